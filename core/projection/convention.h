/* SPDX-License-Identifier: MIT */
/* The conventions of graphics systems, in which scenes and answers are meant. */
#pragma once

#include <stdbool.h>

#include "../exact/map.h"

/* The convention d3d, that of Direct3D, has all members false. */
struct convention {
	bool right_handed;
	bool depth_minus_one; /* ndc depth is from -1, not 0, to 1 */
	bool column_vectors;  /* matrices are printed for column vectors */
	bool ndc_y_down;
	bool origin_bottom_left; /* the device's origin; false: top left */
	bool view_y_down;        /* view space: y points down, z is negated */
};

/* Returns whether the camera looks along -z of view space, not +z. */
static inline bool convention_looks_back(const struct convention *c)
{
	return c->right_handed != c->view_y_down;
}

/* Changes the convention of a map's images or, if `input`, of the points that it maps,
 * in view space or, if `clip`, in clip space. Negates an axis (y, or z of view space)
 * if its direction differs. If the depth range differs, a depth z from 0 to w becomes
 * 2 z - w, and a depth z from -w to w becomes (z + w) / 2. */
void convention_change(const struct convention *from, const struct convention *to,
    bool clip, bool input, struct map *);
