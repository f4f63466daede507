#include "error_bound.h"

#include "frustum.h"

/* Unit roundoff; the least number with all its digits; and what sums may come
 * to, a little below the largest. */
struct arithmetic {
	double u, tiny, most;
};

static const struct arithmetic arithmetic[] = {
	[PRECISION_DOUBLE] = { 0x1p-53, 0x1p-1022, 0x1p1000 },
	[PRECISION_SINGLE] = { 0x1p-24, 0x1p-126, 0x1p120 },
};

/* How far a point can lie from the origin of a map. */
#define FARTHEST (2 * MAGNITUDE_MAX)

/* The bounds below are computed in double. */
#define ROUNDED_UP (1 + 0x1p-46)

/* A corner of the view volume, seen from the map's origin. A sum of |products|
 * over w is a convex function of the position in ndc, and so is largest in a
 * corner, also in one that lies at infinity. */
struct corner {
	double p[3];    /* |p - origin| / w, at most */
	double inverse; /* 1/w, at most */
	double least;   /* 1/w, at least */
};

struct volume {
	const struct transform *t;
	struct corner corner[8];
	double size[3]; /* of the coordinates that come out */
};

static void set_corners(const struct scene *s, const struct map *from_clip,
    struct volume *v)
{
	const double *origin = v->t->map.origin, u2 = MAP_BOUND * 0x1p-106;

	for (int i = 0; i < 8; i++) {
		struct corner *c = &v->corner[i];
		struct ex_sum h[4];

		view_corner(s, from_clip, false, i, h);
		double w = ex_round(h[3].value).hi, error = u2 * h[3].size;

		for (int j = 0; j < 3; j++) {
			ex p = ex_scale(h[3].value, origin[j]);

			p = ex_sub(h[j].value, p);
			c->p[j] = fabs(ex_round(p).hi) +
			    u2 * (h[j].size + fabs(origin[j]) * h[3].size);
		}
		c->inverse = w + error;
		c->least = w - error;
	}
}

static void set_size(const struct scene *s, double size[3])
{
	const struct viewport *v = &s->viewport;

	size[0] = size[1] = size[2] = 1;
	if (!s->has_viewport)
		return;
	size[0] = fmax(fabs(v->x), fabs(v->x + v->width)) * ROUNDED_UP;
	size[1] = fmax(fabs(v->y), fabs(v->y + v->height)) * ROUNDED_UP;
	size[2] = fmax(fabs(v->min_z), fabs(v->max_z));
}

/* The sum of the magnitudes of column j's products, over w, in a corner. Results
 * below tiny have an error of at most tiny u; they can be a coordinate, an
 * element, and each of four operations. */
static double sum(const struct volume *v, int corner, int j, double tiny)
{
	const struct corner *c = &v->corner[corner];
	const struct map *m = &v->t->map;
	double s = c->inverse * (m->sum[AT_ORIGIN][j] + 4 * tiny);

	for (int i = 0; i < 3; i++)
		s += (c->p[i] + tiny * c->inverse) * (m->sum[i][j] + tiny);
	return s;
}

static double largest_sum(const struct volume *v, int j)
{
	double s = 0;

	for (int i = 0; i < 8; i++)
		s = fmax(s, sum(v, i, j, 0));
	return s;
}

static double largest_inverse(const struct volume *v)
{
	double inverse = 0;

	for (int i = 0; i < 8; i++)
		inverse = fmax(inverse, v->corner[i].inverse);
	return inverse;
}

/* Whether nothing overflows on the way, nor 1/w underflows. */
static bool fits(const struct volume *v, const struct arithmetic *a)
{
	const struct kernel_map *l = &v->t->for_kernel;
	const struct map *m = &v->t->map;
	double far[3] = { 0 };

	for (int i = 0; i < 24; i++) {
		const struct corner *c = &v->corner[i / 3];
		double p = c->least > 0 ? c->p[i % 3] / c->least : FARTHEST;

		far[i % 3] = fmax(far[i % 3], fmin(p, FARTHEST));
	}
	for (int j = 0; j < 4; j++) {
		double s = m->sum[AT_ORIGIN][j];

		for (int i = 0; i < 3; i++) {
			s += far[i] * m->sum[i][j];
			if (!(m->sum[i][j] <= a->most) || !(far[i] <= a->most))
				return false;
		}
		if (!(s <= a->most))
			return false;
	}
	return largest_inverse(v) <= a->most && fabs(l->a_hi) <= a->most &&
	    fabs(l->b_hi) <= a->most;
}

static double plain(const struct volume *v, const struct arithmetic *a)
{
	const struct transform *t = v->t;
	double cu = PLAIN_BOUND * a->u, worst = 0, w = 0;
	double inverse = largest_inverse(v);

	for (int i = 0; i < 8; i++) {
		double s3 = sum(v, i, 3, a->tiny);

		w = fmax(w, s3);
		for (int j = 0; j < 3; j++) {
			double s = sum(v, i, j, a->tiny);

			if (t->divide)
				s += v->size[j] * s3;
			if (j < 2 || t->kind != KERNEL_DEPTH)
				worst = fmax(worst, s);
		}
	}
	if (t->kind == KERNEL_DEPTH)
		worst = fmax(worst,
		    fabs(t->for_kernel.a_hi) +
			fabs(t->for_kernel.b_hi) * inverse * w);
	if (!fits(v, a) || (t->divide && !(cu * w < 0x1p-4)))
		return (double)NAN;
	return (cu * worst + 2 * a->tiny) * ROUNDED_UP;
}

/* kappa units in the last place of n / w are at most 2^-52 sum(n) sum(w) / w^2;
 * half a unit is largest for the largest coordinate. */
static double exact(const struct volume *v)
{
	double worst = 0, w = v->t->divide ? largest_sum(v, 3) : 1;

	for (int j = 0; j < 3; j++) {
		double s = largest_sum(v, j) * w * 0x1p-52 * POINTS_BOUND;
		int e;

		frexp(v->size[j], &e);
		worst = fmax(worst, (s + ldexp(1, e - 54)) * ROUNDED_UP);
	}
	return isfinite(worst) ? worst : (double)NAN;
}

const char *error_bounds(const struct scene *s, double bound[3])
{
	enum space to = s->has_viewport ? SPACE_DEVICE : SPACE_NDC;
	struct transform t;
	struct map from_clip;
	struct volume v = { .t = &t };
	const char *why = scene_transform(s, SPACE_MODEL, to, false, &t);

	for (int i = 0; i < 3; i++)
		bound[i] = (double)NAN;
	/* where the world matrix is singular the volume has no end */
	if (why != NULL ||
	    scene_map(s, SPACE_CLIP, SPACE_MODEL, &from_clip) != NULL)
		return why;
	set_corners(s, &from_clip, &v);
	set_size(s, v.size);
	bound[PRECISION_EXACT] = exact(&v);
	bound[PRECISION_DOUBLE] = plain(&v, &arithmetic[PRECISION_DOUBLE]);
	bound[PRECISION_SINGLE] = plain(&v, &arithmetic[PRECISION_SINGLE]);
	return NULL;
}
