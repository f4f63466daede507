/* SPDX-License-Identifier: MIT */
#include "walk.h"

#include <math.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../json/text.h"

/* So that there is a copy of the walk for each format, of which what does not concern
 * it falls away. */
#define INLINE static inline __attribute__((always_inline))

/* What can end a field: blanks, newlines and commas; in csv quotes, where the
 * field is to be left; in JSON brackets, and what strings hold but rarely. */
#define TEXT_STOPS "\t\n\v\f\r ,"
#define CONTROLS                                                  \
	"\0\1\2\3\4\5\6\7\10\16\17\20\21\22\23\24\25\26\27\30\31" \
	"\32\33\34\35\36\37"
static const char text_stops[] = TEXT_STOPS,
		  json_stops[] = TEXT_STOPS "\"[]{}\\" CONTROLS;

/* A bit for each value of the upper four: there may be eight of these. */
static struct byte_set set_of(const char *bytes, size_t n)
{
	struct byte_set set = { { 0 }, { 0 } };
	int bits = 0;

	for (size_t i = 0; i < n; i++) {
		uint8_t b = (uint8_t)bytes[i], *bit = &set.high[b >> 4];

		if (*bit == 0)
			*bit = (uint8_t)(1 << bits++);
		set.low[b & 15] |= *bit;
	}
	return set;
}

static struct byte_set stops_of(struct dialect d)
{
	const char csv_stops[] = { '\t', '\n', '\v', '\f', '\r', ' ', '"',
		d.separator };

	switch (d.format) {
	case FORMAT_CSV:
		return set_of(csv_stops, sizeof csv_stops);
	case FORMAT_JSON:
		return set_of(json_stops, sizeof json_stops - 1);
	default:
		return set_of(text_stops, sizeof text_stops - 1);
	}
}

/* In JSON names are of an object's members, and numbers of an array's elements;
 * where there are neither, lines may be either. */
static void plan_members(const struct layout *l, struct walk *w)
{
	const struct columns *c = &l->columns;

	w->arrays = c->n == 0 || c->name[0] == NULL;
	w->objects = c->n == 0 || c->name[0] != NULL;
	for (int i = 0; i < l->reads && w->objects; i++) {
		const char *name = layout_path(l, i);
		bool pointer = *name == '/';

		w->paths |= pointer;
		w->objects = !strchr(name + pointer, pointer ? '~' : '/');
		w->name[i] = name + pointer;
		w->name_size[i] = strlen(w->name[i]);
	}
}

bool walk_plan(const struct layout *l, struct walk *w)
{
	const int *field = l->columns.field;
	int n = l->reads, last = -1;

	*w = (struct walk){ .in = l->in,
		.stops = stops_of(l->in),
		.n = n,
		.arrays = true,
		.columns = l->columns.n > 0 };
	for (int i = 0; i < n; i++)
		w->coordinate[i] = i;
	if (l->in.format == FORMAT_JSON)
		plan_members(l, w);
	if (!w->arrays)
		return w->objects;
	if (!w->columns)
		return true;
	for (int i = 0; i < n; i++) {
		int k = i;

		for (; k > 0 && field[w->coordinate[k - 1]] > field[i]; k--)
			w->coordinate[k] = w->coordinate[k - 1];
		w->coordinate[k] = i;
	}
	for (int i = 0; i < n; i++) {
		w->skip[i] = field[w->coordinate[i]] - last - 1;
		last = field[w->coordinate[i]];
		if (w->skip[i] < 0)
			return false;
	}
	return true;
}

bool stretch_open(struct stretch *w, const struct walk *walk, const char *text,
    const char *end)
{
	size_t size = (size_t)(end - text), n;

	if (size > STRETCH)
		size = STRETCH;
	n = plain_reader()->find(&walk->stops, text, size, w->stop);
	while (n > 0 && text[w->stop[n - 1]] != '\n')
		n--;
	w->text = text;
	w->at = 0;
	w->end = n > 0 ? w->stop[n - 1] + 1u : 0;
	w->next = w->stop;
	return n > 0;
}

/* On the way through a line: at and the first stop from there on, which is never
 * beyond the newline. */
struct walker {
	const char *text;
	uint32_t at;
	const uint16_t *stop;
	bool comma; /* in the separator that was passed last */
	int found;  /* coordinates that paths led to */
};

INLINE bool stands(const struct walker *p, char c)
{
	return *p->stop == p->at && p->text[p->at] == c;
}

INLINE void pass(struct walker *p)
{
	p->at++;
	p->stop++;
}

INLINE void pass_blanks(struct walker *p, struct dialect d)
{
	while (*p->stop == p->at && is_blank_of(d, p->text[p->at]))
		pass(p);
}

