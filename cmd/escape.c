#include "escape.h"

#include <stdio.h>

#include "utf8.h"

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
