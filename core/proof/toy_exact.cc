// SPDX-License-Identifier: MIT
/* Tests kernel/exact.h and doubled.h in the arithmetic of toy.h: no rounding that it
 * says is sure is wrong, no point without an image gets one, and no point with an image
 * loses it. */
#include "toy.h"

static double sign(void)
{
	return below(2) ? 1 : -1;
}

/* If set, numbers have all exponents of doubles. */
static bool ends;

static int exponent_near(int e)
{
	static const int far[] = { -1074, -1022, -900, -500, -350, -201, -199, -150,
		150, 199, 201, 350, 500, 900, 1022 };

	if (ends && below(3) == 0)
		return far[below(sizeof far / sizeof *far)];
	return e - (int)below(P / 3);
}

/* Returns a number of P digits that is a little below 2^e. */
static double number(int e)
{
	if (below(8) == 0)
		return ends && below(8) == 0 ? HUGE_VAL : 0;
	return sign() * ldexp(head(), exponent_near(e) - 1);
}

/* Returns a number with a low part of any size that it can have. */
static dd pair(int e)
{
	double hi = number(e), lo;

	if (hi == 0 || std::isinf(hi) || below(8) == 0)
		return dd{ hi, 0.0 };
	int at = std::ilogb(hi);

	do
		lo = sign() * ldexp(head(), at - P - (int)below(4));
	while (nearest(hi + lo) != hi);
	return dd{ hi, lo };
}

/* Returns the number of P digits that is nearest to a. */
static double rounded(wide a)
{
	double high = (double)a, low = (double)(a - high);

	return nearest(to_odd(high, low));
}

static struct kernel_map map;
/* A block of two points. Only the image of the first is judged. */
static toy in[3][2], out[4][2];

/* Makes a random map, in which sometimes all columns but that of w are 0. */
static void any_map(void)
{
	bool flat = below(16) == 0;

	for (int j = 0; j < 4; j++) {
		int e = (int)below(7) - 3;

		map.noise[j] = map.least_noise[j] = 0;
		for (int i = 0; i < 4; i++) {
			dd m = pair(i < 3 || below(2) ? e : e + (int)below(9));

			if (flat && j < 3)
				m = dd{ 0.0, 0.0 };

			map.hi[i][j] = m.hi;
			map.lo[i][j] = m.lo;
			map.hi_is_exact[i][j] = at(map.lo[i][j]) == 0;
		}
	}
	if (flat && ends) /* except an element that underflows when scaled */
		map.hi[0][0] = 0x1p-1074;
}

/* Returns a coordinate within 2^e of the origin or, if e is 8, below 2^8. */
static toy coordinate(int k, int e)
{
	return e == 8 ? toy(number(8)) : map.origin[k] + toy(number(e));
}

/* Makes a random point, often at or near the origin. Sometimes changes the map so that
 * the terms of a column nearly cancel. */
static void any_point(void)
{
	for (int k = 0; k < 3; k++) {
		int e = below(2) ? 8 : 6 - (int)below(P);

		map.origin[k] = below(2) ? number(8) : 0;
		in[k][1] = coordinate(k, e);
		in[k][0] = coordinate(k, below(4) ? e : -2);
	}
	if (below(4))
		return;
	int j = below(2) ? 3 : (int)below(3);
	wide s = 0;

	for (int k = 0; k < 3; k++)
		s += ((wide)at(in[k][0]) - at(map.origin[k])) *
		    ((wide)at(map.hi[k][j]) + at(map.lo[k][j]));
	map.hi[3][j] = rounded(-s);
	map.lo[3][j] = below(2) ? rounded(-s - at(map.hi[3][j])) : 0;
	map.hi_is_exact[3][j] = at(map.lo[3][j]) == 0;
}

/* Returns a column. An infinite element stands for a finite one beyond doubles, so that
 * 0 times it is 0. */
static wide column_at(int j, int terms)
{
	wide s = (wide)at(map.hi[3][j]) + at(map.lo[3][j]);

	for (int k = 0; k < terms; k++) {
		wide d = (wide)at(in[k][0]) - at(map.origin[k]);

		if (d != 0)
			s += d * ((wide)at(map.hi[k][j]) + at(map.lo[k][j]));
	}
	return s;
}

/* Returns a root by Newton's iteration, from one of 53 bits. */
static wide root(wide a)
{
	wide r = std::sqrt((double)a);

	for (int i = 0; i < 2 && r > 0; i++)
		r = (r + a / r) / 2;
	return r;
}

/* Returns the number by which a kind of loop divides its columns. */
static wide divisor(int kind, int terms)
{
	wide square = 0;

	for (int j = 0; j < 3; j++)
		square += column_at(j, terms) * column_at(j, terms);
	return kind == KERNEL_DIRECTION ? root(square) :
	    kind < KERNEL_PROJECTIVE    ? 1 :
					  column_at(3, terms);
}

enum verdict { UNSURE, RIGHT, WRONG };

static verdict judge(int kind)
{
	const int terms = kernel_inputs((enum kernel_kind)kind);
	const int columns = kernel_outputs((enum kernel_kind)kind);
	wide w = divisor(kind, terms);

	if (std::isnan(at(out[0][0])))
		return UNSURE;
	if (std::isinf(at(out[0][0])))
		return w <= 0 ? RIGHT : WRONG;
	if (w <= 0)
		return WRONG;
	for (int j = 0; j < columns; j++)
		if (rounded(column_at(j, terms) / w) != at(out[j][0]))
			return WRONG;
	return RIGHT;
}

