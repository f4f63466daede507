/* SPDX-License-Identifier: MIT */
#include "check.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "../message/escape.h"
#include "../message/nearest.h"
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

static bool is_blank(char c)
{
	return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

static bool at(const struct check *s, char c)
{
	return s->p < s->end && *s->p == c;
}

static void blanks(struct check *s)
{
	const char *p = s->p;

	while (p < s->end && is_blank(*p))
		p++;
	s->p = p;
}

/* Whether c can be part of a word or number. */
static bool in_token(char c)
{
	return (unsigned char)c > ' ' && strchr(",:[]{}\"'/#", c) == NULL;
}

/* Where the word, number or other character at s->p ends. */
static const char *token_end(const struct check *s)
{
	const char *p = s->p;
	int n = utf8_length(p, s->end);

	while (p < s->end && in_token(*p))
		p++;
	return p > s->p ? p : p + (n > 0 ? n : 1);
}

/* What stands at s->p, for a message. */
static const char *token(const struct check *s, char out[ESCAPED_MAX])
{
	return escaped(out, s->p, (size_t)(token_end(s) - s->p));
}

static long line_of(const struct check *s, const char *p)
{
	long line = s->line;

	for (const char *c = s->text; c < p; c++)
		line += *c == '\n';
	return line;
}

/* Whether a comma stands before s->p and blanks. */
static bool after_comma(const struct check *s)
{
	const char *p = s->p;

	while (p > s->text && is_blank(p[-1]))
		p--;
	return p > s->text && p[-1] == ',';
}

/* What to do with a character that stands nowhere in JSON, or not there; or NULL. */
static const char *hint_of(const struct check *s)
{
	const char *p = s->p;
	char next = s->end - p > 1 ? p[1] : '\0';

	if (*p == '#' || (*p == '/' && (next == '/' || next == '*')))
		return "comments are not JSON; use a member \"_comment\"";
	if (*p == '\'')
		return "JSON has \"double quotes\" alone";
	if (*p == '\0' || utf8_length(p, s->end) == 0)
		return "JSON is UTF-8 text";
	if ((*p == ']' || *p == '}') && after_comma(s))
		return "remove the comma before it";
	return NULL;
}

/* Says what is wanted at s->p, what stands there, and a hint, unless that is NULL.
 * Returns false. */
static bool expected(struct check *s, const char *wanted, const char *hint, ...)
    __attribute__((format(printf, 3, 4)));

static bool expected(struct check *s, const char *wanted, const char *hint, ...)
{
	const bool ends = s->p == s->end;
	const char *other = ends ? NULL : hint_of(s);
	struct json_error *e = s->error;
	char what[ESCAPED_MAX] = "", said[100] = "";
	va_list args;

	va_start(args, hint);
	if (other != NULL)
		snprintf(said, sizeof said, "; %s", other);
	else if (hint != NULL)
		vsnprintf(stpcpy(said, "; "), sizeof said - 2, hint, args);
	va_end(args);
	snprintf(e->reason, sizeof e->reason, "expected %s,%s%s%s%s", wanted,
	    ends ? " but the text ends" : " not '", ends ? "" : token(s, what),
	    ends ? "" : "'", said);
	e->at = s->p;
	e->line = line_of(s, s->p);
	return false;
}

/* At a backslash. */
static bool escape(struct check *s)
{
	const char *p = s->p, *next;
	char c[4];
	int n;

	if (s->end - p < 2 || memchr("\"\\/bfnrtu", p[1], 9) == NULL)
		return expected(s, "an escape of JSON", "a backslash is \\\\");
	next = json_unescape(p, s->end, c, &n);
	if (p[1] == 'u' && next - p < 6)
		return expected(s, "four hexadecimal digits after \\u", NULL);
	if (p[1] == 'u' && s->kind == JSON_DOCUMENT) {
		if (c[0] == '\0')
			return expected(s, "text in a string",
			    "leave \\u0000 out");
		/* U+FFFD for \ud800 to \udfff */
		if (c[0] == '\xef' && (p[2] | 0x20) == 'd')
			return expected(s, "both halves of a surrogate pair",
			    NULL);
	}
	s->p = next;
	return true;
}

/* At a character of a string. */
static bool character(struct check *s)
{
	unsigned char c = (unsigned char)*s->p;
	int n = 1;

	if (c == '\\')
		return escape(s);
	if (c == '\n' || c == '\r')
		return expected(s, "'\"' at the end of a string",
		    "a string ends on its line");
	if (c < ' ')
		return expected(s, "text in a string",
		    "write a control character as this escape");
	if (s->kind == JSON_DOCUMENT)
		n = utf8_length(s->p, s->end);
	s->p += n;
	return n > 0 || expected(s, "text in a string", NULL);
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
			return expected(s, "'\"' at the end of a string", NULL);
		if (!character(s))
			return false;
	}
	s->p++;
	return true;
}

