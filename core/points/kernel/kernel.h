/* SPDX-License-Identifier: MIT */
/* The inner loops. Each precision has one body, which is compiled once for each kind of
 * processor. All copies give the same bits. */
#ifndef KERNEL_H
#define KERNEL_H

#include <stdbool.h>
#include <stddef.h>

enum { POINTS_BLOCK = 1024 };

/* The best alignment of columns: vectors that cross two lines of the cache cost a fifth
 * of all time in double. */
#define COLUMN_ALIGNED _Alignas(64)

/* The kinds of loops, by the structure of the matrix. */
enum kernel_kind {
	KERNEL_NONE,   /* no loop: point.c computes each point */
	KERNEL_FLAT,   /* two coordinates, no division */
	KERNEL_AFFINE, /* no division */
	KERNEL_FOUR,   /* x, y, z and w, undivided; only in PRECISION_EXACT */
	KERNEL_PROJECTIVE, /* x, y, z divided by w */
	KERNEL_DEPTH, /* the same; z is a + b / w, but not in PRECISION_EXACT */
	KERNEL_DIRECTION, /* two coordinates to three, divided by their length */
	KERNELS,
};

/* Return how many coordinates a point has, how many its image has, and whether the
 * coordinates of the image are divided by w. */
static inline int kernel_inputs(enum kernel_kind kind)
{
	return kind == KERNEL_FLAT || kind == KERNEL_DIRECTION ? 2 : 3;
}

static inline int kernel_outputs(enum kernel_kind kind)
{
	return kind == KERNEL_FLAT ? 2 : kind == KERNEL_FOUR ? 4 : 3;
}

static inline bool kernel_divides(enum kernel_kind kind)
{
	return kind == KERNEL_DEPTH || kind == KERNEL_PROJECTIVE;
}

enum precision { PRECISION_EXACT, PRECISION_DOUBLE, PRECISION_SINGLE };

/* A map for the loops: the image of p is (p - origin, 1) (hi + lo). Each hi + lo is
 * within u^2 / 2 of the exact element, relative to it; u = 2^-53. */
struct kernel_map {
	double origin[3];
	double hi[4][4], lo[4][4];
	bool exact[4][4]; /* the element is exactly hi */
	double a, b;      /* of KERNEL_DEPTH */
	/* slope[j] (|x|+|y|+|z|) + offset[j] bounds the magnitudes of column j's
	 * products, for x, y, z relative to the origin. */
	double slope[4], offset[4];
	/* noise[j] (2^e + 1) is the error that the elements of the matrix (struct sum)
	 * cause in column j if |p - origin| < 2^e. Values of the column that differ by
	 * this noise or less count as equal. */
	double noise[4];
	/* A lower bound of the noise of column j at any point. */
	double least_noise[4];
};

/* Writes the doubles nearest to the exact images of n points. The first coordinate
 * becomes nan if the loop cannot round a coordinate with certainty, and infinite if w
 * is surely not positive, so that there is no image. Returns true if neither happened.
 * Columns have room for n rounded up to a multiple of 16. */
typedef int (*exact_kernel)(const struct kernel_map *,
    const double *const in[3], double *const out[], size_t n);

/* Writes images computed in double or single. A coordinate becomes nan or infinite if
 * its point has no image, or if an intermediate value is beyond the range. Returns true
 * only if this did not happen. */
typedef int (*approx_kernel)(const struct kernel_map *,
    const double *const in[3], double *const out[3], size_t n);

/* Does what approx_kernel does in single, from rows of floats to rows of floats; -0
 * becomes 0. */
typedef int (*float_rows_kernel)(const struct kernel_map *, const char *in,
    char *out, size_t n);

/* The bound of the errors of approx_kernel, in units of roundoff; approx.h derives it. */
#define APPROX_BOUND 10

/* Copies points from rows of floats or doubles to columns of doubles. Returns true if
 * no magnitude is above most. A nan is not above most. */
typedef int (*to_columns_kernel)(const char *rows,
    double (*columns)[POINTS_BLOCK], size_t n, double most);

/* Copies columns to rows; -0 becomes 0. Returns true if all numbers are finite and, if
 * they were rounded to floats, none is_midway. */
typedef int (
    *to_rows_kernel)(double (*columns)[POINTS_BLOCK], char *rows, size_t n);

/* A map in doubles that estimates the signs of its columns. Let size be |x| + |y| +
 * |z|, relative to the origin. If low <= size < high, an estimate whose magnitude is
 * above slope size + floor has the exact sign. All columns share the largest bound:
 * this takes less time, but leaves the signs of a few more points unsure. */
struct estimate {
	double origin[3], m[4][4], slope, floor, low, high;
};

enum { SIGNS_UNSURE = 1 << 16 };

/* The error of an estimate, relative to the sum of its products' magnitudes.
 * Differences, elements, products and three sums are rounded: 6 u, as `make prove`
 * counts. The roundings of the bound itself add 2 u. */
#define ESTIMATE_BOUND 0x1p-50

/* Returns column j of the image of x, y, z, which are relative to the origin. */
static inline double estimate_column(const double m[4][4], int j, double x,
    double y, double z)
{
	return x * m[0][j] + y * m[1][j] + z * m[2][j] + m[3][j];
}

/* Adds weight 2^j to word[i] for each point i and each column j, one of 3 or 4, that is
 * negative. Adds SIGNS_UNSURE if the sign of any column is not sure. A word is a
 * double, so that a loop of vectors of doubles adds the bits. */
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

/* Writes the greatest m[j][0] x + m[j][1] y + m[j][2] z to most[j], and the greatest
 * magnitude of each coordinate to largest. In a value of most each term is rounded at
 * most three times. If all coordinates are nan, the results are -infinity and 0. The
 * loop reads n numbers of a column, rounded up to a multiple of 16. */
typedef void (*farthest_kernel)(const double (*m)[3], int directions,
    const double *const in[3], size_t n, double *most, double largest[3]);

struct kernels {
	enum processor processor;
	exact_kernel exact[KERNELS];
	approx_kernel approx[3][KERNELS]; /* by precision */
	float_rows_kernel float_rows[KERNELS];
	signs_kernel signs;
	farthest_kernel farthest;
	/* [0: rows of floats, 1: of doubles][numbers per row] */
	to_columns_kernel to_columns[2][5];
	to_rows_kernel to_rows[2][5];
};

extern const struct kernels kernels_baseline, kernels_avx2, kernels_avx512,
    kernels_neon;

/* Chooses the kernels of this name (baseline, avx2, avx512, neon) or, if name is NULL,
 * the best ones for this processor. Returns false if no kernels have the name, or if
 * the processor cannot run them. */
bool kernels_choose(const char *name);

/* Returns the kernels chosen, at first those of baseline. */
const struct kernels *kernels_chosen(void);

#endif
