/* SPDX-License-Identifier: MIT */
/* What a type of projection knows of itself: a row, at the end of its file. Only
 * core/projection and the tables of members (cmd/scene) name types. All else asks for
 * the family of a projection, or for one of the properties in projection.h. */
#pragma once

#include "../refusal/refusal.h"
#include "convention.h"

enum projection_type {
	PROJECTION_NONE, /* the identity: the document has no projection */
	PROJECTION_PERSP,
	PROJECTION_ORTHO,
	PROJECTION_OBLIQUE,
	PROJECTION_VOLUME,
	/* stays the last; `matrix` is of any kind, and may contain a camera */
	PROJECTION_MATRIX,
};

enum { PROJECTION_TYPES = PROJECTION_MATRIX + 1 };

/* The types of a family have the same members, and are fitted and checked alike. */
enum projection_family {
	FAMILY_FIXED,    /* `matrix`, or no member: nothing can be fitted */
	FAMILY_PERSP,    /* `section` about the gaze from an eye */
	FAMILY_PARALLEL, /* `section` along the gaze, which `shear` may shear */
	FAMILY_VOLUME,   /* `volume` */
};

struct projection;

struct projection_row {
	enum projection_family family;

	/* Computes the map from view to clip space or, if `inverse`, back, as
	 * projcalc-numbers(7), FORMULAS says. If its numbers make a scaled_matrix
	 * (scaled.h), scaled_map does the rest: the inverse needs no code, and the
	 * plane in which the map is exact is a member there. */
	bool (*map)(const struct projection *, const struct convention *, bool inverse,
	    struct map *, struct refusals *);

	/* Refuses members that do not go together, before `map`; NULL: all do. Members
	 * that the document lacks or that were refused are NaN, of which no comparison
	 * holds. */
	bool (*check)(const struct projection *, struct refusals *);

	/* Refuses what only `map` finds, such as a matrix without an inverse, if the
	 * members that this needs are known; NULL: `map` refuses nothing. */
	bool (*check_map)(const struct projection *, bool inverse, struct refusals *);

	/* The conventions of view and clip space between which `map` leads. */
	enum {
		FRAME_D3D,   /* those of d3d */
		FRAME_VIEW,  /* the scene's view space; clip y is view y, depth d3d's */
		FRAME_SCENE, /* the scene's */
	} frame;

	/* Returns whether the near plane has ndc depth 1; NULL: the member
	 * reverse_z. */
	bool (*is_reversed)(const struct projection *, const struct convention *);

	bool is_sheared; /* `shear` holds */
};

extern const struct projection_row projection_row_none, projection_row_persp,
    projection_row_ortho, projection_row_oblique, projection_row_volume,
    projection_row_matrix;