/* As skip_separator in text; elsewhere something has to separate. Most separators
 * are of one byte. */
INLINE bool pass_separator(struct walker *p, struct dialect d)
{
	bool text = d.format == FORMAT_TEXT;
	char comma = text ? ',' : d.separator, c = p->text[p->at];

	if (p->stop[1] > p->at + 1 && *p->stop == p->at &&
	    (text ? c != '\n' : c == comma)) {
		p->comma = c == comma;
		pass(p);
		return true;
	}
	pass_blanks(p, d);
	p->comma = stands(p, comma);
	if (p->comma) {
		pass(p);
		pass_blanks(p, d);
	}
	return p->comma || (text && !stands(p, '\n'));
}

/* Returns how many stops the escape at the backslash s has behind that; -1 if it is
 * none. */
static int escaped_stops(const char *s)
{
	unsigned code;

	if (s[1] == 'u')
		return json_hex4(s + 2, s + 6, &code) == s + 6 ? 0 : -1;
	if (s[1] == '"' || s[1] == '\\')
		return 1;
	return s[1] != '\0' && strchr("/bfnrt", s[1]) != NULL ? 0 : -1;
}

/* Passes a string of JSON. The string of a name may have no escapes, which could
 * spell the name of a coordinate. */
INLINE bool pass_string(struct walker *p, bool name)
{
	for (p->stop++; p->text[*p->stop] != '"'; p->stop++) {
		const char *s = &p->text[*p->stop];
		int stops = -1;

		if (__builtin_expect(*s == '\\', 0) && !name)
			stops = escaped_stops(s);
		if (stops < 0 && (*s == '\\' || (unsigned char)*s < ' '))
			return false;
		p->stop += stops > 0;
	}
	p->at = *p->stop++ + 1u;
	return true;
}

/* Whether a plain number is one of JSON: it has no 0 before another digit, and
 * digits on both sides of its point. */
INLINE bool is_narrow(const char *s, const char *end)
{
	s += *s == '-';
	/* what the first digits are the processor could not guess: no branches */
	return !(((*s == '0') & (s[1] >= '0') & (s[1] <= '9')) | (*s == '.') |
	    (end[-1] == '.'));
}

/* Returns whether it is a number or a word of JSON. */
static bool is_scalar(const char *s, const char *end)
{
	size_t n = (size_t)(end - s);

	return json_number_end(s, end) == end ||
	    (n == 4 && memcmp(s, "true", 4) == 0) ||
	    (n == 5 && memcmp(s, "false", 5) == 0) ||
	    (n == 4 && memcmp(s, "null", 4) == 0);
}

/* The line of which coordinates are found, with number i. */
struct target {
	struct line *line;
	uint32_t begin;
	size_t i;
	struct plain_places *places;
};

/* Past coordinate k; false where it can't be a plain number. */
INLINE bool pass_coordinate(struct walker *p, struct dialect d,
    const struct target *t, int k)
{
	uint32_t from = p->at, to = *p->stop;

	if (to - from - 1 >= PLAIN_MAX ||
	    (d.format == FORMAT_JSON &&
		!is_narrow(p->text + from, p->text + to)))
		return false;
	t->line->at[k] = (struct part){ from - t->begin, to - t->begin };
	t->places[k].end[t->i] = p->text + to;
	t->places[k].size[t->i] = (uint8_t)(to - from);
	p->at = to;
	return true;
}

/* How deep values that are passed may be nested. */
enum { LEVELS = 8 };

/* What stands at the end of a path into a value. */
enum { NOTHING = -1, MORE = -2, ODD = -3 };

/* Returns the coordinate whose path ends at the member, or at element k if the member
 * has no name; MORE if paths lead into it, with what is left of them in rest. */
static int follow(const struct walk *w, const char *const path[4],
    struct span name, int k, unsigned *led, const char *rest[4])
{
	const char digit = (char)('0' + k);
	int found = NOTHING;

	if (name.s == NULL && k > 9)
		return ODD;
	if (name.s == NULL)
		name = (struct span){ &digit, &digit + 1 };
	size_t n = (size_t)(name.end - name.s);
	bool slash = memchr(name.s, '/', n) != NULL;

	for (int i = 0; i < w->n; i++) {
		rest[i] = NULL;
		if (path[i] == NULL || slash ||
		    strncmp(path[i], name.s, n) != 0 ||
		    (path[i][n] != '\0' && path[i][n] != '/'))
			continue;
		int what = path[i][n] == '\0' ? i : MORE;

		if ((*led >> i & 1) != 0 ||
		    (found != NOTHING && (found != MORE || what != MORE)))
			return ODD;
		*led |= 1u << i;
		found = what;
		if (what == MORE)
			rest[i] = path[i] + n + 1;
	}
	return found;
}

