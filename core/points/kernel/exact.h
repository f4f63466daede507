/* SPDX-License-Identifier: MIT */
/* The kernels of PRECISION_EXACT, written once for the vectors that copy.h describes. A
 * coordinate is a sum hi + lo with a bound of its error. If all numbers within this
 * bound of hi + lo round to one double, this double is the result; if not, doubled.h
 * computes the point. Variables named `sure` are positive if the rounding is certain.
 * Noise (struct kernel_map) is the error up to which a difference counts as 0.
 *
 * To cut a number is to round it to few bits; the difference is its rest. For each
 * coordinate, let 2^e be above the magnitude of the coordinate in a block's points,
 * relative to the origin. Let B be a power of two above a column's elements times
 * their 2^e, and above the column's image of the origin. Points and the origin are cut
 * to multiples of 2^(e-26), elements to multiples of 2^(-e-24) B. Then hi, the sum of
 * the origin's cut image and three products of cut numbers, has no error: all are
 * multiples of 2^-50 B, and hi is at most 2^52 + 2^27 of these units. The low part is
 *
 *	lo = sum of (coordinate's rest) element + (cut coordinate) (element's rest)
 *
 * The first product is up to 2^-27 B in each of three coordinates, the second up to
 * 2^-25 B. The origin's rests add three terms of up to 2^-27 B: no partial sum is above
 * 9 times 2^-26 B. The errors are (coordinate's rest) (lo of struct kernel_map), which
 * is left out, and the roundings of sums, products, rests, and lo plus its bound:
 * together 49 u * 2^-26 B < 2^-73.3 B, where u = 2^-53. `make prove` counts them. */
#include "kernel.h"

/* DIGITS is the number of binary digits of a double. COLUMN_BOUND is the bound of a
 * column's error in units of B: over twice the error above, to include the roundings of
 * a quotient. core/proof/toy.h defines other values for fewer digits. */
#ifndef DIGITS
#define DIGITS 53
#define COLUMN_BOUND 0x1p-72
#define MODERATE 0x1p200
#endif
/* The least normal number. It replaces products that underflow, as an upper bound. */
#define TINY 0x1p-1022

/* the bits of a cut coordinate and of a cut element */
enum { POINT_CUT = DIGITS / 2, ELEMENT_CUT = DIGITS - 3 - POINT_CUT };

/* Returns true if `largest`, the largest magnitude of coordinates or of a column, is 0
 * or is such that products and quotients of two such numbers are normal doubles. */
static int is_moderate(double largest)
{
	return largest == 0 || (largest > 1 / MODERATE && largest < MODERATE);
}

/* Returns s: a + s - s rounds a to a multiple of unit if |a| < 2^(DIGITS-2) unit. */
static double rounder(double unit)
{
	return ldexp(1.5, DIGITS - 1) * unit;
}

static double cut_to(double a, double unit)
{
	double s = rounder(unit);

	return a + s - s;
}

static inline double greatest_lane(V a)
{
	double all[WIDTH], r;

	STORE(all, a);
	r = all[0];
	for (int i = 1; i < WIDTH; i++)
		r = all[i] > r ? all[i] : r;
	return r;
}

/* Returns whether `product` is exactly a b; false if underflow could hide an error. */
static bool is_product(double a, double b, double product)
{
	return fma(a, b, -product) == 0 &&
	    (fabs(product) > 0x1p-900 || a == 0 || b == 0);
}

/* The range of the differences d of a block's points from the origin in one coordinate.
 * An origin below 2^(e+23) is cut: its cut part is subtracted from the points' cut
 * parts, and its rest, times the element, from the column's image of the origin. A
 * larger origin is subtracted whole; the differences are then exact. */
struct kernel_range {
	double largest;         /* the largest |d|, rounded up */
	double power, inverse;  /* 2^e > largest, and 2^-e */
	double rounder;         /* rounds to multiples of 2^(e-26) */
	double whole, rest;     /* (origin, 0) or (0, origin's rest) */
	double rounder_and_cut; /* rounder + the origin's cut part */
};

static struct kernel_range range_of(double low, double high, double origin)
{
	struct kernel_range r = { 0, 0, 0, 0, 0, 0, 0 };
	double cut = 0;
	int e;

