/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>

#include "../../core/scene/scene.h"
#include "line.h"
#include "../message/utf8.h"

/* Returns whether v, coordinate i, is nan or at most MAGNITUDE_MAX in magnitude; writes
 * the reason if not. */
static bool in_range(const struct layout *l, int i, double v,
    char reason[REASON_MAX])
{
	if (!(fabs(v) > MAGNITUDE_MAX))
		return true;
	snprintf(reason, REASON_MAX,
	    isinf(v) ? "%s is infinite; a number up to 1e150 is wanted, or %s" :
		       "%s is beyond 1e150 in magnitude; choose another unit",
	    coordinate_name(i), format_of(l->in)->unknown);
	return false;
}

/* Reads the numbers v of the coordinates. Returns false, with the reason, at the first
 * that is not a number within the range. */
static bool read_coordinates(const struct layout *l, struct cut cut,
    const struct chosen *c, double v[4], char reason[REASON_MAX])
{
	for (int i = 0; i < l->reads; i++) {
		const struct field *f = &c->field[i];
		const char *end = f->value.end;

		if (c->times[i] != 1)
			say_missing(l, i, cut, c, reason);
		else if (format_number(l->in, f->value.s, end, &v[i]) != end)
			/* the message shows the quotes of csv */
			say_field(l, i,
			    format_of(l->in)->header ? f->whole : f->value,
			    reason);
		else if (!say_blanks(l, f, reason) &&
		    in_range(l, i, v[i], reason))
			continue;
		return false;
	}
	return true;
}

/* Returns whether a member of that name can be added to an object: the name is not a
 * pointer, is short, and needs no escapes. */
static bool can_be_added(const char *path)
{
	char shown[JSON_ESCAPE_MAX * ADDED_ROOM];
	size_t n = strlen(path);

	return *path != '/' && n < ADDED_ROOM - 8 &&
	    escape_copy(shown, sizeof shown, path, n, true, "") == n;
}

/* Returns whether the fields of a bad line that are not coordinates can be copied. */
static bool can_be_kept(const struct layout *l, struct cut cut,
    const struct chosen *c)
{
	if (cut.s == NULL && !cut.members)
		return false;
	for (int i = 0; i < l->reads; i++)
		if (c->times[i] > 1 ||
		    (c->times[i] == 0 && cut.members &&
			!can_be_added(l->columns.name[i])))
			return false;
	return choose_overlap(l, c) == 0;
}

/* Returns whether --columns fits a line of JSON: numbers an array, names an object.
 * Else writes the reason. */
static bool columns_fit(const struct layout *l, bool members,
    char reason[REASON_MAX])
{
	if (l->columns.n == 0 || members == (l->columns.name[0] != NULL))
		return true;
	snprintf(reason, REASON_MAX,
	    members ?
		"is an object; --columns is to name its members: x,y,z, or "
		"/position/0" :
		"is an array; --columns is to number its elements: 2,3,4");
	return false;
}

/* Returns whether a line whose coordinates are numbers is legal; or writes why not. */
static bool is_right(const struct layout *l, struct cut cut,
    const struct chosen *c, char reason[REASON_MAX])
{
	size_t fields = l->append && l->fields > 0 ? cut_count(cut) : l->fields;

	if (fields != l->fields)
		snprintf(reason, REASON_MAX,
		    "has %zu fields and the header %zu; --append would put the "
		    "image below other names",
		    fields, l->fields);
	else if (cut.bracket != NULL && choose_overlap(l, c) > 0)
		snprintf(reason, REASON_MAX,
		    "has a coordinate in another; --columns names values "
		    "apart");
	else if (c->mixed)
		snprintf(reason, REASON_MAX,
		    "has commas between some numbers and not between others; "
		    "is the comma a decimal point? write 1.5 for 1,5");
	else
		return true;
	return false;
}

/* Finds the coordinates of a line and reads them. Sets the kind of the line:
 * LINE_REFUSED if the first row does not fit its header. */
static void read_fields(struct layout *l, struct span text, enum first first,
    struct line *line, double v[4], char reason[REASON_MAX])
{
	const struct format_row *in = format_of(l->in);
	struct chosen c;

	line->kind = LINE_LOST;
	line->object = *in->open != '\0' &&
	    *skip_blanks(l->in, text.s, text.end) == '{';
	if (in->check != NULL && !in->check(l->in, text, reason))
		return;
	struct cut cut = cut_line(l->in, text);
	const bool longer = in->header &&
	    header_is_short(l, cut, first, reason);

	if (longer && first == FIRST_ROW) {
		line->kind = LINE_REFUSED;
		return;
	}
	if (cut.bracket != NULL && !columns_fit(l, cut.members, reason))
		return;
	choose(l, cut, &c);
	line->kind = LINE_POINT;
	if (longer || (cut.members && choose_clashes(l, &c, true, reason)) ||
	    !read_coordinates(l, cut, &c, v, reason) ||
	    !is_right(l, cut, &c, reason))
		line->kind = LINE_BAD;
	if (c.mixed) {
		cut.words = line->words = l->columns.n == 0;
		choose(l, cut, &c);
	}
	if (line_is_bad(line) && !l->append && !can_be_kept(l, cut, &c))
		line->kind = LINE_LOST;
	choose_places(l, &c, line);
	if (first == FIRST_LINE && line_is_bad(line))
		l->most = 0; /* a bad row may lack fields */
	if (first == FIRST_LINE && line_is_bad(line) && in->blanks &&
	    l->columns.n == 0)
		say_text_header(l, text, &c, reason);
}

void line_read(struct layout *l, struct span text, enum first *first,
    struct line *line, double v[4], char reason[REASON_MAX])
{
	const struct format_row *in = format_of(l->in);
	const enum first was = *first;

	*line = (struct line){ .s = text.s,
		.size = (uint32_t)(text.end - text.s),
		.kind = LINE_COPY };
	if (was == FIRST_LINE) {
		text.s = skip_mark(text.s, text.end);
		line->mark = text.s > line->s;
	}
	const char *s = skip_blanks(l->in, text.s, text.end);

	if (s == text.end)
		return;
	if (was == FIRST_LINE && (*in->open == '\0' || *s == '#') &&
	    format_is_old(l->in, text, reason)) {
		line->kind = LINE_LOST;
	} else if (*s == '#' && header_in_comment(l, text, was == FIRST_LINE)) {
		if (was == FIRST_LINE)
			say_comment(l, text);
		return;
	} else if (was == FIRST_LINE && in->header &&
	    (*s == '{' || (text.end - s > 1 && memcmp(s, "[{", 2) == 0))) {
		line->kind = LINE_LOST;
		say_field(l, 0, (struct span){ s, text.end }, reason);
	} else if (was != FIRST_LINE || !in->header ||
	    !header_read(l, text, line, reason)) {
		read_fields(l, text, was, line, v, reason);
	}
	*first = line->kind == LINE_HEADER ? FIRST_ROW : FIRST_IS_READ;
	if (was == FIRST_LINE && *in->open == '\0' && *first != FIRST_ROW &&
	    line->kind != LINE_REFUSED &&
	    say_headless(l, text, line->kind == LINE_LOST, reason))
		line->kind = LINE_REFUSED;
}
