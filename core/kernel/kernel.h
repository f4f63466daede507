/* The inner loops: one body a precision, compiled once for each kind of
 * processor with the same bits from each. */
#ifndef KERNEL_H
#define KERNEL_H

#include <stddef.h>

/* What the matrix's structure makes of the loop. */
enum kernel_kind {
	KERNEL_NONE,       /* none of these: point by point */
	KERNEL_FLAT,       /* two coordinates, no division */
	KERNEL_AFFINE,     /* no division */
	KERNEL_DEPTH,      /* x and y divided by w, depth = a + b / w */
	KERNEL_PROJECTIVE, /* x, y, z divided by w */
	KERNELS,
};

enum precision { PRECISION_EXACT, PRECISION_DOUBLE, PRECISION_SINGLE };

/* A map as the loops take it. Where a sum is below doubt |...| + doubt_image,
 * which is 2^-45 of what it can be at most, the loop gives up a point and
 * answers nan. */
struct kernel_map {
	double origin[3];
	double hi[4][4], lo[4][4];
	int image; /* whether hi[3] counts */
	double a_hi, a_lo, b_hi, b_lo;
	/* A column's products are at most most (|x|+|y|+|z|) + sum_image. */
	double most[4], sum_image[4];
	double doubt[4], doubt_image[4], doubt_depth, doubt_a;
};

/* Columns have room for a whole number of vectors: n rounded up to 16. Returns
 * whether all were done: else the first coordinate of some is nan. */
typedef int (*exact_kernel)(const struct kernel_map *,
    const double *const in[3], double *const out[3], size_t n);

/* With a tolerance above 0 the first coordinate is nan where the error could
 * be larger in any of them. */
typedef void (*plain_kernel)(const struct kernel_map *,
    const double *const in[3], double *const out[3], size_t n,
    double tolerance);

/* The bound of the plain kernels' errors, in units of roundoff; derived and
 * claimed in plain.h. */
#define PLAIN_BOUND 10

struct kernels {
	exact_kernel exact[KERNELS];
	plain_kernel plain[3][KERNELS]; /* by precision */
};

extern const struct kernels kernels_baseline, kernels_avx2, kernels_avx512;

/* The copy for this processor, or the named one (baseline, avx2, avx512);
 * NULL where the processor cannot run it or there is none of that name. */
const struct kernels *kernels_find(const char *name);

#endif
