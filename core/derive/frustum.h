/* SPDX-License-Identifier: MIT */
/* The view volume: its planes, its corners, and the test which planes, or edges of a 2D
 * window, a point is outside of. */
#ifndef FRUSTUM_H
#define FRUSTUM_H

#include "../points/transform.h"

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

/* A point is inside if all columns of its images under both transforms are at least 0. A
 * 2D window (sides.in is 2) does not use ends. */
struct frustum {
	struct transform sides; /* left right bottom top */
	struct transform ends;  /* near far w */
};

/* Finds the limits of ndc x and y: a point is between the side planes if |x| scale[0] <=
 * half[0] and |y| scale[1] <= half[1]. half is the viewport's, less the margin. */
void view_limits(const struct scene *, struct sum half[2], struct sum scale[2]);

/* Makes the planes of the view volume as linear functions of a point in one space. The
 * columns of sides are left, right, bottom and top; those of ends are near, far and w.
 * Returns NULL, or the member and the reason. */
const char *view_planes(const struct scene *, enum space from,
    struct map *sides, struct map *ends);
const char *frustum_of(const struct scene *, enum space from, bool homogeneous,
    struct frustum *);

/* Makes the edges of the 2D window as functions of a point in a 2D space. They are the
 * edges of the square in ndc, and those of the device on the device. */
const char *flat_frustum_of(const struct scene *, enum flat from,
    struct frustum *);

/* Returns the OUT_ bits of the planes that a point is outside of, decided exactly. A
 * point on a plane is not outside of it. With OUT_BEHIND or OUT_NAN no other bit is
 * set. */
unsigned frustum_out(const struct frustum *, const double in[4]);

/* Writes frustum_out of n points; in has a column for each coordinate. */
void frustum_out_all(const struct frustum *, const double *const in[4],
    unsigned char *out, size_t n);

/* The planes of the view volume in view space, and the map from view space to another
 * space. A corner is computed as the point where three planes meet. An inverse map has
 * errors relative to the volume, in which the corners of a small near plane would
 * drown. */
struct volume {
	struct map sides, ends, from_view;
};

/* Makes the volume of a scene. Returns NULL, or the member and the reason. */
const char *volume_of(const struct scene *, enum space to, struct volume *);

/* Writes the homogeneous image of corner 0..7 of the view volume: near, then far, each
 * left-bottom, right-bottom, right-top, left-top. Without near and far planes all are at
 * infinity. Returns the positive factor f: h / f is the image of the corner with clip
 * w 1. */
struct sum volume_corner(const struct volume *, int corner, struct sum h[4]);

/* Writes the homogeneous image of the eye, where clip x, y and w are 0. Returns 1 where
 * the eye is on the inner side of the far plane, -1 beyond it, 0 at infinity. */
int volume_eye(const struct volume *, struct sum h[4]);

/* Writes the homogeneous point where three planes a x + b y + c z + d = 0 meet. All of h
 * is 0 if the planes have more than one point in common. */
void planes_meet(const struct sum plane[3][4], struct sum h[4]);

#endif
