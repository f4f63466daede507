/* SPDX-License-Identifier: MIT */
/* Sines, cosines and cotangents against MPFR. */
#include "../exact/trig.h"

#include "arithmetic.h"
#include "claims.h"

static double worst;

static void keep_worst_error(struct sum got, real exact)
{
	double e = mpfr_get_d(divide(sub(real_of_ex(got.value), exact), exact),
	    MPFR_RNDN);

	worst = fmax(worst, fabs(e));
}

static struct sum trig_sin(double angle, enum angle_unit unit)
{
	struct sum sine, cosine;

	trig_sin_cos(angle, unit, &sine, &cosine);
	return sine;
}

static struct sum trig_cos(double angle, enum angle_unit unit)
{
	struct sum sine, cosine;

	trig_sin_cos(angle, unit, &sine, &cosine);
	return cosine;
}

static void check_sine_and_cosine(double angle, enum angle_unit unit)
{
	int mark = real_mark();
	real half = sine(angle / 2, unit);

	/* exact_values tests quarter turns, where a function is 0 */
	if (unit == ANGLE_RADIANS || fmod(angle, 90) != 0) {
		keep_worst_error(trig_sin(angle, unit), sine(angle, unit));
		keep_worst_error(trig_cos(angle, unit), cosine(angle, unit));
		assert_int_equal(sum_sign(sum_add(trig_sin(angle, unit),
				     trig_sin(-angle, unit))),
		    0);
	}
	/* 1 - cos a is 2 sin^2 (a / 2), and cos a no lone 1/2 here */
	if (angle != 0 && fabs(angle) < (unit == ANGLE_RADIANS ? PI / 4 : 45))
		keep_worst_error(sum_sub(sum_one, trig_cos(angle, unit)),
		    add(mul(half, half), mul(half, half)));
	real_release(mark);
}

static void check_cotangent(double angle, enum angle_unit unit)
{
	int mark = real_mark();

	if (angle < (unit == ANGLE_RADIANS ? PI / 2 : 90))
		keep_worst_error(trig_cot(angle, unit), cotangent(angle, unit, 1));
	keep_worst_error(trig_cot(angle / 2, unit), cotangent(angle, unit, 2));
	real_release(mark);
}

static void degrees_within_bound(void **state)
{
	(void)state;
	worst = 0;
	for (double a = -720; a <= 720; a += 7.5)
		check_sine_and_cosine(a, ANGLE_DEGREES);
	for (int i = -450; i <= 450; i++)
		check_sine_and_cosine(i * 0.8 + 0.1, ANGLE_DEGREES);
	for (int k = 0; k < 60; k++) {
		check_sine_and_cosine(45 + ldexp(1, -k), ANGLE_DEGREES);
		check_sine_and_cosine(180 - ldexp(1, -k), ANGLE_DEGREES);
		check_sine_and_cosine(nextafter(45, k % 2 * 90) + 90 * k,
		    ANGLE_DEGREES);
	}
	SAMPLES(i, 200)
		check_sine_and_cosine(sample_number(150), ANGLE_DEGREES);
	assert_at_most("sine, cosine and 1 - cosine", worst, TRIG_ERROR);
}

static void cotangents_within_bound(void **state)
{
	(void)state;
	worst = 0;
	for (int i = 1; i < 1800; i += 2)
		check_cotangent(i / 10.0, ANGLE_DEGREES);
	for (double a = 7.5; a < 180; a += 7.5)
		check_cotangent(a, ANGLE_DEGREES);
	for (int k = 0; k < 46; k++) {
		check_cotangent(180 - ldexp(1, -k), ANGLE_DEGREES);
		check_cotangent(90 - ldexp(1, -k), ANGLE_DEGREES);
	}
	check_cotangent(179.9999999999, ANGLE_DEGREES);
	SAMPLES(i, 200)
		check_cotangent(pow(10, sample_between(-150, 2)), ANGLE_DEGREES);
	assert_at_most("cotangent", worst, TRIG_ERROR);
}