/* Where paths lead into a value; path is NULL where none does. */
struct trail {
	const struct walk *walk;
	const struct target *target;
	const char *const *path;
	int levels; /* how deep the value may be nested */
};

/* Passes a value of JSON, and the coordinates in it. Returns false where line_read is
 * to look at it. */
static bool pass_value(struct walker *p, struct dialect d, struct trail t)
{
	bool members = stands(p, '{'), ok = true;
	const char close = members ? '}' : ']', *rest[4];
	const struct trail none = { .levels = t.levels - 1 },
			   inside = { t.walk, t.target, rest, t.levels - 1 };
	uint32_t from = p->at;
	unsigned led = 0;

	if (!members && !stands(p, '[')) {
		if (stands(p, '"'))
			return t.path == NULL && pass_string(p, false);
		p->at = *p->stop;
		return t.path == NULL &&
		    is_scalar(p->text + from, p->text + p->at);
	}
	for (int k = 0; ok && (k == 0 || stands(p, ',')); k++) {
		struct span name = { NULL, NULL };

		pass(p);
		pass_blanks(p, d);
		if (k == 0 && stands(p, close))
			break;
		if (members) {
			name.s = p->text + p->at + 1;
			if (!stands(p, '"') || !pass_string(p, t.path != NULL))
				return false;
			name.end = p->text + p->at - 1;
			pass_blanks(p, d);
			if (p->text[p->at++] != ':')
				return false;
			pass_blanks(p, d);
		}
		int what = t.path == NULL ?
		    NOTHING :
		    follow(t.walk, t.path, name, k, &led, rest);

		p->found += what >= 0;
		ok = what != ODD && t.levels > 0 &&
		    (what >= 0 ?
			    pass_coordinate(p, d, t.target, what) :
			    pass_value(p, d, what == MORE ? inside : none));
		pass_blanks(p, d);
	}
	if (!ok || !stands(p, close))
		return false;
	pass(p);
	return true;
}

/* Passes a field of csv in quotes in which no quote stands. */
INLINE bool pass_quoted(struct walker *p)
{
	for (p->stop++; p->text[*p->stop] != '"'; p->stop++)
		if (p->text[*p->stop] == '\n')
			return false;
	p->at = *p->stop++ + 1u;
	return !stands(p, '"');
}

/* Past a field that is no coordinate. */
INLINE bool pass_field(struct walker *p, struct dialect d)
{
	uint32_t from = p->at;

	if (d.format == FORMAT_JSON && stands(p, '"'))
		return pass_string(p, false);
	if (d.format == FORMAT_JSON && (stands(p, '{') || stands(p, '[')))
		return pass_value(p, d, (struct trail){ .levels = LEVELS });
	if (d.format == FORMAT_CSV && stands(p, '"'))
		return pass_quoted(p);
	if (d.format == FORMAT_CSV)
		while (is_blank_of(d, p->text[*p->stop]))
			p->stop++;
	p->at = *p->stop;
	return p->text[p->at] != '"' &&
	    (d.format != FORMAT_JSON ||
		is_scalar(p->text + from, p->text + p->at));
}

/* Past the last coordinate: whether all up to the newline is right, too. In text
 * and csv, anything is that begins with a separator. */
INLINE bool pass_rest(struct walker *p, struct dialect d)
{
	if (d.format != FORMAT_TEXT)
		pass_blanks(p, d);
	if (d.format != FORMAT_JSON)
		return *p->stop == p->at && p->text[p->at] != '"';
	while (stands(p, ',')) {
		pass_separator(p, d);
		if (!pass_field(p, d))
			return false;
		pass_blanks(p, d);
	}
	if (!stands(p, ']'))
		return false;
	pass(p);
	pass_blanks(p, d);
	return stands(p, '\n');
}

/* Past coordinate k of a line of fields, which in csv may stand in quotes. */
INLINE bool pass_place(struct walker *p, struct dialect d,
    const struct target *t, int k)
{
	bool quoted = d.format == FORMAT_CSV && stands(p, '"');

	if (__builtin_expect(!quoted, 1))
		return pass_coordinate(p, d, t, k);
	pass(p);
	if (!pass_coordinate(p, d, t, k) || !stands(p, '"'))
		return false;
	pass(p);
	return true;
}

/* Which coordinate has that name, or -1. */
INLINE int coordinate_of(const struct walk *w, const char *name, size_t n)
{
	for (int k = 0; k < w->n; k++)
		if (w->name_size[k] == n && w->name[k][0] == *name &&
		    (n == 1 || memcmp(w->name[k], name, n) == 0))
			return k;
	return -1;
}

