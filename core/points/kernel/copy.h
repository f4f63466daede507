/* SPDX-License-Identifier: MIT */
/* The kernels for one kind of processor. A file that includes copy.h defines:
 *
 *	KERNELS_NAME	the name of its struct kernels
 *	PROCESSOR	its kind of processor (enum processor)
 *
 * and the operations below, as simd_avx2.h, simd_avx512.h and simd_neon.h do:
 *
 *	V, WIDTH	a vector of doubles, and the number of its lanes
 *	M		a mask: true or false for each lane; has & | ~
 *	LOAD, STORE	load or store a V at any address
 *	ALL(a)		a in each lane
 *	FMA(a, b, c)	a b + c, rounded once
 *	ABS, SQRT	the magnitude, and the root, rounded once
 *	MIN, MAX(a, b)	a < b ? a : b, and a > b ? a : b, also for nan
 *	LESS, EQUAL	the masks of a < b and a == b; false for nan
 *	MASK_BITS(m)	an integer; bit i is set if lane i of m is true
 *	SELECT(m, a, b)	m ? a : b in each lane
 *	ONLY(m, a)	m ? a : 0 in each lane
 *
 * and may define MADD(a, b, c), a b + c with a rounded product, if this is faster than
 * FMA. V also has +, -, * and /. Each operation but MADD rounds once (IEEE 754). */
#include <math.h>

#ifndef MADD
#define MADD FMA
#endif
#define IF_EQUAL(a, b, c) ONLY(EQUAL(a, b), c)
#define IF_POSITIVE(a, b, c) SELECT(LESS(ALL(0), a), b, c)
#define ALL_POSITIVE(a) (MASK_BITS(LESS(ALL(0), a)) == (1u << WIDTH) - 1)

#include "exact.h"
#include "doubled.h"
#include "reach.h"
#include "rows.h"
#include "signs.h"

#define REAL double
#define R_FMA fma
#define W_MAX 0x1p1000
#define NAME(x) double_##x
#include "approx.h"

#undef REAL
#undef R_FMA
#undef W_MAX
#undef NAME

#define REAL float
#define R_FMA fmaf
#define W_MAX 0x1p120f
#define NAME(x) single_##x
#include "approx.h"

#include "float_rows.h"

#define KERNELS_OF(prefix, depth)                                         \
	[KERNEL_FLAT] = prefix##_flat, [KERNEL_AFFINE] = prefix##_affine, \
	[KERNEL_PROJECTIVE] = prefix##_projective, [KERNEL_DEPTH] = prefix##_##depth

#define ROWS_OF(name)                                          \
	{                                                      \
		[2] = name##_2, [3] = name##_3, [4] = name##_4 \
	}

const struct kernels KERNELS_NAME = {
	.processor = PROCESSOR,
	.exact = { KERNELS_OF(exact, projective), [KERNEL_XYZW] = exact_xyzw,
	    [KERNEL_DIRECTION] = exact_direction },
	.doubled = { KERNELS_OF(doubled, projective),
	    [KERNEL_XYZW] = doubled_xyzw },
	.approx = {
		[PRECISION_DOUBLE] = { KERNELS_OF(double, depth) },
		[PRECISION_SINGLE] = { KERNELS_OF(single, depth) },
	},
	.float_rows = { KERNELS_OF(float_rows, depth) },
	.signs = signs,
	.reach = block_reach,
	.to_columns = { ROWS_OF(to_columns_floats),
	    ROWS_OF(to_columns_doubles) },
	.to_rows = { ROWS_OF(to_rows_floats), ROWS_OF(to_rows_doubles) },
};
