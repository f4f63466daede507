/* SPDX-License-Identifier: MIT */
/* The walk of cut.h. A walker is a position in a stretch. A function pass_x moves the
 * position behind x, or returns false if the line has to be cut by cursors. */
#include "cut.h"

#include <math.h>

#include "../../core/scene/scene.h"
#include "../json/text.h"

/* INLINE functions are compiled once for each format, so that the compiler removes the
 * branches of other formats. Makefile defines INLINE otherwise for sanitizers. */
#ifndef INLINE
#define INLINE static inline __attribute__((always_inline))
#endif

struct walker {
	const char *text;
	uint32_t at;          /* the position, in bytes from text */
	const uint16_t *stop; /* the first stop at or after `at` */
	int found;            /* the number of coordinates passed */
};

void walk_set_stops(struct walk *w)
{
	const struct dialect d = w->in;
	const bool json = d.format == FORMAT_JSON, csv = d.format == FORMAT_CSV;
	struct byte_set set = { { 0 }, { 0 } };
	int bits = 0;

	for (int b = 0; b < 256; b++) {
		const char c = (char)b;

		if (c != '\n' && !is_blank(c) &&
		    !((csv || json) && (c == d.separator || c == '"')) &&
		    !(json && (b < ' ' || strchr("[]{}\\", c) != NULL)))
			continue;
		byte_set_add(&set, &bits, (uint8_t)b);
	}
	w->stops = set;
}

bool stretch_open(struct stretch *s, const struct walk *w, const char *text,
    const char *end)
{
	size_t size = (size_t)(end - text), n;

	if (size > STRETCH_MAX)
		size = STRETCH_MAX;
	/* a line with a NUL is wrong wherever it stands, and plan_line says so */
	const char *nul = memchr(text, '\0', size);

	if (nul != NULL)
		size = (size_t)(nul - text);
	n = number_loops_chosen()->find(&w->stops, text, size, s->stop);
	while (n > 0 && text[s->stop[n - 1]] != '\n')
		n--;
	s->text = text;
	s->at = 0;
	s->end = n > 0 ? s->stop[n - 1] + 1u : 0;
	s->next = s->stop;
	s->usual = w->in.format != FORMAT_JSON ||
	    is_utf8((struct span){ text, text + s->end });
	return n > 0;
}

/* Returns whether the byte at the position is a stop, and is c. */
INLINE bool stop_is(const struct walker *p, char c)
{
	return *p->stop == p->at && p->text[p->at] == c;
}

INLINE void pass_stop(struct walker *p)
{
	p->at++;
	p->stop++;
}

/* Passes blanks. Spaces that follow two others may be no stops. Counts up to seven at a
 * time without a branch, as their number varies where columns are aligned; of JSON
 * one. */
INLINE void pass_blanks(struct walker *p, struct dialect d)
{
	const uint64_t spaces = 0x2020202020202020, end = 1ull << 63;

	while (*p->stop == p->at && is_blank_of(d, p->text[p->at])) {
		uint32_t from = p->at;

		if (d.format == FORMAT_JSON && p->text[p->at + 1] != ' ') {
			pass_stop(p);
			continue;
		}
		while (p->text[p->at] == ' ') {
			uint64_t b;

			memcpy(&b, p->text + p->at, sizeof b);
			b = (b ^ spaces) | end;
			p->at += (uint32_t)__builtin_ctzll(b) / 8;
		}
		p->at += p->at == from;
		do
			p->stop++;
		while (*p->stop < p->at);
	}
}

/* Passes a separator, which is mostly a single byte. Returns false if there is none. */
INLINE bool pass_separator(struct walker *p, struct dialect d)
{
	const bool blanks = d.format == FORMAT_TEXT || d.format == FORMAT_OBJ;
	const char c = p->text[p->at];

	if (*p->stop == p->at &&
	    (blanks ? c != '\n' && p->stop[1] > p->at + 1 : c == d.separator)) {
		pass_stop(p);
		if (!blanks)
			pass_blanks(p, d);
		return true;
	}
	pass_blanks(p, d);
	if (blanks)
		return !stop_is(p, '\n');
	if (!stop_is(p, d.separator))
		return false;
	pass_stop(p);
	pass_blanks(p, d);
	return true;
}

