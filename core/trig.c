#include "trig.h"

/* pi / 180, within 2^-226 relative. */
static const double RADIAN[4] = { 0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62,
	-0x1.1d937fa428858p-116, 0x1.b5e6b8e502a9bp-173 };

static ex radians(double a)
{
	ex r = ex_of(0);

	for (int i = 3; i >= 0; i--)
		r = ex_add(r, ex_scale(ex_of(RADIAN[i]), a));
	return r;
}

/* 1 - x^2/((n+1)(n+2)) + x^4/((n+1)...(n+4)) - ..., for the sine (n = 1) or the
 * cosine (n = 0). Over the common denominator all coefficients are whole
 * numbers; the first term that is left out, x^48/48!, is below 2^-219, and what
 * five terms cut off is below 2^-250, 24 times. */
static ex series(ex x, int n)
{
	ex x2 = ex_first(ex_mul(x, x), 5), c = ex_of(1), s = c;

	for (int k = n + 46; k > n; k -= 2) {
		c = ex_scale(c, (double)(k * (k - 1)));
		s = ex_first(ex_sub(c, ex_mul(s, x2)), 5);
	}
	return ex_quotient(s, c);
}

/* Both for |a| <= 45. */
static ex sin_small(double a)
{
	if (fabs(a) == 30)
		return ex_of(copysign(0.5, a));
	if (fabs(a) == 45)
		return ex_scale(ex_sqrt(ex_of(0.5)), copysign(1, a));
	ex x = radians(a);

	return ex_mul(x, series(x, 1));
}

static ex cos_small(double a)
{
	return fabs(a) == 45 ? sin_small(45) : series(radians(a), 0);
}

/* sin(a + 90 turns): fmod is exact, and so is r - 90 q, by Sterbenz. */
static ex sine(double a, int turns)
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
		return ex_neg(cos_small(r));
	}
}

ex sin_deg(double angle)
{
	return sine(angle, 0);
}

ex cos_deg(double angle)
{
	return sine(angle, 1);
}

ex cot_deg(double angle)
{
	if (angle > 45)
		return ex_quotient(sin_deg(90 - angle), cos_deg(90 - angle));
	return ex_quotient(cos_deg(angle), sin_deg(angle));
}

/* 180 - angle is exact for angles of 90 and more. */
ex cot_half_deg(double angle)
{
	if (angle <= 90)
		return cot_deg(angle / 2);
	double a = (180 - angle) / 2;

	return ex_quotient(sin_deg(a), cos_deg(a));
}
