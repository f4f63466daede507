#include "window.h"

/* An exact quotient. */
struct quotient {
	ex n, d;
};

static struct quotient whole(ex a)
{
	return (struct quotient){ a, ex_of(1) };
}

static dd rounded(struct quotient q)
{
	return ex_div(q.n, q.d);
}

/* Sets an element to a - b c. */
static void set(struct map *r, int row, int i, dd a, dd b, dd c)
{
	ex p = ex_mul(ex_dd(b), ex_dd(c));

	r->m[row][i] = ex_round(ex_sub(ex_dd(a), p));
	r->sum[row][i] = fabs(a.hi) + fabs(b.hi * c.hi);
}

/* One axis, x' = (x - from) s + to, or with from and to exchanged its inverse.
 * The origin is from, rounded; its exact remainder goes into the origin's
 * image, so that a narrow window far from zero keeps its digits. */
static void put(struct map *r, int i, struct quotient from, dd s,
    struct quotient to)
{
	double origin = rounded(from).hi;
	struct quotient rest = from;

	rest.n = ex_sub(from.n, ex_scale(from.d, origin));
	r->origin[i] = origin;
	r->m[i][i] = s;
	r->sum[i][i] = fabs(s.hi);
	set(r, AT_ORIGIN, i, rounded(to), rounded(rest), s);
	set(r, AT_ZERO, i, rounded(to), rounded(from), s);
}

/* scale / over forth, over / scale back. */
static void axis(struct map *r, int i, struct quotient center, ex scale,
    ex over, struct quotient offset, bool inverse)
{
	if (inverse)
		put(r, i, offset, ex_div(over, scale), center);
	else
		put(r, i, center, ex_div(scale, over), offset);
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
	int sign = (ex_round(ex_sub(high, wide)).hi > 0) ? 1 : -1;
	/* the device is wider than the window: grow takes x, shrink y */
	bool x = (w->adapt == ADAPT_GROW) == (sign > 0);

	if (x)
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
	*r = map_identity;
	for (int i = 0; i < 2; i++) {
		/* about + (c - about) / zoom */
		struct quotient c = { center[i], ex_of(w->zoom) };
		ex about = w->has_about ? ex_of(w->about[i]) : center[i];

		c.n = ex_add(ex_sub(c.n, about), ex_scale(about, w->zoom));
		axis(r, i, c, ex_scale(size[i].d, 2 * w->zoom), size[i].n,
		    whole(ex_of(0)), inverse);
	}
	return map_is_finite(r) ? NULL :
	    "/window: its matrix has elements beyond the range of doubles; "
	    "bring the sizes nearer to one another";
}

const char *device_map(const struct device *d, bool inverse, struct map *r)
{
	double sign = d->top_left ? -1 : 1;

	*r = map_identity;
	axis(r, 0, whole(ex_of(0)), ex_of(d->width), ex_of(2),
	    whole(ex_diff(d->x, -d->width / 2)), inverse);
	axis(r, 1, whole(ex_of(0)), ex_of(sign * d->height), ex_of(2),
	    whole(ex_diff(d->y, -d->height / 2)), inverse);
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

void viewport_limits(const struct viewport *v, dd limit[2])
{
	double s[2];

	scales(v, s);
	limit[0] = ex_div(ex_of(v->width / 2), ex_of(s[0]));
	limit[1] = ex_div(ex_of(v->height / 2), ex_of(s[1]));
}

const char *viewport_map(const struct viewport *v, const struct convention *c,
    bool inverse, struct map *r)
{
	ex depth = ex_diff(v->max_z, v->min_z), min = ex_of(v->min_z);
	double s[2];

	if (inverse && depth.n == 0)
		return "/viewport/max_z: equal to min_z; "
		       "such a depth can't be taken back";
	scales(v, s);
	if (c->ndc_y_down == c->bottom_left)
		s[1] = -s[1];
	*r = map_identity;
	axis(r, 0, whole(ex_of(0)), ex_of(s[0]), ex_of(1),
	    whole(ex_diff(v->x, -v->width / 2)), inverse);
	axis(r, 1, whole(ex_of(0)), ex_of(s[1]), ex_of(1),
	    whole(ex_diff(v->y, -v->height / 2)), inverse);
	if (c->minus_one)
		min = ex_scale(ex_diff(v->min_z, -v->max_z), 0.5);
	axis(r, 2, whole(ex_of(0)), depth, ex_of(c->minus_one ? 2 : 1),
	    whole(min), inverse);
	return NULL;
}
