#include "escape.h"

#include <stdio.h>

/* RFC 3629, section 4: the first byte gives the length and the range of the
 * second, so that overlong forms, surrogates and what lies beyond U+10FFFF
 * are out. */
int utf8_length(const char *s, const char *end)
{
	const unsigned char *u = (const unsigned char *)s;
	unsigned low = 0x80, high = 0xbf;
	int n = 1;

	if (u[0] < 0x80)
		return 1;
	if (u[0] < 0xc2 || u[0] > 0xf4)
		return 0;
	n = u[0] < 0xe0 ? 2 : u[0] < 0xf0 ? 3 : 4;
	if (end - s < n)
		return 0;
	if (u[0] == 0xe0)
		low = 0xa0;
	else if (u[0] == 0xed)
		high = 0x9f;
	else if (u[0] == 0xf0)
		low = 0x90;
	else if (u[0] == 0xf4)
		high = 0x8f;
	if (u[1] < low || u[1] > high)
		return 0;
	for (int i = 2; i < n; i++)
		if ((u[i] & 0xc0) != 0x80)
			return 0;
	return n;
}

/* The code of a control character that is n bytes long, else -1. The second
 * set of them, U+0080 to U+009F, moves a terminal's cursor as well. */
static int control(const char *s, int n)
{
	unsigned char first = (unsigned char)s[0];

	if (n == 1 && (first < 0x20 || first == 0x7f))
		return first;
	if (n == 2 && first == 0xc2 && (unsigned char)s[1] < 0xa0)
		return (unsigned char)s[1];
	return -1;
}

const char *escaped(char out[ESCAPED_MAX], const char *s, size_t n)
{
	const char *end = s + n;
	size_t at = 0;

	while (s < end) {
		int length = utf8_length(s, end), code = control(s, length);

		/* the longest piece is "\u0000", the rest "..." and NUL */
		if (at + 6 + 4 > ESCAPED_MAX) {
			at += (size_t)sprintf(out + at, "...");
			break;
		}
		if (length == 0)
			at += (size_t)sprintf(out + at, "\\x%02x",
			    (unsigned)(unsigned char)*s);
		else if (code >= 0)
			at += (size_t)sprintf(out + at, "\\u%04x",
			    (unsigned)code);
		else
			at += (size_t)sprintf(out + at, "%.*s", length, s);
		s += length > 0 ? length : 1;
	}
	out[at] = '\0';
	return out;
}
