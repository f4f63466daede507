/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../core/derive/frustum.h"
#include "json/print.h"
#include "call/operands.h"
#include "message/message.h"

/* A point within the radius, with what is printed of it. A csv header is a hit, too, at
 * the distance -infinity, which puts it first. */
struct hit {
	double distance, point[4];
	long long line;
	size_t size;
	char text
	    []; /* what is printed; in JSON what follows the line's number */
};

/* The sort key of a hit: its distance, then its offset in the text. */
struct hit_key {
	double distance;
	size_t at;
};

struct hits {
	struct number_style style;
	struct picker picker;
	bool json;
	bool finite_near; /* the near plane is not at infinity */
	struct hit_key *key;
	size_t n, room;
	char *text; /* struct hit after struct hit */
	size_t size, text_room;
};

/* Returns the bytes of a hit with size bytes of text, to the next aligned hit. */
static size_t hit_stride(size_t size)
{
	const size_t unit = _Alignof(struct hit);

	return (sizeof(struct hit) + size + unit - 1) / unit * unit;
}

static struct hit *hit_at(char *text, size_t at)
{
	return (void *)(text + at);
}

/* Appends a hit with what is printed of it: the line or, for JSON, an object. */
static void hits_append(const struct job *j, struct chunk *c, struct hit hit,
    const struct line *line, const double device[3])
{
	const struct hits *h = j->with;
	char *at = chunk_reserve(c,
	    hit_stride(line->size + 8 * NUMBER_MAX + 128));
	char *const text = hit_at(at, 0)->text;
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
	*hit_at(at, 0) = hit;
	c->size += hit_stride(hit.size);
}

/* Appends the points of a block that are within the radius, and its csv headers. */
static void hits_take(const struct job *j, struct chunk *c)
{
	const struct hits *h = j->with;
	size_t points = c->block_points;
	const double *const in[4] = { c->in[0], c->in[1], c->in[2] };
	double(*v)[POINTS_BLOCK] = c->image;
	double *const device[4] = { v[0], v[1], v[2] };
	double *const view[4] = { v[3], v[4], v[5] };
	unsigned char outside[POINTS_BLOCK];
	bool computed = false; /* outside and, if finite_near is set, view */

	points_map(&j->transform, j->precision, in, device, points);
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
		if (!computed) {
			frustum_out_all(&j->frustum, in, outside, points);
			if (h->finite_near)
				points_map(&h->picker.depth, PRECISION_EXACT,
				    in, view, points);
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

static void hits_collect(const struct job *j, const struct chunk *c)
{
	struct hits *h = j->with;
	const size_t end = h->size + c->size;

	if (end > h->text_room) {
		h->text_room = h->text_room / 2 + end;
		h->text = xrealloc(h->text, h->text_room);
	}
	if (c->size > 0)
		memcpy(h->text + h->size, c->out, c->size);
	while (h->size < end) {
		struct hit *hit = hit_at(h->text, h->size);

		hit->line += c->place.line;
		if (h->n == h->room) {
			h->room += h->room / 2 + 64;
			h->key = xrealloc(h->key, h->room * sizeof *h->key);
		}
		h->key[h->n++] = (struct hit_key){ hit->distance, h->size };
		h->size += hit_stride(hit->size);
	}
}

static bool is_header(const struct hit_key *key)
{
	return key->distance < -DBL_MAX;
}

/* The hits whose exact distances hit_compare compares; NULL: it compares the nearest
 * doubles. A variable, as qsort passes no argument on. */
static const struct hits *exact_of;

static int hit_compare(const void *a, const void *b)
{
	const struct hit_key *p = a, *q = b;
	int order = exact_of == NULL ?
	    (p->distance > q->distance) - (p->distance < q->distance) :
	    pick_compare(&exact_of->picker,
		hit_at(exact_of->text, p->at)->point,
		hit_at(exact_of->text, q->at)->point);

	return order != 0 ? order : (p->at > q->at) - (p->at < q->at);
}

/* Sorts the nearest first; hits at one distance keep the order of the input. Exact
 * distances are compared only where their nearest doubles are equal: most often the
 * exact distances are equal, too, and the hits are in their order already. */
static void hits_sort(const struct hits *h)
{
	struct hit_key *const key = h->key;
	size_t end;

	if (h->n == 0)
		return;
	exact_of = NULL;
	qsort(key, h->n, sizeof *key, hit_compare);
	exact_of = h;
	for (size_t i = 0; i < h->n; i = end) {
		bool sorted = true;

		for (end = i + 1;
		     end < h->n && key[end].distance == key[i].distance; end++)
			sorted = sorted &&
			    (is_header(&key[i]) ||
				hit_compare(&key[end - 1], &key[end]) < 0);
		if (!sorted)
			qsort(key + i, end - i, sizeof *key, hit_compare);
	}
}

/* Returns the index of the first hit that is printed. Headers of several sources are
 * printed once if they are equal, else not at all. */
static size_t hits_first(const struct hits *h)
{
	size_t n = 0;
	bool differ = false;

	for (; n < h->n && is_header(&h->key[n]); n++) {
		const struct hit *hit = hit_at(h->text, h->key[n].at);
		const struct hit *first = hit_at(h->text, h->key[0].at);

		differ |= hit->size != first->size ||
		    memcmp(hit->text, first->text, hit->size) != 0;
	}
	return differ || n == 0 ? n : n - 1;
}

static void print_hits(const struct job *j)
{
	struct hits *h = j->with;
	/* there is room: a line number is shorter than the struct that it replaces */
	char *const out = xrealloc(NULL, h->size), *at = out;

	hits_sort(h);
	for (size_t i = hits_first(h); i < h->n; i++) {
		const struct hit *hit = hit_at(h->text, h->key[i].at);

		if (h->json)
			at += sprintf(at, "{\"line\":%lld,", hit->line);
		memcpy(at, hit->text, hit->size);
		at += hit->size;
	}
	output_write(out, (size_t)(at - out));
	free(out);
}

/* Sets the position and radius: an option replaces what "pick" in the document says. */
static void hits_aim(const struct document *d, const struct options *o,
    struct hits *h)
{
	const struct pick *p = &d->pick;

	if (o->pick_at.n == 0 && !p->has_at)
		document_refuse(d,
		    "/pick/at: missing; give the position on the device "
		    "with \"at\": [x, y] or --at X,Y");
	if (!(o->radius > 0) && !(p->radius > 0))
		document_refuse(d,
		    "/pick/radius: missing; give the radius in device units "
		    "with \"radius\": r or --radius R");
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
	hits.style = options_style(o);
	hits.n = hits.size = 0;
	read_document(c, o, &d);
	hits_aim(&d, o, &hits);
	document_check(&d,
	    scene_transform(&d.scene, SPACE_MODEL, SPACE_DEVICE, false,
		&j.transform));
	document_check(&d,
	    frustum_of(&d.scene, SPACE_MODEL, false, &j.frustum));
	document_check(&d, picker_of(&d.scene, &j.transform, &hits.picker));
	if (o->has_out && !hits.json &&
	    (o->out != o->in || o->out_record != o->in_record))
		die(EXIT_USAGE,
		    "pick prints lines as they were read; leave -o out, or "
		    "use -o json");
	hits.finite_near = sum_sign(hits.picker.depth.map.divisor) != 0;
	run_points(o, &d, &j);
}
