/* SPDX-License-Identifier: MIT */
/* A scene and the maps between its spaces. */
#ifndef SCENE_H
#define SCENE_H

#include "camera.h"
#include "projection.h"
#include "window.h"

/* Numbers of a document and coordinates of points are at most MAGNITUDE_MAX in
 * magnitude, and sizes at least SIZE_MIN. Products of two such numbers are in the range
 * of doubles. */
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

/* The spaces of the 2D window commands, with two coordinates each. */
enum flat { FLAT_WINDOW, FLAT_NDC, FLAT_DEVICE };

/* A document as it was read. A member that the document lacks has its default, or its
 * has_... false. */
struct scene {
	struct convention convention; /* of the document's numbers */
	/* The convention in which view, clip and ndc space and the device are read and
	 * printed, or NULL if it is the document's. */
	const struct convention *answer;
	bool has_world, has_camera, has_viewport, has_window, has_device;
	double world[4][4]; /* affine, from model to world, for row vectors */
	struct camera camera;
	struct projection
	    projection; /* PROJECTION_NONE if the document has none */
	struct viewport viewport;
	struct window window;
	struct device device;
	/* For fit, the share of the picture's width and height that stays free at
	 * each side; 0 for all other commands. */
	double margin;
	/* NULL, or the known map of a stage by the space below, or its inverse. */
	const struct map *known[SPACE_DEVICE][2];
};

static inline const struct convention *answer_convention(const struct scene *s)
{
	return s->answer != NULL ? s->answer : &s->convention;
}

/* Returns whether a number is from SIZE_MIN to MAGNITUDE_MAX. */
bool scene_is_size(double);

/* Returns whether a document may contain the scene's computed eye and projection: their
 * numbers are in range, and near differs from far, and each edge from the opposite
 * one. */
bool scene_is_valid(const struct scene *);

/* Compute the map between two spaces, as the product of the maps from each space to the
 * next. Images of points are homogeneous (transform.h divides them). Return NULL, or
 * the member, as a JSON pointer, and the reason. */
const char *scene_map(const struct scene *, enum space from, enum space to,
    struct map *);
const char *scene_flat_map(const struct scene *, enum flat from, enum flat to,
    struct map *);

/* The part of the plane that a 2D window shows, in nearest doubles. */
struct shown {
	double edge[4];  /* left, right, bottom, top */
	double scale[2]; /* device or, without one, ndc units per window unit */
};

/* Computes what the window shows. Returns NULL, or the member and the reason. */
const char *scene_shown(const struct scene *, struct shown *);

/* Computes the same map as scene_map, from model, world or view space to a space after
 * view space, and its last factor: from_view, the map from view space. from_view may
 * have elements beyond the range of doubles. */
const char *scene_map_by_view(const struct scene *, enum space from,
    enum space to, struct map *, struct map *from_view);

#endif
