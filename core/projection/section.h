/* SPDX-License-Identifier: MIT */
/* Cross-sections of persp and parallel projections. */
#pragma once

#include "../refusal/refusal.h"
#include "scaled.h"

/* The ways to give a cross-section. In persp, sizes and edges are at distance
 * edges_at. */
enum section_way {
	SECTION_FOVY,       /* angle from bottom to top, aspect */
	SECTION_FOVX,       /* angle from left to right, aspect */
	SECTION_VIEW_ANGLE, /* angle across the smaller side, aspect */
	SECTION_FIELD,      /* field, aspect */
	SECTION_SIZE,       /* width, height */
	SECTION_WIDTH,      /* width, aspect */
	SECTION_HEIGHT,     /* height, aspect */
	SECTION_EDGES,      /* left, right, bottom, top */
	SECTION_ANGLES,     /* angles */
	SECTION_INTRINSICS, /* intrinsics */
};

enum { SECTION_WAYS = SECTION_INTRINSICS + 1 };

/* Returns whether a way gives one angle of view. */
static inline bool section_is_by_angle(enum section_way way)
{
	return way == SECTION_FOVY || way == SECTION_FOVX || way == SECTION_VIEW_ANGLE;
}

struct projection_section {
	enum section_way way;
	double angle;
	double field;         /* half the larger side at unit distance */
	double width, height; /* with intrinsics, those of their picture */
	/* The size of the picture that the intrinsics are for, or is_sized is false.
	 * Then `width` and `height` are these. */
	bool is_sized;
	double intrinsics_size[2];
	union {
		double edges[4];
		struct {
			double left, right, bottom, top;
		};
	};
	double angles[4]; /* from the gaze to left, right, bottom and top */
	double edges_at;  /* the distance of size and edges; 0: at near */
	/* The 3x4 matrix P, which maps a point X Y Z 1 of view space to u w, v w, w. X
	 * is to the right, Y along device y, and Z along the gaze. u and v are pixels
	 * from the viewport's corner. With P, near and far are values of w. */
	double intrinsics[3][4];
};

struct projection;

/* Refuses edges that are equal, and angles that are not in order. Numbers that were
 * refused are NaN. */
bool section_check(const struct projection *, struct refusals *);

/* Sets s[0] / d[0] = 2 d / (r - l) and sums[0] / d[0] = (l + r) / (r - l), where l and
 * r are the left and right edge at distance d. Sets s[1], d[1] and sums[1] likewise. */
void section_sizes(const struct projection *, double d, struct scaled_matrix *,
    struct sum sums[2]);
