/* Sines, cosines and cotangents against MPFR. */
#include "../trig.h"

#include "claims.h"

static double worst;

static void check(struct sum got, real exact)
{
	double e = mpfr_get_d(over(sub(number_ex(got.value), exact), exact),
	    MPFR_RNDN);

	worst = fmax(worst, fabs(e));
}

static void check_turn(double angle)
{
	int mark = real_mark();

	/* The quarter turns, where one of them is 0, are in exact_ones. */
	if (fmod(angle, 90) != 0) {
		check(sin_deg(angle), sine(angle));
		check(cos_deg(angle), cosine(angle));
		assert_int_equal(sum_sign(
				     sum_add(sin_deg(angle), sin_deg(-angle))),
		    0);
	}
	real_release(mark);
}

static void check_cot(double angle)
{
	int mark = real_mark();

	if (angle < 90)
		check(cot_deg(angle), cotangent(angle, 1));
	check(cot_half_deg(angle), cotangent(angle, 2));
	real_release(mark);
}

static void every_angle(void **state)
{
	(void)state;
	worst = 0;
	sample_seed(1);
	for (double a = -720; a <= 720; a += 7.5)
		check_turn(a);
	for (int i = -450; i <= 450; i++)
		check_turn(i * 0.8 + 0.1);
	for (int k = 0; k < 60; k++) {
		check_turn(45 + ldexp(1, -k));
		check_turn(180 - ldexp(1, -k));
		check_turn(nextafter(45, k % 2 * 90) + 90 * k);
	}
	for (int i = 0; i < 200; i++)
		check_turn(sample_number(150));
	claim("sine and cosine", worst, TRIG_BOUND);
}

static void every_cotangent(void **state)
{
	(void)state;
	worst = 0;
	sample_seed(2);
	for (int i = 1; i < 1800; i += 2)
		check_cot(i / 10.0);
	for (double a = 7.5; a < 180; a += 7.5)
		check_cot(a);
	for (int k = 0; k < 46; k++) {
		check_cot(180 - ldexp(1, -k));
		check_cot(90 - ldexp(1, -k));
	}
	check_cot(179.9999999999);
	for (int i = 0; i < 200; i++)
		check_cot(pow(10, sample_between(-150, 2)));
	claim("cotangent", worst, TRIG_BOUND);
}

static void equals(struct sum got, double expected)
{
	assert_int_equal(ex_compare(got.value, ex_of(expected)), 0);
	assert_true(got.size.m == 0);
}

static void exact_ones(void **state)
{
	static const double sines[12] = { 0, 0.5, 2, 1, 2, 0.5, 0, -0.5, 2, -1,
		2, -0.5 };

	(void)state;
	for (int i = -48; i <= 48; i++) {
		double s = sines[(i + 48) % 12], c = sines[(i + 51) % 12];

		if (s != 2)
			equals(sin_deg(30 * i), s);
		if (c != 2)
			equals(cos_deg(30 * i), c);
	}
	equals(cot_deg(45), 1);
	equals(cot_deg(90), 0);
	equals(cot_half_deg(90), 1);
	equals(sin_deg(360 * 0x1p400), 0);
	equals(cos_deg(360 * 0x1p400), 1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_angle),
		cmocka_unit_test(every_cotangent),
		cmocka_unit_test(exact_ones),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
