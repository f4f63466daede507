/* SPDX-License-Identifier: MIT */
/* No library: the loop over columns that anybody would write, which the
 * compiler vectorizes. */
#include <string.h>

#include "peer.h"

/* By default gcc uses vectors of half the width, which take a fifth more time.
 */
#if defined(__AVX512F__) && !defined(__clang__)
#pragma GCC target("prefer-vector-width=512")
#endif

static double matrix[4][4];

static void prepare(const struct view *v)
{
	memcpy(matrix, v->matrix, sizeof matrix);
}

#define CARRY(name, real)                                                              \
	static void name(const void *in, void *out, size_t n)                          \
	{                                                                              \
		const real *restrict x = in, *y = x + PEER_BLOCK, *z = y + PEER_BLOCK; \
		real *restrict p = out, *q = p + PEER_BLOCK, *r = q + PEER_BLOCK,      \
			       m[4][4];                                                \
                                                                                       \
		for (int i = 0; i < 16; i++)                                           \
			m[i / 4][i % 4] = (real)matrix[i / 4][i % 4];                  \
		for (size_t i = 0; i < n; i++) {                                       \
			real w = 1 /                                                   \
			    (m[3][0] * x[i] + m[3][1] * y[i] + m[3][2] * z[i] +        \
				m[3][3]);                                              \
                                                                                       \
			p[i] = (m[0][0] * x[i] + m[0][1] * y[i] + m[0][2] * z[i] +     \
				   m[0][3]) *                                          \
			    w;                                                         \
			q[i] = (m[1][0] * x[i] + m[1][1] * y[i] + m[1][2] * z[i] +     \
				   m[1][3]) *                                          \
			    w;                                                         \
			r[i] = (m[2][0] * x[i] + m[2][1] * y[i] + m[2][2] * z[i] +     \
				   m[2][3]) *                                          \
			    w;                                                         \
		}                                                                      \
	}

CARRY(carry_double, double)
CARRY(carry_float, float)

const struct peer peers_plain[] = {
	{ "loop, double", NULL, false, { COLUMNS }, prepare, carry_double },
	{ "loop, float", NULL, true, { COLUMNS }, prepare, carry_float },
	{ 0 },
};
