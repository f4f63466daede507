/* SPDX-License-Identifier: MIT */
/* Reads what can be drawn of a Wavefront OBJ file: v, p, l and f. */
#pragma once

#include "../../core/refusal/refusal.h"
#include "../message/utf8.h"
#include "mesh.h"

/* Adds what a text has to a mesh. Points of two numbers are allowed if `flat` is set.
 * Returns false, and what is wrong in which line, if the text is refused. */
bool obj_read(struct span file, bool flat, struct mesh *, struct refusal *);
