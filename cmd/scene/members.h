/* SPDX-License-Identifier: MIT */
/* The members of a scene, and of the objects among them. */
#ifndef MEMBERS_H
#define MEMBERS_H

#include "document.h"
#include "types.h"

/* Of struct document; row i has bit i in enum scene_member. */
extern const struct member scene_members[];

/* Of a projection, and how they can be combined. */
extern const struct member projection_members[];
extern const struct ways projection_ways[];
extern const struct type type_projection;

/* Names of types, from PROJECTION_PERSP on; NULL ends them. */
extern const char *const projection_types[];

/* Completes a projection that was read from a value by what the viewport, or NULL, says
 * of the aspect that is not given, and of pixels. */
void projection_complete(const struct value *, const struct viewport *,
    struct projection *);

/* Examples of members. The viewport gives the scene its aspect. */
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

#endif
