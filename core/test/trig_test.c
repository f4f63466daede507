/* SPDX-License-Identifier: MIT */
/* Sines, cosines and cotangents against MPFR. */
#include "../exact/trig.h"

#include "arithmetic.h"
#include "claims.h"
#include "numbers.h"

static double worst;

static void check(struct sum got, real exact)
{
	double e = mpfr_get_d(divide(sub(real_of_ex(got.value), exact), exact),
	    MPFR_RNDN);

	worst = fmax(worst, fabs(e));
}

static void check_turn(double angle, enum angle_unit unit)
{
	int mark = real_mark();

	/* The quarter turns, where one of them is 0, are in exact_ones. */
	if (unit == RADIANS || fmod(angle, 90) != 0) {
		check(trig_sin(angle, unit), sine(angle, unit));
		check(trig_cos(angle, unit), cosine(angle, unit));
		assert_int_equal(sum_sign(sum_add(trig_sin(angle, unit),
				     trig_sin(-angle, unit))),
		    0);
	}
	real_release(mark);
}

static void check_cot(double angle, enum angle_unit unit)
{
	int mark = real_mark();

	if (angle < (unit == RADIANS ? PI / 2 : 90))
		check(trig_cot(angle, unit), cotangent(angle, unit, 1));
	check(trig_cot(angle / 2, unit), cotangent(angle, unit, 2));
	real_release(mark);
}

static void every_angle(void **state)
{
	(void)state;
	worst = 0;
	sample_seed(1);
	for (double a = -720; a <= 720; a += 7.5)
		check_turn(a, DEGREES);
	for (int i = -450; i <= 450; i++)
		check_turn(i * 0.8 + 0.1, DEGREES);
	for (int k = 0; k < 60; k++) {
		check_turn(45 + ldexp(1, -k), DEGREES);
		check_turn(180 - ldexp(1, -k), DEGREES);
		check_turn(nextafter(45, k % 2 * 90) + 90 * k, DEGREES);
	}
	for (int i = 0; i < 200; i++)
		check_turn(sample_number(150), DEGREES);
	assert_at_most("sine and cosine", worst, TRIG_BOUND);
}

static void every_cotangent(void **state)
{
	(void)state;
	worst = 0;
	sample_seed(2);
	for (int i = 1; i < 1800; i += 2)
		check_cot(i / 10.0, DEGREES);
	for (double a = 7.5; a < 180; a += 7.5)
		check_cot(a, DEGREES);
	for (int k = 0; k < 46; k++) {
		check_cot(180 - ldexp(1, -k), DEGREES);
		check_cot(90 - ldexp(1, -k), DEGREES);
	}
	check_cot(179.9999999999, DEGREES);
	for (int i = 0; i < 200; i++)
		check_cot(pow(10, sample_between(-150, 2)), DEGREES);
	assert_at_most("cotangent", worst, TRIG_BOUND);
}

static void equals(struct sum got, double expected)
{
	assert_int_equal(ex_compare(got.value, ex_of(expected)), 0);
	assert_true(sum_is_exact(&got));
}

/* The angles are written as in other programs: next to zeros of a function, and
 * the double that is nearest of all to one. */
static void every_radian(void **state)
{
	(void)state;
	worst = 0;
	sample_seed(3);
	for (int i = -600; i <= 600; i++)
		if (i != 0)
			check_turn(i / 50.0, RADIANS);
	for (int i = 1; i < 300; i++) {
		check_turn(PI / 2 * i, RADIANS);
		check_turn(nextafter(PI / 4 * i, i % 2 * 1e9), RADIANS);
		check_turn(-ldexp(PI / 2, i), RADIANS);
		check_turn(sample_number(150), RADIANS);
		check_turn(ldexp(1 + sample_unit(), i), RADIANS);
		check_cot(i / 100.0, RADIANS);
		check_cot(pow(10, -i / 2.0), RADIANS);
	}
	check_turn(ldexp(6381956970095103, -500), RADIANS);
	check_turn(ldexp(6381956970095103, 400), RADIANS);
	check_turn(1e150, RADIANS);
	check_cot(PI, RADIANS);
	check_cot(nextafter(PI, 0), RADIANS);
	check_cot(PI / 2, RADIANS);
	assert_at_most("of radians", worst, TRIG_BOUND);
	assert_true(sum_sign(trig_sin(0, RADIANS)) == 0);
	assert_true(sum_double(trig_cos(0, RADIANS)) == 1);
	assert_number(sum_double(trig_cos(PI / 2, RADIANS)),
	    0x1.1a62633145c07p-54);
	assert_number(sum_double(trig_cot(PI / 2, RADIANS)),
	    0x1.1a62633145c07p-54);
}

