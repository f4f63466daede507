/* The view volume: which of its planes a point is outside of, and the ray
 * under a pixel. */
#ifndef FRUSTUM_H
#define FRUSTUM_H

#include "point.h"

enum {
	OUT_LEFT = 1,
	OUT_RIGHT = 2,
	OUT_BOTTOM = 4,
	OUT_TOP = 8,
	OUT_NEAR = 16,
	OUT_FAR = 32,
	OUT_BEHIND = 64,
	OUT_NAN = 128,
};

/* A point is inside where all columns of both are at least 0. */
struct frustum {
	struct transform sides; /* left right bottom top */
	struct transform ends;  /* near far w */
};

/* The planes as seen from one space, with its viewport's limits. Returns NULL,
 * or the member and the reason. */
const char *frustum_of(const struct scene *, enum space from, bool homogeneous,
    struct frustum *);

/* 0 where the point is inside or on a plane; behind comes alone. */
unsigned frustum_out(const struct frustum *, const double in[4]);

/* Model space to the distance along the gaze from the near plane, within 1/2 +
 * kappa 2^-47 units in the last place. */
const char *depth_transform(const struct scene *, struct transform *);
double depth_of(const struct transform *, const double in[4]);

/* Whether a device position is no further than radius from at, exactly but for
 * 2^-100. */
bool is_within(const double device[2], const double at[2], double radius);

struct ray_maker {
	struct map to_view;  /* from the device */
	struct map to_world; /* from view */
	double depth;        /* the near plane's, on the device */
	double sign;         /* of device depth away from the eye */
};

const char *ray_maker_of(const struct scene *, struct ray_maker *);

/* The point on the near plane under a device position, and the unit direction
 * in which depth increases, in world space; each coordinate within 1/2 +
 * kappa 2^-47 units in the last place. nan where there is none. */
void ray_exact(const struct ray_maker *, const double at[2], double point[3],
    double direction[3]);

#endif
