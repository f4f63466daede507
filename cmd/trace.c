/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "json/print.h"
#include "call/operands.h"
#include "stream/block_write.h"
#include "message/message.h"

enum { SPACES = SPACE_DEVICE + 1, NAME_WIDTH = 8 };

struct trace {
	int n;                       /* spaces: without a viewport no device */
	struct transform to[SPACES]; /* from the one that points are given in */
	bool printed;                /* a point */
};

/* The image of point p; nan for a bad line. */
static void trace_carry(const struct job *j, const struct chunk *c,
    const struct transform *t, bool bad, size_t p, double image[4])
{
	/* kernels read and write whole vectors */
	COLUMN_ALIGNED double in[4][16] = { { 0 } }, out[4][16];
	const double *const from[4] = { in[0], in[1], in[2], in[3] };
	double *const to[4] = { out[0], out[1], out[2], out[3] };

	for (int k = 0; k < t->in; k++)
		in[k][0] = bad ? (double)NAN : c->in[k][p];
	points_carry(t, j->precision, from, to, 1);
	for (int k = 0; k < t->out; k++)
		image[k] = isfinite(out[k][0]) ? out[k][0] : (double)NAN;
}

/* Puts n numbers, between brackets in JSON; null for what has no image. */
static void trace_image(struct printer *p, const struct layout *l, int n,
    const double v[4])
{
	bool json = l->out.format == FORMAT_JSON, none = true;

	for (int k = 0; k < n; k++)
		none &= isnan(v[k]);
	if (json && none) {
		put_number(p, (double)NAN);
		return;
	}
	if (json)
		put_open(p, "[");
	for (int k = 0; k < n; k++) {
		p->style = l->style[k];
		if (json || !isnan(v[k])) {
			put_number(p, v[k]);
		} else {
			put_text(p, p->between);
			put_text(p, "nan");
		}
		if (!json)
			p->between = " ";
	}
	if (json)
		put_close(p, "]");
}

static void trace_space(struct printer *p, const struct layout *l,
    enum space space, int n, const double v[4])
{
	const char *name = space_names[space];

	if (l->out.format == FORMAT_JSON) {
		put_name(p, name);
		trace_image(p, l, n, v);
	} else if (n > 0) {
		put_text(p, name);
		for (size_t k = strlen(name); k < NAME_WIDTH; k++)
			put_text(p, " ");
		p->between = "";
		trace_image(p, l, n, v);
		put_text(p, "\n");
	}
}

/* The planes that the point is outside of and, in text, the rest of its line. */
static void trace_last(struct printer *p, const struct layout *l,
    const struct line *line, const struct word *word)
{
	bool json = l->out.format == FORMAT_JSON;

	if (json) {
		put_name(p, "flags");
		put_text(p, "\"");
	}
	memcpy(p->at, word->s, word->size);
	p->at += word->size;
	if (!json)
		p->at = line_rest(l, line, p->at);
	put_text(p, json ? "\"}\n" : "\n");
}

/* Appends what is to be printed of a point, in text after a blank line. */
static void trace_take(const struct job *j, struct chunk *c,
    const struct line *line, size_t p, size_t number)
{
	const struct trace *trace = j->with;
	const struct layout *l = &j->layout;
	bool bad = line_is_bad(line);
	double in[4] = { c->in[0][p], c->in[1][p], c->in[2][p], c->in[3][p] };
	const double *const at[4] = { &in[0], &in[1], &in[2], &in[3] };
	unsigned char outside = OUT_NAN;
	size_t most = SPACES * 4 * (NUMBER_MAX + 16) + 6 * (size_t)line->size;

	(void)number;
	if (!bad)
		frustum_out_all(&j->frustum, at, &outside, 1);
	if (line->kind == LINE_HEADER || (j->visible && outside != 0))
		return;
	struct printer print = { .at = chunk_reserve(c, most + WORD_MAX),
		.single = l->single,
		.compact = true,
		.between = "" };

	put_text(&print, l->out.format == FORMAT_JSON ? "{" : "\n");
	for (int s = 0; s < SPACES; s++) {
		int n = s < trace->n ? trace->to[s].out : 0;
		double image[4];

		if (n > 0)
			trace_carry(j, c, &trace->to[s], bad, p, image);
		trace_space(&print, l, (enum space)s, n, image);
	}
	trace_last(&print, l, line, word_for(c, outside));
	c->size = (size_t)(print.at - c->out);
}

/* The first point has no blank line before it. */
static void trace_collect(const struct job *j, const struct chunk *c,
    long long first_line)
{
	struct trace *trace = j->with;
	bool first = !trace->printed && j->layout.out.format == FORMAT_TEXT;

	(void)first_line;
	if (c->size == 0)
		return;
	put_all(c->out + first, c->size - first);
	trace->printed = true;
}

void run_trace(const struct command *c, const struct options *o)
{
	enum space from = o->has_from ? o->from : SPACE_MODEL;
	static struct trace trace;
	static struct job j = { .take = trace_take,
		.collect = trace_collect,
		.with = &trace };
	struct document d;

	read_document(c, o, &d);
	trace.printed = false;
	trace.n = d.scene.has_viewport || from == SPACE_DEVICE ? SPACES :
								 SPACES - 1;
	for (int s = 0; s < trace.n; s++)
		document_check(&d,
		    scene_transform(&d.scene, from, (enum space)s, false,
			&trace.to[s]));
	document_check(&d, frustum_of(&d.scene, from, false, &j.frustum));
	j.transform = trace.to[SPACE_CLIP];
	prepare_job(&j, o);
	do_points(o, &d, &j);
}
