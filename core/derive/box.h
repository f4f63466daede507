/* SPDX-License-Identifier: MIT */
/* Where a scene shows a box: what culling, scissors, level of detail, and near and far
 * ask for. A sphere counts as its box. */
#pragma once

#include "fit_bounds.h"

struct box {
	double distance[2]; /* least and greatest of the corners (points/distance.h) */
	/* The least rectangle that holds the images of the part of the box beyond the
	 * near plane; nan if this part is empty or reaches w <= 0. */
	double min[2], max[2];
	unsigned outside; /* OUT_ bits of planes that some corner is outside of */
	bool out;         /* all corners are outside of one plane */
	bool behind;      /* all corners are at or behind the eye */
};

/* Describes bounds of three dimensions or, if flat, of two, of which there is no
 * distance. */
bool box_of(const struct scene *, const struct bounds *, bool flat, struct box *,
    struct refusals *faults);
