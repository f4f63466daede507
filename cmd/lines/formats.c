/* SPDX-License-Identifier: MIT */
#include "formats.h"

#include <math.h>
#include <stdio.h>

#include "../json/check.h"
#include "../json/text.h"
#include "../message/escape.h"
#include "../number/number.h"
#include "put.h"

struct dialect dialect_of(enum format f, char separator)
{
	const struct format_row *row = &format_rows[f];

	return (struct dialect){ row->base,
		row->separator != 0 ? row->separator : separator };
}

/* Returns the end of the quoted text at s, with "" for a quote; NULL: not closed. */
static const char *csv_quote_end(const char *s, const char *end)
{
	do {
		s++;
		s = memchr(s, '"', (size_t)(end - s));
	} while (s != NULL && ++s < end && *s == '"');
	return s;
}

bool format_has_only_cr(struct dialect d, struct span line, char reason[REASON_MAX])
{
	const char *s = line.s;
	const bool csv = format_of(d)->header && *skip_blanks(d, s, line.end) != '#';

	bool quoted = false;

	for (bool begins = csv; s < line.end && (quoted || *s != '\r'); s++) {
		quoted ^= begins && *s == '"';
		begins = csv &&
		    (quoted || *s == d.separator ||
			(begins && (is_blank(*s) || *s == '"')));
	}
	while (s < line.end && is_blank(*s))
		s++;
	if (s == line.end)
		return false;
	strcpy(reason,
	    "has carriage returns alone for line ends; make them newlines: tr "
	    "'\\r' '\\n'");
	return true;
}

/* Returns the size of the word or number at s, or else 1. */
static size_t token_size(const char *s, const char *end)
{
	const char *p = s;

	while (p < end && (unsigned char)*p > ' ' && strchr(",:[]{}\"", *p) == NULL)
		p++;
	return p > s ? (size_t)(p - s) : 1;
}

static bool json_line_check(struct dialect d, struct span line, char reason[REASON_MAX])
{
	const char *s = skip_blanks(d, line.s, line.end);
	char shown[ESCAPED_MAX];
	struct json_check c = { .s = line.s, .end = line.end };

	if (*s != '[' && *s != '{')
		strcpy(reason,
		    "is neither a JSON array nor an object; is this csv or "
		    "text? say -i csv or -i text");
	else if (json_check(&c))
		return true;
	else if (format_has_only_cr(d, line, reason))
		return false;
	else if (c.at == line.end)
		snprintf(reason, REASON_MAX,
		    "a bracket is not closed on the line; one array or object "
		    "a line: jq -c %s, for -i json",
		    *s == '{' ? "." : "'.[]'");
	else
		snprintf(reason, REASON_MAX, "is no JSON: expected %s, not '%s'",
		    c.wanted, escape_short(shown, c.at, token_size(c.at, line.end)));
	return false;
}

/* Sets *f to the next field of FORMAT_TEXT. Unless c->no_commas, commas end it, too. */
static void next_of_text(struct cursor *c, struct field *f)
{
	const char *s = skip_blanks(c->in, c->s, c->end), *after;

	f->value.s = s;
	while (s < c->end && !is_blank(*s) && (c->no_commas || *s != ','))
		s++;
	f->value.end = s;
	f->whole = f->value;
	c->previous_end = s;
	after = c->no_commas ? skip_blanks(c->in, s, c->end) :
			       skip_text_separator(s, c->end);
	c->comma = !c->no_commas && memchr(s, ',', (size_t)(after - s)) != NULL;
	f->next = after == c->end && !c->comma ? NULL : after;
}

/* Returns 8 bytes as a number, the first in the lowest bits. */
static inline uint64_t eight_at(const char *s)
{
	uint64_t x;

	memcpy(&x, s, sizeof x);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
	x = __builtin_bswap64(x);
#endif
	return x;
}

/* Each byte of a number is 1, or the top bit of each is set. */
static const uint64_t ones = 0x0101010101010101, tops = ones << 7;

/* Returns the first byte in [s, end) that is a, b or a control character, else end. By
 * 8 bytes at a time no branch depends on the lengths of short fields, which vary. Of
 * the top bits that are set, the lowest is right. */
