/* SPDX-License-Identifier: MIT */
#include "cut.h"

#include "../json/text.h"

struct cut cut_value(struct span value, const char *end)
{
	const char *s = json_space(value.s + 1, end);

	return (struct cut){ .in = { FORMAT_JSON, ',' },
		.s = *s == ']' || *s == '}' ? NULL : s,
		.end = end,
		.bracket = value.s + 1,
		.members = *value.s == '{' };
}

struct cut cut_line(struct dialect in, struct span text)
{
	const char *s = text.s;

	if (in.format == FORMAT_JSON)
		return cut_value(
		    (struct span){ skip_blanks(in, s, text.end), text.end },
		    text.end);
	if (in.format == FORMAT_TEXT)
		s = skip_blanks(in, s, text.end);
	return (struct cut){ .in = in, .s = s, .end = text.end };
}

/* A field of text: up to a blank or, unless it is one of words, a comma. */
static void next_of_text(struct cut *c, struct field *f)
{
	const char *s = c->s, *after;

	f->value.s = s;
	while (s < c->end && !is_blank(*s) && (c->words || *s != ','))
		s++;
	f->value.end = s;
	f->whole = f->value;
	after = c->words ? skip_blanks(c->in, s, c->end) :
			   skip_separator(s, c->end);
	c->comma = !c->words && memchr(s, ',', (size_t)(after - s)) != NULL;
	f->next = after == c->end && !c->comma ? NULL : after;
}

/* A field of csv. If it begins with a quote, separators up to the closing quote are
 * part of it; "" stands for a quote and doesn't close it. In a field that does
 * not begin with one, as in 5" pipe, a quote is like any other character. */
static void next_of_csv(struct cut *c, struct field *f)
{
	const char *s = skip_blanks(c->in, c->s, c->end), *end = c->end;

	f->whole.s = c->s;
	f->closed = s == end || *s != '"';
	for (s += !f->closed; s < end && !f->closed; s++)
		if (*s == '"' && (s + 1 == end || *++s != '"')) {
			f->closed = true;
			break;
		}
	while (s < end && *s != c->in.separator)
		s++;
	f->next = s < end ? s + 1 : NULL;
	if (s == end && s > c->s && s[-1] == '\r')
		s--;
	f->whole.end = s;
	f->value = trimmed(c->in, f->whole);
	if (f->value.end - f->value.s >= 2 && *f->value.s == '"' &&
	    f->value.end[-1] == '"') {
		f->value.s++;
		f->value.end--;
	}
}

/* An element of an array, or a member of an object. */
static void next_of_json(struct cut *c, struct field *f)
{
	const char *s = c->s;

	f->whole.s = s;
	if (c->members) {
		f->name = (struct span){ s, json_string(s, c->end) };
		s = json_space(f->name.end, c->end);
		s = json_space(s + 1, c->end);
	}
	const char *after = json_skip(s, c->end);

	f->value = trimmed(c->in, (struct span){ s, after });
	f->whole.end = f->value.end;
	f->next = *after == ',' ? json_space(after + 1, c->end) : NULL;
}

bool cut_next(struct cut *c, struct field *f)
{
	if (c->s == NULL)
		return false;
	*f = (struct field){ .from = c->from, .comma = c->comma, .closed = true };
	switch (c->in.format) {
	case FORMAT_CSV:
		next_of_csv(c, f);
		break;
	case FORMAT_JSON:
		next_of_json(c, f);
		break;
	default:
		next_of_text(c, f);
	}
	c->s = f->next;
	c->from = trimmed(c->in, f->whole).end;
	return true;
}

struct span field_drop(const struct field *f)
{
	if (f->from != NULL)
		return (struct span){ f->from, f->whole.end };
	return (struct span){ f->whole.s,
		f->next != NULL ? f->next : f->whole.end };
}

struct cut cut_behind(struct cut c, const char *s)
{
	const char *after = skip_blanks(c.in, s + (s < c.end && *s == '"'), c.end);

	c.from = s;
	if (c.in.format == FORMAT_TEXT)
		after = skip_separator(s, c.end);
	else
		after = after < c.end && *after == c.in.separator ? after + 1 : NULL;
	c.s = after == c.end ? NULL : after;
	if (c.s != NULL && c.in.format == FORMAT_JSON)
		c.s = json_space(c.s, c.end);
	return c;
}
