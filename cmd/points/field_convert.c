#include "field_convert.h"

#include <math.h>
#include <string.h>

#include "../json/line.h"
#include "../number/number.h"

/* A field's characters, without what its format wraps them in. */
struct reader {
	enum format format; /* text where it isn't quoted */
	const char *s, *end;
	char piece[4]; /* a decoded character */
};

static bool is_quoted(enum format format, struct span f)
{
	return format != FORMAT_TEXT && f.end - f.s >= 2 && *f.s == '"' &&
	    f.end[-1] == '"';
}

static unsigned hex4(const char *s, const char *end)
{
	unsigned v = 0;

	for (int i = 0; i < 4; i++) {
		const char *all = "0123456789abcdef0123456789ABCDEF";
		const char *d = s + i < end ? memchr(all, s[i], 32) : NULL;

		v = v * 16 + (d != NULL ? (unsigned)(d - all) % 16 : 0);
	}
	return v;
}

/* RFC 3629, section 3. */
static int utf8(unsigned code, char out[4])
{
	int n = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
	static const unsigned char first[] = { 0, 0, 0xc0, 0xe0, 0xf0 };

	for (int i = n - 1; i > 0; i--, code >>= 6)
		out[i] = (char)(0x80 | (code & 0x3f));
	out[0] = (char)(first[n] | code);
	return n;
}

/* At a backslash of JSON; half a surrogate pair becomes U+FFFD. */
static int escape(struct reader *r)
{
	static const char from[] = "bfnrt", to[] = "\b\f\n\r\t";
	char c = r->s[1];
	const char *simple = memchr(from, c, 5);

	r->s += 2;
	r->piece[0] = simple != NULL ? to[simple - from] : c;
	if (c != 'u')
		return 1;
	unsigned code = hex4(r->s, r->end), low = 0;

	r->s += r->end - r->s < 4 ? r->end - r->s : 4;
	if (r->end - r->s >= 6 && r->s[0] == '\\' && r->s[1] == 'u')
		low = hex4(r->s + 2, r->end);
	if (code >> 10 == 0xd800 >> 10 && low >> 10 == 0xdc00 >> 10) {
		code = 0x10000 + ((code & 0x3ff) << 10) + (low & 0x3ff);
		r->s += 6;
	}
	return utf8(code >> 11 == 0xd800 >> 11 ? 0xfffd : code, r->piece);
}

/* Takes the next character into piece and returns its length. */
static int next(struct reader *r)
{
	if (r->format == FORMAT_JSON && *r->s == '\\' && r->end - r->s > 1)
		return escape(r);
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
		return is_json_number(f) &&
		    number_read(f.s, f.end, &v) == f.end && isfinite(v);
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
