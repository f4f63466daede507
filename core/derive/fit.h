/* SPDX-License-Identifier: MIT */
/* The tightest camera and view volume, or window, that hold given bounds or points. */
#ifndef FIT_H
#define FIT_H

#include "fit_points.h"

/* Of a volume finds z_near and z_far alone: they close round the bounds along the
 * convention's gaze, near no nearer to an eye before it than near_ratio of the eye's
 * distance to far. The rest is of other types.
 *
 * Completes a scene of type persp, ortho or oblique, whose near and far, and
 * width and height of a parallel one, need not be set; without an eye (has_eye)
 * camera.eye does not count. The axes of view stay; the camera is brought to
 * CAMERA_GAZE.
 *
 * persp keeps its slopes and moves the eye along the gaze until the side planes
 * hold the bounds and one of them touches, or near is near_ratio times far. Where
 * the bounds are points and there is no eye, it moves across the gaze, too: both planes
 * of the tighter pair touch, and those of the other leave as much free.
 * Parallel ones are centred on the bounds; their width and height close round
 * them, the shorter one widened to the aspect where that is set (aspect[1] is
 * not 0). near and far close round the bounds.
 *
 * With a margin, what is said of sides holds for those that leave it free.
 *
 * The eye is rounded to doubles, in persp with a step back by the least power
 * of two that makes up for it. There every corner or point is in, as frustum_out says,
 * and near, far and the sizes of a parallel projection are the tightest doubles
 * for which that is so, unless the bounds lie so far from the eye that they are
 * not known to the last bit. Returns NULL, or the member and the reason. */
const char *fit_scene(struct scene *, bool has_eye, const struct bounds *);

/* The directions in which points have to be the farthest of all for bounds of them to
 * stand for all. Returns NULL, or the member and the reason. */
const char *fit_directions(const struct scene *, bool has_eye,
    struct directions *);

/* Gives the scene a window by center, width and height, in the place of any other,
 * that holds the bounds' x and y. The center is the double nearest to the middle of
 * the bounds; width and height are the least doubles for which, about that center,
 * all is in: as frustum_out says, or with a margin in what it leaves. Then the shorter
 * side, by the device's shape, is widened to that, where there is a device. What has
 * no extent along one axis is taken to be 2^-20 of the other. Returns NULL, or the
 * member and the reason. */
const char *fit_window(struct scene *, const struct bounds *);

/* The directions in which a window closes on points: the box about those that are
 * farthest in them is the box about all. */
void window_directions(struct directions *);

#endif
