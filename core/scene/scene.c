/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include <string.h>

bool scene_is_size(double v)
{
	return v >= SIZE_MIN && v <= MAGNITUDE_MAX;
}

static bool are_numbers(int n, const double *v)
{
	bool are = true;

	for (int i = 0; i < n; i++)
		are &= fabs(v[i]) <= MAGNITUDE_MAX;
	return are;
}

/* Returns whether a cross-section that was computed is valid. The reader of a document
 * has checked the others. */
static bool has_valid_section(const struct scene *s)
{
	const struct projection *p = &s->projection;
	const double(*k)[4] = p->intrinsics;

	if (p->extent == EXTENT_SIZE)
		return scene_is_size(p->width) && scene_is_size(p->height);
	if (p->extent == EXTENT_EDGES)
		return are_numbers(4, &p->left) && p->left != p->right &&
		    p->bottom != p->top;
	return p->extent != EXTENT_INTRINSICS ||
	    (s->has_viewport && s->viewport.scale == SCALE_FILL &&
		scene_is_size(fabs(k[0][0])) && scene_is_size(fabs(k[1][1])) &&
		are_numbers(8, k[0]));
}

bool scene_is_valid(const struct scene *s)
{
	const struct projection *p = &s->projection;
	bool planes = are_numbers(2, &p->near) && p->near != p->far;

	if (p->type == PROJECTION_VOLUME)
		planes = are_numbers(2, &p->z_near);
	else if (p->type == PROJECTION_PERSP)
		planes = projection_is_open(p) ||
		    (scene_is_size(p->near) && p->near < p->far &&
			(isinf(p->far) || scene_is_size(p->far)));
	return are_numbers(3, s->camera.eye) && planes &&
	    (p->type == PROJECTION_VOLUME || has_valid_section(s));
}

static const char *world_map(const struct scene *s, bool inverse, struct map *r)
{
	map_identity(r);
	if (!s->has_world)
		return NULL;
	map_of_doubles(s->world, r);
	if (!map_is_affine(r))
		return "/world: " NOT_AFFINE;
	if (inverse && !map_inverse(s->world, r))
		return "/world: singular; it can't be inverted";
	return NULL;
}

/* Computes the map of view or clip space from one convention to another. The map is the
 * identity for other spaces. y, and in view space z, may change their signs. The depth z
 * from 0 to w of clip space becomes 2 z - w from -w to w, and back (z + w) / 2. */
static void convention_map(enum space space, const struct convention *from,
    const struct convention *to, struct map *r)
{
	bool view = space == SPACE_VIEW, clip = space == SPACE_CLIP;
	bool flips_y = (view && from->view_y_down != to->view_y_down) ||
	    (clip && from->ndc_y_down != to->ndc_y_down);
	bool flips_z = view && looks_back(from) != looks_back(to);
	bool depth = clip && from->minus_one != to->minus_one;
	double y = flips_y ? -1 : 1, t = !depth ? 0 : to->minus_one ? -1 : 0.5;
	double z = flips_z ? -1 : !depth ? 1 : to->minus_one ? 2 : 0.5;
	const double m[4][4] = {
		{ 1, 0, 0, 0 },
		{ 0, y, 0, 0 },
		{ 0, 0, z, 0 },
		{ 0, 0, t, 1 },
	};

	map_of_doubles(m, r);
}

/* Changes the map of a stage, or its inverse, from the scene's convention to the
 * answer's. */
static void scene_answer(const struct scene *s, enum space below, bool inverse,
    struct map *r)
{
	const struct convention *c = &s->convention;
	enum space from = below + inverse, to = below + !inverse;
	struct map before, after;

	if (s->answer == NULL)
		return;
	convention_map(from, s->answer, c, &before);
	convention_map(to, c, s->answer, &after);
	map_append(r, &before, true);
	map_append(r, &after, false);
}

