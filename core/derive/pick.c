/* SPDX-License-Identifier: MIT */
#include "pick.h"

#include "../points/point.h"
#include "frustum.h"

/* The distance of a point from a plane is the plane's function at the point over the
 * length of the function's gradient in view space. Without near and far planes the
 * distance is measured from the plane w = 0. */
bool picker_of(const struct scene *s, const struct transform *to_device,
    struct picker *k, struct refusals *faults)
{
	int plane = projection_is_open(&s->projection) ? 2 : 0;
	struct map *m = &k->depth.map, sides;
	struct sum gradient[3], divisor;

	if (!frustum_refuse_singular(s, faults) ||
	    !frustum_planes(s, SPACE_VIEW, &sides, m, faults))
		return false;
	for (int i = 0; i < 3; i++)
		gradient[i] = m->m[i][plane];
	divisor = m->divisor;
	if (!frustum_planes(s, SPACE_MODEL, &sides, m, faults))
		return false;
	k->to_device = to_device;
	for (int i = 0; i < 5; i++)
		m->m[i][2] = sum_mul(m->m[i][plane], divisor);
	map_divide_column(m, 2, vec3_length(gradient));
	/* the map is affine: w is 1 */
	for (int i = 0; i < 5; i++)
		m->m[i][3] = i < 3 ? sum_of_double(0) : m->divisor;
	transform_init(&k->depth, SPACE_MODEL, SPACE_VIEW, false);
	return !ex_has_overflowed() || scene_refuse_too_wide(s, false, faults);
}

static struct sum square(struct sum a)
{
	return sum_mul(a, a);
}

/* The exact image N / w is within the radius r of the position p if (N - p w)^2 is at
 * most (r w)^2. d2 is the squared distance from p to `device`, the image rounded to
 * doubles. If r is above 2^-40 of the coordinates of p, the errors of device, 2^-53 of
 * its coordinates, are below 2^-12 r near the circle. They change d2 by less than 2^-9
 * r^2, so a d2 that differs from r^2 by more than 2^-8 r^2 decides. */
bool pick_is_within(const struct picker *k, const double in[4], const double device[2])
{
	const struct transform *t = k->to_device;
	double x = device[0] - k->at[0], y = device[1] - k->at[1];
	double d2 = x * x + y * y, r2 = k->radius * k->radius;
	double large = fmax(fabs(k->at[0]), fabs(k->at[1]));

	if (k->radius > 0x1p-40 * large && r2 > 0x1p-900 && r2 < 0x1p900 &&
	    fabs(d2 - r2) > 0x1p-8 * r2)
		return d2 < r2;
	struct sum w = point_column(t, 3, in);
	struct sum d = sum_neg(square(sum_scale(w, k->radius)));

	for (int j = 0; j < 2; j++) {
		struct sum at = sum_scale(w, k->at[j]);

		d = sum_add(d, square(sum_sub(point_column(t, j, in), at)));
	}
	return sum_sign(d) <= 0;
}

double pick_distance(const struct picker *k, const double in[4])
{
	return sum_ratio(point_column(&k->depth, 2, in), k->depth.map.divisor);
}

int pick_compare(const struct picker *k, const double p[4], const double q[4])
{
	return sum_compare(point_column(&k->depth, 2, p),
	    point_column(&k->depth, 2, q));
}
