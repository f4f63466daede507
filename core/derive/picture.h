/* SPDX-License-Identifier: MIT */
/* The picture that a scene makes: the place of its projection in the taxonomy of planar
 * projections; its eye, gaze, planes and depth; and a camera and a projection that make
 * the same picture. */
#ifndef PICTURE_H
#define PICTURE_H

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

/* Faults of a scene, and reasons why no scene in parameters makes its picture. */
enum note {
	NOTE_MIRRORED,    /* the picture is a mirror image */
	NOTE_HANDED,      /* the projection has the other handedness */
	NOTE_AWAY,        /* the projection looks against the camera's gaze */
	NOTE_TRANSPOSED,  /* the projection's matrix looks transposed */
	NOTE_NEAR_BEYOND, /* near is farther than far */
	NOTE_BACKWARD,    /* depth falls along the convention's gaze */
	/* has_scene is false with each of the notes below */
	NOTE_NO_ROTATION, /* the camera's matrix is not a rotation */
	NOTE_TILTED,      /* near and far are not parallel to the picture */
	NOTE_BEHIND,      /* w is negative from near to far */
	NOTE_SKEWED,      /* x depends on y; only intrinsics could say that */
	NOTE_RANGE, /* a plane is behind the eye, or a number beyond the range */
	NOTES,
};

/* A scene's maps. The gradients of clip x, y, z and w in view space are the first three
 * elements of clip. Parallel projectors are perpendicular to the gradients of x and y.
 * The gradient of w or, if w is constant, of z is normal to the projection plane. */
struct lens {
	const struct scene *scene;
	struct volume volume;
	struct map view, world;  /* from world to view space and back */
	struct sum clip[4][4];   /* columns of volume.clip; y points up */
	bool parallel, reversed; /* reversed: near has the larger ndc depth */
};

/* Makes the lens of a scene. Returns NULL, or the member and the reason. */
const char *lens_of(const struct scene *, struct lens *);

/* Writes the unit vector in world space along an axis given in view space. */
void lens_axis(const struct lens *, const struct sum axis[3], double unit[3]);

/* The formats of depth buffers. */
enum buffer { BUFFER_UNORM16, BUFFER_UNORM24, BUFFER_FLOAT32, BUFFERS };

/* The distance D at depth z is (over[0] z + over[1]) / (under[0] z + under[1]). z is
 * device depth or, without a viewport, from 0 to 1. D is measured along the gaze: in a
 * perspective from the eye, else from the origin of view space. under[0] is 0 only in a
 * parallel projection. In a perspective under[0] z + under[1] is positive in front of
 * the eye. If planes of equal depth are tilted against the projection plane, D is
 * measured on the normal of the projection plane through the eye. */
struct depth {
	struct sum over[2], under[2];
	double low, high; /* z at the least ndc depth, and at ndc depth 1 */
	bool reversed;    /* the near plane has the larger ndc depth */
	bool open;        /* there are no near and far planes */
	bool flat;        /* min_z is max_z; low and high are then 0 and 1 */
};

void depth_of(const struct lens *, struct depth *);

/* Writes the distance of the near or far plane as a quotient. */
void depth_quotient(const struct depth *, bool far, struct sum *over,
    struct sum *under);

/* Returns the distance of the near or far plane: infinite if the plane is at infinity,
 * nan if it is behind the eye or does not exist. */
double depth_distance(const struct depth *, bool far);

/* Returns the distance from the near or far plane, inward, to the depth that differs by
 * one step of the buffer; a step of BUFFER_FLOAT32 ends at the next float. Returns nan
 * if the plane is at infinity or does not exist, or if the range of depth is less than
 * a step. */
double depth_step(const struct depth *, enum buffer, bool far);

/* Returns the distance from the points at distance at, toward the eye, to the depth
 * that differs by one step of the buffer. */
double depth_step_at(const struct depth *, enum buffer, double at);

/* A picture in nearest doubles; a number that does not exist is nan. */
struct picture {
	enum taxon taxon;
	enum kind kind;
	/* In a parallel projection, the lengths of the images of the world's unit
	 * axes in the projection plane, in view units. */
	double foreshortening[3];
	/* The world axes' vanishing points, on the device or, without one, ndc */
	double vanishing_point[3][2];
	double fov[2];       /* degrees across x and y */
	double eye[3];       /* in world space */
	double gaze[3];      /* unit normal of the projection plane */
	double corner[8][3]; /* in world space, in the order of struct volume */
	/* Distances from the eye or, in a parallel projection, from the origin of
	 * view space along the convention's gaze. far may be infinite. */
	double near, far;
	struct depth depth;
	double aspect;
	bool reverse_z;
	/* x of left and right, y of bottom and top in view space, on the near plane */
	double plane[4];
	/* Rows of K. K maps X to the right, Y along device y and Z along the gaze to
	 * pixels from the viewport's corner. */
	double intrinsics[3][3];
	/* a b c d in world space for left, right, bottom, top, near and far: a point is
	 * inside if a x + b y + c z + d >= 0; a b c is a unit vector */
	double frustum_plane[6][4];
	double error_bound[3]; /* of error_bounds */
	unsigned notes;        /* a bit for each enum note */
	/* A scene that makes the same picture: a camera by eye and gaze, and a
	 * projection by edges or, if x depends on y or there are no planes, by
	 * intrinsics. The convention is the answer's. */
	bool has_scene;
	struct scene scene;
};

/* Sets the members up to corner. */
void taxonomy_of(const struct lens *, struct picture *);

/* Finds all of a scene's picture. Returns NULL, or the member and the reason. */
const char *picture_of(const struct scene *, struct picture *);

#endif