static const char *const words[] = { "true", "false", "null", NULL };

/* Refuses what stands in the place of a value. If it is a number or a word of a
 * programming language, says how JSON writes it. */
static bool no_value(struct check *s)
{
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	const char *wanted = "a value", *near;
	char what[ESCAPED_MAX], text[NUMBER_MAX];
	double v;

	if (s->p == s->end ||
	    !(is_letter(*s->p) || strchr("+-.0123456789", *s->p) != NULL))
		return expected(s, wanted, NULL);
	if (number_read(s->p, token_end(s), &v) != token_end(s)) {
		near = nearest(token(s, what), words);
		if (near != NULL)
			return expected(s, wanted, "write %s", near);
		return expected(s, wanted,
		    is_letter(*s->p) ? "text needs \"double quotes\"" :
				       "a number is like -1.5e-3");
	}
	if (isnan(v))
		return expected(s, wanted, "an unknown coordinate is null");
	if (isinf(v))
		return expected(s, wanted, "only \"far\" can be \"infinity\"");
	*number_write(text, v, shortest) = '\0';
	return expected(s, wanted, "write %s", text);
}

/* Where true, false, null or the number at s ends; NULL if none stands there. */
static const char *scalar_end(const char *s, const char *end)
{
	for (int i = 0; i < 3 && s < end && is_letter(*s); i++) {
		size_t n = strlen(words[i]);

		if ((size_t)(end - s) >= n && memcmp(s, words[i], n) == 0)
			return s + n;
	}
	return json_number_end(s, end);
}

static bool list(struct check *s);

static bool value(struct check *s)
{
	const char *end;

	if (at(s, '{') || at(s, '['))
		return list(s);
	if (at(s, '"'))
		return string(s);
	end = scalar_end(s->p, s->end);
	if (end == NULL || (end < s->end && in_token(*end)))
		return no_value(s);
	s->p = end;
	return true;
}

/* Refuses what stands in the place of a member's name. */
static bool no_name(struct check *s)
{
	const char *wanted = "a member's name in quotes";
	char what[ESCAPED_MAX];

	if (s->p < s->end && (is_letter(*s->p) || *s->p == '_'))
		return expected(s, wanted, "write \"%s\"", token(s, what));
	return expected(s, wanted,
	    after_comma(s) && json_number_end(s->p, s->end) != NULL ?
		"several numbers stand in brackets: [1,2,3]" :
		NULL);
}

static bool member(struct check *s)
{
	struct span quoted = { .s = s->p };
	const char *start;

	if (!at(s, '"'))
		return no_name(s);
	if (!string(s))
		return false;
	quoted.end = s->p;
	blanks(s);
	if (!at(s, ':'))
		return expected(s, "':' after the member's name", NULL);
	s->p++;
	blanks(s);
	start = s->p;
	if (!value(s))
		return false;
	if (s->level == 1 && s->name != NULL && s->part.s == NULL) {
		struct span name = { s->name, s->name + strlen(s->name) };

		if (json_is_name(quoted, name, false))
			s->part = (struct span){ start, s->p };
	}
	return true;
}

/* Refuses what stands behind a value in the list that begins at open. */
static bool no_comma(struct check *s, const char *open)
{
	const char *wanted = *open == '{' ? "',' or '}'" : "',' or ']'";

	if (s->p == s->end)
		return expected(s, wanted, "the '%c' is on line %ld", *open,
		    line_of(s, open));
	return expected(s, wanted,
	    memchr("/*+", *s->p, 3) != NULL ? "JSON has no arithmetic" : NULL);
}

/* An array or object, at its opening bracket or brace. */
static bool list(struct check *s)
{
	const char *open = s->p;
	char close = *open == '{' ? '}' : ']';

	if (++s->level > LEVELS_MAX)
		return expected(s, "at most 100 levels of brackets", NULL);
	s->p++;
	blanks(s);
	for (bool empty = at(s, close); !empty; blanks(s)) {
		if (!(close == '}' ? member(s) : value(s)))
			return false;
		blanks(s);
		if (at(s, close))
			break;
		if (!at(s, ','))
			return no_comma(s, open);
		s->p++;
	}
	s->p++;
	s->level--;
	return true;
}

static bool check_text(struct check *s)
{
	const char *start;

	blanks(s);
	start = s->p;
	if (!value(s))
		return false;
	if (s->name == NULL)
		s->part = (struct span){ start, s->p };
	blanks(s);
	return s->p == s->end || expected(s, "the end of the text", NULL);
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
