/* SPDX-License-Identifier: MIT */
#include "cut.h"

#include "check.h"
#include "../json/text.h"
#include "../message/escape.h"
#include "../message/message.h"

/* Returns the end of the quoted text at s, with "" for a quote; NULL: not closed. */
static const char *csv_quote_end(const char *s, const char *end)
{
	do {
		s++;
		s = memchr(s, '"', (size_t)(end - s));
	} while (s != NULL && ++s < end && *s == '"');
	return s;
}

/* Returns the first byte that is not UTF-8, or the end. */
static const char *utf8_end(struct span f)
{
	unsigned code;
	int size = 1;

	for (; f.s < f.end && size > 0; f.s += size)
		size = utf8_read(f.s, f.end, &code);
	return f.s;
}

bool is_utf8(struct span f)
{
	unsigned char high = 0;

	for (const char *s = f.s; s < f.end; s++)
		high |= (unsigned char)*s;
	return high <= 0x7f || utf8_end(f) == f.end;
}

/* Returns the size of the word or number at s, or else of one character. */
static size_t token_size(const char *s, const char *end)
{
	const char *p = s;

	while (p < end && (unsigned char)*p > ' ' && strchr(",:[]{}\"", *p) == NULL)
		p++;
	return p > s ? (size_t)(p - s) : 1;
}

static bool json_line_check(struct dialect d, struct span line, struct refusal *r)
{
	const char *s = skip_blanks(d, line.s, line.end);
	struct json_check c = { .at = s, .end = line.end };
	char shown[ESCAPED_MAX];

	if (!is_utf8(line)) {
		refusal_set(r, NULL, "is not UTF-8",
		    "iconv -f LATIN1 -t UTF-8 makes it so, if it is Latin-1");
		c.at = utf8_end(line);
	} else if (*s != '[' && *s != '{') {
		refusal_set(r, NULL, "is neither a JSON array nor an object",
		    "of csv or text say -i csv or -i text");
	} else if (json_check(&c)) {
		return true;
	} else if (c.at == line.end) {
		refusal_set(r, NULL, "a bracket is not closed on the line",
		    "jq -c . makes one array or object a line");
	} else {
		escape_short(shown, c.at, token_size(c.at, line.end));
		refusal_set(r, NULL,
		    text("is no JSON: expected %s, not '%s'", c.wanted, shown), NULL);
	}
	r->column = (size_t)(c.at - line.s) + 1;
	return false;
}

/* Sets *f to the next field of text. */
static void next_of_text(struct cursor *c, struct field *f)
{
	const char *s = skip_blanks(c->in, c->s, c->end);

	f->value.s = s;
	while (s < c->end && !is_blank(*s))
		s++;
	f->value.end = s;
	f->whole = f->value;
	c->previous_end = s;
	s = skip_blanks(c->in, s, c->end);
	f->next = s < c->end ? s : NULL;
}

/* Sets *f to the next field of csv. If the field begins with a quote, separators and
 * doubled quotes before the closing quote are in it. Other quotes are plain bytes. */
static void next_of_csv(struct cursor *c, struct field *f)
{
	const char *end = c->end, *s = skip_blanks(c->in, c->s, end);

	f->whole.s = c->s;
	if (s < end && *s == '"')
		s = csv_quote_end(s, end);
	s = s != NULL && s < end ? memchr(s, c->in.separator, (size_t)(end - s)) : NULL;
	f->next = s != NULL ? s + 1 : NULL;
	f->whole.end = s != NULL ? s : end;
	if (s == NULL && end > c->s && end[-1] == '\r')
		f->whole.end--;
	f->value = trimmed(c->in, f->whole);
	c->previous_end = f->value.end;
	f->value = trimmed(c->in, unquoted(f->value));
}

static void next_of_json(struct cursor *c, struct field *f)
{
	const char *s = c->s;

	f->whole.s = s;
	if (c->members) {
		f->name = (struct span){ s, json_string_end(s, c->end) };
		s = json_skip_blanks(f->name.end, c->end);
		s = json_skip_blanks(s + 1, c->end);
	}
	const char *after = json_item_end(s, c->end);

	f->value = trimmed(c->in, (struct span){ s, after });
	f->whole.end = c->previous_end = f->value.end;
	f->next = *after == ',' ? json_skip_blanks(after + 1, c->end) : NULL;
}

static bool csv_line_check(struct dialect d, struct span line, struct refusal *r)
{
	struct cursor c = line_cursor(d, line);
	struct field f;

	if (memchr(line.s, '"', (size_t)(line.end - line.s)) == NULL)
		return true;
	while (cursor_next(&c, &f))
		continue;
	/* the last field has all that follows an open quote */
	const char *s = skip_blanks(d, f.whole.s, line.end);

	if (s == line.end || *s != '"' || csv_quote_end(s, line.end) != NULL)
		return true;
	refusal_set(r, NULL, "a quote is not closed on the line",
	    "a field with a newline in it can't be read");
	r->column = (size_t)(s - line.s) + 1;
	return false;
}

bool line_check(struct dialect d, struct span line, struct refusal *r)
{
	if (d.format == FORMAT_JSON)
		return json_line_check(d, line, r);
	return d.format != FORMAT_CSV || csv_line_check(d, line, r);
}

bool line_is_other(struct dialect d, struct span line)
{
	const char *s = skip_blanks(d, line.s, line.end);

	return d.format == FORMAT_OBJ &&
	    !(*s == 'v' && (s + 1 == line.end || is_blank(s[1])));
}

struct cursor line_cursor(struct dialect in, struct span line)
{
	const char *s = line.s, *bracket = NULL;
	bool members = false;

	if (in.format != FORMAT_CSV)
		s = skip_blanks(in, s, line.end);
	if (in.format == FORMAT_OBJ) {
		s = skip_blanks(in, s + 1, line.end);
	} else if (in.format == FORMAT_JSON) {
		members = *s == '{';
		bracket = s + 1;
		s = json_skip_blanks(bracket, line.end);
		s = *s == ']' || *s == '}' ? NULL : s;
	}
	if (in.format == FORMAT_OBJ && s == line.end)
		s = NULL;
	return (struct cursor){ .in = in,
		.s = s,
		.end = line.end,
		.bracket = bracket,
		.members = members };
}

bool cursor_next(struct cursor *c, struct field *f)
{
	if (c->s == NULL)
		return false;
	f->name.s = NULL;
	f->previous_end = c->previous_end;
	if (c->in.format == FORMAT_CSV)
		next_of_csv(c, f);
	else if (c->in.format == FORMAT_JSON)
		next_of_json(c, f);
	else
		next_of_text(c, f);
	c->s = f->next;
	return true;
}