/* Returns how many stops the escape at s has after its backslash; -1: no escape. */
static inline int stops_in_escape(const char *s)
{
	unsigned code;

	if (s[1] == 'u')
		return json_hex4(s + 2, s + 6, &code) == s + 6 ? 0 : -1;
	if (s[1] == '"' || s[1] == '\\')
		return 1;
	return s[1] != '\0' && strchr("/bfnrt", s[1]) != NULL ? 0 : -1;
}

/* Passes a string of JSON. Returns false if the string has an escape, unless
 * may_have_escapes is set: an escaped name could be the name of a coordinate. */
INLINE bool pass_string(struct walker *p, bool may_have_escapes)
{
	for (p->stop++; p->text[*p->stop] != '"'; p->stop++) {
		const char *s = &p->text[*p->stop];
		int stops = -1;

		if (__builtin_expect(*s == '\\', 0) && may_have_escapes)
			stops = stops_in_escape(s);
		if (stops < 0 && (*s == '\\' || (unsigned char)*s < ' '))
			return false;
		p->stop += stops > 0;
	}
	p->at = *p->stop++ + 1u;
	return true;
}

/* Returns whether a plain number (loops.h) is legal JSON: 01, .5, +1, "1." are not. */
INLINE bool is_json_number(const char *s, const char *end)
{
	s += *s == '-';
	/* no branches, because the first digits can't be predicted */
	return !(((*s == '0') & (s[1] >= '0') & (s[1] <= '9')) | (*s < '0') |
	    (end[-1] == '.'));
}

/* Passes a field of text or csv that is not a coordinate. A quote inside of a quoted
 * field ends it here: as no separator follows, cursors cut the line. */
INLINE bool pass_other_field(struct walker *p, struct dialect d)
{
	bool csv = d.format == FORMAT_CSV, quoted = csv && stop_is(p, '"');

	if (quoted)
		for (p->stop++; p->text[*p->stop] != '"'; p->stop++)
			if (p->text[*p->stop] == '\n')
				return false;
	while (csv && !quoted && is_blank_of(d, p->text[*p->stop]))
		p->stop++;
	p->at = *p->stop;
	if (quoted)
		pass_stop(p);
	return true;
}

/* Where to store what is found in line i of a batch, which begins at byte `begin`. */
struct target {
	const struct walk *walk;
	struct line *line;
	uint32_t begin;
	size_t i;
	struct plain_places *places;
};

/* Sets the place of number k of line i, which is unknown, to a byte that may be
 * read. */
static void set_dummy_number(int k, size_t i, struct plain_places places[4])
{
	static const char none[PLAIN_READABLE + 1] = "";

	places[k].end[i] = none + sizeof none;
	places[k].size[i] = 1;
}

/* Returns whether a coordinate of csv without bytes is a gap that may be replaced where
 * it is: blanks, as the CR of CR LF, do not precede it. */
INLINE bool is_gap(const struct walker *p, struct dialect d, const struct target *t)
{
	char before = (p->text + p->at)[-1];

	return d.format == FORMAT_CSV &&
	    (before == d.separator || before == '"' || p->at == t->begin);
}

/* Passes the number that is coordinate k. Returns false if it is too long for vector
 * code or, in JSON, not legal. */
INLINE bool pass_number(struct walker *p, struct dialect d, const struct target *t,
    int k)
{
	uint32_t from = p->at, to = *p->stop;
	bool fits = to - from - 1 < PLAIN_MAX;

	if (!fits && (to != from || !is_gap(p, d, t)))
		return false;
	if (d.format == FORMAT_JSON && !is_json_number(p->text + from, p->text + to))
		return false;
	t->line->at[k] = (struct part){ from - t->begin, to - t->begin };
	t->places[k].end[t->i] = p->text + to;
	t->places[k].size[t->i] = (uint8_t)(to - from);
	if (!fits)
		set_dummy_number(k, t->i, t->places);
	p->at = to;
	p->found++;
	return true;
}

