/* SPDX-License-Identifier: MIT */
/* What a scene's projection is: its place in the taxonomy of planar
 * projections, and what of it can be seen from the world. */
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

/* nan stands for what such a projection has not. All are the
 * nearest doubles. */
struct taxonomy {
	enum taxon taxon;
	enum kind kind;
	bool reversed; /* the near plane has the larger depth */
	/* lengths of the world's unit axes' images in the projection plane, in
	 * view units, of a parallel projection */
	double foreshortening[3];
	/* of the world's axes, in device or else ndc units */
	double vanishing_point[3][2];
	double fov[2];       /* degrees across x and y */
	double eye[3];       /* in world space */
	double gaze[3];      /* unit normal of the projection plane */
	double corner[8][3]; /* in world space, see view_corner */
};

/* Returns NULL, or the member and the reason. */
const char *taxonomy_of(const struct scene *, struct taxonomy *);

#endif
