#include "ray.h"

#include <math.h>
#include <string.h>

#include "quick.h"
#include "vec3.h"

static double over(struct sum n, struct sum d, bool single)
{
	double q = single ? (double)sum_over_float(n, d) : sum_over(n, d);

	return isfinite(q) ? q : (double)NAN;
}

/* Where clip x, y and w are 0. */
static const char *set_eye(const struct scene *s, struct ray_maker *r)
{
	struct map back;
	const char *why = scene_map(s, SPACE_CLIP, SPACE_WORLD, &back);

	for (int i = 0; i < 6 && why == NULL; i++)
		r->eye[i / 3][i % 3] = over(back.m[2][i % 3], back.m[2][3],
		    i / 3);
	return why;
}

const char *ray_maker_of(const struct scene *s, struct ray_maker *r)
{
	bool reversed = projection_is_reversed(&s->projection, &s->convention);
	const struct viewport *v = &s->viewport;

	r->depth = reversed ? v->max_z : v->min_z;
	r->against = (v->max_z > v->min_z) == reversed;
	const char *why = scene_transform(s, SPACE_DEVICE, SPACE_WORLD, false,
	    &r->to_world);

	if (why == NULL)
		why = scene_transform(s, SPACE_DEVICE, SPACE_VIEW, false,
		    &r->to_view);
	if (why == NULL)
		why = scene_transform(s, SPACE_VIEW, SPACE_WORLD, false,
		    &r->turn);
	r->from_eye = projection_is_open(&s->projection);
	if (why == NULL && r->from_eye)
		why = set_eye(s, r);
	return why;
}

/* View space is N(z) / D(z) at device depth z, and the direction the derivative's
 * numerator N' D - N D', as D^2 > 0, turned to the world: there the eye's place
 * would have to cancel. Both are computed twice, alike: in double-double, and
 * exactly where that may have rounded to the wrong side. */
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

/* Columns of the image of a device position at the near plane. */
static void set_columns(const struct ray_maker *r, const struct kernel_map *k,
    const double at[2], struct quick n[4])
{
	dd p[4] = { [3] = { 1, 0 } };

	for (int i = 0; i < 3; i++)
		p[i] = two_sum(i < 2 ? at[i] : r->depth, -k->origin[i]);
	for (int j = 0; j < 4; j++)
		n[j] = quick_column(k, j, p);
}

static bool point_is_sure(const struct ray_maker *r, const double at[2],
    double point[3])
{
	struct quick n[4];

	set_columns(r, &r->to_world.for_kernel, at, n);
	return n[3].value.hi > QUICK_BOUND * n[3].size &&
	    quick_over(n[0], n[3], &point[0]) &&
	    quick_over(n[1], n[3], &point[1]) &&
	    quick_over(n[2], n[3], &point[2]);
}

static bool direction_is_sure(const struct ray_maker *r, const double at[2],
    double direction[3])
{
	const struct kernel_map *k = &r->to_view.for_kernel;
	const struct kernel_map *turn = &r->turn.for_kernel;
	struct quick n[4], to[3] = { QUICK_ZERO, QUICK_ZERO, QUICK_ZERO };

	set_columns(r, k, at, n);
	for (int i = 0; i < 3; i++) {
		struct quick d = QUICK_ZERO;

		quick_add(&d, n[3].value, n[3].size, quick_element(k, 2, i),
		    false);
		quick_add(&d, dd_neg(n[i].value), n[i].size,
		    quick_element(k, 2, 3), false);
		if (r->against)
			d.value = dd_neg(d.value);
		for (int j = 0; j < 3; j++)
			quick_add(&to[j], d.value, d.size,
			    quick_element(turn, i, j), false);
	}
	struct quick length = length_of(to);

	return quick_over(to[0], length, &direction[0]) &&
	    quick_over(to[1], length, &direction[1]) &&
	    quick_over(to[2], length, &direction[2]);
}

static void set_direction(const struct ray_maker *r, const double in[4],
    bool single, double direction[3])
{
	const struct sum *m = r->to_view.map.m[2];
	struct sum w = point_column(&r->to_view, 3, in), d[3], to[3];

	for (int i = 0; i < 3; i++) {
		struct sum n = point_column(&r->to_view, i, in);

		d[i] = sum_sub(sum_mul(m[i], w), sum_mul(n, m[3]));
		if (r->against)
			d[i] = sum_neg(d[i]);
	}
	for (int j = 0; j < 3; j++) {
		const struct sum column[3] = { r->turn.map.m[0][j],
			r->turn.map.m[1][j], r->turn.map.m[2][j] };

		to[j] = sum_settled(vec3_dot(d, column));
	}
	struct sum length = vec3_length(to);

	for (int j = 0; j < 3; j++)
		direction[j] = over(to[j], length, single);
}

static bool begin_is_sure(const struct ray_maker *r, const double at[2],
    double point[3])
{
	if (!r->from_eye)
		return point_is_sure(r, at, point);
	memcpy(point, r->eye[false], sizeof r->eye[false]);
	return !isnan(at[0]) && !isnan(at[1]);
}

void ray_exact(const struct ray_maker *r, const double at[2], bool single,
    double point[3], double direction[3])
{
	const double in[4] = { at[0], at[1], r->depth, 1 };

	if (!single && begin_is_sure(r, at, point) &&
	    direction_is_sure(r, at, direction))
		return;
	for (int i = 0; i < 3; i++)
		point[i] = direction[i] = (double)NAN;
	if (isnan(at[0]) || isnan(at[1]))
		return;
	struct sum w = point_column(&r->to_world, 3, in);

	if (sum_sign(w) <= 0)
		return;
	for (int j = 0; j < 3; j++)
		point[j] = r->from_eye ?
		    r->eye[single][j] :
		    over(point_column(&r->to_world, j, in), w, single);
	set_direction(r, in, single, direction);
}
