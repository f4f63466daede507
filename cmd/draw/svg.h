/* SPDX-License-Identifier: MIT */
/* Prints pictures as an SVG. */
#pragma once

#include "../../core/refusal/refusal.h"
#include "picture.h"

/* Where a picture stands: a rectangle of the device. */
struct frame {
	double x, y, width, height;
	bool from_bottom; /* y of the device points up */
};

/* Returns the greater side, which is 1 in a picture. */
static inline double frame_size(const struct frame *f)
{
	return f->width > f->height ? f->width : f->height;
}

/* Adds a picture, from which hidden lines are removed. */
void svg_add(const struct picture *, const struct frame *);

/* Sets what stands behind the pictures that are added next: the contents of a PNG or
 * JPEG file. Returns false if they are another file's. */
bool svg_set_background(struct span, struct refusal *);

/* Prints all pictures that were added as one SVG, and forgets them. */
void svg_print(void);
