/* SPDX-License-Identifier: MIT */
/* The fields of a line, in each format of lines. */
#ifndef FIELD_H
#define FIELD_H

#include <string.h>

#include "../message/span.h"
#include "formats.h"

/* White space within a line. */
static inline bool is_blank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}

/* The same of a dialect: \v and \f are none in JSON, and in csv what separates is
 * none. */
static inline __attribute__((always_inline)) bool is_blank_of(struct dialect d,
    char c)
{
	return is_blank(c) && (d.format == FORMAT_TEXT || c != d.separator) &&
	    (d.format != FORMAT_JSON || (c != '\v' && c != '\f'));
}

static inline const char *skip_blanks(struct dialect d, const char *s,
    const char *end)
{
	while (s < end && is_blank_of(d, *s))
		s++;
	return s;
}

/* Without the blanks at its ends. */
static inline struct span trimmed(struct dialect d, struct span f)
{
	f.s = skip_blanks(d, f.s, f.end);
	while (f.end > f.s && is_blank_of(d, f.end[-1]))
		f.end--;
	return f;
}

/* Past the byte order mark that a text may begin with. */
static inline const char *skip_mark(const char *s, const char *end)
{
	return end - s >= 3 && memcmp(s, "\xef\xbb\xbf", 3) == 0 ? s + 3 : s;
}

/* Whether a field of text ends at s. */
static inline bool ends_field(const char *s, const char *end)
{
	return s == end || is_blank(*s) || *s == ',';
}

/* Past the separator of text that begins at s: blanks, at most one comma. */
static inline const char *skip_separator(const char *s, const char *end)
{
	while (s < end && is_blank(*s))
		s++;
	s += s < end && *s == ',';
	while (s < end && is_blank(*s))
		s++;
	return s;
}


#endif
