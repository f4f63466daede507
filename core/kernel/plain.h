/* The inner loop of double and single, written once for both: copy.h includes it
 * twice. As in exact.h a point is taken relative to the map's origin.
 *
 * With u the unit roundoff and S the sum of a column's products' magnitudes:
 * a point's difference from the origin and a matrix element carry u each, a
 * chain of three products and sums 3 u. So a column is within 5 u S. A quotient
 * N / W carries that of both, and u each for the reciprocal and the product:
 *
 *	|error of N/W| <= PLAIN_BOUND u (S_N + |N/W| S_W) / |W|
 *
 * of which 5 is the columns', 2 the quotient's and 1 for printing the shortest
 * digits of a float: 8. Depth a + b/w is within PLAIN_BOUND u (|a| + |b/W| S_W /
 * |W|): b, the reciprocal, the fused product and sum, and printing carry u each,
 * to which come w's 5 u S_W: 9. Both are so where S_W is |W|. Where it is more, w
 * is known less, to 1/16 as is asked for: dividing by what was computed makes its
 * 5 at most 32/31 as much, and the others weigh less. `make prove` counts all of
 * these. S is not summed, but bounded by the column's largest element times |x| +
 * |y| + |z|. What underflows is off by u TINY at most. */

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
 * so much more of an element, of the image, and of four operations. */
static inline R NAME(most)(const struct kernel_map *m, int k, R size)
{
	double most = m->most[k] + TINY;

	return R_FMA(R_ALL((REAL)most), size,
	    R_ALL((REAL)(m->image[k] + TINY * (4 + 3 * most))));
}

/* a + b / w, and the sum of their sizes. */
static inline R NAME(depth_of)(const struct kernel_map *m, R r, R w_size, R *z)
{
	R a = R_ALL((REAL)m->a_hi), b = R_ALL((REAL)m->b_hi);

	*z = R_FMA(b, r, a);
	return R_FMA(R_ABS(b * r), w_size, R_ABS(a));
}

static inline int NAME(all_below)(R a, double limit)
{
	double all[R_WIDTH];
	int below = 1;

	R_STORE(all, a);
	for (int i = 0; i < R_WIDTH; i++)
		below &= all[i] < limit;
	return below;
}

static inline __attribute__((always_inline)) int NAME(
    plain)(const struct kernel_map *m, const double *const in[3],
    double *const out[3], size_t n, double tolerance, enum kernel_kind kind,
    int bounded)
{
	const int terms = kernel_terms(kind), columns = kernel_columns(kind);
	const int divide = kernel_divides(kind);
	const R cu = R_ALL((REAL)PLAIN_BOUND * ROUNDOFF);
	const R within = R_ALL((REAL)(1 / tolerance));
	const R lost = R_ALL((REAL)(4 * TINY * (double)ROUNDOFF / tolerance));
	const double limit = 1 / tolerance < MOST ? size_limit(m, kind, MOST) :
						    0;
	R largest = R_ALL(0), behind = R_ALL((REAL)-MOST);

	for (size_t i = 0; i < n; i += R_WIDTH) {
		R p[3], q[3], size = R_ALL(0), r = R_ALL(1), error = lost;
		R w_size = r, w = r;

		for (int k = 0; k < terms; k++) {
			p[k] = R_NEAR(in[k] + i, m->origin[k]);
			size += R_ABS(p[k]);
		}
		if (divide) {
			w = NAME(column)(m, 3, p, terms);
			r = R_ALL(1) / w;
			w_size = NAME(most)(m, 3, size) * R_ABS(r);
			error = R_MAX(error, cu * w_size * R_ALL(16));
		}
		for (int k = 0; k < columns; k++) {
			R s = NAME(most)(m, k, size);

			q[k] = NAME(column)(m, k, p, terms);
			if (divide) {
				q[k] = q[k] * r;
				s = R_FMA(R_ABS(q[k]), w_size, s * R_ABS(r));
			}
			error = R_MAX(error, cu * s * within + lost);
		}
		if (kind == KERNEL_DEPTH) {
			R s = NAME(depth_of)(m, r, w_size, &q[2]);

			error = R_MAX(error, cu * s * within + lost);
		}
		R room = R_ALL((REAL)limit) - size;

		largest = R_MAX(size, largest);
		behind = R_MAX(-w, behind);
		for (int k = 0; k < terms; k++) {
			if (divide)
				q[k] = R_POSITIVE(w, q[k]);
			if (bounded && k == 0)
				q[k] = R_POSITIVE(R_ALL(1) - error, q[k]);
			if (k == 0)
				q[k] = R_POSITIVE(room, q[k]);
			R_STORE(out[k] + i, q[k]);
		}
	}
	return NAME(all_below)(largest, limit) &&
	    (!divide || NAME(all_below)(behind, -1 / MOST));
}

#define LOOP(KIND, name)                                                       \
	static int NAME(name)(const struct kernel_map *m,                      \
	    const double *const in[3], double *const out[3], size_t n,         \
	    double tolerance)                                                  \
	{                                                                      \
		if (tolerance > 0)                                             \
			return NAME(plain)(m, in, out, n, tolerance, KIND, 1); \
		return NAME(plain)(m, in, out, n, 1, KIND, 0);                 \
	}

LOOP(KERNEL_FLAT, flat)
LOOP(KERNEL_AFFINE, affine)
LOOP(KERNEL_DEPTH, depth)
LOOP(KERNEL_PROJECTIVE, projective)
#undef LOOP
