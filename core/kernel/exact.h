/* The fast phase of exact, written once for the vectors that copy.h describes:
 * each coordinate as a sum hi + lo with a bound of its error, and a test whether
 * all that lies within the bound rounds to the same double. If it doesn't, the
 * point is left to point.c. `make prove` counts the errors of what stands here;
 * the numbers below are what it finds.
 *
 * High parts add without error: for a block of points |p - origin| < 2^e, and a
 * column's elements, with its origin's image over 2^e, are below 2^f. Coordinates
 * are cut to multiples of 2^(e-26), elements to multiples of 2^(f-25). Then three
 * products and the image are whole multiples of 2^(e+f-51), and with B = 2^(e+f)
 * none is above B: their sums are at most 4 B, which is 2^53 of it. The rest is
 *
 *	lo = sum of (coordinate's rest) element + (cut coordinate) (element's rest)
 *
 * of three terms up to B/2^27 and three up to B/2^26, summed in this order. In
 * units of u 2^-26 B = 2^-79 B, where u = 2^-53:
 *
 *	10.5	rounding the sums of 0.5, 1, 1.5, 2.5, 3.5, 4.5 times 2^-26 B
 *	4.5	rounding the products, where they are not fused with the sums
 *	4.5	rounding the rests: three times 1/2 and three times 1
 *	0.75	the elements' low parts, left out of the first three terms
 *	4	normalise(), where |hi| < |lo|
 *
 * 24.25 in all, where products are fused 19.75; less than half of the bound. */
#include "kernel.h"

/* The proofs compile this file for numbers of other digits, too: with theirs in
 * the place of a double's. */
#ifndef DIGITS
#define DIGITS 53
#define COLUMN_BOUND 0x1p-72 /* of B */
#define DEPTH_BOUND 0x1p-100 /* of a */
#define EXPONENT_MAX 200     /* of e and f: nothing underflows or overflows */
#endif

/* Binary places that are left to coordinates and elements by their cuts. */
enum { POINT_CUT = DIGITS / 2, ELEMENT_CUT = DIGITS - 2 - POINT_CUT };

/* A column's elements, cut for a block of points. */
struct cut {
	double high[4], rest[4], all[4];
	double bound; /* of the error */
};

/* What rounds a to a multiple of unit, added and subtracted again, while
 * |a| < 2^(DIGITS-2) unit. */
static double rounder(double unit)
{
	return ldexp(1.5, DIGITS - 1) * unit;
}

static double cut_to(double a, double unit)
{
	double s = rounder(unit);

	return a + s - s;
}

/* e of the least 2^e above a >= 0; 0 for 0. */
static int exponent(double a)
{
	int e = 0;

	if (!(a < HUGE_VAL))
		return EXPONENT_MAX;
	frexp(a, &e);
	return e;
}

static int is_moderate(int e)
{
	return e > -EXPONENT_MAX && e < EXPONENT_MAX;
}

static double none_of(const struct kernel_map *m, int j, int e)
{
	return ldexp(m->none[j], e > 0 ? e : 0);
}

/* False where that is beyond the range. */
static int cut_column(const struct kernel_map *m, int j, int terms, int e,
    struct cut *c)
{
	double most = 0;

	for (int i = 0; i < terms; i++)
		most = fmax(most, fabs(m->hi[i][j]));
	most = fmax(most, ldexp(fabs(m->hi[3][j]), -e));
	int f = exponent(most);

	for (int i = 0; i < 4; i++) {
		double unit = ldexp(1,
		    (i < 3 ? f : e + f - POINT_CUT) - ELEMENT_CUT);

		c->high[i] = cut_to(m->hi[i][j], unit);
		c->rest[i] = (m->hi[i][j] - c->high[i]) + m->lo[i][j];
		c->all[i] = m->hi[i][j];
	}
	c->bound = most > 0 ? ldexp(COLUMN_BOUND, e + f) : 0;
	c->bound += none_of(m, j, e);
	return is_moderate(f);
}

