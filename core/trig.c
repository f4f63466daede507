#include "trig.h"

/* pi / 180, within 2^-378 relative. */
static const ex RADIAN = { 1, 6, -6,
	{ 0x38862864b4ea8a06, 0x95b7b08b3c0c88a4, 0xc728154da64a6428,
	    0xc805bd77a80daf35, 0x70762fb374a42e26, 0x0477d1a894a74e45 } };

/* Words that the terms of a series keep. */
enum { WORDS = 6 };

/* 1 - x^2/((n+1)(n+2)) + x^4/((n+1)...(n+4)) - ..., for the sine (n = 1) or the
 * cosine (n = 0) of |x| <= pi/4. Over the common denominator all coefficients are
 * whole numbers. The first term that is left out, x^64/64!, is below 2^-317; what
 * six words cut off is below 2^-319, 32 times. */
static ex series(ex x, int n)
{
	ex x2 = ex_first(ex_mul(x, x), WORDS), c = ex_of(1), s = c;

	for (int k = n + 62; k > n; k -= 2) {
		c = ex_scale(c, (double)(k * (k - 1)));
		s = ex_first(ex_sub(c, ex_mul(s, x2)), WORDS);
	}
	return ex_quotient(s, c);
}

/* Both for |a| <= 45. */
static struct sum sin_small(double a)
{
	if (a == 0)
		return sum_of_double(0);
	if (fabs(a) == 30)
		return sum_of_double(copysign(0.5, a));
	if (fabs(a) == 45)
		return sum_inexact(
		    ex_scale(ex_sqrt(ex_of(0.5)), copysign(1, a)));
	ex x = ex_first(ex_scale(RADIAN, a), WORDS);

	return sum_inexact(ex_mul(x, series(x, 1)));
}

static struct sum cos_small(double a)
{
	if (a == 0)
		return sum_of_double(1);
	if (fabs(a) == 45)
		return sin_small(45);
	return sum_inexact(series(ex_first(ex_scale(RADIAN, a), WORDS), 0));
}

/* sin(a + 90 turns): fmod is exact, and so is r - 90 q, by Sterbenz. */
static struct sum sine(double a, int turns)
{
	double r = fmod(a, 360), q = rint(r / 90);

	r -= 90 * q;
	switch (((int)q + turns) & 3) {
	case 0:
		return sin_small(r);
	case 1:
		return cos_small(r);
	case 2:
		return sin_small(-r);
	default:
		return sum_neg(cos_small(r));
	}
}

struct sum sin_deg(double angle)
{
	return sine(angle, 0);
}

struct sum cos_deg(double angle)
{
	return sine(angle, 1);
}

/* 90 - angle is exact for angles of 45 and more, 180 - angle of 90 and more. */
struct sum cot_deg(double angle)
{
	if (angle == 45)
		return sum_of_double(1);
	if (angle > 45)
		return sum_quotient(sin_deg(90 - angle), cos_deg(90 - angle));
	return sum_quotient(cos_deg(angle), sin_deg(angle));
}

struct sum cot_half_deg(double angle)
{
	if (angle <= 90)
		return cot_deg(angle / 2);
	double a = (180 - angle) / 2;

	return sum_quotient(sin_deg(a), cos_deg(a));
}

struct sum in_degrees(struct sum angle)
{
	return sum_quotient(angle, sum_inexact(RADIAN));
}
