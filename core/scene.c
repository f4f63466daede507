#include "scene.h"

#include <string.h>

static const char *world_map(const struct scene *s, bool inverse,
    struct map *r)
{
	double m[4][4];

	*r = map_identity;
	if (!s->has_world)
		return NULL;
	memcpy(m, s->world, sizeof m);
	*r = map_of_doubles(m);
	if (!map_is_affine(r))
		return "/world: its last column is not 0 0 0 1; "
		       "write the rows as \"vectors\" says";
	if (inverse && !map_inverse(m, r))
		return "/world: singular; it can't be inverted";
	return NULL;
}

/* The map of one stage, from the space below to the one above or back. */
static const char *stage_map(const struct scene *s, enum space below,
    bool inverse, struct map *r)
{
	const struct convention *c = &s->convention;

	*r = map_identity;
	switch (below) {
	case SPACE_MODEL:
		return world_map(s, inverse, r);
	case SPACE_WORLD:
		return s->has_camera ? camera_map(&s->camera,
		    c->right_handed, inverse, r) : NULL;
	case SPACE_VIEW:
		return projection_map(&s->projection, c, inverse, r);
	case SPACE_NDC:
		if (!s->has_viewport)
			return "/viewport: missing; device coordinates need "
			       "one, or use the space ndc";
		return viewport_map(&s->viewport, c, inverse, r);
	default: /* clip to ndc divides */
		return NULL;
	}
}

static const char *add(struct map *r, const struct map *stage, const char *why)
{
	if (why != NULL)
		return why;
	*r = map_then(r, stage);
	return map_is_finite(r) ? NULL :
	    "/projection: the scene's composed matrix has elements beyond the "
	    "range of doubles; bring sizes and distances nearer to one another";
}

const char *scene_map(const struct scene *s, enum space from, enum space to,
    struct map *r)
{
	const char *why = NULL;
	struct map stage;

	*r = map_identity;
	for (int i = (int)from; i < (int)to && why == NULL; i++)
		why = add(r, &stage, stage_map(s, (enum space)i, false, &stage));
	for (int i = (int)from; i > (int)to && why == NULL; i--)
		why = add(r, &stage,
		    stage_map(s, (enum space)(i - 1), true, &stage));
	return why;
}

const char *scene_flat_map(const struct scene *s, enum flat from, enum flat to,
    struct map *r)
{
	const struct device *d = s->has_device ? &s->device : NULL;
	bool back = from > to;
	enum flat low = back ? to : from, high = back ? from : to;
	struct map w = map_identity, n = map_identity;
	const char *why = NULL;

	if (low == FLAT_WINDOW)
		why = window_map(&s->window, d, back, &w);
	if (why == NULL && high == FLAT_DEVICE)
		why = device_map(&s->device, back, &n);
	*r = map_identity;
	if (why == NULL)
		why = add(r, back ? &n : &w, NULL);
	return add(r, back ? &w : &n, why);
}
