/* SPDX-License-Identifier: MIT */
#include "plan.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <strings.h>

#include "../../core/scene/scene.h"
#include "../json/text.h"
#include "../message/escape.h"
#include "../message/message.h"

/* The fields that are sought in a line: the first of each coordinate, and how many. */
struct sought {
	struct field field[4];
	int index[4]; /* of the field, from 0 */
	int times[4];
	size_t n;        /* fields of the line */
	bool ends_empty; /* the last field is empty */
};

/* Sets the column of what is wrong, which is at s. A byte order mark does not count. */
static void set_column(struct refusal *r, const struct line *line, const char *s)
{
	r->column = (size_t)(s - line->s) - (line->has_bom ? 3 : 0) + 1;
}

/* Refuses the line for what is at `at`. Returns false. */
static bool refuse_place(struct refusal *r, const struct line *line, const char *at,
    const char *what, const char *remedy)
{
	refusal_set(r, NULL, what, remedy);
	set_column(r, line, at);
	return false;
}

void plan_begin(struct layout *l)
{
	const bool drops = l->plan.drops_bom;

	l->plan = (struct plan){ .drops_bom = drops };
	for (int i = 0; i < 4; i++)
		l->plan.field[i] = l->columns.n > 0 ? l->columns.field[i] : i;
}

static const char *shown(struct span f)
{
	char escaped[ESCAPED_MAX];

	return text("%s", escape_short(escaped, f.s, span_size(f)));
}

/* Law 3: the coordinates. */

/* The names by which the coordinates are sought; NULL: one is sought by its number. */
struct names {
	const char *name[4];
	bool either_case; /* they are x, y, z and w, in either case */
	char in_space[4][2 * NAME_ROOM];
};

/* Returns whether a field of a header or object has this name. Names of members have
 * quotes, and may have escapes. */
static bool is_named(const struct cursor *c, const struct field *f, const char *name)
{
	const struct span word = { name, name + strlen(name) };

	return c->members ? json_is_name(f->name, word, false) :
			    span_is(unquoted(f->value), name);
}

static const char *name_place(const struct cursor *c, const struct field *f)
{
	return c->members ? f->name.s : f->value.s;
}

/* Returns whether field k of a line is coordinate i. */
static bool is_coordinate(const struct layout *l, const struct cursor *c,
    const struct field *f, const struct names *n, int i, size_t k)
{
	if (n == NULL || n->name[i] == NULL)
		return (size_t)l->plan.field[i] == k;
	const char upper[] = { (char)toupper((unsigned char)*n->name[i]), '\0' };

	return is_named(c, f, n->name[i]) || (n->either_case && is_named(c, f, upper));
}

/* Finds the coordinates of a line by their names or, if `names` is NULL, numbers. */
static void find_fields(const struct layout *l, struct cursor c,
    const struct names *names, struct sought *found)
{
	/* of text without a header nothing after the last coordinate counts */
	const bool whole = names != NULL || l->plan.fields > 0 ||
	    !format_of(l->in)->blanks;
	int left = l->reads;
	struct field f;

	*found = (struct sought){ 0 };
	for (; (whole || left > 0) && cursor_next(&c, &f); found->n++) {
		for (int i = 0; i < l->reads; i++) {
			if (!is_coordinate(l, &c, &f, names, i, found->n))
				continue;
			left--;
			if (found->times[i]++ > 0)
				continue;
			found->field[i] = f;
			found->index[i] = (int)found->n;
		}
		found->ends_empty = f.value.s == f.value.end;
	}
}

static bool finds_all(const struct sought *found, int reads)
{
	for (int i = 0; i < reads; i++)
		if (found->times[i] == 0)
			return false;
	return true;
}

/* Finds the coordinates by the names that --columns gives; else by those of the space
 * that is read, S_x and so on, if the line has all of them; else by x, y, z and w in
 * either case. */
static void find_by_names(const struct layout *l, struct cursor c, struct names *names,
    struct sought *found)
{
	const bool given = l->columns.n > 0;

	names->either_case = false;
	for (int i = 0; i < l->reads; i++) {
		snprintf(names->in_space[i], 2 * NAME_ROOM, "%s_%s",
		    l->from != NULL ? l->from : "", coordinate_name(i));
		names->name[i] = given ? l->columns.name[i] : names->in_space[i];
	}
	if (given || l->from != NULL)
		find_fields(l, c, names, found);
	if (given || (l->from != NULL && finds_all(found, l->reads)))
		return;
	names->either_case = true;
	for (int i = 0; i < l->reads; i++)
		names->name[i] = coordinate_name(i);
	find_fields(l, c, names, found);
}

