#include "field.h"

#include "../json/scan.h"

/* A field of text: up to a blank or comma. */
static struct span text_field(const char *s, const char *end)
{
	struct span f = { s, s };

	while (!ends_field(f.end, end))
		f.end++;
	return f;
}

/* A field of csv. If it begins with a quote, commas up to the closing one are
 * part of it, and "" is not the closing one; the quote of 5" pipe is like any
 * other character. */
static struct span csv_field(const char *s, const char *end)
{
	const char *p = skip_blanks(s, end);
	struct span f = { s, s };
	bool quoted = p < end && *p == '"';

	for (f.end = p + quoted; quoted && f.end < end; f.end++)
		if (*f.end == '"' && (f.end + 1 == end || *++f.end != '"'))
			break;
	while (f.end < end && *f.end != ',')
		f.end++;
	if (f.end == end && f.end > s && f.end[-1] == '\r')
		f.end--;
	return f;
}

/* An element of a JSON array. */
static struct span json_field(const char *s, const char *end)
{
	struct span f;

	f.s = skip_blanks(s, end);
	f.end = json_skip(f.s, end);
	while (f.end > f.s && is_blank(f.end[-1]))
		f.end--;
	return f;
}

struct span split_field(enum format format, const char *s, const char *end)
{
	switch (format) {
	case FORMAT_CSV:
		return csv_field(s, end);
	case FORMAT_JSON:
		return json_field(s, end);
	default:
		return text_field(s, end);
	}
}

/* Where the field after the one that ends at s begins, or NULL. */
const char *split_next(enum format format, const char *s, const char *end)
{
	if (format == FORMAT_TEXT) {
		const char *after = text_next(s, end);

		return after == end && (s == end || after[-1] != ',') ? NULL :
									after;
	}
	s = skip_blanks(s, end);
	return s < end && *s == ',' ? s + 1 : NULL;
}

/* The k-th field, from 0. */
bool split_find(enum format format, const char *s, const char *end, int k,
    struct span *f)
{
	for (; s != NULL; s = split_next(format, f->end, end)) {
		*f = split_field(format, s, end);
		if (k-- == 0)
			return f->s < f->end;
	}
	return false;
}