	r.largest = fmax(fabs(high - origin), fabs(origin - low)) *
	    (1 + ldexp(1, 3 - DIGITS));
	frexp(r.largest, &e);
	r.power = ldexp(1, e);
	r.inverse = ldexp(1, -e);
	double unit = r.power * ldexp(1, -POINT_CUT);

	r.rounder = rounder(unit);
	if (fabs(origin) < r.power * ldexp(1, POINT_CUT - 3)) {
		cut = cut_to(origin, unit);
		r.rest = origin - cut;
	} else {
		r.whole = origin;
	}
	r.rounder_and_cut = r.rounder + cut;
	return r;
}

/* Finds the least and the greatest of n coordinates: infinity and -infinity if all are
 * nan. Vectors in even and in odd places have separate minima and maxima, as operations
 * on the same minimum have to wait for each other. */
static void find_limits(const double *in, size_t n, double *least, double *greatest)
{
	V low[2] = { ALL(HUGE_VAL), ALL(HUGE_VAL) };
	V high[2] = { ALL(-HUGE_VAL), ALL(-HUGE_VAL) };

	for (size_t i = 0; i < n; i += 2 * WIDTH)
		for (size_t k = 0; k < 2; k++) {
			V x = LOAD(in + i + k * WIDTH);

			low[k] = MIN(x, low[k]);
			high[k] = MAX(x, high[k]);
		}
	*least = -greatest_lane(-MIN(low[0], low[1]));
	*greatest = greatest_lane(MAX(high[0], high[1]));
}

static double largest_noise(const struct kernel_map *m, int j, int terms,
    const struct kernel_range *range)
{
	double largest = 1;

	for (int k = 0; k < terms; k++)
		largest = fmax(largest, range[k].largest);
	return m->noise[j] * largest;
}

/* A column for a block of points: its elements and, in row 3, its image of the origin,
 * cut into `high` and `rest`. The elements' low parts (lo of struct kernel_map) are
 * added to `rest`, unless all of them together are within the noise. */
struct column_cut {
	double high[4], rest[4], element[4];
	double bound;       /* of the column's error */
	bool noise_only;    /* `rest` has no error beyond the noise */
	double noisy_below; /* 2^56 times the noise */
};

/* Returns true if the elements' low parts change column j by at most least_noise. */
static bool low_parts_are_noise(const struct kernel_map *m, int j, int terms,
    const struct kernel_range *range)
{
	double all = 0;

	for (int i = 0; i < 4; i++)
		if ((i == 3 || i < terms) && !m->hi_is_exact[i][j])
			all += fabs(m->lo[i][j]) * (i == 3 ? 1 : range[i].largest) +
			    TINY;
	return fmax(all, m->least_noise[j]) == m->least_noise[j];
}

/* Cuts column j. Returns false if the column could overflow or underflow. */
static int cut_column(const struct kernel_map *m, int j, int terms,
    const struct kernel_range *range, struct column_cut *c)
{
	double most = fabs(m->hi[3][j]);
	int exponent;

	for (int i = 0; i < terms; i++)
		if (range[i].largest > 0 && fabs(m->hi[i][j]) > 0)
			most = fmax(most,
			    fmax(TINY, fabs(m->hi[i][j]) * range[i].power));
	frexp(most, &exponent);
	const double power = ldexp(1, exponent);

	c->noise_only = low_parts_are_noise(m, j, terms, range);
	for (int i = 0; i < 4; i++) {
		bool used = i == 3 || (i < terms && range[i].largest > 0);
		double unit = i == 3 ? ldexp(1, -POINT_CUT) :
		    used             ? range[i].inverse :
				       0;

		c->element[i] = used ? m->hi[i][j] : 0;
		c->high[i] = cut_to(c->element[i],
		    unit * power * ldexp(1, -ELEMENT_CUT));
		c->rest[i] = c->element[i] - c->high[i];
		if (used && !c->noise_only)
			c->rest[i] += m->lo[i][j];
	}
	for (int i = 0; i < terms; i++) {
		double shift = range[i].rest * c->element[i], old = c->rest[3];

		c->rest[3] = old - shift;
		c->noise_only &= is_product(range[i].rest, c->element[i], shift) &&
		    old - c->rest[3] == shift && c->rest[3] + shift == old;
	}
	double noise = largest_noise(m, j, terms, range);

	c->noisy_below = 0x1p56 * noise;
	c->bound = most > 0 ? COLUMN_BOUND * power + noise : 0;
	return is_moderate(most);
}

