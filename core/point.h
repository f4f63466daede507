/* One point through a transform. */
#ifndef POINT_H
#define POINT_H

#include "transform.h"

/* A coordinate is wrong by at most 1/2 + POINTS_BOUND kappa units in its last
 * place. A numerator N and a denominator W are sums of products; before them
 * stand the map's elements, within MAP_BOUND u^2 = 7.2 u^2 of their own sizes.
 * The kernels add 18 u^2 of the sums' sizes (map_column 13 u^2), the quotient
 * 12 u^2 of itself (dd_div 9). Relative to N/W the first two count kappa(N)
 * and kappa(W) times, so that all errors are below
 *
 *	2 (7.2 + 18) kappa + 12 < 63 u^2 kappa,  kappa = kappa(N) kappa(W),
 *
 * and u^2 kappa is less than kappa 2^-53 units in the last place. Depth as
 * a + b/w is within 23 + 7.2 + 25.2 u^2 of |a| + |b/w|. */
#define POINTS_BOUND 0x1p-47

/* Past this kappa a point is ill: cancellation may have cost more than 1/128
 * of a last place. */
#define POINTS_ILL 0x1p40

/* One point with care, where the kernels give up: what cancels to nothing, lies
 * in the eye plane, or overflows on the way. Also tells the worst kappa of its
 * coordinates, on the screen those of less than a unit counted as a unit. */
void point_exact(const struct transform *, const double in[4], double out[4],
    double *kappa);

/* The first n columns of a map of three coordinates in plain double, for what
 * only asks for signs and sizes: value is within a 32nd of itself, and size is
 * at least its products' sum. False where that can't be said of all. */
bool point_estimate(const struct transform *, const double in[3], int n,
    double value[4], double size[4]);

/* Whether its kappa is past POINTS_ILL. */
bool point_is_ill(const struct transform *, const double in[4]);

/* Coordinate j of the point's image, which points_carry gave as a double, as a
 * float: rounded once. */
float point_single(const struct transform *, const double in[4], int j,
    double image);

#endif
