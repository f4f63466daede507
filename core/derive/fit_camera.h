/* SPDX-License-Identifier: MIT */
/* The camera that fit moves: by eye and gaze. */
#ifndef GAZE_H
#define GAZE_H

#include "fit_bounds.h"

/* Makes the camera one of CAMERA_GAZE. A gaze keeps its numbers; at - eye is
 * rounded, and so are the axes of an orientation and of the rotation nearest to
 * a matrix. A scene without a camera gets one at 0 that looks along view space's
 * own axis. */
const char *gaze_of(struct scene *);

/* Where the eye is, in the world, after a step in view space; back leads from
 * view to world. */
void eye_move(const struct map *back, const struct sum step[3], double eye[3]);

#endif
