/* SPDX-License-Identifier: MIT */
#include "point.h"

#include <math.h>

#include "kernel/midway.h"

/* Sets p to the point `in`, homogeneous and relative to the transform's origin. The
 * origin is 0 if the points are of clip space, as their w may differ from 1. */
static void set_relative(const struct transform *t, const double in[4], struct sum p[4])
{
	for (int i = 0; i < 3; i++)
		if (t->origin[i] == 0)
			sum_set(&p[i], i < t->in ? in[i] : 0);
		else
			p[i] = sum_difference(i < t->in ? in[i] : 0, t->origin[i]);
	sum_set(&p[3], t->in == 4 && !t->reciprocal ? in[3] : 1);
}

/* Sets p to the point from which column_of computes images: in view space if t is
 * staged, else relative to the origin. */
static void set_point(const struct transform *t, const double in[4], struct sum p[4])
{
	struct sum q[4];

	set_relative(t, in, t->staged ? q : p);
	for (int j = 0; j < 3 && t->staged; j++)
		sum_dot(4, q, &t->relative[0][j], 4, &p[j]);
	if (t->staged) /* the map to view space is affine */
		sum_copy(&p[3], &t->relative[3][3]);
	if (t->distance == DISTANCE_IN) {
		p[3] = sum_mul(p[2], t->length);
		sum_copy(&p[2], &t->unit);
		p[0] = sum_scale(p[3], in[0]);
		p[1] = sum_scale(p[3], in[1]);
	}
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
	if (t->distance == DISTANCE_IN && !(in[2] > 0))
		return false;
	if (!t->divide) {
		sum_copy(d, &t->map.divisor);
		if (t->distance == DISTANCE_IN)
			*d = sum_mul(*d, t->unit);
		return true;
	}
	if (t->reciprocal && t->out == 4)
		*d = sum_scale(t->map.divisor, in[3]);
	else
		column_of(t, 3, p, d);
	int sign = sum_sign(*d);

	return t->front ? sign > 0 : sign != 0;
}

/* Sets n and d to numerator and divisor of coordinate j of the image of p, with the
 * divisor of find_divisor as *d. Returns false if coordinate j is a distance and the
 * point, of clip or ndc space, is beyond infinity. */
static bool find_quotient(const struct transform *t, int j, const struct sum p[4],
    struct sum *n, struct sum *d)
{
	column_of(t, j, p, n);
	if (j != 2 || t->distance != DISTANCE_OUT)
		return true;
	const bool finite = sum_sign(*n) > 0;
	struct sum scale = sum_mul(*n, t->length);

	*n = sum_mul(*d, t->unit);
	sum_copy(d, &scale);
	return finite;
}

void point_exact(const struct transform *t, const double in[4], double out[4])
{
	struct sum p[4], q, d;
	bool has_image = true;

	for (int i = 0; i < t->in; i++)
		has_image &= !isnan(in[i]);
	if (has_image) {
		set_point(t, in, p);
		has_image = find_divisor(t, in, p, &d);
	}
	for (int j = 0; j < t->out; j++) {
		double v = (double)NAN;

		has_image = has_image && find_quotient(t, j, p, &q, &d);
		if (has_image)
			v = sum_ratio_nearest(&q, &d, false);
		out[j] = isfinite(v) ? v : (double)NAN;
	}
	for (int j = 0; j < t->out && !has_image; j++)
		out[j] = (double)NAN;
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
	find_quotient(t, j, p, &q, &d);
	return (float)sum_ratio_nearest(&q, &d, true);
}
