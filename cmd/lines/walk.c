/* SPDX-License-Identifier: MIT */
#include "walk.h"

#include <math.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "walker.h"

static struct byte_set stretch_stops(struct dialect d)
{
	const struct format_row *row = format_of(d);
	const bool json = *row->open != '\0';
	struct byte_set set = { { 0 }, { 0 } };
	int bits = 0;

	for (int b = 0; b < 256; b++) {
		/* stops with the same upper four bits share one of 8 bits */
		uint8_t *bit = &set.high[b >> 4];
		char c = (char)b;

		if (c != '\n' && !is_blank(c) && c != d.separator &&
		    !(row->blanks && c == ',') &&
		    (row->quote == 0 || (c != row->quote && c != row->escape)) &&
		    !(json && (b < ' ' || strchr("[]{}", c) != NULL)))
			continue;
		if (*bit == 0)
			*bit = (uint8_t)(1 << bits++);
		set.low[b & 15] |= *bit;
	}
	return set;
}

bool stretch_open(struct stretch *s, const struct byte_set *stops, const char *text,
    const char *end)
{
	size_t size = (size_t)(end - text), n;

	if (size > STRETCH_MAX)
		size = STRETCH_MAX;
	/* a line with a NUL is wrong wherever it stands, and line_read says so */
	const char *nul = memchr(text, '\0', size);

	if (nul != NULL)
		size = (size_t)(nul - text);
	n = number_loops_chosen()->find(stops, text, size, s->stop);
	while (n > 0 && text[s->stop[n - 1]] != '\n')
		n--;
	s->text = text;
	s->at = 0;
	s->end = n > 0 ? s->stop[n - 1] + 1u : 0;
	s->next = s->stop;
	return n > 0;
}

bool walk_plan(const struct layout *l, struct walk *w)
{
	const struct columns *c = &l->columns;
	const bool json = l->in.format == FORMAT_JSON;

	*w = (struct walk){ .in = l->in,
		.stops = stretch_stops(l->in),
		.n = l->reads,
		.exact_fields = l->output.append ? (int)l->seen.header_fields : 0,
		.max_fields = l->seen.header_fields > 0 ? (int)l->seen.max_fields :
							  STRETCH_MAX,
		.added_names = l->output.append ? l->output.name : NULL,
		.arrays = !json || c->n == 0 || c->name[0] == NULL,
		.objects = json && (c->n == 0 || c->name[0] != NULL),
		.by_column = !layout_in_order(l) };
	for (int i = 0; i < l->reads; i++)
		w->field[i] = layout_field(l, i);
	for (int i = 0; i < l->reads && w->objects; i++) {
		const char *name = l->columns.name[i];
		bool pointer = *name == '/';

		name += pointer;
		w->objects = !pointer || strchr(name, '~') == NULL;
		w->paths.path[i] = name;
		w->paths.size[i] = pointer ? strcspn(name, "/") : strlen(name);
	}
	return w->arrays || w->objects;
}

/* Where to store what is found in line i of a batch, which begins at byte `begin`. */
struct target {
	const struct walk *walk;
	struct line *line;
	uint32_t begin;
	size_t i;
	struct plain_places *places;
};

/* Sets the place of number k of line i, which is unknown, to a byte
 * that may be read. */
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

/* How coordinate i is found: as field i, as field walk->field[i], by path i, or not. */
enum walk_way { BY_ORDER, BY_COLUMN, BY_PATH, NO_LOOKUP };

static bool pass_nested(struct walker *, const struct target *,
    const struct walk_paths *, unsigned leads, int levels);

/* Results of functions that find or pass a field. NOT_SIMPLE is for line_read. */
enum { NO_COORDINATE = -1, NOT_SIMPLE = -2, LAST_FIELD = -3, MORE_FIELDS = -4 };

INLINE int coordinate_in_column(const struct walk *w, int n, int k)
{
	for (int i = 0; i < n; i++)
		if (w->field[i] == k)
			return i;
	return NO_COORDINATE;
}

static bool is_added_name(const char (*added)[NAME_ROOM], struct span name)
{
	size_t n = (size_t)(name.end - name.s);

	for (int k = 0; k <= COORDINATES_MAX; k++)
		if (added[k][0] == *name.s && n < NAME_ROOM &&
		    memcmp(added[k], name.s, n) == 0 && added[k][n] == '\0')
			return true;
	return false;
}

/* Passes a JSON value that is not a coordinate. Bit i of leads is set if path i leads
 * into the value. */
