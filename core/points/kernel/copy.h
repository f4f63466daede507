/* SPDX-License-Identifier: MIT */
/* The loops for one kind of processor. A file that includes this defines:
 *
 *	COPY, PROCESSOR	the name of its struct kernels, and what it is for
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
 * and the same of FMA for floats, F and F_..., but that F_NEAR(p, o)
 * reads doubles and gives their difference from o rounded to floats, F_STORE
 * writes doubles, and F_POSITIVE(a, b) is a > 0 ? b : nan. F_LOAD and F_SAVE are
 * from and to floats, and F_FAR(p, o) is F_NEAR of what is floats in memory.
 * Vectors have +, -, * and /. Every operation is one rounding of IEEE 754 in each
 * lane. */
#include <math.h>

#include "exact.h"
#include "farthest.h"
#include "rows.h"
#include "signs.h"

#define REAL double
#define R_FMA fma
#define MOST 0x1p1000
#define NAME(x) double_##x
#include "plain.h"

#undef REAL
#undef R_FMA
#undef MOST
#undef NAME

#define REAL float
#define R_FMA fmaf
#define MOST 0x1p120f
#define NAME(x) single_##x
#include "plain.h"

#include "floats.h"

#define KERNELS_OF(prefix)                                                \
	[KERNEL_FLAT] = prefix##_flat, [KERNEL_AFFINE] = prefix##_affine, \
	[KERNEL_DEPTH] = prefix##_depth,                                  \
	[KERNEL_PROJECTIVE] = prefix##_projective

#define ROWS_OF(name)                                          \
	{                                                      \
		[2] = name##_2, [3] = name##_3, [4] = name##_4 \
	}

const struct kernels COPY = {
	.processor = PROCESSOR,
	.exact = { KERNELS_OF(exact), [KERNEL_FOUR] = exact_four, [KERNEL_DIRECTION] = exact_direction },
	.plain = {
		[PRECISION_DOUBLE] = { KERNELS_OF(double) },
		[PRECISION_SINGLE] = { KERNELS_OF(single) },
	},
	.floats = { KERNELS_OF(floats) },
	.signs = signs,
	.farthest = farthest,
	.split = { ROWS_OF(split_narrow), ROWS_OF(split_wide) },
	.join = { ROWS_OF(join_narrow), ROWS_OF(join_wide) },
};
