/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../core/derive/picture.h"
#include "../core/points/distance.h"
#include "../core/points/points.h"
#include "call/notes.h"
#include "call/operands.h"
#include "call/option_row.h"
#include "json/print.h"
#include "message/message.h"

enum { SPACES = SPACE_DEVICE + 1, BATCH = NUMBER_BATCH };

struct trace {
	int n_spaces;                /* 6, or 5 without a viewport */
	struct transform to[SPACES]; /* from the points' space to each space */
	char label[2][SPACES][16];   /* before the image in a space: text, JSON */
	char axes[8 * NUMBER_MAX];   /* the end of each JSON object, with gaze and up */
	bool printed;                /* a point was printed */
};

struct images {
	COLUMN_ALIGNED double v[SPACES][4][BATCH];
	struct number_text text[SPACES][4][BATCH];
	unsigned char outside[BATCH];
};

static void images_transform(struct images *m, const struct job *j,
    const struct chunk *c, size_t p, size_t n)
{
	const struct trace *trace = j->data;
	const double *const from[4] = { &c->in[0][p], &c->in[1][p], &c->in[2][p],
		&c->in[3][p] };

	for (int s = 0; s < trace->n_spaces; s++) {
		double(*v)[BATCH] = m->v[s];
		double *const to[4] = { v[0], v[1], v[2], v[3] };

		points_map(&trace->to[s], j->precision, from, to, n);
		for (int k = 0; k < trace->to[s].out; k++)
			number_texts(v[k], n, j->layout.output.single,
			    j->layout.output.style[k], m->text[s][k]);
	}
	frustum_outside_all(&j->frustum, from, m->outside, n);
}

/* Returns the end of an image. A number beyond the range, and each if m is NULL,
 * becomes nan or, in JSON, null. An array of only nulls becomes null. */
static char *trace_put_image(char *at, const struct job *j, const struct images *m,
    int s, size_t p)
{
	const struct layout *l = &j->layout;
	int n = ((const struct trace *)j->data)->to[s].out, finite = 0;
	bool json = l->out.format == FORMAT_JSON;

	for (int k = 0; m != NULL && k < n; k++)
		finite += isfinite(m->v[s][k][p]) != 0;
	if (json && finite == 0)
		return stpcpy(at, "null");
	if (json)
		*at++ = '[';
	for (int k = 0; k < n; k++) {
		if (k > 0)
			*at++ = json ? ',' : ' ';
		if (finite < n && (m == NULL || !isfinite(m->v[s][k][p])))
			at = stpcpy(at, json ? "null" : "nan");
		else
			at = number_text_put(at, &m->text[s][k][p], m->v[s][k][p],
			    l->output.single, l->output.style[k]);
	}
	if (json)
		*at++ = ']';
	return at;
}

/* Appends the images of point p of m; of a bad line, whose m is NULL, nan or null. */
static void trace_put_point(const struct job *j, struct chunk *c,
    const struct images *m, size_t p)
{
	const struct trace *trace = j->data;
	unsigned outside = m != NULL ? m->outside[p] : OUT_NAN;
	const struct flags *word = flags_word(&c->words, outside);
	bool json = j->layout.out.format == FORMAT_JSON;
	char *at;

	if (j->visible && outside != 0)
		return;
	at = chunk_reserve(c,
	    SPACES * 4 * (NUMBER_MAX + 16) + sizeof trace->axes + FLAG_MAX + 16);
	*at++ = json ? '{' : '\n';
	for (int s = 0; s < (json ? SPACES : trace->n_spaces); s++) {
		at = trace_put_image(stpcpy(at, trace->label[json][s]), j,
		    s < trace->n_spaces ? m : NULL, s, p);
		*at++ = json ? ',' : '\n';
	}
	if (json)
		at = stpcpy(at, "\"flags\":\"");
	memcpy(at, word->s, word->size);
	at += word->size;
	at = stpcpy(stpcpy(at, json ? trace->axes : ""), "\n");
	c->size = (size_t)(at - c->out);
}

static void trace_take_block(const struct job *j, struct chunk *c)
{
	/* too large for a thread's stack */
	struct images *m = aligned_alloc(_Alignof(struct images), sizeof *m);

	if (m == NULL)
		die(EXIT_SYSTEM, "out of memory", NULL);
	else /* vector loops read beyond the last point */
		memset(m->v, 0, sizeof m->v);
	for (size_t i = 0, p = 0; i < c->block_lines; i++) {
		const struct line *line = &c->line[i];

		if (line_is_bad(line))
			trace_put_point(j, c, NULL, 0);
		if (line->kind != LINE_POINT)
			continue;
		if (p % BATCH == 0)
			images_transform(m, j, c, p,
			    c->block_points - p < BATCH ? c->block_points - p : BATCH);
		trace_put_point(j, c, m, p++ % BATCH);
	}
	free(m);
}

/* Leaves out the blank line before the very first point. */
static void trace_collect_chunk(const struct job *j, const struct chunk *c)
{
	struct trace *trace = j->data;
	bool first = !trace->printed && j->layout.out.format == FORMAT_TEXT;

	if (c->size == 0)
		return;
	output_write(c->out + first, c->size - first);
	trace->printed = true;
}

/* Writes what follows the flags in JSON: where the gaze and the camera's up point in
 * the world. */
static void trace_set_axes(const struct options *o, const struct scene *s,
    struct trace *trace)
{
	struct printer p = { .at = trace->axes,
		.compact = true,
		.style = options_style(o, 0),
		.floats = o->precision == PRECISION_SINGLE,
		.separator = "," };
	double gaze[3], up[3];

	picture_axes(s, gaze, up);
	put_text(&p, "\"");
	put_numbers(put_name(&p, "gaze"), gaze, 3);
	put_numbers(put_name(&p, "up"), up, 3);
	put_text(&p, "}");
	*p.at = '\0';
}

static bool run_trace(const struct options *o, struct document *d, struct job *j)
{
	static struct trace trace;
	struct refusals *const faults = d->source.faults;

	j->take_block = trace_take_block;
	j->collect_chunk = trace_collect_chunk;
	j->data = &trace;
	trace.printed = false;
	trace.n_spaces = SPACES - (!d->scene.has_viewport && o->from != SPACE_DEVICE);
	for (int s = 0; s < trace.n_spaces; s++)
		if (!distance_transform(&d->scene, o->from, (enum space)s, &trace.to[s],
			faults))
			return false;
	if (!frustum_of(&d->scene, o->from, false, &j->frustum, faults))
		return false;
	j->transform = trace.to[SPACE_CLIP];
	for (int s = 0; s < SPACES; s++) {
		snprintf(trace.label[false][s], sizeof **trace.label, "%-8s",
		    space_names[s]);
		snprintf(trace.label[true][s], sizeof **trace.label,
		    "\"%s\":", space_names[s]);
	}
	j->layout.from = space_names[o->from];
	/* without -o the points' format, which is not known yet, is the output's */
	if (!o->has_out || o->out == FORMAT_JSON)
		trace_set_axes(o, &d->scene, &trace);
	notes_say_of_spaces(d, SPACE_MODEL,
	    d->scene.has_viewport ? SPACE_DEVICE : SPACE_NDC);
	return operands_run_job(o, d, o->from, SPACE_NDC, j);
}

static void judge_trace(const struct options *o, const struct document *d)
{
	scene_check(&d->scene, o->from, SPACE_DEVICE, d->source.faults);
	scene_check(&d->scene, o->from, SPACE_MODEL, d->source.faults);
}

const struct work trace_work = { run_trace, judge_trace, NULL, NULL };