/* As much of a w + b as the kernel map's sums hold for none. */
static double depth_none(const struct kernel_map *m, int e)
{
	return none_of(m, 2, e) + fabs(m->a_hi) * none_of(m, 3, e);
}

static int is_depth_moderate(const struct kernel_map *m)
{
	return is_moderate(exponent(fabs(m->a_hi))) &&
	    is_moderate(exponent(fabs(m->b_hi)));
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

/* The exponent e of the block; 0 where all points are the origin. */
static int exponent_of(const struct kernel_map *m, int terms,
    const double *const in[3], size_t n)
{
	V most = ALL(0);

	for (size_t i = 0; i < n; i += WIDTH)
		for (int k = 0; k < terms; k++) {
			V d = ABS(LOAD(in[k] + i) - ALL(m->origin[k]));

			most = MAX(d, most);
		}
	return exponent(-least(-most) * (1 + ldexp(1, 3 - DIGITS)));
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
 * the rest follows within 80 u^2 of q, though low parts be 3 u. The bounds are
 * above 2^-74 of n and w, and columns need half of them, so that the other half
 * covers this a million times; and that w, which is above its own bound, may be
 * a quarter less than it is divided by. */
static inline V quotient(vdd n, vdd w, V reciprocal, V bound, V w_bound,
    V *sure)
{
	V q = n.hi * reciprocal;
	V rest = FMA(-q, w.hi, n.hi) + MADD(-q, w.lo, n.lo);
	V error = reciprocal * MADD(ABS(q), w_bound, bound);

	return round_surely(q, rest * reciprocal, error, sure);
}

/* a + b / w, by the quotient's steps; what they lose of a is below 16 u^2 of it.
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
	const int terms = kind == KERNEL_FLAT ? 2 : 3;
	const int divide = kind == KERNEL_DEPTH || kind == KERNEL_PROJECTIVE;
	const int columns = kind == KERNEL_DEPTH ? 2 : terms;
	const int e = exponent_of(m, terms, in, n);
	const V none = ALL(depth_none(m, e));
	const V shift = ALL(rounder(ldexp(1, e - POINT_CUT)));
	struct cut c[4];
	int moderate = is_moderate(e) &&
	    (kind != KERNEL_DEPTH || is_depth_moderate(m));
	V done = ALL(1);

	for (int j = 0; j < 4; j++)
		if (j < columns || (j == 3 && divide))
			moderate &= cut_column(m, j, terms, e, &c[j]);
	for (size_t i = 0; i < n; i += WIDTH) {
		V cut[3], rest[3], q[3], r = ALL(1), sure = ALL(moderate);
		V bound = ALL(0);
		vdd w = { r, bound };

		for (int k = 0; k < terms; k++) {
			vdd p = v_two_sum(LOAD(in[k] + i), ALL(-m->origin[k]));

			cut[k] = (p.hi + shift) - shift;
			rest[k] = (p.hi - cut[k]) + p.lo;
		}
		if (divide) {
			w = column(&c[3], cut, rest, terms);
			r = ALL(1) / w.hi;
			bound = ALL(c[3].bound);
		}
		for (int k = 0; k < columns; k++) {
			vdd s = column(&c[k], cut, rest, terms);

			q[k] = divide ?
			    quotient(s, w, r, ALL(c[k].bound), bound, &sure) :
			    round_surely(s.hi, s.lo, ALL(c[k].bound), &sure);
		}
		if (kind == KERNEL_DEPTH)
			q[2] = depth(m, w, r, none, bound, &sure);
		if (divide)
			sure = CHOOSE(w.hi - bound, sure,
			    CHOOSE(-(w.hi + bound), ALL(-moderate), ALL(0)));
		q[0] = CHOOSE(sure, q[0],
		    CHOOSE(-sure, ALL(INFINITY), ALL(NAN)));
		done = MIN(done, sure);
		for (int k = 0; k < terms; k++)
			STORE(out[k] + i, q[k]);
	}
	return least(done) > 0;
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
