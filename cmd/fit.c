/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "../core/derive/fit.h"
#include "../core/derive/fit_window.h"
#include "call/input.h"
#include "call/operands.h"
#include "scene/print_scene.h"
#include "message/message.h"

static const struct bounds nothing = {
	.min = { HUGE_VAL, HUGE_VAL, HUGE_VAL },
	.max = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL },
};

static void widen(struct bounds *box, const double min[3], const double max[3])
{
	for (int i = 0; i < 3; i++) {
		box->min[i] = fmin(box->min[i], min[i]);
		box->max[i] = fmax(box->max[i], max[i]);
	}
}

/* Widens the box that is the chunk's output by a point. */
static void take_into_box(const struct job *j, struct chunk *c,
    const struct line *line, size_t p, size_t number)
{
	double z = j->transform.in > 2 ? c->in[2][p] : 0;
	double at[3] = { c->in[0][p], c->in[1][p], z };

	(void)number;
	if (line->kind != LINE_POINT)
		return;
	if (c->size == 0)
		memcpy(chunk_reserve(c, sizeof nothing), &nothing,
		    sizeof nothing);
	c->size = sizeof nothing;
	if (!isnan(at[0]) && !isnan(at[1]) && !isnan(at[2]))
		widen((void *)c->out, at, at);
}

static void collect_box(const struct job *j, const struct chunk *c,
    long long first_line)
{
	const struct bounds *box = (const void *)c->out;

	(void)first_line;
	if (c->size > 0)
		widen(j->with, box->min, box->max);
}

static void read_box(const struct options *o, const struct document *d,
    struct job *j)
{
	struct bounds *box = j->with;

	*box = nothing;
	if (d->flat) {
		flat_transform(&d->scene, FLAT_NDC, FLAT_NDC, &j->transform);
	} else {
		map_identity(&j->transform.map);
		transform_init(&j->transform, SPACE_MODEL, SPACE_WORLD, false);
	}
	prepare_job(j, o);
	do_points(o, d, j);
	if (!(box->min[0] <= box->max[0]))
		document_refuse(d,
		    "/bounds: missing, and there are no points to "
		    "take them from");
}

/* why is of core/, and may be about /bounds. If those were taken from points,
 * the message is about the points. */
static _Noreturn void refuse_fit(const struct options *o,
    const struct document *d, const char *why)
{
	const char bounds[] = "/bounds: ";
	size_t n = strlen(bounds);

	if (d->has_bounds || strncmp(why, bounds, n) != 0)
		document_refuse(d, why);
	if (o->n_points == 0)
		die_at(EXIT_INPUT,
		    &(struct place){ .file = d->name, .pointer = "/points" },
		    "%s", why + n);
	bool typed = o->n_points > 1 || first_char(o->points[0]) == '[';

	die_at(EXIT_INPUT,
	    &(struct place){ .file = typed ? "POINTS" : o->points[0] }, "%s",
	    why + n);
}

#define OR_POINTS ", or points: a file, or - for standard input"

void run_fit(const struct command *c, const struct options *o)
{
	struct document d;
	static struct job j = { .take = take_into_box, .collect = collect_box };

	j.with = &d.bounds;
	read_document(c, o, &d);
	if (d.scene.answer != NULL)
		document_refuse(&d,
		    "/convention: is not that of -c; fit prints the scene in "
		    "its own, so leave -c out");
	if (d.has_bounds && o->n_points > 0)
		document_refuse(&d,
		    "/bounds: not together with POINTS; fit holds "
		    "the one or the other");
	if (!d.has_bounds && !has_points(o, &d))
		document_refuse(&d,
		    d.flat ? "/bounds: missing; add \"bounds\": "
			     "{\"min\": [-1,-1], \"max\": [1,1]}" OR_POINTS :
			     "/bounds: missing; add \"bounds\": "
			     "{\"min\": [-1,-1,-1], \"max\": "
			     "[1,1,1]}" OR_POINTS);
	if (!d.has_bounds)
		read_box(o, &d, &j);
	const char *why = d.flat ? fit_window(&d.scene, &d.bounds) :
				   fit_scene(&d.scene, d.has_eye, &d.bounds);

	if (why != NULL)
		refuse_fit(o, &d, why);
	print_scene(&d);
}
