// SPDX-License-Identifier: MIT
/* Counts the errors of kernel/exact.h, doubled.h and approx.h, and compares them with
 * the bounds that these headers claim. Prints a line for each:
 *
 *	claim, claimed, found, proved or refused
 */
#include <algorithm>

#include "count.h"

using count::bound;
using count::fabs;
using count::fma;
using count::fmax;
using count::frexp;
using count::given;
using count::ldexp;
using count::number;
using count::plus;
using count::poly;
using count::sqrt;
using count::times;
using count::U;

/* The upper end of the last test of whether a rounding is sure. */
static number tested_up;

static number same(number up, number, number sure)
{
	tested_up = up;
	return sure;
}

#ifdef FUSED_MADD
#define MADD FMA
#else
#define MADD(a, b, c) ((a) * (b) + (c))
#endif
#define V number
#define WIDTH 1
#define LOAD(p) (*(p))
#define STORE(p, a) (*(p) = (a))
#define ALL(a) (number(a))
#define FMA(a, b, c) fma(a, b, c)
#define SQRT(a) sqrt(a)
#define ABS(a) fabs(a)
#define MIN(a, b) (a)
#define MAX(a, b) (a)
#define IF_EQUAL(a, b, c) same(a, b, c)
#define IF_POSITIVE(a, b, c) (b)
#define ALL_POSITIVE(a) ((a) > 0)
#define double number
#include "exact/dd.h"
#include "points/kernel/exact.h"
#include "points/kernel/doubled.h"

#define restrict
#define REAL number
#define R_FMA(a, b, c) fma(a, b, c)
#define W_MAX 1
#define NAME(x) counted_##x
#include "points/kernel/approx.h"

#undef double

/* A value far below any error that is counted, for operands whose own size must not
 * count, while the operations on them must. */
static const double small = 0x1p-300;

static int refusals;
static const double MILLIONTH = 1 + 1e-6;

/* Prints a claim, which may be exceeded by a millionth: the claims leave out terms of
 * higher order, which are as small. */
static void say(const char *claim, double claimed, double found, const char *unit)
{
	bool proved = found <= claimed * MILLIONTH;

	printf("%-36s %8.6g %8.6g %-6s %8.3g  %s\n", claim, claimed, found, unit,
	    claimed / found, proved ? "proved" : "REFUSED");
	refusals += !proved;
}

/* Prints a claim about powers of two, as exponents. */
static void say_powers(const char *claim, int claimed, int found)
{
	printf("%-36s %8d %8d %-6s 2^%-6d  %s\n", claim, claimed, found, "2^",
	    claimed - found, found <= claimed ? "proved" : "REFUSED");
	refusals += found > claimed;
}

static void fresh(void)
{
	count::bounds.clear();
	count::left_by_sum.clear();
	count::divisions.clear();
	count::nodes.clear();
	count::relative = false;
	count::lost = 0;
	count::answers = -1;
}

static poly exactly(number a)
{
	return a->is;
}

static poly minus(const poly &a, const poly &b)
{
	return count::plus(a, b, -1);
}

/* ex_round rounds a number to a double, and the rest to a second double. */
static void prove_round(void)
{
	fresh();
	say("ex_round: EX_ROUND_BOUND", EX_ROUND_BOUND, count::half_ulp(U) / (U * U),
	    "u^2");
}

/* ---- kernel/exact.h ---- */

static struct kernel_map map;
static number in[4], out[3]; /* ranges are read in pairs */
static poly difference[3];   /* a point minus the origin */

/* Makes a map for coordinates below 2^e and columns below 2^f, where e = f = 0. The low
 * part of an element is at most half a unit in the last place of its high part. */
static void give_map(double element, double image)
{
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++) {
			double most = i < 3 ? element : image;

			map.hi[i][j] = given(most);
			map.lo[i][j] = given(most * U / 2);
		}
	for (int j = 0; j < 4; j++)
		map.noise[j] = map.least_noise[j] = map.slope[j] = map.offset[j] =
		    number(0);
}

static void give_points(double size)
{
	for (int k = 0; k < 3; k++) {
		number d = given(size);

		map.origin[k] = given(HUGE_VAL);
		difference[k] = d->is;
		in[k] = number::add({ plus(d->is, map.origin[k]->is), HUGE_VAL, 0,
		    count::NO_UNIT, count::GIVEN, -1, -1, -1, -1 });
	}
}