/* The ranges of a block of points, and the columns cut for them. For KERNEL_DIRECTION
 * column[3].bound is the bound of the length's error. */
struct kernel_block {
	struct kernel_range range[3];
	struct column_cut column[4];
	int moderate;   /* is_moderate is true for all ranges and columns */
	bool has_whole; /* range[k].whole is not 0 for some k */
};

static struct kernel_block block_of(const struct kernel_map *m,
    const double *const in[3], size_t n, enum kernel_kind kind)
{
	const int terms = kernel_inputs(kind);
	struct kernel_block b = { .moderate = 1 };

	for (int k = 0; k < terms; k++) {
		double low, high;

		find_limits(in[k], n, &low, &high);
		b.range[k] = range_of(low, high, m->origin[k]);
		b.moderate &= is_moderate(b.range[k].largest);
		b.has_whole |= fabs(b.range[k].whole) > 0;
	}
	for (int j = 0; j < 4; j++)
		if (j < kernel_outputs(kind) || (j == 3 && kernel_divides(kind)))
			b.moderate &= cut_column(m, j, terms, b.range, &b.column[j]);
	for (int j = 0; j < 3 && kind == KERNEL_DIRECTION; j++)
		b.column[3].bound += b.column[j].bound;
	return b;
}

typedef struct {
	V hi, lo;
} vdd;

static inline vdd v_two_sum(V a, V b)
{
	V s = a + b, t = s - a;

	return (vdd){ s, (a - (s - t)) + (b - t) };
}

static inline vdd normalise(vdd a)
{
	V s = a.hi + a.lo;

	return (vdd){ s, a.lo - (s - a.hi) };
}

/* Writes the points' differences from the origin as cut + rest, without the origin's
 * rest, whose product with the element cut_column has subtracted from the column. */
static inline void cut_points(const struct kernel_block *b, const V p[3], int terms,
    V cut[3], V rest[3])
{
	for (int k = 0; k < terms; k++) {
		const struct kernel_range *o = &b->range[k];
		V x = p[k];

		if (b->has_whole)
			x = x - ALL(o->whole);
		V s = x + ALL(o->rounder);

		cut[k] = s - ALL(o->rounder_and_cut);
		rest[k] = x - (s - ALL(o->rounder));
	}
}

static inline vdd column_sum(const struct column_cut *c, const V cut[3],
    const V rest[3], int terms)
{
	V hi = ALL(c->high[3]), lo = ALL(c->rest[3]);

	for (int k = 0; k < terms; k++)
		hi = MADD(cut[k], ALL(c->high[k]), hi);
	for (int k = 0; k < terms; k++)
		lo = MADD(rest[k], ALL(c->element[k]), lo);
	for (int k = 0; k < terms; k++)
		lo = MADD(cut[k], ALL(c->rest[k]), lo);
	return (vdd){ hi, lo };
}

/* Returns 0 if a is 0, or if |a| is above noisy_below, which is 2^56 times the noise:
 * then noise can't change the rounding of a. Otherwise returns a positive number. */
static inline V inexact_if_noisy(V a, double noisy_below)
{
	return IF_POSITIVE(ABS(a) - ALL(noisy_below), ALL(0), ABS(a));
}

/* Returns 0 if the column's sum, hi + lo, is exact apart from noise, and noise does not
 * change its rounding. Returns a positive number if this is not certain, for example if
 * a product may have underflowed. A sum midway between two doubles counts as a tie,
 * whatever the noise. Any other sum differs from each midpoint by at least half a unit
 * in the last place of the sum, or by 2^-53 |lo|. So inexact_if_noisy tests that the
 * noise is small beside the sum, and beside lo. */
