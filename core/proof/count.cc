/* Counts the errors of dd.h, quick.h, kernel/exact.h and kernel/plain.h and compares them
 * with the bounds that are claimed there. A line for each:
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

/* Of the last test whether a rounding is sure. */
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
#define ABS(a) fabs(a)
#define MIN(a, b) (a)
#define MAX(a, b) (a)
#define SAME(a, b, c) same(a, b, c)
#define CHOOSE(a, b, c) (b)
#define IS_POSITIVE(a) ((a) > 0)
#define double number
#include "dd.h"
#include "kernel/exact.h"

static bool isfinite(number)
{
	return true;
}
#define COLUMN number
#define REAL number
#define R number
#define R_WIDTH 1
#define R_NEAR(p, o) (*(p) - (o))
#define R_STORE(p, a) (*(p) = (a))
#define R_ALL(a) (number(a))
#define R_FMA(a, b, c) fma(a, b, c)
#define R_ABS(a) fabs(a)
#define R_MAX(a, b) (a)
#define R_POSITIVE(a, b) (b)
#define ROUNDOFF 0x1p-53
#define TINY 0
#define MOST 1
#define NAME(x) counted_##x
#include "kernel/plain.h"

#include "quick.h"

struct ray_maker {
	struct {
		struct kernel_map for_kernel;
	} to_world, to_view, turn;
	number depth;
	bool against;
};

namespace whole
{
#include "ray_length.h"
}

/* What a ray's direction is made of, before anything is divided. */
static struct quick directions[3];

static struct quick length_of(const struct quick to[3])
{
	for (int j = 0; j < 3; j++)
		directions[j] = to[j];
	return QUICK_ONE;
}

#define quick_over(n, d, q) (*(q) = (n).value.hi, true)
#include "ray_sums.h"
#undef quick_over
#undef double

/* Than any error that is counted: for what shall not count, though its operations
 * do. */
static const double small = 0x1p-300;

static int refusals;
static const double MILLIONTH = 1 + 1e-6;

/* Counted to a millionth: terms of higher order than is told are as small. */
static void say(const char *claim, double claimed, double found,
    const char *unit)
{
	bool proved = found <= claimed * MILLIONTH;

	printf("%-36s %8.6g %8.6g %-6s %8.3g  %s\n", claim, claimed, found,
	    unit, claimed / found, proved ? "proved" : "REFUSED");
	refusals += !proved;
}

/* The same of powers of two. */
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
	count::lost = count::head = 0;
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

/* ---- dd.h, in units of u^2 of the result ---- */

/* Heads x and y in a box, low parts as large as they can be. Powers of two and
 * signs change nothing. */
struct box {
	double x0, x1, y0, y1;
};

static dd word(double low, double high)
{
	return dd{ given(high, low, -52), given(U) };
}

static poly sum_of(dd a)
{
	return plus(a.hi->is, a.lo->is);
}

static double dd_error(bool divide, const box &at)
{
	fresh();
	dd a = word(at.x0, at.x1 - 2 * U), b = word(at.y0, at.y1 - 2 * U);

	count::head = divide ? 0.5 : 1;
	if (!divide)
		return bound(minus(sum_of(dd_mul(a, b)),
			   times(sum_of(a), sum_of(b)))) /
		    (at.x0 * at.y0 * (1 - 2 * U));
	return bound(minus(times(sum_of(dd_div(a, b)), sum_of(b)), sum_of(a))) /
	    (at.x0 * (1 - U));
}

/* Halves a box where its bound is above the claim, until one shows that this
 * isn't for want of halving. */
static double worst_dd(bool divide, double claim, const box &at)
{
	double e = dd_error(divide, at) / (U * U), worst = 0;
	double x = (at.x0 + at.x1) / 2, y = (at.y0 + at.y1) / 2;
	const box parts[] = { { at.x0, x, at.y0, y }, { at.x0, x, y, at.y1 },
		{ x, at.x1, at.y0, y }, { x, at.x1, y, at.y1 } };

	if (e <= claim || at.x1 - at.x0 < 0x1p-24)
		return e;
	for (int i = 0; i < 4 && worst <= claim * MILLIONTH; i++)
		worst = std::fmax(worst, worst_dd(divide, claim, parts[i]));
	return worst;
}

