/* SPDX-License-Identifier: MIT */
#include "line.h"

#include "../json/text.h"

struct cut cut_value(struct span value, const char *end)
{
	const char *s = json_skip_blanks(value.s + 1, end);

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

size_t cut_count(struct cut c)
{
	struct field f;
	size_t n = 0;

	while (cut_next(&c, &f))
		n++;
	return n;
}
