/* SPDX-License-Identifier: MIT */
/* Cuts the points of a document, or of an operand, from its text, byte for byte. */
#pragma once

#include "value.h"

/* Replaces *array, the text of an array of points or of one point, by lines: each is a
 * point's array without blanks. The lines fit into the text, but the newline of a
 * single point may take the byte after it. A point is an array: first the coordinates,
 * each a number or null, then any values but arrays and objects. `v` is the value of
 * the array, for messages. Returns false, and changes nothing, if a point is
 * refused. */
bool points_cut(const struct value *v, struct span *array, int coordinates);
