/* SPDX-License-Identifier: MIT */
#include "line.h"

#include <math.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../json/text.h"

/* The walk is inlined once for each format, so that the compiler removes the branches
 * of other formats. */
#define INLINE static inline __attribute__((always_inline))

/* Returns the stops of a dialect: the bytes that can end a field, or for which a line
 * may have to be left. */
static struct byte_set stops_of(struct dialect d)
{
	const struct format_row *row = format_of(d);
	const bool json = *row->open != '\0';
	struct byte_set set = { { 0 }, { 0 } };
	int bits = 0;

	for (int b = 0; b < 256; b++) {
		/* one bit for each upper half of a byte; there are at most eight */
		uint8_t *bit = &set.high[b >> 4];
		char c = (char)b;

		if (c != '\n' && !is_blank(c) && c != d.separator &&
		    !(row->blanks && c == ',') &&
		    (row->quote == 0 ||
			(c != row->quote && c != row->escape)) &&
		    !(json && (b < ' ' || strchr("[]{}", c) != NULL)))
			continue;
		if (*bit == 0)
			*bit = (uint8_t)(1 << bits++);
		set.low[b & 15] |= *bit;
	}
	return set;
}

bool walk_plan(const struct layout *l, struct walk *w)
{
	const struct columns *c = &l->columns;
	const bool json = l->in.format == FORMAT_JSON;

	*w = (struct walk){ .in = l->in,
		.stops = stops_of(l->in),
		.n = l->reads,
		.fields = l->append ? (int)l->fields : 0,
		.most = l->fields > 0 ? (int)l->most : STRETCH,
		.added = l->append ? l->name : NULL,
		.arrays = !json || c->n == 0 || c->name[0] == NULL,
		.objects = json && (c->n == 0 || c->name[0] != NULL),
		.columns = !layout_is_first(l) };
	for (int i = 0; i < l->reads; i++)
		w->field[i] = layout_field(l, i);
	for (int i = 0; i < l->reads && w->objects; i++) {
		const char *name = l->columns.name[i];
		bool pointer = *name == '/';

		name += pointer;
		w->objects = !pointer || strchr(name, '~') == NULL;
		w->trail.path[i] = name;
		w->trail.size[i] = pointer ? strcspn(name, "/") : strlen(name);
	}
	return w->arrays || w->objects;
}

bool stretch_open(struct stretch *w, const struct walk *walk, const char *text,
    const char *end)
{
	size_t size = (size_t)(end - text), n;

	if (size > STRETCH)
		size = STRETCH;
	n = number_loops()->find(&walk->stops, text, size, w->stop);
	while (n > 0 && text[w->stop[n - 1]] != '\n')
		n--;
	w->text = text;
	w->at = 0;
	w->end = n > 0 ? w->stop[n - 1] + 1u : 0;
	w->next = w->stop;
	return n > 0;
}

/* A position on a line. A function pass_... moves at to the end of what it passes. If
 * it returns false, the line is left to line_read unless its comment says otherwise. */
struct walker {
	const char *text;
	uint32_t at;
	const uint16_t *stop; /* the first stop at text + at or after it */
	bool comma;           /* the last separator has a comma */
	int found;            /* the number of coordinates passed */
};

/* Returns whether c, which is a stop, is at the walker. */
INLINE bool stands(const struct walker *p, char c)
{
	return *p->stop == p->at && p->text[p->at] == c;
}

/* Passes a stop. */
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

/* Passes a separator as skip_separator does in text; elsewhere returns false if there
 * is none. Most separators have one byte, which comes first for speed. */
