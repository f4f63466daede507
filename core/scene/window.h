/* SPDX-License-Identifier: MIT */
/* The maps of the 2D window, 2D device and 3D viewport. 2D maps do not change z. */
#pragma once

#include "../projection/convention.h"
#include "../refusal/refusal.h"

struct window {
	double center[2], width, height;
	unsigned by_edges; /* 0: center, width and height; 1: edges */
	double left, right, bottom, top;
	double pan[2];   /* added to the centre */
	double zoom;     /* 2 shows half the extent; the default is 1 */
	bool has_about;  /* false: the zoom is about the centre */
	double about[2]; /* the point that the zoom does not move */
	/* for the device's shape: GROW the side that is too short, SHRINK the other */
	enum { ADAPT_STRETCH, ADAPT_GROW, ADAPT_SHRINK } adapt;
};

struct device {
	double x, y, width, height;
	bool top_left; /* the origin is at top left; false: bottom left */
};

struct viewport {
	double x, y, width, height, min_z, max_z;
	enum { SCALE_FILL, SCALE_UNIFORM, SCALE_GIVEN } scale;
	double scales[2]; /* of SCALE_GIVEN: pixels per unit of ndc x and y */
	bool distance; /* z that project and trace print is a distance, not a depth */
};

/* Computes the map from window to ndc, with pan, zoom and adapt, or its inverse. The
 * device may be NULL with ADAPT_STRETCH. */
bool window_map(const struct window *, const struct device *, bool inverse,
    struct map *, struct refusals *faults);

/* Compute the map from ndc to a 2D device or a 3D viewport or, if inverse, back. The
 * convention has ndc's depth and y, and the device's origin. */
bool device_map(const struct device *, bool inverse, struct map *,
    struct refusals *faults);
bool viewport_map(const struct viewport *, const struct convention *, bool inverse,
    struct map *, struct refusals *faults);

/* Writes half the width and height, and the pixels per unit of ndc x and y. Points of
 * ndc with |x| scale[0] <= half[0] and |y| scale[1] <= half[1] are in the viewport. */
void viewport_limits(const struct viewport *, double half[2], double scale[2]);
