/* SPDX-License-Identifier: MIT */
#include "depth.h"

#include "../points/distance.h"

/* The depth of a point is z / w. Let z0 and w0 be z and w at the point from which the
 * distance D is measured, and dz and dw the dot products of their gradients with n,
 * along which D is measured. Then
 *
 *	depth = (z0 + D dz / |n|) / (w0 + D dw / |n|),
 *	D = |n| (w0 depth - z0) / (dz - dw depth).
 *
 * In a perspective w0 is 0. The point is homogeneous: the denominator is multiplied by
 * its last coordinate. Numerator and denominator are negated if D is then
 * positive where the denominator is or, if w is constant, if this gives the
 * denominator its sign. */
void depth_of(const struct lens *l, struct depth *d)
{
	const struct scene *s = &l->scene;
	const struct viewport *v = &s->viewport;
	const bool has_range = s->has_viewport && v->min_z != v->max_z;
	const struct viewport range = { .width = 2,
		.height = 2,
		.min_z = has_range ? v->min_z : 0,
		.max_z = has_range ? v->max_z : 1 };
	const struct sum origin[4] = { [3] = sum_one };
	const bool is_origin = l->parallel || vec3_is_zero(l->eye);
	const struct sum *from = is_origin ? origin : l->eye;
	struct sum at[2], slope[2]; /* of z and w */
	struct distance along;
	struct map m, to_range;

	*d = (struct depth){ .plane = { l->reversed ? range.max_z : range.min_z,
				 l->reversed ? range.min_z : range.max_z },
		.open = projection_is_open(&s->projection),
		.constant = s->has_viewport && !has_range };
	/* lens_of has refused a scene of which these make no map */
	distance_of(s, &along, NULL);
	viewport_map(&range, scene_answer_convention(s), false, &to_range, NULL);
	map_copy(&m, &l->to_clip);
	map_multiply(&m, &to_range, false);
	for (int k = 0; k < 2; k++) {
		map_image(&m, 2 + k, from, &at[k]);
		sum_dot(3, along.column, &m.m[0][2 + k], 4, &slope[k]);
		slope[k] = sum_mul(slope[k], from[3]);
	}
	if (!l->parallel)
		sum_set(&at[1], 0);
	const bool minus = l->parallel ? sum_sign(slope[0]) != sum_sign(at[1]) :
					 sum_sign(at[0]) > 0;

	d->num[0] = sum_negated_if(minus, sum_mul(along.length, at[1]));
	d->num[1] = sum_negated_if(!minus, sum_mul(along.length, at[0]));
	d->den[0] = sum_negated_if(!minus, slope[1]);
	d->den[1] = sum_negated_if(minus, slope[0]);
}

void depth_quotient(const struct depth *d, bool far, struct sum *num, struct sum *den)
{
	*num = sum_add(sum_scale(d->num[0], d->plane[far]), d->num[1]);
	*den = sum_add(sum_scale(d->den[0], d->plane[far]), d->den[1]);
}

double depth_distance(const struct depth *d, bool far)
{
	struct sum num, den;

	depth_quotient(d, far, &num, &den);
	if (d->open || (sum_sign(den) < 0 && sum_sign(d->den[0]) != 0))
		return (double)NAN;
	return sum_sign(den) == 0 ? HUGE_VAL : sum_ratio_or_nan(num, den);
}

/* Finds the least float above z or, if up is -1, the greatest float below z. Returns
 * false if this float is infinite. */
static bool next_float(const struct sum *z, int up, struct sum *next)
{
	float f = (float)sum_ratio_nearest(z, &sum_one, true);

	if (!isfinite(f) || sum_compare(sum_of_double((double)f), *z) * up <= 0)
		f = nextafterf(f, up > 0 ? HUGE_VALF : -HUGE_VALF);
	if (isfinite(f))
		sum_set(next, (double)f);
	return isfinite(f) != 0;
}

/* The steps of a buffer in depths from 0 to 1. A float's depth counts as it is. */
static const double buffer_steps
    [] = { [DEPTH_UNORM16] = 0xffff, [DEPTH_UNORM24] = 0xffffff, [DEPTH_FLOAT32] = 1 };

/* Finds the depth, times buffer_steps, that is a step above z or, if up is -1, below z.
 * Returns false if the next float is infinite. */
static bool next_depth(const struct sum *z, enum depth_buffer b, int up,
    struct sum *next)
{
	if (b == DEPTH_FLOAT32)
		return next_float(z, up, next);
	*next = sum_add(*z, sum_of_double(up));
	return true;
}

/* Returns num[0] den[1] - num[1] den[0], the determinant of D(z) of struct depth. Its
 * sign is the sign of the slope of D. */
static struct sum depth_determinant(const struct depth *d)
{
	return sum_minor(d->num[0], d->den[1], d->num[1], d->den[0]);
}

/* Returns |D(q) - D(p)| of depths p and q times n: the determinant times n (q - p),
 * over the denominators of D, times n, at p and at q. Returns nan if p = q, or if p or
 * q is behind the eye. */
static double distance_between(const struct depth *d, double n, const struct sum *p,
    const struct sum *q)
{
	struct sum offset = sum_scale(d->den[1], n);
	struct sum at_p = sum_add(sum_mul(d->den[0], *p), offset);
	struct sum at_q = sum_add(sum_mul(d->den[0], *q), offset);
	struct sum change = sum_mul(depth_determinant(d), sum_sub(*q, *p));

	if (sum_sign(change) == 0 || sum_sign(at_p) <= 0 || sum_sign(at_q) <= 0)
		return (double)NAN;
	return sum_ratio_or_nan(sum_scale(sum_abs(change), n), sum_mul(at_p, at_q));
}

double depth_step(const struct depth *d, enum depth_buffer b, bool far)
{
	const double n = buffer_steps[b];
	struct sum from = sum_scale(sum_of_double(d->plane[far]), n), to;
	struct sum limit = sum_scale(sum_of_double(d->plane[!far]), n);
	const int up = sum_compare(limit, from);

	if (d->open || d->constant || !next_depth(&from, b, up, &to) ||
	    sum_compare(to, limit) * up > 0)
		return (double)NAN;
	return distance_between(d, n, &from, &to);
}

double depth_step_at(const struct depth *d, enum depth_buffer b, double distance)
{
	const double n = buffer_steps[b];
	const int to_eye = -sum_sign(depth_determinant(d));
	const struct sum range = sum_difference(d->plane[0], d->plane[1]);
	const bool narrow = b != DEPTH_FLOAT32 &&
	    sum_compare(sum_scale(sum_abs(range), n), sum_one) < 0;
	struct sum above, below;
	struct sum z = sum_quotient(
	    sum_scale(sum_sub(d->num[1], sum_scale(d->den[1], distance)), n),
	    sum_sub(sum_scale(d->den[0], distance), d->num[0]));

	if (d->open || d->constant || narrow || !next_depth(&z, b, 1, &above) ||
	    !next_depth(&z, b, -1, &below))
		return (double)NAN;
	if (b == DEPTH_FLOAT32) {
		const double nearest = sum_ratio_nearest(&z, &sum_one, true);

		if (sum_compare(z, sum_of_double(nearest)) != 0)
			return distance_between(d, n, &below, &above);
		if (nearest == d->plane[0])
			return depth_step(d, b, false);
	}
	return distance_between(d, n, &z, to_eye > 0 ? &above : &below);
}
