/* SPDX-License-Identifier: MIT */
/* gcc 12 compiles these functions wrongly without the flags of the Makefile. If a test
 * fails, the output of a program of this compiler is not to be trusted. */
#include "claims.h"

/* Keeps gcc, or clang, from analysing and inlining a function. */
#if __has_attribute(noipa)
#define OPAQUE __attribute__((noipa))
#else
#define OPAQUE __attribute__((noinline))
#endif

struct pair {
	double hi, lo;
};

struct pairs {
	struct pair m[5][4];
	double sum[5][4];
};

OPAQUE static double same_value(double a)
{
	return a;
}

OPAQUE static struct pair pair(double a, double b)
{
	return (struct pair){ a, b };
}

/* From -O1 on, gcc 12 does not store to sum without the flags: it counts the addresses
 * in the loop from 0, as the calls make the arguments known. */
static __attribute__((noinline)) void combine(struct pairs *r, int j,
    const struct pairs *m, int k)
{
	for (int i = 0; i < 5; i++) {
		double x = same_value(m->m[i][k].hi) + same_value(m->m[i][k].lo);
		double w = same_value(m->m[i][3].hi) + same_value(m->m[i][3].lo);

		r->m[i][j] = pair(x, w);
		r->sum[i][j] = m->sum[i][k] + m->sum[i][3];
	}
}

static void loops_store(void **state)
{
	struct pairs m, r = { .sum = { { 0 } } };

	(void)state;
	for (int i = 0; i < 20; i++) {
		m.m[i / 4][i % 4] = (struct pair){ 1, 2 };
		m.sum[i / 4][i % 4] = 5;
	}
	for (int k = 0; k < 4; k++)
		combine(&r, k, &m, k);
	for (int i = 0; i < 20; i++) {
		assert_number(r.m[i / 4][i % 4].hi, 3);
		assert_number(r.sum[i / 4][i % 4], 10);
	}
}

/* Without the flags, at -O2, gcc 12 does not round to float: it makes a vector of the
 * two doubles. */
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
