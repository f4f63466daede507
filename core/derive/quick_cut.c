/* SPDX-License-Identifier: MIT */
#include "quick_cut.h"

/* A number with a bound of its error. With u = 2^-53, a sum of two dd is within 3 u^2
 * of the sum of their magnitudes, and a product within 7 u^2 of its own (Joldes, Muller
 * and Popescu, Tight and Rigorous Error Bounds for Basic Building Blocks of Double-Word
 * Arithmetic, 2017). A column has three of both, and elements within u^2 / 2: less than
 * 32 u^2 of the sum of its magnitudes. PAIR_BOUND is 256 u^2, and so covers the
 * roundings of the bounds, too. TINY is above all that underflows. */
struct bounded {
	dd v;
	double error;
};

#define PAIR_BOUND 0x1p-98
#define TINY 0x1p-1000

static inline dd two_sum(double a, double b)
{
	const double s = a + b, part = s - a;

	return (dd){ s, (a - (s - part)) + (b - part) };
}

static inline dd quick_two_sum(double a, double b)
{
	const double s = a + b;

	return (dd){ s, b - (s - a) };
}

/* Returns a b, exactly: Dekker, A Floating-Point Technique for Extending the Available
 * Precision, 1971. What overflows becomes nan, which no comparison accepts. */
static inline dd two_product(double a, double b)
{
	const double x = 0x8000001p0 * a, y = 0x8000001p0 * b;
	const double a_high = x - (x - a), a_low = a - a_high;
	const double b_high = y - (y - b), b_low = b - b_high;
	const double p = a * b;

	return (dd){ p,
		a_low * b_low -
		    (((p - a_high * b_high) - a_low * b_high) - a_high * b_low) };
}

static inline dd dd_add(dd a, dd b)
{
	dd s = two_sum(a.hi, b.hi);
	const dd t = two_sum(a.lo, b.lo);

	s = quick_two_sum(s.hi, s.lo + t.hi);
	return quick_two_sum(s.hi, s.lo + t.lo);
}

static inline dd dd_mul(dd a, dd b)
{
	const dd p = two_product(a.hi, b.hi);

	return quick_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

static inline dd dd_minus(dd a)
{
	return (dd){ -a.hi, -a.lo };
}

/* Returns a column of the image of a point. Its error includes the map's noise, which
 * kernel.h describes. */
static struct bounded column(const struct kernel_map *m, int terms, int j,
    const double *in)
{
	dd sum = { m->hi[3][j], m->lo[3][j] };
	double size = fabs(sum.hi), far = 1;

	for (int k = 0; k < terms; k++) {
		const dd d = two_sum(in[k], -m->origin[k]);
		const dd p = dd_mul(d, (dd){ m->hi[k][j], m->lo[k][j] });

		sum = dd_add(sum, p);
		size += fabs(p.hi);
		far += fabs(d.hi);
	}
	return (struct bounded){ sum, PAIR_BOUND * size + far * (m->noise[j] + TINY) };
}

static struct bounded quick_side(const struct quick_cut *c, int plane, const double *in)
{
	const struct transform *t = plane < 4 ? &c->frustum->sides : &c->frustum->ends;

	return column(&t->for_kernel, t->in, plane % 4, in);
}

static bool is_sure(struct bounded a)
{
	return fabs(a.v.hi) * 0x1p-60 > a.error;
}

/* Returns a x - b y. */
static struct bounded minor(const struct bounded *a, const struct bounded *x,
    const struct bounded *b, const struct bounded *y)
{
	const dd p = dd_mul(a->v, x->v), q = dd_mul(b->v, y->v);
	const double of_first = a->error * fabs(x->v.hi) + fabs(a->v.hi) * x->error +
	    a->error * x->error;
	const double of_second = b->error * fabs(y->v.hi) + fabs(b->v.hi) * y->error +
	    b->error * y->error;

	return (struct bounded){ dd_add(p, dd_minus(q)),
		2 * (of_first + of_second) + PAIR_BOUND * (fabs(p.hi) + fabs(q.hi)) +
		    TINY };
}

/* Sets *r to the double nearest to n / d. Returns false if it is not sure. */
static bool divide(const struct bounded *n, const struct bounded *d, double *r)
{
	const double first = n->v.hi / d->v.hi;
	const dd rest = dd_add(n->v, dd_minus(dd_mul((dd){ first, 0 }, d->v)));
	const dd q = quick_two_sum(first, rest.hi / d->v.hi);
	const double error = 2 * (n->error + fabs(q.hi) * d->error) / fabs(d->v.hi) +
	    PAIR_BOUND * fabs(q.hi);

	*r = q.hi;
	return fabs(q.hi) > 0x1p-900 && fabs(q.hi) < 0x1p1000 && is_sure(*d) &&
	    q.hi + (q.lo - error) == q.hi && q.hi + (q.lo + error) == q.hi;
}

bool quick_cut_sides(const struct quick_cut *c, int plane, const double *p,
    const double *q, double *a, double *b)
{
	const struct bounded at_p = quick_side(c, plane, p);
	const struct bounded at_q = quick_side(c, plane, q);

	*a = at_p.v.hi;
	*b = at_q.v.hi;
	return is_sure(at_p) && is_sure(at_q);
}

bool quick_cut_image(const struct quick_cut *c, int plane, const double *p,
    const double *q, double image[4])
{
	const struct bounded a = quick_side(c, plane, p), b = quick_side(c, plane, q);
	const struct transform *t = c->image;
	struct bounded x = { { 1, 0 }, 0 }, y = x;

	if (t->divide) {
		x = column(&t->for_kernel, t->in, 3, q);
		y = column(&t->for_kernel, t->in, 3, p);
	}
	const struct bounded w = minor(&a, &x, &b, &y);

	for (int j = 0; j < t->out; j++) {
		if (c->has_edges && j == plane / 2) {
			image[j] = c->edge[plane];
			continue;
		}
		x = column(&t->for_kernel, t->in, j, q);
		y = column(&t->for_kernel, t->in, j, p);
		const struct bounded n = minor(&a, &x, &b, &y);

		if (!divide(&n, &w, &image[j]))
			return false;
	}
	return !c->has_edges || !isnan(c->edge[plane]);
}

bool quick_cut_of(struct quick_cut *c, enum space from, enum space to,
    const struct transform *image, const struct frustum *f)
{
	const bool flat = space_is_flat(from);

	c->image = image;
	c->frustum = f;
	c->has_edges = flat || to == SPACE_NDC || to == SPACE_DEVICE;
	for (int k = 0; k < CLIP_PLANES; k++)
		c->edge[k] = (double)NAN;
	return (flat || from <= SPACE_VIEW) && image->distance == DISTANCE_NONE;
}
