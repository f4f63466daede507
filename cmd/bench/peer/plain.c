/* SPDX-License-Identifier: MIT */
/* No library: the loop over columns that anybody would write, and the same loop over
 * points in place. The compiler vectorizes both. */
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

#define ROW(m, i, x, y, z) (m[i][0] * x + m[i][1] * y + m[i][2] * z + m[i][3])

#define LOOPS(carry, in_place, real)                                                   \
	static void carry(const void *in, void *out, size_t n)                         \
	{                                                                              \
		const real *restrict x = in, *y = x + PEER_BLOCK, *z = y + PEER_BLOCK; \
		real *restrict p = out, *q = p + PEER_BLOCK, *r = q + PEER_BLOCK,      \
			       m[4][4];                                                \
                                                                                       \
		for (int i = 0; i < 16; i++)                                           \
			m[i / 4][i % 4] = (real)matrix[i / 4][i % 4];                  \
		for (size_t i = 0; i < n; i++) {                                       \
			real w = 1 / ROW(m, 3, x[i], y[i], z[i]);                      \
                                                                                       \
			p[i] = ROW(m, 0, x[i], y[i], z[i]) * w;                        \
			q[i] = ROW(m, 1, x[i], y[i], z[i]) * w;                        \
			r[i] = ROW(m, 2, x[i], y[i], z[i]) * w;                        \
		}                                                                      \
	}                                                                              \
	static void in_place(void *points, size_t n)                                   \
	{                                                                              \
		real(*p)[3] = points, m[4][4];                                         \
                                                                                       \
		for (int i = 0; i < 16; i++)                                           \
			m[i / 4][i % 4] = (real)matrix[i / 4][i % 4];                  \
		for (size_t i = 0; i < n; i++) {                                       \
			real x = p[i][0], y = p[i][1], z = p[i][2];                    \
			real w = 1 / ROW(m, 3, x, y, z);                               \
                                                                                       \
			p[i][0] = ROW(m, 0, x, y, z) * w;                              \
			p[i][1] = ROW(m, 1, x, y, z) * w;                              \
			p[i][2] = ROW(m, 2, x, y, z) * w;                              \
		}                                                                      \
	}

LOOPS(carry_double, in_place_double, double)
LOOPS(carry_float, in_place_float, float)

const struct peer peers_plain[] = {
	{ "loop, double", NULL, false, { COLUMNS }, prepare, carry_double,
	    in_place_double },
	{ "loop, float", NULL, true, { COLUMNS }, prepare, carry_float,
	    in_place_float },
	{ 0 },
};
