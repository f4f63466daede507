// SPDX-License-Identifier: MIT
/* dd.h in toy arithmetic, over nearly all operands: transformations without error
 * have none, and relative errors are below what dd.h claims, given here by the
 * names DD_ADD, DD_MUL, DD_DIV. quick.h's sum is dd_add's, and exact where it says
 * so. */
#include "toy.h"

#define double toy
#include "quick.h"
#undef double

/* The claims are of so many u^2 and of higher powers of u that 53 digits make
 * nothing of; so few digits do. */
static const double MORE = 1 / (1 - 8 * U);

static dd words[1 << 16];
static int many;

/* All with hi in [1, 2), and lo down to u^2 of it; every stride-th. */
static void fill(int stride)
{
	const int half = 1 << (P - 1);
	int k = 0;

	for (int i = 0; i < half; i++)
		for (int e = 0; e <= P; e++)
			for (int j = -half; j < half; j++) {
				double hi = 1 + (double)i / half;
				double lo = ldexp((j < 0 ? j - half :
							   j + half) /
					(double)half,
				    -P - e);

				if (nearest(hi + lo) == hi && k++ % stride == 0)
					words[many++] = dd{ hi, lo };
				if (e == 0 && j == 0)
					words[many++] = dd{ hi, 0.0 };
			}
}

static double most[3];

static void note(int k, wide error, wide exact)
{
	double e = (double)(error / exact) / (U * U);

	most[k] = std::fmax(most[k], std::fabs(e));
}

/* 0 where all is well. */
static int pair(dd a, dd b)
{
	wide x = value(a), y = value(b);
	dd p = two_prod(a.hi, b.hi);

	note(1, value(dd_mul(a, b)) - x * y, x * y);
	note(2, value(dd_div(a, b)) * y - x, x);
	return value(p) != (wide)a.hi.v * b.hi.v;
}

static int scaled(dd a, dd b)
{
	int wrong = 0;

	for (int e = -2 * P - 2; e <= 2 * P + 2; e++)
		for (int sign = -1; sign <= 1; sign += 2) {
			dd c = dd_scale(b, sign * ldexp(1.0, e));
			wide exact = value(a) + value(c);
			wide heads = (wide)a.hi.v + c.hi.v;
			bool sure = true;
			dd s = dd_add(a, c), q = quick_sum(a, c, &sure);

			if (exact != 0)
				note(0, value(s) - exact, exact);
			wrong |= exact == 0 && value(s) != 0;
			wrong |= value(q) != value(s);
			wrong |= sure && value(q) != exact;
			wrong |= nearest(s.hi.v + s.lo.v) != s.hi.v;
			wrong |= value(two_sum(a.hi, c.hi)) != heads;
			wrong |= std::fabs(a.hi.v) >= std::fabs(c.hi.v) &&
			    value(fast_two_sum(a.hi, c.hi)) != heads;
		}
	return wrong;
}

int main()
{
	const double claim[] = { DD_ADD, DD_MUL, DD_DIV };
	const char *const name[] = { "dd_add", "dd_mul", "dd_div" };
	int wrong = 0;

	fill(P < 5 ? 1 : P < 6 ? 7 : 37);
	for (int i = 0; i < many; i++)
		for (int j = 0; j < many; j++) {
			wrong |= pair(words[i], words[j]);
			if ((i + j) % (P < 5 ? 9 : 7) == 0)
				wrong |= scaled(words[i], words[j]);
		}
	if (wrong)
		return failed("a transformation has an error");
	for (int k = 0; k < 3; k++) {
		printf("# P = %d, %d numbers: %s %.3f u^2, claimed %g\n", P,
		    many, name[k], most[k], claim[k]);
		if (most[k] > claim[k] * MORE)
			return failed(name[k]);
	}
	return 0;
}
