/* SPDX-License-Identifier: MIT */
#include "depth.h"

#include <math.h>

#include "../exact/vec3.h"

/* A perspective's distance is w over the length of the gradient of w, where 1/w is
 * (c2 z + c3) / det by the inverse's last column, on the axis through the device's
 * middle. A parallel projection's is that of clip z, along the convention's gaze or, of
 * a matrix, from near to far. */
void depth_of(const struct scene *s, bool reversed, struct depth *d)
{
	struct sum w[3], z[3];
	struct map m;

	/* whose reasons the scene has not, as it is not degenerate */
	projection_map(&s->projection, &s->convention, false, &m);
	for (int i = 0; i < 3; i++) {
		w[i] = m.m[i][3];
		z[i] = m.m[i][2];
	}
	d->first = s->convention.minus_one ? -1 : 0;
	d->reversed = reversed;
	d->open = projection_is_open(&s->projection);
	if (!vec3_is_zero(w)) {
		struct sum det = map_minor(4, m.m, 0, 0);
		struct sum length = sum_negated_if(sum_sign(det) < 0,
		    vec3_length(w));

		d->over[0] = sum_of_double(0);
		d->over[1] = sum_abs(det);
		d->under[0] = sum_neg(sum_mul(length, map_minor(3, m.m, 8, 4)));
		d->under[1] = sum_mul(length, map_minor(3, m.m, 8, 8));
		return;
	}
	bool behind = sum_sign(m.m[3][3]) < 0;
	bool against = s->projection.type == PROJECTION_MATRIX ?
	    reversed != behind :
	    sum_sign(z[2]) * (looks_back(&s->convention) ? -1 : 1) < 0;

	d->over[0] = sum_negated_if(against != behind, m.m[3][3]);
	d->over[1] = sum_negated_if(against == behind, m.m[3][2]);
	d->under[0] = sum_of_double(0);
	d->under[1] = sum_negated_if(behind, vec3_length(z));
}

/* A depth, as an exact quotient. */
struct at {
	struct sum n, d;
};

static struct sum at_depth(const struct sum line[2], const struct at *z)
{
	return sum_add(sum_mul(line[0], z->n), sum_mul(line[1], z->d));
}

static struct at plane(const struct depth *d, bool far)
{
	return (struct at){ sum_of_double(far != d->reversed ? 1 : d->first),
		sum_of_double(1) };
}

void depth_quotient(const struct depth *d, bool far, struct sum *over,
    struct sum *under)
{
	struct at z = plane(d, far);

	*over = at_depth(d->over, &z);
	*under = at_depth(d->under, &z);
}

double depth_distance(const struct depth *d, bool far)
{
	struct sum over, under;

	depth_quotient(d, far, &over, &under);
	if (d->open || sum_sign(under) < 0)
		return (double)NAN;
	return sum_sign(under) == 0 ? HUGE_VAL : sum_over_or_nan(over, under);
}

/* The viewport's depth, from ndc's. */
static struct at on_device(const struct depth *d, const struct viewport *v,
    const struct at *z)
{
	struct sum range = sum_of_double(1 - d->first);
	struct sum share = sum_sub(z->n, sum_scale(z->d, d->first));

	return (
	    struct at){ sum_add(sum_mul(sum_diff(v->max_z, v->min_z), share),
			    sum_mul(sum_scale(z->d, v->min_z), range)),
		sum_mul(z->d, range) };
}

/* And back. */
static struct at on_ndc(const struct depth *d, const struct viewport *v,
    const struct at *z)
{
	struct sum range = sum_diff(v->max_z, v->min_z);
	struct sum share = sum_sub(z->n, sum_scale(z->d, v->min_z));

	return (struct at){ sum_add(sum_scale(share, 1 - d->first),
				sum_mul(sum_scale(z->d, d->first), range)),
		sum_mul(z->d, range) };
}

static int compare_depths(const struct at *a, const struct at *b)
{
	return sum_sign(sum_minor(a->n, b->d, b->n, a->d)) * sum_sign(a->d) *
	    sum_sign(b->d);
}

/* The next float above or below z, strictly. False where there is none. */
static bool next_float(const struct at *z, int up, struct at *next)
{
	float f = sum_over_float(z->n, z->d),
	      to = up > 0 ? HUGE_VALF : -HUGE_VALF;

	next->d = sum_of_double(1);
	if (isfinite(f))
		next->n = sum_of_double((double)f);
	if (!isfinite(f) || compare_depths(next, z) * up <= 0)
		next->n = sum_of_double((double)(f = nextafterf(f, to)));
	return isfinite(f) != 0;
}

/* The depth a step above or below z, on the device. */
static bool next_depth(const struct at *z, enum buffer b, int up,
    struct at *next)
{
	double most = b == BUFFER_UNORM16 ? 0xffff : 0xffffff;

	if (b == BUFFER_FLOAT32)
		return next_float(z, up, next);
	*next = (struct at){ sum_add(sum_scale(z->n, most),
				 sum_scale(z->d, up)),
		sum_scale(z->d, most) };
	return true;
}

/* How far it is from one ndc depth to another; nan where that is nothing. */
static double between(const struct depth *d, const struct at *a,
    const struct at *b)
{
	struct sum under[2] = { at_depth(d->under, a), at_depth(d->under, b) };
	struct sum way = sum_minor(at_depth(d->over, b), under[0],
	    at_depth(d->over, a), under[1]);

	if (sum_sign(way) == 0 || sum_sign(under[0]) * sum_sign(a->d) <= 0 ||
	    sum_sign(under[1]) * sum_sign(b->d) <= 0)
		return (double)NAN;
	return sum_over_or_nan(sum_abs(way),
	    sum_abs(sum_mul(under[0], under[1])));
}

/* From ndc depth z a step up or down in ndc, to the limit at most. */
static double step_from(const struct depth *d, const struct viewport *v,
    enum buffer b, const struct at *z, int up, const struct at *limit)
{
	static const struct viewport whole = { .max_z = 1 };
	const struct viewport *view = v != NULL ? v : &whole;
	struct at from = on_device(d, view, z), to;
	int deeper = (view->max_z > view->min_z) - (view->max_z < view->min_z);

	if (d->open || deeper == 0 || !next_depth(&from, b, up * deeper, &to))
		return (double)NAN;
	to = on_ndc(d, view, &to);
	if (limit != NULL && compare_depths(&to, limit) * up > 0)
		return (double)NAN;
	return between(d, z, &to);
}

double depth_step(const struct depth *d, const struct viewport *v,
    enum buffer b, bool far)
{
	struct at from = plane(d, far), to = plane(d, !far);

	return step_from(d, v, b, &from, far != d->reversed ? -1 : 1, &to);
}

double depth_step_at(const struct depth *d, const struct viewport *v,
    enum buffer b, double at)
{
	struct at z = { sum_sub(d->over[1], sum_scale(d->under[1], at)),
		sum_sub(sum_scale(d->under[0], at), d->over[0]) };
	struct sum det = sum_minor(d->over[0], d->under[1], d->over[1],
	    d->under[0]);

	return step_from(d, v, b, &z, -sum_sign(det), NULL);
}