INLINE bool pass_coordinate(struct walker *p, struct dialect d, const struct target *t,
    int k)
{
	bool quoted = d.format == FORMAT_CSV && stop_is(p, '"');

	if (__builtin_expect(!quoted, 1))
		return pass_number(p, d, t, k);
	pass_stop(p);
	if (!pass_number(p, d, t, k) || !stop_is(p, '"'))
		return false;
	pass_stop(p);
	return true;
}

/* How coordinate i is found: as field i, as field walk->field[i], or by its name. */
enum walk_way { BY_ORDER, BY_COLUMN, BY_NAME };

/* The form of the lines of a batch. All members are constants where it is compiled. */
struct form {
	struct dialect in;
	int n; /* the number of coordinates */
	enum walk_way way;
	bool whole; /* all fields are passed, not those to the last coordinate alone */
};

static bool pass_brackets_of_value(struct walker *, int levels);

/* Passes a JSON value that is not a coordinate. */
INLINE bool pass_value(struct walker *p, int levels)
{
	uint32_t from = p->at;

	if (stop_is(p, '{') || stop_is(p, '[')) {
		struct walker inside = *p; /* p stays in registers */
		bool ok = pass_brackets_of_value(&inside, levels);

		*p = inside;
		return ok;
	}
	if (stop_is(p, '"'))
		return pass_string(p, true);
	p->at = *p->stop;
	return json_scalar_end(p->text + from, p->text + p->at) == p->text + p->at;
}

INLINE bool pass_name(struct walker *p, bool may_have_escapes, struct span *name)
{
	const struct dialect json = { FORMAT_JSON, ',' };

	name->s = p->text + p->at + 1;
	if (!stop_is(p, '"') || !pass_string(p, may_have_escapes))
		return false;
	name->end = p->text + p->at - 1;
	pass_blanks(p, json);
	if (p->text[p->at++] != ':')
		return false;
	pass_blanks(p, json);
	return true;
}

/* Passes an array or object in a field, which may have this many levels of brackets. */
static bool pass_brackets_of_value(struct walker *p, int levels)
{
	const struct dialect json = { FORMAT_JSON, ',' };
	const bool members = stop_is(p, '{');
	const char close = members ? '}' : ']';
	struct span name;

	if (levels == 0)
		return false;
	pass_stop(p);
	pass_blanks(p, json);
	for (bool more = !stop_is(p, close); more;) {
		if ((members && !pass_name(p, true, &name)) ||
		    !pass_value(p, levels - 1))
			return false;
		more = pass_separator(p, json);
	}
	if (!stop_is(p, close))
		return false;
	pass_stop(p);
	pass_blanks(p, json);
	return true;
}

/* The most levels of arrays and objects in a field of a usual line. */
enum { LEVELS_MAX = 8 };

/* What identify_field and pass_field return beside the number of a coordinate. */
enum { NO_COORDINATE = -1, NOT_USUAL = -2, LAST_FIELD = -3, MORE_FIELDS = -4 };

static bool is_taken(const char *const *taken, struct span name)
{
	for (; *taken != NULL; taken++)
		if (span_is(name, *taken))
			return true;
	return false;
}

/* Returns the coordinate of this name, or NO_COORDINATE; NOT_USUAL if it was there, or
 * if the output has a member of this name. */
INLINE int coordinate_named(const struct walk *w, int n, struct span name,
    unsigned *passed)
{
	const size_t size = span_size(name);

	for (int i = 0; i < n; i++) {
		if (w->size[i] != size || *w->name[i] != *name.s ||
		    (size > 1 && memcmp(w->name[i], name.s, size) != 0))
			continue;
		const bool repeated = (*passed >> i & 1) != 0;

		*passed |= 1u << i;
		return repeated ? NOT_USUAL : i;
	}
	return *w->taken != NULL && is_taken(w->taken, name) ? NOT_USUAL :
							       NO_COORDINATE;
}

