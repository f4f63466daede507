/* SPDX-License-Identifier: MIT */
/* Finds the planes that points are outside of: a column of a map is negative outside of
 * its plane. All numbers are doubles, so that the compiler vectorizes the loop. */
#include "kernel.h"

/* Does what signs_kernel says. If low <= size < high, no estimate is nan. */
static inline __attribute__((always_inline)) void add_signs(const struct estimate *e,
    int columns, double weight, const double *const in[3], double *restrict word,
    size_t n)
{
	const double *x = in[0], *y = in[1], *z = in[2];

	for (size_t i = 0; i < n; i++) {
		double a = x[i] - e->origin[0], b = y[i] - e->origin[1];
		double c = z[i] - e->origin[2];
		double size = fabs(a) + fabs(b) + fabs(c), least = (double)INFINITY;
		double sum = word[i];

		for (int j = 0; j < columns; j++) {
			double v = estimate_column(e->m, j, a, b, c);

			least = fabs(v) < least ? fabs(v) : least;
			sum += v < 0 ? weight * (1 << j) : 0;
		}
		bool sure = (size >= e->low) & (size < e->high) &
		    (least > e->slope * size + e->floor);

		word[i] = sum + (sure ? 0 : SIGNS_UNSURE);
	}
}

static void signs(const struct estimate *e, int columns, double weight,
    const double *const in[3], double *word, size_t n)
{
	if (columns == 4)
		add_signs(e, 4, weight, in, word, n);
	else
		add_signs(e, 3, weight, in, word, n);
}
