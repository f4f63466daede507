/* SPDX-License-Identifier: MIT */
/* Where a plane cuts a segment, computed in double-double arithmetic: it mostly decides
 * which doubles are nearest, in a tenth of the time that core/exact takes. What is left
 * open clip.c computes exactly. */
#pragma once

#include "frustum.h"

enum { CLIP_PLANES = 6 };

struct quick_cut {
	const struct transform *image;
	const struct frustum *frustum;
	/* In ndc, in a device and in 2D all images on a plane have one coordinate in
	 * common, which is x, y or z: edge[plane], which is nan until it is known. */
	bool has_edges;
	double edge[CLIP_PLANES];
};

/* Makes the quick cuts of points of `from` by their transform to `to` and the frustum,
 * which the caller keeps. Returns false if there are none. */
bool quick_cut_of(struct quick_cut *, enum space from, enum space to,
    const struct transform *, const struct frustum *);

/* Sets *a and *b to the functions of a plane at the points p and q, within 2^-52 of
 * each. Returns false unless it is sure that neither is 0. */
bool quick_cut_sides(const struct quick_cut *, int plane, const double *p,
    const double *q, double *a, double *b);

/* Computes the doubles nearest to the coordinates of the image of the point where the
 * plane cuts the segment from p to q. Returns false if it is not sure of them. */
bool quick_cut_image(const struct quick_cut *, int plane, const double *p,
    const double *q, double image[4]);
