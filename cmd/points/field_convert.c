#include "field_convert.h"

#include <math.h>
#include <string.h>

#include "../json/scan.h"
#include "../number/number.h"

/* A field's characters, without what its format wraps them in. */
struct reader {
	enum format format; /* FORMAT_TEXT: not quoted */
	const char *s, *end;
	char piece[4]; /* a decoded character */
};

static bool is_quoted(enum format format, struct span f)
{
	return format != FORMAT_TEXT && f.end - f.s >= 2 && *f.s == '"' &&
	    f.end[-1] == '"';
}

/* Takes the next character into piece and returns its length. */
static int next(struct reader *r)
{
	int n;

	if (r->format == FORMAT_JSON && *r->s == '\\') {
		r->s = json_unescape(r->s, r->end, r->piece, &n);
		return n;
	}
	r->piece[0] = *r->s;
	r->s += r->format == FORMAT_CSV && *r->s == '"' && r->end - r->s > 1 &&
		r->s[1] == '"' ?
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
		*at++ = ' ';
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
 * it there. */
static char *put_quoted(enum format out, struct reader *r, char *at)
{
	bool quotes = out != FORMAT_TEXT;

	if (quotes)
		*at++ = '"';
	while (r->s < r->end) {
		int n = next(r);
		char c = r->piece[0];

		if (quotes && c == '"')
			*at++ = out == FORMAT_CSV ? '"' : '\\';
		if (out == FORMAT_JSON && c == '\\')
			*at++ = '\\';
		if ((unsigned char)c < ' ') {
			at = put_control(out, c, at);
			continue;
		}
		memcpy(at, r->piece, (size_t)n);
		at += n;
	}
	if (quotes)
		*at++ = '"';
	return at;
}

/* Whether f means the same in the other format as it stands. */
static bool is_plain(enum format out, struct span f)
{
	size_t n = (size_t)(f.end - f.s);
	double v;

	switch (out) {
	case FORMAT_JSON:
		return json_number(f.s, f.end, &v) == f.end && isfinite(v);
	case FORMAT_CSV:
		return memchr(f.s, '"', n) == NULL &&
		    memchr(f.s, ',', n) == NULL;
	default:
		return true;
	}
}

char *foreign_write(enum format in, enum format out, struct span f, char *at)
{
	bool quoted = is_quoted(in, f);
	struct reader r = { quoted ? in : FORMAT_TEXT, f.s + quoted,
		f.end - quoted, "" };

	if (quoted || !is_plain(out, f))
		return put_quoted(out, &r, at);
	memcpy(at, f.s, (size_t)(f.end - f.s));
	return at + (f.end - f.s);
}
