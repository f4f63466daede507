/* SPDX-License-Identifier: MIT */
/* The members of a scene, and of the objects among them. */
#ifndef MEMBERS_H
#define MEMBERS_H

#include "document.h"
#include "types.h"

/* Of struct document; row i has bit i in enum scene_member. */
extern const struct member scene_members[];

/* How members of a projection can be combined. */
extern const struct member projection_members[];
extern const struct ways projection_ways[];
extern const struct type type_projection;

/* Names of types, from PROJECTION_PERSP on; NULL ends them. */
extern const char *const projection_types[];

/* Completes a projection that was read from a value by what the viewport, or NULL, says
 * of the aspect that is not given, and of pixels. */
void projection_complete(const struct value *, const struct viewport *,
    struct projection *);

#endif
