/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../core/derive/pick.h"
#include "../core/points/points.h"
#include "json/print.h"
#include "call/notes.h"
#include "call/operands.h"
#include "call/option_row.h"
#include "message/grow.h"
#include "message/message.h"

/* A point within the radius, with the text that is printed for it. A csv header is a
 * hit, too, with a distance of -infinity, which makes it the first hit. */
struct hit {
	double distance, point[4];
	long long line;
	size_t size;
	char text[]; /* the output; in JSON without {"line":NUMBER, */
};

struct hits {
	struct number_style style;
	struct picker picker;
	bool json;
	bool finite_near; /* the near plane is not at infinity */
	size_t n;
	char *buffer; /* the hits, one after another */
	size_t size;
};

/* Returns the bytes from a hit with `size` bytes of text to the next. */
static size_t hit_stride(size_t size)
{
	const size_t unit = _Alignof(struct hit);

	return (sizeof(struct hit) + size + unit - 1) / unit * unit;
}

static struct hit *hit_at(char *buffer, size_t at)
{
	return (void *)(buffer + at);
}

/* Appends a hit and its text: the line of input or, in JSON, all but {"line":NUMBER, */
static void hits_append(const struct job *j, struct chunk *c, struct hit hit,
    const struct line *line, const double device[3])
{
	const struct hits *h = j->data;
	char *at = chunk_reserve(c, hit_stride(line->size + 8 * NUMBER_MAX + 128));
	char *const text = hit_at(at, 0)->text;
	struct printer p = { .at = text, .style = h->style, .compact = true };

	if (h->json) {
		put_number(put_name(&p, "distance"), hit.distance);
		put_numbers(put_name(&p, "device"), device, 3);
		put_numbers(put_name(&p, "point"), hit.point, 3);
		put_text(&p, "}\n");
	} else {
		memcpy(p.at, line->s, line->size);
		p.at += line->size;
		*p.at = '\n';
		p.at += !format_is_binary(j->layout.in.format);
	}
	hit.size = (size_t)(p.at - text);
	memcpy(at, &hit, offsetof(struct hit, text));
	c->size += hit_stride(hit.size);
}

static void hits_take_block(const struct job *j, struct chunk *c)
{
	const struct hits *h = j->data;
	size_t points = c->block_points;
	const double *const in[4] = { c->in[0], c->in[1], c->in[2] };
	double(*v)[POINTS_BLOCK] = c->image;
	double *const device[4] = { v[0], v[1], v[2] };
	double *const view[4] = { v[3], v[4], v[5] };
	unsigned char outside[POINTS_BLOCK];
	bool computed = false; /* outside is set; if finite_near, view, too */

	points_map(&j->transform, j->precision, in, device, points);
	for (size_t i = 0, p = 0; i < c->block_lines; i++) {
		const struct line *line = &c->line[i];

		if (line->kind == LINE_HEADER && !h->json)
			hits_append(j, c, (struct hit){ .distance = (double)-INFINITY },
			    line, NULL);
		if (line->kind != LINE_POINT)
			continue;
		const size_t at = p++;
		const double to[3] = { v[0][at], v[1][at], v[2][at] };
		struct hit hit = { .point = { in[0][at], in[1][at], in[2][at], 1 },
			.line = (long long)(c->n_lines + i) };

		if (isnan(to[0]) || isnan(to[1]) ||
		    !pick_is_within(&h->picker, hit.point, to))
			continue;
		if (!computed) {
			frustum_outside_all(&j->frustum, in, outside, points);
			if (h->finite_near)
				points_map(&h->picker.depth, PRECISION_EXACT, in, view,
				    points);
			computed = true;
		}
		if (outside[at] != 0)
			continue;
		hit.distance = h->finite_near ? v[5][at] : (double)INFINITY;
		if (isnan(hit.distance))
			hit.distance = pick_distance(&h->picker, hit.point);
		hits_append(j, c, hit, line, to);
	}
}

static void hits_collect_chunk(const struct job *j, const struct chunk *c)
{
	struct hits *h = j->data;
	const size_t end = h->size + c->size;

	GROW(h->buffer, h->size, c->size);
	if (c->size > 0)
		memcpy(h->buffer + h->size, c->out, c->size);
	for (; h->size < end; h->n++) {
		struct hit *hit = hit_at(h->buffer, h->size);

		hit->line = chunk_line(c, (size_t)hit->line);
		h->size += hit_stride(hit->size);
	}
}

static bool hit_is_header(const struct hit *hit)
{
	return hit->distance < -DBL_MAX;
}

/* The picker for hit_compare; NULL: exact distances are not compared. */
static const struct picker *hit_picker;

