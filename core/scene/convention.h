/* SPDX-License-Identifier: MIT */
/* The differences between the conventions of graphics systems. */
#ifndef CONVENTION_H
#define CONVENTION_H

#include <stdbool.h>

/* The convention d3d has all members false. */
struct convention {
	bool right_handed;
	bool minus_one; /* ndc depth is from -1, not 0, to 1 */
	bool column;    /* matrices are printed transposed: p' = M p */
	bool ndc_y_down;
	bool bottom_left; /* the device's origin */
	bool view_y_down; /* y and z of view space are negated */
};

/* Returns whether the camera looks along -z. */
static inline bool looks_back(const struct convention *c)
{
	return c->right_handed != c->view_y_down;
}

#endif
