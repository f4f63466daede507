/* SPDX-License-Identifier: MIT */
#include "ray.h"

#include <string.h>

#include "../points/kernel/midway.h"
#include "../points/point.h"
#include "../points/points.h"

/* Divides a map by a power of two so that the largest element is about 1: the kernel
 * squares vectors, whose lengths do not matter. */
static void scale_to_one(struct map *r)
{
	int most = -EX_RANGE;

	for (int i = 0; i < 16; i++) {
		const int e = ex_exponent(&r->m[i / 4][i % 4].value);

		most = e > most ? e : most;
	}
	sum_set(&r->divisor, 1);
	map_divide(r, sum_of_power(most));
}

/* Makes the map from device x and y to a vector along the ray. Its points are P / P_w,
 * where P is the sum of q_i m_i, with q = (x, y, z, 1) and the rows m_i of the map to
 * view space. As z grows, they move along
 *
 *	m_2 P_w - P m_2w = sum of q_i d_i,    d_i = m_2 m_iw - m_i m_2w
 *
 * where d_2 is 0. The vector is negated if it does not point from near to far. Errors
 * of the camera do not enter the differences: only then d_i is taken to world space. */
static bool set_direction_map(const struct scene *s, bool depth_falls, struct map *r,
    struct refusals *faults)
{
	struct map m;
	struct sum d[4][3] = { 0 };

	if (!scene_map_factor(s, SPACE_DEVICE, SPACE_VIEW, &m, faults))
		return false;
	for (int i = 0; i < 12; i++)
		d[i / 3][i % 3] = sum_negated_if(depth_falls,
		    sum_minor(m.m[2][i % 3], m.m[i / 3][3], m.m[i / 3][i % 3],
			m.m[2][3]));
	if (!scene_map(s, SPACE_VIEW, SPACE_WORLD, &m, faults))
		return false;
	memset(r->m, 0, sizeof r->m);
	for (int i = 0; i < 12; i++)
		if (i / 3 != 2)
			sum_dot(3, d[i / 3], &m.m[0][i % 3], 4, &r->m[i / 3][i % 3]);
	scale_to_one(r);
	return true;
}

/* Makes every ray begin at the eye, where clip x, y and w are 0. scene_map cannot fail:
 * the caller has made the map from the device, which contains the map from clip. */
static void start_at_eye(const struct scene *s, struct transform *t)
{
	struct sum(*m)[4] = t->map.m;

	scene_map(s, SPACE_CLIP, SPACE_WORLD, &t->map, NULL);
	for (int j = 0; j < 4; j++)
		m[3][j] = sum_negated_if(sum_sign(m[2][3]) < 0, m[2][j]);
	memset(m, 0, 3 * sizeof *m);
	map_set_origin(&t->map, NULL);
	transform_init(t, SPACE_DEVICE, SPACE_WORLD, false);
}

bool ray_maker_of(const struct scene *s, struct ray_maker *r, struct refusals *faults)
{
	bool reversed = projection_is_reversed(&s->projection, &s->convention);
	const struct viewport *v = &s->viewport;
	/* device depth falls from near to far */
	bool depth_falls = (v->max_z > v->min_z) == reversed;

	if (!transform_of_scene(s, SPACE_DEVICE, SPACE_WORLD, false, &r->to_world,
		faults) ||
	    !set_direction_map(s, depth_falls, &r->direction.map, faults))
		return false;
	map_set_origin(&r->direction.map,
	    (double[3]){ r->to_world.map.origin[0], r->to_world.map.origin[1] });
	if (projection_is_open(&s->projection))
		start_at_eye(s, &r->to_world);
	r->depth = reversed ? v->max_z : v->min_z;
	r->direction.in = 2;
	transform_prepare(&r->direction);
	return !ex_has_overflowed() || scene_refuse_too_wide(s, false, faults);
}

static void ray_direction(const struct ray_maker *r, const double in[4], bool single,
    double *const direction[3], size_t i)
{
	struct sum to[3];

	for (int j = 0; j < 3; j++)
		to[j] = sum_snap_zero(point_column(&r->direction, j, in));
	struct sum length = vec3_length(to);

	for (int j = 0; j < 3; j++) {
		double q = sum_ratio_nearest(&to[j], &length, single);

		direction[j][i] = isfinite(q) ? q : (double)NAN;
	}
}

static void round_to_floats(const struct ray_maker *r, const double in[4],
    double *const point[3], double *const direction[3], size_t i)
{
	bool midway = false;

	for (int j = 0; j < 3; j++) {
		float p = point_exact_float(&r->to_world, in, j, point[j][i]);

		point[j][i] = isfinite(p) ? (double)p : (double)NAN;
		midway |= is_midway(direction[j][i]);
	}
	if (midway)
		ray_direction(r, in, true, direction, i);
	for (int j = 0; j < 3; j++)
		direction[j][i] = (double)(float)direction[j][i];
}

