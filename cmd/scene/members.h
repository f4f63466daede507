/* SPDX-License-Identifier: MIT */
/* The members of a scene, and of the objects among them. */
#ifndef MEMBERS_H
#define MEMBERS_H

#include "document.h"
#include "types.h"

/* The first is of the scene itself, in the order of the bits of SCENE_CONVENTION and
 * so on. */
extern const struct member scene_members[], camera_members[],
    projection_members[], viewport_members[], window_members[],
    device_members[], bounds_members[], pick_members[];

/* How their members can be combined. */
extern const struct ways camera_ways[], projection_ways[], rectangle_ways[],
    window_ways[], bounds_ways[];

/* What some of these may be, in the order of their enums; NULL ends each. Types
 * begin with PROJECTION_PERSP, kinds with OBLIQUE_CAVALIER. */
extern const char *const projection_types[], *const oblique_kinds[],
						 *const adapt_names[];

/* Returns whether the camera says where its eye is, which a translation, a pose
 * and a matrix do as well. Only fit may do without. */
bool read_camera(const struct value *, struct camera *);
void read_viewport(const struct value *, struct viewport *);
void read_window(const struct value *, struct window *);
/* Returns whether it has an origin. */
bool read_device(const struct value *, struct device *);
void read_bounds(const struct value *, struct bounds *);
void read_pick(const struct value *, struct pick *);

/* implied is the only type that the command takes, which need not be given
 * then, or PROJECTION_NONE. An aspect that is not given is the viewport's,
 * unless that is NULL. */
void read_projection(const struct value *, int implied,
    const struct viewport *viewport, struct projection *);

/* Prints what reads back as the same, without an aspect that is the viewport's. */
void print_projection(struct printer *, const struct projection *,
    const struct viewport *);

#endif
