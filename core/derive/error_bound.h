/* SPDX-License-Identifier: MIT */
/* Bounds of the errors of images that the kernels compute in double or single
 * precision, for all points of the view volume. */
#pragma once

#include "lens.h"

/* Writes to bound[enum precision] an upper bound of the errors of the coordinates of
 * images, for all model points in the view volume. The unit is that of the device or,
 * without a viewport, of ndc. kernel/approx.h derives the bounds. A bound is nan if a
 * point's w could be at most 16 times its error, or if 1/w is beyond the range of the
 * precision. */
bool error_bound_of(const struct lens *, double bound[3], struct refusals *faults);