/* Hits of one distance are in the order of addresses, which is that of the input. */
static int hit_compare(const void *a, const void *b)
{
	const struct hit *p = *(struct hit *const *)a;
	const struct hit *q = *(struct hit *const *)b;
	int order = (p->distance > q->distance) - (p->distance < q->distance);

	if (order == 0 && hit_picker != NULL && !hit_is_header(p))
		order = pick_compare(hit_picker, p->point, q->point);
	return order != 0 ? order : (p > q) - (p < q);
}

/* Sorts by the doubles of distances, then runs of equal doubles by exact distances. */
static void hits_sort(const struct picker *picker, struct hit **hit, size_t n)
{
	hit_picker = NULL;
	qsort(hit, n, sizeof *hit, hit_compare);
	hit_picker = picker;
	for (size_t i = 0, end; i < n; i = end) {
		bool sorted = true;

		for (end = i + 1; end < n && hit[end]->distance == hit[i]->distance;
		     end++)
			sorted = sorted && hit_compare(&hit[end - 1], &hit[end]) < 0;
		if (!sorted)
			qsort(hit + i, end - i, sizeof *hit, hit_compare);
	}
}

static void print_hits(const struct job *j)
{
	struct hits *h = j->data;
	/* h->size is enough: struct hit without text is larger than {"line":NUMBER, */
	char *const out = xrealloc(NULL, h->size), *at = out;
	struct hit **hit = xrealloc(NULL, (h->n + 1) * sizeof(struct hit *));

	for (size_t i = 0, size = 0; i < h->n; size += hit_stride(hit[i++]->size))
		hit[i] = hit_at(h->buffer, size);
	hits_sort(&h->picker, hit, h->n);
	for (size_t i = 0; i < h->n; i++) {
		if (h->json)
			at += sprintf(at, "{\"line\":%lld,", hit[i]->line);
		memcpy(at, hit[i]->text, hit[i]->size);
		at += hit[i]->size;
	}
	output_write(out, (size_t)(at - out));
	free(hit);
	free(out);
}

/* Refuses a circle that neither the call nor the scene gives. One that the scene gives
 * wrongly is told already, and NaN. */
static bool check_circle(const struct document *d, const struct options *o)
{
	const struct pick *p = &d->pick;
	bool is_right = true;

	if (!d->has_pick && (d->present & SCENE_PICK) != 0)
		return false; /* an unknown member may mean it */
	if (o->pick_at.n == 0 && !p->has_at && !isnan(p->at[0]))
		is_right = document_refuse(d, "/pick/at", "missing",
		    "give --at X,Y and --radius R, or in the scene "
		    "\"pick\": " PICK_EXAMPLE);
	if (o->radius.n == 0 && p->radius == 0)
		is_right = document_refuse(d, "/pick/radius", "missing",
		    "give --radius R, or in the scene \"pick\": " PICK_EXAMPLE);
	return is_right;
}

static bool hits_set_circle(const struct document *d, const struct options *o,
    struct hits *h)
{
	const struct pick *p = &d->pick;

	if (!check_circle(d, o))
		return false;
	for (int i = 0; i < 2; i++)
		h->picker.at[i] = o->pick_at.n > 0 ? o->pick_at.v[i] : p->at[i];
	h->picker.radius = o->radius.n > 0 ? *o->radius.v : p->radius;
	return true;
}

static void check_pick(const struct options *o)
{
	options_matrix_style(o);
	if (o->has_out && o->out != FORMAT_JSON && o->in != FORMAT_SNIFF &&
	    (o->out != o->in || o->out_record != o->in_record))
		die(EXIT_USAGE, "pick prints the lines that it read",
		    "leave -o out, or say -o json");
}

static bool run_pick(const struct options *o, struct document *d, struct job *j)
{
	static struct hits hits;
	const struct scene *s = &d->scene;
	struct refusals *const faults = d->source.faults;

	j->take_block = hits_take_block;
	j->collect_chunk = hits_collect_chunk;
	j->flush = print_hits;
	j->data = &hits;
	hits.json = o->has_out && o->out == FORMAT_JSON;
	hits.style = options_matrix_style(o);
	hits.n = hits.size = 0;
	if (!hits_set_circle(d, o, &hits) ||
	    !transform_of_scene(s, SPACE_MODEL, SPACE_DEVICE, false, &j->transform,
		faults) ||
	    !frustum_of(s, SPACE_MODEL, false, &j->frustum, faults) ||
	    !picker_of(s, &j->transform, &hits.picker, faults))
		return false;
	hits.finite_near = sum_sign(hits.picker.depth.map.divisor) != 0;
	j->layout.from = space_names[SPACE_MODEL];
	notes_say_of_spaces(d, SPACE_MODEL, SPACE_DEVICE);
	return operands_run_job(o, d, SPACE_MODEL, SPACE_DEVICE, j);
}

static void judge_pick(const struct options *o, const struct document *d)
{
	check_circle(d, o);
	scene_check(&d->scene, SPACE_MODEL, SPACE_DEVICE, d->source.faults);
}

const struct work pick_work = { run_pick, judge_pick, check_pick, NULL };