INLINE bool pass_value(struct walker *p, const struct target *t,
    const struct walk_paths *paths, unsigned leads, int levels)
{
	uint32_t from = p->at;

	if (stop_is(p, '{') || stop_is(p, '[')) {
		struct walker inside = *p; /* p stays in registers */
		bool ok = pass_nested(&inside, t, paths, leads, levels);

		*p = inside;
		return ok;
	}
	if (leads != 0)
		return false;
	if (stop_is(p, '"'))
		return pass_string(p, true);
	p->at = *p->stop;
	return json_scalar_end(p->text + from, p->text + p->at) == p->text + p->at;
}

INLINE bool pass_name(struct walker *p, struct dialect d, bool may_have_escapes,
    struct span *name)
{
	name->s = p->text + p->at + 1;
	if (!stop_is(p, '"') || !pass_string(p, may_have_escapes))
		return false;
	name->end = p->text + p->at - 1;
	pass_blanks(p, d);
	if (p->text[p->at++] != ':')
		return false;
	pass_blanks(p, d);
	return true;
}

struct fields {
	int n; /* the number of coordinates */
	enum walk_way lookup;
	bool members; /* the fields are members of an object */
	const struct walk_paths *paths;
	int levels;      /* the most levels of brackets in a field */
	unsigned passed; /* bit i: a field on path i has been passed */
	/* separators passed, and how many of them have a comma */
	int separators, commas;
};

/* Passes a name; returns the coordinate that is field k, or another result. */
INLINE int identify_field(struct walker *p, struct dialect d, struct fields *f,
    const struct walk *w, int k, unsigned *leads)
{
	const char digit = (char)('0' + k);
	struct span name = { &digit, &digit + 1 };

	*leads = 0;
	if (f->members && !pass_name(p, d, f->lookup == NO_LOOKUP, &name))
		return NOT_SIMPLE;
	if (f->lookup == BY_ORDER)
		return k < f->n ? k : NO_COORDINATE;
	if (f->lookup == BY_COLUMN)
		return coordinate_in_column(w, f->n, k);
	if (f->lookup == NO_LOOKUP)
		return NO_COORDINATE;
	if (!f->members && k >= 10)
		return NOT_SIMPLE;
	int i = follow_paths(f->paths, f->n, name, leads);
	bool repeated = (f->passed & *leads) != 0;

	f->passed |= *leads;
	if (w->added_names != NULL && f->paths == &w->paths)
		repeated |= is_added_name(w->added_names, name);
	return repeated ? NOT_SIMPLE : i;
}

/* Returns LAST_FIELD (in text, also for the last coordinate) or another result. */
INLINE int pass_field(struct walker *p, struct dialect d, struct fields *f,
    const struct target *t, int k)
{
	unsigned leads;
	int i = identify_field(p, d, f, t->walk, k, &leads);

	if (i == NOT_SIMPLE)
		return NOT_SIMPLE;
	if (i >= 0 ? !pass_coordinate(p, d, t, i) :
		d.format == FORMAT_JSON ?
		     !pass_value(p, t, f->paths, leads, f->levels) :
		     !pass_other_field(p, d))
		return NOT_SIMPLE;
	if ((d.format == FORMAT_TEXT && p->found == f->n) || stop_is(p, '\n') ||
	    !pass_separator(p, d))
		return LAST_FIELD;
	f->separators++;
	f->commas += p->comma;
	return MORE_FIELDS;
}

/* Passes all fields or, in the format text, the fields up to the last coordinate. */
INLINE bool pass_fields(struct walker *p, struct dialect d, struct fields f,
    const struct target *t)
{
	const int unrolled = f.lookup == BY_ORDER ? f.n : 0;
	int more = MORE_FIELDS, k = 0;

#pragma GCC unroll 4
	for (; k < unrolled && more == MORE_FIELDS; k++)
		more = pass_field(p, d, &f, t, k);
	for (; more == MORE_FIELDS; k++)
		more = pass_field(p, d, &f, t, k);
	if (more == NOT_SIMPLE || (d.format != FORMAT_JSON && p->found != f.n))
		return false;
	if (d.format == FORMAT_CSV)
		return t->walk->exact_fields != 0 ?
		    k == t->walk->exact_fields :
		    k - (p->text[p->at - 1] == d.separator) <= t->walk->max_fields;
	if (d.format != FORMAT_TEXT)
		return true;
	return (f.commas == 0 || f.commas == f.separators) &&
	    has_no_decimal_comma(p, d, f.n, f.commas > 0);
}

INLINE bool pass_brackets(struct walker *p, struct fields f, const struct target *t)
{
	const struct dialect json = { FORMAT_JSON, ',' };
	const char close = f.members ? '}' : ']';

	if (!stop_is(p, f.members ? '{' : '['))
		return false;
	pass_stop(p);
	pass_blanks(p, json);
	if (!stop_is(p, close) && (!pass_fields(p, json, f, t) || !stop_is(p, close)))
		return false;
	pass_stop(p);
	pass_blanks(p, json);
	return true;
}

