/* SPDX-License-Identifier: MIT */
/* The tightest 2D window that holds given bounds. */
#ifndef FIT_WINDOW_H
#define FIT_WINDOW_H

#include "fit_points.h"

/* Gives the scene a window by center, width and height, in the place of any other,
 * that holds the bounds' x and y. The center is the double nearest to the middle of
 * the bounds; width and height are the least doubles for which, about that center,
 * all is in: as frustum_out says, or with a margin in what it leaves. Then the shorter
 * side, by the device's shape, is widened to that, where there is a device. What has
 * no extent along one axis is taken to be 2^-20 of the other. Returns NULL, or the
 * member and the reason. */
const char *fit_window(struct scene *, const struct bounds *);

/* The directions in which a window closes on points: the box about those that are
 * farthest in them is the box about all. */
void window_directions(struct directions *);

#endif
