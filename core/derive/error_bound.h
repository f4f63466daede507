/* SPDX-License-Identifier: MIT */
/* How wrong a point's image can be. */
#ifndef ERROR_BOUND_H
#define ERROR_BOUND_H

#include "../points/point.h"

/* For each precision, an upper bound of the error of any coordinate, in device
 * or else ndc units, for points of the view volume that are given in model
 * space; from the analysis in kernel/plain.h. nan where that is none, as w could
 * be lost in its error or 1/w beyond the precision's range. Returns
 * NULL, or the member and the reason. */
const char *error_bounds(const struct scene *, double bound[3]);

#endif