/* Returns which of the coordinates that were found have names of the space that is
 * read. */
static unsigned find_in_space(const struct layout *l, struct cursor c,
    const struct names *names, const struct sought *found)
{
	unsigned in_space = 0;

	for (int i = 0; i < l->reads && l->from != NULL; i++)
		if (is_named(&c, &found->field[i], names->in_space[i]))
			in_space |= 1u << i;
	return in_space;
}

void plan_name(const struct layout *l, int k, char name[2 * NAME_ROOM])
{
	const struct output *o = &l->output;

	const unsigned all = (1u << l->reads) - 1;
	const bool in_space = k < l->reads ? l->plan.in_space >> k & 1 :
					     l->plan.in_space == all;

	if (k < COORDINATES_MAX && in_space && !o->append && o->space != NULL &&
	    (k < 3 || l->writes <= 4))
		snprintf(name, 2 * NAME_ROOM, "%s_%s", o->space, o->name[k]);
	else
		strcpy(name, o->name[k]);
}

/* Returns whether the field is a coordinate whose name the output changes. */
static bool is_renamed(const struct layout *l, const struct sought *found,
    const struct field *f)
{
	for (int i = 0; i < l->reads; i++)
		if (f->whole.s == found->field[i].whole.s)
			return !l->output.append && l->plan.in_space >> i & 1;
	return false;
}

/* Refuses S_w beside the coordinates S_x ... of a space that has no w: -H wrote them,
 * not divided by w, unless --columns says otherwise. */
static bool is_undivided(const struct layout *l, const struct line *line,
    struct cursor c, struct refusal *r)
{
	char name[2 * NAME_ROOM];
	struct field f;

	if (l->plan.in_space == 0 || l->columns.n > 0 || strcmp(l->from, "clip") == 0)
		return false;
	snprintf(name, sizeof name, "%s_w", l->from);
	while (cursor_next(&c, &f))
		if (is_named(&c, &f, name))
			return !refuse_place(r, line, name_place(&c, &f),
			    text("%shas '%s': -H wrote numbers that are not divided by "
				 "w",
				c.members ? "" : "the header ", name),
			    "leave -H out there, or say --columns");
	return false;
}

/* Refuses a name that the output adds, or changes a name to, and that a field of the
 * line has, too. Names that change are not there. */
static bool has_clash(const struct layout *l, const struct line *line, struct cursor c,
    const struct sought *found, struct refusal *r)
{
	const struct output *o = &l->output;
	char name[2 * NAME_ROOM];
	struct field f;

	/* trace, pick, draw and --lines print no names of images */
	if (!o->copies || o->space == NULL ||
	    (!o->append && !o->flags && l->writes <= l->reads && l->plan.in_space == 0))
		return false;
	while (cursor_next(&c, &f)) {
		if (is_renamed(l, found, &f))
			continue;
		for (int k = 0; k <= COORDINATES_MAX; k++) {
			const bool stays = k < l->reads && !o->append &&
			    !(l->plan.in_space >> k & 1);

			plan_name(l, k, name);
			if (!stays && *name != '\0' && is_named(&c, &f, name))
				return !refuse_place(r, line, name_place(&c, &f),
				    text("%shas '%s', which the output adds",
					c.members ? "" : "the header ", name),
				    "rename it, or leave it out");
		}
	}
	return false;
}

/* Law 4: the header. */

static bool begins_like_number(struct span f)
{
	f.s += f.s < f.end && (*f.s == '+' || *f.s == '-');
	f.s += f.s < f.end && *f.s == '.';
	return f.s < f.end && isdigit((unsigned char)*f.s);
}

static bool is_number(struct dialect d, struct span f)
{
	double v;

	return format_read(d, f.s, f.end, &v) == f.end && !isnan(v);
}

/* Returns whether the field is a name: no number, no missing value, and not like
 * one, in quotes or not. */
static bool is_name(struct dialect d, struct span f)
{
	double v;

	f = unquoted(f);
	return format_read(d, f.s, f.end, &v) != f.end && !begins_like_number(f);
}

/* Returns whether tabs of the first line have told the format, which blanks of text may
 * be, too. */
static bool is_sniffed_tsv(const struct layout *l)
{
	return l->plan.sniffed && same_dialect(l->in, dialect_of(FORMAT_TSV, ','));
}

