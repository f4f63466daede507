/* SPDX-License-Identifier: MIT */
/* Finds how far a block of points reaches along some directions. */
#include "kernel.h"

/* Returns the greatest m[0] x + m[1] y + m[2] z of n points, as find_limits does. */
static double farthest_along(const double m[3], const double *const in[3], size_t n)
{
	const V a = ALL(m[0]), b = ALL(m[1]), c = ALL(m[2]);
	V most[2] = { ALL(-HUGE_VAL), ALL(-HUGE_VAL) };

	for (size_t i = 0; i < n; i += 2 * WIDTH)
		for (size_t k = 0; k < 2; k++) {
			const size_t at = i + k * WIDTH;
			V v = MADD(b, LOAD(in[1] + at), c * LOAD(in[2] + at));

			most[k] = MAX(MADD(a, LOAD(in[0] + at), v), most[k]);
		}
	return greatest_lane(MAX(most[0], most[1]));
}

static void block_reach(const double (*m)[3], int directions, const double *const in[3],
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