static inline V column_inexactness(const struct column_cut *c, vdd sum, const V cut[3],
    const V rest[3], int terms)
{
	V lo = ALL(c->rest[3]), inexact = ALL(0);

	if (!c->noise_only)
		return ALL(1);
	for (int k = 0; k < 2 * terms; k++) {
		V a = k < terms ? rest[k] : cut[k - terms];
		double b = k < terms ? c->element[k] : c->rest[k - terms];

		if (b == 0)
			continue;
		V p = a * ALL(b);
		vdd s = v_two_sum(lo, p);

		inexact = inexact + ABS(FMA(a, ALL(b), -p)) + ABS(s.lo) +
		    IF_POSITIVE(ABS(p) - ALL(0x1p-900), ALL(0), ABS(a));
		lo = s.hi;
	}
	return inexact + inexact_if_noisy(lo, c->noisy_below) +
	    inexact_if_noisy(sum.hi + lo, c->noisy_below);
}

/* Returns hi + lo rounded. Rounding is monotone: if hi + lo - error and hi + lo + error
 * round to one double, so do all numbers between them. If not, *sure becomes 0. */
static inline V round_surely(V hi, V lo, V error, V *sure)
{
	V up = hi + (lo + error), down = hi + (lo - error);

	*sure = IF_EQUAL(up, down, *sure);
	return up;
}

/* Returns n / w rounded; *sure becomes 0 if the rounding is not certain. The first
 * quotient q is within 4 u |q| of n / w; the residual n - q w is at most 4 u |n|. q's
 * correction, the residual over w, has an error of at most 24 u^2 |q| plus 3 u times
 * the low parts, which are up to 9 times 2^-26 of their column's B. `bound` is above
 * 2^-74 |n|, and w_bound above 2^-74 w. If w is above w_bound, all errors together
 * leave a sixth of the bounds unused, even if the exact divisor is less than w. */
static inline V quotient(vdd n, vdd w, V reciprocal, V bound, V w_bound, V *sure)
{
	V q = (n.hi + n.lo) * reciprocal;
	V rest = FMA(q, -w.hi, n.hi) + MADD(q, -w.lo, n.lo);
	V error = MADD(ABS(q), w_bound, bound);
	V up = MADD(rest + error, reciprocal, q);
	V down = MADD(rest - error, reciprocal, q);

	*sure = IF_EQUAL(up, down, *sure);
	return up;
}

/* Rounds undivided columns once more, with error 0 for each column that is exact: an
 * exact column is often midway between two doubles, where no larger error lets it be
 * rounded. A lane of the result is positive if all roundings of the lane are sure. */
static V round_exact(const struct kernel_block *b, const V cut[3], const V rest[3],
    enum kernel_kind kind, V q[])
{
	const int terms = kernel_inputs(kind);
	V sure = ALL(b->moderate);

	for (int k = 0; k < kernel_outputs(kind); k++) {
		const struct column_cut *c = &b->column[k];
		vdd s = column_sum(c, cut, rest, terms);
		V inexact = column_inexactness(c, s, cut, rest, terms);

		q[k] = round_surely(s.hi, s.lo,
		    IF_POSITIVE(inexact, ALL(c->bound), ALL(0)), &sure);
	}
	return sure;
}

/* Returns the length of the vector a as hi + lo, with a relative error of at most
 * 60.2 u^2, and 1 / hi in *reciprocal. Let s be the sum of a's squares without those of
 * the low parts. hi is near the root of s, and lo is (s - hi^2) / (2 hi). Errors:
 * - 40.5 u^2 for the roundings of s - hi^2 and of lo;
 * - 4.5 u^2 for the squares of low parts, which are at most 3 u;
 * - 15.2 u^2 as hi + lo is above the root of s by lo^2 / (2 hi). lo is the low part of
 *   the length, which is at most 6 u: 5.5 u as counted, and 5.5^2 / 2 < 15.2. */
static inline vdd length_of(const vdd a[3], V *reciprocal)
{
	V square[3], low = ALL(0);

	for (int k = 0; k < 3; k++) {
		square[k] = a[k].hi * a[k].hi;
		low = low + FMA(a[k].hi, a[k].hi, -square[k]);
	}
	for (int k = 0; k < 3; k++)
		low = MADD(a[k].hi + a[k].hi, a[k].lo, low);
	vdd s = v_two_sum(square[0], square[1]);
	vdd t = v_two_sum(s.hi, square[2]);
	V root = SQRT(t.hi);
	V rest = FMA(-root, root, t.hi) + ((s.lo + t.lo) + low);

	*reciprocal = ALL(1) / root;
	return (vdd){ root, (rest * ALL(0.5)) * *reciprocal };
}

