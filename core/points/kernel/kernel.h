/* SPDX-License-Identifier: MIT */
/* The inner loops: one body a precision, compiled once for each kind of
 * processor with the same bits from each. */
#ifndef KERNEL_H
#define KERNEL_H

#include <stdbool.h>
#include <stddef.h>

enum { POINTS_BLOCK = 1024 };

/* Of columns, best: a vector that crosses two lines of the cache takes longer, a
 * fifth of all time in double. */
#define COLUMN_ALIGNED _Alignas(64)

/* What the matrix's structure makes of the loop. */
enum kernel_kind {
	KERNEL_NONE,       /* none of these: point by point */
	KERNEL_FLAT,       /* two coordinates, no division */
	KERNEL_AFFINE,     /* no division */
	KERNEL_FOUR,       /* x, y, z and w, not divided; of exact alone */
	KERNEL_DEPTH,      /* x and y divided by w, depth = a + b / w */
	KERNEL_PROJECTIVE, /* x, y, z divided by w */
	KERNEL_DIRECTION, /* two coordinates to three, divided by their length */
	KERNELS,
};

/* Coordinates in; coordinates out, of which some are columns; and whether these are
 * divided. */
static inline int kernel_terms(enum kernel_kind kind)
{
	return kind == KERNEL_FLAT || kind == KERNEL_DIRECTION ? 2 : 3;
}

static inline int kernel_outputs(enum kernel_kind kind)
{
	return kind == KERNEL_FLAT ? 2 : kind == KERNEL_FOUR ? 4 : 3;
}

static inline int kernel_columns(enum kernel_kind kind)
{
	return kind == KERNEL_DEPTH ? 2 : kernel_outputs(kind);
}

static inline bool kernel_divides(enum kernel_kind kind)
{
	return kind == KERNEL_DEPTH || kind == KERNEL_PROJECTIVE;
}

enum precision { PRECISION_EXACT, PRECISION_DOUBLE, PRECISION_SINGLE };

/* A map as the loops take it: the image of p is (p - origin, 1) times hi + lo,
 * whose elements are within u^2 / 2 of their exact values. */
struct kernel_map {
	double origin[3];
	double hi[4][4], lo[4][4];
	bool exact[4][4];              /* the element is hi */
	double a_hi, a_lo, b_hi, b_lo; /* of KERNEL_DEPTH */
	/* A column's products are at most most (|x|+|y|+|z|) + image. */
	double most[4], image[4];
	/* A difference of none (2^e + 1) between two images' columns is to be
	 * taken for none, where |p - origin| < 2^e (see struct sum). */
	double none[4];
	/* Of any point's column so much is none, or half of it. */
	double surely_none[4];
};

/* The nearest doubles to the exact image, where that is sure. Otherwise the first
 * coordinate is nan; or infinite, where w is surely not positive and there is no
 * image. Returns whether neither was. Columns have room for a whole number of
 * vectors: n rounded up to 16. */
typedef int (*exact_kernel)(const struct kernel_map *,
    const double *const in[3], double *const out[], size_t n);

/* Where there is no image, or something on the way was beyond the precision's
 * range, a coordinate is nan or infinite. Returns whether that is surely nowhere so. */
typedef int (*plain_kernel)(const struct kernel_map *,
    const double *const in[3], double *const out[3], size_t n);

/* The same in single, from rows of floats to rows of floats, -0 as 0. */
typedef int (*float_kernel)(const struct kernel_map *, const char *in,
    char *out, size_t n);

/* The bound of the plain kernels' errors, in units of roundoff; derived and
 * claimed in plain.h. */
#define PLAIN_BOUND 10

/* Points in rows, of floats or doubles, to columns of doubles. Returns whether none
 * is beyond most in magnitude; nan isn't. */
typedef int (*split_kernel)(const char *rows, double (*columns)[POINTS_BLOCK],
    size_t n, double most);

/* And back, -0 as 0. Returns whether all are finite and, where they were rounded
 * to floats, none is_midway. */
typedef int (
    *join_kernel)(double (*columns)[POINTS_BLOCK], char *rows, size_t n);

/* The columns of a map: all their values above slope all + floor have sure signs
 * where all, |x| + |y| + |z| from the origin, is not below low and below high. One
 * bound for all columns, the largest, leaves a few more points to be looked at and
 * saves the others. */
struct estimate {
	double origin[3], m[4][4], slope, floor, low, high;
};

enum { SIGNS_UNSURE = 1 << 16 };

/* Differences from the origin, elements and products are rounded, then three sums: 6
 * u of the sum of the products' magnitudes, as `make prove` counts it. A third more
 * is enough for roundings of the bound itself. */
#define ESTIMATE_BOUND 0x1p-50

/* Column j of the image of x, y, z, relative to the origin. */
static inline double estimate_column(const double m[4][4], int j, double x,
    double y, double z)
{
	return x * m[0][j] + y * m[1][j] + z * m[2][j] + m[3][j];
}

/* Adds weight 2^j to word[i] where column j, of 3 or 4, is negative at point i, and
 * SIGNS_UNSURE where that is not sure of all. */
typedef void (*signs_kernel)(const struct estimate *, int columns,
    double weight, const double *const in[3], double *word, size_t n);

/* The kinds of processors that the loops are compiled for. */
enum processor {
	PROCESSOR_BASELINE,
	PROCESSOR_AVX2,
	PROCESSOR_AVX512,
	PROCESSOR_NEON,
	PROCESSORS,
};

/* Finds for each direction j the greatest m[j][0] x + m[j][1] y + m[j][2] z, with
 * four roundings, and for each coordinate the greatest magnitude; -infinity or 0
 * where all are nan. Reads n numbers of a column, rounded up to 16. */
typedef void (*farthest_kernel)(const double (*m)[3], int directions,
    const double *const in[3], size_t n, double *most, double largest[3]);

struct kernels {
	enum processor processor;
	exact_kernel exact[KERNELS];
	plain_kernel plain[3][KERNELS]; /* by precision */
	float_kernel floats[KERNELS];
	signs_kernel signs;
	farthest_kernel farthest;
	/* By whether rows are of doubles, and how many. */
	split_kernel split[2][5];
	join_kernel join[2][5];
};

extern const struct kernels kernels_baseline, kernels_avx2, kernels_avx512,
    kernels_neon;

/* The best copy that this processor runs, or the named one (baseline, avx2, avx512,
 * neon); NULL where it can't run that or there is none of that name. */
const struct kernels *kernels_find(const char *name);

#endif
