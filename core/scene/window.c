/* SPDX-License-Identifier: MIT */
#include "window.h"

/* An exact quotient. */
struct quotient {
	struct sum n, d;
};

static struct quotient quotient_of(struct sum a)
{
	return (struct quotient){ a, sum_of_double(1) };
}

/* One axis, x' = (x - from) s + to, where from or to is 0; the denominators go into
 * the map's divisor. */
static void window_put(struct map *r, int i, struct quotient from,
    struct quotient s, struct quotient to)
{
	r->origin[i] = sum_over(from.n, from.d);
	bool back = sum_sign(to.n) != 0;
	struct sum d = back ? to.d : from.d;
	struct sum at = back ? sum_mul(to.n, s.d) :
			       sum_neg(sum_mul(from.n, s.n));

	r->m[i][i] = sum_mul(r->divisor, sum_mul(s.n, d));
	r->m[3][i] = sum_mul(r->divisor, at);
	map_column_over(r, i, sum_mul(s.d, d));
}

/* x' = (x - center) s + offset, or back. */
static void window_axis(struct map *r, int i, struct quotient center,
    struct quotient s, struct quotient offset, bool inverse)
{
	if (inverse)
		window_put(r, i, offset, (struct quotient){ s.d, s.n }, center);
	else
		window_put(r, i, center, s, offset);
}

/* From ndc, x' = x n / d + offset, or back. */
static void from_ndc(struct map *r, int i, struct sum n, double d,
    struct sum offset, bool inverse)
{
	window_axis(r, i, quotient_of(sum_of_double(0)),
	    (struct quotient){ n, sum_of_double(d) }, quotient_of(offset),
	    inverse);
}

/* Two sides and the centre, panned, as exact sums. */
static const char *shape(const struct window *w, struct sum size[2],
    struct sum center[2])
{
	struct sum pan[2] = { sum_of_double(w->pan[0]),
		sum_of_double(w->pan[1]) };

	if (w->by_edges) {
		if (!(w->left < w->right))
			return "/window/right: not greater than left; "
			       "a window's edges stand in order";
		if (!(w->bottom < w->top))
			return "/window/top: not greater than bottom; "
			       "a window's edges stand in order";
		size[0] = sum_diff(w->right, w->left);
		size[1] = sum_diff(w->top, w->bottom);
		center[0] = sum_scale(sum_diff(w->left, -w->right), 0.5);
		center[1] = sum_scale(sum_diff(w->bottom, -w->top), 0.5);
	} else {
		size[0] = sum_of_double(w->width);
		size[1] = sum_of_double(w->height);
		center[0] = sum_of_double(w->center[0]);
		center[1] = sum_of_double(w->center[1]);
	}
	for (int i = 0; i < 2; i++)
		center[i] = sum_add(center[i], pan[i]);
	return NULL;
}

/* Grow widens the side that is too short for the device's shape, so that all
 * that was seen is; shrink narrows the one that is too long. */
static void adapt(const struct window *w, const struct device *d,
    struct quotient size[2])
{
	struct sum wide = sum_scale(size[0].n, d->height);
	struct sum high = sum_scale(size[1].n, d->width);
	bool wider = sum_sign(sum_sub(high, wide)) > 0;

	if (wider == (w->adapt == ADAPT_GROW))
		size[0] = (struct quotient){ high, sum_of_double(d->height) };
	else
		size[1] = (struct quotient){ wide, sum_of_double(d->width) };
}

const char *window_map(const struct window *w, const struct device *d,
    bool inverse, struct map *r)
{
	struct sum side[2], center[2];
	const char *why = shape(w, side, center);

	if (why != NULL)
		return why;
	struct quotient size[2] = { quotient_of(side[0]),
		quotient_of(side[1]) };

	if (w->adapt != ADAPT_STRETCH) {
		if (d == NULL)
			return "/window/adapt: there is no device to adapt "
			       "to; add \"device\"";
		adapt(w, d, size);
	}
	map_identity(r);
	for (int i = 0; i < 2; i++) {
		/* about + (c - about) / zoom */
		struct quotient c = { center[i], sum_of_double(w->zoom) };
		struct sum about = w->has_about ? sum_of_double(w->about[i]) :
						  center[i];
		struct quotient s = { sum_scale(size[i].d, 2 * w->zoom),
			size[i].n };

		c.n = sum_add(sum_sub(c.n, about), sum_scale(about, w->zoom));
		window_axis(r, i, c, s, quotient_of(sum_of_double(0)), inverse);
	}
	return NULL;
}

const char *device_map(const struct device *d, bool inverse, struct map *r)
{
	struct sum high = sum_of_double(d->top_left ? -d->height : d->height);

	map_identity(r);
	from_ndc(r, 0, sum_of_double(d->width), 2,
	    sum_diff(d->x, -d->width / 2), inverse);
	from_ndc(r, 1, high, 2, sum_diff(d->y, -d->height / 2), inverse);
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
	struct sum depth = sum_diff(v->max_z, v->min_z),
		   min = sum_of_double(v->min_z);
	double s[2];

	if (inverse && sum_sign(depth) == 0)
		return "/viewport/max_z: equal to min_z; "
		       "such a depth can't be taken back";
	scales(v, s);
	if (c->ndc_y_down == c->bottom_left)
		s[1] = -s[1];
	if (c->minus_one)
		min = sum_scale(sum_diff(v->min_z, -v->max_z), 0.5);
	map_identity(r);
	from_ndc(r, 0, sum_of_double(s[0]), 1, sum_diff(v->x, -v->width / 2),
	    inverse);
	from_ndc(r, 1, sum_of_double(s[1]), 1, sum_diff(v->y, -v->height / 2),
	    inverse);
	from_ndc(r, 2, depth, c->minus_one ? 2 : 1, min, inverse);
	return NULL;
}
