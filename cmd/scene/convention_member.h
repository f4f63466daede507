/* SPDX-License-Identifier: MIT */
/* The member "convention", and the conventions that have a name. */
#ifndef CONVENTION_MEMBER_H
#define CONVENTION_MEMBER_H

#include "../../core/scene/scene.h"
#include "../json/object.h"

enum {
	CONVENTION_D3D, /* the default */
	CONVENTION_GL,
	CONVENTION_VULKAN,
	CONVENTION_WEBGPU,
	CONVENTION_OPENCV,
	CONVENTIONS,
};

extern const struct convention conventions[CONVENTIONS];
extern const char *const convention_names[CONVENTIONS + 1]; /* NULL ends */

/* The members of a convention that is an object. Each is a bool of struct convention and
 * has two words: the first, the property of d3d, is false, the second true. */
extern const struct member convention_members[];

/* Returns whether two conventions are equal. */
bool same_convention(const struct convention *, const struct convention *);

/* A convention: a name, or an object of convention_members. */
extern const struct type type_convention;

/* Refuses the member of that name, which depends on the view axes, if neither the document
 * nor the command line has a convention. */
void check_axes(const struct value *in, const char *name);

#endif
