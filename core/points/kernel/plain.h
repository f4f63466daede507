/* SPDX-License-Identifier: MIT */
/* The inner loop of double and single, written once: copy.h includes it for each
 * kind of column. As in exact.h a point is taken relative to the map's origin.
 *
 * With u the unit roundoff and S the sum of a column's products' magnitudes:
 * a point's difference from the origin and a matrix element carry u each, a
 * chain of three products and sums 3 u. So a column is within 5 u S. A quotient
 * N / W carries that of both, and u each for the reciprocal and the product:
 *
 *	|error of N/W| <= PLAIN_BOUND u (S_N + |N/W| S_W) / |W|
 *
 * of which 5 is the columns', 2 the quotient's and 1 for printing the shortest
 * digits: 8. Depth a + b/w is within PLAIN_BOUND u (|a| + |b/W| S_W / |W|): b, the
 * reciprocal, the fused product and sum, and printing carry u each, to which come
 * w's 5 u S_W: 9. Both are so where S_W is |W|. Where it is more, w
 * is known less, to 1/16 as error_bound.c asks for: dividing by what was computed makes its
 * 5 at most 32/31 as much, and the others weigh less. `make prove` counts all of
 * these, and error_bound.c bounds S for the points of a scene. What underflows is off
 * by u times the least normal number at most. What overflows is never finite again,
 * unless w does, whose reciprocal would be 0. */

/* Column k of the map. */
static inline R NAME(
    column)(const struct kernel_map *m, int k, const R p[3], int terms)
{
	R c = R_ALL((REAL)m->hi[3][k]);

	for (int l = 0; l < terms; l++)
		c = R_FMA(p[l], R_ALL((REAL)m->hi[l][k]), c);
	return c;
}

static inline int NAME(all_finite)(R a)
{
	COLUMN all[R_WIDTH];
	int finite = 1;

	R_STORE(all, a);
	for (int i = 0; i < R_WIDTH; i++)
		finite &= isfinite(all[i]);
	return finite;
}

static inline __attribute__((always_inline)) int NAME(
    plain)(const struct kernel_map *m, const COLUMN *const in[3],
    COLUMN *const out[3], size_t n, enum kernel_kind kind)
{
	const int terms = kernel_terms(kind), columns = kernel_columns(kind);
	const int divide = kernel_divides(kind);
	/* copies, as for the compiler what is stored could change the map */
	const struct kernel_map own = *m;
	R sum = R_ALL(0);

	m = &own;
	for (size_t i = 0; i < n; i += R_WIDTH) {
		R p[3], q[3], w = R_ALL(1), r = w;

		for (int k = 0; k < terms; k++)
			p[k] = R_NEAR(in[k] + i, m->origin[k]);
		if (divide) {
			w = NAME(column)(m, 3, p, terms);
			r = R_ALL(1) / w;
		}
		for (int k = 0; k < columns; k++) {
			q[k] = NAME(column)(m, k, p, terms);
			if (divide)
				q[k] = q[k] * r;
		}
		if (kind == KERNEL_DEPTH) {
			R a = R_ALL((REAL)m->a_hi), b = R_ALL((REAL)m->b_hi);

			q[2] = R_FMA(b, r, a);
		}
		if (divide)
			q[0] = R_POSITIVE(w,
			    R_POSITIVE(R_ALL((REAL)MOST) - w, q[0]));
		for (int k = 0; k < terms; k++) {
			R_STORE(out[k] + i, q[k]);
			sum += q[k];
		}
	}
	return NAME(all_finite)(sum);
}

#define LOOP(KIND, name)                                               \
	static int NAME(name)(const struct kernel_map *m,              \
	    const COLUMN *const in[3], COLUMN *const out[3], size_t n) \
	{                                                              \
		return NAME(plain)(m, in, out, n, KIND);               \
	}

LOOP(KERNEL_FLAT, flat)
LOOP(KERNEL_AFFINE, affine)
LOOP(KERNEL_DEPTH, depth)
LOOP(KERNEL_PROJECTIVE, projective)
#undef LOOP
