/* SPDX-License-Identifier: MIT */
#include "fit_bounds.h"

#include <math.h>

#include "frustum.h"

const char *bounds_check(const struct bounds *b, int dimensions)
{
	static const char *const less_than_min[3] = {
		"/bounds/max/0: less than min's; give the lower corner as min",
		"/bounds/max/1: less than min's; give the lower corner as min",
		"/bounds/max/2: less than min's; give the lower corner as min",
	};

	for (int k = 0; k < dimensions && !b->sphere; k++)
		if (b->max[k] < b->min[k])
			return less_than_min[k];
	return NULL;
}

double least_over(struct sum n, struct sum d)
{
	double v = sum_over(n, d);

	return sum_compare(sum_scale(d, v), n) < 0 ? nextafter(v, HUGE_VAL) : v;
}

void sides_widen(double *width, double *height, double across, double up)
{
	struct sum w = sum_of_double(across), h = sum_of_double(up);
	double wide = sum_over(sum_scale(w, *height), h);
	double high = sum_over(sum_scale(h, *width), w);

	if (wide > *width)
		*width = wide;
	else
		*height = fmax(*height, high);
}

/* A box is lowest at a corner; a sphere by its radius times the length of the
 * slope below its centre. */
struct sum bounds_lowest(const struct bounds *b, const struct map *m, int j,
    bool minus)
{
	struct sum slope[3], lowest = sum_of_double(0);

	for (int i = 0; i < 3; i++)
		slope[i] = sum_negated_if(minus, m->m[i][j]);
	for (int k = 0; k == 0 || k < b->n; k++) {
		struct sum sum = sum_negated_if(minus, m->m[3][j]);

		for (int i = 0; i < 3; i++) {
			double at = b->n > 0       ? b->point[k][i] :
			    b->sphere              ? b->center[i] :
			    sum_sign(slope[i]) > 0 ? b->min[i] :
						     b->max[i];

			sum = sum_add(sum,
			    sum_mul(slope[i], sum_of_double(at)));
		}
		if (k == 0 || sum_sign(sum_sub(sum, lowest)) < 0)
			lowest = sum;
	}
	if (b->sphere)
		lowest = sum_sub(lowest,
		    sum_mul(vec3_length(slope), sum_of_double(b->radius)));
	return sum_settled(sum_quotient(lowest, m->divisor));
}

/* Highest less lowest, of a box or a sphere roughly; 0 only where the bounds have no
 * extent. */
static double width(const struct bounds *b, const struct map *m, int j,
    const struct extents *r)
{
	double length = 0, sum = 0;

	if (b->n > 0)
		return sum_double(sum_sub(r->high[j], r->low[j]));
	for (int i = 0; i < 3; i++) {
		double slope = fabs(map_nearest(m, i, j, false));

		length = hypot(length, slope);
		sum += slope * (b->max[i] - b->min[i]);
	}
	return b->sphere ? 2 * b->radius * length : sum;
}

struct sum extents_middle(const struct extents *r, int j)
{
	return sum_mul(sum_add(r->low[j], r->high[j]), sum_of_double(0.5));
}

/* The lowest and highest of column j. */
static void range(const struct bounds *b, const struct map *m, int j,
    bool minus, struct extents *r)
{
	r->low[j] = bounds_lowest(b, m, j, minus);
	r->high[j] = sum_neg(bounds_lowest(b, m, j, !minus));
}

const char *bounds_center(const struct bounds *b, const struct scene *s,
    double center[3])
{
	struct map world;
	struct extents r;
	const char *why = scene_map(s, SPACE_MODEL, SPACE_WORLD, &world);

	for (int k = 0; k < 3 && why == NULL; k++) {
		range(b, &world, k, false, &r);
		center[k] = sum_double(extents_middle(&r, k));
	}
	return why;
}

const char *bounds_extents(const struct bounds *b, const struct scene *s,
    struct extents *r)
{
	bool parallel = s->projection.type != PROJECTION_PERSP &&
	    s->projection.type != PROJECTION_VOLUME;
	struct map view, clip;
	double widths[3], largest = 0;
	const char *why = scene_map(s, SPACE_MODEL, SPACE_VIEW, &view);

	clip = view;
	if (why == NULL && parallel)
		why = scene_map(s, SPACE_MODEL, SPACE_CLIP, &clip);
	/* no test reaches this: finding the centre has composed the same */
	if (why != NULL)
		return why;
	for (int j = 0; j < 3; j++) {
		const struct map *m = j == 2 ? &view : &clip;
		bool turned = j == 2 ?
		    looks_back(&s->convention) :
		    j == 1 && parallel && s->convention.ndc_y_down;

		range(b, m, j, turned, r);
		widths[j] = width(b, m, j, r);
		largest = fmax(largest, widths[j]);
	}
	if (largest == 0)
		return BOUNDS_SINGLE;
	/* a perspective's planes are at values of w */
	struct sum more = sum_of_double(projection_w_at_eye(&s->projection));

	r->low[2] = sum_add(r->low[2], more);
	r->high[2] = sum_add(r->high[2], more);
	for (int j = 0; j < 3; j++) {
		struct sum half = sum_of_double(
		    widths[j] == 0 ? 0x1p-21 * largest : 0);

		r->low[j] = sum_sub(r->low[j], half);
		r->high[j] = sum_add(r->high[j], half);
	}
	return NULL;
}

const char *bounds_out(const struct bounds *b, const struct scene *s,
    unsigned *out)
{
	struct frustum f;
	const char *why = frustum_of(s, SPACE_MODEL, false, &f);

	*out = 0;
	/* no test reaches this: the sizes that fit closes are valid */
	if (why != NULL)
		return why;
	for (int k = 0; k < (b->n > 0 ? b->n : 8) && !b->sphere; k++) {
		double corner[4] = { [3] = 1 };

		for (int i = 0; i < 3; i++)
			corner[i] = b->n > 0 ? b->point[k][i] :
			    k >> i & 1       ? b->max[i] :
					       b->min[i];
		*out |= frustum_out(&f, corner);
	}
	for (int k = 0; k < 7 && b->sphere; k++) {
		const struct map *m = k < 4 ? &f.sides.map : &f.ends.map;
		int low = sum_sign(bounds_lowest(b, m, k % 4, false));

		if (low < 0 || (low == 0 && 1 << k == OUT_BEHIND))
			*out |= 1u << k;
	}
	return NULL;
}

const char *bounds_close(const struct bounds *b, const struct scene *s,
    double *v, double outward, unsigned planes)
{
	double step = nextafter(*v, outward) - *v;
	unsigned out;

	for (; fabs(*v) <= MAGNITUDE_MAX; *v += step, step *= 2) {
		const char *why = bounds_out(b, s, &out);

		if (why != NULL || (out & planes) == 0)
			return why;
	}
	return NULL;
}

const char *bounds_close_depth(const struct bounds *b, struct scene *s)
{
	struct projection *p = &s->projection;
	struct extents r;
	const char *why = bounds_extents(b, s, &r);

	/* no test reaches this: all that could fail has been done before */
	if (why != NULL)
		return why;
	double far = sum_double(r.high[2]);

	p->near = sum_double(r.low[2]);
	p->far = fmax(far, nextafter(p->near, HUGE_VAL));
	why = bounds_close(b, s, &p->near, -HUGE_VAL, OUT_NEAR);
	p->far = fmax(far, nextafter(p->near, HUGE_VAL));
	return why != NULL ? why :
			     bounds_close(b, s, &p->far, HUGE_VAL, OUT_FAR);
}
