/* SPDX-License-Identifier: MIT */
#include "trig.h"

#include <limits.h>

/* pi / 2, with a relative error below 2^-963. */
static const struct sum HALF_PI = {
	.value = { 1, 16, -15,
	    { 0x8400f97142c77e0b, 0x9250cca3d9c8b67b, 0x5d3e4822f8963fcc,
		0xdc70d7f6b5133f4b, 0x17feb96de80d6fdb, 0xe89885d34c6fdad6,
		0xc90b6aecc4bcfd8d, 0x9fc26adadaa3848b, 0x605614dbe4be286e,
		0xdf2a33679a748636, 0xa29410f31c6809bb, 0x04177d4c76273644,
		0x52049c1114cf98e8, 0x898cc51701b839a2, 0x921fb54442d18469, 1 } },
};

/* The number of words of a reduced angle. */
enum { REST_WORDS = 6 };

/* How squared_chord computes from x^2 below 4 or, if not short, up to 4 pi^2: from the
 * chord of x / 2^halvings, with numbers of so many words. */
enum {
	SHORT_HALVINGS = 14,
	SHORT_WORDS = 6,
	LONG_HALVINGS = 35,
	LONG_WORDS = EX_QUOTIENT_WORDS,
	LONG_ERROR = EX_RANGE - 680, /* 2^-692, with room for the cuts of sum.h */
	CHORD_POWER = 20,            /* terms of the series are below x^CHORD_POWER */
};

/* Returns g(x) = 2 - 2 cos x, the square of the chord of x radians, from x^2. For an
 * angle t = x / 2^halvings it is y (1 - y/(3 4) + y^2/(3 4 5 6) - ...) with y = t^2, by
 * Horner's scheme as y s / c with the common denominator c = CHORD_POWER! / 2. Then
 * each g(2 t) = g (4 - g) doubles the angle.
 *
 * The first term left out, 2 y^10 / 22!, is below 2^-328 or, if not short, 2^-715. The
 * cuts of y, s, the quotient, the product and of each g lose less than a unit of the
 * last word, 2^-320 or 2^-704 of the number. A doubling multiplies a relative error by
 * (4 - 2 g) / (4 - g), at most 1 for g <= 8/3, and at most 1.5 where twice_sine doubles
 * a short angle. A long one is doubled twice beyond that, which multiplies an absolute
 * error by at most 4 each: 2^-692 in all. Near x = 2 pi g can be as small as 2^-326, as
 * the sum of the squares of three doubles can be as near to 4 pi^2 as 2^-159; so can
 * 4 - g near pi. */
static struct sum squared_chord(const ex *square)
{
	const bool is_short = ex_exponent(square) <= 2;
	const int halvings = is_short ? SHORT_HALVINGS : LONG_HALVINGS;
	const int words = is_short ? SHORT_WORDS : LONG_WORDS;
	struct sum r = sum_of_power(-2 * halvings);
	ex *g = &r.value, y, minus, c = ex_of(1), s = c;
	const ex one = c, four = ex_of(4);

	ex_dot(1, (const ex *[]){ square }, (const ex *[]){ g }, INT_MIN, &y);
	ex_truncate(&y, words, &y);
	ex_truncate(&y, words, &minus);
	minus.sign = -minus.sign;
	for (int k = CHORD_POWER; k > 2; k -= 2) {
		c.word[0] *= (uint64_t)(k * (k - 1));
		ex_dot(2, (const ex *[]){ &c, &s }, (const ex *[]){ &one, &minus },
		    64 * (1 - words), &s);
	}
	ex_divide(&s, &c, words, &s);
	ex_dot(1, (const ex *[]){ &y }, (const ex *[]){ &s }, 64 * (y.e + y.n - words),
	    g);
	for (int i = 0; i < halvings; i++) {
		ex_truncate(g, words, &minus);
		minus.sign = -minus.sign;
		ex_dot(2, (const ex *[]){ g, g }, (const ex *[]){ &four, &minus },
		    64 * (g->e + g->n - words), g);
	}
	r.error = LONG_ERROR;
	return is_short ? sum_with_error(r, SUM_TRIG_ERROR) : r;
}

/* Returns 2 |sin x| from g(x), as the root of g(2 x). */
static struct sum twice_sine(const struct sum *g)
{
	const struct sum four = sum_of_double(4);

	return sum_sqrt(sum_minor(four, *g, *g, *g));
}

/* Returns the sign of x - turns pi, from x^2. */
static int compare_half_turns(const struct sum *square, int turns)
{
	struct sum pi = sum_scale(HALF_PI, 2 * turns);

	return sum_sign(sum_minor(*square, sum_one, pi, pi));
}

bool trig_rodrigues(struct sum square, struct sum *a, struct sum *b)
{
	if (compare_half_turns(&square, 2) > 0)
		return false;
	if (sum_sign(square) == 0) {
		sum_set(a, 1);
		sum_set(b, 0.5);
		return true;
	}
	struct sum g = squared_chord(&square.value);
	struct sum twice = sum_scale(sum_sqrt(square), 2);

	*a = sum_negated_if(compare_half_turns(&square, 1) > 0,
	    sum_with_error(sum_quotient(twice_sine(&g), twice), SUM_TRIG_ERROR));
	*b = sum_with_error(sum_quotient(g, sum_scale(square, 2)), SUM_TRIG_ERROR);
	return true;
}

