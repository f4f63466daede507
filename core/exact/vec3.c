/* SPDX-License-Identifier: MIT */
#include "vec3.h"

struct sum vec3_dot(const struct sum a[3], const struct sum b[3])
{
	const struct sum *const x[3] = { &a[0], &a[1], &a[2] };
	const struct sum *const y[3] = { &b[0], &b[1], &b[2] };

	struct sum r;

	sum_dot(3, x, y, &r);
	return r;
}

void vec3_cross(const struct sum a[3], const struct sum b[3], struct sum r[3])
{
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		r[i] = sum_minor(a[j], b[k], a[k], b[j]);
	}
}

/* As far as a is off, its length is at most. So its size is the sum of the
 * elements', and not of their squares. */
struct sum vec3_length(const struct sum a[3])
{
	struct sum r = sum_sqrt(vec3_dot(a, a));

	if (r.error.m == 0)
		return r;
	struct sum off = sum_inexact(r.value, SUM_ERROR);

	for (int i = 0; i < 3; i++)
		off = sum_add(off, (struct sum){ ex_of(0), a[i].error });
	r.error = off.error;
	return r;
}

bool vec3_is_zero(const struct sum a[3])
{
	return sum_sign(a[0]) == 0 && sum_sign(a[1]) == 0 &&
	    sum_sign(a[2]) == 0;
}
