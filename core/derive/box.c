/* SPDX-License-Identifier: MIT */
#include "box.h"

#include <math.h>

#include "clip.h"

/* The corners of a box. Along an edge one bit of the index changes. */
struct corners {
	int n;
	struct sum at[8][4]; /* homogeneous, in view space or in the 2D window */
	/* the function of the near plane, not negative beyond it; 1 in a window */
	struct sum near[8];
};

static bool set_corners(const struct bounds *b, bool flat, const struct map *m,
    struct corners *c, struct refusals *faults)
{
	const int dimensions = flat ? 2 : 3;
	struct hull h;

	if (!hull_of(b, dimensions, &h, faults))
		return false;
	c->n = 1 << dimensions;
	for (int k = 0; k < c->n; k++) {
		struct sum p[4];

		sum_set(&p[3], 1);
		for (int i = 0; i < 3; i++) {
			const double radius = i < dimensions ? h.radius : 0;

			p[i] = sum_difference(h.point[k % h.n][i],
			    k >> i & 1 ? -radius : radius);
		}
		for (int j = 0; j < 4; j++)
			map_image(m, j, p, &c->at[k][j]);
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

/* Sets the distances. distance_of refuses nothing, as the map to clip is known. */
static void set_distances(const struct scene *s, const struct corners *c,
    double distance[2])
{
	struct distance d;
	struct sum v, length;

	distance_of(s, &d, NULL);
	for (int k = 0; k < c->n; k++) {
		sum_dot(4, c->at[k], d.column, 1, &v);
		length = sum_mul(d.length, c->at[k][3]);
		widen(&distance[0], &distance[1], &v, &length);
	}
	for (int i = 0; i < 2; i++)
		if (isinf(distance[i]))
			distance[i] = (double)NAN;
}

/* Sets what depends on the planes in `sides` and, unless flat, `ends`. */
static void set_planes(const struct map *sides, const struct map *ends, bool flat,
    struct corners *c, struct box *r)
{
	unsigned some = 0, all = ~0u;

	for (int k = 0; k < c->n; k++) {
		unsigned out = 0;

		for (int i = 0; i < (flat ? 4 : 7); i++) {
			struct sum v;

			map_image(i < 4 ? sides : ends, i % 4, c->at[k], &v);
			if (sum_sign(v) < (1 << i == OUT_BEHIND))
				out |= 1u << i;
			if (1 << i == OUT_NEAR)
				sum_copy(&c->near[k], &v);
		}
		if (flat)
			sum_set(&c->near[k], 1);
		some |= out;
		all &= out;
	}
	r->behind = (all & OUT_BEHIND) != 0;
	r->out = (all & ~(unsigned)OUT_BEHIND) != 0;
	r->outside = some & ~(unsigned)OUT_BEHIND;
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

/* Finds the rectangle. The corners of the part beyond the near plane are those of
 * the box there, and the points where the plane cuts an edge. These are found in
 * view space, as the differences of images would lose what the errors of sines
 * and cosines hide. */
static void find_rectangle(const struct map *to_screen, const struct corners *c,
    struct box *r)
{
	bool reaches_eye = false;

	for (int a = 0; a < c->n; a++) {
		const struct sum *p = c->at[a], *near = &c->near[a];
		const int sign = sum_sign(*near);

		reaches_eye |= sign >= 0 && take_point(to_screen, p, r);
		for (int bit = 1; bit < c->n; bit *= 2) {
			const struct sum *q = c->at[a | bit], *far = &c->near[a | bit];
			struct sum cut[4];

			if ((a & bit) != 0 || sign * sum_sign(*far) >= 0)
				continue;
			clip_cut(4, p, near, q, far, cut);
			reaches_eye |= take_point(to_screen, cut, r);
		}
	}
	for (int k = 0; k < 2 && reaches_eye; k++)
		r->min[k] = r->max[k] = (double)NAN;
}

/* A sphere: its centre, and how a step by the radius along x, y and z of model space
 * moves it, all homogeneous, in view space. So of a linear function the value v at the
 * centre, and its slopes along the steps, whose length is g, give v - g and v + g as
 * the least and the greatest value on the sphere, or ellipsoid. */
struct ball {
	struct sum center[4], step[3][4];
};

static void set_ball(const struct bounds *b, const struct map *m, struct ball *s)
{
	struct sum p[4] = { [3] = sum_one };

	for (int i = 0; i < 3; i++)
		sum_set(&p[i], b->center[i]);
	for (int j = 0; j < 4; j++) {
		map_image(m, j, p, &s->center[j]);
		for (int i = 0; i < 3; i++)
			s->step[i][j] = sum_scale(m->m[i][j], b->radius);
	}
}

/* Sets the slopes of a linear function, whose coefficients are `stride` apart. */
static void ball_slopes(const struct ball *s, const struct sum *column, int stride,
    struct sum slope[3])
{
	for (int i = 0; i < 3; i++)
		sum_dot(4, s->step[i], column, stride, &slope[i]);
}

/* Replaces distances and planes of the corners by those of the sphere. Returns whether
 * the sphere lies beyond the near plane, if there is one, and in front of the eye. */
static bool set_ball_planes(const struct scene *s, const struct ball *ball,
    const struct map *sides, const struct map *ends, struct box *r)
{
	struct sum slope[3], v;
	unsigned some = 0, all = 0;
	struct distance d;

	for (int i = 0; i < 7; i++) {
		const struct map *m = i < 4 ? sides : ends;

		map_image(m, i % 4, ball->center, &v);
		ball_slopes(ball, &m->m[0][i % 4], 4, slope);
		const struct sum reach = vec3_length(slope);
		const int limit = 1 << i == OUT_BEHIND;

		some |= (unsigned)(sum_sign(sum_sub(v, reach)) < limit) << i;
		all |= (unsigned)(sum_sign(sum_add(v, reach)) < limit) << i;
	}
	r->behind = (all & OUT_BEHIND) != 0;
	r->out = (all & ~(unsigned)OUT_BEHIND) != 0;
	r->outside = some & ~(unsigned)OUT_BEHIND;
	distance_of(s, &d, NULL);
	sum_dot(4, ball->center, d.column, 1, &v);
	ball_slopes(ball, d.column, 1, slope);
	const struct sum reach = vec3_length(slope);
	const struct sum length = sum_mul(d.length, ball->center[3]);

	r->distance[0] = sum_ratio_or_nan(sum_sub(v, reach), length);
	r->distance[1] = sum_ratio_or_nan(sum_add(v, reach), length);
	return (some & (OUT_NEAR | OUT_BEHIND)) == 0;
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
static void find_ball_rectangle(const struct map *to_screen, const struct ball *ball,
    struct box *r)
{
	struct sum w, b[3], x, a[3], h[3], across[3];

	for (int j = 0; j < 2; j++) {
		map_image(to_screen, 3, ball->center, &w);
		ball_slopes(ball, &to_screen->m[0][3], 4, b);
		map_image(to_screen, j, ball->center, &x);
		ball_slopes(ball, &to_screen->m[0][j], 4, a);
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
	struct corners c;
	struct map m, ends, to_clip, to_screen;
	struct ball ball;
	const bool is_ball = b->sphere && b->n == 0 && !flat;

	for (int k = 0; k < 2; k++)
		r->distance[k] = r->min[k] = r->max[k] = (double)NAN;
	if (!scene_map_factor(s, model, view, &m, faults) ||
	    !set_corners(b, flat, &m, &c, faults) ||
	    (!flat && !scene_map_factor(s, SPACE_VIEW, SPACE_CLIP, &to_clip, faults)))
		return false;
	if (!flat) {
		s->known[SPACE_VIEW][false] = &to_clip;
		set_distances(s, &c, r->distance);
	}
	if (is_ball)
		set_ball(b, &m, &ball);
	if (!scene_map_factor(s, view, screen, &to_screen, faults) ||
	    !frustum_planes(s, view, &m, &ends, faults))
		return false;
	set_planes(&m, &ends, flat, &c, r);
	if (is_ball && set_ball_planes(s, &ball, &m, &ends, r))
		find_ball_rectangle(&to_screen, &ball, r);
	else
		find_rectangle(&to_screen, &c, r);
	return !ex_has_overflowed() ||
	    refuse(faults, "/bounds", SCENE_TOO_WIDE, SCENE_TOO_WIDE_REMEDY);
}
