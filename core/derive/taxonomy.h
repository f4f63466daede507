/* SPDX-License-Identifier: MIT */
/* The place of a scene's projection in the taxonomy of planar projections; its eye, gaze
 * and corners in world space. */
#ifndef TAXONOMY_H
#define TAXONOMY_H

#include "frustum.h"

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

/* Parameters of a scene's picture: its planes, and a camera and a projection that make
 * the same picture. */

/* Faults of a scene, and reasons why no scene in parameters makes its picture. */
enum note {
	NOTE_MIRRORED,    /* the picture is a mirror image */
	NOTE_HANDED,      /* the projection has the other handedness */
	NOTE_AWAY,        /* the projection looks against the camera's gaze */
	NOTE_TRANSPOSED,  /* the projection's matrix looks transposed */
	NOTE_NEAR_BEYOND, /* near is farther than far */
	NOTE_BACKWARD,    /* depth falls along the convention's gaze */
	/* with one of the notes below has_scene is false */
	NOTE_NO_ROTATION, /* the camera's matrix is not a rotation */
	NOTE_TILTED,      /* near and far are not parallel to the picture */
	NOTE_BEHIND,      /* w is negative from near to far */
	NOTE_SKEWED,      /* only intrinsics could say that x depends on y */
	NOTE_RANGE,       /* a plane is behind the eye, a number out of range */
	NOTES,
};

/* Nearest doubles; nan where a number does not exist. */
struct parameters {
	/* Distances from the eye or, in a parallel projection, from the origin of
	 * view space along the convention's gaze. far may be infinite. */
	double near, far;
	struct depth depth;
	double aspect;
	bool reverse_z;
	/* x or y of view space where left, right, bottom and top meet the near
	 * plane */
	double plane[4];
	/* Rows of K. K maps X to the right, Y in the direction of device y and Z along the
	 * gaze to pixels from the viewport's corner. nan in a parallel projection. */
	double intrinsics[3][3];
	/* a b c d in world space for left, right, bottom, top, near and far: inside
	 * is where a x + b y + c z + d >= 0; a b c is a unit vector */
	double frustum_plane[6][4];
	unsigned notes; /* a bit for each enum note */
	/* A scene that makes the same picture: a camera by eye and gaze, and a projection
	 * by edges or, if x depends on y or there are no planes, by intrinsics. The
	 * convention is the answer's. */
	bool has_scene;
	struct scene scene;
};

/* Finds the parameters of a scene and its taxonomy. Returns NULL, or the member and the
 * reason. */
const char *parameters_of(const struct scene *, const struct taxonomy *,
    struct parameters *);

#endif
