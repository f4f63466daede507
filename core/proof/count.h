/* SPDX-License-Identifier: MIT */
/* Numbers that count their roundings. The headers under test are compiled with these
 * numbers in place of doubles. A number is a polynomial in atoms, which are the given
 * values and the errors of all roundings, and each atom has a bound. The error of an
 * algorithm is the polynomial of its result minus that of the exact result: equal terms
 * cancel, and a term that was forgotten, or has the wrong sign, remains.
 *
 * The error of a rounding is at most u times the bound of the result. It is 0 if the
 * result is a multiple of a unit, and at most 2^53 units. The low parts of two_sum,
 * fast_two_sum and two_prod are exactly the errors of their high parts, as exact.v
 * proves. */
#pragma once

#include <algorithm>
#include <cfloat>
#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <vector>

namespace count
{

static const double U = 0x1p-53;

/* Ends the program at an operation whose error this header cannot count. */
[[noreturn]] static void refuse(const char *why)
{
	printf("refused: %s\n", why);
	exit(1);
}

static std::vector<double> bounds; /* of atoms: given values and errors */
static std::vector<bool> left_by_sum;

static int new_atom(double bound, bool by_sum = false)
{
	bounds.push_back(bound);
	left_by_sum.push_back(by_sum);
	return (int)bounds.size() - 1;
}

typedef std::vector<int> product; /* of atoms, in ascending order */
typedef std::map<product, double> poly;

static double bound(const poly &p)
{
	double sum = 0;

	for (const auto &term : p) {
		double size = std::fabs(term.second);

		for (int atom : term.first)
			size *= bounds[atom];
		sum += size;
	}
	return sum * (1 + 0x1p-40);
}

static poly plus(const poly &a, const poly &b, double times = 1)
{
	poly s = a;

	for (const auto &term : b) {
		double &c = s[term.first];

		c += times * term.second;
		if (c == 0)
			s.erase(term.first);
	}
	return s;
}

/* A quotient q = a / b + error by an atom b: the product q b is a + b error. */
struct division {
	int q, b;
	poly product;
};
static std::vector<division> divisions;

static poly times(const poly &a, const poly &b);

/* Adds a term to s, unless an atom in it is 0. A quotient times its divisor becomes the
 * product of their division. */
static void add_term(poly *s, product atoms, double c)
{
	for (int atom : atoms)
		if (bounds[atom] == 0)
			return;
	for (const division &d : divisions)
		for (size_t i = 0; i < atoms.size(); i++)
			for (size_t j = 0; j < atoms.size(); j++) {
				if (i == j || atoms[i] != d.q || atoms[j] != d.b)
					continue;
				product rest;

				for (size_t k = 0; k < atoms.size(); k++)
					if (k != i && k != j)
						rest.push_back(atoms[k]);
				*s = plus(*s, times({ { rest, c } }, d.product));
				return;
			}
	*s = plus(*s, { { atoms, c } });
}

static poly times(const poly &a, const poly &b)
{
	poly s;

	for (const auto &x : a)
		for (const auto &y : b) {
			product atoms = x.first;

			atoms.insert(atoms.end(), y.first.begin(), y.first.end());
			std::sort(atoms.begin(), atoms.end());
			add_term(&s, atoms, x.second * y.second);
		}
	return s;
}

enum operation { GIVEN, SUM, DIFFERENCE, PRODUCT, QUOTIENT, FUSED, NEGATIVE, SIZE };

static const int NO_UNIT = INT_MIN / 4;

struct node {
	poly is;
	double most;  /* bound of the magnitude */
	double least; /* lower bound of the magnitude; 0 if unknown */
	int unit;     /* the number is a multiple of 2^unit */
	operation op;
	int a, b, c;
	int error; /* the atom of its rounding, or -1 */
};
static std::vector<node> nodes;

/* If set, magnitudes are not bounds, but the sizes to which errors are relative. */
static bool relative;
/* What each rounding may lose in addition by underflow, or 0. */
static double lost;
/* The results of comparisons of a magnitude with a constant, the first in the lowest
 * bit: 1 if the magnitude is less. */
static int answers = -1;

static double half_ulp(double most)
{
	int e;

	if (most == 0 || most == HUGE_VAL)
		return most;
	if (relative)
		return U * most;
	return std::frexp(most, &e) == 0.5 ? std::ldexp(U, e - 2) :
					     std::ldexp(U, e - 1);
}

static int unit_of(double a)
{
	int e;

	if (a == 0)
		return INT_MAX / 4;
	double m = std::ldexp(std::frexp(a, &e), 53);

	for (e -= 53; std::fmod(m, 2) == 0; e++)
		m /= 2;
	return e;
}

struct number {
	int id;

