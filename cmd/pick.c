/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "../core/derive/pick.h"
#include "json/print.h"
#include "call/operands.h"
#include "message/message.h"

/* A point that was hit, or a csv header, whose distance is -infinity. Behind it
 * stands the text of its line or, where JSON is printed, a struct hit_json. */
struct hit {
	double distance, point[3];
	size_t size; /* of what stands behind it */
};

struct hit_json {
	long long line;
	double device[3];
};

/* What is sorted: a distance, and where in text its struct hit stands. */
struct key {
	double distance;
	size_t at;
};

struct hits {
	struct number_style style;
	struct picker picker;
	bool json;
	struct key *key;
	size_t n, room;
	char *text;
	size_t size, text_room;
};

static void hits_append(struct chunk *c, struct hit hit, const void *behind)
{
	char *at = chunk_reserve(c, sizeof hit + hit.size);

	memcpy(at, &hit, sizeof hit);
	memcpy(at + sizeof hit, behind, hit.size);
	c->size += sizeof hit + hit.size;
}

/* Moves the points that lie within the radius to the beginning of their columns;
 * line[p] becomes the place in the block of the line of point p. Returns how many
 * there are. */
static size_t hits_gather(const struct hits *h, struct chunk *c, size_t n,
    uint16_t line[POINTS_BLOCK])
{
	size_t hits = 0, p = 0;

	for (size_t i = 0; i < n; i++) {
		if (c->line[i].kind != LINE_POINT)
			continue;
		const double in[4] = { c->in[0][p], c->in[1][p], c->in[2][p] };
		const double device[3] = { c->image[0][p], c->image[1][p],
			c->image[2][p] };

		p++;
		if (isnan(device[0]) || isnan(device[1]) ||
		    !pick_holds(&h->picker, in, device))
			continue;
		for (int k = 0; k < 3; k++) {
			c->in[k][hits] = in[k];
			c->image[k][hits] = device[k];
		}
		line[hits++] = (uint16_t)i;
	}
	return hits;
}

/* Appends the points of a block that are hit, and its headers. */
static void hits_take(const struct job *j, struct chunk *c, size_t n,
    size_t points)
{
	const struct hits *h = j->with;
	const double *const in[4] = { c->in[0], c->in[1], c->in[2] };
	double *const device[4] = { c->image[0], c->image[1], c->image[2] };
	/* a near plane at infinity is infinitely far */
	const bool near = sum_sign(h->picker.depth.map.divisor) != 0;
	double *const view[4] = { c->image[3], c->image[4], c->image[5] };
	uint16_t line[POINTS_BLOCK];
	unsigned char outside[POINTS_BLOCK];

	for (size_t i = 0; i < n && !h->json; i++)
		if (c->line[i].kind == LINE_HEADER)
			hits_append(c,
			    (struct hit){ .distance = (double)-INFINITY,
				.size = c->line[i].size },
			    c->line[i].s);
	points_carry(&j->transform, j->precision, in, device, points);
	points = hits_gather(h, c, n, line);
	frustum_out_all(&j->frustum, in, outside, points);
	if (near)
		points_carry(&h->picker.depth, PRECISION_EXACT, in, view,
		    points);
	for (size_t p = 0; p < points; p++) {
		const struct line *l = &c->line[line[p]];
		struct hit hit = { near ? view[2][p] : (double)INFINITY,
			{ in[0][p], in[1][p], in[2][p] }, l->size };
		struct hit_json json = { (long long)(c->n_lines - n + line[p]),
			{ device[0][p], device[1][p], device[2][p] } };

		if (outside[p] != 0)
			continue;
		if (isnan(hit.distance))
			hit.distance = pick_distance(&h->picker,
			    (double[4]){ in[0][p], in[1][p], in[2][p], 1 });
		if (h->json)
			hit.size = sizeof json;
		hits_append(c, hit, h->json ? (const void *)&json : l->s);
	}
}

static void hits_collect(const struct job *j, const struct chunk *c,
    long long first_line)
{
	struct hits *h = j->with;
	struct hit hit;
	long long line;

	if (h->size + c->size > h->text_room) {
		h->text_room = h->text_room / 2 + h->size + c->size;
		h->text = need(h->text, h->text_room);
	}
	if (c->size > 0)
		memcpy(h->text + h->size, c->out, c->size);
	for (size_t end = h->size + c->size; h->size < end;
	     h->size += sizeof hit + hit.size) {
		memcpy(&hit, h->text + h->size, sizeof hit);
		if (h->n == h->room) {
			h->room += h->room / 2 + 64;
			h->key = need(h->key, h->room * sizeof *h->key);
		}
		h->key[h->n++] = (struct key){ hit.distance, h->size };
		if (h->json) {
			char *at = h->text + h->size + sizeof hit;

			memcpy(&line, at, sizeof line);
			line += first_line;
			memcpy(at, &line, sizeof line);
		}
	}
}

static bool is_header(struct key k)
{
	return k.distance < -DBL_MAX;
}

/* For qsort, which hands nothing on. */
static const struct hits *comparing;

static int key_compare(const void *a, const void *b)
{
	const struct key *p = a, *q = b;

	if (p->distance < q->distance || p->distance > q->distance)
		return p->distance < q->distance ? -1 : 1;
	return p->at < q->at ? -1 : p->at > q->at;
}

