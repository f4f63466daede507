/* SPDX-License-Identifier: MIT */
/* The tables of the members of a scene, and of the objects among them. */
#ifndef MEMBERS_H
#define MEMBERS_H

#include "document.h"
#include "types.h"
#include "../../core/scene/scene.h"
#include "../json/object.h"

/* The members of struct document; row i has bit i in enum scene_member. */
extern const struct member scene_members[];

/* The members of a projection, and the ways to combine them. */
extern const struct member projection_members[];
extern const struct ways projection_ways[];
extern const struct type type_projection;

/* The names of the types from PROJECTION_PERSP on; NULL ends them. */
extern const char *const projection_types[];

/* Completes a projection that was read from a value: takes a missing aspect, and the size
 * for intrinsics, from the viewport, which may be NULL. */
void projection_complete(const struct value *, const struct viewport *,
    struct projection *);

/* Examples of members. The aspect of SCENE_LIKE is that of its viewport. */
#define CAMERA_LIKE "{\"eye\": [0,0,-5], \"at\": [0,0,0]}"
#define LENS_LIKE                                               \
	"{\"type\": \"persp\", \"fovy\": 60, \"aspect\": 1.5, " \
	"\"near\": 1, \"far\": 10}"
#define RECTANGLE_LIKE "{\"width\": 640, \"height\": 480}"
#define WINDOW_LIKE "{\"center\": [20,30], \"width\": 10, \"height\": 10}"

#define SCENE_LIKE                                                            \
	"{\"camera\": " CAMERA_LIKE ", \"projection\": {\"type\": \"persp\"," \
	" \"fovy\": 60, \"near\": 1, \"far\": 10}, "                          \
	"\"viewport\": " RECTANGLE_LIKE "}"

/* The member "convention", and the conventions that have a name. */

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
