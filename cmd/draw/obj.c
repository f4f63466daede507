/* SPDX-License-Identifier: MIT */
#include "obj.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../message/words.h"
#include "../number/number.h"
#include "../table/format.h"
#include "../message/grow.h"

/* Reads a text twice, for its points and for its shapes, as an index may be of a point
 * below. */
struct reader {
	struct mesh *mesh;
	bool flat;
	struct refusal *fault;
	const char *s, *end;
	long long line, next_line; /* where the line and the one after it begin */
	unsigned *vertex;          /* of each point */
	size_t points, above;      /* all of them; those above the line */
	unsigned *corner;          /* of the shape so far */
	size_t corners;
	bool any; /* shape was read */
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

/* Moves to the next word of the line and past it; a backslash at its end joins it to
 * the next line. Returns false if there is none: the
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
	if (n < 2 + !r->flat)
		return obj_refuse(r, "v has fewer than three numbers",
		    "v 1 2 3 is a point");
	GROW(r->vertex, r->points, 1);
	r->vertex[r->points++] = mesh_vertex(r->mesh, v);
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
	const long long above = (long long)r->above;
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
	const long long points = i < 0 ? above : (long long)r->points;

	if (i == 0 || i > points || -i > points)
		return obj_refuse(r,
		    i == 0 ? "an index is 0" :
			     text("index %lld of %lld point%s%s", i, points,
				 points == 1 ? "" : "s", i < 0 ? " before it" : ""),
		    "indices count from 1 on, or from -1 back");
	GROW(r->corner, r->corners, 1);
	r->corner[r->corners++] = r->vertex[i > 0 ? i - 1 : above + i];
	return true;
}

static bool read_shape(struct reader *r, int kind)
{
	const char letter = shapes[kind].letter;
	struct span word;

	r->corners = 0;
	while (next_word(r, &word))
		if (!read_index(r, word))
			return false;
	if (r->corners < shapes[kind].least)
		return obj_refuse(r, shapes[kind].what,
		    "f 1 2 3 is a face, l 1 2 a line and p 1 a point");
	if (letter == 'f')
		mesh_add_face(r->mesh, r->corner, r->corners);
	for (size_t i = 0; i < r->corners && letter == 'p'; i++)
		mesh_add_dot(r->mesh, r->corner[i], NULL, 0);
	for (size_t i = 0; i + 1 < r->corners && letter == 'l'; i++)
		mesh_add_segment(r->mesh, r->corner[i], r->corner[i + 1], STROKE_LINE);
	return r->any = true;
}

/* Reads a line that begins with a word: first the points, then the shapes. */
static bool read_line(struct reader *r, struct span word, bool shapes_now)
{
	const size_t n = (size_t)(word.end - word.s);
	char name[24] = "";

	if (n == 1 && *word.s == 'v')
		return shapes_now ? ++r->above > 0 : read_vertex(r);
	if (n < sizeof name)
		memcpy(name, word.s, n);
	/* fo is what f was called once */
	for (int k = 0; k < 3 && shapes_now; k++)
		if (*name == shapes[k].letter &&
		    (name[1] == '\0' || strcmp(name, "fo") == 0))
			return read_shape(r, k);
	return !shapes_now || word_is_one_of(name, other_words) ||
	    obj_refuse(r,
		text("'%.*s' begins no line of an OBJ file", n < 20 ? (int)n : 20,
		    word.s),
		"v, p, l and f are drawn, and its other words skipped");
}

/* Moves past the end of the line, which may be that of another that is joined to it. */
static void skip_line(struct reader *r)
{
	const char *newline = memchr(r->s, '\n', (size_t)(r->end - r->s));
	struct span word;

	if (newline != NULL && newline > r->s &&
	    (newline[-1] == '\\' || (newline > r->s + 1 && newline[-2] == '\\'))) {
		while (next_word(r, &word))
			continue;
		newline = memchr(r->s, '\n', (size_t)(r->end - r->s));
	}
	r->s = newline != NULL ? newline + 1 : r->end;
}

static bool read_lines(struct reader *r, const char *from, bool shapes_now)
{
	struct span word;

	r->s = from;
	r->next_line = 0;
	while (r->s < r->end) {
		r->line = ++r->next_line;
		if (next_word(r, &word) && !read_line(r, word, shapes_now))
			return false;
		skip_line(r);
	}
	return true;
}

/* Refuses what no line of a text has, and carriage returns that end lines alone. */
static bool is_text(struct reader *r, const char *s)
{
	r->line = 1;
	for (; s < r->end; s++) {
		if (*s == '\0')
			return obj_refuse(r, "is binary", "an OBJ file is text");
		if (*s == '\r' && s + 1 < r->end && s[1] != '\n')
			return obj_refuse(r, "has carriage returns alone for line ends",
			    "make them newlines: tr '\\r' '\\n'");
		r->line += *s == '\n';
	}
	return true;
}

bool obj_read(struct span file, bool flat, struct mesh *m, struct refusal *fault)
{
	struct reader r = { .mesh = m, .flat = flat, .fault = fault, .end = file.end };
	const char *const s = skip_bom(file.s, file.end);
	bool good = !format_is_foreign(s, (size_t)(r.end - s), false, fault) &&
	    is_text(&r, s) && read_lines(&r, s, false) && read_lines(&r, s, true);

	if (good && r.points == 0)
		good = obj_refuse(&r, "the file has no points", "v 1 2 3 is one");
	for (size_t i = 0; i < r.points && good && !r.any; i++)
		mesh_add_dot(m, r.vertex[i], NULL, 0);
	free(r.vertex);
	free(r.corner);
	return good;
}
