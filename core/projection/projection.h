/* SPDX-License-Identifier: MIT */
/* Projections, which map view to clip space. Each type has a row, in the file that
 * computes its map. */
#pragma once

#include "parallel.h"
#include "section.h"
#include "volume.h"

/* Defaults: of the direction of an oblique projection, in degrees; and of the least
 * near / far that the command fit finds. */
#define PROJECTION_DIRECTION 45
#define PROJECTION_NEAR_RATIO 0.0005

struct projection {
	enum projection_type type;
	enum angle_unit unit; /* of all angles but shear.direction */
	double aspect[2];     /* width : height; [1] is 0 without an aspect */
	/* Planes of persp and parallel types. In persp, far may be INFINITY. Without
	 * near and far planes, near is 0, and reverse_z is set, so that depth is
	 * 1/w. */
	double near, far;
	bool reverse_z; /* depth is larger at near than at far */
	/* The command fit makes near / far at least near_ratio, and the distance of
	 * near from the eye at least min_near, which is 0 if it is not given. */
	double near_ratio, min_near;
	struct projection_section section;
	struct projection_shear shear;
	struct projection_volume volume;
	double matrix[4][4];
	/* The most digits that an element of the matrix has in the shortest decimal
	 * that reads back as its double; a float has at most 9. 0: they were not
	 * counted. */
	int matrix_digits;
	/* each element is a float, or the decimal of nine digits that tells a float */
	bool matrix_of_floats;
	bool without_camera; /* no camera is given; `matrix` may contain one */
};

/* Returns the first type of the family that shears or, if not `sheared`, does not; or
 * PROJECTION_NONE. */
enum projection_type projection_type_of(enum projection_family, bool sheared);

/* Makes a projection of a type, in which members have their defaults, or are 0. */
void projection_set_defaults(struct projection *, enum projection_type);

enum projection_family projection_family(const struct projection *);

/* Returns whether a scene has no projection, whose map is then the identity. */
static inline bool projection_is_none(const struct projection *p)
{
	return p->type == PROJECTION_NONE;
}

/* Returns whether the member `shear` holds. */
bool projection_is_sheared(const struct projection *);

/* Returns whether the projection is a given matrix, of any kind: it may contain a
 * camera, and says neither which plane is near nor where the gaze is. */
static inline bool projection_is_given_matrix(const struct projection *p)
{
	return p->type == PROJECTION_MATRIX;
}

/* Returns the share of the greatest of the three numbers that multiply x, y and z for a
 * clip coordinate up to which another of them, and directions, may be rounding errors:
 * 2^-18 of a given matrix of floats, or of at most 9 digits, else 2^-40. */
static inline double projection_tolerance(const struct projection *p)
{
	return projection_is_given_matrix(p) && p->matrix_digits > 0 &&
		p->matrix_digits <= 9 ?
	    0x1p-18 :
	    0x1p-40;
}

/* Returns whether the projection is a persp without near and far planes. */
static inline bool projection_is_open(const struct projection *p)
{
	return projection_family(p) == FAMILY_PERSP && p->near == 0;
}

/* Returns whether p is a persp whose size or edges are given on the near plane. */
static inline bool projection_is_given_at_near(const struct projection *p)
{
	const enum section_way way = p->section.way;

	return projection_family(p) == FAMILY_PERSP && p->section.edges_at == 0 &&
	    (way == SECTION_SIZE || way == SECTION_WIDTH || way == SECTION_HEIGHT ||
		way == SECTION_EDGES);
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

/* Computes the map from view to clip space, or its inverse, as projcalc-numbers(7),
 * FORMULAS says. Returns false, and adds a refusal, if it can't. */
bool projection_map(const struct projection *, const struct convention *, bool inverse,
    struct map *, struct refusals *);

/* Refuses what projection_map would refuse. Members that the document lacks or that
 * were refused are NaN. */
bool projection_check(const struct projection *, bool inverse, struct refusals *);

/* Returns whether the near plane has ndc depth 1, as the row of the type tells. */
bool projection_is_reversed(const struct projection *, const struct convention *);
