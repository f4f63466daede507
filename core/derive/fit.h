/* SPDX-License-Identifier: MIT */
/* Fits a scene or a 2D window to bounds, so that its picture holds them, as the command
 * fit does. fit_bounds.h has the bounds; if they are points, the caller collects those
 * that matter by fit_points.h, along the directions that are found here. */
#pragma once

#include "fit_points.h"

/* Completes a scene of type persp, ortho, oblique or volume, and gives its camera the
 * form CAMERA_GAZE, as the command fit does. Ignores the given near and far, except a
 * near plane on which sizes are given; width and height of ortho and oblique; and
 * camera.eye if has_eye is false.
 *
 * persp keeps the directions of its side planes. The eye moves along the gaze until the
 * bounds are between the side planes and one plane touches the bounds, or until near is
 * near_ratio times far, or min_near. If the bounds are points and has_eye is false, the
 * eye also moves across the gaze. Both planes of the tighter pair then touch the
 * bounds, and the bounds are centred between the other two planes: the functions of
 * these planes (frustum_planes in frustum.h) have the same least value on the bounds.
 *
 * In a volume only z_near and z_far change, to the ends of the bounds along the
 * convention's gaze, z or -z of view space. If the eye is on near's side of far, near
 * is moved until its distance from the eye is at least near_ratio times far's, and
 * min_near; if not, far until its distance is at least min_near.
 *
 * The eye is rounded to doubles; in persp it then moves back until frustum_outside
 * finds the bounds inside. near, far and the sizes of ortho and oblique are the
 * tightest such doubles, unless the errors of a far eye exceed the last bits of the
 * bounds. */
bool fit_scene(struct scene *, bool has_eye, const struct bounds *,
    struct refusals *faults);

/* Finds the directions for which fit_scene makes the same scene of the farthest points
 * along them as of all points. */
bool fit_directions(const struct scene *, bool has_eye, struct directions *,
    struct refusals *faults);

/* Replaces the scene's 2D window by the least that holds x and y of the bounds, given
 * by center, width and height, as frustum_outside finds. */
bool fit_window(struct scene *, const struct bounds *, struct refusals *faults);

/* Refuse what is wrong with each member that fit_scene and fit_window read by itself,
 * as they stop at the first fault. Numbers that were refused are NaN. The bounds may be
 * NULL. fit_check_window also makes the hull, and returns whether nothing is wrong. */
void fit_check(const struct scene *, const struct bounds *, struct refusals *faults);
bool fit_check_window(const struct scene *, const struct bounds *, struct hull *,
    struct refusals *faults);

/* Sets the directions along which fit_window measures: x, -x, y and -y. */
void fit_window_directions(struct directions *);
