/* SPDX-License-Identifier: MIT */
#include "check.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../message/utf8.h"
#include "../message/escape.h"
#include "../message/words.h"
#include "text.h"

/* Each function check_PART below checks a part of JSON that begins at s->at. If the
 * part is valid, the function moves s->at to its end and returns true. If not, the
 * function moves s->at to the error, writes s->reason and returns false. */

static bool next_is(const struct json_check *s, char c)
{
	return s->at < s->end && *s->at == c;
}

static void skip_space(struct json_check *s)
{
	s->at = json_skip_blanks(s->at, s->end);
}

static bool in_token(char c)
{
	return (unsigned char)c > ' ' && c != ',' && strchr(":[]{}\"'/#", c) == NULL;
}

/* Returns the end of the word or number at s->at, or else of one character there. */
static const char *token_end(const struct json_check *s)
{
	const char *p = s->at;
	unsigned code;
	int n = utf8_read(p, s->end, &code);

	while (p < s->end && in_token(*p))
		p++;
	return p > s->at ? p : p + (n > 0 ? n : 1);
}

void json_count_lines(const char *text, const char *at, long long *line, size_t *column)
{
	*column += (size_t)(at - text);
	for (const char *s = text; s < at; s++)
		if (*s == '\n') {
			++*line;
			*column = (size_t)(at - s);
		}
}

static bool after_comma(const struct json_check *s)
{
	const char *p = s->at;

	while (p > s->text && json_is_blank(p[-1]))
		p--;
	return p > s->text && p[-1] == ',';
}

/* Returns a hint about the wrong character at s->at, or `fallback` if none is known. */
static const char *hint_of(const struct json_check *s, const char *fallback)
{
	const char *p = s->at, *end = token_end(s);
	char next = s->end - p > 1 ? p[1] : '\0';
	unsigned code;

	if (*p == '#' || (*p == '/' && (next == '/' || next == '*')))
		return "comments are not JSON; use a member \"_comment\"";
	if (*p == '\'')
		return "JSON has \"double quotes\" alone";
	if (s->level == 0 &&
	    (*p == '%' || *p == '<' ||
		(isalpha((unsigned char)*p) && end < s->end && *end == ':')))
		return "YAML and XML are to be converted to JSON";
	if (*p == '\0' || utf8_read(p, s->end, &code) == 0)
		return "JSON is UTF-8 text";
	if ((*p == ']' || *p == '}') && after_comma(s))
		return "remove the comma before it";
	return fallback;
}

/* Returns false. Writes to s->reason that `wanted` was expected, and what is at s->at.
 * Adds the hint of hint_of or, if there is none, `hint`, which may be NULL. */
static bool refuse(struct json_check *s, const char *wanted, const char *hint)
{
	const bool ends = s->at == s->end;
	char what[ESCAPED_MAX] = "";

	if (!ends) {
		escape_short(what, s->at, (size_t)(token_end(s) - s->at));
		const char *said = word_hint(what, WORD_JSON, ':');

		hint = said != NULL ? said + 2 : hint_of(s, hint);
	}
	snprintf(s->reason, sizeof s->reason, "expected %s,%s%s%s%s%s", wanted,
	    ends ? " but the text ends" : " not '", what, ends ? "" : "'",
	    hint != NULL ? "; " : "", hint != NULL ? hint : "");
	return false;
}

/* Checks an escape in a string. In a document, refuses \u0000, and half of a surrogate
 * pair (\ud800 to \udfff) alone, for which json_unescape writes U+FFFD. */
static bool check_escape(struct json_check *s)
{
	const char *p = s->at, *next = p;
	bool is_u = s->end - p > 1 && p[1] == 'u';
	char c[4];
	int n;

	if (s->end - p > 1 && memchr("\"\\/bfnrtu", p[1], 9) != NULL)
		next = json_unescape(p, s->end, c, &n);
	if (next - p < (is_u ? 6 : 2) ||
	    (is_u && !s->is_line &&
		(c[0] == '\0' || (c[0] == '\xef' && (p[2] | 0x20) == 'd'))))
		return refuse(s, "an escape for a character",
		    "a backslash itself is \\\\");
	s->at = next;
	return true;
}

static bool check_string(struct json_check *s)
{
	static const char wanted[] = "text or '\"' in a string";
	unsigned code;
	int n;

	for (s->at++; !next_is(s, '"'); s->at += n) {
		if (s->at == s->end)
			return refuse(s, wanted, NULL);
		n = s->is_line ? 1 : utf8_read(s->at, s->end, &code);
		if (n == 0 || (unsigned char)*s->at < ' ')
			return refuse(s, wanted,
			    "write a control character as this escape");
		if (*s->at == '\\') {
			if (!check_escape(s))
				return false;
			n = 0;
		}
	}
	s->at++;
	return true;
}

