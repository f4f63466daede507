/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../core/derive/pick.h"
#include "json/print.h"
#include "call/operands.h"
#include "message/message.h"

/* A point that was hit, or a csv header: its line, and where the text of that line
 * begins in hits.text, and its size. */
struct hit {
	double distance, device[3], point[4];
	long long line;
	size_t text, size;
	bool header; /* printed before all points */
};

struct hits {
	const struct options *o;
	struct number_style style;
	struct picker picker;
	struct hit *hit;
	size_t n, room;
	char *text;
	size_t size, text_room;
};

/* Appends a struct hit to the chunk's output, then the text of its line. */
static void hits_append(struct chunk *c, const struct line *line,
    struct hit hit)
{
	hit.size = line->size;
	char *at = chunk_reserve(c, sizeof hit + hit.size);

	memcpy(at, &hit, sizeof hit);
	memcpy(at + sizeof hit, line->s, hit.size);
	c->size += sizeof hit + hit.size;
}

/* Takes a point that is hit, or a header. */
static void hits_take(const struct job *j, struct chunk *c,
    const struct line *line, size_t p, size_t number)
{
	const struct hits *h = j->with;
	double in[4] = { c->in[0][p], c->in[1][p], c->in[2][p], 1 };
	struct hit hit = { .line = (long long)number, .point = { [3] = 1 } };

	if (line->kind == LINE_HEADER)
		hits_append(c, line, (struct hit){ .header = true });
	if (line->kind != LINE_POINT)
		return;
	for (int i = 0; i < 3; i++) {
		hit.device[i] = c->image[i][p];
		hit.point[i] = in[i];
	}
	if (isnan(hit.device[0]) || isnan(hit.device[1]) ||
	    !pick_holds(&h->picker, in, hit.device) ||
	    frustum_out(&j->frustum, in) != 0)
		return;
	hit.distance = pick_distance(&h->picker, in);
	hits_append(c, line, hit);
}

static void hits_collect(const struct job *j, const struct chunk *c,
    long long first_line)
{
	struct hits *h = j->with;

	for (size_t i = 0; i < c->size;) {
		struct hit hit;

		memcpy(&hit, c->out + i, sizeof hit);
		hit.text = h->size;
		hit.line += first_line;
		if (h->n == h->room) {
			h->room = 2 * h->room + 64;
			h->hit = need(h->hit, h->room * sizeof hit);
		}
		if (h->size + hit.size > h->text_room) {
			h->text_room = 2 * (h->size + hit.size);
			h->text = need(h->text, h->text_room);
		}
		memcpy(h->text + h->size, c->out + i + sizeof hit, hit.size);
		h->size += hit.size;
		h->hit[h->n++] = hit;
		i += sizeof hit + hit.size;
	}
}

/* For qsort, which hands nothing on. */
static const struct picker *comparing;

/* Nearest first, then as they came; distances that are printed alike can
 * differ. */
static int hits_compare(const void *a, const void *b)
{
	const struct hit *p = a, *q = b;
	int order = q->header - p->header;

	if (order == 0)
		order = (p->distance > q->distance) -
		    (p->distance < q->distance);

	if (order == 0)
		order = pick_compare(comparing, p->point, q->point);
	return order != 0 ? order : p->text < q->text ? -1 : p->text > q->text;
}

/* Of several sources one header is enough, and none if they differ. */
static bool hits_wants(const struct hits *h, size_t i)
{
	const struct hit *hit = &h->hit[i];

	if (!hit->header)
		return true;
	for (size_t k = 0; k < h->n && h->hit[k].header; k++)
		if (h->hit[k].size != hit->size ||
		    memcmp(h->text + h->hit[k].text, h->text + hit->text,
			hit->size) != 0)
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
    struct number_style style)
{
	char text[8 * NUMBER_MAX + 128];
	struct printer p = { .at = text, .compact = true, .between = "" };

	put_open(&p, "{");
	put_name(&p, "line");
	put_number(&p, (double)h->line);
	p.style = style;
	put_name(&p, "distance");
	put_number(&p, h->distance);
	put_name(&p, "device");
	put_numbers(&p, h->device, 3);
	put_name(&p, "point");
	put_numbers(&p, h->point, 3);
	put_close(&p, "}\n");
	hits_put(out, text, (size_t)(p.at - text));
}

static void print_hits(const struct job *j)
{
	static struct output out;
	struct hits *h = j->with;
	const struct options *o = h->o;

	if (h->n > 0) {
		comparing = &h->picker;
		qsort(h->hit, h->n, sizeof *h->hit, hits_compare);
	}
	for (size_t i = 0; i < h->n; i++) {
		const struct hit *hit = &h->hit[i];

		if (!hits_wants(h, i) || (hit->header && o->out == FORMAT_JSON))
			continue;
		if (o->has_out && o->out == FORMAT_JSON) {
			print_json(&out, hit, h->style);
			continue;
		}
		hits_put(&out, h->text + hit->text, hit->size);
		if (!is_binary(o->in))
			hits_put(&out, "\n", 1);
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

	hits.o = o;
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
	if (o->has_out && o->out != FORMAT_JSON &&
	    (o->out != o->in || o->out_record != o->in_record))
		die(EXIT_USAGE,
		    "pick prints lines as they were read, or "
		    "-o json");
	prepare_job(&j, o);
	do_points(o, &d, &j);
}
