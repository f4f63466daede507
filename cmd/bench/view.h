/* SPDX-License-Identifier: MIT */
/* The view that the benchmarks measure, and the error of an image of a point.
 * All numbers of the view are floats, so that libraries in float get the same
 * scene. */
#pragma once

#include <math.h>
#include <string.h>

#include "../../core/test/truth.h"
#include "peer/peer.h"

static struct view bench_view = { .eye = { 1, 2, -5 },
	.at = { 0.125, 0.25, 0.375 },
	.up = { 0, 1, 0 },
	.fovy = 60,
	.near = 1,
	.far = 10,
	.width = 640,
	.height = 480 };

static inline struct scene scene_of(const struct view *v)
{
	struct scene s = {
		.has_camera = true,
		.camera = { .way = CAMERA_AT },
		.projection = { .type = PROJECTION_PERSP,
		    .section.way = SECTION_FOVY,
		    .section.angle = v->fovy,
		    .aspect = { v->width, v->height },
		    .near = v->near,
		    .far = v->far },
		.has_viewport = true,
		.viewport = { .width = v->width, .height = v->height, .max_z = 1 },
	};

	memcpy(s.camera.eye, v->eye, sizeof v->eye);
	memcpy(s.camera.at, v->at, sizeof v->at);
	memcpy(s.camera.up, v->up, sizeof v->up);
	return s;
}

static inline void compose(struct view *v)
{
	struct scene s = scene_of(v);
	real m[4][4];
	int mark = real_mark();

	truth_matrix(&s, SPACE_WORLD, SPACE_DEVICE, m);
	for (int i = 0; i < 16; i++) {
		double *const parts[] = { &v->matrix[i / 4][i % 4],
			&v->matrix_rest[0][i / 4][i % 4],
			&v->matrix_rest[1][i / 4][i % 4] };
		real rest = m[i % 4][i / 4];

		for (int part = 0; part < 3; part++) {
			*parts[part] = mpfr_get_d(rest, MPFR_RNDN);
			rest = sub(rest, real_of(*parts[part]));
		}
	}
	real_release(mark);
}

/* Returns the error of the worst coordinate of an image; infinity for nan. */
static inline double error_of(const struct truth *t, const double point[3],
    const double image[3])
{
	const double p[4] = { point[0], point[1], point[2], 1 };
	double worst = 0;
	int mark = real_mark();
	real w = truth_column(t, 3, p).value;

	for (int k = 0; k < 3; k++) {
		if (!isfinite(image[k]))
			return HUGE_VAL;
		real right = divide(truth_column(t, k, p).value, w);
		real error = magnitude(sub(right, real_of(image[k])));

		worst = fmax(worst, mpfr_get_d(error, MPFR_RNDU));
	}
	real_release(mark);
	return worst;
}
