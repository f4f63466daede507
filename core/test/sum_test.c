/* SPDX-License-Identifier: MIT */
/* A sum's error goes with it through each operation, and a difference that is not
 * above the error is none. */
#include "../exact/sum.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include "numbers.h"

/* Returns a 0 with an error of SUM_QUOTIENT_ERROR. */
static struct sum nothing_of_one(void)
{
	struct sum one = sum_with_error(ex_of(1), SUM_QUOTIENT_ERROR);

	return sum_sub(one, sum_of_double(1));
}

/* Asserts an error of 2^e SUM_QUOTIENT_ERROR: the greatest difference that counts as 0. */
static void assert_error(struct sum nothing, int e)
{
	double none = ldexp(1, SUM_QUOTIENT_ERROR - EX_RANGE + e);

	for (int minus = 0; minus < 2; minus++) {
		struct sum least = sum_of_double(nextafter(none, HUGE_VAL));
		struct sum off = sum_add(nothing, sum_of_double(none));

		assert_int_equal(sum_sign(off), 0);
		assert_number(sum_double(off), 0);
		assert_true(sum_snap_zero(off).value.n == 0);
		off = sum_add(nothing, sum_negated_if(minus, least));
		assert_int_equal(sum_sign(off), minus ? -1 : 1);
		assert_true(sum_double(off) ==
		    (minus ? -1 : 1) * nextafter(none, HUGE_VAL));
		nothing = sum_neg(nothing);
	}
}

static void errors_go_with_sums(void **state)
{
	const struct sum nothing = nothing_of_one();
	const struct sum eight = sum_of_double(-8);

	(void)state;
	assert_error(nothing, 0);
	assert_error(sum_mul(nothing, eight), 3);
	assert_error(sum_mul(eight, nothing), 3);
	assert_error(sum_quotient(nothing, eight), -3);
	assert_error(sum_add(nothing, nothing), 1);
	assert_error(sum_sub(nothing, sum_neg(nothing)), 1);
	assert_error(sum_mul(sum_mul(nothing, eight), eight), 6);
	assert_error(sum_mul(sum_add(nothing, sum_of_double(4)), nothing), 2);
	assert_error(sum_mul(nothing, nothing), SUM_QUOTIENT_ERROR - EX_RANGE);
	for (int n = 1; n <= 4; n++) {
		const struct sum a[5] = { eight, nothing, eight, nothing,
			eight };
		struct sum r;

		sum_dot(n, a, a + 1, 1, &r);
		/* the bound of three errors is that of four */
		assert_error(sum_quotient(r, sum_of_double(n)), 3 + (n == 3));
	}
}

static void what_is_nothing(void **state)
{
	struct sum nothing = nothing_of_one(), zero = sum_of_double(0);
	struct sum one = sum_of_double(1);

	(void)state;
	assert_true(sum_is_exact_zero(&zero));
	assert_false(sum_is_exact_zero(&nothing));
	assert_false(sum_is_exact_zero(&one));
	zero = sum_mul(zero, nothing);
	assert_true(sum_is_exact_zero(&zero));
	zero = sum_sub(one, one);
	assert_true(sum_is_exact_zero(&zero));
	assert_true(sum_is_one(&one));
	assert_true(sum_is_power_of_two(&one));
	one = sum_add(one, nothing);
	assert_false(sum_is_one(&one));
	assert_false(sum_is_power_of_two(&one));
	one = sum_of_double(3);
	assert_false(sum_is_power_of_two(&one));
}

/* Roots that are short are exact, as are quotients; others have an error. */
static void what_is_exact(void **state)
{
	(void)state;
	assert_int_equal(sum_sqrt(sum_of_double(2.25)).error, 0);
	assert_int_equal(sum_quotient(sum_of_double(6), sum_of_double(3)).error,
	    0);
	struct sum root = sum_sqrt(sum_of_double(4 + 0x1p-50));
	struct sum third = sum_quotient(sum_of_double(1), sum_of_double(3));

	assert_int_equal(root.error, 2 + SUM_QUOTIENT_ERROR);
	assert_int_equal(third.error, -1 + SUM_QUOTIENT_ERROR);
	assert_int_equal(sum_sign(sum_sub(sum_mul(root, root),
			     sum_of_double(4 + 0x1p-50))),
	    0);
	assert_int_equal(sum_sign(sum_sub(sum_mul(third, sum_of_double(3)),
			     sum_of_double(1))),
	    0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(errors_go_with_sums),
		cmocka_unit_test(what_is_nothing),
		cmocka_unit_test(what_is_exact),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
