/* SPDX-License-Identifier: MIT */
#include "lines.h"

#include <string.h>

#include "../../core/derive/clip.h"
#include "runs.h"

enum { LINES_ROWS = 8 * NUMBER_BATCH };

/* The rows that are not printed yet, and what their run needs. */
struct lines {
	struct run_reader reader;
	struct clipper clipper;
	struct clip_ring ring;
	struct clip_vertex end[2], cut[2];
	const struct output *output;
	const struct run *run;

	bool any;    /* a part was printed before */
	bool begins; /* the next row that is put begins a part */
	/* The rows with which a part begins are held while they are alike: a part of
	 * one point is not printed. */
	size_t held;
	double held_image[4];
	size_t n;                /* rows that are put */
	bool parted[LINES_ROWS]; /* a blank line stands above the row */
	double image[4][LINES_ROWS];

	/* of a polygon that is cut: the image of its part's first vertex */
	double first[4];
	bool has_first;
};

static char *write_row(const struct lines *l, size_t row,
    struct number_text (*t)[NUMBER_BATCH], char *out)
{
	const int last = l->clipper.out - 1;

	if (l->parted[row])
		*out++ = '\n';
	for (int k = 0; k <= last; k++) {
		out = number_text_put(out, &t[k][row % NUMBER_BATCH], l->image[k][row],
		    l->output->single, l->output->style[k]);
		*out++ = k < last ? ' ' : '\n';
	}
	return out;
}

static void print_rows(void *data)
{
	enum { ROW_ROOM = 4 * (NUMBER_MAX + 1) + 1 };
	static struct number_text t[4][NUMBER_BATCH];
	static char text[NUMBER_BATCH * ROW_ROOM];
	struct lines *l = data;

	for (size_t from = 0; from < l->n; from += NUMBER_BATCH) {
		const size_t left = l->n - from;
		const size_t n = left < NUMBER_BATCH ? left : NUMBER_BATCH;
		char *at = text;

		for (int k = 0; k < l->clipper.out; k++)
			number_texts(&l->image[k][from], n, l->output->single,
			    l->output->style[k], t[k]);
		for (size_t i = from; i < from + n; i++)
			at = write_row(l, i, t, at);
		output_write(text, (size_t)(at - text));
	}
	l->n = 0;
}

static void keep_row(struct lines *l, const double image[4])
{
	if (l->n == LINES_ROWS)
		print_rows(l);
	for (int k = 0; k < l->clipper.out; k++)
		l->image[k][l->n] = image[k];
	l->parted[l->n++] = l->begins && l->any;
	l->any = true;
	l->begins = false;
}

static void begin_part(struct lines *l)
{
	l->begins = true;
	l->held = 0;
}

static void put_held(struct lines *l)
{
	for (; l->held > 0; l->held--)
		keep_row(l, l->held_image);
}

static bool is_held(const struct lines *l, const double image[4])
{
	for (int k = 0; k < l->clipper.out; k++)
		if (image[k] != l->held_image[k])
			return false;
	return true;
}

/* Adds a row to the part. */
static void add_row(struct lines *l, const double image[4])
{
	if (l->begins && l->held == 0)
		memcpy(l->held_image, image, sizeof l->held_image);
	if (l->begins && is_held(l, image)) {
		l->held++;
		return;
	}
	put_held(l);
	keep_row(l, image);
}

/* Returns point i of the run as a vertex. Neighbours have one each, so that segments
 * that follow one another share what they compute. */
static struct clip_vertex *end_at(struct lines *l, size_t i)
{
	struct clip_vertex *v = &l->end[i % 2];
	const struct run_point *p = &l->run->point[i];

	if (v->index != i)
		clip_vertex_set(v, &l->clipper, p->in, i, p->outside);
	return v;
}

/* Finds the part of the segment from point i to the next. Returns false if there is
 * none; else sets cut[0] and cut[1] to whether its ends are cut off, and the images of
 * the ends. */
static bool find_part(struct lines *l, size_t i, bool cut[2], double image[2][4])
{
	const struct run_point *p = &l->run->point[i], *q = p + 1;

	memcpy(image[0], p->image, sizeof image[0]);
	memcpy(image[1], q->image, sizeof image[1]);
	cut[0] = cut[1] = false;
	if ((p->outside | q->outside) == 0)
		return true;
	if ((p->outside & q->outside) != 0)
		return false;
	if (!clip_segment(&l->clipper, end_at(l, i), end_at(l, i + 1), l->cut))
		return false;
	for (int k = 0; k < 2; k++) {
		cut[k] = l->cut[k].cut;
		if (cut[k])
			clip_image(&l->clipper, &l->cut[k], l->output->single,
			    image[k]);
	}
	return true;
}

static void take_polyline(struct lines *l)
{
	const struct run_point *p = l->run->point;
	bool goes_on = false, cut[2]; /* the part has come to point i */
	double image[2][4];

	l->end[0].index = l->end[1].index = SIZE_MAX;
	if (l->run->n == 1 && p[0].outside == 0)
		add_row(l, p[0].image);
	for (size_t i = 0; i + 1 < l->run->n; i++) {
		if (!find_part(l, i, cut, image)) {
			goes_on = false;
			continue;
		}
		if (!goes_on) {
			begin_part(l);
			add_row(l, image[0]);
		}
		add_row(l, image[1]);
		goes_on = !cut[1];
	}
}

/* Takes a vertex of the part of the polygon. */
static void take_vertex(void *data, struct clip_vertex *v)
{
	struct lines *l = data;
	double image[4];

	if (v->cut)
		clip_image(&l->clipper, v, l->output->single, image);
	else
		memcpy(image, l->run->point[v->index].image, sizeof image);
	if (!l->has_first)
		memcpy(l->first, image, sizeof image);
	l->has_first = true;
	add_row(l, image);
}

static void take_polygon(struct lines *l)
{
	const struct run_point *p = l->run->point;
	unsigned some = 0, all = ~0u;

	for (size_t i = 0; i < l->run->n; i++) {
		some |= p[i].outside;
		all &= p[i].outside;
	}
	if (all != 0)
		return;
	if (some == 0) {
		for (size_t i = 0; i < l->run->n; i++)
			add_row(l, p[i].image);
		return;
	}
	l->has_first = false;
	clip_ring_begin(&l->ring, &l->clipper, take_vertex, l);
	for (size_t i = 0; i + 1 < l->run->n; i++)
		clip_ring_add(&l->ring, p[i].in, i, p[i].outside);
	clip_ring_end(&l->ring);
	if (l->has_first)
		add_row(l, l->first);
}

static bool is_closed(const struct lines *l)
{
	const struct run_point *p = &l->run->point[0],
			       *q = &l->run->point[l->run->n - 1];

	for (int k = 0; k < l->clipper.in; k++)
		if (p->in[k] != q->in[k])
			return false;
	return l->run->n > 3;
}

static void take_run(void *data, const struct run *run)
{
	struct lines *l = data;

	l->run = run;
	begin_part(l);
	if (is_closed(l))
		take_polygon(l);
	else
		take_polyline(l);
	/* all points of the run are visible, and have one image */
	if (l->held == run->n)
		put_held(l);
}

bool lines_prepare(const struct scene *s, enum space from, enum space to, struct job *j,
    struct refusals *faults)
{
	static struct lines l;

	if (!clipper_of(s, from, to, &j->transform, &j->frustum, &l.clipper, faults))
		return false;
	l.output = &j->layout.output;
	l.reader.take = take_run;
	l.reader.flush = print_rows;
	l.reader.data = &l;
	runs_prepare(&l.reader, j);
	return true;
}
