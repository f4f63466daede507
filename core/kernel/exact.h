/* The fast phase of exact, written once for the vectors that copy.h describes:
 * each coordinate as a sum hi + lo with a bound of its error, and a test whether
 * all that lies within the bound rounds to the same double. If it doesn't, the
 * point is left to point.c.
 *
 * High parts add without error. In a block of points let a coordinate's difference
 * from the origin be below 2^e, each with its own e, and for a column let its
 * elements times 2^e, and the origin's image, be below B, a power of two. Points
 * and the origin are cut to multiples of 2^(e-26), elements to multiples of
 * 2^(-e-24) B. Then three products and the image are multiples of 2^-50 B, their
 * sum at most 2^52 + 2^27 of it.
 *
 * The rest is
 *
 *	lo = sum of (coordinate's rest) element + (cut coordinate) (element's rest)
 *
 * of three terms up to 2^-26 B, then three up to 2^-25 B, so that partial sums are
 * up to 1, 2, 3, 5, 7, 9 times 2^-26 B. Rounding these, products and rests, leaving
 * elements' low parts out of the first three terms, and normalise(), where |hi| <
 * |lo|, lose together 48.5 u 2^-26 B < 2^-73.3 B, where u = 2^-53: `make prove`
 * counts it from what stands here. */
#include "kernel.h"

/* The bound that is used, in units of B. More than half of it is left for what the
 * quotient and the test itself round, 2^-100 of a coordinate. */
#ifndef DIGITS /* of another number, as the proofs have it */
#define DIGITS 53
#define COLUMN_BOUND 0x1p-72
#define DEPTH_BOUND 0x1p-100 /* of a, where depth is a + b / w */
#define MODERATE 0x1p200
#endif
/* What isn't 0 counts as so much, though it underflow when it is scaled. */
#define LEAST 0x1p-1022

/* Binary places that are left to coordinates and elements by their cuts. */
enum { POINT_CUT = DIGITS / 2, ELEMENT_CUT = DIGITS - 3 - POINT_CUT };

/* Coordinates and columns of which nothing underflows or overflows. */
static int is_moderate(double largest)
{
	return largest == 0 || (largest > 1 / MODERATE && largest < MODERATE);
}

/* What rounds a to a multiple of unit, added and subtracted again, while |a| <
 * 2^(DIGITS-2) unit. */
static double rounder(double unit)
{
	return ldexp(1.5, DIGITS - 1) * unit;
}

static double cut_to(double a, double unit)
{
	double s = rounder(unit);

	return a + s - s;
}

static inline double least(V a)
{
	double all[WIDTH], r;

	STORE(all, a);
	r = all[0];
	for (int i = 1; i < WIDTH; i++)
		r = all[i] < r ? all[i] : r;
	return r;
}

/* What a block's coordinates have in common. Where the origin is less than 2^23
 * times as large as the differences from it, points are cut like it, and the parts
 * subtracted: high and rest. Else points lie so near to each other and to it that
 * the whole difference is exact: near. */
struct range {
	double largest; /* of the differences, a little up */
	int e;          /* below 2^e */
	double rounder; /* to multiples of 2^(e-26) */
	double near, high, rest;
};

static struct range range_of(const double *in, double origin, size_t n)
{
	struct range r = { 0, 0, 0, 0, 0, 0 };
	V most = ALL(0);

	for (size_t i = 0; i < n; i += WIDTH) {
		V d = ABS(LOAD(in + i) - ALL(origin));

		most = MAX(d, most);
	}
	r.largest = -least(-most) * (1 + ldexp(1, 3 - DIGITS));
	frexp(r.largest, &r.e);
	r.rounder = rounder(ldexp(1, r.e - POINT_CUT));
	if (!(fabs(origin) < ldexp(1, r.e + POINT_CUT - 3))) {
		r.near = origin;
		return r;
	}
	r.high = cut_to(origin, ldexp(1, r.e - POINT_CUT));
	r.rest = origin - r.high;
	return r;
}

/* What is no difference between a column's images (see struct sum). */
static double none_of(const struct kernel_map *m, int j, int terms,
    const struct range *range)
{
	double largest = 1;

	for (int k = 0; k < terms; k++)
		largest = fmax(largest, range[k].largest);
	return m->none[j] * largest;
}

/* A column's elements, and its origin's image, cut for a block of points. Where all
 * of them are held for 0, the column is 0. */
struct cut {
	double high[4], rest[4], all[4];
	double bound; /* of the error */
};

