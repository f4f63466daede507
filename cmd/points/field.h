/* A line's fields, format by format. */
#ifndef FIELD_H
#define FIELD_H

#include "format.h"

struct span {
	const char *s, *end;
};

/* White space within a line. */
static inline bool is_blank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}

static inline const char *skip_blanks(const char *s, const char *end)
{
	while (s < end && is_blank(*s))
		s++;
	return s;
}

/* Whether a field of text ends at s. */
static inline bool ends_field(const char *s, const char *end)
{
	return s == end || is_blank(*s) || *s == ',';
}

/* Where the separator at s ends: blanks with at most one comma, in text. */
static inline const char *text_next(const char *s, const char *end)
{
	s = skip_blanks(s, end);
	if (s < end && *s == ',')
		s = skip_blanks(s + 1, end);
	return s;
}

/* The field that begins at s; with its quotes in csv and JSON. */
struct span split_field(enum format, const char *s, const char *end);

/* Where the field after the one that ends at s begins, or NULL. */
const char *split_next(enum format, const char *s, const char *end);

/* The k-th field from s, from 0; false where there is none, or it is empty. */
bool split_find(enum format, const char *s, const char *end, int k,
    struct span *);

#endif