const char *json_scalar_end(const char *p, const char *end)
{
	static const char *const words[] = { "true", "false", "null" };

	for (int i = 0; i < 3 && p < end && '9' < *p; i++) {
		size_t n = strlen(words[i]);

		if ((size_t)(end - p) >= n && memcmp(p, words[i], n) == 0)
			return p + n;
	}
	return json_number(p, end, NULL);
}

static bool check_scalar(struct json_check *s)
{
	const char *end = json_scalar_end(s->at, s->end);

	if (end == NULL || (end < s->end && in_token(*end)))
		return refuse(s, "a value",
		    s->at < s->end && in_token(*s->at) ?
			"a value is like -1.5e-3, true, null or \"text\"" :
			NULL);
	s->needs_edit |= end - s->at > CJSON_NUMBER_MAX;
	s->at = end;
	return true;
}

static bool check_brackets(struct json_check *s, const char *path);

/* Checks a value. `path` is the part of s->pointer after the tokens that led to the
 * value, or NULL if s->pointer leads elsewhere. */
static bool check_value(struct json_check *s, const char *path)
{
	const char *start = s->at;
	bool good;

	if (path != NULL)
		s->found.s = start;
	if (next_is(s, '{') || next_is(s, '['))
		good = check_brackets(s, path);
	else
		good = next_is(s, '"') ? check_string(s) : check_scalar(s);
	if (s->found.s == start)
		s->found.end = s->at;
	return good;
}

/* Returns `path` without its first token if this token is `name` or, if name.s is NULL,
 * `index`. Returns NULL if the first token differs or `path` has no token. */
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

static bool check_member(struct json_check *s, const char *path)
{
	struct span name = { .s = s->at };

	if (!next_is(s, '"'))
		return refuse(s, "a member's name in \"double quotes\"",
		    after_comma(s) && json_number(s->at, s->end, NULL) != NULL ?
			"several numbers stand in brackets: [1,2,3]" :
			NULL);
	if (!check_string(s))
		return false;
	name.end = s->at;
	s->needs_edit |= name.s[1] == '_';
	skip_space(s);
	if (!next_is(s, ':'))
		return refuse(s, "':' after the member's name", NULL);
	s->at++;
	skip_space(s);
	return check_value(s, path_after(path, name, 0));
}

/* Returns false. Refuses what follows a value in the brackets that begin at `open`. */
static bool refuse_no_comma(struct json_check *s, const char *open)
{
	const char *wanted = *open == '{' ? "',' or '}'" : "',' or ']'";
	long long line = s->line;
	size_t column = 0;
	char hint[60];

	if (s->at < s->end)
		return refuse(s, wanted,
		    strchr("/*+", *s->at) ? "JSON has no arithmetic" : NULL);
	json_count_lines(s->text, open, &line, &column);
	snprintf(hint, sizeof hint, "the '%c' is on line %lld", *open, line);
	return refuse(s, wanted, hint);
}

static bool check_brackets(struct json_check *s, const char *path)
{
	const char *open = s->at;
	const bool object = *open == '{';
	const char close = object ? '}' : ']';

	if (++s->level > JSON_LEVELS_MAX)
		return refuse(s, "at most 200 levels of brackets", NULL);
	s->at++;
	skip_space(s);

	long index = 0;

	for (bool empty = next_is(s, close); !empty; skip_space(s)) {
		if (!(object ? check_member(s, path) :
			       check_value(s,
				   path_after(path, (struct span){ 0 }, index++))))
			return false;
		skip_space(s);
		if (next_is(s, close))
			break;
		if (!next_is(s, ','))
			return refuse_no_comma(s, open);
		s->at++;
	}
	s->at++;
	s->level--;
	return true;
}

bool json_check(struct json_check *s)
{
	s->at = s->text;
	skip_space(s);
	if (!check_value(s, s->pointer))
		return false;
	skip_space(s);
	return s->at == s->end ||
	    refuse(s, "the end of the text",
		s->is_line        ? NULL :
		    *s->at == '{' ? "--scenes reads several scenes" :
		    *s->at == ',' && *s->text == '[' ?
				    "several points are one list: [[0,0,0], [1,1,1]]" :
				    NULL);
}
