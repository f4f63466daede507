/* SPDX-License-Identifier: MIT */
/* Facts about the picture that a scene makes: the kind of the planar projection; the
 * eye, gaze, planes and depth; and a second scene, with a camera and a projection, that
 * makes the same picture. */
#ifndef PICTURE_H
#define PICTURE_H

#include "frustum.h"

enum taxon {
	TAXON_ORTHOGRAPHIC,
	TAXON_OBLIQUE,
	TAXON_PERSPECTIVE,
	TAXON_REVERSE, /* the eye lies beyond the far plane */
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

/* Faults of a scene, and reasons why it has no second scene (struct picture). */
enum note {
	NOTE_MIRRORED,     /* the picture is a mirror image */
	NOTE_OTHER_HANDED, /* the projection's handedness is not the scene's */
	NOTE_LOOKS_AWAY,   /* the projection looks against the camera's gaze */
	NOTE_TRANSPOSED,   /* the projection's matrix looks transposed */
	NOTE_NEAR_BEYOND,  /* the near plane is farther than the far plane */
	NOTE_DEPTH_FALLS,  /* depth decreases along the convention's gaze */
	NOTE_RADIANS,      /* an angle of view in degrees may be in radians */
	NOTE_OFF_CENTER, /* the principal point is at the viewport's edge or outside */
	/* with each of the following notes there is no second scene */
	NOTE_NO_ROTATION,   /* the camera's matrix is not a rotation */
	NOTE_TILTED,        /* near and far are not parallel to the image */
	NOTE_MINUS_W,       /* w is negative between the near and far planes */
	NOTE_NO_INTRINSICS, /* it would need intrinsics, but cannot have them */
	NOTE_OUT_OF_RANGE,  /* numbers of the second scene are out of range */
	NOTES,
};

/* The maps of a scene. clip[j] is clip coordinate j (x, y, z or w) as a function on
 * view space: three elements are its gradient, the fourth is its value at the origin.
 * Parallel projectors are perpendicular to the gradients of x and y. The gradient of w
 * is normal to the projection plane; if w is constant, the gradient of z is. */
struct lens {
	const struct scene *scene;
	struct volume volume;
	struct map to_view, to_world; /* from world to view space and back */
	struct sum clip[4][4]; /* columns of volume.to_clip; y points upward */
	struct sum half[2], scale[2]; /* set by view_limits */
	bool parallel, reversed; /* reversed: near has the larger ndc depth */
};

/* Makes the maps of a scene. Returns NULL, or the member at fault and why. */
const char *lens_of(const struct scene *, struct lens *);

/* Writes the unit vector in world space along an axis given in view space. */
void lens_axis(const struct lens *, const struct sum axis[3], double unit[3]);

/* The formats of depth buffers. */
enum buffer { BUFFER_UNORM16, BUFFER_UNORM24, BUFFER_FLOAT32, BUFFERS };

/* A point of depth z has the distance D = (num[0] z + num[1]) / (den[0] z + den[1]). z
 * is device depth; without a viewport, z is 0 to 1. D is measured on the normal of the
 * projection plane: in a perspective from the eye, in a parallel projection from the
 * origin of view space (depth.c says which way). den[0] is 0 only in a parallel
 * projection. In a perspective den[0] z + den[1] is positive in front of the eye. */
struct depth {
	struct sum num[2], den[2];
	double low, high; /* z at the least ndc depth, and at ndc depth 1 */
	bool reversed;    /* the near plane has the larger ndc depth */
	bool open;        /* there are no near and far planes */
	bool constant;    /* the viewport's min_z is max_z; low is 0, high 1 */
};

void depth_of(const struct lens *, struct depth *);

/* Writes the distance of the near or far plane as the quotient num / den. */
void depth_quotient(const struct depth *, bool far, struct sum *num,
    struct sum *den);

/* Returns the distance of the near or far plane: infinite if the plane is at infinity,
 * nan if the plane is behind the eye or does not exist. */
double depth_distance(const struct depth *, bool far);

/* Returns the length in space of one step of the buffer's depth, from the near or far
 * plane toward the other plane. A step of BUFFER_FLOAT32 ends at the next float.
 * Returns nan if the plane is at infinity or does not exist, or if the whole range of
 * depth is less than a step. */
double depth_step(const struct depth *, enum buffer, bool far);

/* Returns the length in space of one step of the buffer's depth, from points at the
 * given distance toward the eye. */
double depth_step_at(const struct depth *, enum buffer, double distance);

/* Facts about a scene's picture. A number that does not exist is nan; the others are
 * the doubles nearest to the exact numbers, except error_bound. */
struct picture {
	enum taxon taxon;
	enum kind kind;
	/* In a parallel projection: the lengths in view space of the images, on the
	 * projection plane, of the unit vectors of the world's axes. */
	double foreshortening[3];
	/* World axes' vanishing points, on the device or, if it is missing, in ndc. */
	double vanishing_point[3][2];
	double fov[2];  /* degrees from left to right, and from bottom to top */
	double eye[3];  /* in world space */
	double gaze[3]; /* unit normal of the projection plane */
	double corner[8][3]; /* in world space, in the order of struct volume */
	/* Distances of the planes, as in struct depth. far may be infinite. */
	double near, far;
	struct depth depth;
	double aspect;
	bool reverse_z;
	/* The near plane's edges in view space: x of left, right, y of bottom, top. */
	double near_edge[4];
	/* The matrix K takes X, Y, Z of view space to u w, v w, w, with u and v in
	 * pixels from the viewport's corner. X is to the right, Y along device y, Z
	 * along the gaze. */
	double intrinsics[3][3];
	/* a b c d for left, right, bottom, top, near and far: a point x y z of world
	 * space is inside if a x + b y + c z + d >= 0. a b c is a unit vector. */
	double frustum_plane[6][4];
	double error_bound[3]; /* [enum precision] */
	unsigned notes;        /* bit i is set if enum note i applies */
	/* The second scene, in the convention of answer_convention. The camera is given
	 * by eye and gaze, the projection by edges or, if there are no near and far
	 * planes or if clip x depends on y, by intrinsics. */
	bool has_scene;
	struct scene scene;
};

/* Sets the members of struct picture from taxon to corner. A number that does not exist
 * keeps the nan that the caller has set. */
void taxonomy_of(const struct lens *, struct picture *);

/* Sets all members of the picture. Returns NULL, or the member at fault and why. */
const char *picture_of(const struct scene *, struct picture *);

#endif