/* Returns x or, if the image is not sure, infinity or nan, as exact_kernel says. */
static inline V mark(V x, V sure, V behind)
{
	return IF_POSITIVE(sure, x,
	    IF_POSITIVE(behind, ALL(HUGE_VAL), ALL((double)NAN)));
}

/* Writes the images q of points p. Returns true if all roundings are sure. If a
 * rounding is not sure, its image gets nan or infinity in q[0] (see exact_kernel). The
 * other images are finite, as columns are below 2^202 and w is above 2^-274.
 *
 * A direction is divided by its length, whose error is at most the sum of the columns'
 * errors (triangle inequality). The length's bound is the sum of the columns' bounds.
 * Each of these is above 2^-74 of its column, and so the sum is above 2^-74 of the
 * length, as quotient() requires. If the length is below its bound, the error of each
 * quotient exceeds the quotient: no rounding is sure. */
static inline __attribute__((always_inline)) bool image_of(const struct kernel_block *b,
    const V p[3], V q[], enum kernel_kind kind)
{
	const int terms = kernel_inputs(kind), columns = kernel_outputs(kind);
	const bool divide = kernel_divides(kind);
	const bool direction = kind == KERNEL_DIRECTION;
	V cut[3], rest[3], r = ALL(1), sure = ALL(b->moderate);
	V bound = ALL(b->column[3].bound), w_sum = r;
	vdd w = { r, ALL(0) }, c[4];

	cut_points(b, p, terms, cut, rest);
	if (divide) {
		w = column_sum(&b->column[3], cut, rest, terms);
		w_sum = w.hi + w.lo;
		r = ALL(1) / w_sum;
	}
	for (int k = 0; k < 3 && direction; k++)
		c[k] = normalise(column_sum(&b->column[k], cut, rest, terms));
	if (direction)
		w = length_of(c, &r);
	for (int k = 0; k < columns; k++) {
		vdd s = direction ? c[k] : column_sum(&b->column[k], cut, rest, terms);
		V error = ALL(b->column[k].bound);

		q[k] = divide || direction ? quotient(s, w, r, error, bound, &sure) :
					     round_surely(s.hi, s.lo, error, &sure);
	}
	if (divide) /* if w is above its bound, it is surely positive */
		sure = MIN(w_sum - bound, sure);
	if (!divide && !direction && !ALL_POSITIVE(sure))
		sure = round_exact(b, cut, rest, kind, q);
	if (ALL_POSITIVE(sure))
		return true;
	q[0] = mark(q[0], sure,
	    IF_POSITIVE(-(w_sum + bound), ALL(b->moderate), ALL(0)));
	return false;
}

static inline __attribute__((always_inline)) int
exact_images(const struct kernel_map *m, const double *const in[3], double *const out[],
    size_t n, enum kernel_kind kind)
{
	const int terms = kernel_inputs(kind), outputs = kernel_outputs(kind);
	const struct kernel_block b = block_of(m, in, n, kind);
	const double *const from[3] = { in[0], in[1], in[terms - 1] };
	double *const to[4] = { out[0], out[1], out[outputs > 2 ? 2 : 1],
		out[outputs - 1] };
	int done = 1;

	for (size_t i = 0; i < n; i += WIDTH) {
		V p[3], q[4];

		for (int k = 0; k < terms; k++)
			p[k] = LOAD(from[k] + i);
		done &= image_of(&b, p, q, kind);
		for (int k = 0; k < outputs; k++)
			STORE(to[k] + i, q[k]);
	}
	return done;
}

#define LOOP(KIND, name, images)                                               \
	static int name(const struct kernel_map *m, const double *const in[3], \
	    double *const out[], size_t n)                                     \
	{                                                                      \
		return images(m, in, out, n, KIND);                            \
	}

LOOP(KERNEL_FLAT, exact_flat, exact_images)
LOOP(KERNEL_AFFINE, exact_affine, exact_images)
LOOP(KERNEL_XYZW, exact_xyzw, exact_images)
LOOP(KERNEL_PROJECTIVE, exact_projective, exact_images)
LOOP(KERNEL_DIRECTION, exact_direction, exact_images)
