/* SPDX-License-Identifier: MIT */
/* The member "projection": the table of its members, which of them go together, and
 * what it takes from the rest of the scene. It is read to struct projection of
 * core/projection, which keeps nothing of the document. */
#pragma once

#include "../../core/scene/scene.h"
#include "../json/object.h"

/* The members of a projection, and the ways to combine them. */
extern const struct member projection_members[];
extern const struct rule projection_rules[];
extern const struct member_type type_projection;

/* The names of the types of projections, from PROJECTION_PERSP on; NULL ends them. */
extern const char *const projection_type_names[];

/* Completes a projection that was read from the value: takes a missing aspect and, for
 * intrinsics, the size of the image from the viewport, which may be NULL. Refuses a
 * projection that lacks them. Leaves a projection whose type was refused as it is. */
void projection_complete(const struct value *, const struct viewport *,
    struct projection *);
