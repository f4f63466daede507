/* SPDX-License-Identifier: MIT */
/* What the conventions of graphics systems differ in. */
#ifndef CONVENTION_H
#define CONVENTION_H

#include <stdbool.h>

/* All false is d3d. */
struct convention {
	bool right_handed;
	bool minus_one; /* ndc depth runs from -1, not 0, to 1 */
	bool column;    /* matrices print transposed: p' = M p */
	bool ndc_y_down;
	bool bottom_left; /* device origin */
	/* The axes of view are turned half around x: y is down, z the other
	 * way. */
	bool view_y_down;
};

/* Whether the camera looks along -z. */
static inline bool looks_back(const struct convention *c)
{
	return c->right_handed != c->view_y_down;
}

#endif
