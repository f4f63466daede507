#include "scan.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "../number/number.h"
#include "../escape.h"
#include "../talk.h"

enum {
	DEPTH_MAX = 100,
	NUMBER_LENGTH = 63, /* cJSON cuts off the rest */
};

struct scan {
	const char *name;
	char *p, *end;
	long line;
	int depth;
};

static _Noreturn void bad(const struct scan *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void bad(const struct scan *s, const char *format, ...)
{
	char what[512];
	va_list args;

	va_start(args, format);
	vsnprintf(what, sizeof what, format, args);
	va_end(args);
	die(EXIT_INPUT, "%s:%ld: %s", s->name, s->line, what);
}

static const struct number_style shortest = { NUMBER_SHORTEST, 0 };

static bool at(const struct scan *s, char c)
{
	return s->p < s->end && *s->p == c;
}

static bool at_comment(const struct scan *s)
{
	if (at(s, '#'))
		return true;
	return s->end - s->p > 1 && s->p[0] == '/' &&
	    (s->p[1] == '/' || s->p[1] == '*');
}

static bool is_letter(char c)
{
	return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static void blank(struct scan *s)
{
	for (; s->p < s->end && strchr(" \t\r\n", *s->p) != NULL; s->p++)
		if (*s->p == '\n')
			s->line++;
}

/* Where the word, number or character at s->p ends. */
static char *token_end(const struct scan *s)
{
	char *p = s->p;

	while (p < s->end && (unsigned char)*p > ' ' &&
	    strchr(",:[]{}\"'/#", *p) == NULL)
		p++;
	if (p == s->p && p < s->end)
		p += utf8_length(p, s->end) > 0 ? utf8_length(p, s->end) : 1;
	return p;
}

/* What is wrong with anything that stands in the wrong place. */
static _Noreturn void stray(const struct scan *s, const char *wanted)
{
	char what[ESCAPED_MAX];

	if (s->p == s->end)
		bad(s, "expected %s, but the text ends", wanted);
	if (at_comment(s))
		bad(s, "comments are not JSON; use a member \"_comment\"");
	if (*s->p == '\'')
		bad(s, "'single quotes' are not JSON; use \"double\" ones");
	escaped(what, s->p, (size_t)(token_end(s) - s->p));
	bad(s, "expected %s, not '%s'", wanted, what);
}

static int hex4(const struct scan *s, const char *p)
{
	int v = 0;

	for (int i = 0; i < 4; i++, p++) {
		const char *all = "0123456789abcdef0123456789ABCDEF";
		const char *d = p < s->end ? strchr(all, *p) : NULL;

		if (d != NULL)
			v = v * 16 + (int)(d - all) % 16;
		else
			bad(s, "\\u in a string needs four hexadecimal digits");
	}
	return v;
}

/* At a backslash. */
static void escape(struct scan *s)
{
	char what[ESCAPED_MAX];

	s->p++;
	if (s->p == s->end || strchr("\"\\/bfnrtu", *s->p) == NULL)
		bad(s, "\\%s is no escape of JSON; a backslash is \\\\",
		    escaped(what, s->p, s->p < s->end));
	if (*s->p++ != 'u')
		return;
	int code = hex4(s, s->p);

	s->p += 4;
	if (code == 0)
		bad(s, "\\u0000 in a string is not supported; leave it out");
	if (code < 0xd800 || code > 0xdfff)
		return;
	if (code < 0xdc00 && s->end - s->p >= 6 && s->p[0] == '\\' &&
	    s->p[1] == 'u') {
		int second = hex4(s, s->p + 2);

		s->p += 6;
		if (second >= 0xdc00 && second <= 0xdfff)
			return;
	}
	bad(s, "\\u%04x is half of a surrogate pair; write both", code);
}

/* At a quotation mark. */
static void string(struct scan *s)
{
	for (s->p++; s->p < s->end && *s->p != '"';) {
		unsigned char c = (unsigned char)*s->p;
		int length = utf8_length(s->p, s->end);

		if (c == '\\') {
			escape(s);
			continue;
		}
		if (c == '\n' || c == '\r')
			bad(s, "a string is not closed on its line; add '\"'");
		if (c < ' ')
			bad(s, "control character in a string; write \\u%04x",
			    (unsigned)c);
		if (length == 0)
			bad(s, "byte 0x%02x is not UTF-8; JSON is UTF-8 text",
			    (unsigned)c);
		s->p += length;
	}
	if (s->p == s->end)
		bad(s, "a string is not closed; add '\"'");
	s->p++;
}

static bool digits(const char **p, const char *end)
{
	const char *start = *p;

	while (*p < end && **p >= '0' && **p <= '9')
		++*p;
	return *p > start;
}

static bool is_number(const char *p, const char *end)
{
	if (p < end && *p == '-')
		p++;
	const char *start = p;

	if (!digits(&p, end) || (*start == '0' && p > start + 1))
		return false;
	if (p < end && *p == '.') {
		p++;
		if (!digits(&p, end))
			return false;
	}
	if (p < end && (*p == 'e' || *p == 'E')) {
		p++;
		if (p < end && (*p == '+' || *p == '-'))
			p++;
		if (!digits(&p, end))
			return false;
	}
	return p == end;
}

/* No number of JSON; but perhaps one of a programming language. */
static _Noreturn void not_number(const struct scan *s, const char *end)
{
	char what[ESCAPED_MAX], text[NUMBER_MAX];
	double v;

	escaped(what, s->p, (size_t)(end - s->p));
	if (number_read(s->p, end, &v) != end)
		bad(s, "'%s' is not a JSON number; write it like -1.5e-3",
		    what);
	if (isnan(v))
		bad(s, "'%s' is not JSON; an unknown coordinate is null", what);
	if (isinf(v))
		bad(s, "'%s' is not JSON; only \"far\" can be \"infinity\"",
		    what);
	char *e = number_write(text, v, shortest);

	bad(s, "'%s' is not a JSON number; write %.*s", what, (int)(e - text),
	    text);
}

static void number(struct scan *s)
{
	char *end = token_end(s);
	double v = 0;
	char text[NUMBER_MAX] = "1e999", *e = text + 5;

	if (!is_number(s->p, end))
		not_number(s, end);
	if (end - s->p > NUMBER_LENGTH) {
		number_read(s->p, end, &v);
		if (isfinite(v))
			e = number_write(text, v, shortest);
		memset(s->p, ' ', (size_t)(end - s->p));
		memcpy(s->p, text, (size_t)(e - text));
	}
	s->p = end;
}

static void word(struct scan *s)
{
	static const char *const words[][2] = { { "true", "true" },
		{ "false", "false" }, { "null", "null" }, { "none", "null" },
		{ "undefined", "null" } };
	char *end = token_end(s), what[ESCAPED_MAX];
	size_t n = (size_t)(end - s->p);
	double v;

	escaped(what, s->p, n);
	for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
		if (strcasecmp(what, words[i][0]) != 0)
			continue;
		if (strcmp(what, words[i][1]) != 0)
			bad(s, "'%s' is not JSON; write %s", what, words[i][1]);
		s->p = end;
		return;
	}
	if (number_read(s->p, end, &v) == end)
		not_number(s, end);
	bad(s, "'%s' is not JSON; text needs \"double quotes\"", what);
}

static void list(struct scan *s);

static void value(struct scan *s)
{
	char c = s->p < s->end ? *s->p : '\0';

	if (c == '{' || c == '[')
		list(s);
	else if (c == '"')
		string(s);
	else if ((c >= '0' && c <= '9') || (c != '\0' && strchr("+-.", c)))
		number(s);
	else if (is_letter(c))
		word(s);
	else
		stray(s, "a value");
}

/* A member's name and colon. */
static void name(struct scan *s)
{
	char what[ESCAPED_MAX];
	char c = s->p < s->end ? *s->p : '\0';

	if (is_letter(c) || c == '_') {
		escaped(what, s->p, (size_t)(token_end(s) - s->p));
		bad(s, "the name %s has no quotes; write \"%s\"", what, what);
	}
	if (c != '"')
		stray(s, "a member's name in quotes");
	string(s);
	blank(s);
	if (!at(s, ':'))
		stray(s, "':' after the member's name");
	s->p++;
	blank(s);
}

/* At an opening bracket or brace. */
static void list(struct scan *s)
{
	char open = *s->p, close = open == '{' ? '}' : ']';
	long opened = s->line;

	if (++s->depth > DEPTH_MAX)
		bad(s, "more than %d levels of brackets", DEPTH_MAX);
	s->p++;
	blank(s);
	while (!at(s, close)) {
		if (close == '}')
			name(s);
		value(s);
		blank(s);
		if (s->p == s->end)
			bad(s, "the text ends; add '%c' for '%c' of line %ld",
			    close, open, opened);
		if (at(s, close))
			break;
		if (!at(s, ','))
			stray(s, open == '{' ? "',' or '}'" : "',' or ']'");
		s->p++;
		blank(s);
		if (at(s, close))
			bad(s, "trailing comma before '%c'; remove it", close);
	}
	s->p++;
	s->depth--;
}

void syntax_check(const char *file, char *text, size_t size)
{
	struct scan s = { file, text, text + size, 1, 0 };
	char *nul = memchr(text, '\0', size);

	if (nul != NULL) {
		for (; s.p < nul; s.p++)
			s.line += *s.p == '\n';
		bad(&s, "a NUL byte; JSON is UTF-8 text");
	}
	if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
		memset(text, ' ', 3);
	blank(&s);
	if (s.p == s.end)
		bad(&s, "the document is empty; expected a JSON value");
	value(&s);
	blank(&s);
	if (at_comment(&s))
		stray(&s, "nothing");
	if (s.p < s.end)
		bad(&s, "text after the document; one JSON value is wanted");
}
