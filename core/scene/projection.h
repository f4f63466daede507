/* SPDX-License-Identifier: MIT */
/* Projections: view to clip and back. */
#ifndef PROJECTION_H
#define PROJECTION_H

#include "convention.h"
#include "../exact/map.h"
#include "../exact/trig.h"

/* The cross-section of persp (on the near plane), ortho and oblique, in the order of
 * the ways of their members. */
enum extent {
	EXTENT_FOVY, /* angle, aspect */
	EXTENT_FOVX,
	EXTENT_VIEW_ANGLE, /* of the smaller side */
	EXTENT_FIELD,      /* half the larger side at unit distance, aspect */
	EXTENT_SIZE,       /* width, height */
	EXTENT_WIDTH,      /* width, aspect */
	EXTENT_HEIGHT,     /* height, aspect */
	EXTENT_EDGES,
	EXTENT_ANGLES,     /* of the edges from the gaze */
	EXTENT_INTRINSICS, /* what makes pixels of a point in view space */
};

struct projection {
	enum {
		PROJECTION_NONE, /* identity */
		PROJECTION_PERSP,
		PROJECTION_ORTHO,
		PROJECTION_OBLIQUE,
		PROJECTION_VOLUME,
		PROJECTION_MATRIX,
	} type;

	enum angle_unit unit; /* of angles but the direction */
	enum extent extent;
	double angle;         /* or the field; or a volume's */
	double aspect[2];     /* width over height as a quotient; [1] 0: none */
	double width, height; /* with intrinsics, the viewport's */
	double left, right, bottom, top;
	double edges_at; /* the distance where they are measured, or 0: near */
	/* P: a point X right, Y as device y increases, Z along the gaze is taken to
	 * u w, v w, w by these rows; pixels u and v count from the viewport's
	 * corner. near and far are values of w. */
	double intrinsics[3][4];
	/* far may be INFINITY in persp; where near is 0 there are no such planes,
	 * and depth is 1/w, reversed. */
	double near, far;
	bool reverse_z;
	double near_ratio; /* for fit */

	/* oblique */
	enum { OBLIQUE_ANGLE, OBLIQUE_CAVALIER, OBLIQUE_CABINET } kind;
	double projector; /* angle between projectors and plane */
	double direction; /* angle from +x in which receding lines run */
	enum angle_unit direction_unit;
	double plane; /* depth that stays unsheared */

	/* volume; with an aspect both halves are those of the smaller side */
	double half_width, half_height, z_near, z_far;
	double inverse_eye_z, tan_skew[2];
	double eye[3]; /* in view space */
	/* Whether the eye is by inverse_eye_z, at eye, or by the angle, of which 0
	 * is parallel. In the order of the ways of their members. */
	enum { EYE_BY_Z, EYE_GIVEN, EYE_BY_ANGLE } eye_by;

	double matrix[4][4];
	bool alone; /* without a camera, which the matrix may have in it */
};

/* A persp without planes. */
static inline bool projection_is_open(const struct projection *p)
{
	return p->type == PROJECTION_PERSP && p->near == 0;
}

/* A persp whose section is measured on its near plane. */
static inline bool projection_is_by_near(const struct projection *p)
{
	return p->type == PROJECTION_PERSP && p->edges_at == 0 &&
	    p->extent >= EXTENT_SIZE && p->extent <= EXTENT_EDGES;
}

static inline bool projection_is_by_p(const struct projection *p)
{
	return p->type == PROJECTION_PERSP && p->extent == EXTENT_INTRINSICS;
}

/* Whether w is another thing than the distance along the gaze and an offset: the last
 * row of P does not begin 0 0 1. */
static inline bool projection_is_tilted(const struct projection *p)
{
	const double *w = p->intrinsics[2];

	return projection_is_by_p(p) && (w[0] != 0 || w[1] != 0 || w[2] != 1);
}

/* w less the distance along the gaze; 0 where P is tilted. */
static inline double projection_w_at_eye(const struct projection *p)
{
	bool offset = projection_is_by_p(p) && !projection_is_tilted(p);

	return offset ? p->intrinsics[2][3] : 0;
}

/* Of a volume: 1/z of the eye, as a quotient of which the denominator is exact. The
 * angle is that across the smaller side, seen from before the near plane. */
void projection_inverse_eye_z(const struct projection *, struct sum *over,
    struct sum *under);

/* The matrices of projcalc(1), FORMULAS, and their inverses, from formulas in
 * the parameters. Returns NULL, or the member and the reason. */
const char *projection_map(const struct projection *, const struct convention *,
    bool inverse, struct map *);

/* Whether the near plane is that of ndc depth 1. A matrix, or the identity where
 * there is no projection, doesn't say: its near plane is that of the smaller
 * positive w or, where w is constant, the first along the convention's gaze. But
 * in a parallel one with a camera in it, which is turned or mirrored, depth grows. */
bool projection_is_reversed(const struct projection *,
    const struct convention *);

#endif
