/* SPDX-License-Identifier: MIT */
#include "convention.h"

/* Negates coordinate k of the images or, if `input`, of the points. Row 4 of a map is
 * the image of its origin: it is an image, too, and for points the origin changes. */
static void negate_axis(struct map *r, int k, bool input)
{
	for (int i = 0; i < (input ? 4 : 5); i++)
		(input ? &r->m[k][i] : &r->m[i][k])->value.sign *= -1;
	if (input)
		r->origin[k] = 0 - r->origin[k]; /* which is never -0 */
}

/* Changes the range of depths to -w..w if `to_minus_one`, else to 0..w. */
static void rescale_depth(struct map *r, bool to_minus_one, bool input)
{
	/* z becomes 2 z - w or (z + w) / 2; of points the inverse replaces z */
	const double t = to_minus_one != input ? -1 : 0.5, scale = t < 0 ? 2 : 0.5;

	for (int i = 0; i < (input ? 4 : 5); i++) {
		struct sum *z = input ? &r->m[2][i] : &r->m[i][2];
		struct sum *w = input ? &r->m[3][i] : &r->m[i][3];

		if (input)
			*w = sum_add(*w, sum_scale(*z, t));
		*z = sum_scale(*z, scale);
		if (!input)
			*z = sum_add(*z, sum_scale(*w, t));
	}
	if (input)
		map_set_origin(r, NULL);
}

void convention_change(const struct convention *from, const struct convention *to,
    bool clip, bool input, struct map *r)
{
	const bool flips_y = clip ? from->ndc_y_down != to->ndc_y_down :
				    from->view_y_down != to->view_y_down;

	if (flips_y)
		negate_axis(r, 1, input);
	if (!clip && convention_looks_back(from) != convention_looks_back(to))
		negate_axis(r, 2, input);
	if (clip && from->depth_minus_one != to->depth_minus_one)
		rescale_depth(r, to->depth_minus_one, input);
}
