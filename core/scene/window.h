/* SPDX-License-Identifier: MIT */
/* The flat end of the pipeline: the 2D window, the device and the 3D viewport.
 * 2D maps leave z alone. */
#ifndef WINDOW_H
#define WINDOW_H

#include "convention.h"
#include "../exact/map.h"

struct window {
	double center[2], width, height;
	unsigned by_edges; /* 1: by its edges, 0: by its centre */
	double left, right, bottom, top;
	double pan[2];
	double zoom; /* 2 shows half the extent; 1 where not given */
	bool has_about;
	double about[2]; /* the point that zoom leaves where it is */
	enum { ADAPT_STRETCH, ADAPT_GROW, ADAPT_SHRINK } adapt;
};

struct device {
	double x, y, width, height;
	bool top_left;
};

struct viewport {
	double x, y, width, height, min_z, max_z;
	enum { SCALE_FILL, SCALE_UNIFORM, SCALE_GIVEN } scale;
	double scales[2];
};

/* Window to NDC after pan, zoom and adapt; device may be NULL where
 * adapt is ADAPT_STRETCH. */
const char *window_map(const struct window *, const struct device *,
    bool inverse, struct map *);

/* NDC to device. */
const char *device_map(const struct device *, bool inverse, struct map *);

/* NDC to device in space, from the convention's depth range and origin. */
const char *viewport_map(const struct viewport *, const struct convention *,
    bool inverse, struct map *);

/* A point is on the viewport where |x| scale and |y| scale are at most half its sides;
 * on ndc's square, where there is none (NULL), at most 1. */
void viewport_limits(const struct viewport *, struct sum half[2],
    struct sum scale[2]);

#endif
