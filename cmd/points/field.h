/* The fields of a line, in each format of lines. */
#ifndef FIELD_H
#define FIELD_H

#include "../span.h"
#include "format.h"

/* White space within a line. */
static inline bool is_blank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}

/* The same of a format: \v and \f are none in JSON. */
static inline bool is_blank_of(enum format format, char c)
{
	return is_blank(c) &&
	    (format != FORMAT_JSON || (c != '\v' && c != '\f'));
}

static inline const char *skip_blanks(enum format format, const char *s,
    const char *end)
{
	while (s < end && is_blank_of(format, *s))
		s++;
	return s;
}

/* Whether a field of text ends at s. */
static inline bool ends_field(const char *s, const char *end)
{
	return s == end || is_blank(*s) || *s == ',';
}

/* Past the separator of text that begins at s: blanks, at most one comma. */
static inline const char *skip_separator(const char *s, const char *end)
{
	s = skip_blanks(FORMAT_TEXT, s, end);
	if (s < end && *s == ',')
		s = skip_blanks(FORMAT_TEXT, s + 1, end);
	return s;
}

/* The field that begins at s, with its quotes in csv and JSON. */
struct span field_at(enum format, const char *s, const char *end);

/* Where the field begins that comes after the one that ends at s, or NULL. */
const char *field_next(enum format, const char *s, const char *end);

/* The k-th field from s on, counted from 0. Returns false where there is none,
 * or where it is empty. */
bool field_find(enum format, const char *s, const char *end, int k,
    struct span *);

#endif