static void prove_dd(void)
{
	fresh();
	/* what its first double leaves of 1, rounded again */
	say("ex_round: EX_BOUND", EX_BOUND, count::half_ulp(U) / (U * U),
	    "u^2");
	const box all = { 1, 2, 1, 2 };

	say("dd_mul", DD_MUL, worst_dd(false, DD_MUL, all), "u^2");
	say("dd_div", DD_DIV, worst_dd(true, DD_DIV, all), "u^2");
}

/* ---- kernel/exact.h ---- */

static struct kernel_map map;
static number in[3], out[3];
static poly difference[3]; /* of a point from the origin */

/* Coordinates below 2^e and a column below 2^f for e = f = 0; an element's low part is
 * at most half a unit of its high one. */
static void give_map(double element, double image)
{
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++) {
			double most = i < 3 ? element : image;

			map.hi[i][j] = given(most);
			map.lo[i][j] = given(most * U / 2);
		}
	for (int j = 0; j < 4; j++)
		map.none[j] = map.most[j] = map.image[j] = number(0);
}

static void give_points(double size)
{
	for (int k = 0; k < 3; k++) {
		number d = given(size);

		map.origin[k] = given(HUGE_VAL);
		difference[k] = d->is;
		in[k] = number::add({ plus(d->is, map.origin[k]->is), HUGE_VAL,
		    0, count::NO_UNIT, count::GIVEN, -1, -1, -1, -1 });
	}
}

static poly column_of(int j, int terms)
{
	poly s = plus(map.hi[3][j]->is, map.lo[3][j]->is);

	for (int k = 0; k < terms; k++)
		s = plus(s,
		    times(difference[k],
			plus(map.hi[k][j]->is, map.lo[k][j]->is)));
	return s;
}

static void run(enum kernel_kind kind)
{
	const number *const from[3] = { in, in + 1, in + 2 };
	number *const to[3] = { out, out + 1, out + 2 };

	exact(&map, from, to, 1, kind);
}

/* hi + lo of a test hi + (lo + error). */
static poly tested(void)
{
	const count::node &up = *tested_up;

	return plus(count::nodes[up.a].is,
	    count::nodes[count::nodes[up.b].a].is);
}

/* What the test itself rounds. */
static double test_error(void)
{
	const count::node &sum = count::nodes[tested_up->b];

	return sum.error < 0 ? 0 : count::bounds[sum.error];
}

/* A column's error and the most that it can be, in units of B. Bit k of far tells
 * that the origin is so far off in coordinate k that it is subtracted whole. */
static double column_error(int terms, int far, double *most)
{
	fresh();
	count::answers = ~far;
	give_map(1, 1);
	give_points(1);
	run(terms == 2 ? KERNEL_FLAT : KERNEL_AFFINE);
	number hi;

	hi.id = tested_up->a;
	*most = hi->most;
	/* elements are rounded to hi + lo */
	return bound(minus(tested(), column_of(terms - 1, terms))) +
	    test_error() + (terms + 1) * EX_BOUND * U * U;
}

/* Heads of 1, low parts as normalise() may leave them: 3 u. In units of the
 * quotient. */
static vdd pair(double head)
{
	return vdd{ given(head, head), given(3 * U * head) };
}

static double quotient_error(void)
{
	fresh();
	count::relative = true;
	vdd n = pair(1), w = pair(1);
	number sure = 1;

	quotient(n, w, number(1) / w.hi, given(small), 0, &sure);
	poly wrong = minus(times(tested(), plus(w.hi->is, w.lo->is)),
	    plus(n.hi->is, n.lo->is));

	return (bound(wrong) + test_error()) / (1 - 4 * U);
}

static double depth_error(double a, double b)
{
	fresh();
	count::relative = true;
	vdd w = pair(1), first = pair(a), second = pair(b);
	number sure = 1;

	map.a_hi = first.hi;
	map.a_lo = first.lo;
	map.b_hi = second.hi;
	map.b_lo = second.lo;
	depth(&map, w, number(1) / w.hi, given(small), 0, &sure);
	poly whole = plus(w.hi->is, w.lo->is);
	poly right = plus(times(plus(first.hi->is, first.lo->is), whole),
	    plus(second.hi->is, second.lo->is));

	return (bound(minus(times(tested(), whole), right)) + test_error()) /
	    (1 - 4 * U);
}

/* With the columns of n and w off by a share of their bounds, and w above its
 * bound: how much of the test's error is needed. What the quotient itself rounds
 * is of |q|, and the test has at least COLUMN_BOUND / most of that. */
