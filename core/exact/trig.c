/* SPDX-License-Identifier: MIT */
#include "trig.h"

#include <limits.h>

/* pi / 2, with a relative error below 2^-963. */
static const struct sum QUARTER = {
	{ 1, 16, -15,
	    { 0x8400f97142c77e0b, 0x9250cca3d9c8b67b, 0x5d3e4822f8963fcc,
		0xdc70d7f6b5133f4b, 0x17feb96de80d6fdb, 0xe89885d34c6fdad6,
		0xc90b6aecc4bcfd8d, 0x9fc26adadaa3848b, 0x605614dbe4be286e,
		0xdf2a33679a748636, 0xa29410f31c6809bb, 0x04177d4c76273644,
		0x52049c1114cf98e8, 0x898cc51701b839a2, 0x921fb54442d18469,
		1 } },
	0
};

/* How many words an angle and the terms of its series keep. */
enum { SINE_WORDS = 6 };

/* Returns 1 - y/((n+1)(n+2)) + y^2/((n+1)...(n+4)) - ... up to y^(last/2). For y = x^2
 * this is cos x (n = 0), or sin x / x (n = 1). Over the common denominator all
 * coefficients are whole numbers. y, and the sum after each term, are cut by less than
 * 1 in the last word that is kept. */
static ex series(ex y, int n, int last, int words)
{
	ex minus = ex_truncate(y, words), c = ex_of(1), s = c, step = c;
	const ex *const a[] = { &c, &s }, *const b[] = { &step, &minus };

	minus.sign = -minus.sign;
	for (int k = n + last; k > n; k -= 2) {
		step.word[0] = (uint64_t)(k * (k - 1));
		ex_dot(2, a, b, 64 * (c.e + c.n - words), &s);
		ex_dot(1, a, b, INT_MIN, &c);
	}
	ex_divide(&s, &c, EX_QUOTIENT, &step);
	return step;
}

/* The last power of x for |x| <= pi / 4. The first term left out, x^64/64!, is below
 * 2^-317; the truncations, of x^2 and 32 times of the sum, are below 2^-319. */
enum { SINE_POWER = 62 };

/* The last power of x for x^2 <= 4 pi^2, and the words of its terms, for an absolute
 * error of 2^-500. The sum can be as small as 2^-8 of its terms or, for doubles whose
 * squares sum to nearly pi^2, as 2^-160. The first term left out, x^170/170!, is below
 * 2^-560. */
enum { SINC_POWER = 168, SINC_WORDS = 11 };

bool trig_sinc(struct sum square, struct sum *sinc, struct sum *versinc)
{
	if (sum_compare(square, sum_scale(sum_mul(QUARTER, QUARTER), 16)) > 0)
		return false;
	ex s = series(square.value, 1, SINC_POWER, SINC_WORDS);
	ex v = series(square.value, 2, SINC_POWER, SINC_WORDS);

	*sinc = sum_with_error(s, SUM_TRIG_ERROR);
	*versinc = sum_scale(sum_with_error(v, SUM_TRIG_ERROR), 0.5);
	return true;
}

/* An angle, reduced: quarters times 90 degrees, modulo 360, plus a rest from -45 to 45
 * degrees. */
struct reduced {
	double degrees; /* the rest; nan where the angle is given in radians */
	struct sum radians; /* the rest, truncated */
	unsigned quarters;
};

static struct sum angle_rest(struct sum a)
{
	return sum_with_error(ex_truncate(a.value, SINE_WORDS), 0);
}

/* Reduces degrees. fmod is exact, and so is rest - 90 q, by Sterbenz's lemma. */
static void reduce_degrees(double angle, struct reduced *r)
{
	double rest = fmod(angle, 360), q = rint(rest / 90);

	r->degrees = rest - 90 * q;
	r->radians = angle_rest(
	    sum_quotient(sum_scale(QUARTER, r->degrees), sum_of_double(90)));
	r->quarters = (unsigned)(int)q;
}