/* False where that is beyond the range. */
static int cut_column(const struct kernel_map *m, int j, int terms,
    const struct range *range, struct cut *c)
{
	double most = fabs(m->hi[3][j]);
	int f = 0;

	for (int i = 0; i < terms; i++)
		if (range[i].largest > 0 && fabs(m->hi[i][j]) > 0)
			most = fmax(most,
			    fmax(LEAST, ldexp(fabs(m->hi[i][j]), range[i].e)));
	frexp(most, &f);
	for (int i = 0; i < 4; i++) {
		bool counts = i == 3 || (i < terms && range[i].largest > 0);
		double unit = ldexp(1,
		    i == 3     ? f - ELEMENT_CUT - POINT_CUT :
			counts ? f - ELEMENT_CUT - range[i].e :
				 0);

		c->all[i] = counts ? m->hi[i][j] : 0;
		c->high[i] = cut_to(c->all[i], unit);
		c->rest[i] = counts ? (c->all[i] - c->high[i]) + m->lo[i][j] :
				      0;
	}
	c->bound = most > 0 ?
	    ldexp(COLUMN_BOUND, f) + none_of(m, j, terms, range) :
	    0;
	return is_moderate(most);
}

/* A block of points as the map's columns need it. */
struct block {
	struct range range[3];
	struct cut cut[4];
	int moderate;
	double none; /* in depth times w */
};

