/* SPDX-License-Identifier: MIT */
#include "frustum.h"

#include <math.h>

/* Replaces the function line[0] z + line[1] of ndc depth by |high - low| times the same
 * function of device depth. first is the least ndc depth, 0 or -1. */
static void depth_on_device(struct sum line[2], double first,
    const struct depth *d)
{
	struct sum range = sum_diff(d->high, d->low);
	struct sum at = sum_diff(first * d->high, d->low);
	bool falls = d->high < d->low;

	line[1] = sum_negated_if(falls,
	    sum_add(sum_mul(line[0], at), sum_mul(line[1], range)));
	line[0] = sum_negated_if(falls, sum_scale(line[0], 1 - first));
}

/* Sets D of a perspective: w / |n|, where n is the gradient of w. Clip x, y and w are 0
 * at the eye, so the eye is the inverse map's image of (0, 0, 1, 0), and clip z at the
 * eye is the product of both divisors over the fourth coordinate of that image. From the
 * eye along n, clip z is z(eye) + (gradient of z . n) D / |n|; it also equals ndc z
 * times w = |n| D, and the two together give D. */
static void set_perspective(const struct scene *s, const struct map *m,
    const struct sum z[3], const struct sum w[3], struct depth *d)
{
	struct map back;

	projection_map(&s->projection, &s->convention, true, &back);
	struct sum eye = sum_quotient(sum_mul(back.divisor, m->divisor),
	    back.m[2][3]);
	bool minus = sum_sign(eye) < 0;

	d->over[0] = sum_of_double(0);
	d->over[1] = sum_mul(vec3_length(w), sum_abs(eye));
	d->under[0] = sum_negated_if(minus, vec3_dot(w, w));
	d->under[1] = sum_negated_if(!minus, vec3_dot(w, z));
}

/* Sets D of a parallel projection: the difference of clip z from its value at the origin,
 * over the length of the gradient of z. D grows along the convention's gaze; if the
 * projection is a matrix, D grows from near to far. */
static void set_parallel(const struct scene *s, const struct map *m,
    const struct sum z[3], struct depth *d)
{
	bool behind = sum_sign(m->m[3][3]) < 0;
	bool against = s->projection.type == PROJECTION_MATRIX ?
	    d->reversed != behind :
	    sum_sign(z[2]) * (looks_back(&s->convention) ? -1 : 1) < 0;

	d->over[0] = sum_negated_if(against != behind, m->m[3][3]);
	d->over[1] = sum_negated_if(against == behind, m->m[3][2]);
	d->under[0] = sum_of_double(0);
	d->under[1] = sum_negated_if(behind, vec3_length(z));
}

void depth_of(const struct scene *s, bool reversed, struct depth *d)
{
	const struct viewport *v = &s->viewport;
	bool ranges = s->has_viewport && v->min_z != v->max_z;
	double first = s->convention.minus_one ? -1 : 0;
	struct sum w[3], z[3];
	struct map m;

	/* can't fail, as the scene's maps are invertible */
	projection_map(&s->projection, &s->convention, false, &m);
	for (int i = 0; i < 3; i++) {
		w[i] = m.m[i][3];
		z[i] = m.m[i][2];
	}
	d->low = ranges ? v->min_z : 0;
	d->high = ranges ? v->max_z : 1;
	d->reversed = reversed;
	d->open = projection_is_open(&s->projection);
	d->flat = s->has_viewport && !ranges;
	if (vec3_is_zero(w))
		set_parallel(s, &m, z, d);
	else
		set_perspective(s, &m, z, w, d);
	depth_on_device(d->over, first, d);
	depth_on_device(d->under, first, d);
}

/* A depth n / d. */
struct depth_value {
	struct sum n, d;
};

/* Returns d times line[0] z + line[1] at the depth z = n / d. */
static struct sum depth_line_at(const struct sum line[2],
    const struct depth_value *z)
{
	return sum_add(sum_mul(line[0], z->n), sum_mul(line[1], z->d));
}

static struct depth_value depth_of_plane(const struct depth *d, bool far)
{
	return (struct depth_value){ sum_of_double(
					 far != d->reversed ? d->high : d->low),
		sum_of_double(1) };
}

