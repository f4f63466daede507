/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../core/derive/pick.h"
#include "json/print.h"
#include "call/operands.h"
#include "message/message.h"

/* A point that was hit, or a csv header, whose distance is -infinity; and where in
 * the text of hits stands what is printed of it. */
struct hit {
	double distance, point[4];
	long long line;
	size_t at, size;
};

struct hits {
	struct number_style style;
	struct picker picker;
	bool json;
	bool near; /* the near plane is not at infinity */
	struct hit *hit;
	size_t n, room;
	char *text;
	size_t size, text_room;
};

/* Appends a hit, and behind it what is printed of it: its line or, in JSON, what
 * follows the line's number. */
static void hits_append(const struct job *j, struct chunk *c, struct hit hit,
    const struct line *line, const double device[3])
{
	const struct hits *h = j->with;
	char *at = chunk_reserve(c,
	    sizeof hit + line->size + 8 * NUMBER_MAX + 128);
	char *const text = at + sizeof hit;
	struct printer p = { .at = text,
		.style = h->style,
		.compact = true,
		.between = "" };

	if (h->json) {
		put_name(&p, "distance");
		put_number(&p, hit.distance);
		put_name(&p, "device");
		put_numbers(&p, device, 3);
		put_name(&p, "point");
		put_numbers(&p, hit.point, 3);
		put_text(&p, "}\n");
	} else {
		memcpy(p.at, line->s, line->size);
		p.at += line->size;
		*p.at = '\n';
		p.at += !is_binary(j->layout.in.format);
	}
	hit.size = (size_t)(p.at - text);
	memcpy(at, &hit, sizeof hit);
	c->size += sizeof hit + hit.size;
}

/* Appends the points of a block that are hit, and its headers. */
static void hits_take(const struct job *j, struct chunk *c)
{
	const struct hits *h = j->with;
	size_t points = c->block_points;
	const double *const in[4] = { c->in[0], c->in[1], c->in[2] };
	double(*v)[POINTS_BLOCK] = c->image;
	double *const device[4] = { v[0], v[1], v[2] };
	double *const view[4] = { v[3], v[4], v[5] };
	unsigned char outside[POINTS_BLOCK];
	bool known = false; /* outside, and view where that is finite */

	points_carry(&j->transform, j->precision, in, device, points);
	for (size_t i = 0, p = 0; i < c->block_lines; i++) {
		const struct line *line = &c->line[i];
		size_t at = p, number = c->n_lines + i;

		if (line->kind == LINE_HEADER && !h->json)
			hits_append(j, c,
			    (struct hit){ .distance = (double)-INFINITY }, line,
			    NULL);
		if (line->kind != LINE_POINT)
			continue;
		p++;
		const double to[3] = { v[0][at], v[1][at], v[2][at] };
		struct hit hit = { .point = { in[0][at], in[1][at], in[2][at],
				       1 },
			.line = (long long)number };

		if (isnan(to[0]) || isnan(to[1]) ||
		    !pick_holds(&h->picker, hit.point, to))
			continue;
		if (!known) {
			frustum_out_all(&j->frustum, in, outside, points);
			if (h->near)
				points_carry(&h->picker.depth, PRECISION_EXACT,
				    in, view, points);
			known = true;
		}
		if (outside[at] != 0)
			continue;
		hit.distance = h->near ? v[5][at] : (double)INFINITY;
		if (isnan(hit.distance))
			hit.distance = pick_distance(&h->picker, hit.point);
		hits_append(j, c, hit, line, to);
	}
}

static void hits_collect(const struct job *j, const struct chunk *c,
    long long first_line)
{
	struct hits *h = j->with;
	struct hit hit;

	if (h->size + c->size > h->text_room) {
		h->text_room = h->text_room / 2 + h->size + c->size;
		h->text = need(h->text, h->text_room);
	}
	for (size_t at = 0; at < c->size; at += sizeof hit + hit.size) {
		memcpy(&hit, c->out + at, sizeof hit);
		memcpy(h->text + h->size, c->out + at + sizeof hit, hit.size);
		hit.line += first_line;
		hit.at = h->size;
		h->size += hit.size;
		if (h->n == h->room) {
			h->room += h->room / 2 + 64;
			h->hit = need(h->hit, h->room * sizeof *h->hit);
		}
		h->hit[h->n++] = hit;
	}
}

static bool is_header(const struct hit *hit)
{
	return hit->distance < -DBL_MAX;
}

