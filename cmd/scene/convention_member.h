/* SPDX-License-Identifier: MIT */
/* The member "convention": the conventions that have a name, and the choices of one
 * that is an object. It is read to struct convention of core/projection. */
#pragma once

#include "../../core/scene/scene.h"
#include "../json/object.h"

/* The conventions that have a name. */
enum {
	CONVENTION_D3D, /* the default */
	CONVENTION_GL,
	CONVENTION_VULKAN,
	CONVENTION_WEBGPU,
	CONVENTION_OPENCV,
	CONVENTIONS,
};

extern const struct convention conventions[CONVENTIONS];
extern const char *const convention_names[CONVENTIONS + 1]; /* NULL ends them */
extern const char *const convention_aliases[CONVENTIONS]; /* as word_aliases has them */

/* The members of a convention that is an object. Each has one of two words, and is a
 * bool in struct convention: false for the first word, which d3d has, else true. */
extern const struct member convention_members[];

/* A convention: a name, or an object of convention_members. */
extern const struct member_type type_convention;

/* Refuses the object's member `name`, whose numbers depend on the view axes, if neither
 * the document nor the command line gives a convention; `or_else` says what else would
 * do. */
void convention_require(const struct value *object, const char *name,
    const char *or_else);
