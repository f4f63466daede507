/* SPDX-License-Identifier: MIT */
#include "error_bound.h"

struct arithmetic {
	double u;     /* unit roundoff */
	double tiny;  /* least normal number */
	double limit; /* error bounds are nan if 1/w or an image is larger */
};

static const struct arithmetic arithmetic[] = {
	[PRECISION_DOUBLE] = { 0x1p-53, 0x1p-1022, 0x1p1000 },
	[PRECISION_SINGLE] = { 0x1p-24, 0x1p-126, 0x1p120 },
};

/* The factor that makes a bound in doubles at least as large as the exact bound. */
#define ROUNDED_UP (1 + 0x1p-46)

/* A corner of the view volume, which may be at infinity. An error bound is a sum of
 * magnitudes of products, divided by w. This quotient is a convex function of the
 * position in ndc, so its maximum over the volume is at a corner. */
struct corner {
	double offset[3]; /* |model coordinate - the map's origin| / w */
	double inverse_w; /* 1/w */
};

struct error_analysis {
	const struct transform *transform;
	struct corner corner[8];
	double max[3], largest; /* bounds of images' |x|, |y|, |z|; their max */
};

/* Sets c to corner i of the volume. to_model maps world to model space. */
static void set_corner(const struct lens *l, const struct map *to_model,
    const double origin[3], int i, struct corner *c)
{
	struct sum h[4], w;

	for (int j = 0; j < 4; j++)
		map_image(to_model, j, l->world_corner[i], &h[j]);
	map_image(&l->ends, 2, l->corner[i], &w);
	w = sum_quotient(sum_mul(w, sum_mul(to_model->divisor, l->to_world.divisor)),
	    l->ends.divisor);
	for (int j = 0; j < 3; j++)
		c->offset[j] = fabs(
		    sum_ratio(sum_sub(h[j], sum_scale(h[3], origin[j])), w));
	c->inverse_w = sum_ratio(h[3], w);
}

/* Returns S / w of column j in a corner: S is the sum of the magnitudes of the column's
 * products, as in kernel/approx.h, plus the largest errors by underflow. */
static double column_bound(const struct kernel_map *k, const struct corner *c, int j,
    double tiny)
{
	double s = c->inverse_w * (k->offset[j] + tiny * (4 + 3 * k->slope[j]));

	for (int i = 0; i < 3; i++)
		s += c->offset[i] * (fabs(k->hi[i][j]) + tiny);
	return s;
}

/* Returns the error bound for the arithmetic *a, or nan if w could be at most 16 times
 * its error, or if 1/w, the image, k->a or k->b could be above a->limit. If another
 * number overflows, no bound is needed: the image is not finite, but made exactly. */
static double precision_bound(const struct error_analysis *v,
    const struct arithmetic *a)
{
	const struct transform *t = v->transform;
	const struct kernel_map *k = &t->for_kernel;
	double factor = APPROX_BOUND * a->u, worst = 0, w = 0, inverse_w = 0;

	for (int i = 0; i < 8; i++) {
		const struct corner *c = &v->corner[i];
		double s_w = column_bound(k, c, 3, a->tiny);

		w = fmax(w, s_w);
		inverse_w = fmax(inverse_w, c->inverse_w);
		for (int j = 0; j < (t->kernel == KERNEL_DEPTH ? 2 : 3); j++)
			worst = fmax(worst,
			    column_bound(k, c, j, a->tiny) +
				(t->divide ? v->max[j] * s_w : 0));
	}
	if (t->kernel == KERNEL_DEPTH)
		worst = fmax(worst, fabs(k->a) + fabs(k->b) * inverse_w * w);
	if (!(inverse_w <= a->limit) || !(v->largest <= a->limit) ||
	    !(fabs(k->a) <= a->limit) || !(fabs(k->b) <= a->limit) ||
	    (t->divide && !(factor * w < 0x1p-4)))
		return (double)NAN;
	return (factor * worst + 4 * a->tiny * a->u) * ROUNDED_UP;
}

bool error_bound_of(const struct lens *l, double bound[3], struct refusals *faults)
{
	const struct scene *s = &l->scene;
	enum space to = s->has_viewport ? SPACE_DEVICE : SPACE_NDC;
	struct transform t;
	struct map to_model;
	const struct viewport *v = &s->viewport;
	struct error_analysis a = { .transform = &t, .max = { 1, 1, 1 } };
	int e;

	for (int i = 0; i < 3; i++)
		bound[i] = (double)NAN;
	if (!transform_of_scene(s, SPACE_MODEL, to, false, &t, faults))
		return false;
	/* there are no bounds if the volume is infinite in model space */
	if (projection_is_open(&s->projection) ||
	    !scene_map(s, SPACE_WORLD, SPACE_MODEL, &to_model, NULL))
		return true;
	for (int i = 0; i < 8; i++)
		set_corner(l, &to_model, t.for_kernel.origin, i, &a.corner[i]);
	if (s->has_viewport) {
		a.max[0] = fmax(fabs(v->x), fabs(v->x + v->width)) * ROUNDED_UP;
		a.max[1] = fmax(fabs(v->y), fabs(v->y + v->height)) * ROUNDED_UP;
		a.max[2] = fmax(fabs(v->min_z), fabs(v->max_z));
	}
	a.largest = fmax(fmax(a.max[0], a.max[1]), a.max[2]);
	/* half an ulp of the largest coordinate */
	frexp(a.largest, &e);
	bound[PRECISION_EXACT] = ldexp(1, e - 54);
	for (int i = PRECISION_DOUBLE; i <= PRECISION_SINGLE; i++)
		bound[i] = precision_bound(&a, &arithmetic[i]);
	return true;
}