/* An angle modulo 360 degrees: quarters times 90 degrees plus a rest from -45 to 45. */
struct reduced_angle {
	double rest_degrees;     /* nan if the angle is in radians */
	struct sum rest_radians; /* cut to REST_WORDS words */
	unsigned quarters;
};

/* Reduces degrees. fmod is exact, and so is the subtraction (Sterbenz's lemma). */
static void reduce_degrees(double angle, struct reduced_angle *r)
{
	double rest = fmod(angle, 360), q = rint(rest / 90);

	r->rest_degrees = rest - 90 * q;
	r->rest_radians = sum_truncate(sum_quotient(sum_scale(HALF_PI, r->rest_degrees),
					   sum_of_double(90)),
	    REST_WORDS);
	r->quarters = (unsigned)(int)q;
}

/* Reduces an angle in radians, up to 2^500. The error of the rest is within 2^-460. A
 * double of at least 2^-64 is no closer than 2^-64 to a multiple of pi / 2 (J.-M.
 * Muller, "Elementary Functions", on range reduction), so that the relative error is
 * within 2^-396. A smaller angle is its own rest, without an error. */
static void reduce_radians(double angle, struct reduced_angle *r)
{
	struct sum a = sum_of_double(angle);
	struct sum half = sum_of_double(copysign(0.5, angle));
	struct sum rounded = sum_add(sum_quotient(a, HALF_PI), half);
	const ex *q = &rounded.value;

	rounded = sum_truncate(rounded, q->e + q->n > 0 ? q->e + q->n : 0);
	a = sum_sub(a, sum_mul(rounded, HALF_PI));
	r->rest_degrees = (double)NAN;
	r->rest_radians = sum_truncate(a, REST_WORDS);
	r->quarters = q->n > 0 && q->e == 0 ? (unsigned)q->word[0] : 0;
	r->quarters *= (unsigned)q->sign;
}

/* Returns the sine of the rest x, exactly 0 if x is 0, from g(x). */
static struct sum sine_of_rest(const struct reduced_angle *r, const struct sum *g)
{
	if (fabs(r->rest_degrees) == 30)
		return sum_of_double(copysign(0.5, r->rest_degrees));
	return sum_with_error(sum_scale(twice_sine(g),
				  r->rest_radians.value.sign * 0.5),
	    SUM_TRIG_ERROR);
}

/* The cosine of the rest is 1 - g / 2, with g at most 0.6. So the error of g bounds
 * that of 1 - cos, too, which has its digits however small the angle is. */
void trig_sin_cos(double angle, enum angle_unit unit, struct sum *sine,
    struct sum *cosine)
{
	struct reduced_angle r;

	if (unit == ANGLE_RADIANS)
		reduce_radians(angle, &r);
	else
		reduce_degrees(angle, &r);
	const bool odd = r.quarters & 1, back = r.quarters & 2;
	struct sum square = sum_mul(r.rest_radians, r.rest_radians);
	struct sum g = squared_chord(&square.value);
	struct sum s = sine_of_rest(&r, &g);
	struct sum c = sum_sub(sum_one, sum_scale(g, 0.5));

	*sine = sum_negated_if(back, odd ? c : s);
	*cosine = sum_negated_if(back != odd, odd ? s : c);
}

struct sum trig_cot(double angle, enum angle_unit unit)
{
	struct sum s, c;

	if (unit == ANGLE_DEGREES && angle == 45)
		return sum_of_double(1);
	trig_sin_cos(angle, unit, &s, &c);
	return sum_quotient(c, s);
}

#define DEGREES_PER_RADIAN 57.29577951308232

/* Adds to the C library's atan2 the small angle that it lacks. Two terms of the arc
 * tangent's series give this angle from its tangent; the third bounds their error. As
 * the library is right to an ulp, or two in degrees, 2^-51 of the angle, the third is
 * below (2^-51 pi)^5 / pi, 2^-248, of it. */
struct sum trig_angle(struct sum y, struct sum x, enum angle_unit unit)
{
	struct sum abs_x = sum_abs(x);
	struct sum larger = sum_compare(y, abs_x) > 0 ? y : abs_x;
	double a = atan2(sum_ratio(y, larger), sum_ratio(x, larger));
	struct sum s, c;

	if (unit == ANGLE_DEGREES)
		a *= DEGREES_PER_RADIAN;
	trig_sin_cos(a, unit, &s, &c);
	struct sum tan = sum_quotient(sum_sub(sum_mul(y, c), sum_mul(x, s)),
	    sum_add(sum_mul(x, c), sum_mul(y, s)));
	struct sum square = sum_mul(tan, tan), cube = sum_mul(square, tan);
	struct sum rest = sum_sub(tan, sum_quotient(cube, sum_of_double(3)));

	rest = sum_add_error(rest, sum_mul(cube, square));
	if (unit == ANGLE_DEGREES)
		rest = sum_quotient(sum_scale(rest, 90),
		    sum_with_error(HALF_PI, SUM_TRIG_ERROR));
	return sum_add(sum_of_double(a), rest);
}

double trig_atan2(struct sum y, struct sum x, enum angle_unit unit)
{
	x = sum_snap_zero(x);
	y = sum_snap_zero(y);
	if (sum_sign(x) == 0 && sum_sign(y) == 0)
		return (double)NAN;
	return sum_double(trig_angle(y, x, unit));
}
