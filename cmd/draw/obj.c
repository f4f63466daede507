/* SPDX-License-Identifier: MIT */
#include "obj.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../message/words.h"
#include "../number/number.h"
#include "../table/format.h"
#include "grow.h"

/* Reads words. A backslash at the end of a line joins it to the next. */
struct reader {
	struct obj *obj;
	struct refusal *fault;
	const char *s, *end;
	long long line, next_line; /* where the line and the one after it begin */
	/* the greatest index, from 1, and the first line that has it */
	unsigned long long greatest;
	long long greatest_line;
};

/* What a shape needs. */
static const struct {
	char letter;
	size_t least;
	const char *what;
} shapes[] = {
	{ 'p', 1, "p has no point" },
	{ 'l', 2, "l has fewer than two points" },
	{ 'f', 3, "f has fewer than three points" },
};

/* The words of the format that say nothing of points, lines and polygons. */
static const char other_words[] =
    "vt vn vp g s o mg usemtl mtllib usemap maplib cstype deg bmat step curv curv2 "
    "surf parm trim hole scrv sp end con bevel c_interp d_interp lod shadow_obj "
    "trace_obj ctech stech call csh bsp bzp cdc cdp res";

static bool obj_refuse(const struct reader *r, const char *what, const char *remedy)
{
	refusal_set(r->fault, NULL, what, remedy);
	r->fault->line = r->line;
	return false;
}

/* Returns the bytes of a line end after a backslash at s, with it; 0: there is none. */
static size_t join_at(const struct reader *r, const char *s)
{
	const bool cr = r->end - s > 1 && s[1] == '\r';

	return *s == '\\' && r->end - s > 1 + cr && s[1 + cr] == '\n' ? 2u + cr : 0;
}

static bool is_space(char c)
{
	return c == ' ' || c == '\t' || c == '\r';
}

/* Moves to the next word of the line and past it. Returns false if there is none: the
 * line ends, or a comment begins. */
static bool next_word(struct reader *r, struct span *word)
{
	size_t join = 0;

	while (r->s < r->end && (is_space(*r->s) || (join = join_at(r, r->s)) > 0)) {
		r->next_line += join > 0;
		r->s += join > 0 ? join : 1;
		join = 0;
	}
	word->s = r->s;
	if (r->s == r->end || *r->s == '\n' || *r->s == '#')
		return false;
	while (
	    r->s < r->end && !is_space(*r->s) && *r->s != '\n' && join_at(r, r->s) == 0)
		r->s++;
	word->end = r->s;
	return true;
}

static bool read_vertex(struct reader *r)
{
	struct obj *obj = r->obj;
	struct span word;
	double v[3] = { 0 };
	int n = 0;

	for (; n < 3 && next_word(r, &word); n++) {
		if (number_read(word.s, word.end, &v[n]) != word.end)
			return obj_refuse(r, "v has a word that is no number",
			    "v 1 2 3 is a point");
		if (!(fabs(v[n]) <= SCENE_MAGNITUDE_MAX))
			return obj_refuse(r, "v has a number that is not up to 1e150",
			    "v 1 2 3 is a point");
	}
	if (n < 2)
		return obj_refuse(r, "v has fewer than three numbers",
		    "v 1 2 3 is a point");
	if (n == 2 && obj->flat_line == 0)
		obj->flat_line = r->line;
	GROW(obj->point, obj->points, 1, obj->point_room);
	memcpy(obj->point[obj->points++], v, sizeof v);
	return true;
}

/* Reads a whole number. Returns its end, or NULL if there is none up to 2^32. */
static const char *read_whole(const char *s, const char *end, long long *v)
{
	const bool minus = s < end && *s == '-';
	const char *digit = s + (minus || (s < end && *s == '+'));

	for (*v = 0, s = digit; s < end && *s >= '0' && *s <= '9'; s++)
		if ((*v = 10 * *v + (*s - '0')) > UINT32_MAX)
			return NULL;
	*v = minus ? -*v : *v;
	return s > digit ? s : NULL;
}

/* Reads i, i/t, i//n or i/t/n. Only i counts. */
static bool read_index(struct reader *r, struct span word)
{
	struct obj *obj = r->obj;
	const long long n = (long long)obj->points;
	long long i, other;
	const char *const end = word.end, *at = read_whole(word.s, end, &i);

	for (int k = 0; k < 2 && at != NULL && at < end && *at == '/'; k++) {
		at++;
		if (at < end && (k == 1 || *at != '/'))
			at = read_whole(at, end, &other);
	}
	if (at != end)
		return obj_refuse(r, "a word is no index",
		    "an index is i, i/t, i//n or i/t/n of whole numbers");
	if (i == 0 || -i > n)
		return obj_refuse(r,
		    i == 0 ? "an index is 0" :
			     text("index %lld, and %lld points are before it", i, n),
		    "indices count from 1 on, or from -1 back");
	if (i > 0 && (unsigned long long)i > r->greatest) {
		r->greatest = (unsigned long long)i;
		r->greatest_line = r->line;
	}
	GROW(obj->index, obj->indices, 1, obj->index_room);
	obj->index[obj->indices++] = (unsigned)(i > 0 ? i - 1 : n + i);
	return true;
}

