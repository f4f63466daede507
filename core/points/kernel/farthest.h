/* SPDX-License-Identifier: MIT */
/* Finds how far a block of points reaches along some directions. */
#include "kernel.h"

/* Returns the greatest m[0] x + m[1] y + m[2] z of n points. Keeps two maxima, of even
 * and of odd vectors: with a single one, each MAX would wait for the MAX before it. */
static double farthest_along(const double m[3], const double *const in[3], size_t n)
{
	const V a = ALL(m[0]), b = ALL(m[1]), c = ALL(m[2]);
	V even = ALL(-HUGE_VAL), odd = even;

	for (size_t i = 0; i < n; i += 2 * WIDTH) {
		const double *x = in[0] + i, *y = in[1] + i, *z = in[2] + i;
		V v = MADD(a, LOAD(x), MADD(b, LOAD(y), c * LOAD(z)));
		V w = MADD(a, LOAD(x + WIDTH),
		    MADD(b, LOAD(y + WIDTH), c * LOAD(z + WIDTH)));

		even = MAX(v, even);
		odd = MAX(w, odd);
	}
	return greatest_lane(MAX(even, odd));
}

static void farthest(const double (*m)[3], int directions, const double *const in[3],
    size_t n, double *most, double largest[3])
{
	for (int j = 0; j < directions; j++)
		most[j] = farthest_along(m[j], in, n);
	for (int k = 0; k < 3; k++) {
		double low, high;

		find_limits(in[k], n, &low, &high);
		largest[k] = fmax(0, fmax(-low, high));
	}
}