/* Completes ray i, which a kernel left undecided. If all of its point is nan, there is
 * a ray only if w is positive: its point is then beyond the range of doubles. */
static void ray_finish(const struct ray_maker *r, const double in[4], bool single,
    double *const point[3], double *const direction[3], size_t i)
{
	if (isnan(point[0][i]) && isnan(point[1][i]) && isnan(point[2][i]) &&
	    (isnan(in[0]) || isnan(in[1]) ||
		sum_sign(point_column(&r->to_world, 3, in)) <= 0)) {
		for (int j = 0; j < 3; j++)
			direction[j][i] = (double)NAN;
		return;
	}
	if (isnan(direction[0][i]))
		ray_direction(r, in, false, direction, i);
	if (single)
		round_to_floats(r, in, point, direction, i);
}

bool rays_cast(const struct ray_maker *r, bool single, const double *const at[2],
    double *const point[3], double *const direction[3], size_t n)
{
	double depth[POINTS_BLOCK];
	const double *const in[4] = { at[0], at[1], depth };
	double *const out[4] = { point[0], point[1], point[2] };

	for (size_t i = 0; i < POINTS_BLOCK; i++)
		depth[i] = r->depth;
	const bool finite = points_map(&r->to_world, PRECISION_EXACT, in, out, n);

	if (kernels_chosen()->exact[KERNEL_DIRECTION](&r->direction.for_kernel, at,
		direction, n) &&
	    finite && !single)
		return true;
	for (size_t i = 0; i < n; i++)
		if (single || isnan(point[0][i]) || isnan(direction[0][i]))
			ray_finish(r, (double[4]){ at[0][i], at[1][i], r->depth, 1 },
			    single, point, direction, i);
	return false;
}

/* Writes row i of the map r from q = (x, y, z, 1) to the point where the ray through x
 * and y meets the plane p. m_i are the rows of m, the map from device or ndc space. m
 * takes q to P = sum of q_i m_i, which is on the plane if p . P = 0. This equation is
 * linear in z = q_2:
 *
 *	z = -sum of q_i (m_i . p) / (m_2 . p),    i = 0, 1, 3
 *
 * So P = sum of q_i (m_i - m_2 (m_i . p) / (m_2 . p)). Row i of r is the factor of q_i
 * times m_2 . p. In column j of the row, the terms of p_j cancel. Row 4 follows in the
 * same way from m_4, the origin's image: the origin's z, times m_2, cancels. */
static void set_plane_row(const struct map *m, int i, const struct sum p[4],
    struct map *r)
{
	const struct sum *a = m->m[i], *b = m->m[2];

	for (int j = 0; j < 4; j++) {
		struct sum minor[4] = { 0 };

		for (int k = 0; k < 4; k++)
			if (k != j)
				minor[k] = sum_minor(a[j], b[k], b[j], a[k]);
		sum_dot(4, p, minor, 1, &r->m[i][j]);
	}
}

/* Row m_2 of the map m is the homogeneous point that all rays share: the eye or, if the
 * rays are parallel, their direction. The plane must not contain this point. */
bool ray_plane_transform(const struct scene *s, enum space from, enum space to,
    const double plane[4], struct transform *t, struct refusals *faults)
{
	struct sum p[4], m2_p;
	struct map m, *r = &t->map;

	if (!scene_map(s, from, to, &m, faults))
		return false;
	for (int k = 0; k < 4; k++)
		sum_set(&p[k], plane[k]);
	sum_dot(4, m.m[2], p, 1, &m2_p);
	if (sum_sign(m2_p) == 0)
		return refuse(faults, NULL,
		    sum_sign(m.m[2][3]) == 0 ? "the plane is parallel to all rays" :
					       "the plane goes through the eye",
		    "choose another");
	memset(r, 0, sizeof *r);
	sum_set(&r->divisor, 1);
	memcpy(r->origin, m.origin, 2 * sizeof *m.origin);
	for (int i = 0; i < 5; i++)
		if (i != 2)
			set_plane_row(&m, i, p, r);
	bool turned = sum_sign(m.m[3][3]) < 0; /* w is constant and negative */

	for (int i = 0; i < 3; i++)
		turned &= sum_sign(m.m[i][3]) == 0;
	m2_p = sum_negated_if(turned, m2_p);
	map_divide(r, sum_mul(m2_p, m.divisor));
	t->in = 2;
	t->out = 3;
	t->divide = t->front = true;
	t->reciprocal = false;
	t->kernel = KERNEL_PROJECTIVE;
	transform_prepare(t);
	if (ex_has_overflowed())
		return refuse(faults, NULL, SCENE_TOO_WIDE, SCENE_TOO_WIDE_REMEDY);
	return map_is_finite(r) ||
	    refuse(faults, NULL,
		"the plane is too near to the eye, or the scene too large, for the "
		"range of doubles",
		NULL);
}