static double share(double column, double most, double own)
{
	double part = column / (double)COLUMN_BOUND;

	return (part / (1 - part) + own * most / COLUMN_BOUND) * (1 + 16 * U);
}

/* Binary exponents where coordinates and B are at the ends of what is moderate: of
 * all that underflows, 16 times half the least double, multiplied by a coordinate
 * and by w at most; of the largest that is computed, 2 n over a w at its bound; of
 * the least bound. */
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
	double most = 0, column = 0, m;

	for (int terms = 2; terms <= 3; terms++)
		for (int far = 0; far < 1 << terms; far++) {
			column = std::fmax(column,
			    column_error(terms, far, &m));
			most = std::fmax(most, m);
		}
	const double q = quotient_error(), a = depth_error(1, small),
		     b = depth_error(small, 1), least = 0x1p-79;

	say("column, of 2^-79 B", COLUMN_UNITS, column / least, "2^-79");
	say("column: COLUMN_BOUND / 2", COLUMN_BOUND / 2 / least,
	    column / least, "2^-79");
	say("column: |hi| at most", 4 + 0x1p-23, most, "B");
	say("quotient's own", QUOTIENT_BOUND, q / (U * U), "u^2");
	say("quotient: share of its error", 1, share(column, most, q), "");
	say("depth: DEPTH_BOUND", DEPTH_BOUND / (U * U), a / (U * U), "u^2");
	say("depth: share of its error", 1, share(column, most, b), "");
}

/* ---- kernel/plain.h, in units of u ---- */

static void run_plain(enum kernel_kind kind)
{
	const number *const from[3] = { in, in + 1, in + 2 };
	number *const to[3] = { out, out + 1, out + 2 };

	counted_plain(&map, from, to, 1, NULL, kind);
}

/* An element as it is cast: rounded once. */
static void give_plain(int term)
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
	map.a_hi = map.a_lo = map.b_hi = map.b_lo = number(0);
}

/* What is lost of a term, of its size; then of the quotient. */
static double plain_column(int term)
{
	give_plain(term);
	run_plain(KERNEL_AFFINE);
	return bound(minus(exactly(out[0]), column_of(0, 3))) / U;
}

static double plain_quotient(void)
{
	give_plain(3);
	run_plain(KERNEL_PROJECTIVE);
	const count::division &d = count::divisions.back();
	const count::node &q = *out[0];

	return bound(minus(times(q.is, { { { d.b }, 1.0 } }),
		   count::nodes[q.a].is)) /
	    U;
}

static double plain_depth(double a, double b)
{
	give_plain(3);
	map.a_hi = given(a);
	map.a_lo = given(U * a * (1 + 0x1p-20));
	map.b_hi = given(b);
	map.b_lo = given(U * b * (1 + 0x1p-20));
	run_plain(KERNEL_DEPTH);
	const poly w = { { { count::divisions.back().b }, 1.0 } };
	poly right = plus(times(plus(map.a_hi->is, map.a_lo->is), w),
	    plus(map.b_hi->is, map.b_lo->is));

	return bound(minus(times(out[2]->is, w), right)) / U;
}

/* S / |w| is t, from 1 to where the loop asks for w to 1/16; there w is off by c u
 * S. The sum's parts fall and rise with t, so its ends are its worst. */
static double worst_of(double c, double own, double u)
{
	double last = 1 / (16 * (double)PLAIN_BOUND * u), worst = 0;

	for (double t : { 1.0, last })
		worst = std::fmax(worst,
		    c / (1 - c * u * t) + own / t / (1 - c * u * t));
	return worst;
}

static void prove_plain(void)
{
	double c = 0;

	for (int term = 0; term < 4; term++)
		c = std::fmax(c, plain_column(term));
	/* and one for printing the shortest digits */
	double q = plain_quotient() + 1;
	double a = plain_depth(1, small) + 1, b = plain_depth(small, 1) + 1;
	/* the bound's own roundings; u of single, where higher powers count */
	const double u = 0x1p-24, own = 1 - 32 * u;

	say("plain column", 5, c, "u S");
	say("plain quotient: PLAIN_BOUND", PLAIN_BOUND, worst_of(c, q, u) / own,
	    "u");
	say("plain depth, of a: PLAIN_BOUND", PLAIN_BOUND, a / own, "u");
	say("plain depth, of b/w: PLAIN_BOUND", PLAIN_BOUND,
	    worst_of(c, b, u) / own, "u");
}