/* Reduces radians. The rest of an angle below 2^500 has an error within 2^-460. A
 * double that is not below 2^-64 is no closer than 2^-64 to a multiple of pi / 2 other
 * than 0 (J.-M. Muller, "Elementary Functions", on range reduction). The relative error
 * is therefore within 2^-396. */
static void reduce_radians(double angle, struct reduced *r)
{
	struct sum a = sum_of_double(angle);
	struct sum half = sum_of_double(copysign(0.5, angle));
	ex q = sum_add(sum_quotient(a, QUARTER), half).value;

	q = ex_truncate(q, q.e + q.n > 0 ? q.e + q.n : 0);
	a = sum_sub(a, sum_mul(sum_with_error(q, 0), QUARTER));
	r->degrees = (double)NAN;
	r->radians = angle_rest(a);
	r->quarters = q.n > 0 && q.e == 0 ? (unsigned)q.word[0] : 0;
	r->quarters *= (unsigned)q.sign;
}

/* Returns the sine (n = 1) or the cosine (n = 0) of the rest of a reduced angle. The
 * sine of 0 is exactly 0, as the error is relative. */
static struct sum sine_of_rest(const struct reduced *r, int n)
{
	if (n == 0 && r->radians.value.sign == 0)
		return sum_of_double(1);
	if (n == 1 && fabs(r->degrees) == 30)
		return sum_of_double(copysign(0.5, r->degrees));
	struct sum s =
	    sum_with_error(series(sum_mul(r->radians, r->radians).value, n,
			       SINE_POWER, SINE_WORDS),
		SUM_TRIG_ERROR);

	return n == 1 ? sum_mul(s, r->radians) : s;
}

/* Returns the sine of the angle plus quarters times 90 degrees. */
static struct sum sine(double angle, enum angle_unit unit, unsigned quarters)
{
	struct reduced r;

	if (unit == RADIANS)
		reduce_radians(angle, &r);
	else
		reduce_degrees(angle, &r);
	quarters += r.quarters;
	return sum_negated_if(quarters & 2, sine_of_rest(&r, ~quarters & 1));
}

struct sum trig_sin(double angle, enum angle_unit unit)
{
	return sine(angle, unit, 0);
}

struct sum trig_cos(double angle, enum angle_unit unit)
{
	return sine(angle, unit, 1);
}

struct sum trig_cot(double angle, enum angle_unit unit)
{
	if (unit == DEGREES && angle == 45)
		return sum_of_double(1);
	return sum_quotient(trig_cos(angle, unit), trig_sin(angle, unit));
}

static struct sum to_degrees(struct sum angle)
{
	return sum_quotient(sum_scale(angle, 90),
	    sum_with_error(QUARTER.value, SUM_TRIG_ERROR));
}

#define DEGREE 57.29577951308232

/* Corrects the C library's atan2 by the arc tangent of the angle that remains. Two
 * terms of its series are summed; the third bounds the error. */
double trig_degrees(struct sum y, struct sum x)
{
	x = sum_snap_zero(x);
	y = sum_snap_zero(y);
	struct sum size = sum_abs(x);
	struct sum most = sum_compare(y, size) > 0 ? y : size;

	if (sum_sign(most) == 0)
		return (double)NAN;
	double a = atan2(sum_ratio(y, most), sum_ratio(x, most)) * DEGREE;
	struct sum s = trig_sin(a, DEGREES), c = trig_cos(a, DEGREES);
	struct sum tan = sum_quotient(sum_sub(sum_mul(y, c), sum_mul(x, s)),
	    sum_add(sum_mul(x, c), sum_mul(y, s)));
	struct sum square = sum_mul(tan, tan), cube = sum_mul(square, tan);
	struct sum rest = sum_sub(tan, sum_quotient(cube, sum_of_double(3)));

	rest = sum_add_error(rest, sum_mul(cube, square));
	return sum_double(sum_add(sum_of_double(a), to_degrees(rest)));
}