static int loops(int tries, bool at_the_ends)
{
	ends = at_the_ends;
	const toy *const from[3] = { in[0], in[1], in[2] };
	toy *const to[4] = { out[0], out[1], out[2], out[3] };
	int count[2 * KERNELS][2] = { { 0 } };

	for (int i = 0; i < tries; i++) {
		int loop = KERNEL_FLAT + (int)below(KERNEL_DIRECTION);
		enum kernel_kind kind = (enum kernel_kind)loop;

		any_map();
		any_point();
		exact_images(&map, from, to, 2, kind);
		int verdict = judge(kind);

		if (verdict == WRONG)
			return failed("surely wrong");
		count[loop][verdict]++;
		if (kind == KERNEL_DIRECTION)
			continue;
		out[0][0] = out[0][1] = NAN;
		doubled_images(&map, from, to, 2, kind);
		verdict = judge(kind);
		if (verdict == WRONG)
			return failed("surely wrong in doubled.h");
		count[KERNELS + loop][verdict]++;
	}
	for (int loop = KERNEL_FLAT; loop < 2 * KERNELS; loop++) {
		const int *n = count[loop];

		printf("# P = %d, loop %d: %d sure, %d not\n", P, loop, n[RIGHT],
		    n[UNSURE]);
		if (P > 20 && !ends && n[RIGHT] < n[UNSURE] / 16)
			return failed("hardly ever sure");
	}
	return 0;
}

/* Tests quotient() alone, for columns with errors of up to half their bounds. The
 * bounds are the least that a loop can give. */
static int quotients(int tries)
{
	int sure_of = 0;

	for (int i = 0; i < tries; i++) {
		dd n = pair(1), w = pair(1);
		double least = COLUMN_BOUND / 4, n_bound, w_bound;

		if (at(n.hi) == 0 || at(w.hi) == 0)
			continue;
		if (at(w.hi) < 0)
			w = dd{ -w.hi, -w.lo };
		n_bound = nearest(std::fabs(at(n.hi)) * least);
		w_bound = nearest(at(w.hi) * least);
		toy sure = 1;
		toy q = quotient(vdd{ n.hi, n.lo }, vdd{ w.hi, w.lo }, toy(1) / w.hi,
		    n_bound, w_bound, &sure);

		if (!(sure > 0))
			continue;
		sure_of++;
		for (int s = 0; s < 4; s++) {
			wide a = value(n) + (s & 1 ? n_bound : -n_bound) / 2;
			wide b = value(w) + (s & 2 ? w_bound : -w_bound) / 2;

			if (rounded(a / b) != at(q))
				return failed("a quotient is surely wrong");
		}
	}
	printf("# P = %d, quotients: %d of %d sure\n", P, sure_of, tries);
	return sure_of == 0 && P > 13 ? failed("never sure") : 0;
}

/* Tests all x m + b + t, where x and m have P digits and are from 1 to 2. t is 0 or a
 * bit far below, which decides what would be a tie. With a point of size 2^far in the
 * block, points are cut at another bit. */
enum { HEADS = 1 << (P == 6 ? P - 1 : 0) };

static int ties_of(double m, double b, double t, int far, int count[2])
{
	static toy x[2][HEADS + 2], q[2][HEADS + 1];
	const toy *const from[3] = { x[0], x[1], x[1] };
	toy *const to[4] = { q[0], q[1], q[1], q[1] };

	for (int i = 0; i < HEADS + 2; i++) { /* an even number of points */
		x[0][i] = i < HEADS ? 1 + i * LAST : std::ldexp(1, far);
		x[1][i] = 1;
	}
	map.hi[0][0] = m;
	map.hi[1][0] = t;
	map.hi[3][0] = b;
	exact_images(&map, from, to, HEADS + 1, KERNEL_FLAT);
	for (int i = 0; i < HEADS; i++) {
		double is = at(x[0][i]) * m + b + t, up = is * (1 + 0x1p-40);
		bool tie = nearest(up) != nearest(is * (1 - 0x1p-40));

		if (!std::isnan(at(q[0][i])) && at(q[0][i]) != nearest(is))
			return failed("a tie is surely wrong");
		if (tie && t == 0)
			count[std::isnan(at(q[0][i]))]++;
	}
	return 0;
}

static int ties()
{
	int count[2] = { 0, 0 };

	map = kernel_map();
	for (auto &row : map.hi_is_exact)
		for (auto &exact : row)
			exact = true;
	for (int k = 0; k < HEADS * HEADS; k++)
		for (int e = -2 * P; e <= 2 * P; e++)
			for (int way = 0; way < 12; way++) {
				double b = ldexp(1 + k % HEADS * LAST, e);
				double t = std::ldexp(way / 2 % 3 - 1, -3 * P);

				if (ties_of(1 + k / HEADS * LAST, way & 1 ? -b : b, t,
					way / 6 * P / 2, count))
					return 1;
			}
	printf("# P = %d, ties: %d decided, %d left\n", P, count[0], count[1]);
	return count[0] == 0 ? failed("no tie is decided") : 0;
}

int main()
{
	return quotients(60000) || (P == 6 && ties()) || loops(50000, false) ||
	    (P == 53 && loops(500000, true));
}
