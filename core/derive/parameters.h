/* SPDX-License-Identifier: MIT */
/* What of a scene's picture can be said in parameters: its planes, and a camera and
 * a projection that make it. */
#ifndef PARAMETERS_H
#define PARAMETERS_H

#include "taxonomy.h"

/* All are nearest doubles; nan stands for what there is not. */
struct parameters {
	/* From the eye, in a parallel projection from the origin of view space along
	 * the convention's gaze. far may be infinite. */
	double near, far;
	double aspect;
	bool reverse_z;
	/* left, right, bottom and top where they meet the near plane: x or y of
	 * view space */
	double plane[4];
	/* a b c d in world space for left, right, bottom, top, near and far: inside
	 * is where a x + b y + c z + d >= 0; a b c is a unit vector */
	double frustum_plane[6][4];
	/* By eye and gaze, and by edges, or where x depends on y or there are no
	 * planes by intrinsics; in the convention of the answer. */
	bool has_scene;
	struct scene scene;
};

/* Returns NULL, or the member and the reason. */
const char *parameters_of(const struct scene *, const struct taxonomy *,
    struct parameters *);

#endif
