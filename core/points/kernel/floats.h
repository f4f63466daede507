/* SPDX-License-Identifier: MIT */
/* Transforms rows of floats to rows of floats in PRECISION_SINGLE, with the bits of
 * single_plain. */
#include "little.h"

/* Transforms n rows. are_floats says that the origin's coordinates are floats; then a
 * float subtraction gives the same bits. A difference of two floats that is not a
 * double is so near to the larger float that one or two roundings give this float. */
static inline __attribute__((always_inline)) int
floats(const struct kernel_map *m, const char *in, char *out, size_t n,
    enum kernel_kind kind, bool are_floats)
{
	const size_t terms = (size_t)kernel_inputs(kind);
	const struct kernel_map own = *m;
	float column[3][POINTS_BLOCK];
	int beyond = 0;

	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < terms; k++)
			column[k][i] = (float)little_get(in +
				4 * (terms * i + k),
			    false);
	for (size_t i = 0; i < n; i++) {
		float p[3], q[3], sum = 0;

		for (size_t k = 0; k < terms; k++) {
			float a = column[k][i];
			double o = own.origin[k];

			p[k] = are_floats ? a - (float)o :
					    (float)((double)a - o);
		}
		single_image(&own, p, q, kind);
		for (size_t k = 0; k < terms; k++) {
			column[k][i] = q[k];
			sum += q[k];
		}
		beyond |= sum - sum == 0 ? 0 : -1;
	}
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < terms; k++)
			little_put(out + 4 * (terms * i + k), false,
			    (double)column[k][i]);
	return beyond == 0;
}

/* Returns true if v is a float. */
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
			return floats(m, in, out, n, KIND, true);              \
		return floats(m, in, out, n, KIND, false);                     \
	}

LOOP(KERNEL_FLAT, floats_flat)
LOOP(KERNEL_AFFINE, floats_affine)
LOOP(KERNEL_DEPTH, floats_depth)
LOOP(KERNEL_PROJECTIVE, floats_projective)
#undef LOOP
