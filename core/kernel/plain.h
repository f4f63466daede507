/* The inner loop of double and single, written once for both, relative to the
 * map's origin as exact is: included twice, see kernels_avx2.c.
 *
 * With u the unit roundoff and S the sum of a column's products' sizes, a
 * point's difference from the origin and a matrix element carry u each and a
 * chain of three products and sums 3 u, so a column is within 5 u S; the
 * reciprocal of w and the quotient carry u each, and 1 u more is for printing
 * the shortest digits: |error| of n/w is below PLAIN_BOUND u (S_n + |n/w| S_w)
 * / |w|, while that is below 1/16 for w itself; of a + b/w, below PLAIN_BOUND u
 * (|a| + |b/w| S_w/|w|). S is not summed but bounded, by the largest element
 * times |x| + |y| + |z|. */
static inline __attribute__((always_inline)) void NAME(
    plain)(const struct kernel_map *m, const double *const in[3],
    double *const out[3], size_t n, double tolerance, enum kernel_kind kind,
    int bounded)
{
	const int terms = kind == KERNEL_FLAT ? 2 : 3;
	const int divide = kind == KERNEL_DEPTH || kind == KERNEL_PROJECTIVE;
	const R cu = R_ALL((REAL)PLAIN_BOUND * ROUNDOFF);

	for (size_t i = 0; i < n; i += R_WIDTH) {
		R p[3], q[3], size = R_ALL(0), r = R_ALL(1), error = r;
		R w_size = r, w = r;

		for (int k = 0; k < terms; k++) {
			p[k] = R_NEAR(in[k] + i, m->origin[k]);
			size += R_ABS(p[k]);
		}
		for (int k = 3; k >= 0; k--) {
			if (k == 3 ?
				!divide :
				k >= terms || (k == 2 && kind == KERNEL_DEPTH))
				continue;
			R c = R_ALL((REAL)m->hi[3][k]);

			for (int l = 0; l < terms; l++)
				c = R_FMA(p[l], R_ALL((REAL)m->hi[l][k]), c);
			R s = R_FMA(R_ALL((REAL)m->most[k]), size,
			    R_ALL((REAL)m->sum_image[k]));

			if (k == 3) {
				w = c;
				r = R_ALL(1) / w;
				w_size = s * R_ABS(r);
				error = cu * w_size * R_ALL(16);
				continue;
			}
			q[k] = c;
			if (divide)
				q[k] = c * r;
			if (divide)
				s = R_FMA(R_ABS(q[k]), w_size, s * R_ABS(r));
			s = cu * s * R_ALL((REAL)(1 / tolerance));
			error = k == terms - 1 && !divide ? s : R_MAX(error, s);
		}
		if (kind == KERNEL_DEPTH) {
			R b = R_ALL((REAL)m->b_hi) * r;
			R s = R_FMA(R_ABS(b), w_size,
			    R_ALL((REAL)fabs(m->a_hi)));

			q[2] = R_ALL((REAL)m->a_hi) + b;
			s = cu * s * R_ALL((REAL)(1 / tolerance));
			error = R_MAX(error, s);
		}
		for (int k = 0; k < terms; k++) {
			if (divide)
				q[k] = R_POSITIVE(w, q[k]);
			if (bounded && k == 0)
				q[k] = R_POSITIVE(R_ALL(1) - error, q[k]);
			R_STORE(out[k] + i, q[k]);
		}
	}
}

#define LOOP(KIND, name)                                                \
	static void NAME(name)(const struct kernel_map *m,              \
	    const double *const in[3], double *const out[3], size_t n,  \
	    double tolerance)                                           \
	{                                                               \
		if (tolerance > 0)                                      \
			NAME(plain)(m, in, out, n, tolerance, KIND, 1); \
		else                                                    \
			NAME(plain)(m, in, out, n, 1, KIND, 0);         \
	}

LOOP(KERNEL_FLAT, flat)
LOOP(KERNEL_AFFINE, affine)
LOOP(KERNEL_DEPTH, depth)
LOOP(KERNEL_PROJECTIVE, projective)
#undef LOOP
