/* SPDX-License-Identifier: MIT */
/* The operand PARAMS: one JSON document or, with --scenes, any number of them, which
 * are read one after another. This module owns their text. */
#pragma once

#include "options.h"

/* Ends messages of the command pick that refuse a point of two numbers. */
#define POSITION_HINT "--at 320,240 is the position"

/* Moves to the next document of PARAMS and returns whether there is one. With --scenes,
 * PARAMS may have several, and messages begin with the number of the document. */
bool params_next_document(const struct options *);

/* Reads from the current document what the command and the options need. Returns false
 * after refusals, which are in `faults`. The points in struct document stay valid until
 * the next call of params_next_document. */
bool params_read_document(const struct options *, struct document *,
    struct refusals *faults);

/* Returns the remedy for `points`, as they were typed, where a scene is wanted. */
const char *params_points_remedy(const struct options *, const char *points);
