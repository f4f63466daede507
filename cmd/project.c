/* SPDX-License-Identifier: MIT */
#include "../core/points/distance.h"
#include "call/notes.h"
#include "call/operands.h"
#include "matrix.h"
#include "call/option_row.h"
#include "message/message.h"

static void check_project(const struct options *o)
{
	const bool plane = o->plane.n > 0;

	if (o->ray &&
	    ((o->has_from && o->from != SPACE_DEVICE) ||
		(o->has_to && o->to != SPACE_WORLD)))
		die(EXIT_USAGE, "--ray goes from device to world",
		    "leave --from and --to out, and for rays of view space the camera");
	if (plane &&
	    ((o->has_from && o->from < SPACE_NDC) || (o->has_to && o->to > SPACE_VIEW)))
		die(EXIT_USAGE, "--plane is from device or ndc to model, world, view",
		    NULL);
	if (plane && o->plane.v[0] == 0 && o->plane.v[1] == 0 && o->plane.v[2] == 0)
		die(EXIT_USAGE, "--plane: A, B and C are 0",
		    "z = 0 is --plane 0,0,1,0");
	if (o->directions &&
	    (o->matrix || o->homogeneous || o->ray || plane || o->flags || o->visible))
		die(EXIT_USAGE,
		    "--directions excludes -m, -H, --ray, --plane, --flags and "
		    "--visible",
		    NULL);
	if (o->directions && !o->has_to)
		die(EXIT_USAGE, "--directions needs --to",
		    "say --to world, view or model");
	if (o->directions &&
	    (o->to > SPACE_VIEW || (o->has_from && o->from > SPACE_VIEW)))
		die(EXIT_USAGE, "--directions goes among model, world and view",
		    "a direction has no image of its own in clip, ndc and device");
	if ((o->ray && (plane || o->matrix)) ||
	    ((o->ray || plane) && (o->homogeneous || o->flags || o->visible)))
		die(EXIT_USAGE,
		    plane ? "--plane excludes -H, --flags, --visible and --ray" :
			    "--ray excludes -H, --flags, --visible and -m",
		    NULL);
}

/* Sets the job's transform, ray or frustum. Returns false if the scene is refused. */
static bool project_prepare(const struct document *d, const struct options *o,
    enum space from, enum space to, struct job *j)
{
	const bool needs_frustum = o->flags || o->visible || o->lines;
	const struct scene *s = &d->scene;
	struct refusals *const faults = d->source.faults;

	if (s->has_viewport && s->viewport.distance && o->plane.n == 0 &&
	    (from == SPACE_DEVICE || to == SPACE_DEVICE) && !o->ray &&
	    (o->matrix || o->homogeneous))
		return document_refuse(d, "/viewport/depth",
		    "is \"distance\", but -m and -H are about the depth of \"buffer\"",
		    "write that");
	j->rays = o->ray;
	j->count_imageless = !needs_frustum && !o->homogeneous && to != SPACE_CLIP;
	if (o->plane.n > 0)
		return ray_plane_transform(s, from, to, o->plane.v, &j->transform,
		    faults);
	if (o->directions)
		return transform_of_directions(s, from, to, &j->transform, faults);
	if (o->ray)
		return ray_maker_of(s, &j->ray, faults);
	if (!(o->matrix ? transform_of_matrix(s, from, to, &j->transform, faults) :
		    o->homogeneous ?
			  transform_of_scene(s, from, to, true, &j->transform, faults) :
			  distance_transform(s, from, to, &j->transform, faults)))
		return false;
	return !needs_frustum ||
	    frustum_of(s, from, o->homogeneous, &j->frustum, faults);
}

/* Refuses --from or --to alone if the other option's default is the same space, which
 * for --from depends on the scene. */
static bool project_check_alone(const struct options *o, struct document *d,
    enum space from, enum space to)
{
	const char *name = space_names[from];

	if (from != to || o->has_from == o->has_to)
		return true;
	const char *what = text("--%s %s alone goes from %s to %s",
	    o->has_to ? "to" : "from", name, name, name);
	const char *remedy =
	    text("write --from %s --to world, or --from world --to %s%s", name, name,
		from == SPACE_DEVICE ? ", or --ray or --plane A,B,C,D for x y" : "");

	if (!o->has_from)
		die(EXIT_USAGE, what, remedy);
	d->is_usage = true;
	return document_refuse(d, NULL, what, remedy);
}

/* Sets the spaces of the points and of their images. */
static void find_spaces(const struct options *o, const struct scene *s,
    enum space *from, enum space *to)
{
	const bool back = o->ray || o->plane.n > 0;

	*from = o->has_from ? o->from : back ? SPACE_DEVICE : SPACE_MODEL;
	*to = o->has_to     ? o->to :
	    back            ? SPACE_WORLD :
	    s->has_viewport ? SPACE_DEVICE :
			      SPACE_NDC;
}

static void judge_project(const struct options *o, const struct document *d)
{
	enum space from, to;

	find_spaces(o, &d->scene, &from, &to);
	scene_check(&d->scene, from, to, d->source.faults);
}

static bool run_project(const struct options *o, struct document *d, struct job *j)
{
	const bool plane = o->plane.n > 0;
	const bool back = o->ray || plane;
	const struct scene *s = &d->scene;
	const bool projects = !projection_is_none(&s->projection);
	enum space from, to;

	find_spaces(o, s, &from, &to);
	if (!back && !project_check_alone(o, d, from, to))
		return false;
	matrix_check_unit_w(o, o->matrix, from, plane ? SPACE_VIEW : to);
	if (!o->has_to && to == SPACE_NDC && projects &&
	    (s->has_device || s->has_window))
		return document_refuse(d, "/viewport", "missing",
		    "\"device\" and \"window\" are for two dimensions; give "
		    "\"viewport\", or say --to ndc");
	if (!project_prepare(d, o, from, to, j))
		return false;
	notes_say_of_spaces(d, from, to);
	if (!back && !o->has_from && !o->has_to && (s->has_camera || s->has_world) &&
	    !projects)
		notes_say(d, 1u << NOTE_NO_PROJECTION);
	if (o->matrix)
		return matrix_print(o, d, &j->transform);
	j->layout.from = space_names[from];
	j->layout.output.space = space_names[to];
	return operands_run_job(o, d, from, to, j);
}

const struct work project_work = { run_project, judge_project, check_project, NULL };
