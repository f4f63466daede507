/* SPDX-License-Identifier: MIT */
/* Numbers of P binary digits, P <= 24, of which many operands can be tried. The headers
 * under test are compiled with these numbers in place of doubles. Exponents have no
 * limits. If P is 53, the numbers are doubles. */
#pragma once

#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

typedef __float128 wide;

static const double U = std::ldexp(1, -P); /* the unit roundoff */

#if P == 53
typedef double toy;

/* Returns x, as a double is already rounded to 53 digits. */
static inline double nearest(double x)
{
	return x;
}
static inline double to_odd(double a, double b)
{
	return a + b;
}
#else
/* Returns x rounded to P digits, ties to even. A sum that lost bits as a double must
 * not look like a tie of P digits, so sums are rounded by to_odd() first. */
static inline double nearest(double x)
{
	const int cut = 53 - P;
	uint64_t b;

	if (!(std::fabs(x) <= DBL_MAX))
		return x;
	memcpy(&b, &x, sizeof b);
	b += ((uint64_t)1 << (cut - 1)) - 1 + (b >> cut & 1);
	b &= ~(((uint64_t)1 << cut) - 1);
	memcpy(&x, &b, sizeof x);
	return x;
}

/* Returns a + b or, if that loses bits, the double next to it whose last bit is 1. */
static inline double to_odd(double a, double b)
{
	double s = a + b, t = s - a, rest = (a - (s - t)) + (b - t);
	uint64_t bits;

	memcpy(&bits, &s, sizeof bits);
	if (rest != 0 && (bits & 1) == 0)
		bits += (rest > 0) == (s > 0) ? 1 : -1;
	memcpy(&s, &bits, sizeof s);
	return s;
}

struct toy {
	double v;

	toy() = default;
	toy(double a) : v(a)
	{
	}
	friend toy operator+(toy a, toy b)
	{
		return nearest(to_odd(a.v, b.v));
	}
	friend toy operator-(toy a, toy b)
	{
		return nearest(to_odd(a.v, -b.v));
	}
	/* Products have 48 digits; no quotient of 24 digits is nearly a tie. */
	friend toy operator*(toy a, toy b)
	{
		return nearest(a.v * b.v);
	}
	friend toy operator/(toy a, toy b)
	{
		return nearest(a.v / b.v);
	}
	toy operator-() const
	{
		return -v;
	}
	toy &operator+=(toy b)
	{
		return *this = *this + b;
	}
	friend bool operator==(toy a, toy b)
	{
		return a.v == b.v;
	}
	friend bool operator<(toy a, toy b)
	{
		return a.v < b.v;
	}
	friend bool operator>(toy a, toy b)
	{
		return a.v > b.v;
	}
};

static inline toy fma(toy a, toy b, toy c)
{
	return nearest(to_odd(a.v * b.v, c.v));
}
static inline toy sqrt(toy a)
{
	return nearest(std::sqrt(a.v));
}
static inline toy fabs(toy a)
{
	return std::fabs(a.v);
}
static inline toy fmax(toy a, toy b)
{
	return std::fmax(a.v, b.v);
}
static inline toy ldexp(toy a, int e)
{
	return std::ldexp(a.v, e);
}
static inline toy frexp(toy a, int *e)
{
	return std::frexp(a.v, e);
}

#endif

/* As in baseline.c or, if FUSED is defined, with the fused products of the other
 * copies. */
#ifdef FUSED
#define MADD FMA
#else
#define MADD(a, b, c) ((a) * (b) + (c))
#endif
#define V toy
#define WIDTH 1
#define LOAD(p) (*(p))
#define STORE(p, a) (*(p) = (a))
#define ALL(a) (toy(a))
#define FMA(a, b, c) fma(a, b, c)
#define SQRT(a) sqrt(a)
#define ABS(a) fabs(a)
#define MIN(a, b) ((a) < (b) ? (a) : (b))
#define MAX(a, b) ((a) > (b) ? (a) : (b))
#define IF_EQUAL(a, b, c) ((a) == (b) ? (c) : toy(0))
#define IF_POSITIVE(a, b, c) ((a) > 0 ? toy(b) : toy(c))
#define ALL_POSITIVE(a) ((a) > 0)

/* For 53 digits, as in exact.h: 128 u 2^-26. */
#define DIGITS P
#define COLUMN_BOUND (128 * U / (1 << (P - 1) / 2))
#define DOUBLED_BOUND (256 * U * U)
#define MODERATE 0x1p200

static inline double at(toy a)
{
#if P == 53
	return a;
#else
	return a.v;
#endif
}

#define double toy
#include "exact/dd.h"
#include "points/kernel/exact.h"
#include "points/kernel/doubled.h"
#undef double

static inline wide value(dd a)
{
	return (wide)at(a.hi) + at(a.lo);
}

/* Returns a number below n from a fixed pseudo-random sequence (Marsaglia's xorshift).
 */
static inline unsigned below(unsigned n)
{
	static uint64_t s = 88172645463325252u;

	s ^= s << 13;
	s ^= s >> 7;
	s ^= s << 17;
	return (unsigned)(s >> 33) % n;
}

/* The last digit of a head, which is a number of P digits with 1 <= head < 2. */
static const double LAST = 2 * U;

static inline double head(void)
{
	double most = std::fmin(1 / LAST, 0x1p31);

	switch (below(8)) {
	case 0:
		return 1 + below(4) * LAST;
	case 1:
		return 2 - (1 + below(4)) * LAST;
	default:
		return 1 + std::floor(below((unsigned)most) / most / LAST) * LAST;
	}
}

static inline int failed(const char *what)
{
	printf("not ok - %s, P = %d\n", what, P);
	return 1;
}
