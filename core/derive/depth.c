/* SPDX-License-Identifier: MIT */
#include "picture.h"

/* Let n be the gradient of w or, if w is constant, of z. At the distance D along n from
 * the eye or, if w is constant, from the origin, z and w are z0 + D z . n / |n| and w0
 * + D w . n / |n|, with the gradients z and w. Depth is the quotient of both, which
 * gives D by depth. At the eye w0 is 0, as x and y are. over and under change their
 * signs if this makes the denominator positive in front of the eye. D of a parallel
 * projection grows along the convention's gaze; that of a matrix from near to far. */
void depth_of(const struct lens *l, struct depth *d)
{
	const struct scene *s = l->scene;
	const struct viewport *v = &s->viewport;
	bool ranges = s->has_viewport && v->min_z != v->max_z;
	bool behind = sum_sign(l->clip[3][3]) < 0, against_n = false;
	struct viewport range = { .width = 2, .height = 2, .max_z = 1 };
	const struct sum *eye_z = l->volume.eye_z;
	struct sum z[4], w[4];
	struct map m = l->volume.clip, to_range;

	if (ranges) {
		range.min_z = v->min_z;
		range.max_z = v->max_z;
	}
	*d = (struct depth){ .low = range.min_z,
		.high = range.max_z,
		.reversed = l->reversed,
		.open = projection_is_open(&s->projection),
		.flat = s->has_viewport && !ranges };
	viewport_map(&range, answer_convention(s), false, &to_range);
	map_multiply(&m, &to_range, false);
	for (int i = 0; i < 4; i++) {
		z[i] = m.m[i][2];
		w[i] = m.m[i][3];
	}
	const struct sum *n = l->parallel ? z : w;
	struct sum size = vec3_length(n);

	if (!l->parallel) {
		w[3] = sum_of_double(0);
		z[3] = sum_quotient(sum_mul(eye_z[0], to_range.m[2][2]),
		    eye_z[1]);
	} else if (s->projection.type == PROJECTION_MATRIX) {
		against_n = l->reversed != behind;
	} else {
		against_n = looks_back(answer_convention(s)) !=
		    (sum_sign(l->clip[2][2]) < 0);
	}
	against_n ^= l->parallel && d->high < d->low;
	bool minus = l->parallel ? !behind : sum_sign(z[3]) < 0;

	d->over[0] = sum_negated_if(minus == against_n, sum_mul(size, w[3]));
	d->over[1] = sum_negated_if(minus != against_n, sum_mul(size, z[3]));
	d->under[0] = sum_negated_if(minus, vec3_dot(w, n));
	d->under[1] = sum_negated_if(!minus, vec3_dot(z, n));
}

/* A depth nd[0] / nd[1]. */
struct depth_value {
	struct sum nd[2];
};

static struct depth_value depth_of_plane(const struct depth *d, bool far)
{
	return (struct depth_value){
		{ sum_of_double(far != d->reversed ? d->high : d->low),
		    sum_of_double(1) }
	};
}

void depth_quotient(const struct depth *d, bool far, struct sum *over,
    struct sum *under)
{
	struct depth_value z = depth_of_plane(d, far);

	sum_dot(2, d->over, z.nd, 1, over);
	sum_dot(2, d->under, z.nd, 1, under);
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
	return sum_sign(sum_minor(a->nd[0], b->nd[1], b->nd[0], a->nd[1])) *
	    sum_sign(a->nd[1]) * sum_sign(b->nd[1]);
}

/* Finds the least float above z or, if up is -1, the greatest below z. Returns false if
 * this float is infinite. */
static bool next_float(const struct depth_value *z, int up,
    struct depth_value *next)
{
	float f = (float)sum_nearest(&z->nd[0], &z->nd[1], true),
	      to = up > 0 ? HUGE_VALF : -HUGE_VALF;

	next->nd[1] = sum_of_double(1);
	if (isfinite(f))
		next->nd[0] = sum_of_double((double)f);
	if (!isfinite(f) || compare_depths(next, z) * up <= 0)
		next->nd[0] = sum_of_double((double)(f = nextafterf(f, to)));
	return isfinite(f) != 0;
}

/* Finds the depth one step of the buffer above z or, if up is -1, below z. Returns
 * false if there is no such depth. */
static bool next_depth(const struct depth_value *z, enum buffer b, int up,
    struct depth_value *next)
{
	double most = b == BUFFER_UNORM16 ? 0xffff : 0xffffff;

	if (b == BUFFER_FLOAT32)
		return next_float(z, up, next);
	sum_dot(2, z->nd,
	    (struct sum[]){ sum_of_double(most), sum_of_double(up) }, 1,
	    &next->nd[0]);
	next->nd[1] = sum_scale(z->nd[1], most);
	return true;
}

/* Returns the determinant of D(z) = (over[0] z + over[1]) / (under[0] z + under[1]).
 * Its sign is the sign of the slope of D. */
static struct sum determinant(const struct depth *d)
{
	return sum_minor(d->over[0], d->under[1], d->over[1], d->under[0]);
}

/* Returns |D(b) - D(a)|: the determinant times the difference of the depths, over both
 * denominators. Returns nan if the difference is 0 or a depth is behind the eye. */
static double distance_between(const struct depth *d,
    const struct depth_value *a, const struct depth_value *b)
{
	struct sum under[2],
	    difference = sum_mul(determinant(d),
		sum_minor(b->nd[0], a->nd[1], a->nd[0], b->nd[1]));

	sum_dot(2, d->under, a->nd, 1, &under[0]);
	sum_dot(2, d->under, b->nd, 1, &under[1]);
	if (sum_sign(difference) == 0 ||
	    sum_sign(under[0]) * sum_sign(a->nd[1]) <= 0 ||
	    sum_sign(under[1]) * sum_sign(b->nd[1]) <= 0)
		return (double)NAN;
	return sum_ratio_or_nan(sum_abs(difference),
	    sum_abs(sum_mul(under[0], under[1])));
}

/* Returns the distance between depth z and the next depth of the buffer above or below
 * z, or nan if the next depth is beyond the limit. */
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
	struct depth_value z = {
		{ sum_sub(d->over[1], sum_scale(d->under[1], at)),
		    sum_sub(sum_scale(d->under[0], at), d->over[0]) }
	};

	return step_from(d, b, &z, -sum_sign(determinant(d)), NULL);
}
