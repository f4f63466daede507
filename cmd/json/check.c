/* SPDX-License-Identifier: MIT */
#include "check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../message/escape.h"
#include "../message/message.h"
#include "../message/utf8.h"
#include "../number/number.h"
#include "text.h"

enum { LEVELS_MAX = 100 };

static bool is_letter(char c)
{
	return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static bool is_json_blank(char c)
{
	return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

static bool at(const struct json_check *s, char c)
{
	return s->at < s->end && *s->at == c;
}

static void check_blanks(struct json_check *s)
{
	const char *p = s->at;

	while (p < s->end && is_json_blank(*p))
		p++;
	s->at = p;
}

/* Returns whether c can be part of a word or number. */
static bool in_token(char c)
{
	return (unsigned char)c > ' ' && strchr(",:[]{}\"'/#", c) == NULL;
}

/* Returns the end of the word, number or other character at s->at. */
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

/* Returns whether the last character before s->at that is not blank is a comma. */
static bool after_comma(const struct json_check *s)
{
	const char *p = s->at;

	while (p > s->text && is_json_blank(p[-1]))
		p--;
	return p > s->text && p[-1] == ',';
}

/* Returns what to do with the character at s->at, which JSON does not have or not
 * there; or NULL. */
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

/* Sets the reason: JSON wants this at s->at, and the text has another character or ends.
 * A hint that is not NULL follows. Returns false. */
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

/* Each function check_x checks the x at s->at, sets s->at to the x's end and returns true;
 * or sets s->at to the first wrong character and the reason, and returns false. */

/* json_unescape writes half of a surrogate pair, \ud800 to \udfff, as U+FFFD, which
 * begins with \xef. */
static bool check_escape(struct json_check *s)
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

static bool check_character(struct json_check *s)
{
	unsigned code;
	int n = s->kind == JSON_DOCUMENT ? utf8_read(s->at, s->end, &code) : 1;

	if (*s->at == '\\')
		return check_escape(s);
	if (n == 0 || (unsigned char)*s->at < ' ')
		return expected(s, "text or '\"' in a string",
		    "write a control character as this escape");
	s->at += n;
	return true;
}

/* Returns whether c is a character of a string, whatever stands around it. */
static bool is_simple(char c)
{
	return c >= ' ' && c != '"' && c != '\\' && (unsigned char)c < 0x80;
}

static bool check_string(struct json_check *s)
{
	s->at++;
	for (;;) {
		while (s->at < s->end && is_simple(*s->at))
			s->at++;
		if (at(s, '"'))
			break;
		if (s->at == s->end)
			return expected(s, "text or '\"' in a string", NULL);
		if (!check_character(s))
			return false;
	}
	s->at++;
	return true;
}

/* Returns the end of true, false, null or the number at p; NULL if there is none. */
static const char *scalar_end(const char *p, const char *end)
{
	static const char *const words[] = { "true", "false", "null" };

	for (int i = 0; i < 3 && p < end && is_letter(*p); i++) {
		size_t n = strlen(words[i]);

		if ((size_t)(end - p) >= n && memcmp(p, words[i], n) == 0)
			return p + n;
	}
	return json_number_end(p, end);
}

/* A scalar is true, false, null or a number. */
static bool check_scalar(struct json_check *s)
{
	const char *end = scalar_end(s->at, s->end), *hint = NULL;

	if (end == NULL || (end < s->end && in_token(*end))) {
		if (s->at < s->end && strchr("+-.0123456789", *s->at))
			hint = "a number is like -1.5e-3";
		else if (s->at < s->end && is_letter(*s->at))
			hint = "a word is true, false, null or \"text\" in "
			       "quotes";
		return expected(s, "a value", hint);
	}
	s->at = end;
	return true;
}

/* Adds a value of zeros, and returns its index. */
static size_t add_value(struct json_values *made)
{
	if (made->n == made->room) {
		made->room = 2 * made->room + 64;
		made->value = need(made->value,
		    made->room * sizeof *made->value);
	}
	made->value[made->n] = (struct json_value){ 0 };
	return made->n++;
}

/* Adds the characters that a string of JSON stands for, and returns them. They take less
 * room than the string, as its quotes have two bytes and the NUL one. */
static const char *add_string(struct json_values *made, const char *s,
    const char *end)
{
	char *const start = made->end;
	int n;

	for (s++; s < end - 1; made->end += n)
		if (*s == '\\') {
			s = json_unescape(s, end, made->end, &n);
		} else {
			*made->end = *s++;
			n = 1;
		}
	*made->end++ = '\0';
	return start;
}

/* Completes value i, which was checked from start to s->at. */
static void finish_value(const struct json_check *s, size_t i,
    const char *start)
{
	struct json_values *made = s->made;
	struct json_value *v = &made->value[i];
	static const char types[] = "ftn-\"[{"; /* in the order of json_type */
	const char *type = strchr(types, *start);

	v->type = type != NULL ? (enum json_type)(type - types) : JSON_NUMBER;
	v->size = made->n - i;
	if (v->type == JSON_NUMBER)
		number_read(start, s->at, &v->number);
	if (v->type == JSON_STRING)
		v->string = add_string(made, start, s->at);
}

static bool check_list(struct json_check *s, const char *pointer);

/* pointer is the rest of s->pointer that leads on from this value; NULL if the value is
 * not on its path. */
static bool check_value(struct json_check *s, const char *pointer)
{
	const char *start = s->at;
	size_t i = s->made != NULL ? add_value(s->made) : 0;
	bool good;

	if (pointer != NULL)
		s->found.s = start;
	if (at(s, '{') || at(s, '['))
		good = check_list(s, pointer);
	else
		good = at(s, '"') ? check_string(s) : check_scalar(s);
	if (s->found.s == start)
		s->found.end = s->at;
	if (good && s->made != NULL)
		finish_value(s, i, start);
	return good;
}

/* Returns the rest of the pointer after its first token, if that is the name, or where
 * name.s is NULL the index; else NULL. */
static const char *pointer_next(const char *pointer, struct span name,
    long index)
{
	struct span token = { pointer, pointer };

	if (pointer == NULL || *pointer == '\0')
		return NULL;
	token.end += strcspn(++token.s, "/") + 1;
	return (name.s != NULL ? json_is_name(name, token, true) :
				 strtol(token.s, NULL, 10) == index) ?
	    token.end :
	    NULL;
}

static bool check_member(struct json_check *s, const char *pointer)
{
	struct span name = { .s = s->at };

	if (!at(s, '"'))
		return expected(s, "a member's name in \"double quotes\"",
		    after_comma(s) && json_number_end(s->at, s->end) != NULL ?
			"several numbers stand in brackets: [1,2,3]" :
			NULL);
	if (!check_string(s))
		return false;
	name.end = s->at;
	check_blanks(s);
	if (!at(s, ':'))
		return expected(s, "':' after the member's name", NULL);
	s->at++;
	check_blanks(s);
	size_t i = s->made != NULL ? s->made->n : 0;

	if (!check_value(s, pointer_next(pointer, name, 0)))
		return false;
	if (s->made != NULL)
		s->made->value[i].name = add_string(s->made, name.s, name.end);
	return true;
}

/* Sets the reason where no comma follows a value of the list that begins at open. Returns
 * false. */
static bool expected_comma(struct json_check *s, const char *open)
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

/* A list is an array or object. */
static bool check_list(struct json_check *s, const char *pointer)
{
	const char *open = s->at;
	const bool object = *open == '{';
	const char close = object ? '}' : ']';
	struct json_values *const made = s->made;
	bool found = pointer != NULL && *pointer == '\0' && !object;
	long index = 0;

	if (++s->level > LEVELS_MAX)
		return expected(s, "at most 100 levels of brackets", NULL);
	s->at++;
	check_blanks(s);
	for (bool empty = at(s, close); !empty; check_blanks(s)) {
		bool hidden = object && s->end - s->at > 1 && s->at[1] == '_';

		s->made = found || hidden ? NULL : made;
		if (!(object ? check_member(s, pointer) :
			       check_value(s,
				   pointer_next(pointer, (struct span){ 0 },
				       index++))))
			return false;
		check_blanks(s);
		if (at(s, close))
			break;
		if (!at(s, ','))
			return expected_comma(s, open);
		s->at++;
	}
	s->made = made;
	s->at++;
	s->level--;
	return true;
}

bool json_check(struct json_check *s)
{
	if (s->made != NULL) {
		s->made->strings = need(s->made->strings,
		    (size_t)(s->end - s->text));
		s->made->end = s->made->strings;
		s->made->n = 0;
	}
	s->at = s->text;
	check_blanks(s);
	if (!check_value(s, s->pointer))
		return false;
	check_blanks(s);
	return s->at == s->end || expected(s, "the end of the text", NULL);
}