INLINE bool pass_separator(struct walker *p, struct dialect d)
{
	bool text = d.format == FORMAT_TEXT;
	char comma = text ? ',' : d.separator, c = p->text[p->at];

	if (*p->stop == p->at &&
	    (text ? c != '\n' && p->stop[1] > p->at + 1 : c == comma)) {
		p->comma = c == comma;
		pass(p);
		if (!text)
			pass_blanks(p, d);
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

/* Returns the number of stops after the backslash of the escape at s; -1: no escape. */
static int escaped_stops(const char *s)
{
	unsigned code;

	if (s[1] == 'u')
		return json_hex4(s + 2, s + 6, &code) == s + 6 ? 0 : -1;
	if (s[1] == '"' || s[1] == '\\')
		return 1;
	return s[1] != '\0' && strchr("/bfnrt", s[1]) != NULL ? 0 : -1;
}

/* Passes a string of JSON. Returns false for a name with escapes, which could be the
 * name of a coordinate. */
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

/* Returns whether a plain number is one of JSON: no 0 before another digit, and digits
 * on both sides of the point. */
INLINE bool is_narrow(const char *s, const char *end)
{
	s += *s == '-';
	/* without branches, as the first digits can't be predicted */
	return !(((*s == '0') & (s[1] >= '0') & (s[1] <= '9')) | (*s == '.') |
	    (end[-1] == '.'));
}

/* The destination of the coordinates of line i, which begins at begin. */
struct target {
	const struct walk *walk;
	struct line *line;
	uint32_t begin;
	size_t i;
	struct plain_places *places;
};

/* Passes coordinate k. Returns false if it is no number of JSON, or too long for plain. */
INLINE bool pass_number(struct walker *p, struct dialect d,
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
	p->found++;
	return true;
}

/* Passes coordinate k, with its quotes in csv. */
INLINE bool pass_coordinate(struct walker *p, struct dialect d,
    const struct target *t, int k)
{
	bool quoted = d.format == FORMAT_CSV && stands(p, '"');

	if (__builtin_expect(!quoted, 1))
		return pass_number(p, d, t, k);
	pass(p);
	if (!pass_number(p, d, t, k) || !stands(p, '"'))
		return false;
	pass(p);
	return true;
}

/* Passes a field of text or csv that is not a coordinate. A field of csv in quotes may
 * not contain quotes: after such a quote the caller finds neither separator nor
 * newline, and leaves the line. */
INLINE bool pass_other(struct walker *p, struct dialect d)
{
	bool csv = d.format == FORMAT_CSV, quoted = csv && stands(p, '"');

	if (quoted)
		for (p->stop++; p->text[*p->stop] != '"'; p->stop++)
			if (p->text[*p->stop] == '\n')
				return false;
	while (csv && !quoted && is_blank_of(d, p->text[*p->stop]))
		p->stop++;
	p->at = *p->stop;
	if (quoted)
		pass(p);
	return true;
}

/* How coordinates are found among fields: they are the first fields; by the number of
 * a column; by a name or pointer; there are no coordinates. */
enum shape { FIELDS, COLUMNS, PATHS, NONE };

static bool pass_nested(struct walker *, const struct target *,
    const struct trail *, unsigned led, int levels);

/* Results that are not the number of a coordinate. The functions that look at a field
 * return NOTHING if it is no coordinate, MORE if paths lead into it. pass_field returns
 * NOTHING after the last field, MORE if another follows. ODD: the line is left to
 * line_read. */
enum { NOTHING = -1, MORE = -2, ODD = -3 };

/* Returns the paths whose bits are set in led, without their first tokens. */
static struct trail trail_inside(const struct trail *t, unsigned led)
{
	struct trail rest;

	for (int i = 0; i < 4; i++) {
		bool leads = (led >> i & 1) != 0;

		rest.path[i] = leads ? t->path[i] + t->size[i] + 1 : "";
		rest.size[i] = leads ? strcspn(rest.path[i], "/") : SIZE_MAX;
	}
	return rest;
}

/* Returns the coordinate whose path ends at the member of that name, or MORE if paths
 * lead into the member; sets their bits in led. */
INLINE int follow(const struct trail *t, int n, struct span name, unsigned *led)
{
	size_t size = (size_t)(name.end - name.s);

	*led = 0;
	for (int i = 0; i < n; i++) {
		const char *path = t->path[i];

		if (t->size[i] != size || *path != *name.s ||
		    (size > 1 && memcmp(path, name.s, size) != 0))
			continue;
		*led |= 1u << i;
		if (path[size] != '/')
			return i;
	}
	return *led != 0 ? MORE : NOTHING;
}

/* Passes a value of JSON that is not a coordinate, and the coordinates in it if paths
 * have led there. Returns false if the line is left to line_read. */
INLINE bool pass_value(struct walker *p, const struct target *t,
    const struct trail *trail, unsigned led, int levels)
{
	uint32_t from = p->at;

	if (stands(p, '{') || stands(p, '[')) {
		struct walker inside = *p; /* p stays in registers */
		bool ok = pass_nested(&inside, t, trail, led, levels);

		*p = inside;
		return ok;
	}
	if (led != 0)
		return false;
	if (stands(p, '"'))
		return pass_string(p, false);
	p->at = *p->stop;
	return json_scalar_end(p->text + from, p->text + p->at) ==
	    p->text + p->at;
}

/* Passes the name of a member and the colon. Returns false if the line is left to
 * line_read. */
INLINE bool pass_name(struct walker *p, struct dialect d, bool may_have_escapes,
    struct span *name)
{
	name->s = p->text + p->at + 1;
	if (!stands(p, '"') || !pass_string(p, !may_have_escapes))
		return false;
	name->end = p->text + p->at - 1;
	pass_blanks(p, d);
	if (p->text[p->at++] != ':')
		return false;
	pass_blanks(p, d);
	return true;
}

/* Returns the coordinate that is field k, or NOTHING. */
INLINE int coordinate_of(const struct walk *w, int n, int k)
{
	for (int i = 0; i < n; i++)
		if (w->field[i] == k)
			return i;
	return NOTHING;
}

/* Returns whether a line of text has no decimal comma after its last coordinate, as in
 * 1 2 3,5: the separator after it has a comma if those before have one, or the line
 * ends. */
INLINE bool ends_text(struct walker *p, struct dialect d, int n, bool comma)
{
	if (*p->stop != p->at || stands(p, '\n'))
		return *p->stop == p->at;
	if (n != 2)
		return comma || !stands(p, ',');
	pass_separator(p, d);
	return stands(p, '\n') || p->comma == comma;
}

/* Returns whether the name is one that --append adds. */
static bool names_added(const char (*added)[NAME_ROOM], struct span name)
{
	size_t n = (size_t)(name.end - name.s);

	for (int k = 0; k <= COORDINATES_MAX; k++)
		if (added[k][0] == *name.s && n < NAME_ROOM &&
		    memcmp(added[k], name.s, n) == 0 && added[k][n] == '\0')
			return true;
	return false;
}

/* The fields of a line, an array or an object. */
struct fields {
	int n; /* the number of coordinates */
	enum shape shape;
	bool members;
	const struct trail *trail;
	int levels;   /* the most levels of values inside */
	unsigned led; /* bit i: a field passed is on the path of coordinate i */
	/* in text: the separators; those with a comma */
	int separators, commas;
};

/* Passes the name of field k, if it has one. Returns the coordinate that the field is,
 * NOTHING, MORE or ODD. Bit i of led: the path of coordinate i leads to the field. */
INLINE int pass_to_value(struct walker *p, struct dialect d, struct fields *f,
    const struct walk *w, int k, unsigned *led)
{
	const char digit = (char)('0' + k);
	struct span name = { &digit, &digit + 1 };

	*led = 0;
	if (f->members && !pass_name(p, d, f->shape == NONE, &name))
		return ODD;
	if (f->shape == FIELDS)
		return k < f->n ? k : NOTHING;
	if (f->shape == COLUMNS)
		return coordinate_of(w, f->n, k);
	if (f->shape == NONE)
		return NOTHING;
	int i = f->members || k < 10 ? follow(f->trail, f->n, name, led) : ODD;
	bool odd = (f->led & *led) != 0;

	f->led |= *led;
	if (w->added != NULL && f->trail == &w->trail)
		odd |= names_added(w->added, name);
	return odd ? ODD : i;
}

/* Passes field k and the separator after it. Returns MORE, NOTHING if the field is the
 * last, or ODD. */
INLINE int pass_field(struct walker *p, struct dialect d, struct fields *f,
    const struct target *t, int k)
{
	const bool text = d.format == FORMAT_TEXT;
	unsigned led;
	int i = pass_to_value(p, d, f, t->walk, k, &led);

	if (i == ODD)
		return ODD;
	if (i >= 0 ? !pass_coordinate(p, d, t, i) :
		d.format == FORMAT_JSON ?
		     !pass_value(p, t, f->trail, led, f->levels) :
		     !pass_other(p, d))
		return ODD;
	if (text && p->found == f->n)
		return NOTHING;
	if (stands(p, '\n') || !pass_separator(p, d))
		return NOTHING;
	f->separators++;
	f->commas += p->comma;
	return MORE;
}

/* Passes the fields up to the newline or a bracket, in text up to the last coordinate.
 * Returns false if the line is left to line_read. */
INLINE bool pass_fields(struct walker *p, struct dialect d, struct fields f,
    const struct target *t)
{
	const int unrolled = f.shape == FIELDS ? f.n : 0;
	int more = MORE, k = 0;

#pragma GCC unroll 4
	for (; k < unrolled && more == MORE; k++)
		more = pass_field(p, d, &f, t, k);
	for (; more == MORE; k++)
		more = pass_field(p, d, &f, t, k);
	if (more == ODD || (d.format != FORMAT_JSON && p->found != f.n))
		return false;
	if (d.format == FORMAT_CSV)
		return t->walk->fields != 0 ?
		    k == t->walk->fields :
		    k - (p->text[p->at - 1] == d.separator) <= t->walk->most;
	if (d.format != FORMAT_TEXT)
		return true;
	return (f.commas == 0 || f.commas == f.separators) &&
	    ends_text(p, d, f.n, f.commas > 0);
}

/* Passes an array or an object. Returns false if the line is left to line_read. */
INLINE bool pass_brackets(struct walker *p, struct fields f,
    const struct target *t)
{
	const struct dialect json = { FORMAT_JSON, ',' };
	const char close = f.members ? '}' : ']';

	if (!stands(p, f.members ? '{' : '['))
		return false;
	pass(p);
	pass_blanks(p, json);
	if (!stands(p, close) &&
	    (!pass_fields(p, json, f, t) || !stands(p, close)))
		return false;
	pass(p);
	pass_blanks(p, json);
	return true;
}

/* Passes an array or an object that is a value. */
static bool pass_nested(struct walker *p, const struct target *t,
    const struct trail *trail, unsigned led, int levels)
{
	struct trail inside;

	if (led != 0)
		inside = trail_inside(trail, led);
	const struct fields f = { .n = t->walk->n,
		.shape = led != 0 ? PATHS : NONE,
		.members = stands(p, '{'),
		.trail = &inside,
		.levels = levels - 1 };

	return levels > 0 && pass_brackets(p, f, t);
}

/* Lines that nest values deeper are left to line_read. */
enum { LEVELS = 8 };

/* Finds the coordinates of a line. Returns false if the line is left to line_read. */
INLINE bool pass_line(struct walker *p, struct dialect d, int n,
    enum shape shape, const struct target *t)
{
	const struct fields f = { .n = n,
		.shape = shape,
		.members = shape == PATHS,
		.trail = &t->walk->trail,
		.levels = LEVELS };

	p->found = 0;
	t->line->object = f.members;
	pass_blanks(p, d);
	if (d.format == FORMAT_JSON)
		return pass_brackets(p, f, t) && p->found == n &&
		    stands(p, '\n');
	return p->text[p->at] != '#' && pass_fields(p, d, f, t) &&
	    (d.format == FORMAT_TEXT || stands(p, '\n'));
}

/* Sets the places of line i, which is left to line_read, to bytes that can be read. */
static void no_numbers(int n, size_t i, struct plain_places places[4])
{
	static const char none[PLAIN_BEFORE + 1] = "";

	for (int k = 0; k < n; k++) {
		places[k].end[i] = none + sizeof none;
		places[k].size[i] = 1;
	}
}

/* Does the work of walk_lines for one dialect, number of coordinates and shape. */
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
		const struct target t = { walk, &lines[i], begin, i, places };

		lines[i].object = lines[i].words = lines[i].mark = false;
		bool found = p.text + begin - s->readable >= PLAIN_BEFORE &&
		    pass_line(&p, d, n, shape, &t);

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

/* Calls walk_take with a dialect: a copy of it for points of three coordinates that are
 * the first fields, another copy for all other points. */
INLINE size_t take_dialect(struct stretch *s, const struct walk *walk,
    struct dialect d, size_t max, struct line *lines,
    struct plain_places places[4], uint64_t *left)
{
	if (walk->n == 3 && !walk->columns)
		return walk_take(s, walk, d, 3, FIELDS, max, lines, places,
		    left);
	return walk_take(s, walk, d, walk->n, COLUMNS, max, lines, places,
	    left);
}

/* Calls walk_take for objects of JSON. This copy of walk_take is not inlined into
 * walk_lines, which would then have too few registers. */
static __attribute__((noinline)) size_t take_objects(struct stretch *s,
    const struct walk *walk, size_t max, struct line *lines,
    struct plain_places places[4], uint64_t *left)
{
	return walk_take(s, walk, (struct dialect){ FORMAT_JSON, ',' }, walk->n,
	    PATHS, max, lines, places, left);
}

size_t walk_lines(struct stretch *s, const struct walk *walk, size_t n,
    struct line lines[PLAIN_BATCH], struct plain_places places[4],
    uint64_t *left)
{
	const struct dialect json = { FORMAT_JSON, ',' },
			     text = { FORMAT_TEXT, ' ' },
			     csv = { FORMAT_CSV, walk->in.separator };

	/* Each copy of walk_take has its format as a constant. The first line of JSON
	 * decides whether these lines are walked as arrays or as objects. */
	if (format_of(walk->in)->blanks)
		return take_dialect(s, walk, text, n, lines, places, left);
	if (format_of(walk->in)->header)
		return take_dialect(s, walk, csv, n, lines, places, left);
	if (walk->objects && (s->text[s->at] == '{' || !walk->arrays))
		return take_objects(s, walk, n, lines, places, left);
	return take_dialect(s, walk, json, n, lines, places, left);
}

uint64_t walk_numbers(const struct walk *walk, const struct line *lines,
    size_t n, const struct plain_places at[4], uint64_t left,
    double v[4][PLAIN_BATCH])
{
	uint64_t odd[4], some = 0;

	for (int k = 0; k < walk->n; k++)
		some |= odd[k] = number_loops()->read(&at[k], n, v[k]);
	for (some &= ~left; some != 0; some &= some - 1) {
		int i = __builtin_ctzll(some);

		for (int k = 0; k < walk->n; k++) {
			struct span f = line_at(&lines[i], k);

			/* a number that is not plain, such as 1e-300 */
			if ((odd[k] >> i & 1) != 0 &&
			    (format_number(walk->in, f.s, f.end, &v[k][i]) !=
				    f.end ||
				fabs(v[k][i]) > MAGNITUDE_MAX))
				left |= (uint64_t)1 << i;
		}
	}
	return left;
}
