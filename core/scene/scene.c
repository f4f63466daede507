/* SPDX-License-Identifier: MIT */
#include "scene.h"

bool scene_is_size(double v)
{
	return v >= SCENE_SIZE_MIN && v <= SCENE_MAGNITUDE_MAX;
}

static bool are_in_range(int n, const double *v)
{
	bool are = true;

	for (int i = 0; i < n; i++)
		are &= fabs(v[i]) <= SCENE_MAGNITUDE_MAX;
	return are;
}

/* Returns whether the cross-section is valid. Checks only sizes, edges and intrinsics,
 * which may be computed; others are from a document, whose reader has checked them. */
static bool has_valid_section(const struct scene *s)
{
	const struct projection_section *c = &s->projection.section;
	const double(*k)[4] = c->intrinsics;

	if (c->way == SECTION_SIZE)
		return scene_is_size(c->width) && scene_is_size(c->height);
	if (c->way == SECTION_EDGES)
		return are_in_range(4, c->edges) && c->left != c->right &&
		    c->bottom != c->top;
	return c->way != SECTION_INTRINSICS ||
	    (s->has_viewport && s->viewport.scale == SCALE_FILL &&
		scene_is_size(fabs(k[0][0])) && scene_is_size(fabs(k[1][1])) &&
		are_in_range(8, k[0]));
}

bool scene_is_valid(const struct scene *s)
{
	const struct projection *p = &s->projection;
	bool is = are_in_range(3, s->camera.eye);

	switch (projection_family(p)) {
	case FAMILY_PERSP:
		return is && has_valid_section(s) &&
		    (projection_is_open(p) ||
			(scene_is_size(p->near) && p->near < p->far &&
			    (isinf(p->far) || scene_is_size(p->far))));
	case FAMILY_PARALLEL:
		return is && has_valid_section(s) && are_in_range(2, &p->near) &&
		    p->near != p->far;
	case FAMILY_VOLUME:
		return is && are_in_range(2, &p->volume.z_near);
	case FAMILY_FIXED:
		break;
	}
	return is;
}

/* Computes the map from the space `first` to the next space, or its inverse. */
static bool map_to_next(const struct scene *s, enum space first, bool inverse,
    struct map *r, struct refusals *faults)
{
	const struct convention *c = &s->convention, *to = scene_answer_convention(s);

	if (s->known[first][inverse] != NULL) {
		map_copy(r, s->known[first][inverse]);
		return true;
	}
	switch (first) {
	case SPACE_MODEL:
		if (s->has_world)
			return steps_map(&s->world, "/world", inverse, false, r,
			    faults);
		map_identity(r);
		return true;
	case SPACE_WORLD:
		if (!s->has_camera)
			map_identity(r);
		else if (!camera_map(&s->camera, c, inverse, r, faults))
			return false;
		break;
	case SPACE_VIEW:
		if (!projection_map(&s->projection, c, inverse, r, faults))
			return false;
		if (s->has_viewport)
			viewport_part(&s->viewport, c, inverse, r);
		break;
	case SPACE_NDC:
		if (!s->has_viewport)
			return refuse(faults, "/viewport", "missing",
			    "device coordinates need one, such as {\"width\": 640, "
			    "\"height\": 480}; ndc needs none");
		return viewport_map(&s->viewport, to, inverse, r, faults);
	case FLAT_WINDOW:
		return window_map(&s->window, s->has_device ? &s->device : NULL,
		    inverse, r, faults);
	case FLAT_NDC:
		return device_map(&s->device, inverse, r, faults);
	case SPACE_CLIP: /* the division by w is not a part of the map */
	case SPACE_DEVICE:
	case FLAT_DEVICE:
		map_identity(r);
		return true;
	}
	convention_change(c, to, false, inverse == (first == SPACE_WORLD), r);
	if (first == SPACE_VIEW)
		convention_change(c, to, true, inverse, r);
	return true;
}

