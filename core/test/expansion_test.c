/* Expansions against MPFR: sums and products exact, the rest within the bounds
 * that expansion.h claims. */
#include "claims.h"

enum { TRIES = 3000 };

/* A polynomial of numbers from 10^-e to 10^e, whose last steps may cancel all
 * but the smallest of its terms. */
static ex polynomial(int e, real *exact)
{
	ex a = ex_of(0);
	real r = number(0);

	for (int i = 0; i < 6; i++) {
		double x = sample_number(e), y = sample_number(e);

		if (sample_below(3) == 0) {
			a = ex_scale(a, x);
			r = mul(r, number(x));
		}
		a = ex_add(a, ex_mul(ex_of(x), ex_diff(y, x)));
		r = add(r, mul(number(x), sub(number(y), number(x))));
		if (sample_below(3) == 0) {
			ex b = ex_mul(ex_diff(x, -y), ex_of(y));

			a = ex_sub(ex_add(a, b), ex_neg(b));
			r = add(r,
			    mul(number(2),
				mul(number(y), add(number(x), number(y)))));
		}
	}
	*exact = r;
	return a;
}

static double relative(real got, real exact)
{
	if (mpfr_zero_p(exact))
		return mpfr_zero_p(got) ? 0 : (double)INFINITY;
	return fabs(mpfr_get_d(over(sub(got, exact), exact), MPFR_RNDN));
}

static void exact(void **state)
{
	(void)state;
	sample_seed(1);
	for (int i = 0; i < TRIES; i++) {
		int mark = real_mark();
		real r;
		ex a = polynomial(i % 20, &r);

		assert_true(mpfr_equal_p(number_ex(a), r));
		assert_int_equal(ex_sign(a), mpfr_sgn(r));
		assert_true(mpfr_equal_p(number_ex(ex_neg(a)), negative(r)));
		assert_true(mpfr_equal_p(number_ex(ex_abs(a)), magnitude(r)));
		assert_int_equal(ex_sign(ex_sub(a, a)), 0);
		real_release(mark);
	}
}

/* Sums of so many numbers that their products have more terms than are kept
 * before those are filled up. */
static void full(void **state)
{
	(void)state;
	sample_seed(4);
	for (int i = 0; i < TRIES / 100; i++) {
		int mark = real_mark();
		ex a[2] = { ex_of(0), ex_of(0) };
		real r[2] = { number(0), number(0) };

		for (int j = 0; j < 2 * 12; j++) {
			double x = ldexp(sample_between(-1, 1), -(j / 2 * 50));

			a[j % 2] = ex_add(a[j % 2], ex_of(x));
			r[j % 2] = add(r[j % 2], number(x));
		}
		assert_true(mpfr_equal_p(number_ex(ex_mul(a[0], a[1])),
		    mul(r[0], r[1])));
		real_release(mark);
	}
}

/* What is lost of mixed magnitudes is far below the largest term. */
static void wide(void **state)
{
	double worst = 0;

	(void)state;
	sample_seed(2);
	for (int i = 0; i < TRIES; i++) {
		int mark = real_mark();
		ex a = ex_of(0);
		real r = number(0), size = number(0x1p-1000);

		for (int j = 0; j < 6; j++) {
			double x = sample_number(150), y = sample_number(150);
			double z = sample_number(150);
			real p = mul(mul(number(x), number(y)),
			    sub(number(x), number(z)));

			a = ex_add(a,
			    ex_mul(ex_mul(ex_of(x), ex_of(y)), ex_diff(x, z)));
			r = add(r, p);
			size = add(size, magnitude(p));
		}
		real lost = over(magnitude(sub(number_ex(a), r)), size);

		mpfr_mul_2si(lost, lost, 1370, MPFR_RNDU);
		worst = fmax(worst, mpfr_get_d(lost, MPFR_RNDU));
		real_release(mark);
	}
	claim("lost, in 2^-1370", worst, 1);
}

static void rounded(void **state)
{
	double round = 0, first = 0, quotient = 0, square = 0;

	(void)state;
	sample_seed(3);
	for (int i = 0; i < TRIES; i++) {
		int mark = real_mark();
		real x, y;
		ex a = polynomial(i % 20, &x), b = polynomial(i % 20, &y);

		round = fmax(round, relative(number_dd(ex_round(a)), x));
		first = fmax(first, relative(number_ex(ex_first(a, 3)), x));
		if (ex_sign(b) != 0)
			quotient = fmax(quotient,
			    relative(number_ex(ex_quotient(a, b)), over(x, y)));
		square = fmax(square,
		    relative(number_ex(ex_sqrt(ex_abs(a))),
			root(magnitude(x))));
		real_release(mark);
	}
	claim("ex_round", round * 0x1p106, EX_BOUND);
	claim("ex_first of 3", first, 0x1p-156);
	claim("ex_quotient", quotient, 0x1p-200);
	claim("ex_sqrt", square, 0x1p-200);
}

/* Beyond and at the ends of the range of doubles. */
static void range(void **state)
{
	ex big = ex_of(0x1p1000), small = ex_of(0x1p-1000);
	ex huge = ex_mul(big, ex_mul(big, big)), tiny = ex_mul(small, small);

	(void)state;
	assert_true(isinf(ex_round(huge).hi));
	assert_true(isinf(ex_round(ex_sqrt(ex_mul(huge, huge))).hi));
	assert_true(ex_div(huge, huge).hi == 1);
	assert_true(ex_round(ex_mul(huge, tiny)).hi == 0x1p1000);
	assert_true(ex_round(tiny).hi == 0);
	assert_int_equal(ex_sign(ex_neg(tiny)), -1);
	assert_true(ex_div(tiny, small).hi == 0x1p-1000);
	assert_true(ex_round(ex_sqrt(tiny)).hi == 0x1p-1000);
	assert_true(ex_round(ex_shift(tiny, 1000)).hi == 0x1p-1000);
	assert_true(!isfinite(ex_div(big, ex_of(0)).hi));
}

static void zeros(void **state)
{
	ex zero = ex_of(0), third = ex_quotient(ex_of(1), ex_of(3));
	ex rest = ex_sub(ex_of(1), ex_scale(third, 3));

	(void)state;
	assert_int_equal(ex_sign(zero), 0);
	assert_int_equal(ex_sign(ex_of(-0.0)), 0);
	assert_int_equal(ex_sign(ex_mul(zero, ex_of(5))), 0);
	assert_int_equal(ex_sign(ex_quotient(zero, ex_of(-3))), 0);
	assert_int_equal(ex_sign(ex_sqrt(zero)), 0);
	assert_true(ex_round(zero).hi == 0 && !signbit(ex_round(zero).hi));
	assert_int_not_equal(ex_sign(rest), 0);
	assert_int_equal(ex_sign(ex_settled(rest, ex_of(2))), 0);
	assert_int_equal(ex_sign(ex_settled(third, ex_of(2))), 1);
	assert_int_equal(ex_sign(ex_settled(zero, zero)), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(exact),
		cmocka_unit_test(full),
		cmocka_unit_test(wide),
		cmocka_unit_test(rounded),
		cmocka_unit_test(range),
		cmocka_unit_test(zeros),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
