/* The ray under a position on the device. */
#ifndef RAY_H
#define RAY_H

#include "point.h"

struct ray_maker {
	struct transform to_world; /* from the device */
	struct transform to_view;  /* from the device */
	struct transform turn;     /* from view to world */
	double depth;              /* the near plane's, on the device */
	/* There is no near plane: rays begin at the eye, here as doubles and as
	 * floats. */
	bool from_eye;
	double eye[2][3];
	bool against; /* device depth falls away from the eye */
};

/* Returns NULL, or the member and the reason. */
const char *ray_maker_of(const struct scene *, struct ray_maker *);

/* The point on the near plane under a device position, or the eye where there is no
 * such plane, and the unit direction away from the eye, from near to far, in world
 * space: the nearest doubles, or floats. nan where there is none. */
void ray_exact(const struct ray_maker *, const double at[2], bool single,
    double point[3], double direction[3]);

#endif
