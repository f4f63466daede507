/* The ray under a position on the device. */
#ifndef RAY_H
#define RAY_H

#include "scene.h"

struct ray_maker {
	struct map to_view;  /* from the device */
	struct map to_world; /* from view */
	double depth;        /* the near plane's, on the device */
	double
	    sign; /* +1 where device depth grows away from the eye, else -1 */
};

/* Returns NULL, or the member and the reason. */
const char *ray_maker_of(const struct scene *, struct ray_maker *);

/* The point on the near plane under a device position, and the unit direction
 * away from the eye, in world space; each coordinate within 1/2 + kappa 2^-47
 * units in the last place. nan where there is none. */
void ray_exact(const struct ray_maker *, const double at[2], double point[3],
    double direction[3]);

#endif
