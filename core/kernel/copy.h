/* The loops for one kind of processor. A file that includes this defines:
 *
 *	COPY		the name of its struct kernels
 *	V, WIDTH	a vector of doubles, and how many it holds
 *	LOAD, STORE	from and to any address
 *	ALL(a)		a in each lane
 *	FMA(a, b, c)	a b + c, rounded once
 *	MADD(a, b, c)	the same, or the product rounded before: what is faster
 *	ABS SQRT
 *	MIN MAX		MIN is a < b ? a : b, MAX a > b ? a : b, nan or not
 *	SAME(a, b, c)	a == b ? c : 0
 *	CHOOSE(a, b, c)	a > 0 ? b : c
 *	IS_POSITIVE(a)	whether all of a are above 0
 *
 * and the same of FMA, ABS and MAX for floats, F and F_..., but that F_NEAR(p, o)
 * reads doubles and gives their difference from o rounded to floats, F_STORE
 * writes doubles, and F_POSITIVE(a, b) is a > 0 ? b : nan. Vectors have +, -, *
 * and /. Every operation is one rounding of IEEE 754 in each lane. */
#include <math.h>

#include "exact.h"

/* Below which |x| + |y| + |z| makes no sum of the map's larger than most. */
static double size_limit(const struct kernel_map *m, enum kernel_kind kind,
    double most)
{
	double limit = most;

	for (int j = 0; j < 4; j++) {
		if (j >= kernel_columns(kind) &&
		    (j < 3 || !kernel_divides(kind)))
			continue;
		limit = fmin(limit,
		    m->most[j] <= most ? (most - m->image[j]) / m->most[j] : 0);
	}
	return limit;
}

#define REAL double
#define R V
#define R_WIDTH WIDTH
#define R_NEAR(p, o) (LOAD(p) - ALL(o))
#define R_STORE(p, a) STORE(p, a)
#define R_ALL(a) ALL(a)
#define R_FMA(a, b, c) FMA(a, b, c)
#define R_ABS(a) ABS(a)
#define R_MAX(a, b) MAX(a, b)
#define R_POSITIVE(a, b) CHOOSE(a, b, ALL((double)NAN))
#define ROUNDOFF 0x1p-53
#define TINY 0x1p-1022
#define MOST 0x1p1000
#define NAME(x) double_##x
#include "plain.h"
#undef REAL
#undef R
#undef R_WIDTH
#undef R_NEAR
#undef R_STORE
#undef R_ALL
#undef R_FMA
#undef R_ABS
#undef R_MAX
#undef R_POSITIVE
#undef ROUNDOFF
#undef TINY
#undef MOST
#undef NAME

#define REAL float
#define R F
#define R_WIDTH F_WIDTH
#define R_NEAR(p, o) F_NEAR(p, o)
#define R_STORE(p, a) F_STORE(p, a)
#define R_ALL(a) F_ALL(a)
#define R_FMA(a, b, c) F_FMA(a, b, c)
#define R_ABS(a) F_ABS(a)
#define R_MAX(a, b) F_MAX(a, b)
#define R_POSITIVE(a, b) F_POSITIVE(a, b)
#define ROUNDOFF 0x1p-24f
#define TINY 0x1p-126
#define MOST 0x1p120
#define NAME(x) single_##x
#include "plain.h"

#define KERNELS_OF(prefix)                                                \
	[KERNEL_FLAT] = prefix##_flat, [KERNEL_AFFINE] = prefix##_affine, \
	[KERNEL_DEPTH] = prefix##_depth,                                  \
	[KERNEL_PROJECTIVE] = prefix##_projective

const struct kernels COPY = {
	.exact = { KERNELS_OF(exact), [KERNEL_DIRECTION] = exact_direction },
	.plain = {
		[PRECISION_DOUBLE] = { KERNELS_OF(double) },
		[PRECISION_SINGLE] = { KERNELS_OF(single) },
	},
};
