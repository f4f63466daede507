/* SPDX-License-Identifier: MIT */
/* The kernels of double and of single precision, written once: copy.h includes this
 * file for each of the two. p is a point's difference from the map's origin.
 *
 * Let u be the unit roundoff and S the sum of the magnitudes of a column's products. A
 * point's difference from the origin has a relative error of u, a matrix element one of
 * u, and a chain of three products and sums one of 3 u. So the error of a column is at
 * most 5 u S. A quotient N / W of columns, whose S are S_N and S_W, has the errors of N
 * and W, plus u for the reciprocal of W and u for the product of N and the reciprocal:
 *
 *	|error of N/W| <= APPROX_BOUND u (S_N + |N/W| S_W) / |W|
 *
 * Columns take 5 u of this bound, the quotient 2 u, and printing the shortest digits 1
 * u, together 8 u. The error of a depth a + b/W (KERNEL_DEPTH) is at most APPROX_BOUND
 * u (|a| + |b/W| S_W / |W|). If S_W is |W|, W takes 5 u of this bound, and each of b,
 * the reciprocal, the fused multiply-add, and printing takes u, together 9 u. If S_W is
 * larger, W has a larger relative error, up to 1/32, as error_bound.c requires
 * APPROX_BOUND u S_W / |W| < 1/16. Division by the computed W then makes the 5 u at
 * most 32/31 as large, and the other 4 u weigh less. `make prove` counts these errors,
 * and error_bound.c bounds S for a scene. An underflow adds at most u times the least
 * normal number. A value that overflows never becomes finite again, except w, whose
 * reciprocal is 0. So x of the image becomes nan if w is not below W_MAX. */

/* Returns the product of (p, 1) and column k of the matrix; p has `terms` elements. */
static inline REAL NAME(
    column)(const struct kernel_map *m, int k, const REAL p[3], int terms)
{
	REAL c = (REAL)m->hi[3][k];

	for (int l = 0; l < terms; l++)
		c = R_FMA(p[l], (REAL)m->hi[l][k], c);
	return c;
}

/* Writes the image q of the point p. */
static inline __attribute__((always_inline)) void NAME(
    image)(const struct kernel_map *m, const REAL p[3], REAL q[3],
    enum kernel_kind kind)
{
	const int terms = kernel_inputs(kind);
	REAL w = 1, r = 1;

	if (kernel_divides(kind)) {
		w = NAME(column)(m, 3, p, terms);
		r = 1 / w;
	}
	for (int k = 0; k < terms; k++)
		q[k] = NAME(column)(m, k, p, terms) * r;
	if (kind == KERNEL_DEPTH)
		q[2] = R_FMA((REAL)m->b, r, (REAL)m->a);
	if (kernel_divides(kind)) {
		REAL nan_if_large = w < W_MAX ? 0 : (REAL)NAN;

		q[0] += w > 0 ? nan_if_large : (REAL)NAN;
	}
}

static inline __attribute__((always_inline)) int NAME(
    approx)(const struct kernel_map *m, const double *const in[3], double *restrict x,
    double *restrict y, double *restrict z, size_t n, enum kernel_kind kind)
{
	const int terms = kernel_inputs(kind);
	/* copies: the compiler knows that stores to x, y and z do not change them */
	const double *const from[3] = { in[0], in[1], in[2] };
	const struct kernel_map map = *m;
	int nonfinite = 0;

	for (size_t i = 0; i < n; i++) {
		REAL p[3], q[3], sum = 0;

		for (int k = 0; k < terms; k++)
			p[k] = (REAL)(from[k][i] - map.origin[k]);
		NAME(image)(&map, p, q, kind);
		x[i] = (double)q[0];
		y[i] = (double)q[1];
		if (terms > 2)
			z[i] = (double)q[2];
		for (int k = 0; k < terms; k++)
			sum += q[k];
		nonfinite |= sum - sum == 0 ? 0 : -1;
	}
	return nonfinite == 0;
}

#define LOOP(KIND, name)                                                             \
	static int NAME(name)(const struct kernel_map *m, const double *const in[3], \
	    double *const out[3], size_t n)                                          \
	{                                                                            \
		return NAME(approx)(m, in, out[0], out[1], out[2], n, KIND);         \
	}

LOOP(KERNEL_FLAT, flat)
LOOP(KERNEL_AFFINE, affine)
LOOP(KERNEL_DEPTH, depth)
LOOP(KERNEL_PROJECTIVE, projective)
#undef LOOP
