/* SPDX-License-Identifier: MIT */
/* Sums, products, quotients, roots and rounding of core/exact/ex.c against GMP, for
 * numbers of every length up to EX_WORDS. The command integers_test COUNT makes most
 * tests try 1000 COUNT numbers; without COUNT it is 20. */
#include "claims.h"

#include <gmp.h>
#include <limits.h>
#include <stdlib.h>

#include "arithmetic.h"

static int tries = 20;

/* Returns a number of n words, many of which cause carries and wrong guesses of
 * digits. The exponents leave room for the sum of four products of a number of 54
 * words with one of 14. */
static ex sample_words(int n)
{
	static const uint64_t odd[] = { 0, 1, UINT64_MAX, UINT64_MAX - 1,
		(uint64_t)1 << 63, ((uint64_t)1 << 63) - 1 };
	ex a = { sample_below(2) ? 1 : -1, n, (int)sample_below(21) - 10, { 0 } };

	for (int i = 0; i < n; i++) {
		uint64_t any = (uint64_t)(sample_unit() * 0x1p53) << 11;

		a.word[i] = sample_below(3) == 0 ? any | sample_below(2048) :
						   odd[sample_below(6)];
	}
	for (int i = 0; i<n; i += n> 1 ? n - 1 : 1)
		if (a.word[i] == 0)
			a.word[i] = odd[1 + sample_below(5)];
	return a;
}

static ex sample_up_to(int most)
{
	return sample_words(1 + (int)sample_below((unsigned)most));
}

/* Sets z to a times 2^(64 up), which must be an integer. */
static void set_integer(mpz_t z, const ex *a, int up)
{
	mpz_import(z, (size_t)a->n, -1, 8, 0, 0, a->word);
	mpz_mul_2exp(z, z, (mp_bitcnt_t)(64 * (a->e + up)));
	if (a->sign < 0)
		mpz_neg(z, z);
}

static void assert_integer(const ex *a, int up, const mpz_t expected)
{
	mpz_t got;

	mpz_init(got);
	if (a->n > 0)
		set_integer(got, a, up);
	assert_int_equal(mpz_cmp(got, expected), 0);
	assert_int_equal(a->sign, mpz_sgn(expected));
	assert_true(a->n == 0 || (a->word[0] != 0 && a->word[a->n - 1] != 0));
	mpz_clear(got);
}

enum { UP = 64 }; /* makes every number an integer: no exponent is below -64 */

static void sums_and_products(void **state)
{
	mpz_t x[4], y[4], z;

	(void)state;
	mpz_init(z);
	for (int k = 0; k < 4; k++)
		mpz_inits(x[k], y[k], NULL);
	SAMPLES(i, 1000 * tries) {
		int n = 1 + (int)sample_below(4);
		ex a[4], b[4], r;
		const ex *p[4], *q[4];

		mpz_set_si(z, 0);
		for (int k = 0; k < n; k++) {
			a[k] = sample_up_to(EX_WORDS / 2 - 1);
			b[k] = sample_up_to(EX_WORDS / 2 - 41);
			p[k] = &a[k];
			q[k] = &b[k];
			set_integer(x[k], &a[k], UP);
			set_integer(y[k], &b[k], UP);
			mpz_addmul(z, x[k], y[k]);
		}
		(void)ex_has_overflowed();
		ex_dot(n, p, q, INT_MIN, &r);
		assert_integer(&r, 2 * UP, z);
		mpz_sub(z, x[0], y[0]);
		r = ex_sub(a[0], b[0]);
		assert_integer(&r, UP, z);
		assert_int_equal(ex_compare(a[0], b[0]), mpz_sgn(z));
		mpz_add(z, x[0], y[0]);
		r = ex_add(a[0], b[0]);
		assert_integer(&r, UP, z);
		assert_false(ex_has_overflowed());
	}
	for (int k = 0; k < 4; k++)
		mpz_clears(x[k], y[k], NULL);
	mpz_clear(z);
}

