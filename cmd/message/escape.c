/* SPDX-License-Identifier: MIT */
#include "escape.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "utf8.h"

/* The longest piece is "\u0000". */
enum { PIECE_MAX = 6 };

/* The code of the character that is n bytes long (RFC 3629, section 3). */
static unsigned code_of(const char *s, int n)
{
	unsigned code = (unsigned char)s[0];

	if (n == 1)
		return code;
	code &= 0xffu >> (n + 1);
	for (int i = 1; i < n; i++)
		code = code << 6 | ((unsigned char)s[i] & 0x3f);
	return code;
}

/* Whether a character looks like a blank or nothing: no-break spaces, the soft
 * hyphen, joiners of zero width, invisible operators, and the byte order mark. */
static bool is_unseen(unsigned code)
{
	return code == 0xa0 || code == 0xad ||
	    (code >= 0x200b && code <= 0x200d) ||
	    (code >= 0x2060 && code <= 0x2064) || code == 0xfeff;
}

/* Whether a character is of the two sets of control characters, ends a line, or
 * is one of the marks, embeddings, overrides and isolates of UAX 9, tables 1 to
 * 4. */
static bool is_control(unsigned code)
{
	return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x061c ||
	    code == 0x200e || code == 0x200f ||
	    (code >= 0x2028 && code <= 0x202e) ||
	    (code >= 0x2066 && code <= 0x2069);
}

unsigned escape_unseen(const char *s)
{
	const char *end = s + strlen(s);
	unsigned code;

	while (s < end) {
		int n = utf8_length(s, end);

		if (sscanf(s, "\\u%4x", &code) < 1)
			code = n > 0 ? code_of(s, n) : 0;
		if (is_unseen(code))
			return code;
		s += n > 0 ? n : 1;
	}
	return 0;
}

/* Writes a piece for the character at *s, and goes past it. Returns its length. */
static size_t piece(char out[PIECE_MAX + 1], const char **s, const char *end,
    bool json)
{
	int n = utf8_length(*s, end);
	const char *c = *s;

	*s += n > 0 ? n : 1;
	if (n == 0 && json)
		return (size_t)sprintf(out, "\\ufffd");
	if (n == 0)
		return (
		    size_t)sprintf(out, "\\x%02x", (unsigned)(unsigned char)*c);
	unsigned code = code_of(c, n);

	if (is_control(code) || is_unseen(code))
		return (size_t)sprintf(out, "\\u%04x", code);
	if (json && (*c == '"' || *c == '\\'))
		return (size_t)sprintf(out, "\\%c", *c);
	memcpy(out, c, (size_t)n);
	return (size_t)n;
}

const char *escaped(char out[ESCAPED_MAX], const char *s, size_t n)
{
	const char *end = s + n;
	size_t at = 0;

	while (s < end) {
		/* a piece, the rest "..." and NUL */
		if (at + PIECE_MAX + 4 > ESCAPED_MAX) {
			at += (size_t)sprintf(out + at, "...");
			break;
		}
		at += piece(out + at, &s, end, false);
	}
	out[at] = '\0';
	return out;
}

/* As many pieces as there is room for with a NUL. */
static size_t pieces(char *out, size_t room, const char *s, const char *end,
    bool json)
{
	char one[PIECE_MAX + 1];
	size_t at = 0;

	while (s < end) {
		size_t n = piece(one, &s, end, json);

		if (at + n >= room)
			break;
		memcpy(out + at, one, n);
		at += n;
	}
	out[at] = '\0';
	return at;
}

size_t escape_text(char *out, size_t room, const char *s, size_t n)
{
	return pieces(out, room, s, s + n, false);
}

size_t escape_json(char *out, size_t room, const char *s, size_t n)
{
	return pieces(out, room, s, s + n, true);
}
