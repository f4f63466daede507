/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../core/derive/pick.h"
#include "json/print.h"
#include "call/operands.h"
#include "message/message.h"

/* A point that was hit, or a csv header, whose distance is -infinity. Behind it
 * stands the text of its line or, where JSON is printed, the device position. */
struct hit {
	double distance, point[4];
	long long line;
	size_t size; /* of what stands behind it */
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
	bool near; /* the near plane is not at infinity */
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

/* Appends the points of a block that are hit, and its headers. */
static void hits_take(const struct job *j, struct chunk *c, size_t n,
    size_t points)
{
	const struct hits *h = j->with;
	const double *const in[4] = { c->in[0], c->in[1], c->in[2] };
	double(*v)[POINTS_BLOCK] = c->image;
	double *const device[4] = { v[0], v[1], v[2] };
	double *const view[4] = { v[3], v[4], v[5] };
	unsigned char outside[POINTS_BLOCK];
	bool known = false; /* outside, and view where that is finite */

	points_carry(&j->transform, j->precision, in, device, points);
	for (size_t i = 0, p = 0; i < n; i++) {
		const struct line *line = &c->line[i];
		size_t at = p, number = c->n_lines - n + i;

		if (line->kind == LINE_HEADER && !h->json)
			hits_append(c,
			    (struct hit){ .distance = (double)-INFINITY,
				.size = line->size },
			    line->s);
		if (line->kind != LINE_POINT)
			continue;
		p++;
		const double to[3] = { v[0][at], v[1][at], v[2][at] };
		struct hit hit = { .point = { in[0][at], in[1][at], in[2][at],
				       1 },
			.line = (long long)number,
			.size = h->json ? sizeof to : line->size };

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
		hits_append(c, hit, h->json ? (const void *)to : line->s);
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
	if (c->size > 0)
		memcpy(h->text + h->size, c->out, c->size);
	for (size_t end = h->size + c->size; h->size < end;
	     h->size += sizeof hit + hit.size) {
		memcpy(&hit, h->text + h->size, sizeof hit);
		hit.line += first_line;
		memcpy(h->text + h->size, &hit, sizeof hit);
		if (h->n == h->room) {
			h->room += h->room / 2 + 64;
			h->key = need(h->key, h->room * sizeof *h->key);
		}
		h->key[h->n++] = (struct key){ hit.distance, h->size };
	}
}

static bool is_header(struct key k)
{
	return k.distance < -DBL_MAX;
}

static struct hit hit_at(const struct hits *h, struct key k)
{
	struct hit hit;

	memcpy(&hit, h->text + k.at, sizeof hit);
	return hit;
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
	const struct hit one = hit_at(comparing, *p);
	const struct hit other = hit_at(comparing, *q);
	int order = pick_compare(&comparing->picker, one.point, other.point);

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

/* Of several sources one header is enough, and none if they differ. */
static bool hits_wants(const struct hits *h, size_t i)
{
	if (!is_header(h->key[i]))
		return true;
	const struct hit first = hit_at(h, h->key[0]);
	const char *text = h->text + h->key[0].at + sizeof first;

	for (size_t k = 1; k < h->n && is_header(h->key[k]); k++)
		if (hit_at(h, h->key[k]).size != first.size ||
		    memcmp(h->text + h->key[k].at + sizeof first, text,
			first.size) != 0)
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
    const char *behind, struct number_style style)
{
	char text[8 * NUMBER_MAX + 128];
	double device[3];
	struct printer p = { .at = text, .compact = true, .between = "" };

	memcpy(device, behind, sizeof device);
	put_open(&p, "{");
	put_name(&p, "line");
	put_number(&p, (double)h->line);
	p.style = style;
	put_name(&p, "distance");
	put_number(&p, h->distance);
	put_name(&p, "device");
	put_numbers(&p, device, 3);
	put_name(&p, "point");
	put_numbers(&p, h->point, 3);
	put_close(&p, "}\n");
	hits_put(out, text, (size_t)(p.at - text));
}

static void print_hits(const struct job *j)
{
	static struct output out;
	struct hits *h = j->with;

	hits_sort(h);
	for (size_t i = 0; i < h->n; i++) {
		const struct hit hit = hit_at(h, h->key[i]);
		const char *behind = h->text + h->key[i].at + sizeof hit;

		if (h->json) {
			print_json(&out, &hit, behind, h->style);
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
	if (o->has_out && !hits.json &&
	    (o->out != o->in || o->out_record != o->in_record))
		die(EXIT_USAGE,
		    "pick prints lines as they were read, or "
		    "-o json");
	hits.near = sum_sign(hits.picker.depth.map.divisor) != 0;
	prepare_job(&j, o);
	do_points(o, &d, &j);
}
