/* SPDX-License-Identifier: MIT */
/* The axes of the picture: X to the right, Y upward and D along the gaze. A camera,
 * edges and intrinsics are read off the map to clip space in these axes. */
#pragma once

#include "lens.h"

/* The map from view to clip space, in axes X, Y and D that make it upright: clip y and
 * w do not depend on X, nor w on Y. X is to the right, Y upward, and D along the gaze.
 * Clip coordinates are
 *
 *	x = clip_xy[0][0] X + clip_xy[0][1] Y + clip_xy[0][2] D + clip_xy[0][3],
 *	y = clip_xy[1][1] Y + clip_xy[1][2] D + clip_xy[1][3],
 *	w = clip_w[0] D + clip_w[1],
 *
 * all times the map's divisor, which cancels. In a perspective w grows along D, and D
 * is 0 at the eye, so clip_xy[0][3], clip_xy[1][3] and clip_w[1] are 0. */
struct upright {
	struct sum clip_xy[2][4], clip_w[2];
	struct sum axis[3][3]; /* X, Y and D in view space */
	bool uses_view_axes;   /* if not, an RQ decomposition finds the axes */
	bool turned;           /* w grows against the convention's gaze */
	bool tilted;           /* z depends on X or Y */
	/* The greatest share, of the greatest of the three numbers of a clip
	 * coordinate, of a number that counts as a rounding error and so as 0. */
	double residual;
};

void upright_of(const struct lens *, struct upright *);
