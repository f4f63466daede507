/* SPDX-License-Identifier: MIT */
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

/* A field of csv. If it begins with a quote, separators up to the closing quote are
 * part of it; "" stands for a quote and doesn't close it. In a field that does
 * not begin with one, as in 5" pipe, a quote is like any other character. */
static struct span csv_field(char separator, const char *s, const char *end)
{
	const char *p = skip_blanks((struct dialect){ FORMAT_CSV, separator },
	    s, end);
	struct span f = { s, s };
	bool quoted = p < end && *p == '"';

	for (f.end = p + quoted; quoted && f.end < end; f.end++)
		if (*f.end == '"' && (f.end + 1 == end || *++f.end != '"'))
			break;
	while (f.end < end && *f.end != separator)
		f.end++;
	if (f.end == end && f.end > s && f.end[-1] == '\r')
		f.end--;
	return f;
}

/* An element of a JSON array. */
static struct span json_field(const char *s, const char *end)
{
	struct dialect json = { FORMAT_JSON, ',' };

	s = skip_blanks(json, s, end);
	return trimmed(json, (struct span){ s, json_skip(s, end) });
}

struct span field_at(struct dialect d, const char *s, const char *end)
{
	switch (d.format) {
	case FORMAT_CSV:
		return csv_field(d.separator, s, end);
	case FORMAT_JSON:
		return json_field(s, end);
	default:
		return text_field(s, end);
	}
}

const char *field_next(struct dialect d, const char *s, const char *end)
{
	if (d.format == FORMAT_TEXT) {
		const char *after = skip_separator(s, end);
		size_t n = (size_t)(after - s);

		return after == end && memchr(s, ',', n) == NULL ? NULL : after;
	}
	s = skip_blanks(d, s, end);
	return s < end && *s == d.separator ? s + 1 : NULL;
}

bool field_find(struct dialect d, const char *s, const char *end, int k,
    struct span *f)
{
	for (; s != NULL; s = field_next(d, f->end, end)) {
		*f = field_at(d, s, end);
		if (k-- == 0)
			return f->s < f->end;
	}
	*f = (struct span){ NULL, NULL };
	return false;
}
