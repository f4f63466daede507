/* Points through a composed map, block by block. */
#ifndef POINTS_H
#define POINTS_H

#include <stddef.h>

#include "kernel/kernel.h"
#include "scene.h"

/* What is done with a point: (p - origin, 1) m, then x/w, y/w, z/w where it
 * divides. */
struct transform {
	struct map map;
	int in, out; /* coordinates: 2, 3, or 4 for clip and homogeneous ones */
	bool divide;
	/* Only w > 0 has an image, as seen from the eye; else all but 0. */
	bool front;
	/* The fourth number read is 1/w, of a device point. */
	bool reciprocal;
	/* To ndc or the device, where a coordinate near 0 is no worse than one
	 * of a unit: a point on an edge of the view is not ill. */
	bool on_screen;
	int exponent; /* of two, that no element's sum of products reaches */
	enum kernel_kind kind;
	struct kernel_map for_kernel; /* unless the kind is KERNEL_NONE */
};

/* The transform between two spaces; homogeneous keeps x y z w undivided or,
 * from the device, reads 1/w after x y z. Returns NULL, or the member and the
 * reason. */
const char *scene_transform(const struct scene *, enum space from,
    enum space to, bool homogeneous, struct transform *);
const char *flat_transform(const struct scene *, enum flat from, enum flat to,
    struct transform *);

/* The same for a map of one's own that leads from one to another. */
struct transform transform_of(const struct map *, enum space from,
    enum space to, bool homogeneous);

/* Chooses the kernels: the best for this processor, or those named. False
 * where it cannot run them. */
bool points_choose(const char *name);

enum { POINTS_BLOCK = 1024 };

/* A coordinate is wrong by at most 1/2 + POINTS_BOUND kappa units in its last
 * place. Numerator and denominator are within MAP_BOUND u^2 of their products'
 * sizes before, 18 u^2 in the kernels' sums (13 u^2 in point_exact's), and the
 * quotient within 12 (9.8): with errors multiplied by their own kappas, 2 (7.2
 * + 18) + 12 < 63 u^2 kappa, which is less than kappa 2^-47 places. Depth as a
 * + b/w is within 23 + 7.2 + 25.2 u^2 of |a| + |b/w|. */
#define POINTS_BOUND 0x1p-47

/* Past this kappa a point is ill: cancellation may have cost more than 1/128
 * of a last place. */
#define POINTS_ILL 0x1p40

/* What points are computed in. With a tolerance above 0, for each point from
 * that point alone, the cheapest precision whose proven bound is at most that
 * in every coordinate. */
struct accuracy {
	enum precision precision;
	double tolerance;
};

/* Images of n <= POINTS_BLOCK points, a column of POINTS_BLOCK each for x, y,
 * z, w. What has no image, or one beyond the range of doubles, is nan.
 * single[i] says that the numbers of point i are floats. */
void points_carry(const struct transform *, const struct accuracy *,
    const double *const in[4], double *const out[4], bool *single, size_t n);

/* The first n columns of a map of three coordinates in plain double, for what
 * only asks for signs and sizes: each within a 32nd of its value, and of no
 * more products than size. False where that can't be had of them all. */
bool point_estimate(const struct transform *, const double in[3], int n,
    double value[4], double size[4]);

/* Whether its kappa is past POINTS_ILL. */
bool point_is_ill(const struct transform *, const double in[4]);

/* A coordinate before the division, and the sum of its products' sizes. */
struct sum {
	dd value;
	double size;
};

/* Column j of the image of p, relative to the origin, w: four products and sums
 * in double-double, 13 u^2 of size; 0 where no larger than its error bound. */
struct sum map_column(const struct map *, int j, const dd p[4]);

/* One point with care, where the kernels give up: what cancels to nothing, lies
 * in the eye plane, or overflows on the way. Also tells the worst kappa of its
 * coordinates, on the screen those of less than a unit counted as a unit. */
void point_exact(const struct transform *, const double in[4], double out[4],
    double *kappa);

/* Coordinate j of its image, which points_carry gave as a double, as a float:
 * rounded once. */
float point_single(const struct transform *, const double in[4], int j,
    double image);

#endif