/* Returns whether the first line is a header. If that is not certain, or one that has
 * to be a header can't be cut, refuses it. */
static bool is_header(const struct layout *l, struct span text, struct line *line,
    struct refusal *r)
{
	const bool certain = layout_has_names(l) || l->header != HEADER_MAYBE;
	const int first = l->columns.n > 0 ? l->columns.field[0] : 0;
	bool empty = false, numbers = false, name = false;
	struct field f;

	if (!format_of(l->in)->header || l->header == HEADER_NONE)
		return false;
	if (!line_check(l->in, text, r)) {
		line->kind = certain ? LINE_REFUSED : line->kind;
		return certain;
	}
	if (certain)
		return true;
	struct cursor c = line_cursor(l->in, text);

	for (int k = 0; cursor_next(&c, &f); k++) {
		empty |= k == 0 && f.value.s == f.value.end;
		name |= k == first && is_name(l->in, f.value);
		numbers |= is_number(l->in, f.value);
	}
	if (!empty || !format_of(l->in)->table)
		return name;
	if (numbers)
		line->kind = LINE_REFUSED;
	if (numbers && is_sniffed_tsv(l))
		refusal_set(r, NULL, "begins with an empty field, if tabs part fields",
		    "say -i text or -i tsv, and of tsv --header or --no-header");
	else if (numbers)
		refusal_set(r, NULL, "begins with an empty field: a header or a point",
		    "say --header or --no-header");
	return true;
}

/* Returns what to say of a line that has one field, or names of text, in which another
 * character may part fields; or NULL. */
static const char *other_separator(const struct layout *l, struct span f)
{
	static const char *const rows[][3] = { { ";", "';'", "--separator ';'" },
		{ "|", "'|'", "--separator '|'" }, { "\t", "a tab", "-i tsv" },
		{ ",", "','", "-i csv" }, { " ", "a blank", "-i text" } };

	for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
		if (memchr(f.s, *rows[k][0], span_size(f)) != NULL &&
		    !(format_of(l->in)->blanks && is_blank(*rows[k][0])) &&
		    !(format_of(l->in)->table && l->in.separator == *rows[k][0]))
			return text("if %s parts its fields, say %s", rows[k][1],
			    rows[k][2]);
	return NULL;
}

/* Writes the names of a line, such as "x, y", or nothing if there are none. */
static void list_fields(struct cursor c, char all[512])
{
	char escaped[ESCAPED_MAX];
	struct field f;
	size_t n = 0;

	*all = '\0';
	while (n < 512 - 2 * ESCAPED_MAX && cursor_next(&c, &f)) {
		const struct span name = c.members ?
		    (struct span){ f.name.s + 1, f.name.end - 1 } :
		    unquoted(f.value);

		if (name.s < name.end)
			n += (size_t)sprintf(all + n, "%s%s", n > 0 ? ", " : "",
			    escape_short(escaped, name.s, span_size(name)));
	}
	if (c.s != NULL)
		strcpy(all + n, ", ...");
}

/* Returns whether a line of text is one of OBJ: v and a number, or mtllib. */
static bool is_obj(const struct layout *l, struct cursor c)
{
	struct field f;

	if (!format_of(l->in)->blanks || !cursor_next(&c, &f))
		return false;
	return span_is(f.value, "mtllib") ||
	    (span_is(f.value, "v") && cursor_next(&c, &f) && is_number(l->in, f.value));
}

/* Returns whether a line has numbers alone. */
static bool has_numbers(const struct layout *l, struct cursor c)
{
	struct field f;
	bool numbers = !c.members;

	while (numbers && cursor_next(&c, &f))
		numbers = is_number(l->in, f.value);
	return numbers;
}

/* Says that the line has no field of coordinate i, or several, and which it has. */
static void refuse_name(const struct layout *l, const struct line *line,
    struct cursor c, const struct names *names, const struct sought *found, int i,
    struct refusal *r)
{
	const struct field *first = &found->field[i];
	const char *name = names->name[i];
	const char *subject = c.members ? "has" : "the header has";
	const char *what = c.members ? "member" : "column";
	const char *remedy = "--columns chooses the coordinates";
	const char *other = c.members                   ? NULL :
	    c.s < c.end && (*c.s == '{' || *c.s == '[') ? "of JSON say -i json" :
	    is_obj(l, c)                                ? "of OBJ say -i obj" :
	    found->n == 1 || l->in.format == FORMAT_TEXT ?
			   other_separator(l, (struct span){ c.s, c.end }) :
			   NULL;
	char all[512];