/* Past a name and its colon: which coordinate it is, or -1; -2 where it isn't as
 * usual. */
INLINE int pass_name(struct walker *p, const struct walk *w, struct dialect d)
{
	uint32_t from = p->at + 1, to;

	if (!stands(p, '"') || !pass_string(p, true))
		return -2;
	to = p->at - 1;
	pass_blanks(p, d);
	if (p->text[p->at] != ':')
		return -2;
	p->at++;
	pass_blanks(p, d);
	return to > from ? coordinate_of(w, p->text + from, to - from) : -1;
}

/* Where the coordinates stand in an object whose values are numbers, words and
 * strings; false where it is to be left. */
INLINE bool find_members(struct walker *p, const struct walk *w,
    struct dialect d, int n, const struct target *t)
{
	unsigned seen = 0, all = (1u << n) - 1;

	pass_blanks(p, d);
	if (!stands(p, '{'))
		return false;
	t->line->object = true;
	do {
		pass(p);
		pass_blanks(p, d);
		int k = pass_name(p, w, d);

		if (k == -2 || (k >= 0 && (seen >> k & 1) != 0))
			return false;
		if (k >= 0)
			seen |= 1u << k;
		if (k >= 0 ? !pass_coordinate(p, d, t, k) : !pass_field(p, d))
			return false;
		pass_blanks(p, d);
	} while (stands(p, ','));
	if (!stands(p, '}') || seen != all)
		return false;
	pass(p);
	pass_blanks(p, d);
	return stands(p, '\n');
}

/* Where the coordinates stand in an object that paths lead into. */
static bool find_paths(struct walker *p, const struct walk *w, struct dialect d,
    const struct target *t)
{
	const struct trail trail = { w, t, w->name, LEVELS };

	pass_blanks(p, d);
	if (!stands(p, '{'))
		return false;
	t->line->object = true;
	p->found = 0;
	if (!pass_value(p, d, trail) || p->found != w->n)
		return false;
	pass_blanks(p, d);
	return stands(p, '\n');
}

/* What the coordinates are of a line. */
enum shape { FIELDS, COLUMNS, MEMBERS, PATHS };

/* Where the coordinates of a line stand; false where it is to be left. That some
 * separators of text have a comma and others have not is left as well. */
INLINE bool walk_coordinates(struct walker *p, const struct walk *w,
    struct dialect d, int n, enum shape shape, const struct target *t)
{
	const bool text = d.format == FORMAT_TEXT, columns = shape == COLUMNS;
	bool comma = false;

	if (shape == MEMBERS)
		return find_members(p, w, d, n, t);
	if (shape == PATHS)
		return find_paths(p, w, d, t);

	pass_blanks(p, d);
	if (p->text[p->at] == '#')
		return false;
	if (d.format == FORMAT_JSON) {
		if (!stands(p, '['))
			return false;
		pass(p);
		pass_blanks(p, d);
	}
#pragma GCC unroll 3
	for (int m = 0; m < n; m++) {
		for (int skip = columns ? w->skip[m] : 0; skip > 0; skip--)
			if (!pass_field(p, d) || !pass_separator(p, d) ||
			    (text && m > 0 && p->comma != comma))
				return false;
		if (!pass_place(p, d, t, columns ? w->coordinate[m] : m))
			return false;
		if (m + 1 == n)
			break;
		if (!pass_separator(p, d) ||
		    (text && m > 0 && p->comma != comma))
			return false;
		comma = p->comma;
	}
	if (!pass_rest(p, d))
		return false;
	/* what comes next may be a number */
	if (!text || stands(p, '\n'))
		return true;
	if (n != 2)
		return comma || !stands(p, ',');
	pass_separator(p, d);
	return stands(p, '\n') || p->comma == comma;
}

/* To the newline, over quotes that open right behind a separator and close right
 * before one; false where they don't, as "" in quotes and 5" without. */
INLINE bool pass_quotes(struct walker *p, char separator)
{
	bool open = false, odd = false;

	for (; p->text[*p->stop] != '\n'; p->stop++) {
		const char *s = p->text + *p->stop;

		if (*s != '"')
			continue;
		odd |= open ?
		    s[1] != separator && s[1] != '\n' && s[1] != '\r' :
		    s[-1] != separator;
		open = !open;
	}
	return !open && !odd;
}