static bool read_shape(struct reader *r, int kind)
{
	struct obj *obj = r->obj;
	struct obj_shape shape = { shapes[kind].letter, obj->indices, 0 };
	struct span word;

	while (next_word(r, &word))
		if (!read_index(r, word))
			return false;
	shape.n = obj->indices - shape.first;
	if (shape.n < shapes[kind].least)
		return obj_refuse(r, shapes[kind].what,
		    "f 1 2 3 is a face, l 1 2 a line and p 1 a point");
	GROW(obj->shape, obj->shapes, 1, obj->shape_room);
	obj->shape[obj->shapes++] = shape;
	return true;
}

static bool read_line(struct reader *r)
{
	char name[24] = "";
	struct span word;

	if (!next_word(r, &word))
		return true;
	const size_t n = (size_t)(word.end - word.s);

	if (n < sizeof name)
		memcpy(name, word.s, n);
	if (strcmp(name, "v") == 0)
		return read_vertex(r);
	/* fo is what f was called once */
	for (int k = 0; k < 3; k++)
		if (*name == shapes[k].letter &&
		    (name[1] == '\0' || strcmp(name, "fo") == 0))
			return read_shape(r, k);
	if (word_is_one_of(name, other_words))
		return true;
	return obj_refuse(r,
	    text("'%.*s' begins no line of an OBJ file", n < 20 ? (int)n : 20, word.s),
	    "v, p, l and f are drawn, and its other words skipped");
}

/* Refuses what no line of a text has, and carriage returns that end lines alone. */
static bool is_text(struct reader *r)
{
	r->line = 1;
	for (const char *s = r->s; s < r->end; s++) {
		if (*s == '\0')
			return obj_refuse(r, "is binary", "an OBJ file is text");
		if (*s == '\r' && s + 1 < r->end && s[1] != '\n')
			return obj_refuse(r, "has carriage returns alone for line ends",
			    "make them newlines: tr '\\r' '\\n'");
		r->line += *s == '\n';
	}
	return true;
}

bool obj_read(struct span file, struct obj *obj, struct refusal *fault)
{
	struct reader r = { .obj = obj, .fault = fault, .end = file.end };
	struct span rest;

	r.s = skip_bom(file.s, file.end);
	if (format_is_foreign(r.s, (size_t)(r.end - r.s), false, fault) || !is_text(&r))
		return false;
	while (r.s < r.end) {
		r.line = ++r.next_line;
		if (!read_line(&r))
			return false;
		while (next_word(&r, &rest)) /* in the lines that are joined */
			continue;
		const char *newline = memchr(r.s, '\n', (size_t)(r.end - r.s));

		r.s = newline != NULL ? newline + 1 : r.end;
	}
	if (obj->points == 0)
		return obj_refuse(&r, "the file has no points", "v 1 2 3 is one");
	r.line = r.greatest_line;
	return r.greatest <= obj->points ||
	    obj_refuse(&r,
		text("index %llu, and there are %zu points", r.greatest, obj->points),
		"indices count from 1 on, or from -1 back");
}

void obj_add(const struct obj *obj, struct mesh *m)
{
	unsigned *vertex = xrealloc(NULL, obj->points * sizeof *vertex);
	unsigned *corner = xrealloc(NULL, (obj->indices + 1) * sizeof *corner);

	for (size_t i = 0; i < obj->points; i++)
		vertex[i] = mesh_vertex(m, obj->point[i]);
	for (size_t i = 0; i < obj->indices; i++)
		corner[i] = vertex[obj->index[i]];
	for (size_t i = 0; i < obj->shapes; i++) {
		const struct obj_shape *s = &obj->shape[i];
		const unsigned *at = corner + s->first;

		if (s->letter == 'f')
			mesh_add_face(m, at, s->n);
		for (size_t k = 0; k < s->n && s->letter == 'p'; k++)
			mesh_add_dot(m, at[k], NULL, 0);
		for (size_t k = 0; k + 1 < s->n && s->letter == 'l'; k++)
			mesh_add_segment(m, at[k], at[k + 1], STROKE_LINE);
	}
	for (size_t i = 0; i < obj->points && obj->shapes == 0; i++)
		mesh_add_dot(m, vertex[i], NULL, 0);
	free(vertex);
	free(corner);
}

void obj_free(struct obj *o)
{
	free(o->point);
	free(o->index);
	free(o->shape);
	*o = (struct obj){ 0 };
}
