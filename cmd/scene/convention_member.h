/* Conventions: those that have a name, and the member that gives one. */
#ifndef CONVENTION_MEMBER_H
#define CONVENTION_MEMBER_H

#include "../../core/scene.h"
#include "../json/object.h"

enum {
	CONVENTION_D3D, /* the default */
	CONVENTION_GL,
	CONVENTION_VULKAN,
	CONVENTION_WEBGPU,
	CONVENTIONS,
};

extern const struct convention conventions[CONVENTIONS];
extern const char *const convention_names[CONVENTIONS + 1]; /* NULL ends */

/* The members of a convention without a name: each a bool of struct convention
 * by two words, of which d3d has the first. */
extern const struct member convention_members[];

/* A name, or an object of what differs from d3d. */
void read_convention(const struct value *, struct convention *);

#endif
