/* SPDX-License-Identifier: MIT */
/* Where a scene shows a box or a sphere, which the world may make an ellipsoid: what
 * culling, scissors, level of detail, and near and far ask for. A circle of a window
 * counts as its box, which has the same edges. */
#pragma once

#include "fit_bounds.h"

struct box {
	double distance[2]; /* least and greatest (points/distance.h) */
	/* The least rectangle that holds the images of the part of the box beyond the
	 * near plane; nan if this part is empty or reaches w <= 0. Of a sphere beyond
	 * the near plane it is that of the sphere. */
	double min[2], max[2];
	unsigned outside; /* OUT_ bits of planes that some part is outside of */
	bool out;         /* all is outside of one plane */
	bool behind;      /* all is at or behind the eye */
};

/* Describes bounds of three dimensions or, if flat, of two, of which there is no
 * distance. */
bool box_of(const struct scene *, const struct bounds *, bool flat, struct box *,
    struct refusals *faults);
