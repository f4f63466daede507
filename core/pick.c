#include "pick.h"

#include <math.h>

/* On the axis view z = N(z)/D(z) of ndc z; the gaze goes where that moves as z
 * leaves the near plane: N' D - N D', times -1 where depth is reversed. */
const char *depth_transform(const struct scene *s, struct transform *t)
{
	struct map view, back;
	bool reverse = s->projection.reverse_z;
	double z = reverse ? 1 : s->convention.minus_one ? -1 : 0;
	const char *why = scene_map(s, SPACE_NDC, SPACE_VIEW, &back);

	if (why == NULL)
		why = scene_map(s, SPACE_MODEL, SPACE_VIEW, &view);
	/* no test reaches this: pick has composed the same before */
	if (why != NULL)
		return why;
	dd(*m)[4] = back.m;
	ex n = ex_add(ex_scale(ex_dd(m[2][2]), z), ex_dd(m[AT_ZERO][2]));
	ex d = ex_add(ex_scale(ex_dd(m[2][3]), z), ex_dd(m[AT_ZERO][3]));
	ex slope = ex_sub(ex_mul(ex_dd(m[2][2]), d), ex_mul(n, ex_dd(m[2][3])));
	double sign = (ex_round(slope).hi > 0) == !reverse ? 1 : -1;
	dd near = ex_div(n, d);

	for (int i = 0; i < 5; i++)
		view.m[i][2] = dd_scale(view.m[i][2], sign);
	view.m[AT_ORIGIN][2] = dd_add(view.m[AT_ORIGIN][2],
	    dd_scale(near, -sign));
	view.sum[AT_ORIGIN][2] += fabs(near.hi);
	*t = transform_of(&view, SPACE_MODEL, SPACE_VIEW, false);
	return NULL;
}

double depth_of(const struct transform *t, const double in[4])
{
	double out[4], kappa;

	point_exact(t, in, out, &kappa);
	return out[2];
}

bool is_within(const double device[2], const double at[2], double radius)
{
	dd r = two_prod(radius, radius), d2 = { 0, 0 };

	for (int i = 0; i < 2; i++) {
		dd d = two_sum(device[i], -at[i]);

		d2 = dd_add(d2, dd_mul(d, d));
	}
	return dd_add(d2, dd_neg(r)).hi <= 0;
}
