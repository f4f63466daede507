/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include <string.h>

/* Makes the map from view space to x, y, device depth or depth from 0 to 1, and w. */
static void depth_map(const struct lens *l, const struct depth *d,
    struct map *m)
{
	struct viewport v = { .width = 2,
		.height = 2,
		.min_z = d->low,
		.max_z = d->high };
	struct map stage;

	viewport_map(&v, answer_convention(l->scene), false, &stage);
	*m = l->volume.clip;
	map_append(m, &stage, false);
}

/* Let n be the gradient of w or, if w is constant, of z, and h the eye or, if w is
 * constant, the origin. At the distance D from h along n, z and w times h[3] |n| are |n| z
 * . h + h[3] D z . n and |n| w . h + h[3] D w . n. Depth is their quotient, which gives D
 * by depth. w . h is 0 by definition at the eye. All four elements change their signs
 * where that makes the denominator positive in front of the eye. D of a parallel
 * projection grows along the convention's gaze; if the projection is a matrix, D grows
 * from near to far. */
void depth_of(const struct lens *l, struct depth *d)
{
	const struct scene *s = l->scene;
	const struct viewport *v = &s->viewport;
	bool ranges = s->has_viewport && v->min_z != v->max_z;
	bool behind = sum_sign(l->clip[3][3]) < 0, against = false;
	struct sum h[4] = { [3] = sum_of_double(1) }, z[4], w[4], size;
	struct map m;

	*d = (struct depth){ .low = ranges ? v->min_z : 0,
		.high = ranges ? v->max_z : 1,
		.reversed = l->reversed,
		.open = projection_is_open(&s->projection),
		.flat = s->has_viewport && !ranges };
	depth_map(l, d, &m);
	if (!l->parallel)
		memcpy(h, l->volume.eye, sizeof h);
	else if (s->projection.type == PROJECTION_MATRIX)
		against = l->reversed != behind;
	else
		against = looks_back(answer_convention(s)) !=
		    (sum_sign(l->clip[2][2]) < 0);
	against ^= l->parallel && d->high < d->low;
	for (int i = 0; i < 4; i++) {
		z[i] = m.m[i][2];
		w[i] = m.m[i][3];
	}
	const struct sum *n = l->parallel ? z : w;

	size = vec3_length(n);
	map_image(&m, 2, h, &d->over[1]);
	bool minus = l->parallel ? !behind : sum_sign(d->over[1]) < 0;

	d->over[0] = sum_negated_if(minus == against,
	    l->parallel ? sum_mul(size, w[3]) : sum_of_double(0));
	d->over[1] = sum_negated_if(minus != against,
	    sum_mul(size, d->over[1]));
	d->under[0] = sum_negated_if(minus, sum_mul(h[3], vec3_dot(w, n)));
	d->under[1] = sum_negated_if(!minus, sum_mul(h[3], vec3_dot(z, n)));
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
