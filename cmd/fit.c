/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "../core/derive/fit.h"
#include "call/input.h"
#include "call/notes.h"
#include "call/operands.h"
#include "message/message.h"

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

static void fit_read_points(const struct options *o, struct document *d, struct job *j)
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
	else
		document_refuse_if(d,
		    fit_directions(&d->scene, d->has_eye, &fit.directions));
	operands_run_job(o, d, space, space, j);
	if (!extremes_bounds(&fit.extremes, &fit.directions, &d->bounds))
		document_refuse(d, "/bounds: missing, and there are no points");
}

/* If the reason is about /bounds, and these are those of points, names the points. */
static _Noreturn void refuse_fit(const struct options *o, const struct document *d,
    const char *reason)
{
	const char bounds[] = "/bounds: ";
	const size_t n = strlen(bounds);
	struct place place = json_source_place(&d->source, "/points");

	if (d->has_bounds || strncmp(reason, bounds, n) != 0)
		document_refuse(d, reason);
	if (o->n_points == 1 && input_first_char(o->points[0]) != '[')
		place = (struct place){ .file = o->points[0] };
	else if (o->n_points > 0)
		place = (struct place){ .file = "POINTS" };
	place.of_scene = true;
	die_at(EXIT_INPUT, &place, "%s", reason + n);
}

void run_fit(const struct options *o, struct document *d, struct job *j)
{
	const bool points = operands_have_points(o, d);

	if (d->scene.answer != NULL)
		document_refuse(d, "/convention: fit prints the scene's; leave -c out");
	if (d->has_bounds && o->n_points > 0)
		document_refuse(d, "/bounds: not together with POINTS; give one");
	if (!d->has_bounds && !points)
		document_refuse(d,
		    "/bounds: missing; add it ('projcalc help bounds'), POINTS or -");
	if (!d->flat)
		notes_say(d, notes_of_document(d, 0));
	if (!d->has_bounds)
		fit_read_points(o, d, j);
	const char *why = d->flat ? fit_window(&d->scene, &d->bounds) :
				    fit_scene(&d->scene, d->has_eye, &d->bounds);

	if (why != NULL)
		refuse_fit(o, d, why);
	document_print(d, o->out == FORMAT_JSON);
}