static inline const char *find_either(const char *s, const char *end, char a, char b)
{
	for (; s < end; s += 8) {
		uint64_t x = eight_at(s), is_a = x ^ (ones * (uint8_t)a),
			 is_b = x ^ (ones * (uint8_t)b);
		uint64_t found = (((is_a - ones) & ~is_a) | ((is_b - ones) & ~is_b) |
				     ((x - ones * ' ') & ~x)) &
		    tops;

		if (found != 0) {
			s += __builtin_ctzll(found) / 8;
			break;
		}
	}
	return s < end ? s : end;
}

/* Sets *f to the next field of csv. If the field begins with a quote, separators and
 * doubled quotes before the closing quote are in it. Other quotes are plain bytes. */
static void next_of_csv(struct cursor *c, struct field *f)
{
	const char *end = c->end, *s = skip_blanks(c->in, c->s, end);

	f->whole.s = c->s;
	if (s < end && *s == '"')
		s = csv_quote_end(s, end);
	if (s != NULL)
		s = memchr(s, c->in.separator, (size_t)(end - s));
	f->next = s != NULL ? s + 1 : NULL;
	f->whole.end = s != NULL ? s : end;
	if (s == NULL && end > c->s && end[-1] == '\r')
		f->whole.end--;
	f->value = trimmed(c->in, f->whole);
	c->previous_end = f->value.end;
	if (f->value.end - f->value.s >= 2 && *f->value.s == '"' &&
	    f->value.end[-1] == '"')
		f->value = trimmed(c->in,
		    (struct span){ f->value.s + 1, f->value.end - 1 });
}

static void next_of_json(struct cursor *c, struct field *f)
{
	const char *s = c->s;

	f->whole.s = s;
	if (c->members) {
		f->name = (struct span){ s, json_string_end(s, c->end) };
		s = json_skip_blanks(f->name.end, c->end);
		s = json_skip_blanks(s + 1, c->end);
	}
	const char *after = json_item_end(s, c->end);

	f->value = trimmed(c->in, (struct span){ s, after });
	f->whole.end = c->previous_end = f->value.end;
	f->next = *after == ',' ? json_skip_blanks(after + 1, c->end) : NULL;
}

static bool csv_check(struct dialect d, struct span line, char reason[REASON_MAX])
{
	struct cursor c = line_cursor(d, line);
	struct field f;

	if (memchr(line.s, '"', (size_t)(line.end - line.s)) == NULL)
		return true;
	while (cursor_next(&c, &f))
		continue;
	/* the last field has all that follows an open quote */
	const char *s = skip_blanks(d, f.whole.s, line.end);

	if (s == line.end || *s != '"' || csv_quote_end(s, line.end) != NULL)
		return true;
	strcpy(reason,
	    "a quote is not closed on the line; a field with a newline in it can't be "
	    "read");
	return false;
}

const char *format_read(struct dialect d, const char *s, const char *end, double *v)
{
	static const char words[][5] = { "null", "NA", "N/A", "n/a", "na", "NULL", "" };
	const struct format_row *in = format_of(d);
	const char *after = *in->open != '\0' ? json_number(s, end, v) :
						number_read(s, end, v);

	for (int i = 0; i < in->nan_words && after == NULL; i++)
		if (strlen(words[i]) == (size_t)(end - s) &&
		    memcmp(words[i], s, (size_t)(end - s)) == 0) {
			*v = (double)NAN;
			after = end;
		}
	return after;
}

/* Returns the first byte in [s, end) that is no digit, or a place from end on. */
static const char *skip_digits(const char *s, const char *end)
{
	for (; s < end; s += 8) {
		uint64_t x = eight_at(s) ^ ('0' * ones);
		uint64_t others = (x | (x + 0x76 * ones)) & tops;

		if (others != 0)
			return s + __builtin_ctzll(others) / 8;
	}
	return s;
}

/* Returns whether f is a number of JSON without exponent, of so few digits that it is
 * finite. */