/* Compares with MPFR's sine and cosine of a root: of sums of squares of three doubles,
 * among them roots next to a multiple of pi. */
static void check_square(struct sum square)
{
	int mark = real_mark();
	real s = real_of(0), c = real_of(0), x = root(real_of_ex(square.value));
	struct sum sinc, versinc;

	mpfr_sin_cos(s, c, x, MPFR_RNDN);
	assert_true(trig_sinc(square, &sinc, &versinc));
	check(sinc, divide(s, x));
	check(versinc, divide(sub(real_of(1), c), mul(x, x)));
	real_release(mark);
}

static struct sum square_of(double a)
{
	return sum_mul(sum_of_double(a), sum_of_double(a));
}

/* Returns a sum of squares of three doubles that is nearly the square of pi or 2 pi. */
static struct sum square_near(double turns)
{
	int mark = real_mark();
	struct sum square = sum_of_double(0);
	real rest = real_of(0);

	mpfr_const_pi(rest, MPFR_RNDN);
	rest = mul(rest, real_of(turns));
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

static void every_square(void **state)
{
	struct sum s, c;

	(void)state;
	worst = 0;
	sample_seed(4);
	for (int i = 1; i <= 628; i++)
		check_square(square_of(i / 100.0));
	for (int i = 1; i < 150; i++)
		check_square(square_of(pow(10, -i)));
	for (int i = 0; i < 2000; i++)
		check_square(square_near(i % 2 + 1));
	assert_at_most("of squares", worst, TRIG_BOUND);
	assert_true(trig_sinc(sum_of_double(0), &s, &c));
	assert_true(sum_double(s) == 1 && sum_double(c) == 0.5);
	assert_true(trig_sinc(square_of(2 * PI), &s, &c));
	assert_false(trig_sinc(square_of(nextafter(2 * PI, 7)), &s, &c));
}

static void exact_ones(void **state)
{
	static const double sines[12] = { 0, 0.5, 2, 1, 2, 0.5, 0, -0.5, 2, -1,
		2, -0.5 };

	(void)state;
	for (int i = -48; i <= 48; i++) {
		double s = sines[(i + 48) % 12], c = sines[(i + 51) % 12];

		if (s != 2)
			equals(trig_sin(30 * i, DEGREES), s);
		if (c != 2)
			equals(trig_cos(30 * i, DEGREES), c);
	}
	equals(trig_cot(45, DEGREES), 1);
	equals(trig_cot(90, DEGREES), 0);
	equals(trig_sin(360 * 0x1p400, DEGREES), 0);
	equals(trig_cos(360 * 0x1p400, DEGREES), 1);
}

/* A sum below its error is 0: the roots of 2, 3 and 5 times themselves, less
 * these numbers. */
static void angles_of_nothing(void **state)
{
	(void)state;
	for (double v = 2; v < 6; v++) {
		struct sum root = sum_sqrt(sum_of_double(v));
		struct sum none = sum_sub(sum_mul(root, root),
		    sum_of_double(v));
		struct sum one = sum_of_double(1);
		struct sum least = sum_of_double(0x1p-1074);

		for (int turn = 0; turn < 2; turn++) {
			assert_number(trig_atan2_degrees(none, one), 0);
			assert_number(trig_atan2_degrees(none, least), 0);
			assert_number(trig_atan2_degrees(one, none), 90);
			assert_number(trig_atan2_degrees(none, sum_neg(one)),
			    180);
			assert_true(isnan(trig_atan2_degrees(none, none)));
			none = sum_neg(none);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_angle),
		cmocka_unit_test(every_cotangent),
		cmocka_unit_test(every_radian),
		cmocka_unit_test(every_square),
		cmocka_unit_test(exact_ones),
		cmocka_unit_test(angles_of_nothing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
