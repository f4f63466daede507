/* SPDX-License-Identifier: MIT */
#include "check.h"

#include <string.h>

#include "../json/text.h"
#include "../json/value.h"

/* Each function check_PART below checks a part of JSON that begins at c->at. If the
 * part is valid, the function moves c->at to its end and returns true. If not, it moves
 * c->at to the error and returns false. */

static bool next_is(const struct json_check *c, char byte)
{
	return c->at < c->end && *c->at == byte;
}

static void pass_blanks(struct json_check *c)
{
	c->at = json_skip_blanks(c->at, c->end);
}

static bool want(struct json_check *c, const char *wanted)
{
	c->wanted = wanted;
	return false;
}

static bool is_escape(const char *s, const char *end)
{
	unsigned code;

	return end - s > 1 && memchr("\"\\/bfnrtu", s[1], 9) != NULL &&
	    (s[1] != 'u' || json_hex4(s + 2, end, &code) == s + 6);
}

static bool check_string(struct json_check *c)
{
	for (c->at++; !next_is(c, '"'); c->at++) {
		if (c->at == c->end || (unsigned char)*c->at < ' ')
			return want(c, "text or '\"' in a string");
		if (*c->at == '\\' && !is_escape(c->at, c->end))
			return want(c, "an escape for a character");
		c->at += *c->at == '\\';
	}
	c->at++;
	return true;
}

static bool check_brackets(struct json_check *);

static bool check_value(struct json_check *c)
{
	if (next_is(c, '{') || next_is(c, '['))
		return check_brackets(c);
	if (next_is(c, '"'))
		return check_string(c);
	const char *const end = json_scalar_end(c->at, c->end);

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
	pass_blanks(c);
	if (!next_is(c, ':'))
		return want(c, "':' after the member's name");
	c->at++;
	pass_blanks(c);
	return check_value(c);
}

static bool check_brackets(struct json_check *c)
{
	const bool object = *c->at == '{';
	const char close = object ? '}' : ']';

	if (++c->level > JSON_LEVELS_MAX)
		return want(c, "at most 200 levels of brackets");
	c->at++;
	pass_blanks(c);
	for (bool empty = next_is(c, close); !empty; pass_blanks(c)) {
		if (!(object ? check_member(c) : check_value(c)))
			return false;
		pass_blanks(c);
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
	pass_blanks(c);
	if (!check_value(c))
		return false;
	pass_blanks(c);
	return c->at == c->end || want(c, "the end of the line");
}