/* Computes the map of a stage, from the space below to the next space, or its inverse. */
static const char *stage_map(const struct scene *s, enum space below,
    bool inverse, struct map *r)
{
	const struct convention *c = &s->convention;
	const char *why = NULL;

	map_identity(r);
	switch (below) {
	case SPACE_MODEL:
		return world_map(s, inverse, r);
	case SPACE_WORLD:
		if (s->has_camera)
			why = camera_map(&s->camera, c, inverse, r);
		scene_answer(s, below, inverse, r);
		break;
	case SPACE_VIEW:
		why = projection_map(&s->projection, c, inverse, r);
		scene_answer(s, below, inverse, r);
		break;
	case SPACE_NDC:
		if (!s->has_viewport)
			return "/viewport: missing; device coordinates need "
			       "one, or use the space ndc";
		return viewport_map(&s->viewport, answer_convention(s), inverse,
		    r);
	case SPACE_CLIP: /* ndc is clip space divided by w */
	case SPACE_DEVICE:
		break;
	}
	return why;
}

static const char *compose(const struct scene *s, enum space from,
    enum space to, struct map *r)
{
	bool back = from > to;
	int low = (int)(back ? to : from), high = (int)(back ? from : to);
	struct map stage;

	map_identity(r);
	for (int i = low; i < high; i++) {
		const char *why = stage_map(s, (enum space)i, back, &stage);

		if (why != NULL)
			return why;
		map_append(r, &stage, back);
	}
	return NULL;
}

static const char *check_range(const struct map *r)
{
	if (ex_has_overflowed())
		return "/projection: " SCENE_TOO_WIDE;
	return map_is_finite(r) ?
	    NULL :
	    "/projection: the scene's composed matrix has elements beyond "
	    "the range of doubles; bring sizes and distances nearer to one "
	    "another";
}

const char *scene_map(const struct scene *s, enum space from, enum space to,
    struct map *r)
{
	const char *why = compose(s, from, to, r);

	return why != NULL ? why : check_range(r);
}

const char *scene_map_by_view(const struct scene *s, enum space from,
    enum space to, struct map *r, struct map *from_view)
{
	const char *why = compose(s, from, SPACE_VIEW, r);

	if (why == NULL)
		why = compose(s, SPACE_VIEW, to, from_view);
	if (why != NULL)
		return why;
	map_append(r, from_view, false);
	return check_range(r);
}

const char *scene_flat_map(const struct scene *s, enum flat from, enum flat to,
    struct map *r)
{
	const struct device *d = s->has_device ? &s->device : NULL;
	bool back = from > to;
	enum flat low = back ? to : from, high = back ? from : to;
	struct map stage;
	const char *why = NULL;

	map_identity(r);
	if (low == high)
		return NULL;
	if (low == FLAT_WINDOW)
		why = window_map(&s->window, d, back, r);
	if (why == NULL && high == FLAT_DEVICE) {
		why = device_map(&s->device, back, &stage);
		map_append(r, &stage, back);
	}
	if (why == NULL && ex_has_overflowed())
		return "/window: " SCENE_TOO_WIDE;
	return why != NULL || map_is_finite(r) ?
	    why :
	    "/window: the composed matrix has elements beyond the range of "
	    "doubles; bring the sizes nearer to one another";
}

const char *scene_shown(const struct scene *s, struct shown *w)
{
	struct map out, back;
	const char *why = scene_flat_map(s, FLAT_WINDOW,
	    s->has_device ? FLAT_DEVICE : FLAT_NDC, &out);

	if (why == NULL)
		why = scene_flat_map(s, FLAT_NDC, FLAT_WINDOW, &back);
	for (int k = 0; k < 4 && why == NULL; k++) {
		struct sum half = back.m[k / 2][k / 2];
		struct sum edge = sum_add(back.m[3][k / 2],
		    k & 1 ? half : sum_neg(half));

		w->edge[k] = sum_ratio(edge, back.divisor);
		w->scale[k / 2] = map_nearest(&out, k / 2, k / 2, false);
	}
	return why;
}