static int hit_compare(const void *a, const void *b)
{
	const struct hit *p = a, *q = b;

	if (p->distance < q->distance || p->distance > q->distance)
		return p->distance < q->distance ? -1 : 1;
	return p->at < q->at ? -1 : p->at > q->at;
}

/* For qsort, which hands nothing on. */
static const struct picker *comparing;

/* The same of distances whose nearest doubles are equal. */
static int hit_compare_exactly(const void *a, const void *b)
{
	const struct hit *p = a, *q = b;
	int order = pick_compare(comparing, p->point, q->point);

	return order != 0 ? order : hit_compare(a, b);
}

/* Sorts the nearest first, then as they came. Exact distances are compared only
 * where their nearest doubles are equal; most often they are equal then, too, and
 * stay in their order. */
static void hits_sort(const struct hits *h)
{
	struct hit *const hit = h->hit;
	size_t end;

	if (h->n == 0)
		return;
	comparing = &h->picker;
	qsort(hit, h->n, sizeof *hit, hit_compare);
	for (size_t i = 0; i < h->n; i = end) {
		bool sorted = true;

		for (end = i + 1;
		     end < h->n && hit[end].distance == hit[i].distance; end++)
			sorted = sorted &&
			    (is_header(&hit[i]) ||
				hit_compare_exactly(&hit[end - 1], &hit[end]) <
				    0);
		if (!sorted)
			qsort(hit + i, end - i, sizeof *hit,
			    hit_compare_exactly);
	}
}

/* Returns the hits that are printed from: of several sources one header is enough,
 * and none if they differ. */
static size_t hits_headers(const struct hits *h)
{
	size_t n = 0;
	bool differ = false;

	for (; n < h->n && is_header(&h->hit[n]); n++)
		differ |= h->hit[n].size != h->hit[0].size ||
		    memcmp(h->text + h->hit[n].at, h->text + h->hit[0].at,
			h->hit[0].size) != 0;
	return differ || n == 0 ? n : n - 1;
}

static void print_hits(const struct job *j)
{
	const size_t line_max = 40;
	struct hits *h = j->with;
	char *const out = need(NULL, h->size + h->n * line_max), *at = out;

	hits_sort(h);
	for (size_t i = hits_headers(h); i < h->n; i++) {
		const struct hit *hit = &h->hit[i];

		if (h->json)
			at += sprintf(at, "{\"line\":%lld,", hit->line);
		memcpy(at, h->text + hit->at, hit->size);
		at += hit->size;
	}
	put_all(out, (size_t)(at - out));
	free(out);
}

/* Options win over the document's member "pick". */
static void aim(const struct document *d, const struct options *o,
    struct hits *h)
{
	const struct pick *p = &d->pick;

	if (o->pick_at.n == 0 && !p->has_at)
		document_refuse(d,
		    "/pick/at: missing; say where on the device "
		    "with \"at\": [x, y] or --at X,Y");
	if (!(o->radius > 0) && !(p->radius > 0))
		document_refuse(d,
		    "/pick/radius: missing; say how far around "
		    "with \"radius\" or --radius R");
	for (int i = 0; i < 2; i++)
		h->picker.at[i] = o->pick_at.n > 0 ? o->pick_at.v[i] : p->at[i];
	h->picker.radius = o->radius > 0 ? o->radius : p->radius;
}

void run_pick(const struct command *c, const struct options *o)
{
	struct document d;
	static struct hits hits;
	static struct job j = { .take = hits_take,
		.collect = hits_collect,
		.flush = print_hits,
		.with = &hits };

	hits.json = o->has_out && o->out == FORMAT_JSON;
	hits.style = one_style(o);
	hits.n = hits.size = 0;
	read_document(c, o, &d);
	aim(&d, o, &hits);
	document_check(&d,
	    scene_transform(&d.scene, SPACE_MODEL, SPACE_DEVICE, false,
		&j.transform));
	document_check(&d,
	    frustum_of(&d.scene, SPACE_MODEL, false, &j.frustum));
	document_check(&d, picker_of(&d.scene, &j.transform, &hits.picker));
	if (o->has_out && !hits.json &&
	    (o->out != o->in || o->out_record != o->in_record))
		die(EXIT_USAGE,
		    "pick prints lines as they were read, or "
		    "-o json");
	hits.near = sum_sign(hits.picker.depth.map.divisor) != 0;
	prepare_job(&j, o);
	do_points(o, &d, &j);
}
