/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "../core/derive/fit.h"
#include "call/input.h"
#include "call/notes.h"
#include "call/operands.h"

struct fit {
	struct directions directions;
	struct extremes extremes;
};

/* Adds the points of a block, c->in, to the chunk's struct extremes, in c->out. */
static void fit_take_block(const struct job *j, struct chunk *c)
{
	const struct fit *fit = j->data;
	bool flat = j->transform.in == 2;
	/* in 2D there is no z, and no direction uses z: passes x instead */
	const double *const in[3] = { c->in[0], c->in[1], c->in[flat ? 0 : 2] };

	if (c->size == 0)
		memset(chunk_reserve(c, sizeof fit->extremes), 0, sizeof fit->extremes);
	c->size = sizeof fit->extremes;
	/* extremes_add needs a multiple of 16 points: repeats the first point */
	for (size_t i = c->block_points; i % 16 != 0; i++)
		for (int k = 0; k < j->transform.in; k++)
			c->in[k][i] = c->in[k][0];
	extremes_add((void *)c->out, &fit->directions, in, c->block_points);
}

static void fit_collect_chunk(const struct job *j, const struct chunk *c)
{
	struct fit *fit = j->data;

	if (c->size > 0)
		extremes_merge(&fit->extremes, &fit->directions, (const void *)c->out);
}

static bool fit_read_points(const struct options *o, struct document *d, struct job *j)
{
	const enum space space = d->flat ? FLAT_NDC : SPACE_MODEL;
	static struct fit fit;

	j->take_block = fit_take_block;
	j->collect_chunk = fit_collect_chunk;
	j->data = &fit;
	memset(&fit.extremes, 0, sizeof fit.extremes);
	map_identity(&j->transform.map);
	transform_init(&j->transform, space, space, false);
	if (d->flat)
		fit_window_directions(&fit.directions);
	else if (!fit_directions(&d->scene, d->has_eye, &fit.directions,
		     d->source.faults))
		return false;
	if (!operands_run_job(o, d, space, space, j))
		return false;
	return extremes_bounds(&fit.extremes, &fit.directions, &d->bounds) ||
	    document_refuse(d, "/bounds", "missing, and there are no points", NULL);
}

/* A refusal of /bounds that are those of points names the points. */
static void name_points(const struct options *o, struct document *d)
{
	struct refusal *r = &d->source.faults->list[0];

	if (d->has_bounds || strcmp(r->where, "/bounds") != 0)
		return;
	strcpy(r->where, o->n_points > 0 ? "" : "/points");
	if (o->n_points == 0)
		return;
	d->source.text = NULL; /* it is not that of the points */
	d->source.name = o->n_points == 1 && input_first_char(o->points[0]) != '[' ?
	    o->points[0] :
	    "POINTS";
}

/* Refuses bounds that are given twice, or not at all. */
static bool check_given(const struct options *o, const struct document *d)
{
	if (d->has_bounds && o->n_points > 0)
		return document_refuse(d, "/bounds", "not together with POINTS",
		    "give one");
	return o->n_points > 0 || (d->present & (SCENE_BOUNDS | SCENE_POINTS)) != 0 ||
	    document_refuse(d, "/bounds", "missing",
		"add it ('projcalc help bounds'), POINTS or -");
}

static bool run_fit(const struct options *o, struct document *d, struct job *j)
{
	struct refusals *const faults = d->source.faults;
	bool points;

	if (!operands_have_points(o, d, &points))
		return false;
	if (d->scene.answer != NULL)
		return document_refuse(d, "/convention", "fit prints the scene's",
		    "leave -c out");
	if (!check_given(o, d))
		return false;
	if (!d->flat)
		notes_say(d,
		    notes_of_document(d, 0) |
			notes_of_spaces(d, SPACE_MODEL, SPACE_DEVICE));
	if (!d->has_bounds && !fit_read_points(o, d, j))
		return false;
	if (!(d->flat ? fit_window(&d->scene, &d->bounds, faults) :
			fit_scene(&d->scene, d->has_eye, &d->bounds, faults))) {
		name_points(o, d);
		return false;
	}
	document_print(d, o->out == FORMAT_JSON);
	return true;
}

static void judge_fit(const struct options *o, const struct document *d)
{
	const struct bounds *b = d->has_bounds ? &d->bounds : NULL;
	struct hull h;

	check_given(o, d);
	if (d->flat)
		fit_check_window(&d->scene, b, &h, d->source.faults);
	else
		fit_check(&d->scene, b, d->source.faults);
}

const struct work fit_work = { run_fit, judge_fit, NULL, NULL };
