/* The inner loop of exact, written once for the vectors that copy.h describes. */
#include "kernel.h"

typedef struct {
	V hi, lo;
} vdd;

/* dd.h's, lane by lane. */
static inline vdd v_two_sum(V a, V b)
{
	V s = a + b, t = s - a;

	return (vdd){ s, (a - (s - t)) + (b - t) };
}

static inline vdd v_fast_two_sum(V a, V b)
{
	V s = a + b;

	return (vdd){ s, b - (s - a) };
}

/* A coordinate's product in hi, its error and low parts in lo: |lo| <= 3 u
 * |hi|. The chain rounds 2 u |hi| and 3 u |hi|, and p.lo b is left out: within
 * 6 u^2 |hi|. */
static inline vdd product(const struct kernel_map *m, int i, int j, vdd p)
{
	V a = ALL(m->hi[i][j]), b = ALL(m->lo[i][j]);
	V h = p.hi * a;

	return (vdd){ h, FMA(p.lo, a, FMA(p.hi, b, FMA(p.hi, a, -h))) };
}

/* Column j of the map: hi + lo with |lo| <= 5 u S, S the sum of the products'
 * sizes. Let x and y have the part a of S. The products lose 6 u^2 S; x.lo +
 * y.lo, s.lo + t.lo, z.lo to that, and both together round sums of at most 3
 * a, 1 + a, 4 - 2 a and 4 + a u S. In all 15 + 3 a <= 18 u^2 S. */
static inline vdd column(const struct kernel_map *m, int j, const vdd p[3],
    int terms, int image)
{
	vdd x = product(m, 0, j, p[0]), y = product(m, 1, j, p[1]);
	vdd s = v_two_sum(x.hi, y.hi);
	V lo = x.lo + y.lo;

	if (terms == 3) {
		vdd z = product(m, 2, j, p[2]);
		vdd t = v_two_sum(s.hi, z.hi);

		lo += z.lo + (s.lo + t.lo);
		s.hi = t.hi;
	} else {
		lo += s.lo;
	}
	if (image) {
		vdd t = v_two_sum(s.hi, ALL(m->hi[3][j]));

		lo += t.lo + ALL(m->lo[3][j]);
		s.hi = t.hi;
	}
	return (vdd){ s.hi, lo };
}

/* n / w, corrected by its residual. Normalised, n.lo and w.lo are below u |n|
 * and u |w|, the reciprocal and q carry u each. The residual's parts are below
 * 2 u and 2 u |n| and lose 2 u^2 each, their sum 4 u^2, the reciprocal's error
 * on that 4 u^2: the value that is rounded last is within 12 u^2. */
static inline V quotient(vdd n, vdd w, V reciprocal)
{
	n = v_fast_two_sum(n.hi, n.lo);
	V q = n.hi * reciprocal;
	V r = FMA(-q, w.hi, n.hi) + FMA(-q, w.lo, n.lo);

	return FMA(r, reciprocal, q);
}

/* a + b / w: the quotient is within 12 u^2 as above, the sums of low parts
 * round at most 5 u and 6 u (|a| + |b / w|): within 23 u^2 of that. */
static inline V exact_third(const struct kernel_map *m, vdd w, V reciprocal,
    V *sure)
{
	V q = ALL(m->b_hi) * reciprocal;
	V r = FMA(-q, w.hi, ALL(m->b_hi)) + FMA(-q, w.lo, ALL(m->b_lo));
	vdd s = v_two_sum(ALL(m->a_hi), q);
	V z = s.hi + (s.lo + FMA(r, reciprocal, ALL(m->a_lo)));

	*sure = MIN(*sure,
	    ABS(z) - FMA(ALL(m->doubt_depth), ABS(q), ALL(m->doubt_a)));
	return z;
}

/* How far a sum is from being lost in its error, and hi from being less than
 * lo. */
static inline V surely(const struct kernel_map *m, int j, V value, V size)
{
	return value - FMA(ALL(m->doubt[j]), size, ALL(m->doubt_image[j]));
}

static inline __attribute__((always_inline)) int
exact(const struct kernel_map *m, const double *const in[3],
    double *const out[3], size_t n, enum kernel_kind kind, int image)
{
	int terms = kind == KERNEL_FLAT ? 2 : 3;
	int divide = kind == KERNEL_DEPTH || kind == KERNEL_PROJECTIVE;
	V done = ALL(0);
	double all[WIDTH], sum = 0;

	for (size_t i = 0; i < n; i += WIDTH) {
		vdd p[3], c[3], w = { ALL(1), ALL(0) };
		V size = ALL(0), q[3], sure, r = ALL(1);

		for (int k = 0; k < terms; k++) {
			p[k] = v_two_sum(LOAD(in[k] + i), ALL(-m->origin[k]));
			size += ABS(p[k].hi);
		}
		if (divide) {
			w = column(m, 3, p, terms, image);
			sure = surely(m, 3, w.hi, size);
			w = v_fast_two_sum(w.hi, w.lo);
			r = ALL(1) / w.hi;
		}
		for (int k = 0; k < terms; k++) {
			if (k == 2 && kind == KERNEL_DEPTH) {
				q[k] = exact_third(m, w, r, &sure);
				continue;
			}
			c[k] = column(m, k, p, terms, image);
			V s = surely(m, k, ABS(c[k].hi), size);

			sure = k == 0 && !divide ? s : MIN(sure, s);
			if (divide)
				q[k] = quotient(c[k], w, r);
			else
				q[k] = c[k].hi + c[k].lo;
		}
		/* nan where any coordinate is nan or infinite: one that can
		 * only be reached with care, or not at all */
		V others = q[1];

		if (terms == 3)
			others += q[2];
		q[0] = POSITIVE(sure, FMA(others, ALL(0), q[0]));
		for (int k = 0; k < terms; k++)
			STORE(out[k] + i, q[k]);
		done += q[0] * ALL(0);
	}
	STORE(all, done);
	for (int i = 0; i < WIDTH; i++)
		sum += all[i];
	return sum == 0;
}

/* Without an image of the origin, as about the eye, four sums are saved. */
#define LOOP(KIND, name)                                                       \
	static int name(const struct kernel_map *m, const double *const in[3], \
	    double *const out[3], size_t n)                                    \
	{                                                                      \
		if (m->image)                                                  \
			return exact(m, in, out, n, KIND, 1);                  \
		return exact(m, in, out, n, KIND, 0);                          \
	}

LOOP(KERNEL_FLAT, exact_flat)
LOOP(KERNEL_AFFINE, exact_affine)
LOOP(KERNEL_DEPTH, exact_depth)
LOOP(KERNEL_PROJECTIVE, exact_projective)
#undef LOOP
