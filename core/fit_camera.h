/* The camera that fit moves: by eye and gaze. */
#ifndef GAZE_H
#define GAZE_H

#include "fit_bounds.h"

/* Brings the camera to CAMERA_GAZE: a gaze keeps its numbers, at - eye is
 * rounded, and so are the axes of an orientation and of a matrix' nearest
 * rotation. Without a camera it stands at 0 and looks as view space does. */
const char *gaze_of(struct scene *);

/* The eye after a step in view space, from which back leads to the world. */
void eye_move(const struct map *back, const struct estimate step[3],
    double eye[3]);

#endif
