/* SPDX-License-Identifier: MIT */
#include "window.h"

/* Sets coordinate i of a map to x' = (x n + t) / d or, if inverse, to (x d - t) / n.
 * The denominator becomes a factor of the map's divisor. */
static void window_axis(struct map *r, int i, struct sum n, struct sum t, struct sum d,
    bool inverse)
{
	r->m[i][i] = sum_mul(r->divisor, inverse ? d : n);
	r->m[3][i] = sum_mul(r->divisor, sum_negated_if(inverse, t));
	map_divide_column(r, i, inverse ? n : d);
}

/* Sets coordinate i of a map from ndc to x' = x n / d + offset, or its inverse. */
static void ndc_axis(struct map *r, int i, struct sum n, double d, struct sum offset,
    bool inverse)
{
	window_axis(r, i, n, sum_scale(offset, d), sum_of_double(d), inverse);
	r->origin[i] = inverse ? sum_double(offset) : 0;
}

bool window_check(const struct window *w, bool has_device, struct refusals *faults)
{
	bool is_right = true;

	if (w->by_edges && w->left == w->right)
		is_right = refuse(faults, "/window/right", "equal to left",
		    "the edges must differ");
	if (w->by_edges && w->bottom == w->top)
		is_right = refuse(faults, "/window/top", "equal to bottom",
		    "the edges must differ");
	if (w->adapt != ADAPT_STRETCH && !has_device)
		is_right = refuse(faults, "/window/adapt",
		    "there is no device to adapt to", "add \"device\"");
	return is_right;
}

/* Sets the magnitudes of the sides, the centre, and whether the axes are mirrored. */
static void window_shape(const struct window *w, struct sum size[2],
    struct sum center[2], bool mirrors[2])
{
	const double low[2] = { w->left, w->bottom };
	const double high[2] = { w->right, w->top };

	sum_set(&size[0], w->width);
	sum_set(&size[1], w->height);
	for (int i = 0; i < 2; i++) {
		sum_set(&center[i], w->center[i]);
		mirrors[i] = w->by_edges ? high[i] < low[i] : i == 1 && w->y_down;
		if (w->by_edges) {
			size[i] = sum_abs(sum_difference(high[i], low[i]));
			center[i] = sum_scale(sum_difference(low[i], -high[i]), 0.5);
		}
		center[i] = sum_add(center[i], sum_of_double(w->pan[i]));
	}
}

/* Gives the window the device's aspect. The new size is size / divisor. */
static void window_adapt(const struct window *w, const struct device *d,
    struct sum size[2], double divisor[2])
{
	struct sum wide = sum_scale(size[0], d->height);
	struct sum high = sum_scale(size[1], d->width);
	int side = (sum_compare(high, wide) > 0) != (w->adapt == ADAPT_GROW);

	size[side] = side == 0 ? high : wide;
	divisor[side] = side == 0 ? d->height : d->width;
}

bool window_map(const struct window *w, const struct device *d, bool inverse,
    struct map *r, struct refusals *faults)
{
	struct sum size[2], center[2];
	double divisor[2] = { 1, 1 }, origin[3] = { 0 };
	bool mirrors[2];

	if (!window_check(w, d != NULL, faults))
		return false;
	window_shape(w, size, center, mirrors);
	if (w->adapt != ADAPT_STRETCH)
		window_adapt(w, d, size, divisor);
	map_identity(r);
	for (int i = 0; i < 2; i++) {
		/* c / zoom is the centre after zoom, about + (center - about) / zoom */
		struct sum about = w->has_about ? sum_of_double(w->about[i]) :
						  center[i];
		struct sum c = sum_add(sum_sub(center[i], about),
		    sum_scale(about, w->zoom));
		struct sum n = sum_scale(sum_of_double(2 * divisor[i]), w->zoom);

		window_axis(r, i, sum_scale(n, w->zoom), sum_neg(sum_mul(c, n)),
		    sum_scale(size[i], w->zoom), inverse);
		r->m[i][i] = sum_negated_if(mirrors[i], r->m[i][i]);
		r->m[3][i] = sum_negated_if(mirrors[i] && !inverse, r->m[3][i]);
		origin[i] = sum_ratio(c, sum_of_double(w->zoom));
	}
	map_set_origin(r, inverse ? NULL : origin);
	return true;
}

void viewport_limits(const struct viewport *v, double half[2], double scale[2])
{
	half[0] = v->width / 2;
	half[1] = v->height / 2;
	for (int k = 0; k < 2; k++)
		scale[k] = v->scale == SCALE_GIVEN ? v->scales[k] :
		    v->scale == SCALE_UNIFORM      ? fmax(half[0], half[1]) :
						     half[k];
}

void viewport_full(const struct viewport *v, double full[2])
{
	full[0] = v->has_full ? v->full[0] : v->width;
	full[1] = v->has_full ? v->full[1] : v->height;
}

/* Returns whether device y falls as y of ndc grows. */
static bool falls(const struct convention *c)
{
	return c->ndc_y_down == c->origin_bottom_left;
}

/* The point x of ndc is at full (x + 1) / 2 in the full picture, and at size (x' + 1) /
 * 2 + offset in the part, both counted from the origin's corner: x' = (x full + full -
 * 2 offset - size) / size. If device y falls, y and y' are negated. */
void viewport_part(const struct viewport *v, const struct convention *c, bool inverse,
    struct map *r)
{
	const double size[2] = { v->width, v->height };
	double full[2];
	struct map part;

	if (!viewport_is_part(v))
		return;
	viewport_full(v, full);
	map_identity(&part);
	for (int k = 0; k < 2; k++) {
		const double offset = v->has_offset ? v->offset[k] : 0;
		const struct sum off = sum_add(sum_difference(full[k], size[k]),
		    sum_of_double(-2 * offset));

		window_axis(&part, k, sum_of_double(full[k]),
		    sum_negated_if(k == 1 && falls(c), off), sum_of_double(size[k]),
		    inverse);
	}
	map_set_origin(&part, NULL);
	map_multiply(r, &part, inverse);
}

bool viewport_check(const struct viewport *v, bool inverse, struct refusals *faults)
{
	return !inverse || v->max_z != v->min_z ||
	    refuse(faults, "/viewport/max_z", "equal to min_z",
		"depth can't be inverted then");
}

bool viewport_map(const struct viewport *v, const struct convention *c, bool inverse,
    struct map *r, struct refusals *faults)
{
	struct sum depth = sum_difference(v->max_z, v->min_z),
		   min = sum_of_double(v->min_z);
	double half[2], scale[2];

	if (!viewport_check(v, inverse, faults))
		return false;
	viewport_limits(v, half, scale);
	if (falls(c))
		scale[1] = -scale[1];
	if (c->depth_minus_one)
		min = sum_scale(sum_difference(v->min_z, -v->max_z), 0.5);
	map_identity(r);
	ndc_axis(r, 0, sum_of_double(scale[0]), 1, sum_difference(v->x, -half[0]),
	    inverse);
	ndc_axis(r, 1, sum_of_double(scale[1]), 1, sum_difference(v->y, -half[1]),
	    inverse);
	ndc_axis(r, 2, depth, c->depth_minus_one ? 2 : 1, min, inverse);
	map_set_origin(r, r->origin);
	return true;
}

bool device_map(const struct device *d, bool inverse, struct map *r,
    struct refusals *faults)
{
	const struct viewport v = { .x = d->x,
		.y = d->y,
		.width = d->width,
		.height = d->height,
		.max_z = 1 };
	const struct convention c = { .origin_bottom_left = !d->top_left };

	return viewport_map(&v, &c, inverse, r, faults);
}