void depth_quotient(const struct depth *d, bool far, struct sum *over,
    struct sum *under)
{
	struct depth_value z = depth_of_plane(d, far);

	*over = depth_line_at(d->over, &z);
	*under = depth_line_at(d->under, &z);
}

double depth_distance(const struct depth *d, bool far)
{
	struct sum over, under;

	depth_quotient(d, far, &over, &under);
	if (d->open || (sum_sign(under) < 0 && sum_sign(d->under[0]) != 0))
		return (double)NAN;
	return sum_sign(under) == 0 ? HUGE_VAL : sum_ratio_or_nan(over, under);
}

/* Returns the sign of a - b. */
static int compare_depths(const struct depth_value *a,
    const struct depth_value *b)
{
	return sum_sign(sum_minor(a->n, b->d, b->n, a->d)) * sum_sign(a->d) *
	    sum_sign(b->d);
}

/* Finds the least float above z or the greatest below z. Returns false if that is
 * infinite. */
static bool next_float(const struct depth_value *z, int up,
    struct depth_value *next)
{
	float f = (float)sum_nearest(&z->n, &z->d, true),
	      to = up > 0 ? HUGE_VALF : -HUGE_VALF;

	next->d = sum_of_double(1);
	if (isfinite(f))
		next->n = sum_of_double((double)f);
	if (!isfinite(f) || compare_depths(next, z) * up <= 0)
		next->n = sum_of_double((double)(f = nextafterf(f, to)));
	return isfinite(f) != 0;
}

/* Finds the depth one step of the buffer above or below z. Returns false if there is no
 * such depth. */
static bool next_depth(const struct depth_value *z, enum buffer b, int up,
    struct depth_value *next)
{
	double most = b == BUFFER_UNORM16 ? 0xffff : 0xffffff;

	if (b == BUFFER_FLOAT32)
		return next_float(z, up, next);
	*next = (struct depth_value){ sum_add(sum_scale(z->n, most),
					  sum_scale(z->d, up)),
		sum_scale(z->d, most) };
	return true;
}

/* Returns the determinant of D(z) = (over[0] z + over[1]) / (under[0] z + under[1]). Its
 * sign is the sign of the slope of D. */
static struct sum determinant(const struct depth *d)
{
	return sum_minor(d->over[0], d->under[1], d->over[1], d->under[0]);
}

/* Returns |D(b) - D(a)|: the determinant times the difference of the depths, over both
 * denominators. Returns nan if the difference is 0 or a depth is behind the eye. */
static double distance_between(const struct depth *d,
    const struct depth_value *a, const struct depth_value *b)
{
	struct sum under[2] = { depth_line_at(d->under, a),
		depth_line_at(d->under, b) };
	struct sum difference = sum_mul(determinant(d),
	    sum_minor(b->n, a->d, a->n, b->d));

	if (sum_sign(difference) == 0 ||
	    sum_sign(under[0]) * sum_sign(a->d) <= 0 ||
	    sum_sign(under[1]) * sum_sign(b->d) <= 0)
		return (double)NAN;
	return sum_ratio_or_nan(sum_abs(difference),
	    sum_abs(sum_mul(under[0], under[1])));
}

/* Returns the distance between depth z and the next depth of the buffer above or below z:
 * nan if that depth is beyond the limit. */
static double step_from(const struct depth *d, enum buffer b,
    const struct depth_value *z, int up, const struct depth_value *limit)
{
	struct depth_value to;

	if (d->open || d->flat || !next_depth(z, b, up, &to) ||
	    (limit != NULL && compare_depths(&to, limit) * up > 0))
		return (double)NAN;
	return distance_between(d, z, &to);
}

double depth_step(const struct depth *d, enum buffer b, bool far)
{
	struct depth_value from = depth_of_plane(d, far),
			   to = depth_of_plane(d, !far);

	return step_from(d, b, &from, compare_depths(&to, &from), &to);
}

double depth_step_at(const struct depth *d, enum buffer b, double at)
{
	struct depth_value z = { sum_sub(d->over[1],
				     sum_scale(d->under[1], at)),
		sum_sub(sum_scale(d->under[0], at), d->over[0]) };

	return step_from(d, b, &z, -sum_sign(determinant(d)), NULL);
}
