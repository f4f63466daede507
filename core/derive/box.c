/* SPDX-License-Identifier: MIT */
#include "box.h"

#include <math.h>

#include "clip.h"

/* The hull of corners, along whose edges one bit of the index changes; or a sphere in
 * it: its centre, and how a step by the radius along x, y and z of model space moves
 * it. All points are homogeneous, in view space or in the 2D window. */
struct body {
	int n; /* corners */
	struct sum corner[8][4];
	bool is_ball;
	struct sum center[4], step[3][4];
};

static bool set_corners(const struct bounds *b, bool flat, const struct map *m,
    struct body *r, struct refusals *faults)
{
	const int dimensions = flat ? 2 : 3;
	struct hull h;

	if (!hull_of(b, dimensions, &h, faults))
		return false;
	r->n = 1 << dimensions;
	for (int k = 0; k < r->n; k++) {
		struct sum p[4];

		sum_set(&p[3], 1);
		for (int i = 0; i < 3; i++) {
			const double radius = i < dimensions ? h.radius : 0;

			p[i] = sum_difference(h.point[k % h.n][i],
			    k >> i & 1 ? -radius : radius);
		}
		for (int j = 0; j < 4; j++)
			map_image(m, j, p, &r->corner[k][j]);
	}
	return true;
}

/* Widens a range to hold n / d. It is nan, which fmin and fmax ignore, while empty. */
static void widen(double *min, double *max, const struct sum *n, const struct sum *d)
{
	const double v = sum_ratio(*n, *d);

	*min = fmin(*min, v);
	*max = fmax(*max, v);
}

/* Sets the slopes along the steps of column j of m. If v is the value at the centre,
 * and g the slopes' length, v - g and v + g are the least and the greatest value on the
 * sphere, or ellipsoid. */
static void ball_slopes(const struct body *b, const struct map *m, int j,
    struct sum slope[3])
{
	for (int i = 0; i < 3; i++)
		sum_dot(4, b->step[i], &m->m[0][j], 4, &slope[i]);
}

/* Finds the least and the greatest value on a body of column j of m. */
static void find_range(const struct body *b, const struct map *m, int j,
    struct sum *least, struct sum *most)
{
	struct sum slope[3], v;

	if (b->is_ball) {
		map_image(m, j, b->center, &v);
		ball_slopes(b, m, j, slope);
		const struct sum reach = vec3_length(slope);

		*least = sum_sub(v, reach);
		*most = sum_add(v, reach);
		return;
	}
	for (int k = 0; k < b->n; k++) {
		map_image(m, j, b->corner[k], &v);
		if (k == 0 || sum_compare(v, *least) < 0)
			sum_copy(least, &v);
		if (k == 0 || sum_compare(v, *most) > 0)
			sum_copy(most, &v);
	}
}

/* Sets the distances. distance_of refuses nothing, as the map to clip is known. */
static void set_distances(const struct scene *s, const struct body *b,
    double distance[2])
{
	struct distance d;
	struct map along;
	struct sum least, most;

	distance_of(s, &d, NULL);
	map_identity(&along);
	for (int i = 0; i < 4; i++)
		sum_copy(&along.m[i][0], &d.column[i]);
	map_set_origin(&along, NULL);
	find_range(b, &along, 0, &least, &most);
	const struct sum length = sum_mul(d.length, b->corner[0][3]);

	distance[0] = sum_ratio_or_nan(least, length);
	distance[1] = sum_ratio_or_nan(most, length);
}

/* Sets what depends on the planes in `sides` and, unless flat, `ends`. Returns whether
 * all is beyond the near plane, if there is one, and in front of the eye. */
static bool set_planes(const struct map *sides, const struct map *ends, bool flat,
    const struct body *b, struct box *r)
{
	unsigned some = 0, all = 0;
	struct sum least, most;

	for (int i = 0; i < (flat ? 4 : 7); i++) {
		const int limit = 1 << i == OUT_BEHIND;

		find_range(b, i < 4 ? sides : ends, i % 4, &least, &most);
		some |= (unsigned)(sum_sign(least) < limit) << i;
		all |= (unsigned)(sum_sign(most) < limit) << i;
	}
	r->behind = (all & OUT_BEHIND) != 0;
	r->out = (all & ~(unsigned)OUT_BEHIND) != 0;
	r->outside = some & ~(unsigned)OUT_BEHIND;
	return (some & (OUT_NEAR | OUT_BEHIND)) == 0;
}

/* Widens the rectangle to hold the image of a point. Returns whether w <= 0. */
static bool take_point(const struct map *to_screen, const struct sum at[4],
    struct box *r)
{
	struct sum v, w;

	map_image(to_screen, 3, at, &w);
	if (sum_sign(w) <= 0)
		return true;
	for (int k = 0; k < 2; k++) {
		map_image(to_screen, k, at, &v);
		widen(&r->min[k], &r->max[k], &v, &w);
	}
	return false;
}

/* Finds the rectangle. The corners of the part beyond the near plane, which is in
 * `ends`, are those of the box there, and the points where the plane cuts an edge.
 * These are found in view space, as the differences of images would lose what the
 * errors of sines and cosines hide. A window has no near plane: `ends` is NULL. */