/* The same of distances whose nearest doubles are equal. */
static int key_compare_exactly(const void *a, const void *b)
{
	const struct key *p = a, *q = b;
	double one[4] = { [3] = 1 }, other[4] = { [3] = 1 };
	size_t point = offsetof(struct hit, point);

	memcpy(one, comparing->text + p->at + point, 3 * sizeof *one);
	memcpy(other, comparing->text + q->at + point, 3 * sizeof *other);
	int order = pick_compare(&comparing->picker, one, other);

	return order != 0 ? order : key_compare(a, b);
}

/* Sorts the nearest first, then as they came. Exact distances are compared only
 * where their nearest doubles are equal; most often they are equal then, too, and
 * stay in their order. */
static void hits_sort(const struct hits *h)
{
	size_t end;

	if (h->n == 0)
		return;
	comparing = h;
	qsort(h->key, h->n, sizeof *h->key, key_compare);
	for (size_t i = 0; i < h->n; i = end) {
		bool sorted = true;

		for (end = i + 1;
		     end < h->n && h->key[end].distance == h->key[i].distance;
		     end++)
			sorted = sorted &&
			    (is_header(h->key[i]) ||
				key_compare_exactly(&h->key[end - 1],
				    &h->key[end]) < 0);
		if (!sorted)
			qsort(h->key + i, end - i, sizeof *h->key,
			    key_compare_exactly);
	}
}

static struct hit hit_at(const struct hits *h, struct key k)
{
	struct hit hit;

	memcpy(&hit, h->text + k.at, sizeof hit);
	return hit;
}

/* Of several sources one header is enough, and none if they differ. */
static bool hits_wants(const struct hits *h, size_t i)
{
	if (!is_header(h->key[i]))
		return true;
	/* their sizes stand before their texts */
	const size_t from = offsetof(struct hit, size);
	const size_t size = sizeof(struct hit) - from +
	    hit_at(h, h->key[0]).size;

	for (size_t k = 1; k < h->n && is_header(h->key[k]); k++)
		if (memcmp(h->text + h->key[k].at + from,
			h->text + h->key[0].at + from, size) != 0)
			return false;
	return i == 0;
}

/* Gathers what is to be printed, so that there are few writes. */
struct output {
	size_t n;
	char text[1 << 16];
};

static void hits_put(struct output *out, const char *s, size_t n)
{
	if (n > sizeof out->text - out->n) {
		put_all(out->text, out->n);
		out->n = 0;
	}
	if (n > sizeof out->text) {
		put_all(s, n);
		return;
	}
	memcpy(out->text + out->n, s, n);
	out->n += n;
}

static void print_json(struct output *out, const struct hit *h,
    const struct hit_json *json, struct number_style style)
{
	char text[8 * NUMBER_MAX + 128];
	struct printer p = { .at = text, .compact = true, .between = "" };

	put_open(&p, "{");
	put_name(&p, "line");
	put_number(&p, (double)json->line);
	p.style = style;
	put_name(&p, "distance");
	put_number(&p, h->distance);
	put_name(&p, "device");
	put_numbers(&p, json->device, 3);
	put_name(&p, "point");
	put_numbers(&p, h->point, 3);
	put_close(&p, "}\n");
	hits_put(out, text, (size_t)(p.at - text));
}

static void print_hits(const struct job *j)
{
	static struct output out;
	struct hits *h = j->with;
	struct hit_json json;

	hits_sort(h);
	for (size_t i = 0; i < h->n; i++) {
		const struct hit hit = hit_at(h, h->key[i]);
		const char *behind = h->text + h->key[i].at + sizeof hit;

		if (h->json) {
			memcpy(&json, behind, sizeof json);
			print_json(&out, &hit, &json, h->style);
		} else if (hits_wants(h, i)) {
			hits_put(&out, behind, hit.size);
			if (!is_binary(j->layout.in.format))
				hits_put(&out, "\n", 1);
		}
	}
	put_all(out.text, out.n);
	out.n = 0;
}

/* Options win over the document's member "pick". */
static void aim(const struct document *d, const struct options *o,
    struct hits *h)
{
	const struct pick *p = &d->pick;

	if (!o->has_at && !p->has_at)
		document_refuse(d,
		    "/pick/at: missing; say where on the device "
		    "with \"at\": [x, y] or --at X,Y");
	if (!(o->radius > 0) && !(p->radius > 0))
		document_refuse(d,
		    "/pick/radius: missing; say how far around "
		    "with \"radius\" or --radius R");
	for (int i = 0; i < 2; i++)
		h->picker.at[i] = o->has_at ? o->at[i] : p->at[i];
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
	hits.style = one_style(o, "what pick prints");
	hits.n = hits.size = 0;
	read_document(c, o, &d);
	aim(&d, o, &hits);
	document_check(&d,
	    scene_transform(&d.scene, SPACE_MODEL, SPACE_DEVICE, false,
		&j.transform));
	document_check(&d,
	    frustum_of(&d.scene, SPACE_MODEL, false, &j.frustum));
	document_check(&d, picker_of(&d.scene, &j.transform, &hits.picker));
	if (o->has_out && !hits.json && o->out != o->in)
		die(EXIT_USAGE,
		    "pick prints lines as they were read, or "
		    "-o json");
	prepare_job(&j, o);
	do_points(o, &d, &j);
}
