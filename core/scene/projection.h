/* SPDX-License-Identifier: MIT */
/* The projection: the map from view to clip space and back. */
#ifndef PROJECTION_H
#define PROJECTION_H

#include "camera.h"

/* The members that give the cross-section of persp (on the near plane), ortho and
 * oblique, in the order of the table of their members. */
enum extent {
	EXTENT_FOVY, /* angle, aspect */
	EXTENT_FOVX,
	EXTENT_VIEW_ANGLE, /* across the smaller side, aspect */
	EXTENT_FIELD,      /* half the larger side at unit distance, aspect */
	EXTENT_SIZE,       /* width, height */
	EXTENT_WIDTH,      /* width, aspect */
	EXTENT_HEIGHT,     /* height, aspect */
	EXTENT_EDGES,
	EXTENT_ANGLES,     /* between the edges and the gaze */
	EXTENT_INTRINSICS, /* the matrix from view space to pixels */
};

struct projection {
	enum {
		PROJECTION_NONE, /* identity */
		PROJECTION_PERSP,
		PROJECTION_ORTHO,
		PROJECTION_OBLIQUE,
		PROJECTION_VOLUME,
		PROJECTION_MATRIX, /* the last: tests sample the types up to it */
	} type;

	enum angle_unit unit; /* of all angles but direction */
	enum extent extent;
	double angle;         /* of view, or the field of EXTENT_FIELD */
	double aspect[2];     /* width / height; [1] is 0 where not given */
	double width, height; /* of extent; by intrinsics, of the viewport */
	double left, right, bottom, top;
	double edges_at; /* the distance of the cross-section; 0 means near */
	/* The rows of P, which maps X Y Z 1 to u w, v w, w. X is to the right, Y in the
	 * direction of device y, and Z along the gaze. The pixels u and v are relative
	 * to the viewport's corner. near and far are values of w. */
	double intrinsics[3][4];
	/* In persp, far may be INFINITY. near 0 means that there are no near and far
	 * planes; depth is then 1/w, reversed. */
	double near, far;
	bool reverse_z;
	double near_ratio; /* the least near / far that fit makes */

	/* oblique */
	enum { OBLIQUE_ANGLE, OBLIQUE_CAVALIER, OBLIQUE_CABINET } kind;
	double projector; /* the angle between projectors and plane */
	double direction; /* the angle from +x to receding lines */
	enum angle_unit direction_unit;
	double plane; /* the depth that the shear keeps */

	/* volume; with an aspect, each half size is half the smaller side */
	double half_width, half_height, z_near, z_far;
	double inverse_eye_z, tan_skew[2];
	double eye[3]; /* in view space */
	/* The member that gives the eye: inverse_eye_z, eye, or angle, where angle 0
	 * means parallel. The table of members has the same order. */
	enum { EYE_BY_Z, EYE_GIVEN, EYE_BY_ANGLE } eye_by;

	double matrix[4][4];
	bool alone; /* no camera: the matrix may contain one */
};

/* Returns whether the projection is a persp without near and far planes. */
static inline bool projection_is_open(const struct projection *p)
{
	return p->type == PROJECTION_PERSP && p->near == 0;
}

/* Returns whether the projection is a persp that gives its cross-section on the near
 * plane. */
static inline bool projection_is_by_near(const struct projection *p)
{
	return p->type == PROJECTION_PERSP && p->edges_at == 0 &&
	    p->extent >= EXTENT_SIZE && p->extent <= EXTENT_EDGES;
}

/* Returns whether the projection is a persp given by the intrinsics P. */
static inline bool projection_is_by_p(const struct projection *p)
{
	return p->type == PROJECTION_PERSP && p->extent == EXTENT_INTRINSICS;
}

/* Returns whether the last row of P does not begin with 0 0 1. If it does, w is the
 * distance along the gaze plus an offset. */
static inline bool projection_is_tilted(const struct projection *p)
{
	const double *w = p->intrinsics[2];

	return projection_is_by_p(p) && (w[0] != 0 || w[1] != 0 || w[2] != 1);
}

/* Returns w at the eye, the difference of w and the distance along the gaze, 0 if P is
 * tilted. */
static inline double projection_w_at_eye(const struct projection *p)
{
	bool offset = projection_is_by_p(p) && !projection_is_tilted(p);

	return offset ? p->intrinsics[2][3] : 0;
}

/* Computes 1/z of a volume's eye in view space as a quotient by an exact number. */
void projection_inverse_eye_z(const struct projection *, struct sum *numerator,
    struct sum *denominator);

/* Computes the matrix of projcalc(1), FORMULAS, or its inverse. Returns NULL, or the
 * member and the reason. */
const char *projection_map(const struct projection *, const struct convention *,
    bool inverse, struct map *);

/* Returns whether the near plane has ndc depth 1. A matrix, and the identity that
 * stands for no projection, do not say which plane is near. The near plane is then the
 * plane of the smaller positive w or, if w is constant, the first plane along the
 * convention's gaze. A parallel matrix that contains a turned or mirrored camera is
 * never reversed. */
bool projection_is_reversed(const struct projection *,
    const struct convention *);

#endif