/* ---- quick.h, in units of u^2 of sums of products' magnitudes ---- */

/* Term i of the columns, of their own elements and of those of the last column; of
 * row 2 what a direction takes of them; and row turned of what turns it. */
static void give_quick(int i, double own, double last, int turned,
    struct ray_maker *r)
{
	fresh();
	count::relative = true;
	/* that sums are in order for fast_two_sum is proved of dd_add in the
	 * papers, and tried in toy arithmetic */
	count::head = HUGE_VAL;
	give_map(small, small);
	give_points(small);
	for (int j = 0; j < 4; j++) {
		double e = (j < 3 ? own : last) ? 1 : small;

		if (i != 2)
			map.hi[2][j] = given(e), map.lo[2][j] = given(e * U);
		map.hi[i][j] = given(1);
		map.lo[i][j] = given(U);
	}
	if (i < 3)
		count::bounds[difference[i].begin()->first[0]] = 1;
	r->to_world.for_kernel = r->to_view.for_kernel = map;
	r->turn.for_kernel = map;
	for (int k = 0; k < 9; k++) {
		double e = k / 3 == turned ? 1 : small;

		r->turn.for_kernel.hi[k / 3][k % 3] = given(e);
		r->turn.for_kernel.lo[k / 3][k % 3] = given(e * U);
	}
	r->depth = in[2];
	r->against = false;
}

static poly element_of(int i, int j)
{
	return plus(map.hi[i][j]->is, map.lo[i][j]->is);
}

static poly image_of(const struct kernel_map &turn, int j)
{
	poly s;

	for (int i = 0; i < 3; i++) {
		poly d = minus(times(element_of(2, i), column_of(3, 3)),
		    times(column_of(i, 3), element_of(2, 3)));

		s = plus(s,
		    times(d, plus(turn.hi[i][j]->is, turn.lo[i][j]->is)));
	}
	return s;
}

/* All of a direction's elements are computed alike. */
static void quick_errors(int i, double own, double last, int turned,
    double *column, double *to)
{
	struct ray_maker r;
	number point[3];
	struct quick n[4];

	give_quick(i, own, last, turned, &r);
	set_columns(&r, &r.to_view.for_kernel, in, n);
	*column = std::fmax(*column,
	    bound(minus(sum_of(n[0].value), column_of(0, 3))));
	direction_is_sure(&r, in, point);
	*to = std::fmax(*to,
	    bound(minus(sum_of(directions[0].value),
		image_of(r.turn.for_kernel, 0))) /
		(i == 2 ? 2 : own + last));
}

/* Of so many equal elements: half of what the square is off by. */
static double length_error(int many)
{
	fresh();
	count::relative = true;
	count::head = HUGE_VAL;
	struct quick to[3];
	poly square;

	for (int j = 0; j < 3; j++) {
		double e = j < many ? 1 / std::sqrt((double)many) : small;

		to[j] = { { given(e), given(e * U) }, number(1), false };
		square = plus(square,
		    times(sum_of(to[j].value), sum_of(to[j].value)));
	}
	poly length = sum_of(whole::length_of(to).value);

	return bound(minus(times(length, length), square)) / 2;
}

static void prove_quick(void)
{
	double column = 0, to = 0, length = 0;

	for (int i = 0; i < 4; i++)
		for (int k = 1; k < 4; k++)
			for (int turned = 0; turned < 3; turned++)
				quick_errors(i, k & 1, k >> 1, turned, &column,
				    &to);
	for (int many = 1; many <= 3; many++)
		length = std::fmax(length, length_error(many));
	/* with what elements are rounded by */
	column = column / (U * U) + EX_BOUND;
	to = to / (U * U) + 3 * EX_BOUND;
	length /= U * U;
	say("quick: a column", QUICK_COLUMN, column, "u^2");
	say("quick: a direction, turned", QUICK_DIRECTION, to, "u^2");
	say("quick: a length", QUICK_LENGTH, length, "u^2");
	say("quick: QUICK_BOUND", QUICK_BOUND / (U * U),
	    std::fmax(column, to) + std::fmax(length, 0.0) + DD_DIV, "u^2");
}

int main()
{
	prove_quick();
	prove_dd();
	prove_exact();
	prove_ends();
	prove_plain();
	return refusals > 0;
}
