/* SPDX-License-Identifier: MIT */
/* The images of cuts, computed in double-double arithmetic where this decides which
 * doubles are nearest, in a tenth of the time that clip.h takes. What it leaves open
 * clip.h computes. */
#pragma once

#include "clip.h"

struct quick_cut {
	const struct transform *image;
	const struct frustum *frustum;
	bool usable;
	/* In ndc, in a device and in a window all images of a plane have one coordinate
	 * in common, which is x, y or z: edge[plane], which is nan until it is known. */
	bool has_edges;
	double edge[CLIP_PLANES];
};

/* Makes the quick cuts of points of `from` by the transform to `to` and the frustum,
 * which the caller keeps. */
void quick_cut_of(struct quick_cut *, enum space from, enum space to,
    const struct transform *, const struct frustum *);

/* Does what clip_segment and clip_image do for points p and q, of which at most one
 * plane cuts off each. Returns false if it is another segment, or if clip.h has to
 * decide. */
bool quick_cut_segment(const struct quick_cut *, const double *p, unsigned p_outside,
    const double *q, unsigned q_outside, bool cut[2], double image[2][4]);

/* Takes an edge from a vertex and its image, if it is not known yet. */
void quick_cut_learn(struct quick_cut *, const struct clip_vertex *,
    const double image[4]);
