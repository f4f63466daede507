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

/* A field of csv. If it begins with a quote, commas up to the closing quote are
 * part of it; "" stands for a quote and doesn't close it. In a field that does
 * not begin with one, as in 5" pipe, a quote is like any other character. */
static struct span csv_field(const char *s, const char *end)
{
	const char *p = skip_blanks(FORMAT_CSV, s, end);
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

	f.s = skip_blanks(FORMAT_JSON, s, end);
	f.end = json_skip(f.s, end);
	while (f.end > f.s && is_blank_of(FORMAT_JSON, f.end[-1]))
		f.end--;
	return f;
}

struct span field_at(enum format format, const char *s, const char *end)
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

const char *field_next(enum format format, const char *s, const char *end)
{
	if (format == FORMAT_TEXT) {
		const char *after = skip_separator(s, end);

		return after == end && (s == end || after[-1] != ',') ? NULL :
									after;
	}
	s = skip_blanks(format, s, end);
	return s < end && *s == ',' ? s + 1 : NULL;
}

bool field_find(enum format format, const char *s, const char *end, int k,
    struct span *f)
{
	for (; s != NULL; s = field_next(format, f->end, end)) {
		*f = field_at(format, s, end);
		if (k-- == 0)
			return f->s < f->end;
	}
	return false;
}