static void assert_exact(struct sum got, double expected)
{
	assert_int_equal(ex_compare(got.value, ex_of(expected)), 0);
	assert_true(sum_is_exact(&got));
}

/* Tests radians next to zeros of the functions: multiples of the double PI / 4, and
 * the double nearest of all to a multiple of pi / 2, 6381956970095103 times a power of
 * two. */
static void radians_within_bound(void **state)
{
	(void)state;
	worst = 0;
	for (int i = -600; i <= 600; i++)
		if (i != 0)
			check_sine_and_cosine(i / 50.0, ANGLE_RADIANS);
	for (int i = 1; i < 300; i++) {
		check_sine_and_cosine(PI / 2 * i, ANGLE_RADIANS);
		check_sine_and_cosine(nextafter(PI / 4 * i, i % 2 * 1e9),
		    ANGLE_RADIANS);
		check_sine_and_cosine(-ldexp(PI / 2, i), ANGLE_RADIANS);
		check_cotangent(i / 100.0, ANGLE_RADIANS);
		check_cotangent(pow(10, -i / 2.0), ANGLE_RADIANS);
	}
	SAMPLES(i, 300) {
		check_sine_and_cosine(sample_number(150), ANGLE_RADIANS);
		check_sine_and_cosine(ldexp(1 + sample_unit(), i), ANGLE_RADIANS);
	}
	check_sine_and_cosine(ldexp(6381956970095103, -500), ANGLE_RADIANS);
	check_sine_and_cosine(ldexp(6381956970095103, 400), ANGLE_RADIANS);
	check_sine_and_cosine(1e150, ANGLE_RADIANS);
	check_cotangent(PI, ANGLE_RADIANS);
	check_cotangent(nextafter(PI, 0), ANGLE_RADIANS);
	check_cotangent(PI / 2, ANGLE_RADIANS);
	assert_at_most("of radians", worst, TRIG_ERROR);
	assert_true(sum_sign(trig_sin(0, ANGLE_RADIANS)) == 0);
	assert_true(sum_double(trig_cos(0, ANGLE_RADIANS)) == 1);
	assert_number(sum_double(trig_cos(PI / 2, ANGLE_RADIANS)),
	    0x1.1a62633145c07p-54);
	assert_number(sum_double(trig_cot(PI / 2, ANGLE_RADIANS)),
	    0x1.1a62633145c07p-54);
}

/* Compares trig_rodrigues with MPFR's sine and cosine of the root of square. square is
 * a sum of squares of three doubles; some roots are next to a multiple of pi. */
static void check_sinc(struct sum square)
{
	int mark = real_mark();
	real s = real_of(0), c = real_of(0), x = root(real_of_ex(square.value));
	struct sum sinc, versinc;

	mpfr_sin_cos(s, c, x, MPFR_RNDN);
	assert_true(trig_rodrigues(square, &sinc, &versinc));
	keep_worst_error(sinc, divide(s, x));
	keep_worst_error(versinc, divide(sub(real_of(1), c), mul(x, x)));
	real_release(mark);
}

static struct sum square_of(double a)
{
	return sum_mul(sum_of_double(a), sum_of_double(a));
}

/* Returns a sum of squares of three doubles that is nearly the square of pi times
 * half_turns. */
static struct sum square_near(double half_turns)
{
	int mark = real_mark();
	struct sum square = sum_of_double(0);
	real rest = real_of(0);

	mpfr_const_pi(rest, MPFR_RNDN);
	rest = mul(rest, real_of(half_turns));
	double part = mpfr_get_d(rest, MPFR_RNDD) *
	    (1 - ldexp(sample_unit(), sample_below(2) ? 0 : -48));

	rest = mul(rest, rest);
	for (int i = 0; i < 3; i++) {
		if (i > 0)
			part = mpfr_get_d(root(rest), MPFR_RNDD);
		square = sum_add(square, square_of(part));
		rest = sub(rest, mul(real_of(part), real_of(part)));
	}
	real_release(mark);
	return square;
}