static struct block block_of(const struct kernel_map *m,
    const double *const in[3], size_t n, enum kernel_kind kind)
{
	const int terms = kernel_terms(kind);
	struct block b = { .moderate = 1 };

	for (int k = 0; k < terms; k++) {
		b.range[k] = range_of(in[k], m->origin[k], n);
		b.moderate &= is_moderate(b.range[k].largest);
	}
	for (int j = 0; j < 4; j++)
		if (j < kernel_columns(kind) ||
		    (j == 3 && kernel_divides(kind)))
			b.moderate &= cut_column(m, j, terms, b.range,
			    &b.cut[j]);
	if (kind != KERNEL_DEPTH)
		return b;
	b.moderate &= is_moderate(fabs(m->a_hi)) & is_moderate(fabs(m->b_hi));
	b.none = none_of(m, 2, terms, b.range) +
	    fabs(m->a_hi) * none_of(m, 3, terms, b.range);
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

static inline vdd normalise(V hi, V lo)
{
	V s = hi + lo;

	return (vdd){ s, lo - (s - hi) };
}

/* Coordinates i to i + WIDTH relative to the origin. */
static inline void cut_points(const struct block *b, const double *const in[3],
    size_t i, int terms, V cut[3], V rest[3])
{
	for (int k = 0; k < terms; k++) {
		const struct range *o = &b->range[k];
		V x = LOAD(in[k] + i) - ALL(o->near);
		V high = (x + ALL(o->rounder)) - ALL(o->rounder);

		cut[k] = high - ALL(o->high);
		rest[k] = (x - high) - ALL(o->rest);
	}
}

static inline vdd column(const struct cut *c, const V cut[3], const V rest[3],
    int terms)
{
	V hi = ALL(c->high[3]), lo = ALL(c->rest[3]);

	for (int k = 0; k < terms; k++)
		hi = MADD(cut[k], ALL(c->high[k]), hi);
	for (int k = 0; k < terms; k++)
		lo = MADD(rest[k], ALL(c->all[k]), lo);
	for (int k = 0; k < terms; k++)
		lo = MADD(cut[k], ALL(c->rest[k]), lo);
	return normalise(hi, lo);
}

/* Rounds hi + lo; both ways are the same where the error counts for nothing, as
 * all that lies between rounds to what lies between. */
static inline V round_surely(V hi, V lo, V error, V *sure)
{
	V up = hi + (lo + error), down = hi + (lo - error);

	*sure = SAME(up, down, *sure);
	return up;
}

/* n / w: q is within 2 u of its size, and so is the residual n - q w, from which
 * the rest follows within 67 u^2 of q, though low parts be 3 u. The bounds are
 * above 2^-74 of n and w, and columns leave more than half of them, which covers
 * this a thousand times; and that w, which is above its own bound, may be less than
 * it is divided by. */
static inline V quotient(vdd n, vdd w, V reciprocal, V bound, V w_bound,
    V *sure)
{
	V q = n.hi * reciprocal;
	V rest = FMA(-q, w.hi, n.hi) + MADD(-q, w.lo, n.lo);
	V error = reciprocal * MADD(ABS(q), w_bound, bound);

	return round_surely(q, rest * reciprocal, error, sure);
}

/* a + b / w, by the quotient's steps; what they lose of a is below 11 u^2 of it.
 * A difference of none in a w + b is none. */
static inline V depth(const struct kernel_map *m, vdd w, V reciprocal, V none,
    V w_bound, V *sure)
{
	V b = ALL(m->b_hi), q = b * reciprocal;
	V rest = FMA(-q, w.hi, b) + MADD(-q, w.lo, ALL(m->b_lo));
	vdd s = v_two_sum(ALL(m->a_hi), q);
	V error = MADD(reciprocal, MADD(ABS(q), w_bound, none),
	    ALL(DEPTH_BOUND * fabs(m->a_hi)));

	return round_surely(s.hi, s.lo + MADD(rest, reciprocal, ALL(m->a_lo)),
	    error, sure);
}

static inline __attribute__((always_inline)) int
exact(const struct kernel_map *m, const double *const in[3],
    double *const out[3], size_t n, enum kernel_kind kind)
{
	const int terms = kernel_terms(kind), columns = kernel_columns(kind);
	const int divide = kernel_divides(kind);
	const struct block b = block_of(m, in, n, kind);
	int done = 1;

	for (size_t i = 0; i < n; i += WIDTH) {
		V cut[3], rest[3], q[3], r = ALL(1), sure = ALL(b.moderate);
		V bound = ALL(0);
		vdd w = { r, bound };

		cut_points(&b, in, i, terms, cut, rest);
		if (divide) {
			w = column(&b.cut[3], cut, rest, terms);
			r = ALL(1) / w.hi;
			bound = ALL(b.cut[3].bound);
		}
		for (int k = 0; k < columns; k++) {
			vdd s = column(&b.cut[k], cut, rest, terms);
			V error = ALL(b.cut[k].bound);

			q[k] = divide ? quotient(s, w, r, error, bound, &sure) :
					round_surely(s.hi, s.lo, error, &sure);
		}
		if (kind == KERNEL_DEPTH)
			q[2] = depth(m, w, r, ALL(b.none), bound, &sure);
		if (divide)
			sure = CHOOSE(w.hi - bound, sure, ALL(0));
		if (!IS_POSITIVE(sure)) {
			V none = CHOOSE(-(w.hi + bound), ALL(b.moderate),
			    ALL(0));

			q[0] = CHOOSE(sure, q[0],
			    CHOOSE(none, ALL(HUGE_VAL), ALL((double)NAN)));
			done = 0;
		}
		for (int k = 0; k < terms; k++)
			STORE(out[k] + i, q[k]);
	}
	return done;
}

/* The length of three columns, within 60.2 u^2: the remainder is the square's less the
 * root's, summed without error but for low parts, of u each; of the squares of low
 * parts, which are left out, come 15 from the length's own and 5 from the columns'.
 * The length's low part is up to 6 u, as columns' are 3 u. */
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

/* A length is off by no more than the sum of what its columns are off by (the
 * triangle's inequality), and that sum's bound is above 2^-74 of it, as a
 * column's is of the column. Of a length below its bound some quotient is below its
 * own, so that it is not sure. */
static int exact_direction(const struct kernel_map *m,
    const double *const in[3], double *const out[3], size_t n)
{
	const struct block b = block_of(m, in, n, KERNEL_DIRECTION);
	const V bound = ALL(b.cut[0].bound + b.cut[1].bound + b.cut[2].bound);
	int done = 1;

	for (size_t i = 0; i < n; i += WIDTH) {
		V cut[3], rest[3], q[3], r, sure = ALL(b.moderate);
		vdd c[3];

		cut_points(&b, in, i, 2, cut, rest);
		for (int k = 0; k < 3; k++)
			c[k] = column(&b.cut[k], cut, rest, 2);
		vdd length = length_of(c, &r);

		for (int k = 0; k < 3; k++)
			q[k] = quotient(c[k], length, r, ALL(b.cut[k].bound),
			    bound, &sure);
		if (!IS_POSITIVE(sure)) {
			q[0] = CHOOSE(sure, q[0], ALL((double)NAN));
			done = 0;
		}
		for (int k = 0; k < 3; k++)
			STORE(out[k] + i, q[k]);
	}
	return done;
}

#define LOOP(KIND, name)                                                       \
	static int name(const struct kernel_map *m, const double *const in[3], \
	    double *const out[3], size_t n)                                    \
	{                                                                      \
		return exact(m, in, out, n, KIND);                             \
	}

LOOP(KERNEL_FLAT, exact_flat)
LOOP(KERNEL_AFFINE, exact_affine)
LOOP(KERNEL_DEPTH, exact_depth)
LOOP(KERNEL_PROJECTIVE, exact_projective)
#undef LOOP