/* What stands for the numbers of a line that is left. */
static void no_numbers(int n, size_t i, struct plain_places places[4])
{
	static const char none[PLAIN_BEFORE + 1] = "";

	for (int k = 0; k < n; k++) {
		places[k].end[i] = none + sizeof none;
		places[k].size[i] = 1;
	}
}

INLINE size_t walk_take(struct stretch *s, const struct walk *walk,
    struct dialect d, int n, enum shape shape, size_t max, struct line *lines,
    struct plain_places places[4], uint64_t *left)
{
	struct walker p = { s->text, s->at, s->next, false, 0 };
	uint32_t end = s->end;
	size_t i;

	*left = 0;
	for (i = 0; i < max && p.at < end; i++) {
		uint32_t begin = p.at;
		const struct target t = { &lines[i], begin, i, places };

		lines[i].object = lines[i].words = lines[i].mark = false;
		bool found = p.text + begin - s->readable >= PLAIN_BEFORE &&
		    walk_coordinates(&p, walk, d, n, shape, &t) &&
		    (d.format != FORMAT_CSV || pass_quotes(&p, d.separator));

		while (p.text[*p.stop] != '\n')
			p.stop++;
		if (!found) {
			no_numbers(n, i, places);
			*left |= (uint64_t)1 << i;
		}
		p.at = *p.stop++;
		lines[i].s = p.text + begin;
		lines[i].size = p.at++ - begin;
		lines[i].kind = LINE_POINT;
		lines[i].newline = true;
	}
	for (size_t k = i; k % PLAIN_GROUP != 0; k++)
		no_numbers(n, k, places);
	s->at = p.at;
	s->next = p.stop;
	return i;
}

/* Three coordinates are what is usual. */
INLINE size_t take_dialect(struct stretch *s, const struct walk *walk,
    struct dialect d, size_t max, struct line *lines,
    struct plain_places places[4], uint64_t *left)
{
	if (walk->n != 3)
		return walk_take(s, walk, d, walk->n, COLUMNS, max, lines,
		    places, left);
	if (walk->columns)
		return walk_take(s, walk, d, 3, COLUMNS, max, lines, places,
		    left);
	return walk_take(s, walk, d, 3, FIELDS, max, lines, places, left);
}

/* Lines of JSON are mostly like the first of them. */
static size_t take_json(struct stretch *s, const struct walk *walk, size_t max,
    struct line *lines, struct plain_places places[4], uint64_t *left)
{
	const struct dialect d = { FORMAT_JSON, ',' };

	if (walk->objects && walk->paths)
		return walk_take(s, walk, d, walk->n, PATHS, max, lines, places,
		    left);
	if (walk->objects && (s->text[s->at] == '{' || !walk->arrays))
		return walk_take(s, walk, d, walk->n, MEMBERS, max, lines,
		    places, left);
	return take_dialect(s, walk, d, max, lines, places, left);
}

size_t walk_lines(struct stretch *s, const struct walk *walk, size_t n,
    struct line lines[PLAIN_BATCH], struct plain_places places[4],
    uint64_t *left)
{
	/* so that each format's copy is made with it as a constant */
	switch (walk->in.format) {
	case FORMAT_CSV:
		return take_dialect(s, walk,
		    (struct dialect){ FORMAT_CSV, walk->in.separator }, n,
		    lines, places, left);
	case FORMAT_JSON:
		return take_json(s, walk, n, lines, places, left);
	default:
		return take_dialect(s, walk,
		    (struct dialect){ FORMAT_TEXT, ' ' }, n, lines, places,
		    left);
	}
}

/* Reads a number that is not plain, such as 1e-3. Returns false where only line_read
 * can tell what it is. */
static bool read_number(struct dialect d, struct span f, const char *readable,
    double *v)
{
	const char *end = d.format == FORMAT_JSON ?
	    json_number(f.s, f.end, v) :
	    number_read(f.s, readable, v);

	return end == f.end && !(fabs(*v) > MAGNITUDE_MAX);
}

uint64_t walk_numbers(const struct walk *walk, const struct line *lines,
    size_t n, const struct plain_places at[4], uint64_t left,
    const char *readable, double v[4][PLAIN_BATCH])
{
	uint64_t odd[4], some = 0;

	for (int k = 0; k < walk->n; k++)
		some |= odd[k] = plain_reader()->read(&at[k], n, v[k]);
	for (some &= ~left; some != 0; some &= some - 1) {
		int i = __builtin_ctzll(some);
		bool ok = true;

		for (int k = 0; k < walk->n && ok; k++)
			ok = (odd[k] >> i & 1) == 0 ||
			    read_number(walk->in, line_at(&lines[i], k),
				readable, &v[k][i]);
		if (!ok)
			left |= (uint64_t)1 << i;
	}
	return left;
}
