/* SPDX-License-Identifier: MIT */
#include "textbook.h"

#include <string.h>

#include "../points/point.h"

enum { STEPS = 5 }; /* points along each axis of the volume */

/* The program: the product of its matrices, and its constants of the viewport. A float
 * is computed as a double and then rounded, which gives the float that one rounding of
 * a sum, a product or a quotient of two floats gives, as 53 >= 2 24 + 2 (Figueroa,
 * "When is double rounding innocuous?", 1995). */
struct program {
	bool single;
	double m[4][4];
	double scale[2], offset[2];
};

static double program_rounded(const struct program *g, double a)
{
	return g->single ? (double)(float)a : a;
}

/* Returns the sum of four products a[k] b[k * 4], from left to right. */
static double dot(const struct program *g, const double *a, const double *b)
{
	double r = program_rounded(g, a[0] * b[0]);

	for (int k = 1; k < 4; k++)
		r = program_rounded(g, r + program_rounded(g, a[k] * b[k * 4]));
	return r;
}

/* Makes the program of a scene, whose maps the caller has made before: a scene's absent
 * members have no matrix in it, but a change of the view axes by -c has one without a
 * camera, too. */
static void set_program(const struct scene *s, struct program *g)
{
	const struct convention *from = &s->convention,
				*to = scene_answer_convention(s);
	const bool turns = from->view_y_down != to->view_y_down ||
	    convention_looks_back(from) != convention_looks_back(to);
	const bool has[3] = { s->has_world, s->has_camera || turns,
		!projection_is_none(&s->projection) ||
		    (s->has_viewport && viewport_is_part(&s->viewport)) };
	double a[4][4], b[4][4];
	struct map m;

	for (int k = 0; k < 3; k++) {
		if (!has[k])
			continue;
		scene_map_factor(s, (enum space)k, (enum space)(k + 1), &m, NULL);
		memcpy(a, g->m, sizeof a);
		for (int i = 0; i < 16; i++)
			b[i / 4][i % 4] = map_element_nearest(&m, i / 4, i % 4,
			    g->single);
		for (int i = 0; i < 16; i++)
			g->m[i / 4][i % 4] = dot(g, a[i / 4], &b[0][i % 4]);
	}
	scene_map_factor(s, SPACE_NDC, s->has_viewport ? SPACE_DEVICE : SPACE_NDC, &m,
	    NULL);
	for (int k = 0; k < 2; k++) {
		g->scale[k] = map_element_nearest(&m, k, k, g->single);
		g->offset[k] = map_element_nearest(&m, 3, k, g->single);
	}
}

/* Computes the program's x and y of a point. Returns whether w is positive, and all
 * numbers are finite. */
static bool run_program(const struct program *g, const double p[4], double image[2])
{
	const double w = dot(g, p, &g->m[0][3]);

	for (int k = 0; k < 2; k++) {
		double x = program_rounded(g, dot(g, p, &g->m[0][k]) / w);

		x = program_rounded(g, x * g->scale[k]);
		image[k] = program_rounded(g, x + g->offset[k]);
	}
	return w > 0 && isfinite(w) && isfinite(image[0]) && isfinite(image[1]);
}

/* Writes the square of the distance of an image from the exact image of p. */
static void squared_error(const struct transform *t, const double p[4],
    const double image[2], struct sum *square)
{
	struct sum w = point_column(t, 3, p), e[2];

	for (int k = 0; k < 2; k++) {
		struct sum at = point_column(t, k, p);

		at = sum_sub(at, sum_scale(w, image[k]));
		e[k] = sum_quotient(at, w);
	}
	sum_dot(2, e, e, 1, square);
}

/* Writes point i of the volume, in model space and rounded. Returns false if it is at
 * infinity. `back` leads from ndc to model space. */
static bool volume_point(const struct scene *s, const struct map *back, int i,
    bool single, double p[4])
{
	const int step[3] = { i % STEPS, i / STEPS % STEPS, i / STEPS / STEPS };
	const double low = scene_answer_convention(s)->depth_minus_one ? -1 : 0;
	struct sum half[2], scale[2], at[4], d, c;

	frustum_limits(s, half, scale);
	for (int k = 0; k < 2; k++)
		at[k] = sum_mul(sum_scale(half[k], step[k] * 0.5 - 1), scale[1 - k]);
	at[3] = sum_mul(scale[0], scale[1]);
	at[2] = sum_scale(at[3], low + step[2] * 0.25 * (1 - low));
	map_image(back, 3, at, &d);
	if (sum_sign(d) == 0)
		return false;
	for (int k = 0; k < 3; k++) {
		map_image(back, k, at, &c);
		p[k] = sum_ratio_nearest(&c, &d, single);
	}
	p[3] = 1;
	return true;
}

/* Returns the error of the program, or nan. */
static double program_error(const struct scene *s, const struct program *g,
    const struct transform *t, const struct map *back)
{
	struct sum most, square;
	double p[4], image[2];

	sum_set(&most, 0);
	for (int i = 0; i < STEPS * STEPS * STEPS; i++) {
		if (!volume_point(s, back, i, g->single, p))
			continue;
		if (!run_program(g, p, image))
			return (double)NAN;
		squared_error(t, p, image, &square);
		if (sum_compare(square, most) > 0)
			sum_copy(&most, &square);
	}
	most = sum_sqrt(most);
	return sum_double(most);
}

bool textbook_errors(const struct scene *s, double error[2], struct refusals *faults)
{
	struct map back;
	struct transform t;

	error[0] = error[1] = (double)NAN;
	if (!transform_of_scene(s, SPACE_MODEL,
		s->has_viewport ? SPACE_DEVICE : SPACE_NDC, false, &t, faults))
		return false;
	if (projection_is_open(&s->projection) ||
	    !scene_map_factor(s, SPACE_NDC, SPACE_MODEL, &back, NULL))
		return true;
	for (int k = 0; k < 2; k++) {
		struct program g = { .single = k == 0,
			.m = { { 1 }, { 0, 1 }, { 0, 0, 1 }, { 0, 0, 0, 1 } } };

		set_program(s, &g);
		error[k] = program_error(s, &g, &t, &back);
	}
	return true;
}
