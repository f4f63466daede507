/* SPDX-License-Identifier: MIT */
/* CPU time for the benchmarks. The minimum of many runs is the machine at its best, the
 * median its usual speed. */
#pragma once

#include <stdlib.h>
#include <time.h>

struct timing {
	double min, median;
};

static inline double clock_ns(void)
{
	struct timespec t;

	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
	return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static inline int clock_compare(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

static inline struct timing timing_of(double *times, size_t n)
{
	qsort(times, n, sizeof *times, clock_compare);
	return (struct timing){ times[0], times[n / 2] };
}
