/* SPDX-License-Identifier: MIT */
/* The kernels, the inner loops over points. The loop of each precision is written once,
 * and compiled for each kind of processor. All processors get the same bits. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { POINTS_BLOCK = 1024 };

/* Aligns a column to cache lines, which saves a fifth of PRECISION_DOUBLE's time. */
#define COLUMN_ALIGNED _Alignas(64)

/* The kinds of kernels, by the structure of the matrix. */
enum kernel_kind {
	KERNEL_NONE,       /* no kernel: points.c and point.c compute the images */
	KERNEL_FLAT,       /* two coordinates, not divided */
	KERNEL_AFFINE,     /* x, y and z, not divided */
	KERNEL_XYZW,       /* x, y, z and w, not divided; PRECISION_EXACT only */
	KERNEL_PROJECTIVE, /* x, y and z divided by w */
	KERNEL_DEPTH,      /* z is a + b / w; in PRECISION_EXACT as PROJECTIVE */
	KERNEL_DIRECTION,  /* from x and y to x, y and z of a unit vector */
	KERNELS,
};

/* How many coordinates a point and its image have, and whether they
 * are divided by w. */
static inline int kernel_inputs(enum kernel_kind kind)
{
	return kind == KERNEL_FLAT || kind == KERNEL_DIRECTION ? 2 : 3;
}

static inline int kernel_outputs(enum kernel_kind kind)
{
	return kind == KERNEL_FLAT ? 2 : kind == KERNEL_XYZW ? 4 : 3;
}

static inline bool kernel_divides(enum kernel_kind kind)
{
	return kind == KERNEL_DEPTH || kind == KERNEL_PROJECTIVE;
}

enum precision { PRECISION_EXACT, PRECISION_DOUBLE, PRECISION_SINGLE };

/* A map for the kernels: the image of p is (p - origin, 1) times the matrix hi + lo.
 * The relative error of an element hi + lo is at most u^2 / 2, where u = 2^-53. */
struct kernel_map {
	double origin[3];
	double hi[4][4], lo[4][4];
	bool hi_is_exact[4][4]; /* the element is exactly hi */
	double a, b;            /* of KERNEL_DEPTH: z = a + b / w */
	/* The sum of the magnitudes of the products in column j is at most slope[j]
	 * (|x|+|y|+|z|) + offset[j], for x, y, z relative to the origin. */
	double slope[4], offset[4];
	/* Elements of the struct map can have errors, which change column j by at most
	 * noise[j] max(1, d) if |x|, |y| and |z| are at most d. Values of the column
	 * that differ by this noise or less count as equal. */
	double noise[4];
	/* A lower bound of the noise of column j at any point. */
	double least_noise[4];
};

/* Writes the doubles nearest to the exact images of n points. The first coordinate of
 * an image becomes infinite if w is surely not positive, so that there is no image, or
 * else nan if the rounding of any of the coordinates is not certain. Returns true if
 * neither happened. Columns have room for n rounded up to a multiple of 16. */
typedef int (*exact_kernel)(const struct kernel_map *, const double *const in[3],
    double *const out[], size_t n);

/* Writes images computed in double or single precision. A coordinate becomes nan or
 * infinite if its point has no image, or if an intermediate value is beyond the range
 * of the precision. Returns true only if all coordinates are finite. */
typedef int (*approx_kernel)(const struct kernel_map *, const double *const in[3],
    double *const out[3], size_t n);

/* Does what approx_kernel does in single precision, on rows of floats; -0 becomes 0. */
typedef int (
    *float_rows_kernel)(const struct kernel_map *, const char *in, char *out, size_t n);

/* The factor of u in the error bound of approx_kernel; approx.h derives the bound. */
#define APPROX_BOUND 10

/* Copies points from rows of floats or doubles to columns of doubles. Returns true if
 * no magnitude is above `max`. A nan is not above it. */
typedef int (*to_columns_kernel)(const char *rows, double (*columns)[POINTS_BLOCK],
    size_t n, double max);

/* Copies columns of doubles to rows of floats or doubles; -0 becomes 0. Returns true
 * only if all numbers of the rows are finite and floats are surely right (midway.h). */
typedef int (*to_rows_kernel)(double (*columns)[POINTS_BLOCK], char *rows, size_t n);

/* A map in doubles, with the matrix m, which finds signs of the columns of an exact map
 * by estimates. Let size be |x| + |y| + |z|, relative to the origin. If low <= size <
 * high, an estimate whose magnitude is above slope * size + floor has the sign of the
 * exact column. One slope and one floor, the largest, serve all
 * columns, to save time. */
struct estimate {
	double origin[3], m[4][4], slope, floor, low, high;
};

enum { SIGNS_UNSURE = 1 << 16 };

/* The bound of the error of an estimate, relative to the sum of the magnitudes of its
 * products. Differences, elements, products and three sums are rounded: 6 u, with u =
 * 2^-53, as `make prove` counts. The roundings of the bound itself add 2 u. */
#define ESTIMATE_BOUND 0x1p-50

/* Returns column j of the image of x, y, z, which are relative to the origin. */
static inline double estimate_column(const double m[4][4], int j, double x, double y,
    double z)
{
	return x * m[0][j] + y * m[1][j] + z * m[2][j] + m[3][j];
}

/* Adds weight * 2^j to word[i] if column j, one of 3 or 4, is negative at point i. Adds
 * SIGNS_UNSURE to word[i] if the sign of any column is not sure at point i. Words are
 * doubles, so that vector operations on doubles can add to them. */
typedef void (*signs_kernel)(const struct estimate *, int columns, double weight,
    const double *const in[3], double *word, size_t n);

/* The kinds of processors that the kernels are compiled for. */
enum processor {
	PROCESSOR_BASELINE,
	PROCESSOR_AVX2,
	PROCESSOR_AVX512,
	PROCESSOR_NEON,
	PROCESSORS,
};

/* Writes the greatest m[j][0] x + m[j][1] y + m[j][2] z of any point to most[j], and
 * the greatest magnitude of each coordinate to largest. Each term of a sum is rounded
 * at most three times. If all coordinates are nan, most is -infinity and largest is 0.
 * The kernel reads n numbers of each column, with n rounded up to a multiple of 16. */
typedef void (*reach_kernel)(const double (*m)[3], int directions,
    const double *const in[3], size_t n, double *most, double largest[3]);

struct kernels {
	enum processor processor;
	/* `doubled` completes images that exact has left nan, and leaves the others */
	exact_kernel exact[KERNELS], doubled[KERNELS];
	approx_kernel approx[3][KERNELS]; /* [precision][kind] */
	float_rows_kernel float_rows[KERNELS];
	signs_kernel signs;
	reach_kernel reach;
	/* [0 for rows of floats, 1 for rows of doubles][numbers per row] */
	to_columns_kernel to_columns[2][5];
	to_rows_kernel to_rows[2][5];
};

extern const struct kernels kernels_baseline, kernels_avx2, kernels_avx512,
    kernels_neon;

/* Chooses the kernels with the given name (baseline, avx2, avx512, neon) or, if name is
 * NULL, the best ones for this processor. Returns false if the name is unknown, or if
 * the processor cannot run the kernels of this name. */
bool kernels_choose(const char *name);

/* Returns the kernels that were chosen, or those of baseline if none were. */
const struct kernels *kernels_chosen(void);
