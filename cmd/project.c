#include "command.h"
#include "talk.h"

static int coordinates(const struct options *o, enum space from)
{
	if (o->ray)
		return 2;
	return from == SPACE_CLIP || (from == SPACE_DEVICE && o->homogeneous) ?
	    4 :
	    3;
}

static void check(const struct document *d, const char *why)
{
	if (why != NULL)
		json_refuse(d, why);
}

static void check_ray(const struct options *o)
{
	if ((o->has_from && o->from != SPACE_DEVICE) ||
	    (o->has_to && o->to != SPACE_WORLD))
		die(EXIT_USAGE, "--ray goes from device to world");
	if (o->homogeneous || o->flags || o->visible || o->matrix)
		die(EXIT_USAGE,
		    "--ray stands alone: no -H, -m, --flags or "
		    "--visible");
}

static void set_transform(const struct document *d, const struct options *o,
    enum space from, enum space to, struct job *j)
{
	check(d,
	    scene_transform(&d->scene, from, to, o->homogeneous,
		&j->transform));
	j->flags = o->flags;
	j->visible = o->visible;
	if (o->flags || o->visible)
		check(d,
		    frustum_of(&d->scene, from, o->homogeneous, &j->frustum));
	j->count_imageless = !o->flags && !o->visible && !o->homogeneous &&
	    to != SPACE_CLIP;
	if (!o->matrix)
		return;
	print_matrix(o, d, &j->transform.map, false);
	close_output();
}

int run_project(const struct command *c, const struct options *o)
{
	struct document d;
	struct job j = { .rays = o->ray, .count_imageless = true };
	enum space from = o->has_from ? o->from :
	    o->ray                    ? SPACE_DEVICE :
					SPACE_MODEL,
		   to = o->to;

	if (o->ray)
		check_ray(o);
	read_document(c, o, coordinates(o, from), &d);
	if (!o->has_to)
		to = d.scene.has_viewport ? SPACE_DEVICE : SPACE_NDC;
	if (o->ray) {
		check(&d, ray_maker_of(&d.scene, &j.ray));
		j.transform.in = 2;
		j.transform.out = 6;
	} else {
		set_transform(&d, o, from, to, &j);
	}
	if (o->matrix)
		return EXIT_OK;
	stream_options(&j, o);
	j.layout.flags = o->flags;
	stream_points(o, &d, &j);
	return stream_end(&j);
}
