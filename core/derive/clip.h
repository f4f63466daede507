/* SPDX-License-Identifier: MIT */
/* Cuts segments and polygons at the planes of the view volume, or at the edges of a 2D
 * window: left, right, bottom, top, near and far, in this order. All is decided and cut
 * in homogeneous coordinates with the numbers of core/exact, before any division: so
 * what passes behind the eye is right, and images of cuts are nearest doubles. Without
 * near and far planes the other four meet in the eye, which has no image beyond clip
 * space. */
#pragma once

#include "../points/distance.h"
#include "quick_cut.h"

/* Points are cut in view space if they are of model, world or view space, else in the
 * space that they are of. Its point p, homogeneous, is to_base's image of the point
 * given, if `mapped`. The image is (columns of to_target) over column 3 or, in clip
 * space, over divisor and weight. */
struct clipper {
	struct map to_base, to_target;
	const struct map *sides, *ends; /* the planes (frustum.h) */
	struct map depth; /* of by_distance: z is column 2 over column 3 */
	int in, out;      /* coordinates of a point, and of an image */
	int planes;       /* that exist: 4 or 6 */
	bool mapped;      /* the points are not of the space where they are cut */
	bool by_distance; /* z of the image is a distance along the gaze */
	bool reaches_eye; /* the planes meet in the eye, which has no image */
	bool has_weight;  /* w of clip space is kept: element 4 is the weight */
	bool is_quick;    /* `quick` computes most cuts, with the same result */
	struct quick_cut quick;
};

/* Makes the clipper of points of `from`, whose images are in `to`; both are flat or
 * neither is. Keeps the addresses of the transform between them (distance.h), which is
 * not homogeneous, and of the frustum of `from`. */
bool clipper_of(const struct scene *, enum space from, enum space to,
    const struct transform *, const struct frustum *, struct clipper *,
    struct refusals *faults);

/* A point, or a vertex that a cut has made. */
struct clip_vertex {
	double in[4];     /* the point as it was given */
	size_t index;     /* the caller's number of it */
	unsigned outside; /* its OUT_ bits (frustum.h); OUT_BEHIND if not known */
	/* A cut has made the vertex, and index is not set. If it is not located, one
	 * plane alone cuts it from the segment from `in` to `other`. */
	bool cut;
	double other[4];
	/* The OUT_ bits of planes whose cuts have made it: it lies on them. An edge
	 * whose two ends have a bit in common lies on that plane. */
	unsigned on;
	bool located; /* `at` is set */
	struct sum at[5];
};

/* Sets a vertex to a point, of clipper.in coordinates. */
void clip_vertex_set(struct clip_vertex *, const struct clipper *, const double *in,
    size_t index, unsigned outside);

/* Cuts the segment from p to q. Returns false if no more than one point of it is
 * inside. If not, end[0].cut and end[1].cut tell whether p and q were cut off; only
 * then end[0] and end[1] are the new ends. p and q become located if that is needed. */
bool clip_segment(const struct clipper *, struct clip_vertex *p, struct clip_vertex *q,
    struct clip_vertex end[2]);

/* Cuts a polygon, which need not be flat or convex: Sutherland and Hodgman, Reentrant
 * Polygon Clipping, 1974. Its vertices are added one by one, without the first again at
 * the end; the vertices of the part inside come out by `emit`, in their order. Only two
 * vertices a plane are kept, so that a polygon may have any number. */
struct clip_ring {
	const struct clipper *clipper;
	/* gets each vertex of the part inside, which may change until the next call */
	void (*emit)(void *data, struct clip_vertex *);
	void *data;
	struct clip_vertex given;
	struct clip_stage {
		bool begun, first_out, last_out;
		struct clip_vertex first, last, cut;
	} stage[CLIP_PLANES];
};

void clip_ring_begin(struct clip_ring *, const struct clipper *,
    void (*emit)(void *data, struct clip_vertex *), void *data);
void clip_ring_add(struct clip_ring *, const double *in, size_t index,
    unsigned outside);
void clip_ring_end(struct clip_ring *);

/* Writes the doubles or, if single, the floats nearest to the coordinates of the
 * image. Those beyond the range are nan, as all are of the eye and of what is at
 * infinity. */
void clip_image(struct clipper *, struct clip_vertex *, bool single, double image[4]);

/* Sets r to the point where a plane cuts the segment from p to q, of whose functions a
 * and b one is negative and one positive. Points have n elements. */
void clip_cut(int n, const struct sum *p, const struct sum *a, const struct sum *q,
    const struct sum *b, struct sum *r);
