/* SPDX-License-Identifier: MIT */
/* Points in rows, x y z after x y z as files have them, to columns and back: loops
 * that compilers turn into shuffles, once they know how long a row is and what
 * the processor has. Rows may begin at any address. */
#include <float.h>
#include <stdint.h>

#include "little.h"
#include "midway.h"

/* Number i of many, doubles if wide, else floats. */
static inline __attribute__((always_inline)) double load(const char *numbers,
    size_t i, int wide)
{
	return wide ? little_double(numbers + 8 * i) :
		      (double)little_float(numbers + 4 * i);
}

static inline __attribute__((always_inline)) int
split(const char *restrict rows, double (*restrict columns)[POINTS_BLOCK],
    size_t n, double most, size_t numbers, int wide)
{
	int64_t beyond = 0;

	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < numbers; k++) {
			double v = load(rows, numbers * i + k, wide);

			columns[k][i] = v;
			beyond |= fabs(v) > most ? -1 : 0;
		}
	return beyond == 0;
}

/* Whether all can be floats that nobody has to look at. */
static inline __attribute__((always_inline)) int
are_sure(const double *restrict column, size_t n)
{
	int64_t unsure = 0;

	for (size_t i = 0; i < n; i++) {
		unsure |= fabs(column[i]) <= (double)FLT_MAX ? 0 : -1;
		unsure |= is_midway(column[i]) ? -1 : 0;
	}
	return unsure == 0;
}

/* -0 becomes 0. */
static inline __attribute__((always_inline)) int
join(double (*restrict columns)[POINTS_BLOCK], char *restrict rows, size_t n,
    size_t numbers, int wide)
{
	int64_t unsure = 0;

	for (size_t k = 0; k < numbers && !wide; k++)
		unsure |= !are_sure(columns[k], n);
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < numbers; k++) {
			double v = columns[k][i] + 0.0;
			float narrow = (float)v + 0.0f;

			if (wide)
				put_little_double(rows + 8 * (numbers * i + k),
				    v);
			else
				put_little_float(rows + 4 * (numbers * i + k),
				    narrow);
			unsure |= !wide || fabs(v) <= DBL_MAX ? 0 : -1;
		}
	return unsure == 0;
}

static inline __attribute__((always_inline)) void
split_single(const char *restrict rows, float (*restrict columns)[POINTS_BLOCK],
    size_t n, size_t numbers)
{
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < numbers; k++)
			columns[k][i] = little_float(
			    rows + 4 * (numbers * i + k));
}

static inline __attribute__((always_inline)) void
join_single(float (*restrict columns)[POINTS_BLOCK], char *restrict rows,
    size_t n, size_t numbers)
{
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < numbers; k++) {
			float v = columns[k][i] + 0.0f;

			put_little_float(rows + 4 * (numbers * i + k), v);
		}
}

#define ROWS(N)                                                                \
	static int split_narrow_##N(const char *rows,                          \
	    double(*columns)[POINTS_BLOCK], size_t n, double most)             \
	{                                                                      \
		return split(rows, columns, n, most, N, 0);                    \
	}                                                                      \
	static int split_wide_##N(const char *rows,                            \
	    double(*columns)[POINTS_BLOCK], size_t n, double most)             \
	{                                                                      \
		return split(rows, columns, n, most, N, 1);                    \
	}                                                                      \
	static int join_narrow_##N(double(*columns)[POINTS_BLOCK], char *rows, \
	    size_t n)                                                          \
	{                                                                      \
		return join(columns, rows, n, N, 0);                           \
	}                                                                      \
	static int join_wide_##N(double(*columns)[POINTS_BLOCK], char *rows,   \
	    size_t n)                                                          \
	{                                                                      \
		return join(columns, rows, n, N, 1);                           \
	}                                                                      \
	static void split_floats_##N(const char *rows,                         \
	    float(*columns)[POINTS_BLOCK], size_t n)                           \
	{                                                                      \
		split_single(rows, columns, n, N);                             \
	}                                                                      \
	static void join_floats_##N(float(*columns)[POINTS_BLOCK], char *rows, \
	    size_t n)                                                          \
	{                                                                      \
		join_single(columns, rows, n, N);                              \
	}

ROWS(2)
ROWS(3)
ROWS(4)
#undef ROWS