static poly column_of(int j, int terms)
{
	poly s = plus(map.hi[3][j]->is, map.lo[3][j]->is);

	for (int k = 0; k < terms; k++)
		s = plus(s,
		    times(difference[k], plus(map.hi[k][j]->is, map.lo[k][j]->is)));
	return s;
}

static void run(enum kernel_kind kind)
{
	const number *const from[3] = { in, in + 1, in + 2 };
	number *const to[3] = { out, out + 1, out + 2 };

	exact_images(&map, from, to, 1, kind);
}

/* Returns hi + (lo + error), the upper end of the last test, without its rounding. */
static poly tested(void)
{
	const count::node &up = *tested_up;

	return up.error < 0 ? up.is : minus(up.is, { { { up.error }, 1.0 } });
}

/* The error of a column and the greatest values of its parts, in units of B, which
 * kernel/exact.h defines. If bit k of far is set, the origin's coordinate k is so large
 * that it is subtracted whole. */
struct column_parts {
	double error, hi, lo;
};

static column_parts column_error(int terms, int far)
{
	fresh();
	count::answers = ~far;
	give_map(1, 1);
	give_points(1);
	run(terms == 2 ? KERNEL_FLAT : KERNEL_AFFINE);
	const count::node &low = count::nodes[tested_up->b];
	poly wrong = minus(tested(), column_of(terms - 1, terms));
	const poly error = { { {}, COLUMN_BOUND } };

	/* + the error of elements, which are rounded to hi + lo */
	return { bound(minus(wrong, error)) + (terms + 1) * EX_ROUND_BOUND * U * U,
		count::nodes[tested_up->a].most, count::nodes[low.a].most };
}

/* Returns the error of a column after normalise, in units of B. */
static double normal_column_error(int far)
{
	const number *const from[3] = { in, in + 1, in + 2 };
	number cut[3], rest[3];

	fresh();
	count::answers = ~far;
	give_map(1, 1);
	give_points(1);
	const struct kernel_block b = block_of(&map, from, 1, KERNEL_DIRECTION);

	cut_points(&b, in, 2, cut, rest);
	vdd c = normalise(column_sum(&b.column[0], cut, rest, 2));

	return bound(minus(plus(c.hi->is, c.lo->is), column_of(0, 2))) +
	    3 * EX_ROUND_BOUND * U * U;
}

static number number_of(const poly &p, double most, double least)
{
	return number::add(
	    { p, most, least, count::NO_UNIT, count::GIVEN, -1, -1, -1, -1 });
}

/* A number head as the sum of two parts, of which the low part has a given size. */
struct sized {
	vdd parts;
	number head;
};

static sized sum_with(double head, double low)
{
	number h = given(head, head), lo = given(low);
	number hi = number_of(minus(h->is, lo->is), head + low, head - low);

	return { { hi, lo }, h };
}

/* Returns 1 / head, if head is the rounded sum of two parts. */
static number reciprocal_of(number head)
{
	number r = number(1) / head, e = given(U * (1 + 4 * U));

	return number_of(plus(r->is, e->is), r->most * (1 + 2 * U),
	    r->least * (1 - 2 * U));
}

/* Returns the error of a quotient, relative to it, as its operands are 1. */
static double quotient_error(double low_of_n, double low_of_w)
{
	fresh();
	count::relative = true;
	sized n = sum_with(1, low_of_n), w = sum_with(1, low_of_w);
	number sure = 1;

	quotient(n.parts, w.parts, reciprocal_of(w.head), given(small), 0, &sure);
	return bound(minus(times(tested(), w.head->is), n.head->is));
}

/* Returns head with a low part of at most 3 u, as after normalise(). */
static vdd pair(double head)
{
	return vdd{ given(head, head), given(3 * U * head) };
}

/* Returns the error of the length of a vector of equal elements, which is half the
 * error of its square, and raises *low to the greatest low part. */
static double length_error(int many, double *low)
{
	fresh();
	count::relative = true;
	vdd a[3];
	number reciprocal;
	poly square;

	for (int j = 0; j < 3; j++) {
		a[j] = pair(j < many ? 1 / std::sqrt((double)many) : small);
		square = plus(square,
		    times(plus(a[j].hi->is, a[j].lo->is),
			plus(a[j].hi->is, a[j].lo->is)));
	}
	vdd length = length_of(a, &reciprocal);
	poly is = plus(length.hi->is, length.lo->is);

	*low = std::fmax(*low, bound(length.lo->is) / (1 - 4 * U));
	return bound(minus(times(is, is), square)) / 2;
}

