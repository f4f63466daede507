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

/* The number of words of a reduced angle and of each term of its series. */
enum { SINE_WORDS = 6 };

/* Returns 1 - y/((n+1)(n+2)) + y^2/((n+1)...(n+4)) - ... up to y^(last/2). For y = x^2
 * this is sin x / x (n = 1) or 2 (1 - cos x) / x^2 (n = 2). Horner's
 * scheme computes the sum as s / c, with the common denominator c. y and each s are cut
 * to `words` words; each cut loses less than one unit of the last word. */
static struct sum trig_series(const ex *y, int n, int last, int words)
{
	ex minus, c = ex_of(1), s = c, factor = c;
	const ex *const a[] = { &c, &s }, *const b[] = { &factor, &minus };

	ex_truncate(y, words, &minus);
	minus.sign = -minus.sign;
	for (int k = n + last; k > n; k -= 2) {
		factor.word[0] = (uint64_t)(k * (k - 1));
		ex_dot(2, a, b, 64 * (c.e + c.n - words), &s);
		ex_dot(1, a, b, INT_MIN, &c);
	}
	struct sum r = { .error = 0 };

	ex_divide(&s, &c, EX_QUOTIENT_WORDS, &r.value);
	return sum_with_error(r, SUM_TRIG_ERROR);
}

/* The last power of x in the series for |x| <= pi / 4. The first term left out is
 * x^64/64! < 2^-317. Cutting x^2 once and the sum 32 times loses less than 2^-319. */
enum { SINE_POWER = 62 };

/* The last power of x in the series for x^2 <= 4 pi^2, and the words of its terms, for
 * an absolute error of 2^-670: the first term left out, x^192/192!, is below 2^-675.
 * (1 - cos x) / x^2 is 0 at 2 pi. Near 2 pi it can be as small as 2^-332, as the sum
 * of the squares of three doubles can be as near to 4 pi^2 as 2^-159. */
enum { SINC_POWER = 190, SINC_WORDS = 12 };

/* The same for x^2 < 9, where a and b are above 2^-5: x^92/92! is below 2^-325,
 * and the cuts lose less than 2^-370. */
enum { SHORT_SINC_POWER = 90, SHORT_SINC_WORDS = 7 };

bool trig_rodrigues(struct sum square, struct sum *a, struct sum *b)
{
	if (sum_compare(square, sum_scale(sum_mul(HALF_PI, HALF_PI), 16)) > 0)
		return false;
	const bool is_short = sum_compare(square, sum_of_double(9)) < 0;
	const int power = is_short ? SHORT_SINC_POWER : SINC_POWER;
	const int words = is_short ? SHORT_SINC_WORDS : SINC_WORDS;

	*a = trig_series(&square.value, 1, power, words);
	*b = sum_scale(trig_series(&square.value, 2, power, words), 0.5);
	return true;
}

/* An angle modulo 360 degrees: quarters times 90 degrees plus a rest from -45 to 45. */
struct reduced_angle {
	double rest_degrees;     /* nan if the angle is in radians */
	struct sum rest_radians; /* cut to SINE_WORDS words */
	unsigned quarters;
};

/* Reduces degrees. fmod is exact, and so is the subtraction (Sterbenz's lemma). */
static void reduce_degrees(double angle, struct reduced_angle *r)
{
	double rest = fmod(angle, 360), q = rint(rest / 90);

	r->rest_degrees = rest - 90 * q;
	r->rest_radians = sum_truncate(sum_quotient(sum_scale(HALF_PI, r->rest_degrees),
					   sum_of_double(90)),
	    SINE_WORDS);
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
	r->rest_radians = sum_truncate(a, SINE_WORDS);
	r->quarters = q->n > 0 && q->e == 0 ? (unsigned)q->word[0] : 0;
	r->quarters *= (unsigned)q->sign;
}

/* The sine is the rest times the series, and so exactly 0 if the rest is 0. */
static struct sum sine_of_rest(const struct reduced_angle *r)
{
	if (fabs(r->rest_degrees) == 30)
		return sum_of_double(copysign(0.5, r->rest_degrees));
	struct sum square = sum_mul(r->rest_radians, r->rest_radians);
	struct sum s = trig_series(&square.value, 1, SINE_POWER, SINE_WORDS);

	return sum_mul(s, r->rest_radians);
}

/* The sine of the rest is at most sqrt(1/2), so its error hardly changes the cosine's. */
void trig_sin_cos(double angle, enum angle_unit unit, struct sum *sine,
    struct sum *cosine)
{
	const struct sum one = sum_of_double(1);
	struct reduced_angle r;

	if (unit == ANGLE_RADIANS)
		reduce_radians(angle, &r);
	else
		reduce_degrees(angle, &r);
	const bool odd = r.quarters & 1, back = r.quarters & 2;
	struct sum s = sine_of_rest(&r);
	struct sum c = sum_sqrt(sum_sub(one, sum_mul(s, s)));

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
 * tangent's series give this angle from its tangent; the third bounds their error. */
double trig_atan2_degrees(struct sum y, struct sum x)
{
	x = sum_snap_zero(x);
	y = sum_snap_zero(y);
	struct sum abs_x = sum_abs(x);
	struct sum larger = sum_compare(y, abs_x) > 0 ? y : abs_x;

	if (sum_sign(larger) == 0)
		return (double)NAN;
	double a = atan2(sum_ratio(y, larger), sum_ratio(x, larger)) *
	    DEGREES_PER_RADIAN;
	struct sum s, c;

	trig_sin_cos(a, ANGLE_DEGREES, &s, &c);
	struct sum tan = sum_quotient(sum_sub(sum_mul(y, c), sum_mul(x, s)),
	    sum_add(sum_mul(x, c), sum_mul(y, s)));
	struct sum square = sum_mul(tan, tan), cube = sum_mul(square, tan);
	struct sum rest = sum_sub(tan, sum_quotient(cube, sum_of_double(3)));

	rest = sum_add_error(rest, sum_mul(cube, square));
	rest = sum_quotient(sum_scale(rest, 90),
	    sum_with_error(HALF_PI, SUM_TRIG_ERROR));
	return sum_double(sum_add(sum_of_double(a), rest));
}
