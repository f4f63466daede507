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

struct reader {
	struct obj *obj;
	struct refusal *fault;
	long long line;
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

static bool is_space(char c)
{
	return c == ' ' || c == '\t' || c == '\r';
}

static const char *skip_space(const char *s, const char *end)
{
	while (s < end && is_space(*s))
		s++;
	return s;
}

static const char *word_end(const char *s, const char *end)
{
	while (s < end && !is_space(*s))
		s++;
	return s;
}

static bool read_vertex(struct reader *r, const char *s, const char *end)
{
	struct obj *obj = r->obj;
	double v[3] = { 0 };
	int n = 0;

	for (s = skip_space(s, end); n < 3 && s < end; s = skip_space(s, end), n++) {
		const char *after = number_read(s, word_end(s, end), &v[n]);

		if (after == NULL || after != word_end(s, end))
			return obj_refuse(r, "v has a word that is no number",
			    "v 1 2 3 is a point");
		if (!(fabs(v[n]) <= SCENE_MAGNITUDE_MAX))
			return obj_refuse(r, "v has a number that is not up to 1e150",
			    "v 1 2 3 is a point");
		s = after;
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

/* Reads i, i/t, i//n or i/t/n, whose words end at `end`. Only i counts. */
static bool read_index(struct reader *r, const char *s, const char *end)
{
	struct obj *obj = r->obj;
	const long long n = (long long)obj->points;
	long long i, other;
	const char *at = read_whole(s, end, &i);

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

static bool read_shape(struct reader *r, int kind, const char *s, const char *end)
{
	struct obj *obj = r->obj;

	GROW(obj->shape, obj->shapes, 1, obj->shape_room);
	struct obj_shape *shape = &obj->shape[obj->shapes];

	*shape = (struct obj_shape){ shapes[kind].letter, obj->indices, 0 };
	for (s = skip_space(s, end); s < end; s = skip_space(s, end)) {
		const char *stop = word_end(s, end);

		if (!read_index(r, s, stop))
			return false;
		s = stop;
	}
	shape->n = obj->indices - shape->first;
	if (shape->n < shapes[kind].least)
		return obj_refuse(r, shapes[kind].what,
		    "f 1 2 3 is a face, l 1 2 a line and p 1 a point");
	obj->shapes++;
	return true;
}

/* Reads a line, without comment and line end. */
static bool read_line(struct reader *r, const char *s, const char *end)
{
	char word[24];

	s = skip_space(s, end);
	if (s == end)
		return true;
	const char *stop = word_end(s, end);
	const size_t n = (size_t)(stop - s);

	if (n == 1 && *s == 'v')
		return read_vertex(r, stop, end);
	/* fo is what f was called once */
	for (int k = 0; k < 3; k++)
		if (*s == shapes[k].letter &&
		    (n == 1 || (k == 2 && n == 2 && s[1] == 'o')))
			return read_shape(r, k, stop, end);
	if (n < sizeof word && memchr(s, '\0', n) == NULL) {
		memcpy(word, s, n);
		word[n] = '\0';
		if (word_is_one_of(word, other_words))
			return true;
	}
	return obj_refuse(r,
	    text("'%.*s' begins no line of an OBJ file", n < 20 ? (int)n : 20, s),
	    "v, p, l and f are drawn, and its other words skipped");
}

/* A line, with those that backslashes join to it. */
struct joined {
	char *text; /* of more lines than one; or NULL */
	size_t size, room;
	struct span line; /* without comment */
};

/* Cuts the next line, and counts the lines that it has in *lines. Returns the place of
 * the next one. A backslash in a comment joins nothing. */
static const char *cut_line(const char *s, const char *end, struct joined *j,
    long long *lines)
{
	const char *begin = s;

	for (j->size = 0, *lines = 1; s < end && *s != '\n' && *s != '#'; s++) {
		const char *newline = s + 1 + (s + 1 < end && s[1] == '\r');

		if (*s != '\\' || newline >= end || *newline != '\n')
			continue;
		const size_t n = (size_t)(s - begin);

		GROW(j->text, j->size, n + 1, j->room);
		memcpy(j->text + j->size, begin, n);
		j->text[j->size + n] = ' ';
		j->size += n + 1;
		begin = newline + 1;
		s = newline;
		++*lines;
	}
	j->line = (struct span){ begin, s };
	if (j->size > 0) {
		const size_t n = (size_t)(s - begin);

		GROW(j->text, j->size, n, j->room);
		memcpy(j->text + j->size, begin, n);
		j->line = (struct span){ j->text, j->text + j->size + n };
	}
	while (s < end && *s != '\n')
		s++;
	return s < end ? s + 1 : end;
}

bool obj_read(struct span file, struct obj *obj, struct refusal *fault)
{
	struct reader r = { .obj = obj, .fault = fault, .line = 1 };
	struct joined joined = { 0 };
	const char *s = skip_bom(file.s, file.end);
	long long lines;
	bool good = !format_is_foreign(s, (size_t)(file.end - s), false, fault);

	for (; good && s < file.end; r.line += lines) {
		s = cut_line(s, file.end, &joined, &lines);
		good = read_line(&r, joined.line.s, joined.line.end);
	}
	free(joined.text);
	if (!good)
		return false;
	r.line = 0;
	if (obj->points == 0)
		return obj_refuse(&r, "has no points", "v 1 2 3 is one");
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
