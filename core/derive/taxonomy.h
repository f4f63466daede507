/* SPDX-License-Identifier: MIT */
/* The kind of planar projection that a scene makes, and what tells it from the others:
 * foreshortening, vanishing points, fields of view, the eye and the gaze. */
#pragma once

#include "lens.h"

/* TAXON_REVERSE: the eye lies beyond the far plane. */
enum taxon { TAXON_ORTHOGRAPHIC, TAXON_OBLIQUE, TAXON_PERSPECTIVE, TAXON_REVERSE };

enum taxon_kind {
	TAXON_MULTIVIEW,
	TAXON_ISOMETRIC,
	TAXON_DIMETRIC,
	TAXON_TRIMETRIC,
	TAXON_CAVALIER,
	TAXON_CABINET,
	TAXON_GENERAL,
	TAXON_ONE_POINT,
	TAXON_TWO_POINT,
	TAXON_THREE_POINT,
};

struct taxonomy {
	enum taxon taxon;
	enum taxon_kind kind;
	/* In a parallel projection: the lengths in view space of the images, on the
	 * projection plane, of the unit vectors of the world's axes. */
	double foreshortening[3];
	/* World axes' vanishing points, on the device or, if it is missing, in ndc. */
	double vanishing_point[3][2];
	double fov[2];       /* degrees from left to right, and from bottom to top */
	double eye[3];       /* in world space */
	double gaze[3];      /* unit normal of the projection plane */
	double corner[8][3]; /* in world space, in the order of struct lens */
};

/* Sets all members. A number that does not exist keeps the caller's nan. */
void taxonomy_of(const struct lens *, struct taxonomy *);