	name = shown((struct span){ name, name + strlen(name) });
	if (found->times[i] > 1) {
		refuse_place(r, line, name_place(&c, first),
		    text("%s two %ss '%s'", subject, what, name),
		    c.members            ? NULL :
			l->columns.n > 0 ? "say --columns by number" :
					   remedy);
		return;
	}
	if (l->columns.n > 0 && l->header == HEADER_MAYBE && has_numbers(l, c)) {
		refusal_set(r, NULL, text("is no header, which would have '%s'", name),
		    "--columns counts columns, too, from 1");
		return;
	}
	list_fields(c, all);
	if (other != NULL)
		remedy = other;
	else if (i == 2 && l->z_hint != NULL && l->columns.n == 0)
		remedy = l->z_hint;
	if (*all != '\0' && l->columns.n > 0 && other == NULL)
		remedy = text("it has %s", all); /* --columns is used already */
	else if (*all != '\0')
		remedy = text("%s; it has %s", remedy, all);
	refusal_set(r, NULL, text("%s no %s '%s'", subject, what, name), remedy);
}

enum line_kind plan_join_header(struct layout *l, struct span header, struct refusal *r)
{
	struct common_header *common = &l->common;
	const bool before = common->known, has = header.s != NULL;

	if (header.end > header.s && header.end[-1] == '\r')
		header.end--; /* as line ends may differ */
	common->known = true;
	if (!before && has) {
		common->size = span_size(header);
		common->text = memcpy(xrealloc(common->text, common->size), header.s,
		    common->size);
	}
	if (!before)
		return has ? LINE_HEADER : LINE_POINT;
	if (!has && common->text == NULL)
		return LINE_POINT;
	if (has && common->text != NULL && common->size == span_size(header) &&
	    memcmp(common->text, header.s, common->size) == 0)
		return LINE_SILENT;
	refusal_set(r, NULL,
	    !has                     ? "lacks the header of the output" :
		common->text == NULL ? "has a header, and the output has none" :
				       "has another header than the output",
	    "with -o json, for one, headers may differ");
	return LINE_REFUSED;
}

/* Joins the header of a source whose lines are copied; others have been joined. */
static enum line_kind join_own_header(struct layout *l, struct span header,
    struct refusal *r)
{
	if (l->output.copies && same_dialect(l->in, l->out))
		return plan_join_header(l, header, r);
	return header.s != NULL ? LINE_HEADER : LINE_POINT;
}

/* Returns whether the coordinates are different columns of the n; if not, says so. */
static bool columns_are_apart(const struct layout *l, size_t n, struct refusal *r)
{
	for (int i = 0; i < l->reads; i++) {
		const int at = l->plan.field[i];

		if ((size_t)at >= n) {
			refusal_set(r, NULL,
			    text("the header has no column %d", at + 1),
			    text("it has %zu", n));
			return false;
		}
		for (int k = 0; k < i; k++)
			if (at == l->plan.field[k]) {
				refusal_set(r, NULL,
				    text("two coordinates are column %d", at + 1),
				    NULL);
				return false;
			}
	}
	return true;
}

/* Blanks part the names of text, also within quotes. */
static bool has_whole_names(const struct layout *l, struct line *line, struct cursor c,
    struct refusal *r)
{
	struct field f;

	const char *remedy = other_separator(l, (struct span){ c.s, c.end });

	while (format_of(l->in)->blanks && cursor_next(&c, &f)) {
		const struct span name = f.value;

		if (*name.s != '"' || (span_size(name) > 1 && name.end[-1] == '"'))
			continue;
		return refuse_place(r, line, name.s,
		    text("the header's %s is not closed", shown(name)),
		    remedy != NULL ?
			remedy :
			"blanks part the names of text: rename it, or write csv");
	}
	return true;
}

/* Reads a header: finds the columns of the coordinates. */
static void read_header(struct layout *l, struct span text, struct line *line,
    struct refusal *r)
{
	const struct cursor c = line_cursor(l->in, text);
	struct plan *p = &l->plan;
	struct names names;
	struct sought found;