/* Passes a name; returns the coordinate that is field k, or another result. */
INLINE int identify_field(struct walker *p, struct form f, const struct walk *w, int k,
    unsigned *passed)
{
	struct span name;

	if (f.way == BY_ORDER)
		return k < f.n ? k : NO_COORDINATE;
	if (f.way == BY_NAME)
		return pass_name(p, false, &name) ?
		    coordinate_named(w, f.n, name, passed) :
		    NOT_USUAL;
	for (int i = 0; i < f.n; i++)
		if (w->field[i] == k)
			return i;
	return NO_COORDINATE;
}

/* Returns LAST_FIELD or another result. */
INLINE int pass_field(struct walker *p, struct form f, const struct target *t, int k,
    unsigned *passed)
{
	const int i = identify_field(p, f, t->walk, k, passed);

	if (i == NOT_USUAL)
		return NOT_USUAL;
	if (i >= 0                         ? !pass_coordinate(p, f.in, t, i) :
		f.in.format == FORMAT_JSON ? !pass_value(p, LEVELS_MAX) :
					     !pass_other_field(p, f.in))
		return NOT_USUAL;
	if ((!f.whole && p->found == f.n) || stop_is(p, '\n') ||
	    !pass_separator(p, f.in))
		return LAST_FIELD;
	return MORE_FIELDS;
}

/* Passes all fields or, if they are not whole, the fields up to the last coordinate. */
INLINE bool pass_fields(struct walker *p, struct form f, const struct target *t)
{
	const int unrolled = f.way == BY_ORDER ? f.n : 0;
	const struct walk *w = t->walk;
	int more = MORE_FIELDS, k = 0;
	unsigned passed = 0;

#pragma GCC unroll 4
	for (; k < unrolled && more == MORE_FIELDS; k++)
		more = pass_field(p, f, t, k, &passed);
	for (; more == MORE_FIELDS; k++)
		more = pass_field(p, f, t, k, &passed);
	if (more == NOT_USUAL || p->found != f.n)
		return false;
	if (f.in.format == FORMAT_JSON || !f.whole || w->fields == 0 || k == w->fields)
		return true;
	return f.in.format == FORMAT_CSV && w->one_more && k == w->fields + 1 &&
	    p->text[p->at - 1] == f.in.separator;
}

/* Passes the line up to its end or, if it is not whole, to its last coordinate. */
INLINE bool pass_line(struct walker *p, struct form f, const struct target *t)
{
	const char open = f.way == BY_NAME ? '{' : '[';

	p->found = 0;
	t->line->object = f.way == BY_NAME;
	pass_blanks(p, f.in);
	if (f.in.format == FORMAT_JSON) {
		if (!stop_is(p, open))
			return false;
		pass_stop(p);
		pass_blanks(p, f.in);
		/* ] and } follow [ and { by two in ASCII */
		if (!pass_fields(p, f, t) || !stop_is(p, (char)(open + 2)))
			return false;
		pass_stop(p);
		pass_blanks(p, f.in);
		return stop_is(p, '\n');
	}
	if (f.in.format == FORMAT_OBJ) {
		if (p->text[p->at] != 'v' || *p->stop != ++p->at || stop_is(p, '\n'))
			return false;
		pass_blanks(p, f.in);
	}
	return p->text[p->at] != '#' && pass_fields(p, f, t) &&
	    (!f.whole || stop_is(p, '\n'));
}

static void set_dummy_numbers(int n, size_t i, struct plain_places places[4])
{
	for (int k = 0; k < n; k++)
		set_dummy_number(k, i, places);
}

INLINE size_t walk_batch(struct stretch *s, const struct walk *walk, struct form f,
    size_t max, struct line *lines, struct plain_places places[4], uint64_t *left)
{
	struct walker p = { s->text, s->at, s->next, 0 };
	const bool usual = s->usual;
	uint32_t end = s->end;
	size_t i;

	*left = 0;
	for (i = 0; i < max && p.at < end; i++) {
		uint32_t begin = p.at;
		const struct target t = { walk, &lines[i], begin, i, places };

		lines[i].object = lines[i].has_bom = false;
		bool found = usual && p.text + begin - s->readable >= PLAIN_READABLE &&
		    pass_line(&p, f, &t);

		while (p.text[*p.stop] != '\n')
			p.stop++;
		if (!found) {
			set_dummy_numbers(f.n, i, places);
			*left |= (uint64_t)1 << i;
		}
		p.at = *p.stop++;
		lines[i].s = p.text + begin;
		lines[i].size = p.at++ - begin;
		lines[i].kind = LINE_POINT;
		lines[i].newline = true;
	}
	for (size_t k = i; k % PLAIN_GROUP != 0; k++)
		set_dummy_numbers(f.n, k, places);
	s->at = p.at;
	s->next = p.stop;
	return i;
}

