/* SPDX-License-Identifier: MIT */
#include "fit_points.h"

#include <string.h>

#include "../points/transform.h"

void directions_add(struct directions *all, const struct map *m, int j, bool minus)
{
	struct sum *exact = all->exact[all->n], largest = sum_of_double(0);

	for (int i = 0; i < 3; i++) {
		exact[i] = sum_snap_zero(sum_negated_if(minus, m->m[i][j]));
		if (sum_compare(sum_abs(exact[i]), largest) > 0)
			largest = sum_abs(exact[i]);
	}
	for (int i = 0; i < 3; i++) {
		double scaled = sum_ratio(exact[i], largest);

		if (scaled == 0)
			scaled = sum_sign(exact[i]) * 0x1p-1074;
		all->scaled[all->n][i] = scaled;
	}
	all->n++;
}

/* Returns an upper bound of the error of distance_along, if no |p[i]| is above
 * largest[i]. Each term is rounded by u = 2^-53 four times: the element of m, the
 * product, and two sums, together 4 u times the sum of the terms' magnitudes. The bound
 * of 8 u also covers the sums in consider and add_block; 2^-1000 covers underflow. */
static double distance_error(const double m[3], const double largest[3])
{
	double sum = 0x1p-1000;

	for (int i = 0; i < 3; i++)
		sum += (fabs(m[i]) + 0x1p-1000) * largest[i];
	return 0x1p-50 * sum;
}

/* Returns whether p is farther than q in direction j. Of equally far points, that with
 * the greater first differing coordinate is farther: their order does not matter. */
static bool is_farther(const struct directions *all, int j, const double p[3],
    const double q[3])
{
	struct sum step[3];
	bool same = true;
	int order = 0;

	for (int i = 0; i < 3; i++)
		same &= all->scaled[j][i] == 0 || p[i] == q[i];
	for (int i = 0; i < 3 && !same; i++)
		step[i] = sum_difference(p[i], q[i]);
	if (!same)
		order = sum_sign(vec3_dot(all->exact[j], step));
	for (int i = 0; i < 3 && order == 0; i++)
		order = (p[i] > q[i]) - (p[i] < q[i]);
	return order > 0;
}

static double distance_along(const double m[3], const double p[3])
{
	return p[0] * m[0] + p[1] * m[1] + p[2] * m[2];
}

/* Makes p the farthest point in direction j if p is farther. If the distances differ by
 * at most the sum of their error bounds, is_farther decides. `bound` is that of p. */
static void consider(struct extremes *e, const struct directions *all, int j,
    const double p[3], double bound)
{
	struct farthest_point *f = &e->item[j];
	double value = distance_along(all->scaled[j], p);

	if (!f->known || value - bound > f->distance + f->error ||
	    (value + bound >= f->distance - f->error &&
		is_farther(all, j, p, f->point)))
		*f = (struct farthest_point){ true, { p[0], p[1], p[2] }, value,
			bound };
}

/* The number of points per call of the kernel. Of larger blocks more points are
 * examined, as all points of a block are if one may be the farthest. */
enum { FIT_BLOCK = 128 };

/* Considers only points whose distance, within its error, may be the largest. */
static void add_block(struct extremes *e, const struct directions *all,
    const double *const in[3], size_t n)
{
	double most[BOUNDS_POINTS], largest[3];

	kernels_chosen()->reach(all->scaled, all->n, in, n, most, largest);
	for (int j = 0; j < all->n; j++) {
		const struct farthest_point *f = &e->item[j];
		double bound = distance_error(all->scaled[j], largest);
		double least = most[j] - 2 * bound;

		if (f->known && most[j] + bound < f->distance - f->error)
			continue;
		for (size_t i = 0; i < n; i++) {
			const double p[3] = { in[0][i], in[1][i], in[2][i] };

			/* the comparison is false for nan */
			if (distance_along(all->scaled[j], p) >= least)
				consider(e, all, j, p, bound);
		}
	}
}

void extremes_add(struct extremes *e, const struct directions *all,
    const double *const in[3], size_t n)
{
	for (size_t i = 0; i < n; i += FIT_BLOCK) {
		const double *const at[3] = { in[0] + i, in[1] + i, in[2] + i };

		add_block(e, all, at, n - i < FIT_BLOCK ? n - i : FIT_BLOCK);
	}
}

void extremes_merge(struct extremes *e, const struct directions *all,
    const struct extremes *other)
{
	for (int j = 0; j < all->n; j++)
		if (other->item[j].known)
			consider(e, all, j, other->item[j].point, other->item[j].error);
}

bool extremes_bounds(const struct extremes *e, const struct directions *all,
    struct bounds *b)
{
	*b = (struct bounds){ .n = all->n };
	for (int j = 0; j < all->n; j++)
		memcpy(b->point[j], e->item[j].point, sizeof b->point[j]);
	return all->n > 0 && e->item[0].known;
}
