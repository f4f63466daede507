/* SPDX-License-Identifier: MIT */
/* The result of each operation has the right bound of its error, and sum_sign returns
 * 0 for a sum that is not above its bound. */
#include "../exact/sum.h"

#include "numbers.h"

/* Returns a 0. The bound of its error is SUM_QUOTIENT_ERROR, an exponent: see sum.h. */
static struct sum inexact_zero(void)
{
	struct sum one = sum_with_error(sum_of_double(1), SUM_QUOTIENT_ERROR);

	return sum_sub(one, sum_of_double(1));
}

/* Asserts that the bound of the error of a zero is 2^e times that of
 * SUM_QUOTIENT_ERROR, by the greatest number that counts as 0 when it is added. */
static void assert_error_bound(struct sum zero_with_error, int e)
{
	double greatest_zero = ldexp(1, SUM_QUOTIENT_ERROR - EX_RANGE + e);

	for (int minus = 0; minus < 2; minus++) {
		struct sum least = sum_of_double(nextafter(greatest_zero, HUGE_VAL));
		struct sum off = sum_add(zero_with_error, sum_of_double(greatest_zero));

		assert_int_equal(sum_sign(off), 0);
		assert_number(sum_double(off), 0);
		assert_true(sum_snap_zero(off).value.n == 0);
		off = sum_add(zero_with_error, sum_negated_if(minus, least));
		assert_int_equal(sum_sign(off), minus ? -1 : 1);
		assert_true(sum_double(off) ==
		    (minus ? -1 : 1) * nextafter(greatest_zero, HUGE_VAL));
		zero_with_error = sum_neg(zero_with_error);
	}
}

static void operations_keep_error_bounds(void **state)
{
	const struct sum zero_with_error = inexact_zero();
	const struct sum eight = sum_of_double(-8);

	(void)state;
	assert_error_bound(zero_with_error, 0);
	assert_error_bound(sum_mul(zero_with_error, eight), 3);
	assert_error_bound(sum_mul(eight, zero_with_error), 3);
	assert_error_bound(sum_quotient(zero_with_error, eight), -3);
	assert_error_bound(sum_add(zero_with_error, zero_with_error), 1);
	assert_error_bound(sum_sub(zero_with_error, sum_neg(zero_with_error)), 1);
	assert_error_bound(sum_mul(sum_mul(zero_with_error, eight), eight), 6);
	assert_error_bound(sum_mul(sum_add(zero_with_error, sum_of_double(4)),
			       zero_with_error),
	    2);
	assert_error_bound(sum_mul(zero_with_error, zero_with_error),
	    SUM_QUOTIENT_ERROR - EX_RANGE);
	for (int n = 1; n <= 4; n++) {
		const struct sum a[5] = { eight, zero_with_error, eight,
			zero_with_error, eight };
		struct sum r;

		sum_dot(n, a, a + 1, 1, &r);
		/* bounds are powers of two: that of three errors is that of four */
		assert_error_bound(sum_quotient(r, sum_of_double(n)), 3 + (n == 3));
	}
}

static void tests_for_zero_and_one(void **state)
{
	struct sum zero_with_error = inexact_zero(), zero = sum_of_double(0);
	struct sum one = sum_of_double(1);

	(void)state;
	assert_true(sum_is_exact_zero(&zero));
	assert_false(sum_is_exact_zero(&zero_with_error));
	assert_false(sum_is_exact_zero(&one));
	zero = sum_mul(zero, zero_with_error);
	assert_true(sum_is_exact_zero(&zero));
	zero = sum_sub(one, one);
	assert_true(sum_is_exact_zero(&zero));
	assert_true(sum_is_one(&one));
	assert_true(sum_is_power_of_two(&one));
	one = sum_add(one, zero_with_error);
	assert_false(sum_is_one(&one));
	assert_false(sum_is_power_of_two(&one));
	one = sum_of_double(3);
	assert_false(sum_is_power_of_two(&one));
}

/* Roots and quotients that fit the words of a sum are exact. Others have an error. */
static void short_roots_and_quotients_are_exact(void **state)
{
	(void)state;
	assert_int_equal(sum_sqrt(sum_of_double(2.25)).error, 0);
	assert_int_equal(sum_quotient(sum_of_double(6), sum_of_double(3)).error, 0);
	struct sum root = sum_sqrt(sum_of_double(4 + 0x1p-50));
	struct sum third = sum_quotient(sum_of_double(1), sum_of_double(3));

	assert_int_equal(root.error, 2 + SUM_QUOTIENT_ERROR);
	assert_int_equal(third.error, -1 + SUM_QUOTIENT_ERROR);
	assert_int_equal(sum_sign(
			     sum_sub(sum_mul(root, root), sum_of_double(4 + 0x1p-50))),
	    0);
	assert_int_equal(sum_sign(sum_sub(sum_mul(third, sum_of_double(3)),
			     sum_of_double(1))),
	    0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(operations_keep_error_bounds),
		cmocka_unit_test(tests_for_zero_and_one),
		cmocka_unit_test(short_roots_and_quotients_are_exact),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
