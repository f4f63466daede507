/* SPDX-License-Identifier: MIT */
/* Sums of products in double-double, and the test whether their quotients are
 * surely rounded as the exact ones: for single points, between the kernels and
 * exact arithmetic. */
#ifndef QUICK_H
#define QUICK_H

#include <stdbool.h>

#include "kernel/kernel.h"

#include "dd.h"

/* A sum of products, and of their magnitudes; and whether it is exact, as often
 * where a number is midway between two others. */
struct quick {
	dd value;
	double size;
	bool exact;
};

#define QUICK_ZERO ((struct quick){ { 0, 0 }, 0, true })
#define QUICK_ONE ((struct quick){ { 1, 0 }, 0, true })

/* What a column is off by, in units of u^2 of size, as `make prove` counts it: an
 * element is off by 1/2, a product by 6 more, each addition by 3: a column by 15.5.
 * A quotient has the relative errors of both and 9 of its own: all is within 32
 * (size/|n| + size/|d|), each of which is at least 1. */
#define QUICK_BOUND 0x1p-101

/* dd_add, with an eye on its roundings. */
static inline dd quick_sum(dd a, dd b, bool *exact)
{
	dd s = two_sum(a.hi, b.hi), t = two_sum(a.lo, b.lo);
	dd u = two_sum(s.lo, t.hi);

	s = fast_two_sum(s.hi, u.hi);
	dd v = two_sum(s.lo, t.lo);

	*exact &= u.lo == 0 && v.lo == 0;
	return fast_two_sum(s.hi, v.hi);
}

/* Adds a b, for a of such a size. */
static inline void quick_add(struct quick *s, dd a, double size, dd b,
    bool exact)
{
	dd p = dd_mul(a, b);

	s->exact &= exact && a.lo == 0 && b.lo == 0 &&
	    (fabs(p.hi) > 0x1p-900 || a.hi == 0 || b.hi == 0);
	s->value = quick_sum(s->value, p, &s->exact);
	/* 0 only where all products are, though what is added may underflow */
	if (size > 0 && fabs(b.hi) > 0)
		s->size += size * fabs(b.hi) + 0x1p-1022;
}

static inline dd quick_element(const struct kernel_map *k, int i, int j)
{
	return (dd){ k->hi[i][j], k->lo[i][j] };
}

/* Column j of the image of p, relative to the origin, w. What is no difference
 * there counts as much as an error. */
static inline struct quick quick_column(const struct kernel_map *k, int j,
    const dd p[4])
{
	struct quick s = QUICK_ZERO;

	for (int i = 0; i < 4; i++)
		quick_add(&s, p[i], fabs(p[i].hi), quick_element(k, i, j),
		    k->exact[i][j]);
	if (s.size > 0)
		s.size += k->none[j] / QUICK_BOUND *
		    (fabs(p[0].hi) + fabs(p[1].hi) + fabs(p[2].hi) +
			fabs(p[3].hi));
	return s;
}

static inline bool quick_is_moderate(double a)
{
	return fabs(a) > 0x1p-450 && fabs(a) < 0x1p450;
}

/* Rounds n / d, where d is QUICK_ONE or a sum; false where its error may turn the
 * rounding, or anything comes near the end of the range. */
static inline bool quick_over(struct quick n, struct quick d, double *q)
{
	dd v = dd_div(n.value, d.value);
	double error = QUICK_BOUND * (n.size + fabs(v.hi) * d.size) /
	    fabs(d.value.hi);

	*q = v.hi;
	if (n.size == 0 || (n.exact && d.size == 0 && n.value.hi == 0))
		return true;
	if (n.exact && d.size == 0)
		return quick_is_moderate(n.value.hi);
	return quick_is_moderate(n.value.hi) && quick_is_moderate(d.value.hi) &&
	    quick_is_moderate(v.hi) && v.hi + (v.lo - error) == v.hi &&
	    v.hi + (v.lo + error) == v.hi;
}

#endif
