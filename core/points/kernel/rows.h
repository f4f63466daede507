/* SPDX-License-Identifier: MIT */
/* Copies points from rows, as files have them (x y z, x y z, ...), to columns, and
 * back. `numbers`, the numbers per row, is a constant, so that compilers turn the loops
 * into shuffles. Rows may begin at any address. */
#include <float.h>
#include <stdint.h>

#include "little.h"
#include "midway.h"

static inline __attribute__((always_inline)) int to_columns(const char *restrict rows,
    double (*restrict columns)[POINTS_BLOCK], size_t n, double max, size_t numbers,
    bool is_double)
{
	int64_t above = 0;

	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < numbers; k++) {
			double v = little_get(rows, is_double);

			rows += is_double ? 8 : 4;
			columns[k][i] = v;
			above |= fabs(v) > max ? -1 : 0;
		}
	return above == 0;
}

/* Returns true only if each double of a column rounds to a finite float, and this float
 * is surely the nearest to the exact value from which the double was rounded. */
static inline __attribute__((always_inline)) int
column_rounds_to_floats(const double *restrict column, size_t n)
{
	int64_t unsure = 0;

	for (size_t i = 0; i < n; i++) {
		unsure |= fabs(column[i]) <= (double)FLT_MAX ? 0 : -1;
		unsure |= is_midway(column[i]) ? -1 : 0;
	}
	return unsure == 0;
}

static inline __attribute__((always_inline)) int
to_rows(double (*restrict columns)[POINTS_BLOCK], char *restrict rows, size_t n,
    size_t numbers, bool is_double)
{
	int64_t unsure = 0;

	for (size_t k = 0; k < numbers && !is_double; k++)
		unsure |= !column_rounds_to_floats(columns[k], n);
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < numbers; k++) {
			double v = columns[k][i];

			little_put(rows, is_double, v);
			rows += is_double ? 8 : 4;
			unsure |= !is_double || fabs(v) <= DBL_MAX ? 0 : -1;
		}
	return unsure == 0;
}

#define ROWS(name, numbers, is_double)                                                 \
	static int to_columns_##name(const char *rows, double(*columns)[POINTS_BLOCK], \
	    size_t n, double max)                                                      \
	{                                                                              \
		return to_columns(rows, columns, n, max, numbers, is_double);          \
	}                                                                              \
	static int to_rows_##name(double(*columns)[POINTS_BLOCK], char *rows,          \
	    size_t n)                                                                  \
	{                                                                              \
		return to_rows(columns, rows, n, numbers, is_double);                  \
	}

ROWS(floats_2, 2, false)
ROWS(floats_3, 3, false)
ROWS(floats_4, 4, false)
ROWS(doubles_2, 2, true)
ROWS(doubles_3, 3, true)
ROWS(doubles_4, 4, true)
#undef ROWS
