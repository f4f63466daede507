/* SPDX-License-Identifier: MIT */
/* A scene and the maps between its spaces. */
#ifndef SCENE_H
#define SCENE_H

#include "camera.h"
#include "projection.h"
#include "window.h"

/* Numbers of a document, and coordinates of points, are at most MAGNITUDE_MAX,
 * sizes are at least SIZE_MIN: products of a few of them stay within
 * the range of doubles. */
#define MAGNITUDE_MAX 1e150

#define SCENE_TOO_WIDE                                                       \
	"the scene's numbers lie too far from one another to be multiplied " \
	"without a loss; bring the largest and the least ones nearer"
#define SIZE_MIN 1e-150

enum space {
	SPACE_MODEL,
	SPACE_WORLD,
	SPACE_VIEW,
	SPACE_CLIP, /* four coordinates; the others have three */
	SPACE_NDC,
	SPACE_DEVICE,
};

/* The spaces of the 2D window commands, two coordinates each. */
enum flat { FLAT_WINDOW, FLAT_NDC, FLAT_DEVICE };

/* A document, as it was read; members that were not there have has_... false
 * or their default. */
struct scene {
	struct convention convention; /* by which all its numbers are read */
	/* By which view, clip and ndc space and the device are wanted, where that
	 * is another; else NULL. */
	const struct convention *answer;
	bool has_world, has_camera, has_viewport, has_window, has_device;
	double world[4][4]; /* model to world, row vectors, affine */
	struct camera camera;
	struct projection projection; /* type NONE where there is none */
	struct viewport viewport;
	struct window window;
	struct device device;
	/* For fit: the share of the picture's width and height that stays free at
	 * each side; 0 for all else. */
	double margin;
};

static inline const struct convention *answer_convention(const struct scene *s)
{
	return s->answer != NULL ? s->answer : &s->convention;
}

bool scene_is_size(double);

/* Whether a document may hold the scene's eye and projection, which were computed. */
bool scene_is_valid(const struct scene *);

/* The composed map between any two spaces: the stages, from their parameters
 * in either direction, multiplied out as sums over a divisor (mat.h).
 * Points come out homogeneous; see points.h for the division. Returns NULL,
 * or the member (a JSON pointer) and the reason. */
const char *scene_map(const struct scene *, enum space from, enum space to,
    struct map *);
const char *scene_flat_map(const struct scene *, enum flat from, enum flat to,
    struct map *);

/* What a 2D window shows, by its edges left, right, bottom, top; and how far on the
 * device, or in ndc where there is none, one unit of the window leads along x and y.
 * The nearest doubles. Returns NULL, or the member and the reason. */
struct shown {
	double edge[4], scale[2];
};

const char *scene_shown(const struct scene *, struct shown *);

/* As scene_map, where from is no later than view space and to is later; and the
 * part from there, which may have elements beyond the range of doubles. */
const char *scene_map_by_view(const struct scene *, enum space from,
    enum space to, struct map *, struct map *from_view);

#endif
