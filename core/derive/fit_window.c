/* SPDX-License-Identifier: MIT */
#include "fit_window.h"

#include <math.h>

struct range {
	ex low, high;
};

static struct range range_of(const struct bounds *b, int axis)
{
	double c = b->center[axis], r = b->radius;

	return b->sphere ?
	    (struct range){ ex_diff(c, r), ex_diff(c, -r) } :
	    (struct range){ ex_of(b->min[axis]), ex_of(b->max[axis]) };
}

static ex extent(const struct range *r)
{
	return ex_sub(r->high, r->low);
}

/* Half of 2^-20 of the other axis on each side. */
static void widen_none(struct range *r, ex other)
{
	ex half = ex_shift(other, -21);

	if (ex_sign(extent(r)) > 0)
		return;
	r->low = ex_sub(r->low, half);
	r->high = ex_add(r->high, half);
}

/* The least double that times d is not below n: the nearest to the quotient, or the
 * one after it. */
static double least_over(ex n, ex d)
{
	double v = ex_double(ex_quotient(n, d));

	return ex_compare(ex_mul(ex_of(v), d), n) < 0 ? nextafter(v, HUGE_VAL) :
							v;
}

/* The side is twice what is farthest from the center, which may be rounded. */
static void close_axis(const struct range *r, double margin, double *center,
    double *side)
{
	*center = ex_double(ex_scale(ex_add(r->low, r->high), 0.5));
	ex c = ex_of(*center);
	ex below = ex_sub(c, r->low), above = ex_sub(r->high, c);
	ex most = ex_compare(below, above) > 0 ? below : above;

	*side = least_over(ex_scale(most, 2), ex_diff(1, 2 * margin));
}

const char *fit_window(struct scene *s, const struct bounds *b)
{
	struct window *w = &s->window;
	struct range x = range_of(b, 0), y = range_of(b, 1);
	const char *why = bounds_check(b, 2);

	if (why != NULL)
		return why;
	if (ex_sign(extent(&x)) == 0 && ex_sign(extent(&y)) == 0)
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
	return is_size(w->width) && is_size(w->height) ? NULL : BOUNDS_BEYOND;
}

void window_directions(struct directions *all)
{
	struct map identity;

	map_identity(&identity);
	all->n = 0;
	for (int k = 0; k < 4; k++)
		directions_add(all, &identity, k / 2, k & 1);
}
