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
 * is known less, to 1/16 as is asked for: dividing by what was computed makes its
 * 5 at most 32/31 as much, and the others weigh less. `make prove` counts all of
 * these. S is not summed, but bounded by the column's largest element times |x| +
 * |y| + |z|. What underflows is off by u TINY at most. What overflows is never
 * finite again, unless w does, whose reciprocal would be 0. */

/* Column k of the map. */
static inline R NAME(
    column)(const struct kernel_map *m, int k, const R p[3], int terms)
{
	R c = R_ALL((REAL)m->hi[3][k]);

	for (int l = 0; l < terms; l++)
		c = R_FMA(p[l], R_ALL((REAL)m->hi[l][k]), c);
	return c;
}

/* What its S is at most, for size = |x| + |y| + |z|; what underflows counts as
 * so much more of an element, of the image, and of four operations. Not fused, as
 * that is a call where there is no instruction for it. */
static inline R NAME(most)(const struct kernel_map *m, int k, R size)
{
	double most = m->most[k] + TINY;

	return R_ALL((REAL)most) * size +
	    R_ALL((REAL)(m->image[k] + TINY * (4 + 3 * most)));
}

/* The largest error of an image q, each coordinate's in units of its tolerance;
 * above 1, too, where w isn't known to 1/16. scale is PLAIN_BOUND u over
 * the tolerance.
 *
 * R_MAX(a, b) is b where a is nan: an error that is nan is lost if another comes after
 * it. It is nan if q[k] is not finite, which all_finite tells of, and gather, of
 * points.c, looks for in each coordinate; or if w_size is infinite, and then all after
 * it are infinite or nan, too. Otherwise it never is. */
static inline R NAME(error)(const struct kernel_map *m, enum kernel_kind kind,
    R size, R r, const R q[3], const double scale[3])
{
	const int divide = kernel_divides(kind);
	R w_size = r, error = R_ALL(0);

	if (divide) {
		w_size = NAME(most)(m, 3, size) * R_ABS(r);
		error = w_size * R_ALL((REAL)(16 * PLAIN_BOUND * ROUNDOFF));
	}
	for (int k = 0; k < kernel_terms(kind); k++) {
		R s = R_ALL((REAL)fabs(m->a_hi));

		if (k == kernel_columns(kind))
			s += R_ABS(R_ALL((REAL)m->b_hi) * r) * w_size;
		else if (divide)
			s = NAME(most)(m, k, size) * R_ABS(r) +
			    R_ABS(q[k]) * w_size;
		else
			s = NAME(most)(m, k, size);
		error = R_MAX(error, s * R_ALL((REAL)scale[k]));
	}
	return error;
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

/* Without a tolerance, where that is NULL. */
static inline __attribute__((always_inline)) int NAME(
    plain)(const struct kernel_map *m, const COLUMN *const in[3],
    COLUMN *const out[3], size_t n, const double *tolerance,
    enum kernel_kind kind)
{
	const int terms = kernel_terms(kind), columns = kernel_columns(kind);
	const int divide = kernel_divides(kind);
	/* copies, as for the compiler what is stored could change the map */
	const struct kernel_map own = *m;
	double scale[3] = { 0, 0, 0 };
	R sum = R_ALL(0);

	m = &own;

	for (int k = 0; k < terms && tolerance != NULL; k++)
		scale[k] = PLAIN_BOUND * (double)ROUNDOFF /
		    (tolerance[k] - 4 * TINY * (double)ROUNDOFF);
	for (size_t i = 0; i < n; i += R_WIDTH) {
		R p[3], q[3], size = R_ALL(0), w = R_ALL(1), r = w;

		for (int k = 0; k < terms; k++) {
			p[k] = R_NEAR(in[k] + i, m->origin[k]);
			size += R_ABS(p[k]);
		}
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
		R first = q[0];

		if (tolerance != NULL)
			first = R_POSITIVE(R_ALL(1) -
				NAME(error)(m, kind, size, r, q, scale),
			    first);
		if (divide)
			first = R_POSITIVE(w,
			    R_POSITIVE(R_ALL((REAL)MOST) - w, first));
		q[0] = first;
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
		return NAME(plain)(m, in, out, n, NULL, KIND);         \
	}

LOOP(KERNEL_FLAT, flat)
LOOP(KERNEL_AFFINE, affine)
LOOP(KERNEL_DEPTH, depth)
LOOP(KERNEL_PROJECTIVE, projective)
#undef LOOP
