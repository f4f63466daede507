/* SPDX-License-Identifier: MIT */
/* What lines are made of: numbers, names and words, each written at out; what is
 * returned is where it ends. */
#ifndef LINE_PUT_H
#define LINE_PUT_H

#include <math.h>

#include "field_convert.h"
#include "line.h"

/* A separator that is longer, in bytes, is not repeated before coordinates that
 * are added to the line; one blank does. */
enum { SEPARATOR_MAX = 64 };

static inline char *put(char *out, const char *s, const char *end)
{
	size_t n = (size_t)(end - s);

	if (n == 1) /* the usual separator */
		*out = *s;
	else
		memcpy(out, s, n);
	return out + n;
}

static inline char *put_number(const struct layout *l,
    const struct numbers *numbers, int k, char *out)
{
	static const char null[] = "null";
	double v = numbers->v[(size_t)k * numbers->step];

	if (l->out.format == FORMAT_JSON && isnan(v))
		return put(out, null, null + 4);
	return number_put(out, &numbers->text[(size_t)k * numbers->text_step],
	    v, l->single, l->style[k]);
}

/* What coordinate k that is written is called. */
static inline const char *name_of(const struct layout *l, int k)
{
	static const char *const names[] = { "x", "y", "z", "w" };
	static const char *const ray[] = { "x", "y", "z", "dx", "dy", "dz" };

	return l->writes > 4 ? ray[k] : names[k];
}

static inline char *put_word(struct dialect d, const struct word *flags,
    char *out)
{
	if (d.format == FORMAT_JSON)
		*out++ = '"';
	memcpy(out, flags->s, WORD_MAX);
	out += flags->size;
	if (d.format == FORMAT_JSON)
		*out++ = '"';
	return out;
}

/* The name of coordinate k in a header, or what it is called where that has none. */
static inline char *put_name(const struct layout *l, const struct line *header,
    int k, char *out)
{
	const char *name = name_of(l, k);

	if (k < l->reads && header->at[k].from < header->at[k].to)
		return field_convert(l->in, l->out, line_at(header, k), out);
	return put(out, name, name + strlen(name));
}

/* The word's number where numbers are counted, and how many there may be of both. */
enum { FLAGS = COORDINATES_MAX, EDITS = COORDINATES_MAX + 1 };

static inline char *put_value(const struct layout *l,
    const struct numbers *numbers, const struct word *flags, int k, char *out)
{
	return k == FLAGS ? put_word(l->out, flags, out) :
			    put_number(l, numbers, k, out);
}

/* A member of its own, number k or the flags, behind those that there are. */
static inline char *put_member(const struct layout *l,
    const struct numbers *numbers, const struct word *flags, int k,
    const char *name, char *out)
{
	if (out[-1] != '{')
		*out++ = ',';
	*out++ = '"';
	out = put(out, name, name + strlen(name));
	*out++ = '"';
	*out++ = ':';
	return put_value(l, numbers, flags, k, out);
}

#endif
