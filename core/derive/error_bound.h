/* SPDX-License-Identifier: MIT */
/* Upper bounds of the error of a point's image. */
#ifndef ERROR_BOUND_H
#define ERROR_BOUND_H

#include "../points/points.h"

/* Writes for each precision an upper bound of the error of any coordinate of an image, in
 * device units or, without a viewport, ndc units, for points of the view volume that are
 * given in model space. kernel/plain.h derives the bounds. A bound is nan if w could be
 * less than its own error, or 1/w beyond the range of the precision. Returns NULL, or
 * the member and the reason. */
const char *error_bounds(const struct scene *, double bound[3]);

#endif
