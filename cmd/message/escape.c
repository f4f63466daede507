/* SPDX-License-Identifier: MIT */
#include "escape.h"

#include <stdio.h>
#include <string.h>

#include "utf8.h"

/* Returns whether a character is a control, ends a line, controls the direction of
 * writing (UAX 9), or looks like a blank or like nothing: no-break spaces, the soft
 * hyphen, joiners of zero width, invisible operators, the byte order mark. */
static bool is_unseen(unsigned code)
{
	return code < 0x20 || (code >= 0x7f && code <= 0xa0) || code == 0xad ||
	    code == 0x061c || (code >= 0x200b && code <= 0x200f) ||
	    (code >= 0x2028 && code <= 0x202e) || (code >= 0x2060 && code <= 0x2069) ||
	    code == 0xfeff;
}

/* Moves *s past a character, which it writes. Returns the number of bytes written. */
static size_t escape_one(char out[JSON_ESCAPE_MAX + 1], const char **s, const char *end,
    bool json)
{
	unsigned code;
	int n = utf8_read(*s, end, &code);
	const char *c = *s;

	*s += n > 0 ? n : 1;
	if (n == 0 && !json)
		return (size_t)sprintf(out, "\\x%02x", (unsigned char)*c);
	if (n == 0 || is_unseen(code))
		return (size_t)sprintf(out, "\\u%04x", n > 0 ? code : 0xfffd);
	if (json && (*c == '"' || *c == '\\'))
		return (size_t)sprintf(out, "\\%c", *c);
	memcpy(out, c, (size_t)n);
	return (size_t)n;
}

size_t escape_copy(char *out, size_t room, const char *s, size_t n, bool json,
    const char *ellipsis)
{
	const char *end = s + n;
	char one[JSON_ESCAPE_MAX + 1];
	size_t at = 0;

	while (s < end) {
		size_t length = escape_one(one, &s, end, json);

		if (at + length + strlen(ellipsis) >= room) {
			at += (size_t)sprintf(out + at, "%s", ellipsis);
			break;
		}
		memcpy(out + at, one, length);
		at += length;
	}
	out[at] = '\0';
	return at;
}

const char *escape_short(char out[ESCAPED_MAX], const char *s, size_t n)
{
	escape_copy(out, ESCAPED_MAX, s, n, false, "...");
	return out;
}
