/* SPDX-License-Identifier: MIT */
#include "check.h"

#include <string.h>

#include "../json/text.h"

/* Each function check_PART below checks a part of JSON that begins at c->at. If the
 * part is valid, the function moves c->at to its end and returns true. If not, it moves
 * c->at to the error and returns false. */

static bool next_is(const struct json_check *c, char byte)
{
	return c->at < c->end && *c->at == byte;
}

static void skip_space(struct json_check *c)
{
	c->at = json_skip_blanks(c->at, c->end);
}

static bool want(struct json_check *c, const char *wanted)
{
	c->wanted = wanted;
	return false;
}

static bool check_string(struct json_check *c)
{
	char character[4];
	int n;

	for (c->at++; !next_is(c, '"');) {
		const char *s = c->at, *next = s + 1;

		if (s == c->end || (unsigned char)*s < ' ')
			return want(c, "text or '\"' in a string");
		if (*s == '\\') {
			if (c->end - s < 2 || memchr("\"\\/bfnrtu", s[1], 9) == NULL)
				return want(c, "an escape for a character");
			next = json_unescape(s, c->end, character, &n);
			if (next - s < (s[1] == 'u' ? 6 : 2))
				return want(c, "an escape for a character");
		}
		c->at = next;
	}
	c->at++;
	return true;
}

static bool check_brackets(struct json_check *);

static bool check_value(struct json_check *c)
{
	const char *end;

	if (next_is(c, '{') || next_is(c, '['))
		return check_brackets(c);
	if (next_is(c, '"'))
		return check_string(c);
	end = json_scalar_end(c->at, c->end);
	if (end == NULL ||
	    (end < c->end && (unsigned char)*end > ' ' &&
		strchr(",:]}[{\"", *end) == NULL))
		return want(c, "a value");
	c->at = end;
	return true;
}

static bool check_member(struct json_check *c)
{
	if (!next_is(c, '"'))
		return want(c, "a member's name in \"double quotes\"");
	if (!check_string(c))
		return false;
	skip_space(c);
	if (!next_is(c, ':'))
		return want(c, "':' after the member's name");
	c->at++;
	skip_space(c);
	return check_value(c);
}

static bool check_brackets(struct json_check *c)
{
	const bool object = *c->at == '{';
	const char close = object ? '}' : ']';

	if (++c->level > JSON_LEVELS_MAX)
		return want(c, "at most 200 levels of brackets");
	c->at++;
	skip_space(c);
	for (bool empty = next_is(c, close); !empty; skip_space(c)) {
		if (!(object ? check_member(c) : check_value(c)))
			return false;
		skip_space(c);
		if (next_is(c, close))
			break;
		if (!next_is(c, ','))
			return want(c, object ? "',' or '}'" : "',' or ']'");
		c->at++;
	}
	c->at++;
	c->level--;
	return true;
}

bool json_check(struct json_check *c)
{
	c->at = c->s;
	skip_space(c);
	if (!check_value(c))
		return false;
	skip_space(c);
	return c->at == c->end || want(c, "the end of the line");
}