	line->kind = LINE_REFUSED;
	find_by_names(l, c, &names, &found);
	for (int i = 0; i < l->reads; i++) {
		if (names.name[i] == NULL)
			continue;
		if (found.times[i] != 1) {
			refuse_name(l, line, c, &names, &found, i, r);
			return;
		}
		p->field[i] = found.index[i];
	}
	if (!has_whole_names(l, line, c, r) || !columns_are_apart(l, found.n, r))
		return;
	for (int i = 0; i < l->reads; i++)
		line->at[i] = line_part(line, found.field[i].value);
	p->in_space = find_in_space(l, c, &names, &found);
	if (is_undivided(l, line, c, r) || has_clash(l, line, c, &found, r))
		return;
	p->has_header = true;
	p->fields = found.n;
	line->kind = join_own_header(l, text, r);
}

/* Law 5: rows. */

/* Returns where a further field of the line would begin. */
static const char *fields_end(const struct layout *l, const struct line *line)
{
	const char *end = trimmed(l->in, line_text(line)).end;

	return end - (l->in.format == FORMAT_JSON);
}

/* Returns whether the row has as many fields as it should; if not, says so. */
static bool has_its_fields(const struct layout *l, const struct line *line,
    struct cursor c, const struct sought *found, struct refusal *r)
{
	const struct plan *p = &l->plan;
	const char *at = fields_end(l, line);
	struct field f;

	const bool one_more = found->ends_empty && found->n == p->fields + 1 &&
	    format_of(l->in)->table && !l->output.append;

	if (p->fields == 0 || found->n == p->fields || one_more)
		return true;
	const bool row_names = p->has_header && found->n == p->fields + 1;
	const bool parted = format_of(l->in)->table && found->n > p->fields;

	for (size_t k = 0; k <= p->fields && cursor_next(&c, &f); k++)
		at = k == p->fields ? f.value.s : at;
	return refuse_place(r, line, at,
	    text("has %zu field%s and the %s %zu", found->n, found->n == 1 ? "" : "s",
		p->has_header ? "header" : "first row", p->fields),
	    text("%s%s%s", parted ? "quote a field that has the separator in it" : "",
		parted && row_names ? "; " : "",
		row_names ? "row names want a name in the header" : ""));
}

/* Finds the coordinates of an object. The first row decides their names; if it is an
 * array or has not all of them, each object does. */
static void find_members(struct layout *l, struct cursor c, bool first,
    struct names *names, struct sought *found)
{
	struct plan *p = &l->plan;

	if (!first && *p->member[0] != '\0') {
		names->either_case = false;
		for (int i = 0; i < l->reads; i++)
			names->name[i] = p->member[i];
		find_fields(l, c, names, found);
		return;
	}
	find_by_names(l, c, names, found);
	if (!first || !finds_all(found, l->reads))
		return;
	p->in_space = find_in_space(l, c, names, found);
	for (int i = 0; i < l->reads && l->columns.n == 0; i++) {
		strcpy(p->member[i], names->name[i]);
		if (!is_named(&c, &found->field[i], p->member[i]))
			*p->member[i] = (char)toupper((unsigned char)*p->member[i]);
	}
}

bool plan_in_range(const struct layout *l, int i, double v, struct refusal *r)
{
	if (!(fabs(v) > SCENE_MAGNITUDE_MAX))
		return true;
	if (isinf(v))
		refusal_set(r, NULL, text("%s is infinite", coordinate_name(i)),
		    text("a number up to 1e150 is wanted, or %s",
			format_of(l->in)->nan_text));
	else
		refusal_set(r, NULL,
		    text("%s is beyond 1e150 in magnitude", coordinate_name(i)),
		    "choose another unit");
	return false;
}

/* Law 12: says what is to be written instead of a field that is no number, and may be
 * the only one, or have semicolons between decimal commas. */
static void refuse_number(const struct layout *l, int i, struct span f, bool one,
    struct refusal *r)
{
	const char *remedy = format_number_remedy(l->in, f), *value = shown(f);

	if (l->in.format == FORMAT_JSON)
		remedy = "a number is wanted";
	else if (f.s < f.end && (*f.s == '[' || *f.s == '{'))
		remedy = "of JSON say -i json";
	else if (*remedy == '\0' && (one || strpbrk(value, ";|") != NULL))
		remedy = other_separator(l, f);
	if (remedy == NULL || *remedy == '\0')
		remedy = "a number is wanted";
	refusal_set(r, NULL, text("%s is '%s'", coordinate_name(i), value), remedy);
}

static void refuse_missing(const struct layout *l, int i, struct refusal *r)
{
	const char *hint = i == 2 && l->z_hint != NULL ? l->z_hint : "";

	refusal_set(r, NULL,
	    l->columns.n == 0 ? text("%s is missing", coordinate_name(i)) :
				text("%s is missing: there is no field %d",
				    coordinate_name(i), l->plan.field[i] + 1),
	    text("%d numbers are wanted%s%s", l->reads, *hint != '\0' ? "; " : "",
		hint));
}

