/* SPDX-License-Identifier: MIT */
/* A scene and the maps between its spaces. */
#pragma once

#include "../projection/projection.h"
#include "camera.h"
#include "window.h"

/* Numbers of scene documents and points are at most SCENE_MAGNITUDE_MAX in magnitude,
 * and sizes at least SCENE_SIZE_MIN: products of two sizes are in the
 * range of doubles. */
#define SCENE_MAGNITUDE_MAX 1e150
#define SCENE_SIZE_MIN 1e-150

/* Says why a product of a scene's numbers that has lost digits is refused. */
#define SCENE_TOO_WIDE                                                       \
	"the scene's numbers lie too far from one another to be multiplied " \
	"without a loss"
#define SCENE_TOO_WIDE_REMEDY "bring the largest and the least ones nearer"

enum space {
	SPACE_MODEL,
	SPACE_WORLD,
	SPACE_VIEW,
	SPACE_CLIP, /* has four coordinates; the other spaces of 3D three */
	SPACE_NDC,
	SPACE_DEVICE,
	/* the spaces of the commands for 2D windows, with two coordinates each */
	FLAT_WINDOW,
	FLAT_NDC,
	FLAT_DEVICE,
};

static inline bool space_is_flat(enum space s)
{
	return s >= FLAT_WINDOW;
}

/* A scene document as it was read. If the document lacks a member, the member has its
 * default, or its has_... is false. */
struct scene {
	struct convention convention; /* of the document's numbers */
	/* The convention in which view, clip, ndc and device coordinates are read and
	 * printed, or NULL for the document's. */
	const struct convention *answer;
	bool has_world, has_camera, has_viewport, has_window, has_device;
	struct steps world; /* from model to world */
	struct camera camera;
	struct projection projection;
	struct viewport viewport;
	struct window window;
	struct device device;
	/* The share of width and height that projcalc fit leaves free at each side. */
	double margin;
	/* NULL, or known maps: [s][0] from space s to s + 1, [s][1] its inverse */
	const struct map *known[FLAT_DEVICE][2];
};

static inline const struct convention *scene_answer_convention(const struct scene *s)
{
	return s->answer != NULL ? s->answer : &s->convention;
}

/* Refuses a product of the scene's maps, between flat spaces or others, that has lost
 * digits: the steps of a list or, without one, the scene. Returns false. */
bool scene_refuse_too_wide(const struct scene *, bool flat, struct refusals *faults);

/* Returns whether a number is from SCENE_SIZE_MIN to SCENE_MAGNITUDE_MAX. */
bool scene_is_size(double);

/* Returns whether the scene's eye and projection, which were computed, are allowed in a
 * document: numbers are in range, near differs from far, and opposite edges differ. */
bool scene_is_valid(const struct scene *);

/* Refuses all that is wrong with the members that make a map between two spaces, each
 * member by itself, as scene_map stops at the first. For scenes that were refused:
 * numbers that were refused or are missing are NaN, and steps are marked. */
void scene_check(const struct scene *, enum space from, enum space to,
    struct refusals *faults);

/* Computes the map between two spaces, both flat or neither: the product of the maps
 * from each space to the next. Images are homogeneous; transform.h divides them. */
bool scene_map(const struct scene *, enum space from, enum space to, struct map *,
    struct refusals *faults);

/* The part of the plane that a 2D window shows, rounded to doubles. */
struct window_extent {
	double edge[4];  /* left, right, bottom, top */
	double scale[2]; /* device units (no device: ndc) per window unit */
};

/* Computes what the window shows. */
bool scene_window_extent(const struct scene *, struct window_extent *,
    struct refusals *faults);

/* Computes a factor of a map: the map of scene_map, whose elements may be beyond the
 * range of doubles. scene_map_refuse_range refuses the scene, and returns false, if
 * elements of the product are; `flat` says of which spaces. */
bool scene_map_factor(const struct scene *, enum space from, enum space to,
    struct map *, struct refusals *faults);
bool scene_map_refuse_range(const struct scene *, bool flat, const struct map *,
    struct refusals *faults);
