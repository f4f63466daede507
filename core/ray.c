#include "ray.h"

#include <math.h>

#include "quick.h"
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
 * numerator N' D - N D', as D^2 > 0. Both are computed twice, alike: in
 * double-double, and exactly where that may have rounded to the wrong side. */
static struct quick length_of(const struct quick to[3])
{
	dd square = { 0, 0 };
	double size = 0;

	for (int j = 0; j < 3; j++) {
		square = dd_add(square, dd_mul(to[j].value, to[j].value));
		size += to[j].size * fabs(to[j].value.hi);
	}
	double s = sqrt(square.hi);
	dd rest = dd_add(square, dd_neg(two_prod(s, s)));

	return (struct quick){ fast_two_sum(s, rest.hi / (2 * s)), size / s,
		false };
}

static bool ray_quick(const struct ray_maker *r, const double at[2],
    double point[3], double direction[3])
{
	const struct kernel_map *k = &r->back.for_kernel;
	struct quick n[4], to[3] = { QUICK_ZERO, QUICK_ZERO, QUICK_ZERO };
	dd p[4] = { [3] = { 1, 0 } };
	bool sure = true;

	for (int i = 0; i < 3; i++)
		p[i] = two_sum(i < 2 ? at[i] : r->depth, -k->origin[i]);
	for (int j = 0; j < 4; j++)
		n[j] = quick_column(k, j, p);
	if (!(n[3].value.hi > QUICK_BOUND * n[3].size))
		return false;
	for (int j = 0; j < 3; j++) {
		quick_add(&to[j], n[3].value, n[3].size, quick_element(k, 2, j),
		    false);
		quick_add(&to[j], dd_neg(n[j].value), n[j].size,
		    quick_element(k, 2, 3), false);
		if (r->against)
			to[j].value = dd_neg(to[j].value);
	}
	struct quick length = length_of(to);

	for (int j = 0; j < 3; j++)
		sure = sure && quick_over(n[j], n[3], &point[j]) &&
		    quick_over(to[j], length, &direction[j]);
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
