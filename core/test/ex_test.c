/* SPDX-License-Identifier: MIT */
/* Sums and products of core/exact/ex.c are exact, and quotients, roots and rounding
 * are within the bounds that ex.h gives. MPFR has the truth. */
#include "arithmetic.h"
#include "claims.h"

enum { TRIES = 3000 };

static ex absolute(ex a)
{
	a.sign = a.n > 0;
	return a;
}

/* Returns a polynomial in numbers from 10^-e to 10^e, and sets *exact to its value by
 * MPFR. The last steps may cancel all but the smallest of its terms. */
static ex polynomial(int e, real *exact)
{
	ex a = ex_of(0);
	real r = real_of(0);

	for (int i = 0; i < 6; i++) {
		double x = sample_number(e), y = sample_number(e);

		if (sample_below(3) == 0) {
			a = ex_mul(a, ex_of(x));
			r = mul(r, real_of(x));
		}
		a = ex_add(a, ex_mul(ex_of(x), ex_sub(ex_of(y), ex_of(x))));
		r = add(r, mul(real_of(x), sub(real_of(y), real_of(x))));
		if (sample_below(3) == 0) {
			ex b = ex_mul(ex_sub(ex_of(x), ex_of(-y)), ex_of(y));

			a = ex_sub(ex_add(a, b), ex_neg(b));
			r = add(r,
			    mul(real_of(2),
				mul(real_of(y), add(real_of(x), real_of(y)))));
		}
	}
	*exact = r;
	return a;
}

static dd round_to_pair(ex a)
{
	return ex_round(&a);
}

static double relative(real got, real exact)
{
	if (mpfr_zero_p(exact))
		return mpfr_zero_p(got) ? 0 : (double)INFINITY;
	return fabs(mpfr_get_d(divide(sub(got, exact), exact), MPFR_RNDN));
}

static void sums_are_exact(void **state)
{
	(void)state;
	SAMPLES(i, TRIES) {
		int mark = real_mark();
		real r;
		ex a = polynomial(i % 20, &r);

		assert_true(mpfr_equal_p(real_of_ex(a), r));
		assert_int_equal(a.sign, mpfr_sgn(r));
		assert_true(mpfr_equal_p(real_of_ex(ex_neg(a)), negative(r)));
		assert_int_equal(ex_sub(a, a).sign, 0);
		real_release(mark);
	}
}

/* Tests magnitudes as far apart as products of four numbers of a document. */
static void wide_magnitudes(void **state)
{
	(void)state;
	SAMPLES(i, TRIES) {
		int mark = real_mark();
		ex a = ex_of(0);
		real r = real_of(0);

		for (int j = 0; j < 6; j++) {
			double x = sample_number(150), y = sample_number(150);
			double z = sample_number(150);

			a = ex_add(a,
			    ex_mul(ex_mul(ex_of(x), ex_of(y)),
				ex_sub(ex_of(x), ex_of(z))));
			r = add(r,
			    mul(mul(real_of(x), real_of(y)),
				sub(real_of(x), real_of(z))));
		}
		assert_true(mpfr_equal_p(real_of_ex(a), r));
		real_release(mark);
	}
}

/* Returns a number of up to n words. Many words are 0, all bits, or bits at the ends,
 * which cause carries and wrong guesses of a quotient's digits. */
static ex sample_words(int n)
{
	static const uint64_t odd[] = { 0, 1, UINT64_MAX, UINT64_MAX - 1,
		(uint64_t)1 << 63, ((uint64_t)1 << 63) - 1 };
	ex a = ex_of(0);

	for (int i = (int)sample_below((unsigned)n); i >= 0; i--) {
		uint64_t w = odd[sample_below(6)];

		if (sample_below(3) == 0)
			w = (uint64_t)(sample_unit() * 0x1p53) << 11 |
			    sample_below(2048);
		a = ex_add(ex_shift(a, 64),
		    ex_add(ex_mul(ex_of((double)(w >> 32)), ex_of(0x1p32)),
			ex_of((double)(uint32_t)w)));
	}
	return sample_below(2) ? a : ex_neg(a);
}