static bool is_short_number(struct span f)
{
	const char *whole = f.s + (*f.s == '-'), *s = skip_digits(whole, f.end);

	if (s == whole || (*whole == '0' && s > whole + 1) || f.end - f.s > 99)
		return false;
	if (*s == '.' && s < f.end - 1)
		s = skip_digits(s + 1, f.end);
	return s == f.end;
}

/* Returns whether the unquoted field f can be copied to the dialect d: to JSON if f is
 * a finite number, to csv if f has no quote or separator, to FORMAT_TEXT always. */
static bool can_copy(struct dialect d, struct span f)
{
	const struct format_row *to = format_of(d);
	double v;

	if (*to->open != '\0')
		return is_short_number(f) ||
		    (json_number(f.s, f.end, &v) == f.end && isfinite(v));
	if (to->quote == 0)
		return true;
	return memchr(f.s, to->quote, (size_t)(f.end - f.s)) == NULL &&
	    memchr(f.s, d.separator, (size_t)(f.end - f.s)) == NULL;
}

#define LINES .open = "", .close = "", .nan_text = "nan"
#define CSV                                                                 \
	LINES, .quote = '"', .escape = '"', .header = true, .nan_words = 7, \
	       .check = csv_check, .next = next_of_csv

const struct format_row format_rows[] = {
	[FORMAT_TEXT] = { FORMAT_TEXT, ' ', LINES, .blanks = true, .nan_words = 6,
	    .next = next_of_text },
	[FORMAT_CSV] = { FORMAT_CSV, CSV },
	[FORMAT_TSV] = { FORMAT_CSV, '\t', CSV },
	[FORMAT_JSON] = { FORMAT_JSON, ',', .open = "[", .close = "]",
	    .nan_text = "null", .quote = '"', .escape = '\\', .nan_words = 1,
	    .check = json_line_check, .next = next_of_json },
	[FORMAT_F64] = { FORMAT_F64, ',', LINES, .size = sizeof(double) },
	[FORMAT_F32] = { FORMAT_F32, ',', LINES, .size = sizeof(float) },
};

const char *const format_names[] = { "text", "csv", "tsv", "json", "f64", "f32", NULL };

/* Writes a control character: outside of JSON as a blank, as it could end the line. */
static char *put_control(const struct format_row *out, char c, char *at)
{
	static const char from[] = "\b\f\n\r\t", to[] = "bfnrt";
	const char *simple = memchr(from, c, 5);

	if (out->escape != '\\') {
		*at++ = out->quote != 0 && c == '\t' ? c : ' ';
		return at;
	}
	*at++ = '\\';
	if (simple == NULL)
		return at + sprintf(at, "u%04x", (unsigned)c);
	*at++ = to[simple - from];
	return at;
}

/* Decodes the character at *s, and moves *s past it; returns its size. `escape` is the
 * field's, or 0. If utf8 is set, a byte that is not UTF-8 becomes U+FFFD. */
static int decode_one(const char **s, const char *end, char escape, bool utf8,
    char c[4])
{
	unsigned code;
	int n = 1;

	if (escape == '\\' && **s == '\\') {
		*s = json_unescape(*s, end, c, &n);
		return n;
	}
	if (utf8)
		n = utf8_read(*s, end, &code);
	if (n == 0) {
		++*s;
		return utf8_write(0xfffd, c);
	}
	memcpy(c, *s, (size_t)n);
	*s += n;
	*s += escape == '"' && *c == '"' && *s < end && **s == '"';
	return n;
}

/* Writes f, in quotes if out has them. `escape` is the escape character in f, or 0. */
static char *put_quoted(const struct format_row *out, struct span f, char escape,
    char *at)
{
	char c[4] = "";

	*at = out->quote;
	at += out->quote != 0;
	while (f.s < f.end) {
		if (*f.s >= ' ' && *f.s <= '~' && *f.s != '"' && *f.s != '\\') {
			*at++ = *f.s++;
			continue;
		}
		int n = decode_one(&f.s, f.end, escape, out->escape == '\\', c);

		if ((unsigned char)c[0] < ' ') {
			at = put_control(out, c[0], at);
			continue;
		}
		if (out->quote != 0 && (c[0] == out->quote || c[0] == out->escape))
			*at++ = out->escape;
		memcpy(at, c, (size_t)n);
		at += n;
	}
	*at = out->quote;
	return at + (out->quote != 0);
}

