/* SPDX-License-Identifier: MIT */
#include "fit_window.h"

#include <math.h>

struct axis_range {
	struct sum low, high;
};

static struct axis_range axis_range_of(const struct bounds *b, int axis)
{
	double c = b->center[axis], r = b->radius;

	return b->sphere ?
	    (struct axis_range){ sum_diff(c, r), sum_diff(c, -r) } :
	    (struct axis_range){ sum_of_double(b->min[axis]),
		    sum_of_double(b->max[axis]) };
}

static struct sum extent(const struct axis_range *r)
{
	return sum_sub(r->high, r->low);
}

/* Half of 2^-20 of the other axis on each side. */
static void widen_none(struct axis_range *r, struct sum other)
{
	struct sum half = sum_scale(other, 0x1p-21);

	if (sum_sign(extent(r)) > 0)
		return;
	r->low = sum_sub(r->low, half);
	r->high = sum_add(r->high, half);
}

/* The side is twice what is farthest from the center, which may be rounded. */
static void close_axis(const struct axis_range *r, double margin,
    double *center, double *side)
{
	*center = sum_double(sum_scale(sum_add(r->low, r->high), 0.5));
	struct sum c = sum_of_double(*center);
	struct sum below = sum_sub(c, r->low), above = sum_sub(r->high, c);
	struct sum most = sum_compare(below, above) > 0 ? below : above;

	*side = least_over(sum_scale(most, 2), sum_diff(1, 2 * margin));
}

const char *fit_window(struct scene *s, const struct bounds *b)
{
	struct window *w = &s->window;
	struct axis_range x = axis_range_of(b, 0), y = axis_range_of(b, 1);
	const char *why = bounds_check(b, 2);

	if (why != NULL)
		return why;
	if (sum_sign(extent(&x)) == 0 && sum_sign(extent(&y)) == 0)
		return BOUNDS_SINGLE;
	widen_none(&x, extent(&y));
	widen_none(&y, extent(&x));
	*w = (struct window){ .zoom = 1 };
	close_axis(&x, s->margin, &w->center[0], &w->width);
	close_axis(&y, s->margin, &w->center[1], &w->height);
	if (s->has_device)
		sides_widen(&w->width, &w->height, s->device.width,
		    s->device.height);
	s->has_window = true;
	return scene_is_size(w->width) && scene_is_size(w->height) ?
	    NULL :
	    BOUNDS_BEYOND;
}

void window_directions(struct directions *all)
{
	struct map identity;

	map_identity(&identity);
	all->n = 0;
	for (int k = 0; k < 4; k++)
		directions_add(all, &identity, k / 2, k & 1);
}