/* Reads the coordinates; if one is wrong, says in which column of the line. */
static bool read_coordinates(const struct layout *l, const struct line *line,
    const struct sought *found, double v[4], struct refusal *r)
{
	for (int i = 0; i < l->reads; i++) {
		const struct span f = found->field[i].value;

		if (found->times[i] == 0)
			refuse_missing(l, i, r);
		else if (format_read(l->in, f.s, f.end, &v[i]) != f.end)
			refuse_number(l, i, f, found->n <= 1, r);
		else if (plan_in_range(l, i, v[i], r))
			continue;
		set_column(r, line, found->times[i] > 0 ? f.s : fields_end(l, line));
		return false;
	}
	return true;
}

/* Law 6: comments above the first row. */

/* The words of a comment that count: their number, and the last three. */
struct words {
	int n;
	struct span last[3];
};

/* Returns whether the last three words, or of two coordinates two, are alike but for
 * their last letters, x, y and z. */
static bool are_axes(const struct words *w, int n)
{
	const struct span *word = &w->last[3 - n];

	for (int i = 0; i < n; i++) {
		const size_t size = span_size(word[i]);

		if (size == 0 || size >= WORD_ROOM || size != span_size(word[0]) ||
		    tolower((unsigned char)word[i].end[-1]) != "xyz"[i] ||
		    memcmp(word[i].s, word[0].s, size - 1) != 0)
			return false;
	}
	return true;
}

static bool is_word(char c)
{
	return isalnum((unsigned char)c) || c == '_';
}

/* Keeps the words of a comment that may name the columns of the coordinates, of several
 * those that are x, y and z alone. If these are its first words, no others count. */
static void read_comment(struct layout *l, const char *s, const char *end)
{
	const int n = l->reads == 2 ? 2 : 3;
	struct plan *p = &l->plan;
	struct words w = { 0 };
	int level = 0, at = 0;
	bool plain = false;

	for (s++; s < end; s++) {
		level += strchr("([{", *s) != NULL;
		level -= level > 0 && strchr(")]}", *s) != NULL;
		if (level > 0 || !is_word(*s))
			continue;
		w.last[0] = w.last[1];
		w.last[1] = w.last[2];
		w.last[2].s = s;
		while (s + 1 < end && is_word(s[1]))
			s++;
		w.last[2].end = s + 1;
		w.n++;
		if (s + 1 < end && s[1] == ':')
			w = (struct words){ 0 };
		if (w.n < n || !are_axes(&w, n) || plain)
			continue;
		plain = span_size(w.last[2]) == 1;
		if (w.n == n && plain)
			return;
		if (w.n == n || (at > 0 && !plain))
			continue;
		at = w.n - n;
		*p->comment = '\0';
		for (int i = 3 - n; i < 3; i++)
			sprintf(p->comment + strlen(p->comment), " %.*s",
			    (int)span_size(w.last[i]), w.last[i].s);
	}
	if (at > 0)
		p->comment_field = at;
}

void plan_comments(struct layout *l, struct span text)
{
	const char *end;

	for (const char *s = text.s; s < text.end; s = end + (end < text.end)) {
		end = memchr(s, '\n', (size_t)(text.end - s));
		end = end != NULL ? end : text.end;
		s = skip_blanks(l->in, s, end);
		if (s < end && *s == '#')
			read_comment(l, s, end);
	}
}

/* Returns whether a comment above the first row names other fields as the coordinates,
 * which are numbers there; if so, says it. */
static bool comment_differs(const struct layout *l, const struct line *line,
    struct cursor c, struct refusal *r)
{
	const int n = l->reads == 2 ? 2 : 3, from = l->plan.comment_field;
	const char *at = NULL;
	int numbers = 0;
	struct field f;

	if (from == 0 || l->columns.n > 0 || c.members || l->in.format == FORMAT_OBJ)
		return false;
	for (int k = 0; k < from + n && cursor_next(&c, &f); k++) {
		numbers += k >= from && is_number(l->in, f.value);
		at = k == from ? f.value.s : at;
	}
	if (numbers < n)
		return false;
	return !refuse_place(r, line, at,
	    text("the comment above has '%s' in other columns", l->plan.comment + 1),
	    "say by --columns where the coordinates are");
}

