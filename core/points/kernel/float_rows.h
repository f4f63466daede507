/* SPDX-License-Identifier: MIT */
/* Transforms rows of floats to rows of floats in PRECISION_SINGLE, and gives the same
 * bits as single_approx of approx.h. */
#include "little.h"

/* Transforms n rows. Subtracts the origin in float if `origin_is_float` tells that its
 * coordinates are values of floats. This gives the bits of a difference of doubles that
 * is rounded to float: if no double equals a difference of two floats, the difference
 * is so near to the larger float that both ways round to this float. */
static inline __attribute__((always_inline)) int float_rows(const struct kernel_map *m,
    const char *in, char *out, size_t n, enum kernel_kind kind, bool origin_is_float)
{
	const size_t terms = (size_t)kernel_inputs(kind);
	const struct kernel_map map = *m;
	float column[3][POINTS_BLOCK];
	int nonfinite = 0;

	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < terms; k++)
			column[k][i] = (float)little_get(in + 4 * (terms * i + k),
			    false);
	for (size_t i = 0; i < n; i++) {
		float p[3], q[3], sum = 0;

		for (size_t k = 0; k < terms; k++) {
			float a = column[k][i];
			double o = map.origin[k];

			p[k] = origin_is_float ? a - (float)o : (float)((double)a - o);
		}
		single_image(&map, p, q, kind);
		for (size_t k = 0; k < terms; k++) {
			column[k][i] = q[k];
			sum += q[k];
		}
		nonfinite |= sum - sum == 0 ? 0 : -1;
	}
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < terms; k++)
			little_put(out + 4 * (terms * i + k), false,
			    (double)column[k][i]);
	return nonfinite == 0;
}

static bool is_float(double v)
{
	return (double)(float)v == v;
}

#define LOOP(KIND, name)                                                       \
	static int name(const struct kernel_map *m, const char *in, char *out, \
	    size_t n)                                                          \
	{                                                                      \
		const double *o = m->origin;                                   \
                                                                               \
		if (is_float(o[0]) && is_float(o[1]) && is_float(o[2]))        \
			return float_rows(m, in, out, n, KIND, true);          \
		return float_rows(m, in, out, n, KIND, false);                 \
	}

LOOP(KERNEL_FLAT, float_rows_flat)
LOOP(KERNEL_AFFINE, float_rows_affine)
LOOP(KERNEL_DEPTH, float_rows_depth)
LOOP(KERNEL_PROJECTIVE, float_rows_projective)
#undef LOOP
