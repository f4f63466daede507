/* SPDX-License-Identifier: MIT */
#include "fit.h"

#include <math.h>
#include <string.h>

#include "../points/transform.h"

void directions_add(struct directions *all, const struct map *map, int j,
    bool minus)
{
	struct direction *d = &all->item[all->n];
	struct sum largest = sum_of_double(0);

	for (int i = 0; i < 3; i++) {
		d->m[i] = sum_snap_zero(sum_negated_if(minus, map->m[i][j]));
		if (sum_sign(sum_sub(sum_abs(d->m[i]), largest)) > 0)
			largest = sum_abs(d->m[i]);
	}
	for (int i = 0; i < 3; i++) {
		int sign = sum_sign(d->m[i]);
		double scaled = 0;

		if (sign != 0)
			scaled = sum_ratio(d->m[i], largest);
		if (sign != 0 && scaled == 0)
			scaled = sign * 0x1p-1074;
		d->hi[i] = all->hi[all->n][i] = scaled;
	}
	all->n++;
}

/* Returns an upper bound of the error of distance_along at points whose coordinates are
 * at most largest in magnitude. The element, the product and two sums are rounded, each
 * by at most u = 2^-53: 4 u times the sum of the products' magnitudes. 8 u also cover
 * the sums in which add_point compares values and bounds; 2^-1000 covers underflow. */
static double bound_of(const double m[3], const double largest[3])
{
	double sum = 0x1p-1000;

	for (int i = 0; i < 3; i++)
		sum += (fabs(m[i]) + 0x1p-1000) * largest[i];
	return 0x1p-50 * sum;
}

/* Returns whether p is farther than q. Of two points that are equally far, the one with
 * the greater coordinates counts as farther: the order of points does not matter. */
static bool is_farther(const struct direction *d, const double p[3],
    const double q[3])
{
	struct sum step[3];
	bool same = true;
	int order = 0;

	for (int i = 0; i < 3; i++)
		same &= d->hi[i] == 0 || p[i] == q[i];
	for (int i = 0; i < 3 && !same; i++)
		step[i] = sum_diff(p[i], q[i]);
	if (!same)
		order = sum_sign(vec3_dot(d->m, step));
	for (int i = 0; i < 3 && order == 0; i++)
		order = (p[i] > q[i]) - (p[i] < q[i]);
	return order > 0;
}

/* Returns the distance of p along the direction, rounded: bound_of bounds its error. */
static double distance_along(const struct direction *d, const double p[3])
{
	return p[0] * d->hi[0] + p[1] * d->hi[1] + p[2] * d->hi[2];
}

/* Makes p the farthest point if it is farther. If the bounds of the values overlap, the
 * exact comparison decides. */
static void add_point(struct farthest *f, const struct direction *d,
    const double p[3], double bound)
{
	double value = distance_along(d, p);

	if (!f->any || value - bound > f->value + f->bound ||
	    (value + bound >= f->value - f->bound &&
		is_farther(d, p, f->point)))
		*f = (struct farthest){ true, { p[0], p[1], p[2] }, value,
			bound };
}

/* How many points a call of the kernel takes. With fewer there are more calls. With
 * more, more blocks hold a farthest point, and are compared point by point. */
enum { FIT_BLOCK = 128 };

/* Adds at most FIT_BLOCK points. Only points whose value may be the largest,
 * within the error, are compared one by one. */
static void add_block(struct extremes *e, const struct directions *all,
    const double *const in[3], size_t n)
{
	double most[BOUNDS_POINTS], largest[3];

	kernels_chosen()->farthest(all->hi, all->n, in, n, most, largest);
	for (int j = 0; j < all->n; j++) {
		const struct direction *d = &all->item[j];
		struct farthest *f = &e->item[j];
		double bound = bound_of(d->hi, largest);
		double least = most[j] - 2 * bound;

		if (f->any && most[j] + bound < f->value - f->bound)
			continue;
		for (size_t i = 0; i < n; i++) {
			const double p[3] = { in[0][i], in[1][i], in[2][i] };

			/* the comparison is false for nan */
			if (distance_along(d, p) >= least)
				add_point(f, d, p, bound);
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
		if (other->item[j].any)
			add_point(&e->item[j], &all->item[j],
			    other->item[j].point, other->item[j].bound);
}

bool extremes_bounds(const struct extremes *e, const struct directions *all,
    struct bounds *b)
{
	*b = (struct bounds){ .n = all->n };
	for (int j = 0; j < all->n; j++)
		memcpy(b->point[j], e->item[j].point, sizeof b->point[j]);
	return all->n > 0 && e->item[0].any;
}