static void quotients_and_roots(void **state)
{
	double quotient = 0, square = 0;

	(void)state;
	SAMPLES(i, 20 * TRIES) {
		int mark = real_mark();
		ex a = sample_words(8), b = sample_words(8), p = ex_mul(a, b);
		real x = real_of_ex(a), y = real_of_ex(b);

		assert_true(mpfr_equal_p(real_of_ex(p), mul(x, y)));
		assert_true(mpfr_equal_p(real_of_ex(ex_add(a, b)), add(x, y)));
		assert_int_equal(ex_compare(a, b),
		    (mpfr_cmp(x, y) > 0) - (mpfr_cmp(x, y) < 0));
		if (b.sign != 0)
			quotient = fmax(quotient,
			    relative(real_of_ex(ex_quotient(a, b)), divide(x, y)));
		square = fmax(square,
		    relative(real_of_ex(ex_root(absolute(a))), root(magnitude(x))));
		a = ex_cut(a, 2);
		b = ex_cut(b, 3);
		if (b.sign != 0)
			assert_int_equal(ex_compare(a, ex_quotient(ex_mul(a, b), b)),
			    0);
		assert_int_equal(ex_compare(absolute(b), ex_root(ex_mul(b, b))), 0);
		real_release(mark);
	}
	assert_at_most("ex_quotient, in 2^-703", quotient * 0x1p703, 1);
	assert_at_most("ex_sqrt, in 2^-703", square * 0x1p703, 1);
}

/* Divides a divisor times a midpoint of two doubles, or a little more or less than
 * that. Two words of the quotient, and whether there is a remainder, tell which double
 * is nearest. */
static void quotients_at_midpoints(void **state)
{
	(void)state;
	SAMPLES(i, 20 * TRIES) {
		double even = 0x1p52 + 2 * sample_below(1000);
		ex q, b = sample_words(4), middle = ex_add(ex_of(even), ex_of(0.5));
		int side = (int)sample_below(3) - 1, e = -700;

		if (b.sign == 0)
			continue;
		if (sample_below(2))
			e = 64 * b.e - 2 - (int)sample_below(200);
		ex little = ex_shift(ex_of(side * b.sign), e);
		ex a = ex_add(ex_mul(b, middle), little);

		assert_true(ex_divide(&a, &b, 2, &q) || side != 0);
		assert_true(ex_nearest(&q, false) == even + (side > 0));
	}
}

/* Rounds to doubles and floats, normal and subnormal, at and near midpoints. */
static void rounding(void **state)
{
	double round = 0, first = 0;

	(void)state;
	SAMPLES(i, TRIES) {
		int mark = real_mark();
		real x;
		ex a = polynomial(i % 20, &x);

		round = fmax(round, relative(real_of_dd(round_to_pair(a)), x));
		first = fmax(first, relative(real_of_ex(ex_cut(a, 3)), x));
		real_release(mark);
	}
	assert_at_most("ex_round", round * 0x1p106, EX_ROUND_BOUND);
	assert_at_most("ex_truncate of 3", first, 0x1p-128);
	for (int i = 0; i < 20 * TRIES; i++) {
		int mark = real_mark(), e = (int)sample_below(2300) - 1150;
		double d = ldexp(1 + sample_unit(), e);
		double next = nextafter(d, HUGE_VAL);
		float f = (float)d, above = nextafterf(f, HUGE_VALF);
		ex near = i % 2 ? ex_add(ex_of(d), ex_of(next)) :
				  ex_add(ex_of((double)f), ex_of((double)above));

		near = ex_shift(near, -1);
		if (!isfinite(next) || !isfinite(above))
			near = ex_shift(ex_of(1 + sample_unit()), e);
		near = ex_add(near,
		    ex_shift(ex_of((double)sample_below(3) - 1),
			e - 60 - (int)sample_below(900)));
		real exact = real_of_ex(near);

		assert_number(ex_double(near), mpfr_get_d(exact, MPFR_RNDN));
		assert_true(
		    ex_nearest(&near, true) == (double)mpfr_get_flt(exact, MPFR_RNDN));
		assert_number(ex_double(ex_neg(near)), -ex_double(near));
		real_release(mark);
	}
}