/* Refuses an object that is not the first row, and has names of the space although that
 * has told none: the output would change them. */
static bool is_late(const struct layout *l, const struct line *line,
    const struct names *names, const struct sought *found, struct refusal *r)
{
	if (*l->plan.member[0] != '\0' || l->columns.n > 0 || names->either_case)
		return false;
	return !refuse_place(r, line, found->field[0].name.s,
	    text("has '%s', and the first row no names", names->name[0]),
	    "put an object first, which tells the names");
}

/* Reads a row, the first of the source or a later one. */
static void read_row(struct layout *l, struct span text, bool first, struct line *line,
    double v[4], struct refusal *r)
{
	struct plan *p = &l->plan;
	struct names names;
	struct sought found;

	line->kind = LINE_LOST;
	line->object = l->in.format == FORMAT_JSON &&
	    *skip_blanks(l->in, text.s, text.end) == '{';
	if (!line_check(l->in, text, r)) {
		/* What is not JSON ends a list. Of its elements, those that are neither
		 * arrays nor objects have been found to be JSON. */
		if (p->is_list && (line->object || *text.s == '['))
			line->kind = LINE_REFUSED;
		else if (p->is_list)
			refusal_set(r, NULL, "is neither a JSON array nor an object",
			    NULL);
		return;
	}
	const struct cursor c = line_cursor(l->in, text);

	if (c.bracket != NULL && l->columns.n > 0 && c.members != layout_has_names(l)) {
		refusal_set(r, NULL, c.members ? "is an object" : "is an array",
		    c.members ? "--columns is to name its members: x,y,z" :
				"--columns is to number its elements: 2,3,4");
		return;
	}
	if (c.members)
		find_members(l, c, first, &names, &found);
	else
		find_fields(l, c, NULL, &found);
	if (first && p->fields == 0 && format_of(l->in)->table)
		p->fields = found.n;
	line->kind = LINE_BAD;
	for (int i = 0; i < l->reads; i++) {
		if (found.times[i] == 1) {
			line->at[i] = line_part(line, found.field[i].value);
			continue;
		}
		line->kind = l->output.append ? LINE_BAD : LINE_LOST;
		if (c.members) {
			refuse_name(l, line, c, &names, &found, i, r);
			return;
		}
	}
	if (c.members && is_late(l, line, &names, &found, r))
		return;
	if (c.members &&
	    (is_undivided(l, line, c, r) || has_clash(l, line, c, &found, r))) {
		line->kind = LINE_LOST; /* a name would be there twice */
		return;
	}
	if (has_its_fields(l, line, c, &found, r) &&
	    read_coordinates(l, line, &found, v, r))
		line->kind = LINE_POINT;
}

/* Law 1: returns where an empty field is in place of a coordinate, or NULL. */
static const char *empty_coordinate(const struct layout *l, struct span text)
{
	struct sought found;

	find_fields(l, line_cursor(l->in, text), NULL, &found);
	for (int i = 0; i < l->reads; i++)
		if (found.times[i] > 0 &&
		    found.field[i].value.s == found.field[i].value.end)
			return found.field[i].value.s;
	return NULL;
}

/* Reads the first row of a source without a header, or after it. */
static void read_first_row(struct layout *l, struct span text, struct line *line,
    double v[4], struct refusal *r)
{
	const bool has_header = l->plan.has_header;
	const char *empty = is_sniffed_tsv(l) ? empty_coordinate(l, text) : NULL;

	if (empty != NULL) {
		refuse_place(r, line, empty,
		    "has an empty coordinate, if tabs part its fields",
		    "say -i text or -i tsv");
		line->kind = LINE_REFUSED;
		return;
	}
	if (!has_header &&
	    join_own_header(l, (struct span){ NULL, NULL }, r) == LINE_REFUSED) {
		line->kind = LINE_REFUSED;
		return;
	}
	read_row(l, text, true, line, v, r);
	if (line->kind != LINE_REFUSED && !has_header && line->kind != LINE_LOST &&
	    comment_differs(l, line, line_cursor(l->in, text), r))
		line->kind = LINE_BAD;
}

/* Law 11: bytes. */

/* Returns the carriage return, out of quotes, that ends a line without a newline; or
 * NULL. */
