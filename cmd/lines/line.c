/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include "header.h"
#include "line.h"
#include "reason.h"
#include "../message/escape.h"

static bool read_coordinates(const struct lookup *found, double v[4],
    char reason[REASON_MAX])
{
	for (int i = 0; i < found->l->reads; i++) {
		const struct field *f = &found->field[i];
		const char *end = f->value.end;

		if (found->times[i] != 1)
			reason_missing(found, i, reason);
		else if (format_read(found->l->in, f->value.s, end, &v[i]) != end)
			reason_field(found->l, i, f, reason);
		else if (reason_in_range(found->l, i, v[i], reason))
			continue;
		return false;
	}
	return true;
}

/* Returns whether `path` can name a new member: no pointer, short, without escapes. */
static bool can_be_added(const char *path)
{
	char shown[JSON_ESCAPE_MAX * PREFIX_ROOM];
	size_t n = strlen(path);

	return n < PREFIX_ROOM - 8 &&
	    escape_copy(shown, sizeof shown, path, n, true, "") == n;
}

/* Returns whether a line with a bad coordinate can be written with its other fields. */
static bool can_be_kept(const struct lookup *found)
{
	if (found->c.s == NULL && !found->c.members)
		return false;
	for (int i = 0; i < found->l->reads; i++)
		if (found->times[i] > 1 ||
		    (found->times[i] == 0 && found->c.members &&
			*found->l->columns.name[i] != '/' &&
			!can_be_added(found->l->columns.name[i])))
			return false;
	return lookup_find_overlap(found) == 0;
}

/* Returns whether --columns has indexes for an array, or names of members; says why. */
static bool columns_fit(const struct layout *l, bool members, char reason[REASON_MAX])
{
	if (l->columns.n == 0 || members == (l->columns.name[0] != NULL))
		return true;
	strcpy(reason,
	    members ? "is an object; --columns is to name its members: x,y,z, or "
		      "/position/0" :
		      "is an array; --columns is to number its elements: 2,3,4");
	return false;
}

static bool is_legal(const struct lookup *found, char reason[REASON_MAX])
{
	const struct layout *l = found->l;

	if (l->output.append && l->seen.header_fields > 0 &&
	    cursor_count(found->c) != l->seen.header_fields)
		snprintf(reason, REASON_MAX,
		    "has %zu fields and the header %zu; --append would put the image "
		    "below other names",
		    cursor_count(found->c), l->seen.header_fields);
	else if (found->c.bracket != NULL && lookup_find_overlap(found) > 0)
		strcpy(reason,
		    "has a coordinate in another; --columns names values apart");
	else if (found->mixed_commas)
		strcpy(reason,
		    "has commas between some numbers and not between others; is the "
		    "comma a decimal point? write 1.5 for 1,5");
	else
		return true;
	return false;
}

/* Sets the kind of the line: LINE_REFUSED if the first row does not fit its header. */
static void read_fields(struct layout *l, struct span text, enum next_part first,
    struct line *line, double v[4], char reason[REASON_MAX])
{
	const struct format_row *in = format_of(l->in);
	struct lookup found;

	line->kind = LINE_LOST;
	line->object = *in->open != '\0' &&
	    *skip_blanks(l->in, text.s, text.end) == '{';
	if (in->check != NULL && !in->check(l->in, text, reason))
		return;
	struct cursor c = line_cursor(l->in, text);
	const bool longer = in->header && header_row_is_long(l, c, first, reason);

	if (longer && first == FIRST_ROW) {
		line->kind = LINE_REFUSED;
		return;
	}
	if (c.bracket != NULL && !columns_fit(l, c.members, reason))
		return;
	lookup_fields(&found, l, c);
	line->kind = LINE_POINT;
	if (longer || (c.members && lookup_clashes(&found, reason)) ||
	    !read_coordinates(&found, v, reason) || !is_legal(&found, reason))
		line->kind = LINE_BAD;
	if (found.mixed_commas) {
		c.no_commas = line->no_commas = l->columns.n == 0;
		lookup_fields(&found, l, c);
	}
	if (line->kind == LINE_POINT && first == FIRST_ROW && l->seen.reordered &&
	    layout_has_names(l) && cursor_count(c) < l->seen.header_fields) {
		snprintf(reason, REASON_MAX,
		    "has %zu fields and the header %zu, so that its names may be those "
		    "of other columns; say --columns by number",
		    cursor_count(c), l->seen.header_fields);
		line->kind = LINE_REFUSED;
		return;
	}
	if (line_is_bad(line) && !l->output.append && !can_be_kept(&found))
		line->kind = LINE_LOST;
	lookup_set_parts(&found, line);
	if (first != FIRST_LINE || !line_is_bad(line))
		return;
	l->seen.max_fields = 0; /* unknown, as a bad row may lack fields */
	if (in->blanks && l->columns.n == 0 && found.times[l->reads - 1] > 0 &&
	    lookup_is_header(l, c))
		reason_text_header(l, text, reason);
}

void line_read(struct layout *l, struct span text, enum next_part *first,
    struct line *line, double v[4], char reason[REASON_MAX])
{
	const struct format_row *in = format_of(l->in);
	const bool json = *in->open != '\0', first_line = *first == FIRST_LINE;

	*line = (struct line){ .s = text.s,
		.size = (uint32_t)(text.end - text.s),
		.kind = LINE_COPY };
	if (first_line) {
		l->seen.first_line++;
		text.s = skip_bom(text.s, text.end);
		line->has_bom = text.s > line->s;
	}
	const char *s = skip_blanks(l->in, text.s, text.end);

	if (s == text.end)
		return;
	const bool binary = memchr(s, '\0', (size_t)(text.end - s)) != NULL;

	if (first_line && (!json || *s == '#') &&
	    format_has_only_cr(l->in, text, reason)) {
		line->kind = LINE_LOST;
	} else if (*s == '#' && !binary && header_is_comment(l, text, first_line)) {
		if (first_line)
			reason_comment_columns(l, text);
		return;
	} else if (first_line && in->header &&
	    (*s == '{' || (text.end - s > 1 && memcmp(s, "[{", 2) == 0))) {
		line->kind = LINE_LOST; /* JSON is neither a header nor a row */
		text.s = s;
		reason_field(l, 0, &(struct field){ .value = text, .whole = text },
		    reason);
	} else if (!first_line || !in->header || !header_read(l, text, line, reason)) {
		read_fields(l, text, *first, line, v, reason);
	}
	if (binary && !line_is_bad(line))
		line->kind = line->kind == LINE_POINT ? LINE_BAD : LINE_LOST;
	*first = line->kind == LINE_HEADER ? FIRST_ROW : FIRST_NONE;
	if (first_line && !json && *first != FIRST_ROW && line->kind != LINE_REFUSED &&
	    reason_needs_header(l, text, line->kind == LINE_LOST, reason))
		line->kind = LINE_REFUSED;
	if (line_is_bad(line))
		reason_binary(l, text, binary, reason);
}