static void find_rectangle(const struct map *to_screen, const struct map *ends,
    const struct body *b, struct box *r)
{
	bool reaches_eye = false;
	struct sum near[8], cut[4];

	for (int a = 0; a < b->n; a++) {
		sum_set(&near[a], 1);
		if (ends != NULL)
			map_image(ends, 0, b->corner[a], &near[a]);
		reaches_eye |= sum_sign(near[a]) >= 0 &&
		    take_point(to_screen, b->corner[a], r);
		for (int bit = 1; bit <= a; bit *= 2) {
			const int from = a & ~bit;

			if (from == a || sum_sign(near[from]) * sum_sign(near[a]) >= 0)
				continue;
			clip_cut(4, b->corner[from], &near[from], b->corner[a],
			    &near[a], cut);
			reaches_eye |= take_point(to_screen, cut, r);
		}
	}
	for (int k = 0; k < 2 && reaches_eye; k++)
		r->min[k] = r->max[k] = (double)NAN;
}

static void set_ball(const struct bounds *b, const struct map *m, struct body *r)
{
	struct sum p[4] = { [3] = sum_one };

	for (int i = 0; i < 3; i++)
		sum_set(&p[i], b->center[i]);
	for (int j = 0; j < 4; j++) {
		map_image(m, j, p, &r->center[j]);
		for (int i = 0; i < 3; i++)
			r->step[i][j] = sum_scale(m->m[i][j], b->radius);
	}
}

/* Returns whether six products of such numbers could exceed EX_WORDS. */
static bool has_many_digits(const struct sum v[3])
{
	return v[0].value.n > 12 || v[1].value.n > 12 || v[2].value.n > 12;
}

/* Finds the rectangle of a sphere's image from its dual conic C = M Q M', of which the
 * lines x = t are tangents: t = (C13 +- sqrt(C13^2 - C11 C33)) / C33. Let X and W be x
 * and w at the centre, a and b their slopes, and H = W a - X b. Then, without the
 * cancellation of a small sphere,
 *
 *	t = (X (W^2 - b^2) - H b +- sqrt(W^2 H^2 - (H x b)^2)) / (W (W^2 - b^2)),
 *
 * where W > |b| as the sphere is in front of the eye. If the elements have many digits,
 * they are divided by W first, which costs an error of 2^-698 but keeps products
 * short. */
static void find_ball_rectangle(const struct map *to_screen, const struct body *ball,
    struct box *r)
{
	struct sum w, b[3], x, a[3], h[3], across[3];

	for (int j = 0; j < 2; j++) {
		map_image(to_screen, 3, ball->center, &w);
		ball_slopes(ball, to_screen, 3, b);
		map_image(to_screen, j, ball->center, &x);
		ball_slopes(ball, to_screen, j, a);
		if (has_many_digits(a) || has_many_digits(b) || w.value.n > 12) {
			for (int i = 0; i < 3; i++) {
				a[i] = sum_quotient(a[i], w);
				b[i] = sum_quotient(b[i], w);
			}
			x = sum_quotient(x, w);
			sum_set(&w, 1);
		}
		for (int i = 0; i < 3; i++)
			h[i] = sum_minor(w, a[i], x, b[i]);
		vec3_cross(h, b, across);
		const struct sum ww = sum_mul(w, w);
		const struct sum rest = sum_sub(ww, vec3_dot(b, b));
		const struct sum middle = sum_sub(sum_mul(x, rest), vec3_dot(h, b));
		const struct sum square = sum_minor(ww, vec3_dot(h, h), sum_one,
		    vec3_dot(across, across));
		const struct sum reach = sum_sqrt(sum_snap_zero(square));
		const struct sum den = sum_mul(w, rest);

		r->min[j] = sum_ratio(sum_sub(middle, reach), den);
		r->max[j] = sum_ratio(sum_add(middle, reach), den);
	}
}

bool box_of(const struct scene *given, const struct bounds *b, bool flat, struct box *r,
    struct refusals *faults)
{
	struct scene scene = *given, *s = &scene;
	const enum space model = flat ? FLAT_WINDOW : SPACE_MODEL,
			 view = flat ? FLAT_WINDOW : SPACE_VIEW,
			 screen = flat ? (s->has_device ? FLAT_DEVICE : FLAT_NDC) :
	    s->has_viewport            ? SPACE_DEVICE :
					 SPACE_NDC;
	struct body body = { .is_ball = b->sphere && b->n == 0 && !flat };
	struct map m, ends, to_clip, to_screen;

	for (int k = 0; k < 2; k++)
		r->distance[k] = r->min[k] = r->max[k] = (double)NAN;
	if (!scene_map_factor(s, model, view, &m, faults) ||
	    !set_corners(b, flat, &m, &body, faults) ||
	    (!flat && !scene_map_factor(s, SPACE_VIEW, SPACE_CLIP, &to_clip, faults)))
		return false;
	if (body.is_ball)
		set_ball(b, &m, &body);
	if (!flat) {
		s->known[SPACE_VIEW][false] = &to_clip;
		set_distances(s, &body, r->distance);
	}
	if (!scene_map_factor(s, view, screen, &to_screen, faults) ||
	    !frustum_planes(s, view, &m, &ends, faults))
		return false;
	if (set_planes(&m, &ends, flat, &body, r) && body.is_ball)
		find_ball_rectangle(&to_screen, &body, r);
	else
		find_rectangle(&to_screen, flat ? NULL : &ends, &body, r);
	return !ex_has_overflowed() ||
	    refuse(faults, "/bounds", SCENE_TOO_WIDE, SCENE_TOO_WIDE_REMEDY);
}
