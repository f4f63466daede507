/* SPDX-License-Identifier: MIT */
#include "convention.h"

void convention_change(const struct convention *from, const struct convention *to,
    bool clip, bool input, struct map *r)
{
	bool flips_y = clip ? from->ndc_y_down != to->ndc_y_down :
			      from->view_y_down != to->view_y_down;
	bool flips_z = !clip &&
	    convention_looks_back(from) != convention_looks_back(to);
	bool depth = clip && from->depth_minus_one != to->depth_minus_one;
	double t = to->depth_minus_one != input ? -1 : 0.5, scale = t < 0 ? 2 : 0.5;

	for (int i = 0; i < (input ? 4 : 5); i++) {
		struct sum *y = input ? &r->m[1][i] : &r->m[i][1];
		struct sum *z = input ? &r->m[2][i] : &r->m[i][2];
		struct sum *w = input ? &r->m[3][i] : &r->m[i][3];

		y->value.sign *= flips_y ? -1 : 1;
		z->value.sign *= flips_z ? -1 : 1;
		if (depth && input)
			*w = sum_add(*w, sum_scale(*z, t));
		if (depth)
			*z = sum_scale(*z, scale);
		if (depth && !input)
			*z = sum_add(*z, sum_scale(*w, t));
	}
	if (input && depth)
		map_set_origin(r, NULL);
	else if (input) {
		r->origin[1] = flips_y ? 0 - r->origin[1] : r->origin[1];
		r->origin[2] = flips_z ? 0 - r->origin[2] : r->origin[2];
	}
}
