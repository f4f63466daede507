/* SPDX-License-Identifier: MIT */
#include "line.h"

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

struct cut cut_line(struct dialect in, struct span line)
{
	if (*format_of(in)->open != '\0')
		return cut_value(trimmed(in, line), line.end);
	return (struct cut){ .in = in, .s = line.s, .end = line.end };
}

bool cut_next(struct cut *c, struct field *f)
{
	if (c->s == NULL)
		return false;
	f->name.s = NULL;
	f->open = false;
	f->from = c->from;
	f->comma = c->comma;
	format_of(c->in)->next(c, f);
	c->s = f->next;
	return true;
}

void cut_behind(struct cut *c, const char *s)
{
	const char *end = c->end, *after;

	c->from = s;
	if (format_of(c->in)->blanks) {
		after = skip_separator(s, end);
		c->s = after < end ? after : NULL;
		return;
	}
	after = skip_blanks(c->in, s + (s < end && *s == '"'), end);
	c->s = after < end && *after == c->in.separator ? after + 1 : NULL;
	if (c->s != NULL && c->bracket != NULL)
		c->s = json_space(c->s, end);
}

size_t cut_count(struct cut c)
{
	struct field f;
	size_t n = 0;

	while (cut_next(&c, &f))
		n++;
	return n;
}

struct span cut_out(const struct field *f)
{
	if (f->from != NULL)
		return (struct span){ f->from, f->whole.end };
	return (struct span){ f->whole.s,
		f->next != NULL ? f->next : f->whole.end };
}