char *format_convert(struct dialect in, struct dialect out, struct span f, char *at)
{
	const struct format_row *from = format_of(in), *to = format_of(out);
	struct span inner = from->header ? trimmed(in, f) : f;
	bool quoted = from->quote != 0 && inner.end - inner.s >= 2 && *inner.s == '"' &&
	    inner.end[-1] == '"';

	if (quoted)
		return put_quoted(to, (struct span){ inner.s + 1, inner.end - 1 },
		    from->escape, at);
	if (!can_copy(out, f))
		return put_quoted(to, f, 0, at);
	return put_gap(f.s, (size_t)(f.end - f.s), at);
}

/* Copies csv with other separators, 16 bytes at a time, from the separator before c->s
 * to FORMAT_TEXT or tsv, up to a field near a quote or a control character or, for
 * text, an empty field. */
static char *put_other_separators(struct cursor *c, struct dialect out, char *at)
{
	typedef uint8_t bytes __attribute__((vector_size(16)));
	typedef uint64_t halves __attribute__((vector_size(16)));
	const bytes place = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15 };
	const uint8_t from = (uint8_t)c->in.separator;
	const uint8_t change = from ^ (uint8_t)out.separator;
	const uint8_t no_empty = format_of(out)->blanks ? 255 : 0;
	const char *s = c->s - 1;

	for (; s < c->end; s += sizeof(bytes), at += sizeof(bytes)) {
		const uint8_t n = c->end - s < 16 ? (uint8_t)(c->end - s) : 16;
		bytes x, before;

		memcpy(&x, s, sizeof x);
		memcpy(&before, s - 1, sizeof before);
		const bytes separators = (bytes)(x == from);
		const halves wrong = (halves)((bytes)(place < n) &
		    ((bytes)(x == '"') | ((bytes)(x < ' ') & ~separators) |
			(separators & (bytes)(before == from) & no_empty)));

		if ((wrong[0] | wrong[1]) != 0)
			break;
		x ^= separators & change;
		memcpy(at, &x, sizeof x);
	}
	const char *done = s < c->end ? s : c->end, *next = done;

	if (done < c->end || (no_empty && done[-1] == c->in.separator))
		while (next >= c->s && *--next != c->in.separator)
			continue;
	c->s = next < c->end ? next + 1 : NULL;
	return at - (s - next);
}

char *format_convert_plain(struct cursor *c, struct dialect out, char *at)
{
	if (format_of(out)->blanks || out.separator == '\t')
		return put_other_separators(c, out, at);
	while (c->s != NULL) {
		const char *s = find_either(c->s, c->end, c->in.separator, '"');
		struct span f = { c->s, s };

		if (s < c->end && *s != c->in.separator)
			break;
		c->s = s < c->end ? s + 1 : NULL;
		*at++ = out.separator;
		at = can_copy(out, f) ? put_gap(f.s, (size_t)(s - f.s), at) :
					put_quoted(format_of(out), f, 0, at);
	}
	return at;
}

struct cursor value_cursor(struct span value, const char *end)
{
	const char *s = json_skip_blanks(value.s + 1, end);

	return (struct cursor){ .in = { FORMAT_JSON, ',' },
		.s = *s == ']' || *s == '}' ? NULL : s,
		.end = end,
		.bracket = value.s + 1,
		.members = *value.s == '{' };
}

struct cursor line_cursor(struct dialect in, struct span line)
{
	if (*format_of(in)->open != '\0')
		return value_cursor(trimmed(in, line), line.end);
	return (struct cursor){ .in = in, .s = line.s, .end = line.end };
}

bool cursor_next(struct cursor *c, struct field *f)
{
	if (c->s == NULL)
		return false;
	f->name.s = NULL;
	f->previous_end = c->previous_end;
	f->comma = c->comma;
	format_of(c->in)->next(c, f);
	c->s = f->next;
	return true;
}

size_t cursor_count(struct cursor c)
{
	struct field f;
	size_t n = 0;

	while (cursor_next(&c, &f))
		n++;
	return n;
}
