/* SPDX-License-Identifier: MIT */
#include "window.h"

/* An exact quotient. */
struct quotient {
	ex n, d;
};

static struct quotient whole(ex a)
{
	return (struct quotient){ a, ex_of(1) };
}

/* One axis, x' = (x - from) s + to, where from or to is 0; the denominators go into
 * the map's divisor. */
static void put(struct map *r, int i, struct quotient from, struct quotient s,
    struct quotient to)
{
	r->origin[i] = ex_double(ex_quotient(from.n, from.d));
	bool back = ex_sign(to.n) != 0;
	ex d = back ? to.d : from.d;
	ex at = back ? ex_mul(to.n, s.d) : ex_neg(ex_mul(from.n, s.n));

	r->m[i][i] = sum_mul(r->divisor, sum_of(ex_mul(s.n, d)));
	r->m[3][i] = sum_mul(r->divisor, sum_of(at));
	map_column_over(r, i, sum_of(ex_mul(s.d, d)));
}

/* x' = (x - center) s + offset, or back. */
static void axis(struct map *r, int i, struct quotient center,
    struct quotient s, struct quotient offset, bool inverse)
{
	if (inverse)
		put(r, i, offset, (struct quotient){ s.d, s.n }, center);
	else
		put(r, i, center, s, offset);
}

/* From ndc, x' = x n / d + offset, or back. */
static void from_ndc(struct map *r, int i, ex n, double d, ex offset,
    bool inverse)
{
	axis(r, i, whole(ex_of(0)), (struct quotient){ n, ex_of(d) },
	    whole(offset), inverse);
}

/* Two sides and the centre, panned, as exact sums. */
static const char *shape(const struct window *w, ex size[2], ex center[2])
{
	ex pan[2] = { ex_of(w->pan[0]), ex_of(w->pan[1]) };

	if (w->by_edges) {
		if (!(w->left < w->right))
			return "/window/right: not greater than left; "
			       "a window's edges stand in order";
		if (!(w->bottom < w->top))
			return "/window/top: not greater than bottom; "
			       "a window's edges stand in order";
		size[0] = ex_diff(w->right, w->left);
		size[1] = ex_diff(w->top, w->bottom);
		center[0] = ex_scale(ex_diff(w->left, -w->right), 0.5);
		center[1] = ex_scale(ex_diff(w->bottom, -w->top), 0.5);
	} else {
		size[0] = ex_of(w->width);
		size[1] = ex_of(w->height);
		center[0] = ex_of(w->center[0]);
		center[1] = ex_of(w->center[1]);
	}
	for (int i = 0; i < 2; i++)
		center[i] = ex_add(center[i], pan[i]);
	return NULL;
}

/* Grow widens the side that is too short for the device's shape, so that all
 * that was seen is; shrink narrows the one that is too long. */
static void adapt(const struct window *w, const struct device *d,
    struct quotient size[2])
{
	ex wide = ex_scale(size[0].n, d->height);
	ex high = ex_scale(size[1].n, d->width);
	bool wider = ex_sign(ex_sub(high, wide)) > 0;

	if (wider == (w->adapt == ADAPT_GROW))
		size[0] = (struct quotient){ high, ex_of(d->height) };
	else
		size[1] = (struct quotient){ wide, ex_of(d->width) };
}

const char *window_map(const struct window *w, const struct device *d,
    bool inverse, struct map *r)
{
	ex side[2], center[2];
	const char *why = shape(w, side, center);

	if (why != NULL)
		return why;
	struct quotient size[2] = { whole(side[0]), whole(side[1]) };

	if (w->adapt != ADAPT_STRETCH) {
		if (d == NULL)
			return "/window/adapt: there is no device to adapt "
			       "to; add \"device\"";
		adapt(w, d, size);
	}
	map_identity(r);
	for (int i = 0; i < 2; i++) {
		/* about + (c - about) / zoom */
		struct quotient c = { center[i], ex_of(w->zoom) };
		ex about = w->has_about ? ex_of(w->about[i]) : center[i];
		struct quotient s = { ex_scale(size[i].d, 2 * w->zoom),
			size[i].n };

		c.n = ex_add(ex_sub(c.n, about), ex_scale(about, w->zoom));
		axis(r, i, c, s, whole(ex_of(0)), inverse);
	}
	return NULL;
}

const char *device_map(const struct device *d, bool inverse, struct map *r)
{
	ex high = ex_of(d->top_left ? -d->height : d->height);

	map_identity(r);
	from_ndc(r, 0, ex_of(d->width), 2, ex_diff(d->x, -d->width / 2),
	    inverse);
	from_ndc(r, 1, high, 2, ex_diff(d->y, -d->height / 2), inverse);
	return NULL;
}

/* Pixels to a unit of ndc; half the sides where nothing else is said. */
static void scales(const struct viewport *v, double s[2])
{
	double larger = fmax(v->width, v->height);

	s[0] = v->scale == SCALE_UNIFORM ? larger / 2 : v->width / 2;
	s[1] = v->scale == SCALE_UNIFORM ? larger / 2 : v->height / 2;
	if (v->scale == SCALE_GIVEN) {
		s[0] = v->scales[0];
		s[1] = v->scales[1];
	}
}

void viewport_limits(const struct viewport *v, struct sum half[2],
    struct sum scale[2])
{
	double s[2] = { 1, 1 };

	if (v != NULL)
		scales(v, s);
	half[0] = sum_of_double(v != NULL ? v->width / 2 : 1);
	half[1] = sum_of_double(v != NULL ? v->height / 2 : 1);
	for (int k = 0; k < 2; k++)
		scale[k] = sum_of_double(s[k]);
}

const char *viewport_map(const struct viewport *v, const struct convention *c,
    bool inverse, struct map *r)
{
	ex depth = ex_diff(v->max_z, v->min_z), min = ex_of(v->min_z);
	double s[2];

	if (inverse && ex_sign(depth) == 0)
		return "/viewport/max_z: equal to min_z; "
		       "such a depth can't be taken back";
	scales(v, s);
	if (c->ndc_y_down == c->bottom_left)
		s[1] = -s[1];
	if (c->minus_one)
		min = ex_scale(ex_diff(v->min_z, -v->max_z), 0.5);
	map_identity(r);
	from_ndc(r, 0, ex_of(s[0]), 1, ex_diff(v->x, -v->width / 2), inverse);
	from_ndc(r, 1, ex_of(s[1]), 1, ex_diff(v->y, -v->height / 2), inverse);
	from_ndc(r, 2, depth, c->minus_one ? 2 : 1, min, inverse);
	return NULL;
}