static void roots_of_sums_of_squares(void **state)
{
	struct sum s, c;

	(void)state;
	worst = 0;
	for (int i = 1; i <= 628; i++)
		check_sinc(square_of(i / 100.0));
	for (int i = 1; i < 150; i++)
		check_sinc(square_of(pow(10, -i)));
	SAMPLES(i, 2000)
		check_sinc(square_near(i % 2 + 1));
	assert_at_most("of squares", worst, TRIG_ERROR);
	assert_true(trig_rodrigues(sum_of_double(0), &s, &c));
	assert_true(sum_double(s) == 1 && sum_double(c) == 0.5);
	assert_true(trig_rodrigues(square_of(2 * PI), &s, &c));
	assert_false(trig_rodrigues(square_of(nextafter(2 * PI, 7)), &s, &c));
}

static void exact_values(void **state)
{
	static const double sines[12] = { 0, 0.5, 2, 1, 2, 0.5, 0, -0.5, 2, -1, 2,
		-0.5 };

	(void)state;
	for (int i = -48; i <= 48; i++) {
		double s = sines[(i + 48) % 12], c = sines[(i + 51) % 12];

		if (s != 2)
			assert_exact(trig_sin(30 * i, ANGLE_DEGREES), s);
		if (c != 2)
			assert_exact(trig_cos(30 * i, ANGLE_DEGREES), c);
	}
	assert_exact(trig_cot(45, ANGLE_DEGREES), 1);
	assert_exact(trig_cot(90, ANGLE_DEGREES), 0);
	assert_exact(trig_sin(360 * 0x1p400, ANGLE_DEGREES), 0);
	assert_exact(trig_cos(360 * 0x1p400, ANGLE_DEGREES), 1);
}

/* The root of v times itself, less v, is 0 with an error, and counts as 0. */
static void arctangents_of_zeros(void **state)
{
	(void)state;
	for (double v = 2; v < 6; v++) {
		struct sum root = sum_sqrt(sum_of_double(v));
		struct sum zero = sum_sub(sum_mul(root, root), sum_of_double(v));
		struct sum one = sum_of_double(1);
		struct sum least = sum_of_double(0x1p-1074);

		for (int turn = 0; turn < 2; turn++) {
			assert_number(trig_atan2(zero, one, ANGLE_DEGREES), 0);
			assert_number(trig_atan2(zero, least, ANGLE_DEGREES), 0);
			assert_number(trig_atan2(one, zero, ANGLE_DEGREES), 90);
			assert_number(trig_atan2(zero, sum_neg(one), ANGLE_DEGREES),
			    180);
			assert_true(isnan(trig_atan2(zero, zero, ANGLE_DEGREES)));
			zero = sum_neg(zero);
		}
	}
}

/* A double's own sine and cosine give it back, and those of degrees the radians. */
static void arctangents_of_angles(void **state)
{
	struct sum s, c;

	(void)state;
	SAMPLES(k, 3000) {
		double angle = sample_between(0, k % 4 ? PI : 1e-9);

		trig_sin_cos(angle, ANGLE_RADIANS, &s, &c);
		assert_number(trig_atan2(s, c, ANGLE_RADIANS), angle);
		trig_sin_cos(angle, ANGLE_DEGREES, &s, &c);
		assert_number(trig_atan2(s, c, ANGLE_DEGREES), angle);
	}
	for (int i = 45; i <= 180; i *= 2) {
		trig_sin_cos(i, ANGLE_DEGREES, &s, &c);
		assert_number(trig_atan2(s, c, ANGLE_RADIANS), i * PI / 180);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(degrees_within_bound),
		cmocka_unit_test(cotangents_within_bound),
		cmocka_unit_test(radians_within_bound),
		cmocka_unit_test(roots_of_sums_of_squares),
		cmocka_unit_test(exact_values),
		cmocka_unit_test(arctangents_of_zeros),
		cmocka_unit_test(arctangents_of_angles),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