static void check_member(const struct scene *s, enum space first, bool inverse,
    struct refusals *faults)
{
	struct map r;

	if (first == SPACE_MODEL && s->has_world)
		steps_map(&s->world, "/world", inverse, false, &r, faults);
	if (first == SPACE_WORLD && s->has_camera)
		camera_check(&s->camera, &s->convention, inverse, faults);
	if (first == SPACE_VIEW)
		projection_check(&s->projection, inverse, faults);
	if (first == SPACE_NDC && s->has_viewport)
		viewport_check(&s->viewport, inverse, faults);
	if (first == FLAT_WINDOW && s->has_window)
		window_check(&s->window, s->has_device, faults);
}

void scene_check(const struct scene *s, enum space from, enum space to,
    struct refusals *faults)
{
	const bool back = from > to;

	for (enum space i = back ? to : from; i < (back ? from : to); i++)
		check_member(s, i, back, faults);
	ex_has_overflowed(); /* a part that lost digits is not what was asked for */
}

bool scene_map_factor(const struct scene *s, enum space from, enum space to,
    struct map *r, struct refusals *faults)
{
	bool back = from > to;
	enum space low = back ? to : from, high = back ? from : to;
	struct map next;

	if (low == high)
		map_identity(r);
	for (enum space i = low; i < high; i++) {
		if (!map_to_next(s, i, back, i == low ? r : &next, faults))
			return false;
		if (i > low)
			map_multiply(r, &next, back);
	}
	return true;
}

/* Returns the pointer to the member to blame for a product of the scene's maps: to the
 * first that is a list of steps, if there is one, and then sets `of_steps`. */
static const char *product_pointer(const struct scene *s, bool flat, bool *of_steps)
{
	const bool world = s->has_world && s->world.step != NULL;
	const bool camera = s->camera.steps.step != NULL;

	*of_steps = !flat && (world || camera);
	return flat ? "/window" :
	    world   ? "/world" :
	    camera  ? camera_3x3_pointer(&s->camera) :
		      "/projection";
}

bool scene_refuse_too_wide(const struct scene *s, bool flat, struct refusals *faults)
{
	bool of_steps;
	const char *pointer = product_pointer(s, flat, &of_steps);

	return of_steps ?
	    refuse(faults, pointer, STEPS_TOO_WIDE, STEPS_TOO_WIDE_REMEDY) :
	    refuse(faults, pointer, SCENE_TOO_WIDE, SCENE_TOO_WIDE_REMEDY);
}

bool scene_map_refuse_range(const struct scene *s, bool flat, const struct map *r,
    struct refusals *faults)
{
	bool of_steps;

	if (ex_has_overflowed())
		return scene_refuse_too_wide(s, flat, faults);
	return map_is_finite(r) ||
	    refuse(faults, product_pointer(s, flat, &of_steps),
		"the composed matrix has elements beyond the range of doubles",
		"bring sizes and distances nearer to one another");
}

bool scene_map(const struct scene *s, enum space from, enum space to, struct map *r,
    struct refusals *faults)
{
	return scene_map_factor(s, from, to, r, faults) &&
	    scene_map_refuse_range(s, space_is_flat(from), r, faults);
}

bool scene_window_extent(const struct scene *s, struct window_extent *w,
    struct refusals *faults)
{
	struct map out, back;

	if (!scene_map(s, FLAT_WINDOW, s->has_device ? FLAT_DEVICE : FLAT_NDC, &out,
		faults) ||
	    !scene_map(s, FLAT_NDC, FLAT_WINDOW, &back, faults))
		return false;
	for (int k = 0; k < 4; k++) {
		struct sum half = back.m[k / 2][k / 2];
		struct sum edge = sum_add(back.m[3][k / 2],
		    k & 1 ? half : sum_neg(half));

		w->edge[k] = sum_ratio(edge, back.divisor);
		w->scale[k / 2] = map_element_nearest(&out, k / 2, k / 2, false);
	}
	return true;
}