/* Tests results beyond the range of doubles and at its ends. */
static void ends_of_the_range(void **state)
{
	ex big = ex_of(0x1p1000), small = ex_of(0x1p-1000);
	ex huge = ex_mul(big, ex_mul(big, big)), tiny = ex_mul(small, small);

	(void)state;
	assert_true(isinf(round_to_pair(huge).hi));
	assert_true(isinf(round_to_pair(ex_root(ex_mul(huge, huge))).hi));
	assert_number(round_to_pair(ex_quotient(huge, huge)).hi, 1);
	assert_number(round_to_pair(ex_mul(huge, tiny)).hi, 0x1p1000);
	assert_number(round_to_pair(tiny).hi, 0);
	assert_int_equal(ex_neg(tiny).sign, -1);
	assert_number(round_to_pair(ex_quotient(tiny, small)).hi, 0x1p-1000);
	assert_number(round_to_pair(ex_root(tiny)).hi, 0x1p-1000);
	assert_number(round_to_pair(ex_shift(tiny, 1000)).hi, 0x1p-1000);
	assert_true(!isfinite(round_to_pair(ex_quotient(big, ex_of(0))).hi));
}

/* Tests terms that are farther apart than EX_WORDS words: only the words of a sum
 * below its first EX_WORDS words are lost. */
static void terms_far_apart(void **state)
{
	ex one = ex_add(ex_of(1), ex_shift(ex_of(1), 70)), r;

	(void)state;
	for (int i = 0; i < 3 * 64 * EX_WORDS; i += 7) {
		int mark = real_mark();
		ex far = ex_shift(ex_of(3), i), less = ex_neg(far);
		const ex *const a[] = { &one, &far }, *const b[] = { &one, &far };
		const ex *const c[] = { &one, &less };
		real x = mul(real_of_ex(one), real_of_ex(one));
		real y = mul(real_of_ex(far), real_of_ex(far));
		real z = add(real_of_ex(one), real_of_ex(far));

		assert_true(relative(real_of_ex(ex_add(one, far)), z) == 0);
		ex_dot(2, a, b, INT_MIN, &r);
		assert_true(relative(real_of_ex(r), add(x, y)) == 0);
		ex_dot(2, a, c, INT_MIN, &r);
		assert_true(relative(real_of_ex(r), sub(x, y)) == 0);
		real_release(mark);
	}
}

/* A sum that is too wide loses its last words. This is an overflow only if a lost word
 * is not below the least word that the caller asks for. */
static void overflow_of_wide_sums(void **state)
{
	const ex near = ex_of(1), far = ex_shift(near, 2 * 64 * EX_WORDS);
	const ex *const a[] = { &near, &far }, *const b[] = { &near, &near };
	ex r;

	(void)state;
	(void)ex_has_overflowed();
	ex_dot(2, a, b, 3 * 64, &r); /* the sum has room for word 3 and those above */
	assert_false(ex_has_overflowed());
	ex_dot(2, a, b, 3 * 64 - 1, &r);
	assert_true(ex_has_overflowed());
}

static void zeros(void **state)
{
	ex zero = ex_of(0), third = ex_quotient(ex_of(1), ex_of(3));
	ex rest = ex_sub(ex_of(1), ex_mul(third, ex_of(3))), q;

	(void)state;
	assert_int_equal(zero.sign, 0);
	assert_int_equal(ex_of(-0.0).sign, 0);
	assert_int_equal(ex_mul(zero, ex_of(5)).sign, 0);
	assert_int_equal(ex_quotient(zero, ex_of(-3)).sign, 0);
	assert_int_equal(ex_root(zero).sign, 0);
	assert_true(round_to_pair(zero).hi == 0 && !signbit(round_to_pair(zero).hi));
	assert_int_not_equal(rest.sign, 0);
	assert_true(ex_divide(&zero, &third, 2, &q));
	assert_false(ex_divide(&third, &zero, 2, &q));
	assert_true(isinf(ex_nearest(&q, false)));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(sums_are_exact),
		cmocka_unit_test(wide_magnitudes),
		cmocka_unit_test(quotients_and_roots),
		cmocka_unit_test(quotients_at_midpoints),
		cmocka_unit_test(rounding),
		cmocka_unit_test(ends_of_the_range),
		cmocka_unit_test(terms_far_apart),
		cmocka_unit_test(overflow_of_wide_sums),
		cmocka_unit_test(zeros),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
