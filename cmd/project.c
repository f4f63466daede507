/* SPDX-License-Identifier: MIT */
#include "../core/points/distance.h"
#include "call/notes.h"
#include "call/operands.h"
#include "matrix.h"
#include "call/option_row.h"
#include "message/message.h"

void check_project(const struct options *o)
{
	const bool plane = o->plane.n > 0;

	if (o->ray &&
	    ((o->has_from && o->from != SPACE_DEVICE) ||
		(o->has_to && o->to != SPACE_WORLD)))
		die(EXIT_USAGE,
		    "--ray goes from device to world; leave --from and --to out, and "
		    "for rays of view space the camera");
	if (plane &&
	    ((o->has_from && o->from < SPACE_NDC) || (o->has_to && o->to > SPACE_VIEW)))
		die(EXIT_USAGE, "--plane is from device or ndc to model, world, view");
	if (plane && o->plane.v[0] == 0 && o->plane.v[1] == 0 && o->plane.v[2] == 0)
		die(EXIT_USAGE, "--plane: A, B and C are 0; z = 0 is --plane 0,0,1,0");
	if ((o->ray && (plane || o->matrix)) ||
	    ((o->ray || plane) && (o->homogeneous || o->flags || o->visible)))
		die(EXIT_USAGE, "--%s excludes -H, --flags, --visible and %s",
		    plane ? "plane" : "ray", plane ? "--ray" : "-m");
}

/* Returns NULL, or why the scene is refused. */
static const char *project_prepare(const struct scene *s, const struct options *o,
    enum space from, enum space to, struct job *j)
{
	const bool needs_frustum = o->flags || o->visible;

	if (s->has_viewport && s->viewport.distance && o->plane.n == 0 &&
	    (o->ray || from == SPACE_DEVICE || to == SPACE_DEVICE) &&
	    (o->matrix || o->homogeneous || o->ray))
		return "/viewport/depth: is \"distance\", but -m, -H and "
		       "--ray are about the depth of \"buffer\"; write that";
	j->rays = o->ray;
	j->count_imageless = !needs_frustum && !o->homogeneous && to != SPACE_CLIP;
	if (o->plane.n > 0)
		return ray_plane_transform(s, from, to, o->plane.v, &j->transform);
	if (o->ray)
		return ray_maker_of(s, &j->ray);
	const char *why = o->matrix ? transform_of_matrix(s, from, to, &j->transform) :
	    o->homogeneous ? transform_of_scene(s, from, to, true, &j->transform) :
			     distance_transform(s, from, to, &j->transform);

	return why == NULL && needs_frustum ?
	    frustum_of(s, from, o->homogeneous, &j->frustum) :
	    why;
}

/* Refuses --from or --to alone if the other option's default is the same space. */
static void project_check_alone(const struct options *o, enum space from, enum space to)
{
	const char *name = space_names[from];

	if (from != to || o->has_from == o->has_to)
		return;
	die_at(EXIT_USAGE, &(struct place){ .of_scene = o->has_from },
	    "--%s %s alone goes from %s to %s; write --from %s --to world, or "
	    "--from world --to %s%s",
	    o->has_to ? "to" : "from", name, name, name, name, name,
	    from == SPACE_DEVICE ? ", or --ray or --plane A,B,C,D for x y" : "");
}

void run_project(const struct options *o, struct document *d, struct job *j)
{
	const bool plane = o->plane.n > 0;
	const bool back = o->ray || plane;
	const enum space from = o->has_from ? o->from :
	    back                            ? SPACE_DEVICE :
					      SPACE_MODEL;
	const enum space to = o->has_to ? o->to :
	    back                        ? SPACE_WORLD :
	    d->scene.has_viewport       ? SPACE_DEVICE :
					  SPACE_NDC;

	if (!back)
		project_check_alone(o, from, to);
	matrix_check_unit_w(o, o->matrix, from, plane ? SPACE_VIEW : to);
	if (!o->has_to && to == SPACE_NDC &&
	    d->scene.projection.type != PROJECTION_NONE &&
	    (d->scene.has_device || d->scene.has_window))
		document_refuse(d,
		    "/viewport: missing; \"device\" and \"window\" are for two "
		    "dimensions; give \"viewport\", or say --to ndc");
	document_refuse_if(d, project_prepare(&d->scene, o, from, to, j));
	notes_say_of_spaces(d, from, to);
	if (!back && !o->has_from && !o->has_to &&
	    (d->scene.has_camera || d->scene.has_world) &&
	    d->scene.projection.type == PROJECTION_NONE)
		notes_say(d, 1u << NOTE_NO_PROJECTION);
	if (o->matrix) {
		matrix_print(o, d, &j->transform);
		return;
	}
	j->from = from != SPACE_MODEL ? space_names[from] : NULL;
	j->space = space_names[to];
	operands_run_job(o, d, o->homogeneous ? SPACE_CLIP : from, to, j);
}
