#include "ray.h"

#include <math.h>

#include "vec3.h"

const char *ray_maker_of(const struct scene *s, struct ray_maker *r)
{
	bool reversed = projection_is_reversed(&s->projection, &s->convention);
	const struct viewport *v = &s->viewport;

	r->depth = reversed ? v->max_z : v->min_z;
	r->against = (v->max_z > v->min_z) == reversed;
	return scene_transform(s, SPACE_DEVICE, SPACE_WORLD, false, &r->back);
}

/* The world is N(z) / D(z) at device depth z, and the direction the derivative's
 * numerator N' D - N D', as D^2 > 0. Both are computed twice, alike: here in
 * double-double, below exactly, where that may have rounded to the wrong side.
 *
 * Off they are, in units of u^2 of the sum of the products' magnitudes, size, by
 * at most as much (`make prove` counts it): an element by 1/2, a product by 6 more,
 * each sum by 4: N and D by 18.5, the direction by 31. A quotient is off by the
 * relative errors of both and by 9 of its own, a length by those of its elements
 * and by 16 of its own. All is within 128 (size/|n| + size/|d|), each of which is
 * at least 1. */
#define RAY_BOUND 0x1p-99

/* A sum of products, and of their magnitudes. */
struct dd_sum {
	dd value;
	double size;
};

/* A size is 0 only where all products are. */
static void add(struct dd_sum *s, dd a, double size, dd b)
{
	s->value = dd_add(s->value, dd_mul(a, b));
	if (size > 0 && fabs(b.hi) > 0)
		s->size += size * fabs(b.hi) + 0x1p-1022;
}

static dd element(const struct kernel_map *k, int i, int j)
{
	return (dd){ k->hi[i][j], k->lo[i][j] };
}

static struct dd_sum length_of(const struct dd_sum to[3])
{
	dd square = { 0, 0 };
	double size = 0;

	for (int j = 0; j < 3; j++) {
		square = dd_add(square, dd_mul(to[j].value, to[j].value));
		size += to[j].size * fabs(to[j].value.hi);
	}
	double s = sqrt(square.hi);
	dd rest = dd_add(square, dd_neg(two_prod(s, s)));

	return (struct dd_sum){ fast_two_sum(s, rest.hi / (2 * s)), size / s };
}

/* Rounds n / d; false where its error may turn the rounding, or anything comes
 * near the end of the range. */
static bool round_quick(struct dd_sum n, struct dd_sum d, double *q)
{
	double size = fabs(n.value.hi), divisor = fabs(d.value.hi);
	dd v = dd_div(n.value, d.value);
	double error = RAY_BOUND * (n.size + fabs(v.hi) * d.size) / divisor;

	*q = v.hi;
	if (!(divisor > 0x1p-450 && divisor < 0x1p450 &&
		divisor > RAY_BOUND * d.size))
		return false;
	if (n.size == 0)
		return true;
	return size > 0x1p-450 && size < 0x1p450 && fabs(v.hi) > 0x1p-450 &&
	    v.hi + (v.lo - error) == v.hi && v.hi + (v.lo + error) == v.hi;
}

static bool ray_quick(const struct ray_maker *r, const double at[2],
    double point[3], double direction[3])
{
	const struct kernel_map *k = &r->back.for_kernel;
	struct dd_sum n[4] = { 0 }, to[3] = { 0 };
	dd p[4] = { 0 };
	bool sure = true;

	for (int i = 0; i < 3; i++)
		p[i] = two_sum(i < 2 ? at[i] : r->depth, -k->origin[i]);
	p[3].hi = 1;
	for (int j = 0; j < 4; j++)
		for (int i = 0; i < 4; i++)
			add(&n[j], p[i], fabs(p[i].hi), element(k, i, j));
	if (!(n[3].value.hi > 0))
		return false;
	for (int j = 0; j < 3; j++) {
		add(&to[j], n[3].value, n[3].size, element(k, 2, j));
		add(&to[j], dd_neg(n[j].value), n[j].size, element(k, 2, 3));
		if (r->against)
			to[j].value = dd_neg(to[j].value);
	}
	struct dd_sum length = length_of(to);

	for (int j = 0; j < 3; j++)
		sure = sure && round_quick(n[j], n[3], &point[j]) &&
		    round_quick(to[j], length, &direction[j]);
	return sure;
}

static double over(struct sum n, struct sum d, bool single)
{
	double q = single ? (double)sum_over_float(n, d) : sum_over(n, d);

	return isfinite(q) ? q : (double)NAN;
}

void ray_exact(const struct ray_maker *r, const double at[2], bool single,
    double point[3], double direction[3])
{
	const double in[4] = { at[0], at[1], r->depth, 1 };
	const struct sum *m = r->back.map.m[2];
	struct sum n[4], to[3];

	if (!single && ray_quick(r, at, point, direction))
		return;
	for (int i = 0; i < 3; i++)
		point[i] = direction[i] = (double)NAN;
	if (isnan(at[0]) || isnan(at[1]))
		return;
	for (int j = 0; j < 4; j++)
		n[j] = point_column(&r->back, j, in);
	if (sum_sign(n[3]) <= 0)
		return;
	for (int j = 0; j < 3; j++) {
		to[j] = sum_settled(
		    sum_sub(sum_mul(m[j], n[3]), sum_mul(n[j], m[3])));
		if (r->against)
			to[j] = sum_neg(to[j]);
	}
	struct sum length = vec3_length(to);

	for (int j = 0; j < 3; j++) {
		point[j] = over(n[j], n[3], single);
		direction[j] = over(to[j], length, single);
	}
}
