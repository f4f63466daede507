/* SPDX-License-Identifier: MIT */
#include "depth.h"

#include "../points/distance.h"

/* The depth of a point is z / w. Let z0 and w0 be z and w at the point from which the
 * distance D is measured, and dz and dw the dot products of their gradients with n, along
 * which D is measured. Then
 *
 *	depth = (z0 + D dz / |n|) / (w0 + D dw / |n|),
 *	D = |n| (w0 depth - z0) / (dz - dw depth).
 *
 * In a perspective w0 is 0. The point is homogeneous: the denominator is multiplied by
 * its last coordinate. Numerator and denominator are negated if D is then positive where
 * the denominator is or, if w is constant, if this gives the denominator its sign. */
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

	*d = (struct depth){ .low = range.min_z,
		.high = range.max_z,
		.reversed = l->reversed,
		.open = projection_is_open(&s->projection),
		.constant = s->has_viewport && !has_range };
	distance_of(s, &along);
	viewport_map(&range, scene_answer_convention(s), false, &to_range);
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

/* Writes the depth of the near or far plane. A depth is a quotient z[0] / z[1]. */
static void depth_of_plane(const struct depth *d, bool far, struct sum z[2])
{
	z[0] = sum_of_double(far != d->reversed ? d->high : d->low);
	sum_set(&z[1], 1);
}

void depth_quotient(const struct depth *d, bool far, struct sum *num, struct sum *den)
{
	struct sum z[2];

	depth_of_plane(d, far, z);
	sum_dot(2, d->num, z, 1, num);
	sum_dot(2, d->den, z, 1, den);
}

double depth_distance(const struct depth *d, bool far)
{
	struct sum num, den;

	depth_quotient(d, far, &num, &den);
	if (d->open || (sum_sign(den) < 0 && sum_sign(d->den[0]) != 0))
		return (double)NAN;
	return sum_sign(den) == 0 ? HUGE_VAL : sum_ratio_or_nan(num, den);
}

/* Returns the sign of a - b, where a and b are depths a[0] / a[1] and b[0] / b[1]. */
static int compare_depths(const struct sum a[2], const struct sum b[2])
{
	return sum_sign(sum_minor(a[0], b[1], b[0], a[1])) * sum_sign(a[1]) *
	    sum_sign(b[1]);
}

/* Finds the least float above z or, if up is -1, the greatest float below z. Returns
 * false if this float is infinite. */
static bool next_float(const struct sum z[2], int up, struct sum next[2])
{
	float f = (float)sum_ratio_nearest(&z[0], &z[1], true),
	      to = up > 0 ? HUGE_VALF : -HUGE_VALF;

	sum_set(&next[1], 1);
	if (isfinite(f))
		sum_set(&next[0], (double)f);
	if (!isfinite(f) || compare_depths(next, z) * up <= 0)
		next[0] = sum_of_double((double)(f = nextafterf(f, to)));
	return isfinite(f) != 0;
}

static bool is_float(const struct sum z[2])
{
	const struct sum f[2] = { sum_of_double(sum_ratio_nearest(&z[0], &z[1], true)),
		sum_of_double(1) };

	return compare_depths(f, z) == 0;
}

/* Finds the depth that is one step of the buffer above z or, if up is -1, below z.
 * Returns false if the next float is infinite. */
static bool next_depth(const struct sum z[2], enum depth_buffer b, int up,
    struct sum next[2])
{
	double steps = b == DEPTH_UNORM16 ? 0xffff : 0xffffff;

	if (b == DEPTH_FLOAT32)
		return next_float(z, up, next);
	sum_dot(2, z, (struct sum[]){ sum_of_double(steps), sum_of_double(up) }, 1,
	    next);
	next[1] = sum_scale(z[1], steps);
	return true;
}

/* Returns num[0] den[1] - num[1] den[0], the determinant of D(z) of struct depth. Its
 * sign is the sign of the slope of D. */
static struct sum depth_determinant(const struct depth *d)
{
	return sum_minor(d->num[0], d->den[1], d->num[1], d->den[0]);
}

/* Returns |D(b) - D(a)|: the determinant times b - a, over the denominators of D at a
 * and at b. Returns nan if a = b, or if a or b is behind the eye. */
static double distance_between(const struct depth *d, const struct sum a[2],
    const struct sum b[2])
{
	struct sum den[2],
	    difference = sum_mul(depth_determinant(d),
		sum_minor(b[0], a[1], a[0], b[1]));

	sum_dot(2, d->den, a, 1, &den[0]);
	sum_dot(2, d->den, b, 1, &den[1]);
	if (sum_sign(difference) == 0 || sum_sign(den[0]) * sum_sign(a[1]) <= 0 ||
	    sum_sign(den[1]) * sum_sign(b[1]) <= 0)
		return (double)NAN;
	return sum_ratio_or_nan(sum_abs(difference), sum_abs(sum_mul(den[0], den[1])));
}

/* Returns the distance between depth z and the next depth of the buffer above z or, if
 * up is -1, below z. Returns nan if the next depth is beyond `limit`. */
static double step_length(const struct depth *d, enum depth_buffer b,
    const struct sum z[2], int up, const struct sum limit[2])
{
	struct sum to[2];

	if (d->open || d->constant || !next_depth(z, b, up, to) ||
	    (limit != NULL && compare_depths(to, limit) * up > 0))
		return (double)NAN;
	return distance_between(d, z, to);
}

double depth_step(const struct depth *d, enum depth_buffer b, bool far)
{
	struct sum from[2], to[2];

	depth_of_plane(d, far, from);
	depth_of_plane(d, !far, to);
	return step_length(d, b, from, compare_depths(to, from), to);
}

double depth_step_at(const struct depth *d, enum depth_buffer b, double distance)
{
	const struct sum z[2] = { sum_sub(d->num[1], sum_scale(d->den[1], distance)),
		sum_sub(sum_scale(d->den[0], distance), d->num[0]) };
	const int to_eye = -sum_sign(depth_determinant(d));
	struct sum plane[2], above[2], below[2];

	if (b != DEPTH_FLOAT32)
		return step_length(d, b, z, to_eye, NULL);
	depth_of_plane(d, false, plane);
	if (d->open || d->constant || !next_float(z, 1, above) ||
	    !next_float(z, -1, below))
		return (double)NAN;
	if (!is_float(z))
		return distance_between(d, below, above);
	return compare_depths(z, plane) == 0 ?
	    depth_step(d, b, false) :
	    distance_between(d, z, to_eye > 0 ? above : below);
}
