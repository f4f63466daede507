#include "scene.h"

#include <string.h>

/* Refusals of a stage whose product with the others is too large, indexed by the
 * space that the stage leads from. */
#define BEYOND                                                         \
	": the scene's composed matrix has elements beyond the range " \
	"of doubles; bring sizes and distances nearer to one another"

static const char *const beyond[] = {
	"/world" BEYOND,
	"/camera" BEYOND,
	"/projection" BEYOND,
	"/projection" BEYOND,
	"/viewport" BEYOND,
};

static const char *world_map(const struct scene *s, bool inverse, struct map *r)
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
		return s->has_camera ?
		    camera_map(&s->camera, c->right_handed, inverse, r) :
		    NULL;
	case SPACE_VIEW:
		return projection_map(&s->projection, c, inverse, r);
	case SPACE_NDC:
		if (!s->has_viewport)
			return "/viewport: missing; device coordinates need "
			       "one, or use the space ndc";
		return viewport_map(&s->viewport, c, inverse, r);
	default: /* clip to ndc: only the division */
		return NULL;
	}
}

/* Backwards the stages are composed from the world's end, so that the eye and the
 * world matrix's translation are subtracted exactly before anything is
 * rounded. */
static void then(struct map *r, const struct map *stage, bool back)
{
	*r = back ? map_then(stage, r) : map_then(r, stage);
}

const char *scene_map(const struct scene *s, enum space from, enum space to,
    struct map *r)
{
	bool back = from > to;
	int low = (int)(back ? to : from), high = (int)(back ? from : to);

	*r = map_identity;
	for (int i = low; i < high; i++) {
		struct map stage;
		const char *why = stage_map(s, (enum space)i, back, &stage);

		if (why != NULL)
			return why;
		then(r, &stage, back);
		if (!map_is_finite(r))
			return beyond[i];
	}
	map_settle(r);
	return NULL;
}

const char *scene_flat_map(const struct scene *s, enum flat from, enum flat to,
    struct map *r)
{
	const struct device *d = s->has_device ? &s->device : NULL;
	bool back = from > to;
	enum flat low = back ? to : from, high = back ? from : to;
	struct map stage;
	const char *why = NULL;

	*r = map_identity;
	if (low == high)
		return NULL;
	if (low == FLAT_WINDOW)
		why = window_map(&s->window, d, back, r);
	if (why != NULL || high != FLAT_DEVICE)
		return why;
	why = device_map(&s->device, back, &stage);
	then(r, &stage, back);
	map_settle(r);
	return why != NULL || map_is_finite(r) ?
	    why :
	    "/device: the composed matrix has elements beyond the range of "
	    "doubles; bring the sizes nearer to one another";
}
