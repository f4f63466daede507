/* SPDX-License-Identifier: MIT */
/* The tightest camera and view volume, or 2D window, that hold given bounds or points. */
#ifndef FIT_H
#define FIT_H

#include "fit_bounds.h"

/* Completes a scene of type persp, ortho, oblique or volume, and gives its camera the
 * form CAMERA_GAZE. The axes of view space do not change. near and far become the ends
 * of the bounds' depth. The caller need not set near, far and, in a parallel projection,
 * width and height; camera.eye is ignored without has_eye.
 *
 * persp keeps the directions of its side planes. The eye moves along the gaze until the
 * bounds are between the side planes and one plane touches the bounds, or until near is
 * near_ratio times far. If the bounds are points and the scene has no eye, the eye also
 * moves across the gaze: both planes of the tighter pair touch the bounds, and the
 * planes of the other pair are equally far from the bounds.
 *
 * ortho and oblique are centred on the bounds. Width and height become the least that
 * hold the bounds; then the shorter side is widened to the aspect, if the projection has
 * one (aspect[1] is not 0).
 *
 * In a volume only z_near and z_far change, to the ends of the bounds along the
 * convention's gaze. If the eye is before near, the distance from the eye to near is at
 * least near_ratio times the distance from the eye to far.
 *
 * A margin moves the side planes inward before they are compared with the bounds.
 *
 * The eye is rounded to doubles; in persp it steps back by the least power of two that
 * outweighs the rounding. Every corner or point of the bounds is in the volume of the
 * rounded eye, as frustum_out decides. near, far and the sizes of a parallel projection
 * are the tightest such doubles, unless the bounds are so far from the eye that they are
 * not known to the last bit. Returns NULL, or the member and the reason. */
const char *fit_scene(struct scene *, bool has_eye, const struct bounds *);

/* Finds the directions along which fit_scene measures the bounds. The farthest points
 * along them make the same scene as all points. Returns NULL, or the member and the
 * reason. */
const char *fit_directions(const struct scene *, bool has_eye,
    struct directions *);

/* Replaces the scene's 2D window by one of center, width and height that holds x and y of
 * the bounds. The center is the double nearest to the middle of the bounds. Width and
 * height are the least doubles for which the window without its margin holds the bounds,
 * as frustum_out decides. Then the shorter side is widened to the device's shape, if
 * there is a device. A zero extent along one axis counts as 2^-20 of the other. Returns
 * NULL, or the member and the reason. */
const char *fit_window(struct scene *, const struct bounds *);

/* Sets the directions along which fit_window measures: x, -x, y and -y. */
void window_directions(struct directions *);

#endif
