#include "trig.h"

#include "expansion.h"

/* pi / 180 to three terms: 2^-160 relative. */
static const double RADIAN[3] = {
	0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62, -0x1.1d937fa428858p-116
};

/* x to four terms. */
static ex radians(double a)
{
	ex r = { 0 };

	for (int i = 2; i >= 0; i--)
		r = ex_add(r, ex_scale(ex_of(RADIAN[i]), a));
	return r;
}

/* 1 - x^2/((n+1)(n+2)) + x^4/((n+1)...(n+4)) - ..., for the sine (n = 1, to be
 * multiplied by x) or the cosine (n = 0). Over the common denominator all
 * coefficients are whole numbers; what is cut off, beyond 2^-200 and beyond
 * x^28/28!, is below 2^-106 even of sqrt(1/2). Rounded once: 1.1 u^2. */
static dd series(ex x, int n, ex times)
{
	ex x2 = ex_first(ex_mul(x, x), 4), c = ex_of(1), s = c;

	for (int k = n + 28; k > n; k -= 2) {
		c = ex_scale(c, (double)(k * (k - 1)));
		s = ex_sub(c, ex_mul(s, x2));
		s = ex_first(s, 4);
	}
	return ex_div(ex_mul(s, times), c);
}

/* Both for |a| <= 45. */
static dd sin_small(double a)
{
	if (fabs(a) == 30)
		return (dd){ copysign(0.5, a), 0 };
	if (fabs(a) == 45) {
		dd half = ex_round(ex_sqrt(ex_of(0.5)));

		return a < 0 ? dd_neg(half) : half;
	}
	ex x = radians(a);

	return series(x, 1, x);
}

static dd cos_small(double a)
{
	return fabs(a) == 45 ? sin_small(45) : series(radians(a), 0, ex_of(1));
}

/* sin(a + 90 turns): fmod is exact, and so is r - 90 q, by Sterbenz. */
static dd sine(double a, int turns)
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
		return dd_neg(cos_small(r));
	}
}

dd sin_deg(double angle)
{
	return sine(angle, 0);
}

dd cos_deg(double angle)
{
	return sine(angle, 1);
}

dd cot_deg(double angle)
{
	dd s = angle > 45 ? cos_deg(90 - angle) : sin_deg(angle);
	dd c = angle > 45 ? sin_deg(90 - angle) : cos_deg(angle);

	return ex_div(ex_dd(c), ex_dd(s));
}

/* 180 - angle is exact for angles of 90 and more. */
dd cot_half_deg(double angle)
{
	if (angle <= 90)
		return cot_deg(angle / 2);
	double a = (180 - angle) / 2;

	return ex_div(ex_dd(sin_deg(a)), ex_dd(cos_deg(a)));
}
