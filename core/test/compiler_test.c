/* SPDX-License-Identifier: MIT */
/* gcc 12 compiles this code wrongly without the flags of the Makefile. If one
 * of these tests fails, no output of this compiler is to be trusted. */
#include "claims.h"
#include "numbers.h"

/* Hides a function from its callers, in gcc's words or in clang's. */
#if __has_attribute(noipa)
#define OPAQUE __attribute__((noipa))
#else
#define OPAQUE __attribute__((noinline))
#endif

struct cell {
	double hi, lo;
};

struct table {
	struct cell m[5][4];
	double sum[5][4];
};

OPAQUE static double value(double a)
{
	return a;
}

OPAQUE static struct cell cell(double a, double b)
{
	return (struct cell){ a, b };
}

/* From -O1 on, gcc 12 leaves sum as it was: it counts the addresses of the loop from 0,
 * where the call makes both maps and columns known. */
static __attribute__((noinline)) void combine(struct table *r, int j,
    const struct table *m, int k)
{
	for (int i = 0; i < 5; i++) {
		double x = value(m->m[i][k].hi) + value(m->m[i][k].lo);
		double w = value(m->m[i][3].hi) + value(m->m[i][3].lo);

		r->m[i][j] = cell(x, w);
		r->sum[i][j] = m->sum[i][k] + m->sum[i][3];
	}
}

static void loops_store(void **state)
{
	struct table m, r = { .sum = { { 0 } } };

	(void)state;
	for (int i = 0; i < 20; i++) {
		m.m[i / 4][i % 4] = (struct cell){ 1, 2 };
		m.sum[i / 4][i % 4] = 5;
	}
	for (int k = 0; k < 4; k++)
		combine(&r, k, &m, k);
	for (int i = 0; i < 20; i++) {
		assert_number(r.m[i / 4][i % 4].hi, 3);
		assert_number(r.sum[i / 4][i % 4], 10);
	}
}

/* At -O2, gcc 12 leaves them doubles: it makes a vector of them. */
OPAQUE static void round_two(double *restrict q, const double *p)
{
	q[0] = (double)(float)p[0];
	q[1] = (double)(float)p[1];
}

static void floats_are_rounded(void **state)
{
	const double p[2] = { 0.1, 0.3 };
	double q[2];

	(void)state;
	round_two(q, p);
	for (int i = 0; i < 2; i++) {
		volatile float narrow = (float)p[i];

		assert_true(q[i] == (double)narrow);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(loops_store),
		cmocka_unit_test(floats_are_rounded),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
