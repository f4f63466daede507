/* SPDX-License-Identifier: MIT */
/* The bounds that dd.h claims, against MPFR. */
#include "claims.h"

enum { TRIES = 20000 };

/* Significands of all kinds, often just above a power of two, and low parts
 * often as large as they can be: there the bounds are nearly reached. */
static dd any(void)
{
	double hi = 1 + sample_unit(), lo = sample_between(-1, 1);

	if (sample_below(2))
		hi = 1 + ldexp(sample_below(64), (int)sample_below(20) - 52);
	if (sample_below(2))
		lo = copysign(1 - 0.01 * sample_unit(), lo);
	lo *= 0x1p-53;
	return dd_scale(fast_two_sum(hi, lo),
	    ldexp(sample_below(2) ? 1 : -1, (int)sample_below(200) - 100));
}

static void error_free(void **state)
{
	(void)state;
	sample_seed(1);
	for (int i = 0; i < TRIES; i++) {
		int mark = real_mark();
		double a = sample_number(150), b = sample_number(150);
		double small = ldexp(a, -(int)sample_below(60));
		real sum = add(number(a), number(b));
		real product = mul(number(a), number(b));

		assert_true(mpfr_equal_p(number_dd(two_sum(a, b)), sum));
		sum = add(number(a), number(small));
		assert_true(
		    mpfr_equal_p(number_dd(fast_two_sum(a, small)), sum));
		if (fabs(a * b) > 0x1p-969)
			assert_true(
			    mpfr_equal_p(number_dd(two_prod(a, b)), product));
		real_release(mark);
	}
}

static double relative(dd got, real exact)
{
	if (mpfr_zero_p(exact))
		return got.hi == 0 ? 0 : (double)INFINITY;
	return mpfr_get_d(over(sub(number_dd(got), exact),
			      mul(magnitude(exact), number(0x1p-106))),
	    MPFR_RNDN);
}

static void bounds(void **state)
{
	double sum = 0, product = 0, quotient = 0;

	(void)state;
	sample_seed(2);
	for (int i = 0; i < TRIES; i++) {
		int mark = real_mark();
		dd a = any(), b = any(), near = a;

		/* terms that cancel */
		near.lo *= sample_unit();
		near.hi = -near.hi;
		if (sample_below(2))
			near = dd_scale(b, 0x1p-40);
		real x = number_dd(a), y = number_dd(b);

		sum = fmax(sum,
		    fabs(relative(dd_add(a, near), add(x, number_dd(near)))));
		product = fmax(product,
		    fabs(relative(dd_mul(a, b), mul(x, y))));
		quotient = fmax(quotient,
		    fabs(relative(dd_div(a, b), over(x, y))));
		real_release(mark);
	}
	claim("dd_add", sum, 3);
	claim("dd_mul", product, 4);
	claim("dd_div", quotient, 9);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(error_free),
		cmocka_unit_test(bounds),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
