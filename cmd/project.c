/* SPDX-License-Identifier: MIT */
#include "call/operands.h"
#include "message/message.h"

static void project_check_ray(const struct options *o)
{
	if ((o->has_from && o->from != SPACE_DEVICE) ||
	    (o->has_to && o->to != SPACE_WORLD))
		die(EXIT_USAGE, "--ray goes from device to world");
	if (o->homogeneous || o->flags || o->visible || o->matrix)
		die(EXIT_USAGE,
		    "--ray stands alone: no -H, -m, --flags or "
		    "--visible");
}

static void project_check_plane(const struct options *o)
{
	if ((o->has_from && o->from < SPACE_NDC) ||
	    (o->has_to && o->to > SPACE_VIEW))
		die(EXIT_USAGE,
		    "--plane goes from device or ndc to model, world or view");
	if (o->plane.v[0] == 0 && o->plane.v[1] == 0 && o->plane.v[2] == 0)
		die(EXIT_USAGE,
		    "--plane: A, B or C is other than 0, as in 0,0,1,0");
	if (o->ray || o->homogeneous || o->flags || o->visible)
		die(EXIT_USAGE,
		    "--plane stands alone: no --ray, -H, --flags or "
		    "--visible");
}

static void project_plane(const struct document *d, const struct options *o,
    enum space to, struct job *j)
{
	enum space from = o->has_from ? o->from : SPACE_DEVICE;

	document_check(d,
	    ray_plane_transform(&d->scene, from, to, o->plane.v, &j->transform));
	j->count_imageless = true;
}

static void project_rays(const struct document *d, struct job *j)
{
	j->rays = true;
	j->count_imageless = true;
	document_check(d, ray_maker_of(&d->scene, &j->ray));
}

static void project_transform(const struct document *d, const struct options *o,
    enum space from, enum space to, struct job *j)
{
	document_check(d,
	    scene_transform(&d->scene, from, to, o->homogeneous,
		&j->transform));
	if (o->flags || o->visible)
		document_check(d,
		    frustum_of(&d->scene, from, o->homogeneous, &j->frustum));
	j->count_imageless = !o->flags && !o->visible && !o->homogeneous &&
	    to != SPACE_CLIP;
}

/* Refuses one of --from and --to that leads from its space to the same space. */
static void project_check_half(const struct options *o, enum space from,
    enum space to)
{
	const char *name = space_names[from];

	if (from != to || o->has_from == o->has_to)
		return;
	if (o->has_to)
		die(EXIT_USAGE,
		    "--to %s alone goes from %s to %s; write --from %s --to "
		    "world, or --from world --to %s",
		    name, name, name, name, name);
	die(EXIT_USAGE,
	    "--from %s alone goes from %s to %s; write --from %s --to world%s",
	    name, name, name, name,
	    from == SPACE_DEVICE ?
		", --ray for the ray of each x y, or --plane A,B,C,D for where "
		"that ray meets a plane" :
		"");
}

void run_project(const struct command *c, const struct options *o)
{
	enum space from = o->has_from ? o->from : SPACE_MODEL;
	struct document d;
	static struct job j;

	if (o->plane.n > 0)
		project_check_plane(o);
	else if (o->ray)
		project_check_ray(o);
	read_document(c, o, &d);

	enum space to = o->has_to  ? o->to :
	    o->ray || o->plane.n > 0 ? SPACE_WORLD :
	    d.scene.has_viewport   ? SPACE_DEVICE :
				     SPACE_NDC;

	if (o->plane.n > 0) {
		project_plane(&d, o, to, &j);
	} else if (o->ray) {
		project_rays(&d, &j);
	} else {
		project_check_half(o, from, to);
		project_transform(&d, o, from, to, &j);
	}
	if (o->matrix) {
		print_matrix(o, &d, &j.transform);
		return;
	}
	j.space = space_names[to];
	prepare_job(&j, o);
	do_points(o, &d, &j);
}