static const char *lone_cr(struct dialect d, struct span line)
{
	const char *s = line.s;
	const bool csv = d.format == FORMAT_CSV && *skip_blanks(d, s, line.end) != '#';
	bool quoted = false;

	for (bool begins = csv; s < line.end && (quoted || *s != '\r'); s++) {
		quoted ^= begins && *s == '"';
		begins = csv &&
		    (quoted || *s == d.separator ||
			(begins && (is_blank(*s) || *s == '"')));
	}
	const char *cr = s;

	while (s < line.end && is_blank(*s))
		s++;
	return s < line.end ? cr : NULL;
}

/* Returns whether the line has bytes of no text; if so, says what they may be. */
static bool is_binary(struct span line, bool first, struct refusal *r)
{
	const char *s = line.s;

	if (!first)
		s = memchr(s, '\0', span_size(line));
	while (first && s < line.end && ((unsigned char)*s >= ' ' || is_blank(*s)) &&
	    *s != '\v' && *s != '\f' && *s != 0x7f)
		s++;
	if (s == NULL || s == line.end)
		return false;
	refusal_set(r, NULL, "is binary",
	    "if it is numbers alone, say -i f32x4, f32 or f64");
	r->column = (size_t)(s - line.s) + 1;
	return true;
}

/* Does what plan_line does to a line whose kind is LINE_REFUSED, after its mark. */
static void read_line(struct layout *l, struct span text, enum next_part *first,
    struct line *line, double v[4], struct refusal *r)
{
	const bool first_line = *first == FIRST_LINE;

	if (is_binary(text, first_line, r))
		return;
	const char *cr = first_line ? lone_cr(l->in, text) : NULL;

	if (cr != NULL &&
	    (l->in.format != FORMAT_JSON || !line_check(l->in, text, r))) {
		refuse_place(r, line, cr, "has carriage returns alone for line ends",
		    "make them newlines: tr '\\r' '\\n'");
		return;
	}
	const char *s = skip_blanks(l->in, text.s, text.end);

	line->kind = LINE_COPY;
	if (s == text.end || *s == '#') {
		if (first_line)
			plan_comments(l, text);
		return;
	}
	if (line_is_other(l->in, text))
		return;
	if (first_line && is_header(l, text, line, r)) {
		if (line->kind != LINE_REFUSED)
			read_header(l, text, line, r);
		*first = FIRST_ROW;
		return;
	}
	if (*first != FIRST_NONE) {
		read_first_row(l, text, line, v, r);
		/* one that can't be cut tells nothing of the next */
		*first = line->kind == LINE_LOST ? FIRST_ROW : FIRST_NONE;
	} else {
		read_row(l, text, false, line, v, r);
	}
}

void plan_line(struct layout *l, struct span text, enum next_part *first,
    struct line *line, double v[4], struct refusal *r)
{
	*line = (struct line){ .s = text.s,
		.size = (uint32_t)span_size(text),
		.kind = LINE_REFUSED };
	if (*first == FIRST_LINE) {
		text.s = skip_bom(text.s, text.end);
		line->has_bom = text.s > line->s;
	}
	read_line(l, text, first, line, v, r);
	if (line_is_bad(line) && r->column == 0) /* all of it is wrong */
		set_column(r, line, skip_blanks(l->in, text.s, text.end));
}

/* Sets the names of members that the walk passes. */
static void plan_members(const struct layout *l, struct walk *w)
{
	const bool given = layout_has_names(l);
	size_t n = 0;

	w->arrays = !given;
	/* else each object has its own, or the names change */
	if ((!given && *l->plan.member[0] == '\0') || l->plan.in_space != 0)
		return;
	for (int i = 0; i < l->reads; i++) {
		w->name[i] = given ? l->columns.name[i] : l->plan.member[i];
		w->size[i] = strlen(w->name[i]);
	}
	for (int k = 0; k <= COORDINATES_MAX; k++)
		if (*l->output.name[k] != '\0' && (l->output.append || k >= l->reads))
			w->taken[n++] = l->output.name[k];
}

bool plan_walk(const struct layout *l, struct walk *w)
{
	const struct plan *p = &l->plan;

	*w = (struct walk){ .in = l->in,
		.n = l->reads,
		.fields = p->fields < STRETCH_MAX ? (int)p->fields : STRETCH_MAX,
		.one_more = !l->output.append };
	walk_set_stops(w);
	for (int i = 0; i < l->reads; i++) {
		w->field[i] = p->field[i];
		w->by_column |= w->field[i] != i;
	}
	if (l->in.format == FORMAT_JSON)
		plan_members(l, w);
	return w->arrays || w->name[0] != NULL || l->in.format != FORMAT_JSON;
}