static bool pass_nested(struct walker *p, const struct target *t,
    const struct walk_paths *paths, unsigned leads, int levels)
{
	struct walk_paths inside;

	if (leads != 0)
		inside = paths_inside(paths, leads);
	const struct fields f = { .n = t->walk->n,
		.lookup = leads != 0 ? BY_PATH : NO_LOOKUP,
		.members = stop_is(p, '{'),
		.paths = &inside,
		.levels = levels - 1 };

	return levels > 0 && pass_brackets(p, f, t);
}

/* The most levels of arrays and objects in a field of a simple line. */
enum { LEVELS_MAX = 8 };

/* Passes the line up to its end or, in the format text, to its last coordinate. */
INLINE bool pass_line(struct walker *p, struct dialect d, int n, enum walk_way lookup,
    const struct target *t)
{
	const struct fields f = { .n = n,
		.lookup = lookup,
		.members = lookup == BY_PATH,
		.paths = &t->walk->paths,
		.levels = LEVELS_MAX };

	p->found = 0;
	t->line->object = f.members;
	pass_blanks(p, d);
	if (d.format == FORMAT_JSON)
		return pass_brackets(p, f, t) && p->found == n && stop_is(p, '\n');
	return p->text[p->at] != '#' && pass_fields(p, d, f, t) &&
	    (d.format == FORMAT_TEXT || stop_is(p, '\n'));
}

static void set_dummy_numbers(int n, size_t i, struct plain_places places[4])
{
	for (int k = 0; k < n; k++)
		set_dummy_number(k, i, places);
}

INLINE size_t walk_batch(struct stretch *s, const struct walk *walk, struct dialect d,
    int n, enum walk_way lookup, size_t max, struct line *lines,
    struct plain_places places[4], uint64_t *left)
{
	struct walker p = { s->text, s->at, s->next, false, 0 };
	uint32_t end = s->end;
	size_t i;

	*left = 0;
	for (i = 0; i < max && p.at < end; i++) {
		uint32_t begin = p.at;
		const struct target t = { walk, &lines[i], begin, i, places };

		lines[i].object = lines[i].no_commas = lines[i].has_bom = false;
		bool found = p.text + begin - s->readable >= PLAIN_READABLE &&
		    pass_line(&p, d, n, lookup, &t);

		while (p.text[*p.stop] != '\n')
			p.stop++;
		if (!found) {
			set_dummy_numbers(n, i, places);
			*left |= (uint64_t)1 << i;
		}
		p.at = *p.stop++;
		lines[i].s = p.text + begin;
		lines[i].size = p.at++ - begin;
		lines[i].kind = LINE_POINT;
		lines[i].newline = true;
	}
	for (size_t k = i; k % PLAIN_GROUP != 0; k++)
		set_dummy_numbers(n, k, places);
	s->at = p.at;
	s->next = p.stop;
	return i;
}

/* Points of three coordinates that are the first fields have a copy of walk_batch. */
INLINE size_t walk_dialect(struct stretch *s, const struct walk *walk, struct dialect d,
    size_t max, struct line *lines, struct plain_places places[4], uint64_t *left)
{
	if (walk->n == 3 && !walk->by_column)
		return walk_batch(s, walk, d, 3, BY_ORDER, max, lines, places, left);
	return walk_batch(s, walk, d, walk->n, BY_COLUMN, max, lines, places, left);
}

/* Not inlined into walk_lines, which would then have too few registers. */
static __attribute__((noinline)) size_t walk_objects(struct stretch *s,
    const struct walk *walk, size_t max, struct line *lines,
    struct plain_places places[4], uint64_t *left)
{
	return walk_batch(s, walk, (struct dialect){ FORMAT_JSON, ',' }, walk->n,
	    BY_PATH, max, lines, places, left);
}

size_t walk_lines(struct stretch *s, const struct walk *walk, size_t n,
    struct line lines[PLAIN_BATCH], struct plain_places places[4], uint64_t *left)
{
	const struct dialect json = { FORMAT_JSON, ',' }, text = { FORMAT_TEXT, ' ' },
			     csv = { FORMAT_CSV, walk->in.separator };

	/* In each copy of walk_batch the format is a constant. The first of n lines of
	 * JSON decides whether all are walked as arrays or as objects. */
	if (format_of(walk->in)->blanks)
		return walk_dialect(s, walk, text, n, lines, places, left);
	if (format_of(walk->in)->header)
		return walk_dialect(s, walk, csv, n, lines, places, left);
	if (walk->objects && (s->text[s->at] == '{' || !walk->arrays))
		return walk_objects(s, walk, n, lines, places, left);
	return walk_dialect(s, walk, json, n, lines, places, left);
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