/* Returns the share of the error in the test of a quotient that is needed. The columns
 * of n and w have errors of a share of their bounds, and w is above its bound. The
 * quotient's own error is own |q|, where the test allows at least |q| least / most; the
 * error from low parts, of_low, is in units of B, as is the bound, least. */
static double share(double column, double most, double own, double of_low,
    double least = COLUMN_BOUND)
{
	double part = column / least;

	if (part >= 1)
		return HUGE_VAL;
	return (part / (1 - part) + (own * most + of_low) / least) * (1 + 16 * U);
}

/* Checks binary exponents for coordinates and B at the ends of the moderate range. All
 * underflows together are at most 16 times half the least double, multiplied by a
 * coordinate and by w. The largest number that is computed is 2 n / w, for a w at its
 * bound. */
static void prove_ends(void)
{
	const int far = std::ilogb(MODERATE);
	int least = std::ilogb(COLUMN_BOUND) - far;

	say_powers("what underflows, of the bound 2^-20", least - 20,
	    4 - 1075 + far + (far + 2));
	say_powers("what could overflow", 1022, far + 3 - least);
}

static void prove_exact(void)
{
	column_parts most = { 0, 0, 0 };
	double normal = 0, length = 0, low = 0;

	for (int far = 0; far < 8; far++)
		for (int terms = far < 4 ? 2 : 3; terms <= 3; terms++) {
			column_parts c = column_error(terms, far);

			most.error = std::fmax(most.error, c.error);
			most.hi = std::fmax(most.hi, c.hi);
			most.lo = std::fmax(most.lo, c.lo);
		}
	for (int far = 0; far < 4; far++)
		normal = std::fmax(normal, normal_column_error(far));
	for (int many = 1; many <= 3; many++)
		length = std::fmax(length, length_error(many, &low));
	const double q = quotient_error(0, 0),
		     of_low = std::fmax(quotient_error(most.lo, 0),
			 quotient_error(0, most.lo)),
		     d = quotient_error(3 * U, LENGTH_LOW * U) + length,
		     least = 0x1p-79, column = most.error;

	say("column, of 2^-79 B", COLUMN_UNITS, column / least, "2^-79");
	say("column: |hi| at most", 4 + 0x1p-23, most.hi, "B");
	say("column: |lo| at most", COLUMN_LOW, most.lo / 0x1p-26, "2^-26");
	say("quotient's own", QUOTIENT_BOUND, q / (U * U), "u^2");
	say("quotient: of low parts", QUOTIENT_LOW, of_low / U / most.lo, "u");
	say("quotient: share of its error", 1, share(column, most.hi, q, of_low), "");
	say("column, normalised", COLUMN_UNITS, normal / least, "2^-79");
	say("length", LENGTH_BOUND, length / (U * U), "u^2");
	say("length: its low part", LENGTH_LOW, low / U, "u");
	say("direction: share of its error", 1, share(normal, most.hi, d, 0), "");
}

/* ---- kernel/doubled.h, in units of S ---- */

/* Returns the error of a column of doubled.h in which this term alone is not small, and
 * raises *low to its low part. */
static double doubled_error(int term, double *low)
{
	fresh();
	count::relative = true;
	give_map(small, small);
	for (int j = 0; j < 4; j++) {
		map.hi[term][j] = given(1);
		map.lo[term][j] = given(U);
	}
	const struct doubled_map doubled = doubled_map_of(&map);
	struct doubled_point p;

	p.farthest = number(1);
	for (int k = 0; k < 3; k++) {
		double size = k == term ? 1 : small;

		p.size[k] = given(size);
		p.d[k] = vdd{ given(size), given(size * U) };
		difference[k] = plus(p.d[k].hi->is, p.d[k].lo->is);
	}
	number allowed, moderate = 1, sure = 1, error = given(DOUBLED_BOUND);
	vdd c = doubled_column(&doubled, 0, 3, &p, &allowed, &moderate);

	round_surely(c.hi, c.lo, error, &sure);
	*low = std::fmax(*low, c.lo->most);
	return bound(minus(minus(tested(), error->is), column_of(0, 3))) +
	    EX_ROUND_BOUND * U * U;
}

