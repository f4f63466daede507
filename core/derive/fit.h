/* SPDX-License-Identifier: MIT */
/* The tightest camera and view volume, or 2D window, that hold given bounds or points. */
#ifndef FIT_H
#define FIT_H

#include "fit_points.h"

/* Completes a scene of type persp, ortho, oblique or volume, and gives its camera the form
 * CAMERA_GAZE. The axes of view space stay. near and far close on the bounds. near, far
 * and, of a parallel projection, width and height need not be set before the call;
 * without has_eye camera.eye is ignored.
 *
 * persp keeps the directions of its side planes and moves the eye along the gaze until
 * the side planes hold the bounds and one of them touches, or near is near_ratio times
 * far. If the bounds are points and the scene has no eye, the eye moves across the gaze,
 * too: both planes of the tighter pair touch, and those of the other pair are at equal
 * distances.
 *
 * ortho and oblique are centred on the bounds. Their width and height close on the
 * bounds; then the shorter side is widened to the aspect, if one is set (aspect[1] is not
 * 0).
 *
 * A volume gets z_near and z_far only, closed on the bounds along the convention's gaze.
 * Where the eye is before near, near is no nearer to it than near_ratio of the eye's
 * distance to far.
 *
 * A margin moves the side planes inward before they are compared with the bounds.
 *
 * The eye is rounded to doubles; in persp it steps back by the least power of two that
 * outweighs the rounding. From the rounded eye every corner or point is in the volume, as
 * frustum_out decides, and near, far and the sizes of a parallel projection are the
 * tightest doubles for which that holds, unless the bounds are so far from the eye that
 * they are not known to the last bit. Returns NULL, or the member and the reason. */
const char *fit_scene(struct scene *, bool has_eye, const struct bounds *);

/* Finds the directions that fit_scene measures the bounds in: the farthest points along
 * these make the same scene as all points. Returns NULL, or the member and the reason. */
const char *fit_directions(const struct scene *, bool has_eye,
    struct directions *);

/* Replaces the scene's 2D window by one of center, width and height that holds x and y of
 * the bounds. The center is the double nearest to the middle of the bounds; width and
 * height are the least doubles for which all of the bounds is in the window, less the
 * margin, as frustum_out decides. Then the shorter side is widened to the device's
 * shape, if there is a device. A zero extent along one axis counts as 2^-20 of the
 * other. Returns NULL, or the member and the reason. */
const char *fit_window(struct scene *, const struct bounds *);

/* Finds the directions that fit_window measures in: -x, x, -y and y. */
void window_directions(struct directions *);

#endif
