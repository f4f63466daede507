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
	if (!scene_map_factor(s, view, screen, &to_screen, faults) ||
	    !frustum_planes(s, view, &m, &ends, faults))
		return false;
	set_planes(&m, &ends, flat, &c, r);
	find_rectangle(&to_screen, &c, r);
	return !ex_has_overflowed() ||
	    refuse(faults, "/bounds", SCENE_TOO_WIDE, SCENE_TOO_WIDE_REMEDY);
}
