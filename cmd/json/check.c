/* SPDX-License-Identifier: MIT */
#include "check.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "../message/escape.h"
#include "../number/number.h"
#include "../message/utf8.h"
#include "text.h"

enum { LEVELS_MAX = 100 };

/* A text that is right up to p. The functions below check what stands at p,
 * move p past it and return true; or set *error, leave p where the text goes
 * wrong and return false. */
struct check {
	enum json_kind kind;
	const char *text, *p, *end;
	long line; /* where it begins */
	int level;
	struct json_error *error;
	const char *name; /* of the member to be found, or NULL */
	struct span part;
};

static bool is_letter(char c)
{
	return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static long line_of(const struct check *s, const char *p)
{
	long line = s->line;

	for (const char *c = s->text; c < p; c++)
		line += *c == '\n';
	return line;
}

/* Says what is wrong at s->p. Returns false. */
static bool fail(const struct check *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static bool fail(const struct check *s, const char *format, ...)
{
	struct json_error *e = s->error;
	va_list args;

	va_start(args, format);
	vsnprintf(e->reason, sizeof e->reason, format, args);
	va_end(args);
	e->at = s->p;
	e->line = line_of(s, s->p);
	return false;
}

static bool at(const struct check *s, char c)
{
	return s->p < s->end && *s->p == c;
}

static bool at_comment(const struct check *s)
{
	return at(s, '#') ||
	    (s->end - s->p > 1 && s->p[0] == '/' &&
		(s->p[1] == '/' || s->p[1] == '*'));
}

static void blanks(struct check *s)
{
	const char *p = s->p;

	while (
	    p < s->end && (*p == ' ' || *p == '\n' || *p == '\t' || *p == '\r'))
		p++;
	s->p = p;
}

/* Whether c can be part of a word or number. */
static bool in_token(char c)
{
	switch (c) {
	case ',':
	case ':':
	case '[':
	case ']':
	case '{':
	case '}':
	case '"':
	case '\'':
	case '/':
	case '#':
		return false;
	default:
		return (unsigned char)c > ' ';
	}
}

/* Where the word or number at p ends. */
static const char *token_end(const struct check *s, const char *p)
{
	while (p < s->end && in_token(*p))
		p++;
	return p;
}

/* The word, number or character at s->p, for a message. */
static const char *token(const struct check *s, char out[ESCAPED_MAX])
{
	const char *e = token_end(s, s->p);
	int n = utf8_length(s->p, s->end);

	if (e == s->p)
		e += n > 0 ? n : 1;
	return escaped(out, s->p, (size_t)(e - s->p));
}

/* Says that something else is wanted at s->p. */
static bool stray(const struct check *s, const char *wanted)
{
	char what[ESCAPED_MAX];

	if (s->p == s->end)
		return fail(s, "expected %s, but the text ends", wanted);
	if (at_comment(s))
		return fail(s,
		    "comments are not JSON; use a member \"_comment\"");
	if (*s->p == '\'')
		return fail(s,
		    "'single quotes' are not JSON; use \"double\" ones");
	return fail(s, "expected %s, not '%s'", wanted, token(s, what));
}

/* The four digits after \u. */
static bool unicode_digits(struct check *s, unsigned *code)
{
	const char *start = s->p;

	s->p = json_hex4(start, s->end, code);
	if (s->p == start + 4)
		return true;
	s->p--; /* at the last character that is right */
	return fail(s, "\\u in a string needs four hexadecimal digits");
}

/* After \u. */
static bool check_unicode(struct check *s)
{
	unsigned code, second = 0;

	if (!unicode_digits(s, &code))
		return false;
	if (s->kind == JSON_LINE)
		return true;
	if (code == 0)
		return fail(s,
		    "\\u0000 in a string is not supported; leave it out");
	if (code >> 10 != FIRST_HALF && code >> 10 != SECOND_HALF)
		return true;
	if (code >> 10 == FIRST_HALF && s->end - s->p >= 6 && s->p[0] == '\\' &&
	    s->p[1] == 'u') {
		s->p += 2;
		if (!unicode_digits(s, &second))
			return false;
	}
	return second >> 10 == SECOND_HALF ||
	    fail(s, "\\u%04x is half of a surrogate pair; write both", code);
}

/* At a backslash. */
static bool escape(struct check *s)
{
	const char *p = s->p + 1;
	char what[ESCAPED_MAX];

	if (p == s->end || memchr("\"\\/bfnrtu", *p, 9) == NULL)
		return fail(s, "\\%s is no escape of JSON; a backslash is \\\\",
		    escaped(what, p, p < s->end));
	s->p += 2;
	return *p != 'u' || check_unicode(s);
}

/* At a character of a string. */
static bool character(struct check *s)
{
	unsigned c = (unsigned char)*s->p;

	if (c == '\\')
		return escape(s);
	if (c == '\n' || c == '\r')
		return fail(s, "a string is not closed on its line; add '\"'");
	if (c < ' ')
		return fail(s, "control character in a string; write \\u%04x",
		    c);
	bool any = c < 0x80 || s->kind == JSON_LINE;
	int n = any ? 1 : utf8_length(s->p, s->end);

	s->p += n;
	return n > 0 ||
	    fail(s, "byte 0x%02x is not UTF-8; JSON is UTF-8 text", c);
}

/* Whether c is any character of a string but a quotation mark, and needs no
 * look at what is around it. */
static bool passes_unseen(char c)
{
	return c >= ' ' && c != '"' && c != '\\' && (unsigned char)c < 0x80;
}

/* At a quotation mark. */
static bool string(struct check *s)
{
	for (s->p++;;) {
		while (s->p < s->end && passes_unseen(*s->p))
			s->p++;
		if (at(s, '"'))
			break;
		if (s->p == s->end)
			return fail(s, "a string is not closed; add '\"'");
		if (!character(s))
			return false;
	}
	s->p++;
	return true;
}

/* Refuses the number or word at start. If it is one of a programming language,
 * says how JSON writes it. */
static bool not_scalar(const struct check *s, const char *start)
{
	static const char *const words[][2] = { { "true", "true" },
		{ "false", "false" }, { "null", "null" }, { "none", "null" },
		{ "undefined", "null" } };
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	const char *end = token_end(s, start);
	char what[ESCAPED_MAX], text[NUMBER_MAX];
	double v;
	bool number = number_read(start, end, &v) == end;

	escaped(what, start, (size_t)(end - start));
	for (size_t i = 0; i < sizeof words / sizeof *words; i++)
		if (strcasecmp(what, words[i][0]) == 0)
			return fail(s, "'%s' is not JSON; write %s", what,
			    words[i][1]);
	if (!number && is_letter(*start))
		return fail(s, "'%s' is not JSON; text needs \"double quotes\"",
		    what);
	if (!number)
		return fail(s,
		    "'%s' is not a JSON number; write it like -1.5e-3", what);
	if (isnan(v))
		return fail(s,
		    "'%s' is not JSON; an unknown coordinate is null", what);
	if (isinf(v))
		return fail(s,
		    "'%s' is not JSON; only \"far\" can be \"infinity\"", what);
	*number_write(text, v, shortest) = '\0';
	return fail(s, "'%s' is not a JSON number; write %s", what, text);
}

/* Where true, false or null at s ends; NULL if none of them stands there. */
static const char *word_end(const char *s, const char *end)
{
	static const char *const words[] = { "true", "false", "null" };

	for (int i = 0; i < 3; i++) {
		size_t n = strlen(words[i]);

		if ((size_t)(end - s) >= n && memcmp(s, words[i], n) == 0)
			return s + n;
	}
	return NULL;
}

/* At a number or a word. */
static bool scalar(struct check *s)
{
	const char *start = s->p;
	const char *e = is_letter(*start) ? word_end(start, s->end) :
					    json_number_end(start, s->end);

	if (e != NULL)
		s->p = e;
	if (e != NULL && (e == s->end || !in_token(*e)))
		return true;
	return not_scalar(s, start);
}

static bool list(struct check *s);

static bool value(struct check *s)
{
	char c = s->p < s->end ? *s->p : '\0';

	if ((c >= '0' && c <= '9') || c == '-')
		return scalar(s);
	if (c == '{' || c == '[')
		return list(s);
	if (is_letter(c) || c == '+' || c == '.')
		return scalar(s);
	return c == '"' ? string(s) : stray(s, "a value");
}

/* At a number behind the value of a member: {"eye": 0,0,5}. */
static bool at_bare_list(const struct check *s)
{
	const char *before = s->p;

	if (s->p == s->end || memchr("0123456789-", *s->p, 11) == NULL)
		return false;
	while (strchr(" \t\r\n", *--before) != NULL)
		continue;
	return *before == ',';
}

/* A member's name and colon. */
static bool name(struct check *s)
{
	char what[ESCAPED_MAX];

	if (s->p < s->end && (is_letter(*s->p) || *s->p == '_'))
		return fail(s, "the name %s has no quotes; write \"%s\"",
		    token(s, what), what);
	if (at_bare_list(s))
		return fail(s,
		    "expected a member's name in quotes, not '%s'; several "
		    "numbers stand in brackets: [1,2,3]",
		    token(s, what));
	if (!at(s, '"'))
		return stray(s, "a member's name in quotes");
	if (!string(s))
		return false;
	blanks(s);
	if (!at(s, ':'))
		return stray(s, "':' after the member's name");
	s->p++;
	blanks(s);
	return true;
}

/* After a value: up to the next one, or to the bracket that closes the list. */
static bool comma(struct check *s, const char *open, char close)
{
	blanks(s);
	if (s->p == s->end)
		return fail(s, "the text ends; add '%c' for '%c' of line %ld",
		    close, *open, line_of(s, open));
	if (at(s, close))
		return true;
	if (memchr("/*+", *s->p, 3) != NULL && !at_comment(s))
		return fail(s,
		    "JSON has no arithmetic, and '%c' is not ',' or '%c'; "
		    "write the number that it gives",
		    *s->p, close);
	if (!at(s, ','))
		return stray(s, close == '}' ? "',' or '}'" : "',' or ']'");
	s->p++;
	blanks(s);
	return !at(s, close) ||
	    fail(s, "trailing comma before '%c'; remove it", close);
}

static bool member(struct check *s)
{
	const char *quoted = s->p, *start;

	if (!name(s))
		return false;
	start = s->p;
	if (!value(s))
		return false;
	if (s->level == 1 && s->name != NULL && s->part.s == NULL &&
	    json_is_name(quoted, s->end, s->name))
		s->part = (struct span){ start, s->p };
	return true;
}

/* An array or object, at its opening bracket or brace. */
static bool list(struct check *s)
{
	const char *open = s->p++;
	char close = *open == '{' ? '}' : ']';

	if (++s->level > LEVELS_MAX)
		return fail(s, "more than %d levels of brackets", LEVELS_MAX);
	blanks(s);
	while (!at(s, close))
		if (!(close == '}' ? member(s) : value(s)) ||
		    !comma(s, open, close))
			return false;
	s->p++;
	s->level--;
	return true;
}

static bool check_text(struct check *s)
{
	const char *nul = s->kind == JSON_LINE ?
	    NULL :
	    memchr(s->text, '\0', (size_t)(s->end - s->text));
	const char *start;

	if (nul != NULL) {
		s->p = nul;
		return fail(s, "a NUL byte; JSON is UTF-8 text");
	}
	blanks(s);
	if (s->p == s->end)
		return fail(s, "the document is empty; expected a JSON value");
	start = s->p;
	if (!value(s))
		return false;
	if (s->name == NULL)
		s->part = (struct span){ start, s->p };
	blanks(s);
	if (at_comment(s))
		return stray(s, "nothing");
	return s->p == s->end ||
	    fail(s, "text after the document; one JSON value is wanted");
}

bool json_check(enum json_kind kind, const char *text, const char *end,
    struct json_error *error)
{
	struct check s = { .kind = kind,
		.text = text,
		.p = text,
		.end = end,
		.line = 1,
		.error = error };

	return check_text(&s);
}

bool json_check_part(const char *text, const char *end, long line,
    const char *name, struct span *part, struct json_error *error)
{
	struct check s = { .kind = JSON_DOCUMENT,
		.text = text,
		.p = text,
		.end = end,
		.line = line,
		.error = error,
		.name = name };
	bool ok = check_text(&s);

	*part = s.part;
	return ok;
}