	number() = default;
	number(double k)
	{
		poly p;

		if (k != 0)
			p[{}] = k;
		*this = add({ p, std::fabs(k), std::fabs(k), unit_of(k), GIVEN, -1, -1,
		    -1, -1 });
	}
	static number add(const node &n)
	{
		number r;

		nodes.push_back(n);
		r.id = (int)nodes.size() - 1;
		return r;
	}
	const node &operator*() const
	{
		return nodes[id];
	}
	const node *operator->() const
	{
		return &nodes[id];
	}
	number operator-() const
	{
		node n = nodes[id];

		n.is = times(n.is, { { {}, -1.0 } });
		n.op = NEGATIVE;
		n.a = id;
		return add(n);
	}
	number &operator+=(number b);
};

/* Returns a given value of at most that magnitude. */
static number given(double most, double least = 0, int unit = NO_UNIT)
{
	return number::add({ { { { new_atom(most) }, 1.0 } }, most, least, unit, GIVEN,
	    -1, -1, -1, -1 });
}

static bool is_zero(number a)
{
	return a->is.empty();
}

static bool is(int id, operation op, int a, int b)
{
	return id >= 0 && nodes[id].op == op && nodes[id].a == a && nodes[id].b == b;
}

/* Returns the rounded result of an operation whose exact result is p, at most most. */
static number rounded(poly p, double most, int unit, operation op, number a, number b,
    int c = -1)
{
	most = std::fmin(most, bound(p));
	node n = { p, most, 0, unit, op, a.id, b.id, c, -1 };
	double units = unit > NO_UNIT ? std::ldexp(most, -unit) : HUGE_VAL;

	if (most == 0) {
		n.is.clear();
	} else if (units <= 0x1p53) {
		n.most = std::ldexp(std::floor(units), unit);
	} else {
		n.error = new_atom(half_ulp(most) + lost,
		    op == SUM || op == DIFFERENCE);
		n.is = plus(p, { { { n.error }, 1.0 } });
		n.most = most + bounds[n.error];
		n.unit = NO_UNIT;
	}
	return number::add(n);
}

static int product_unit(int a, int b)
{
	int x = nodes[a].unit, y = nodes[b].unit;

	return x > NO_UNIT && y > NO_UNIT ? x + y : NO_UNIT;
}

/* Returns the low part of a sum or product, which is its negated error. */
static number error_of(int id)
{
	int atom = nodes[id].error;
	double most = atom < 0 ? 0 : bounds[atom];
	const node &n = nodes[id];
	int unit = n.op == PRODUCT ? product_unit(n.a, n.b) : NO_UNIT;
	poly p;

	if (atom >= 0)
		p[{ atom }] = -1;
	return number::add({ p, most, 0, unit, GIVEN, -1, -1, -1, -1 });
}

static bool is_constant(number a)
{
	return a->is.size() == 1 && a->is.begin()->first.empty();
}

/* Returns the bound of a magnitude by the bounds that atoms have now. */
static double most_of(number a)
{
	return std::fmin(a->most, bound(a->is));
}

/* Returns the constant term of b if the sum a + b lies between the same powers of two
 * as this constant does, otherwise 0. */
static double cut_by(number a, number b)
{
	auto at = b->is.find({});

	if (at == b->is.end())
		return 0;
	poly rest = b->is;

	rest.erase(product());
	double c = at->second, most = most_of(a) + bound(rest);
	double power = std::ldexp(1, std::ilogb(c));

	return c - most >= power && c + most <= 2 * power ? c : 0;
}

static number cut_sum(number a, number b)
{
	int e;

	std::frexp(cut_by(a, b), &e);
	node n = { plus(a->is, b->is), most_of(a) + b->most, 0, e - 53, SUM, a.id, b.id,
		-1, new_atom(std::ldexp(1, e - 54), true) };

	n.is = plus(n.is, { { { n.error }, 1.0 } });
	return number::add(n);
}

static number operator+(number a, number b)
{
	/* (x - (s - t)) + (y - t) for s = x + y, t = s - x */
	if (a->op == DIFFERENCE && b->op == DIFFERENCE) {
		int x = a->a, y = b->a, t = b->b, st = a->b;

		if (is(st, DIFFERENCE, nodes[t].a, t) &&
		    is(t, DIFFERENCE, nodes[st].a, x) && is(nodes[t].a, SUM, x, y))
			return error_of(nodes[t].a);
	}
	if (is_zero(a) || is_zero(b))
		return is_zero(a) ? b : a;
	if (cut_by(a, b) > 0)
		return cut_sum(a, b);
	return rounded(plus(a->is, b->is), a->most + b->most,
	    std::min(a->unit, b->unit), SUM, a, b);
}

static number operator-(number a, number b)
{
	if (is_zero(b))
		return a;
	poly p = plus(a->is, b->is, -1);
	double most = a->most + b->most;

	/* (x + b) - b, a cut, is x rounded to a unit */
	if (a->op == SUM && a->b == b.id && a->unit > NO_UNIT)
		most = std::ldexp(std::nearbyint(
				      std::ldexp(bound(nodes[a->a].is), -a->unit)),
		    a->unit);
	/* The error of a sum is a number, so nothing is rounded. */
	if (p.size() == 1 && p.begin()->first.size() == 1 &&
	    std::fabs(p.begin()->second) == 1 && left_by_sum[p.begin()->first[0]])
		return number::add(
		    { p, bound(p), 0, NO_UNIT, DIFFERENCE, a.id, b.id, -1, -1 });
	/* If neither is more than twice the other, nothing is rounded (Sterbenz). */
	if (bound(p) <= b->least / 2)
		return number::add({ p, std::fmin(most, bound(p)), 0,
		    std::min(a->unit, b->unit), DIFFERENCE, a.id, b.id, -1, -1 });
	return rounded(p, most, std::min(a->unit, b->unit), DIFFERENCE, a, b);
}

/* Returns a times a power of two, which is not rounded. */
static number scaled(number a, double power)
{
	node n = *a;

	n.is = times(n.is, { { {}, power } });
	n.most *= power;
	n.least *= power;
	n.unit += n.unit > NO_UNIT ? std::ilogb(power) : 0;
	n.op = GIVEN;
	return number::add(n);
}

static bool is_power(number a)
{
	int e;

	return is_constant(a) && std::frexp(a->is.begin()->second, &e) == 0.5;
}

static number operator*(number a, number b)
{
	if (is_zero(a) || is_zero(b))
		return number(0);
	if (is_power(a) || is_power(b))
		return is_power(a) ? scaled(b, a->most) : scaled(a, b->most);
	number r = rounded(times(a->is, b->is), a->most * b->most,
	    product_unit(a.id, b.id), PRODUCT, a, b);

	nodes[r.id].least = a->least * b->least * (1 - U);
	if (r->error >= 0 && r->least > 0)
		nodes[r.id].unit = std::ilogb(r->least) - 52;
	return r;
}

/* Returns a quotient. A divisor that is not an atom or a multiple of one is replaced by
 * a new atom, which stands for its computed value. */
static number operator/(number a, number b)
{
	double least = b->least > 0 ? b->least : 1;
	double size = a->most / least, most = size * (1 + 2 * U);
	bool simple = b->is.size() == 1 && b->is.begin()->first.size() == 1;
	int divisor = simple ? b->is.begin()->first[0] : new_atom(1);
	double times_it = simple ? b->is.begin()->second : 1;
	int q = new_atom(most);
	int error = new_atom(half_ulp(relative ? most : size));
	product lost_of_b = { divisor, error };

	std::sort(lost_of_b.begin(), lost_of_b.end());
	divisions.push_back({ q, divisor,
	    plus(times(a->is, { { {}, 1 / times_it } }), { { lost_of_b, 1.0 } }) });
	double small = a->least / b->most * (1 - U);

	return number::add({ { { { q }, 1.0 } }, most, small,
	    small > 0 ? std::ilogb(small) - 52 : NO_UNIT, QUOTIENT, a.id, b.id, -1,
	    -1 });
}

/* Returns a root r = root + error, so that r r = a + 2 r error - error error. */
static number sqrt(number a)
{
	double most = std::sqrt(a->most) * (1 + 2 * U);
	int r = new_atom(most), error = new_atom(half_ulp(most));
	poly square = plus(a->is, { { { r, error }, 2.0 } });

	divisions.push_back({ r, r, plus(square, { { { error, error }, -1.0 } }) });
	return number::add({ { { { r }, 1.0 } }, most, std::sqrt(a->least) * (1 - U),
	    NO_UNIT, GIVEN, -1, -1, -1, -1 });
}

inline number &number::operator+=(number b)
{
	return *this = *this + b;
}

static number fma(number a, number b, number c)
{
	if (is_zero(a) || is_zero(b))
		return c;
	if (c->op == NEGATIVE && is(c->a, PRODUCT, a.id, b.id))
		return error_of(c->a);
	return rounded(plus(times(a->is, b->is), c->is), a->most * b->most + c->most,
	    std::min(product_unit(a.id, b.id), c->unit), FUSED, a, b, c.id);
}

/* Returns a magnitude, which the headers take only of errors and sizes. */
static number fabs(number a)
{
	number size = given(a->most);

	nodes[size.id].op = SIZE;
	nodes[size.id].a = a.id;
	return size;
}
static number fmax(number a, number)
{
	return a;
}
static number ldexp(number a, int e)
{
	return e == 0 ? a : a * number(std::ldexp(1, e));
}
/* Returns a with exponent 0, as magnitudes are in units of the largest. */
static number frexp(number a, int *e)
{
	*e = 0;
	return a;
}
/* Returns the result of comparing the size of a given value with a limit, by answers,
 * and keeps what it says about the value. */
static bool learn(node *n, double limit)
{
	bool less = answers & 1;

	answers >>= 1;
	if (less)
		bounds[n->is.begin()->first[0]] = n->most = std::fmin(n->most, limit);
	else
		n->least = limit;
	return less;
}
/* Other comparisons find points without an image, which the proof does not cover. */
static bool operator<(number a, number b)
{
	bool known = a->op == SIZE && is_constant(b) && nodes[a->a].op == GIVEN &&
	    nodes[a->a].is.size() == 1 && nodes[a->a].is.begin()->first.size() == 1;

	return known ? learn(&nodes[a->a], b->most) : true;
}
static bool operator>(number, number)
{
	return true;
}
static bool operator==(number, number)
{
	return false;
}

} /* namespace count */