/* Points of three coordinates that are the first fields have a copy of walk_batch. */
INLINE size_t walk_dialect(struct stretch *s, const struct walk *w, struct dialect d,
    bool whole, size_t max, struct line *lines, struct plain_places places[4],
    uint64_t *left)
{
	const struct form usual = { d, 3, BY_ORDER, whole };
	const struct form any = { d, w->n, BY_COLUMN, whole };

	if (w->n == 3 && !w->by_column)
		return walk_batch(s, w, usual, max, lines, places, left);
	return walk_batch(s, w, any, max, lines, places, left);
}

/* Not inlined into walk_lines, which would then have too few registers. */
static __attribute__((noinline)) size_t walk_objects(struct stretch *s,
    const struct walk *walk, size_t max, struct line *lines,
    struct plain_places places[4], uint64_t *left)
{
	const struct form f = { { FORMAT_JSON, ',' }, walk->n, BY_NAME, true };

	return walk_batch(s, walk, f, max, lines, places, left);
}

static __attribute__((noinline)) size_t walk_other_text(struct stretch *s,
    const struct walk *w, size_t max, struct line *lines, struct plain_places places[4],
    uint64_t *left)
{
	const struct dialect text = { FORMAT_TEXT, ' ' }, obj = { FORMAT_OBJ, ' ' };

	if (w->in.format == FORMAT_OBJ)
		return walk_batch(s, w, (struct form){ obj, w->n, BY_COLUMN, false },
		    max, lines, places, left);
	return walk_dialect(s, w, text, true, max, lines, places, left);
}

size_t walk_lines(struct stretch *s, const struct walk *walk, size_t n,
    struct line lines[PLAIN_BATCH], struct plain_places places[4], uint64_t *left)
{
	const struct dialect json = { FORMAT_JSON, ',' }, text = { FORMAT_TEXT, ' ' },
			     csv = { FORMAT_CSV, walk->in.separator };

	/* In each copy of walk_batch the form is a constant. The first of n lines of
	 * JSON decides whether all are walked as arrays or as objects. */
	if (walk->in.format == FORMAT_CSV)
		return walk_dialect(s, walk, csv, true, n, lines, places, left);
	if (walk->in.format == FORMAT_TEXT && walk->fields == 0)
		return walk_dialect(s, walk, text, false, n, lines, places, left);
	if (walk->in.format != FORMAT_JSON)
		return walk_other_text(s, walk, n, lines, places, left);
	if (walk->name[0] != NULL && (s->text[s->at] == '{' || !walk->arrays))
		return walk_objects(s, walk, n, lines, places, left);
	return walk_dialect(s, walk, json, true, n, lines, places, left);
}

uint64_t walk_numbers(const struct walk *walk, const struct line *lines, size_t n,
    const struct plain_places at[4], uint64_t left, double v[4][PLAIN_BATCH])
{
	uint64_t unread[4], any = 0;

	for (int k = 0; k < walk->n; k++)
		any |= unread[k] = number_loops_chosen()->read(&at[k], n, v[k]);
	for (any &= ~left; any != 0; any &= any - 1) {
		int i = __builtin_ctzll(any);

		for (int k = 0; k < walk->n; k++) {
			struct span f = line_field(&lines[i], k);

			/* a number such as 1e-300 that vector code does not read */
			if ((unread[k] >> i & 1) != 0 &&
			    (format_read(walk->in, f.s, f.end, &v[k][i]) != f.end ||
				fabs(v[k][i]) > SCENE_MAGNITUDE_MAX))
				left |= (uint64_t)1 << i;
		}
	}
	return left;
}
