/* SPDX-License-Identifier: MIT */
/* The place of a scene's projection in the taxonomy of planar projections; its eye, gaze
 * and corners in world space. */
#ifndef TAXONOMY_H
#define TAXONOMY_H

#include "../scene/scene.h"

enum taxon {
	TAXON_ORTHOGRAPHIC,
	TAXON_OBLIQUE,
	TAXON_PERSPECTIVE,
	TAXON_REVERSE, /* the eye lies beyond far */
};

enum kind {
	KIND_MULTIVIEW,
	KIND_ISOMETRIC,
	KIND_DIMETRIC,
	KIND_TRIMETRIC,
	KIND_CAVALIER,
	KIND_CABINET,
	KIND_GENERAL,
	KIND_ONE_POINT,
	KIND_TWO_POINT,
	KIND_THREE_POINT,
};

/* Nearest doubles; nan where a projection of this taxon has no such number. */
struct taxonomy {
	enum taxon taxon;
	enum kind kind;
	bool reversed; /* the near plane has the larger depth */
	/* In a parallel projection, the lengths of the images of the world's unit
	 * axes in the projection plane, in view units. */
	double foreshortening[3];
	/* The world axes' vanishing points, on the device or, without viewport, in ndc */
	double vanishing_point[3][2];
	double fov[2];       /* degrees across x and y */
	double eye[3];       /* in world space */
	double gaze[3];      /* unit normal of the projection plane */
	double corner[8][3]; /* in world space, in the order of volume_corner */
};

/* Classifies a scene. Returns NULL, or the member and the reason. */
const char *taxonomy_of(const struct scene *, struct taxonomy *);

#endif
