/* SPDX-License-Identifier: MIT */
#include "point.h"

#include <math.h>
#include <string.h>

#include "kernel/midway.h"

/* Sets p to the point `in`, homogeneous and relative to the transform's origin. The
 * origin is 0 if the points are of clip space, as their w may differ from 1. */
static void set_relative(const struct transform *t, const double in[4], struct sum p[4])
{
	for (int i = 0; i < 3; i++)
		p[i] = sum_difference(i < t->in ? in[i] : 0, t->origin[i]);
	p[3] = sum_of_double(t->in == 4 && !t->reciprocal ? in[3] : 1);
}

/* Replaces p, relative to the origin, by the point in view space, if t is staged. */
static void take_stage(const struct transform *t, struct sum p[4])
{
	struct sum q[4];

	if (!t->staged)
		return;
	for (int j = 0; j < 4; j++)
		sum_dot(4, p, &t->relative[0][j], 4, &q[j]);
	memcpy(p, q, sizeof q);
}

/* Computes column j of the image of p, which set_point has made. */
static void column_of(const struct transform *t, int j, const struct sum p[4],
    struct sum *r)
{
	if (t->staged)
		map_image(&t->from_view, j, p, r);
	else
		sum_dot(4, p, &t->relative[0][j], 4, r);
}

static void set_point(const struct transform *t, const double in[4], struct sum p[4])
{
	set_relative(t, in, p);
	take_stage(t, p);
}

struct sum point_column(const struct transform *t, int j, const double in[4])
{
	struct sum p[4], r;

	set_point(t, in, p);
	column_of(t, j, p, &r);
	return r;
}

/* Sets *d to the divisor of the image's columns. Returns false if p has no image. */
static bool find_divisor(const struct transform *t, const double in[4],
    const struct sum p[4], struct sum *d)
{
	*d = t->map.divisor;
	if (!t->divide)
		return true;
	if (t->reciprocal && t->out == 4)
		*d = sum_mul(*d, sum_of_double(in[3]));
	else
		column_of(t, 3, p, d);
	int sign = sum_sign(*d);

	return t->front ? sign > 0 : sign != 0;
}

void point_exact(const struct transform *t, const double in[4], double out[4])
{
	struct sum p[4], q, d;

	for (int j = 0; j < t->out; j++)
		out[j] = (double)NAN;
	for (int i = 0; i < t->in; i++)
		if (isnan(in[i]))
			return;
	set_point(t, in, p);
	if (!find_divisor(t, in, p, &d))
		return;
	for (int j = 0; j < t->out; j++) {
		column_of(t, j, p, &q);
		double v = sum_ratio_nearest(&q, &d, false);

		if (isfinite(v))
			out[j] = v;
	}
}

/* A double that is not midway between two floats is on the same side of each midpoint
 * as the exact image, so that both round to the same float. */
float point_exact_float(const struct transform *t, const double in[4], int j,
    double image)
{
	struct sum p[4], q, d;

	if (!is_midway(image))
		return (float)image;
	set_point(t, in, p);
	find_divisor(t, in, p, &d);
	column_of(t, j, p, &q);
	return (float)sum_ratio_nearest(&q, &d, true);
}
