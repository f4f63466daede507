/* SPDX-License-Identifier: MIT */
#include "text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../message/utf8.h"
#include "../number/number.h"

enum {
	LEVELS_MAX = 100,
	/* cJSON reads a number of at most so many characters. */
	CJSON_NUMBER_MAX = 63,
};

/* A function below that returns bool and is named after a part of JSON, such as
 * string, checks the part that begins at s->at. If it is right, the function moves
 * s->at to its end and returns true. Else it writes s->reason, leaves s->at at the
 * error and returns false. */

static bool is_letter(char c)
{
	return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/* Returns whether c is the next character. */
static bool at(const struct json_check *s, char c)
{
	return s->at < s->end && *s->at == c;
}

/* Moves s->at past blanks. */
static void blanks(struct json_check *s)
{
	s->at = json_space(s->at, s->end);
}

/* Appends n bytes to the copy, if there is one. */
static void copy(struct json_check *s, const char *from, size_t n)
{
	if (s->copy != NULL)
		s->copy = (char *)memcpy(s->copy, from, n) + n;
}

/* Returns whether c can be part of a word or number. */
static bool in_token(char c)
{
	return (unsigned char)c > ' ' && c != ',' &&
	    strchr(":[]{}\"'/#", c) == NULL;
}

/* Returns the end of the word or number at s->at, else of the one character there. */
static const char *token_end(const struct json_check *s)
{
	const char *p = s->at;
	unsigned code;
	int n = utf8_read(p, s->end, &code);

	while (p < s->end && in_token(*p))
		p++;
	return p > s->at ? p : p + (n > 0 ? n : 1);
}

void json_count(const char *text, const char *at, long long *line,
    size_t *column)
{
	*column += (size_t)(at - text);
	for (const char *s = text; s < at; s++)
		if (*s == '\n') {
			++*line;
			*column = (size_t)(at - s);
		}
}

/* Returns whether the last character before s->at that is not a blank is a comma. */
static bool after_comma(const struct json_check *s)
{
	const char *p = s->at;

	while (p > s->text && json_is_blank(p[-1]))
		p--;
	return p > s->text && p[-1] == ',';
}

/* Returns a hint about the character at s->at, which is wrong there; or NULL. */
static const char *hint_of(const struct json_check *s)
{
	const char *p = s->at;
	char next = s->end - p > 1 ? p[1] : '\0';
	unsigned code;

	if (*p == '#' || (*p == '/' && (next == '/' || next == '*')))
		return "comments are not JSON; use a member \"_comment\"";
	if (*p == '\'')
		return "JSON has \"double quotes\" alone";
	if (*p == '\0' || utf8_read(p, s->end, &code) == 0)
		return "JSON is UTF-8 text";
	if ((*p == ']' || *p == '}') && after_comma(s))
		return "remove the comma before it";
	return NULL;
}

/* Returns false. Writes as the reason what is wanted at s->at, the text that is there,
 * and hint_of or else the hint, unless both are NULL. */
static bool expected(struct json_check *s, const char *wanted, const char *hint)
{
	const bool ends = s->at == s->end;
	const char *other = ends ? NULL : hint_of(s);
	char what[ESCAPED_MAX] = "";

	if (other != NULL)
		hint = other;
	if (!ends)
		escaped(what, s->at, (size_t)(token_end(s) - s->at));
	snprintf(s->reason, sizeof s->reason, "expected %s,%s%s%s%s%s", wanted,
	    ends ? " but the text ends" : " not '", what, ends ? "" : "'",
	    hint != NULL ? "; " : "", hint != NULL ? hint : "");
	return false;
}

/* Checks an escape, from its backslash on. json_unescape makes U+FFFD of half of a
 * surrogate pair, \ud800 to \udfff: such an escape is wrong in a document. */
static bool escape(struct json_check *s)
{
	const char *p = s->at, *next = p;
	bool is_u = s->end - p > 1 && p[1] == 'u';
	char c[4];
	int n;

	if (s->end - p > 1 && memchr("\"\\/bfnrtu", p[1], 9) != NULL)
		next = json_unescape(p, s->end, c, &n);
	if (next - p < (is_u ? 6 : 2) ||
	    (is_u && s->kind == JSON_DOCUMENT &&
		(c[0] == '\0' || (c[0] == '\xef' && (p[2] | 0x20) == 'd'))))
		return expected(s, "an escape for a character",
		    "a backslash itself is \\\\");
	s->at = next;
	return true;
}

/* Checks a character of a string. */
static bool character(struct json_check *s)
{
	unsigned code;
	int n = s->kind == JSON_DOCUMENT ? utf8_read(s->at, s->end, &code) : 1;

	if (*s->at == '\\')
		return escape(s);
	if (n == 0 || (unsigned char)*s->at < ' ')
		return expected(s, "text or '\"' in a string",
		    "write a control character as this escape");
	s->at += n;
	return true;
}

/* Checks a string, from its first quotation mark on. */
static bool string(struct json_check *s)
{
	const char *start = s->at++;

	while (!at(s, '"')) {
		if (s->at == s->end)
			return expected(s, "text or '\"' in a string", NULL);
		if (!character(s))
			return false;
	}
	s->at++;
	copy(s, start, (size_t)(s->at - start));
	return true;
}

const char *json_scalar_end(const char *p, const char *end)
{
	static const char *const words[] = { "true", "false", "null" };

	for (int i = 0; i < 3 && p < end && is_letter(*p); i++) {
		size_t n = strlen(words[i]);

		if ((size_t)(end - p) >= n && memcmp(p, words[i], n) == 0)
			return p + n;
	}
	return json_number(p, end, NULL);
}

/* Copies the number from s->at to end. A number that is too long for cJSON is copied as
 * the shortest text of its double. */
static void copy_number(struct json_check *s, const char *end)
{
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	char text[NUMBER_MAX];
	double v;

	if (end - s->at <= CJSON_NUMBER_MAX) {
		copy(s, s->at, (size_t)(end - s->at));
		return;
	}
	number_read(s->at, end, &v);
	if (isfinite(v))
		copy(s, text, (size_t)(number_write(text, v, shortest) - text));
	else
		copy(s, "1e999", 5);
}

/* Checks a number, true, false or null. */
static bool scalar(struct json_check *s)
{
	const char *end = json_scalar_end(s->at, s->end), *hint = NULL;

	if (end == NULL || (end < s->end && in_token(*end))) {
		if (s->at < s->end && strchr("+-.0123456789", *s->at))
			hint = "a number is like -1.5e-3";
		else if (s->at < s->end && is_letter(*s->at))
			hint = "a word is true, false, null or \"text\" in "
			       "quotes";
		return expected(s, "a value", hint);
	}
	if (s->copy != NULL)
		copy_number(s, end);
	s->at = end;
	return true;
}

static bool list(struct json_check *s, const char *path);

/* Checks a value. path is the rest of the pointer after the tokens that led to the
 * value; NULL if the pointer leads elsewhere. */
static bool value(struct json_check *s, const char *path)
{
	const char *start = s->at;
	bool good;

	if (path != NULL)
		s->found.s = start;
	if (at(s, '{') || at(s, '['))
		good = list(s, path);
	else
		good = at(s, '"') ? string(s) : scalar(s);
	if (s->found.s == start)
		s->found.end = s->at;
	return good;
}

/* Returns the rest of the path after its first token if the token is the name, or,
 * where name.s is NULL, the index; else NULL. */
static const char *path_after(const char *path, struct span name, long index)
{
	struct span token = { path, path };

	if (path == NULL || *path == '\0')
		return NULL;
	token.end += strcspn(++token.s, "/") + 1;
	return (name.s != NULL ? json_is_name(name, token, true) :
				 strtol(token.s, NULL, 10) == index) ?
	    token.end :
	    NULL;
}

static bool member(struct json_check *s, const char *path)
{
	struct span name = { .s = s->at };

	if (!at(s, '"'))
		return expected(s, "a member's name in \"double quotes\"",
		    after_comma(s) && json_number(s->at, s->end, NULL) != NULL ?
			"several numbers stand in brackets: [1,2,3]" :
			NULL);
	if (!string(s))
		return false;
	name.end = s->at;
	blanks(s);
	if (!at(s, ':'))
		return expected(s, "':' after the member's name", NULL);
	copy(s, s->at++, 1);
	blanks(s);
	return value(s, path_after(path, name, 0));
}

/* Refuses the text after a value in the array or object that begins at open. Returns
 * false. */
static bool no_comma(struct json_check *s, const char *open)
{
	const char *wanted = *open == '{' ? "',' or '}'" : "',' or ']'";
	long long line = s->line;
	size_t column = 0;
	char hint[60];

	if (s->at < s->end)
		return expected(s, wanted,
		    strchr("/*+", *s->at) ? "JSON has no arithmetic" : NULL);
	json_count(s->text, open, &line, &column);
	snprintf(hint, sizeof hint, "the '%c' is on line %lld", *open, line);
	return expected(s, wanted, hint);
}

/* Checks an array or object, from its opening bracket on. */
static bool list(struct json_check *s, const char *path)
{
	const char *open = s->at;
	const bool object = *open == '{';
	const char close = object ? '}' : ']';

	if (++s->level > LEVELS_MAX)
		return expected(s, "at most 100 levels of brackets", NULL);
	copy(s, s->at++, 1);
	blanks(s);

	/* s->copy is NULL during a value that is not copied; nor is its comma copied */
	char *const first = s->copy;
	const bool skips = path != NULL && *path == '\0' && !object;
	long index = 0;

	for (bool empty = at(s, close); !empty; blanks(s)) {
		char *before = s->copy;

		if (skips || (object && s->end - s->at > 1 && s->at[1] == '_'))
			s->copy = NULL;
		else if (before != first)
			copy(s, ",", 1);
		if (!(object ?
			    member(s, path) :
			    value(s,
				path_after(path, (struct span){ 0 }, index++))))
			return false;
		if (s->copy == NULL)
			s->copy = before;
		blanks(s);
		if (at(s, close))
			break;
		if (!at(s, ','))
			return no_comma(s, open);
		s->at++;
	}
	copy(s, s->at++, 1);
	s->level--;
	return true;
}

bool json_check(struct json_check *s)
{
	s->at = s->text;
	blanks(s);
	if (!value(s, s->pointer))
		return false;
	blanks(s);
	return s->at == s->end || expected(s, "the end of the text", NULL);
}
