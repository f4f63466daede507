/* SPDX-License-Identifier: MIT */
/* What a viewport shows: the images of segments and faces that are in the view volume.
 * x and y are from the viewport's top left corner, to the right and down; 1 is its
 * greater side. z grows away from the eye, and planes stay planes: it is the distance
 * along the gaze of a parallel projection, 0 at the nearest, else -1 over the distance,
 * -1 at the nearest; in a reverse perspective, which looks toward its eye, 1 over the
 * distance. */
#pragma once

#include <math.h>

#include "../message/utf8.h"
#include "mesh.h"

/* The vertex of an end that a cut has made. Others are told by their indices. */
#define NO_VERTEX UINT32_MAX

/* A triangle, or what a cut has left of it, which is convex. */
struct face {
	double normal[3]; /* of its plane, away from the eye; normal[2] > 0 */
	double low[3], high[3];
	size_t first; /* of its corners, counterclockwise where y points up */
	unsigned n, vertex[3];
	float view_normal[3], light; /* the light is from 0 to 1 */
	uint32_t place;              /* where hidden.c sorts it */
};

struct segment {
	double end[2][3];
	unsigned vertex[2];
	enum stroke stroke;
	struct span name; /* of a dot, borrowed of the mesh; or empty */
};

struct picture {
	double width, height; /* of which the greater one is 1 */
	bool parallel, reverse;
	double (*corner)[3];
	struct face *face;
	struct segment *segment;
	size_t corners, faces, segments;
};

/* These add a corner, and make a face of the corners from `first` on, whose normal in
 * view space is given up to its sign. */
void picture_add_corner(struct picture *, const double at[3]);
void picture_add_face(struct picture *, size_t first, const unsigned vertex[3],
    const double view_normal[3]);
void picture_add_segment(struct picture *, const struct segment *);

/* Completes a picture of which all is added, with z the distance. Leaves out faces that
 * are seen from the side. Faces are lit by a lamp in this direction of view space; the
 * eye looks along `gaze`. */
void picture_complete(struct picture *, const double lamp[3], const double gaze[3]);

/* Returns how far `at` is beyond the plane of a face, times normal[2]. It is above 0
 * only if it is more than what the digits of usual files leave open: 2^-18, relative to
 * the picture and to z. So lines on a face are not beyond it. */
static inline double picture_beyond(const struct picture *p, const struct face *f,
    const double at[3])
{
	const double *o = p->corner[f->first], *n = f->normal;
	const double beyond = n[0] * (at[0] - o[0]) + n[1] * (at[1] - o[1]) +
	    n[2] * (at[2] - o[2]);
	const double z = p->parallel ? 1 : fabs(at[2]);

	return beyond - 0x1p-18 * (fabs(n[0]) + fabs(n[1]) + n[2] * z);
}

/* Returns how many vertices of a segment are corners of a face: 0, 1 or both; if 1,
 * *which is its index. */
static inline int picture_shared(const struct face *f, const unsigned vertex[2],
    int *which)
{
	int count = 0;

	for (int i = 0; i < 2; i++)
		for (int k = 0; k < 3 && vertex[i] != NO_VERTEX; k++)
			if (f->vertex[k] == vertex[i]) {
				*which = i;
				count++;
			}
	return count;
}

void picture_free(struct picture *);
