/* SPDX-License-Identifier: MIT */
/* The view volume: its corners, and which of its planes, or of a 2D window's
 * edges, a point is outside of. */
#ifndef FRUSTUM_H
#define FRUSTUM_H

#include "../points/point.h"

enum {
	OUT_LEFT = 1,
	OUT_RIGHT = 2,
	OUT_BOTTOM = 4,
	OUT_TOP = 8,
	OUT_NEAR = 16,
	OUT_FAR = 32,
	OUT_BEHIND = 64,
	OUT_NAN = 128,
};

/* A point is inside where all columns of both are at least 0; of two coordinates
 * (sides.in is 2) it has no ends. */
struct frustum {
	struct transform sides; /* left right bottom top */
	struct transform ends;  /* near far w */
};

/* A point is between the side planes where |x| scale and |y| scale of ndc are at most
 * half: the viewport's limits, less the margin. */
void view_limits(const struct scene *, struct sum half[2], struct sum scale[2]);

/* The planes as seen from one space, with its viewport's limits. Returns NULL,
 * or the member and the reason. */
const char *frustum_of(const struct scene *, enum space from, bool homogeneous,
    struct frustum *);

/* The edges of the 2D window, which are those of the device and of ndc's square,
 * as seen from one of these spaces. */
const char *flat_frustum_of(const struct scene *, enum flat from,
    struct frustum *);

/* 0 where the point is inside or on a plane, exactly; behind comes alone. */
unsigned frustum_out(const struct frustum *, const double in[4]);

/* The same for each of n points, a column for each coordinate. */
void frustum_out_all(const struct frustum *, const double *const in[4],
    unsigned char *out, size_t n);

/* Finds corner 0..7 of the view volume, near, then far, each left-bottom, right-bottom,
 * right-top, left-top, through a map from clip space: homogeneous. Returns the
 * positive number by which that is larger than where clip w is 1. */
struct sum view_corner(const struct scene *, const struct map *from_clip,
    int corner, struct sum h[4]);

#endif
