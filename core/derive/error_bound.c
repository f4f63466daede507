/* SPDX-License-Identifier: MIT */
#include "frustum.h"

#include <math.h>

struct arithmetic {
	double u;    /* unit roundoff */
	double tiny; /* least normal number */
	double most; /* the bound is nan if 1/w or the image is above it */
};

static const struct arithmetic arithmetic[] = {
	[PRECISION_DOUBLE] = { 0x1p-53, 0x1p-1022, 0x1p1000 },
	[PRECISION_SINGLE] = { 0x1p-24, 0x1p-126, 0x1p120 },
};

/* The factor that outweighs the roundings of a bound, which is computed in double. */
#define ROUNDED_UP (1 + 0x1p-46)

/* A corner of the view volume. The bound of an error is a sum of magnitudes of
 * products, over w. This quotient is a convex function of the position in ndc, so its
 * maximum is in a corner, which may be at infinity. */
struct corner {
	double p[3];    /* |p - origin| / w, for the map's origin */
	double inverse; /* 1/w */
};

struct analysis {
	const struct transform *t;
	struct corner corner[8];
	double size[3], largest; /* bounds of the image's coordinates */
};

/* back is the map from view space. */
static void set_corner(const struct volume *seen, const struct map *back,
    const double origin[3], int i, struct corner *c)
{
	struct sum h[4], over;

	for (int j = 0; j < 4; j++)
		map_image(back, j, seen->corner[i], &h[j]);
	map_image(&seen->ends, 2, seen->corner[i], &over);
	over = sum_quotient(sum_mul(over, back->divisor), seen->ends.divisor);
	for (int j = 0; j < 3; j++)
		c->p[j] = fabs(
		    sum_ratio(sum_sub(h[j], sum_scale(h[3], origin[j])), over));
	c->inverse = sum_ratio(h[3], over);
}

static void set_size(const struct scene *s, struct analysis *to)
{
	const struct viewport *v = &s->viewport;
	double *size = to->size;

	size[0] = size[1] = size[2] = 1;
	if (s->has_viewport) {
		size[0] = fmax(fabs(v->x), fabs(v->x + v->width)) * ROUNDED_UP;
		size[1] = fmax(fabs(v->y), fabs(v->y + v->height)) * ROUNDED_UP;
		size[2] = fmax(fabs(v->min_z), fabs(v->max_z));
	}
	to->largest = fmax(fmax(size[0], size[1]), size[2]);
}

/* Returns S / w of column j in a corner. S is the sum of the magnitudes of the
 * products, as in kernel/approx.h, and of the largest error of underflows. */
static double bound_column(const struct kernel_map *k, const struct corner *c,
    int j, double tiny)
{
	double s = c->inverse * (k->offset[j] + tiny * (4 + 3 * k->slope[j]));

	for (int i = 0; i < 3; i++)
		s += c->p[i] * (fabs(k->hi[i][j]) + tiny);
	return s;
}

/* Returns the bound for the precision of a. Returns nan if w could be less than its
 * error, or 1/w beyond the range. A bound need not cover other sums beyond the range:
 * the program then computes the point exactly. */
static double bound_plain(const struct analysis *v, const struct arithmetic *a)
{
	const struct transform *t = v->t;
	const struct kernel_map *k = &t->for_kernel;
	double factor = APPROX_BOUND * a->u, worst = 0, w = 0, inverse = 0;

	for (int i = 0; i < 8; i++) {
		const struct corner *c = &v->corner[i];
		double s_w = bound_column(k, c, 3, a->tiny);

		w = fmax(w, s_w);
		inverse = fmax(inverse, c->inverse);
		for (int j = 0; j < (t->kind == KERNEL_DEPTH ? 2 : 3); j++)
			worst = fmax(worst,
			    bound_column(k, c, j, a->tiny) +
				(t->divide ? v->size[j] * s_w : 0));
	}
	if (t->kind == KERNEL_DEPTH)
		worst = fmax(worst, fabs(k->a) + fabs(k->b) * inverse * w);
	if (!(inverse <= a->most) || !(v->largest <= a->most) ||
	    !(fabs(k->a) <= a->most) || !(fabs(k->b) <= a->most) ||
	    (t->divide && !(factor * w < 0x1p-4)))
		return (double)NAN;
	return (factor * worst + 4 * a->tiny * a->u) * ROUNDED_UP;
}

const char *error_bounds(const struct scene *s, const struct volume *seen,
    double bound[3])
{
	enum space to = s->has_viewport ? SPACE_DEVICE : SPACE_NDC;
	struct transform t;
	struct map back;
	struct analysis v = { .t = &t };
	const char *why = scene_transform(s, SPACE_MODEL, to, false, &t);
	int e;

	for (int i = 0; i < 3; i++)
		bound[i] = (double)NAN;
	/* the volume is infinite without planes, or if world is singular */
	if (why != NULL || projection_is_open(&s->projection) ||
	    scene_map(s, SPACE_VIEW, SPACE_MODEL, &back) != NULL)
		return why;
	for (int i = 0; i < 8; i++)
		set_corner(seen, &back, t.for_kernel.origin, i, &v.corner[i]);
	set_size(s, &v);
	/* half an ulp of the largest coordinate */
	frexp(v.largest, &e);
	bound[PRECISION_EXACT] = ldexp(1, e - 54);
	for (int i = PRECISION_DOUBLE; i <= PRECISION_SINGLE; i++)
		bound[i] = bound_plain(&v, &arithmetic[i]);
	return NULL;
}
