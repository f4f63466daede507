#include "fit_bounds.h"

#include <math.h>

#include "frustum.h"

struct sum sum_of(ex value, double size)
{
	struct sum s = { ex_round(value), size };

	if (fabs(s.value.hi) <= SUM_BOUND * size && isfinite(size))
		s.value = (dd){ 0, 0 };
	return s;
}

/* A box is lowest at a corner; a sphere by its radius times the length of the
 * slope below its centre. */
struct sum bounds_lowest(const struct bounds *b, const struct map *m, int j,
    double sign)
{
	ex sum = ex_scale(ex_dd(m->m[AT_ORIGIN][j]), sign), square = ex_of(0);
	double size = m->sum[AT_ORIGIN][j], radius = b->sphere ? b->radius : 0;

	for (int i = 0; i < 3; i++) {
		ex slope = ex_scale(ex_dd(m->m[i][j]), sign);
		double at = b->sphere  ? b->center[i] :
		    ex_sign(slope) > 0 ? b->min[i] :
					 b->max[i];
		ex p = ex_diff(at, m->origin[i]);

		sum = ex_add(sum, ex_mul(p, slope));
		square = ex_add(square, ex_mul(slope, slope));
		size += (fabs(ex_round(p).hi) + radius) * m->sum[i][j];
	}
	sum = ex_sub(sum, ex_scale(ex_sqrt(square), radius));
	return sum_of(sum, size);
}

/* Highest less lowest, roughly; 0 only where the bounds have no extent. */
static double width(const struct bounds *b, const struct map *m, int j)
{
	double length = 0, sum = 0;

	for (int i = 0; i < 3; i++) {
		length = hypot(length, m->m[i][j].hi);
		sum += fabs(m->m[i][j].hi) * (b->max[i] - b->min[i]);
	}
	return b->sphere ? 2 * b->radius * length : sum;
}

struct sum extents_middle(const struct extents *r, int j)
{
	ex sum = ex_add(ex_dd(r->low[j].value), ex_dd(r->high[j].value));

	return sum_of(ex_scale(sum, 0.5), r->low[j].size + r->high[j].size);
}

/* The lowest and highest of column j. */
static void range(const struct bounds *b, const struct map *m, int j,
    double sign, struct extents *r)
{
	r->low[j] = bounds_lowest(b, m, j, sign);
	r->high[j] = bounds_lowest(b, m, j, -sign);
	r->high[j].value = dd_neg(r->high[j].value);
}

const char *bounds_center(const struct bounds *b, const struct scene *s,
    double center[3])
{
	struct map world;
	struct extents r;
	const char *why = scene_map(s, SPACE_MODEL, SPACE_WORLD, &world);

	for (int k = 0; k < 3 && why == NULL; k++) {
		range(b, &world, k, 1, &r);
		center[k] = extents_middle(&r, k).value.hi;
	}
	return why;
}

const char *bounds_extents(const struct bounds *b, const struct scene *s,
    struct extents *r)
{
	bool parallel = s->projection.type != PROJECTION_PERSP;
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
		    s->convention.right_handed :
		    j == 1 && parallel && s->convention.ndc_y_down;

		range(b, m, j, turned ? -1 : 1, r);
		widths[j] = width(b, m, j);
		largest = fmax(largest, widths[j]);
	}
	if (largest == 0)
		return "/bounds: a single point; what has an extent is wanted";
	for (int j = 0; j < 3; j++) {
		dd half = { widths[j] == 0 ? 0x1p-21 * largest : 0, 0 };

		r->low[j].value = dd_add(r->low[j].value, dd_neg(half));
		r->high[j].value = dd_add(r->high[j].value, half);
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
	for (int k = 0; k < 8 && !b->sphere; k++) {
		double corner[4] = { [3] = 1 };

		for (int i = 0; i < 3; i++)
			corner[i] = k >> i & 1 ? b->max[i] : b->min[i];
		*out |= frustum_out(&f, corner);
	}
	for (int k = 0; k < 7 && b->sphere; k++) {
		const struct map *m = k < 4 ? &f.sides.map : &f.ends.map;
		double low = bounds_lowest(b, m, k % 4, 1).value.hi;

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
	double far = r.high[2].value.hi;

	p->near = r.low[2].value.hi;
	p->far = fmax(far, nextafter(p->near, HUGE_VAL));
	why = bounds_close(b, s, &p->near, -HUGE_VAL, OUT_NEAR);
	p->far = fmax(far, nextafter(p->near, HUGE_VAL));
	return why != NULL ? why :
			     bounds_close(b, s, &p->far, HUGE_VAL, OUT_FAR);
}
