/* SPDX-License-Identifier: MIT */
/* Projections, which map view to clip space. A type of projection has a row in each
 * switch over enum projection_type; most code asks for the type's family only. */
#pragma once

#include "camera.h"

enum projection_type {
	PROJECTION_NONE, /* the identity */
	PROJECTION_PERSP,
	PROJECTION_ORTHO,
	PROJECTION_OBLIQUE,
	PROJECTION_VOLUME,
	PROJECTION_MATRIX, /* stays the last */
};

enum { PROJECTION_TYPES = PROJECTION_MATRIX + 1 };

/* The types of a family have the same members, and are fitted and checked alike. */
enum projection_family {
	FAMILY_FIXED,    /* `matrix`, or no member: nothing can be fitted */
	FAMILY_PERSP,    /* `section` about the gaze from an eye */
	FAMILY_PARALLEL, /* `section` along the gaze, which `shear` may shear */
	FAMILY_VOLUME,   /* `volume` */
};

/* The ways to give a cross-section, in the order of projection_rules (cmd/scene). In
 * persp, sizes and edges are at distance edges_at. */
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

struct projection_section {
	enum section_way way;
	double angle;
	double field;         /* half the larger side at unit distance */
	double width, height; /* with intrinsics, the viewport's */
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

/* The shear of an oblique projection. */
struct projection_shear {
	enum { OBLIQUE_ANGLE, OBLIQUE_CAVALIER, OBLIQUE_CABINET } kind;
	double projector_angle; /* between projectors and the image plane */
	double direction;       /* in the picture, from +x to lines along the gaze */
	enum angle_unit direction_unit;
	double plane; /* points at this distance along the gaze stay put */
};

struct projection_volume {
	double half_width, half_height; /* with an aspect, of the smaller side */
	double z_near, z_far;
	/* The member that gives the eye; a view_angle of 0 makes the projection
	 * parallel. projection_rules (cmd/scene) has the same order. */
	enum { EYE_BY_INVERSE_Z, EYE_BY_POINT, EYE_BY_ANGLE } eye_given_by;
	double inverse_eye_z, eye[3], view_angle; /* eye: in view space */
	double tan_skew[2];                       /* x/z, y/z of the axis */
};

struct projection {
	enum projection_type type;
	enum angle_unit unit; /* of all angles but shear.direction */
	double aspect[2];     /* width : height; [1] is 0 without an aspect */
	/* Planes of persp and parallel types. In persp, far may be INFINITY. Without
	 * near and far planes, near is 0, and reverse_z is set, so that depth is 1/w. */
	double near, far;
	bool reverse_z; /* depth is larger at near than at far */
	/* The command fit makes near / far at least near_ratio, and the distance of
	 * near from the eye at least min_near, which is 0 if it is not given. */
	double near_ratio, min_near;
	struct projection_section section;
	struct projection_shear shear;
	struct projection_volume volume;
	double matrix[4][4];
	bool without_camera; /* no camera is given; `matrix` may contain one */
};

static inline enum projection_family projection_family(const struct projection *p)
{
	switch (p->type) {
	case PROJECTION_PERSP:
		return FAMILY_PERSP;
	case PROJECTION_ORTHO:
	case PROJECTION_OBLIQUE:
		return FAMILY_PARALLEL;
	case PROJECTION_VOLUME:
		return FAMILY_VOLUME;
	case PROJECTION_NONE:
	case PROJECTION_MATRIX:
		break;
	}
	return FAMILY_FIXED;
}

/* Returns whether the projection is a persp without near and far planes. */
static inline bool projection_is_open(const struct projection *p)
{
	return projection_family(p) == FAMILY_PERSP && p->near == 0;
}

/* Returns whether p is a persp whose size or edges are given on the near plane. */
static inline bool projection_is_given_at_near(const struct projection *p)
{
	return projection_family(p) == FAMILY_PERSP && p->section.edges_at == 0 &&
	    p->section.way >= SECTION_SIZE && p->section.way <= SECTION_EDGES;
}

/* Returns whether the projection is a persp given by the intrinsics P. */
static inline bool projection_has_intrinsics(const struct projection *p)
{
	return projection_family(p) == FAMILY_PERSP &&
	    p->section.way == SECTION_INTRINSICS;
}

/* Returns whether P is tilted: its last row does not begin with 0 0 1. If P is not
 * tilted, w is the distance along the gaze plus intrinsics[2][3]. */
static inline bool projection_is_tilted(const struct projection *p)
{
	const double *w = p->section.intrinsics[2];

	return projection_has_intrinsics(p) && (w[0] != 0 || w[1] != 0 || w[2] != 1);
}

/* Computes 1/z of a volume's eye in view space. The denominator is exact. */
void projection_inverse_eye_z(const struct projection *, struct sum *numerator,
    struct sum *denominator);

/* Computes the map from view to clip space, or its inverse, as projcalc(1), FORMULAS
 * says. Returns NULL, or the member at fault and why. */
const char *projection_map(const struct projection *, const struct convention *,
    bool inverse, struct map *);

/* Returns whether the near plane has ndc depth 1. PROJECTION_MATRIX and PROJECTION_NONE
 * do not say which plane is near: it is then the plane of smaller positive w or, if w
 * is constant, the plane that the convention's gaze meets first. But a parallel matrix
 * that contains a turned or mirrored camera is never reversed. */
bool projection_is_reversed(const struct projection *, const struct convention *);
