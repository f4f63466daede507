/* SPDX-License-Identifier: MIT */
/* The maps of the 2D window, 2D device and 3D viewport. 2D maps do not change z. */
#pragma once

#include "../projection/convention.h"
#include "../refusal/refusal.h"

struct window {
	double center[2], width, height;
	unsigned by_edges; /* 0: center, width and height; 1: edges */
	double left, right, bottom, top;
	bool has_edge[4]; /* of the document: left, right, bottom, top */
	bool y_down;      /* without edges: y of the world points down in the picture */
	double pan[2];    /* added to the centre */
	double zoom;      /* 2 shows half the extent; the default is 1 */
	bool has_about;   /* false: the zoom is about the centre */
	double about[2];  /* the point that the zoom does not move */
	/* for the device's shape: GROW the side that is too short, SHRINK the other */
	enum { ADAPT_STRETCH, ADAPT_GROW, ADAPT_SHRINK } adapt;
};

struct device {
	double x, y, width, height;
	bool top_left; /* the origin is at top left; false: bottom left */
};

struct viewport {
	double x, y, width, height, min_z, max_z;
	/* The viewport shows the part of a picture of size `full`, else its own size,
	 * that begins at `offset`, in device units from the corner of the origin. */
	bool has_full, has_offset;
	double full[2], offset[2];
	enum { SCALE_FILL, SCALE_UNIFORM, SCALE_GIVEN } scale;
	double scales[2]; /* of SCALE_GIVEN: pixels per unit of ndc x and y */
	bool distance; /* z that project and trace print is a distance, not a depth */
};

/* Returns whether y of the world points down in the picture. Of edges, fit may have
 * none or one. */
static inline bool window_has_y_down(const struct window *w)
{
	return w->by_edges ? w->has_edge[2] && w->has_edge[3] && w->top < w->bottom :
			     w->y_down;
}

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

/* Refuse what the maps would refuse. Numbers that were refused are NaN. */
bool window_check(const struct window *, bool has_device, struct refusals *faults);
bool viewport_check(const struct viewport *, bool inverse, struct refusals *faults);

/* Writes the size of the full picture. */
void viewport_full(const struct viewport *, double full[2]);

/* Returns whether the viewport may be another part of the picture than all of it. */
static inline bool viewport_is_part(const struct viewport *v)
{
	return v->has_full || v->has_offset;
}

/* Puts the map from clip space of the full picture to that of the part behind r or, if
 * inverse, the map back before r. A point at X of the full picture, counted from the
 * corner of the origin, is at X - offset of the part. */
void viewport_part(const struct viewport *, const struct convention *, bool inverse,
    struct map *r);

/* Writes half the width and height, and the pixels per unit of ndc x and y. Points of
 * ndc with |x| scale[0] <= half[0] and |y| scale[1] <= half[1] are in the viewport. */
void viewport_limits(const struct viewport *, double half[2], double scale[2]);