/* ex_has_overflowed is true only after a product that has no room for all its words. */
static void overflow_of_products(void **state)
{
	mpz_t x, y;

	(void)state;
	mpz_inits(x, y, NULL);
	SAMPLES(i, 1000 * tries) {
		ex a = sample_up_to(EX_WORDS), b = sample_up_to(EX_WORDS), r;

		(void)ex_has_overflowed();
		r = ex_mul(a, b);
		bool lost = ex_has_overflowed();

		set_integer(x, &a, UP);
		set_integer(y, &b, UP);
		mpz_mul(x, x, y);
		if (!lost)
			assert_integer(&r, 2 * UP, x);
		else
			assert_true(mpz_sizeinbase(x, 2) - mpz_scan1(x, 0) >
			    64 * (EX_WORDS - 1));
	}
	mpz_clears(x, y, NULL);
}

/* A quotient is truncated, and its last bit is 1 if there is a remainder. */
static void quotients(void **state)
{
	mpz_t x, y, q, rest;

	(void)state;
	mpz_inits(x, y, q, rest, NULL);
	SAMPLES(i, 1000 * tries) {
		ex a = sample_up_to(EX_WORDS), b = sample_up_to(EX_WORDS), r;
		int n = 2 + (int)sample_below(EX_QUOTIENT_WORDS - 1);

		if (sample_below(2)) {
			a = sample_up_to(EX_WORDS / 2);
			b = sample_up_to(EX_WORDS / 2);
			a = ex_mul(a, b);
		}
		bool exact = ex_divide(&a, &b, n, &r);
		int low = a.e + a.n - n - b.e - b.n, sign = a.sign * b.sign;
		int up = b.n + n - a.n;

		a.e = b.e = 0;
		a.sign = b.sign = 1;
		set_integer(x, &a, up > 0 ? up : 0);
		set_integer(y, &b, up > 0 ? 0 : -up);
		mpz_tdiv_qr(q, rest, x, y);
		assert_int_equal(exact, mpz_sgn(rest) == 0);
		if (!exact)
			mpz_setbit(q, 0);
		if (sign < 0)
			mpz_neg(q, q);
		assert_integer(&r, -low, q);
	}
	mpz_clears(x, y, q, rest, NULL);
}

static void roots(void **state)
{
	mpz_t x, y;

	(void)state;
	mpz_inits(x, y, NULL);
	SAMPLES(i, 10 * tries)
		for (int n = 1; n <= EX_WORDS; n++) {
			ex a = sample_words(n);

			a.sign = 1;
			int count = 2 + (int)sample_below(EX_QUOTIENT_WORDS - 1);

			if (n <= count && sample_below(2))
				a = ex_mul(a, a);
			ex r;
			bool exact = ex_sqrt(&a, count, &r);

			/* a - r^2 is at most 2^(3 - 64 (count - 1)) a */
			set_integer(x, &r, 2 * UP);
			mpz_mul(x, x, x);
			set_integer(y, &a, 4 * UP);
			mpz_sub(x, y, x);
			assert_int_equal(exact, mpz_sgn(x) == 0);
			assert_true(mpz_sgn(x) >= 0);
			mpz_mul_2exp(x, x, (mp_bitcnt_t)(64 * count - 67));
			assert_true(mpz_cmp(x, y) <= 0);
		}
	mpz_clears(x, y, NULL);
}

static void rounding(void **state)
{
	mpz_t x;
	mpfr_t f;

	(void)state;
	mpz_init(x);
	mpfr_init2(f, 64 * EX_WORDS);
	SAMPLES(i, 1000 * tries) {
		ex a = sample_up_to(EX_WORDS);

		a.e = -a.n - (int)sample_below(17) + (int)sample_below(17);
		set_integer(x, &a, -a.e);
		mpfr_set_z_2exp(f, x, 64 * a.e, MPFR_RNDN);
		assert_true(ex_nearest(&a, false) == mpfr_get_d(f, MPFR_RNDN));
		assert_true(ex_nearest(&a, true) == (double)mpfr_get_flt(f, MPFR_RNDN));
	}
	mpz_clear(x);
	mpfr_clear(f);
}

int main(int argc, char **argv)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(sums_and_products),
		cmocka_unit_test(overflow_of_products),
		cmocka_unit_test(quotients),
		cmocka_unit_test(roots),
		cmocka_unit_test(rounding),
	};

	if (argc > 1)
		tries = atoi(argv[1]);
	return cmocka_run_group_tests(tests, NULL, NULL);
}
