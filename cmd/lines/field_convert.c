/* SPDX-License-Identifier: MIT */
#include "field_convert.h"

#include <math.h>
#include <string.h>

#include "../json/text.h"
#include "../number/number.h"
#include "../message/utf8.h"

/* Goes through a field's characters, without the quotes and escapes of its
 * format. */
struct decoder {
	enum format format; /* FORMAT_TEXT where the field has no quotes */
	const char *s, *end;
	char character[4]; /* the last one, in UTF-8 */
};

static bool is_quoted(struct dialect d, struct span f)
{
	return d.format != FORMAT_TEXT && f.end - f.s >= 2 && *f.s == '"' &&
	    f.end[-1] == '"';
}

/* Takes the next character and returns its length in bytes. Where bytes of UTF-8
 * alone are wanted, U+FFFD stands for one that isn't. */
static int decode(struct decoder *d, bool utf8)
{
	int n;

	if (d->format == FORMAT_JSON && *d->s == '\\') {
		d->s = json_unescape(d->s, d->end, d->character, &n);
		return n;
	}
	n = utf8 ? utf8_length(d->s, d->end) : 1;
	if (n == 0) {
		d->s++;
		return utf8_write(0xfffd, d->character);
	}
	if (n > 1) {
		memcpy(d->character, d->s, (size_t)n);
		d->s += n;
		return n;
	}
	d->character[0] = *d->s;
	d->s += d->format == FORMAT_CSV && *d->s == '"' && d->end - d->s > 1 &&
		d->s[1] == '"' ?
	    2 :
	    1;
	return 1;
}

static char *put_control(enum format out, char c, char *at)
{
	static const char from[] = "\b\f\n\r\t", to[] = "bfnrt";
	static const char hex[] = "0123456789abcdef";
	const char *simple = memchr(from, c, 5);

	if (out != FORMAT_JSON) {
		*at++ = out == FORMAT_CSV && c == '\t' ? c : ' ';
		return at;
	}
	*at++ = '\\';
	if (simple != NULL) {
		*at++ = to[simple - from];
		return at;
	}
	memcpy(at, "u00", 3);
	at[3] = hex[c >> 4];
	at[4] = hex[c & 15];
	return at + 5;
}

/* A control character would break the line of text or csv: a blank stands for
 * it there, but for a tab in quotes. */
static char *put_quoted(enum format out, struct decoder *d, char *at)
{
	bool quotes = out != FORMAT_TEXT;

	if (quotes)
		*at++ = '"';
	while (d->s < d->end) {
		int n = decode(d, out == FORMAT_JSON);
		char c = d->character[0];

		if (quotes && c == '"')
			*at++ = out == FORMAT_CSV ? '"' : '\\';
		if (out == FORMAT_JSON && c == '\\')
			*at++ = '\\';
		if ((unsigned char)c < ' ') {
			at = put_control(out, c, at);
			continue;
		}
		memcpy(at, d->character, (size_t)n);
		at += n;
	}
	if (quotes)
		*at++ = '"';
	return at;
}

/* Whether f means the same in the other format as it stands. */
static bool is_plain(struct dialect out, struct span f)
{
	size_t n = (size_t)(f.end - f.s);
	double v;

	switch (out.format) {
	case FORMAT_JSON:
		return json_number(f.s, f.end, &v) == f.end && isfinite(v);
	case FORMAT_CSV:
		return memchr(f.s, '"', n) == NULL &&
		    memchr(f.s, out.separator, n) == NULL;
	default:
		return true;
	}
}

char *field_convert(struct dialect in, struct dialect out, struct span f,
    char *at)
{
	struct span inner = in.format == FORMAT_CSV ? trimmed(in, f) : f;
	bool quoted = is_quoted(in, inner);

	if (quoted)
		f = inner;
	struct decoder d = { quoted ? in.format : FORMAT_TEXT, f.s + quoted,
		f.end - quoted, "" };

	if (quoted || !is_plain(out, f))
		return put_quoted(out.format, &d, at);
	memcpy(at, f.s, (size_t)(f.end - f.s));
	return at + (f.end - f.s);
}