static void prove_doubled(void)
{
	double column = 0, low = 0;

	for (int term = 0; term < 4; term++)
		column = std::fmax(column, doubled_error(term, &low));
	const double q = quotient_error(0, 0),
		     of_low = std::fmax(quotient_error(low, 0), quotient_error(0, low));

	say("doubled: |lo| at most", DOUBLED_LOW, low / U, "u");
	say("doubled: column", DOUBLED_UNITS, column / (U * U), "u^2");
	say("doubled: share of its error", 1,
	    share(column, 1 + DOUBLED_LOW * U, q, of_low, DOUBLED_BOUND), "");
}

/* ---- kernel/approx.h, in units of u ---- */

static void run_approx(enum kernel_kind kind)
{
	const number *const from[3] = { in, in + 1, in + 2 };

	counted_approx(&map, from, out, out + 1, out + 2, 1, kind);
}

/* Makes a map in which row term is 1, with the error of one rounding, and other rows
 * are small. */
static void give_approx(int term)
{
	fresh();
	count::relative = true;
	give_map(small, small);
	give_points(small);
	for (int j = 0; j < 4; j++) {
		map.hi[term][j] = given(1);
		map.lo[term][j] = given(U * (1 + 0x1p-20));
	}
	if (term < 3) {
		count::bounds[difference[term].begin()->first[0]] = 1;
	}
	map.a = map.b = number(0);
}

/* Returns the error of a column, in u times the size of its term. */
static double approx_column(int term)
{
	give_approx(term);
	run_approx(KERNEL_AFFINE);
	return bound(minus(exactly(out[0]), column_of(0, 3))) / U;
}

static double approx_quotient(void)
{
	give_approx(3);
	run_approx(KERNEL_PROJECTIVE);
	const count::division &d = count::divisions.back();
	const count::node &q = *out[0];

	return bound(minus(times(q.is, { { { d.b }, 1.0 } }), count::nodes[q.a].is)) /
	    U;
}

static double approx_depth(double a, double b)
{
	give_approx(3);
	map.a = given(a);
	map.b = given(b);
	/* a and b are rounded */
	const double off = U * (1 + 0x1p-20);
	const number a_lo = given(off * a), b_lo = given(off * b);

	run_approx(KERNEL_DEPTH);
	const poly w = { { { count::divisions.back().b }, 1.0 } };
	poly right = plus(times(plus(map.a->is, a_lo->is), w),
	    plus(map.b->is, b_lo->is));

	return bound(minus(times(out[2]->is, w), right)) / U;
}

/* Returns the greatest error of a quotient. t is S / |w|, at least 1, and at most so
 * large that the bound that the loop needs is 1/16 of w. w has an error of c u S. One
 * term of the sum rises with t and one falls, so that the greatest sum is at one end of
 * the range. */
static double worst_of(double c, double own, double u)
{
	double last = 1 / (16 * (double)APPROX_BOUND * u), worst = 0;

	for (double t : { 1.0, last })
		worst = std::fmax(worst,
		    c / (1 - c * u * t) + own / t / (1 - c * u * t));
	return worst;
}

static void prove_approx(void)
{
	double c = 0;

	for (int term = 0; term < 4; term++)
		c = std::fmax(c, approx_column(term));
	/* + 1: the shortest digits are off by up to u */
	double q = approx_quotient() + 1;
	double a = approx_depth(1, small) + 1, b = approx_depth(small, 1) + 1;
	/* for the rounding of the bound; u is float's, whose higher powers count */
	const double u = 0x1p-24, own = 1 - 32 * u;

	say("approx column", 5, c, "u S");
	say("approx quotient: APPROX_BOUND", APPROX_BOUND, worst_of(c, q, u) / own,
	    "u");
	say("approx depth, of a: APPROX_BOUND", APPROX_BOUND, a / own, "u");
	say("approx depth, of b/w: APPROX_BOUND", APPROX_BOUND, worst_of(c, b, u) / own,
	    "u");
}

/* ---- estimates of signs, in units of u of what their products are ---- */

static void prove_estimate(void)
{
	double most = 0;

	for (int term = 0; term < 4; term++) {
		give_approx(term);
		number p[3];

		for (int k = 0; k < 3; k++)
			p[k] = in[k] - map.origin[k];
		most = std::fmax(most,
		    bound(minus(exactly(estimate_column(map.hi, 0, p[0], p[1], p[2])),
			column_of(0, 3))));
	}
	say("estimate: ESTIMATE_BOUND", ESTIMATE_BOUND / U, most / U, "u");
}

int main()
{
	prove_round();
	prove_exact();
	prove_ends();
	prove_doubled();
	prove_approx();
	prove_estimate();
	return refusals > 0;
}
