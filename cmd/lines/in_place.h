/* SPDX-License-Identifier: MIT */
/* Writes a point in its own format, if only numbers of its line change or are added. */
#ifndef IN_PLACE_H
#define IN_PLACE_H

#include <math.h>

#include "line.h"

static inline char *put_word(const struct layout *l, const struct flags *w,
    char *out)
{
	bool quoted = *format_of(l->out)->open != '\0';

	*out = '"';
	memcpy(out + quoted, w->s, sizeof w->s);
	out += quoted + w->size;
	*out = '"';
	return out + quoted;
}

static inline char *put_coordinate(const struct layout *l, struct numbers n,
    int k, char *out)
{
	const struct number_text *text = &n.text[(size_t)k * n.text_stride];
	double v = n.v[(size_t)k * n.stride];

	if (__builtin_expect(text->layout == 0, 0))
		return line_put_rare_number(l, k, v, out);
	return number_put(out, text, v, l->single, l->style[k]);
}

/* Returns whether the n coordinates are on the line in the order x, y, z, w. */
static inline bool is_in_order(const struct line *line, int n)
{
	for (int k = 1; k < n; k++)
		if (line->at[k].from < line->at[k - 1].from)
			return false;
	return true;
}

/* Sorts order[], a list of the coordinates 0 to n - 1, by their places on the line. */
static inline void find_order(const struct line *line, int n, int order[4])
{
	for (int i = 1; i < n; i++)
		for (int k = i; k > 0 &&
		     line->at[order[k - 1]].from > line->at[order[k]].from;
		     k--) {
			int after = order[k];

			order[k] = order[k - 1];
			order[k - 1] = after;
		}
}

/* Returns whether added values can be written directly after the last coordinate: they
 * have no names, no quote follows the coordinate, and in FORMAT_TEXT one byte is the
 * separator before it. By --append, the line must not end in blanks. */
static inline bool can_add_in_place(const struct layout *l,
    const struct line *line)
{
	const struct part *last = &line->at[l->reads - 1];
	const char *end = line->s + line->size;

	if (l->append &&
	    (is_blank(end[-1]) ||
		is_blank(end[-1 - (*format_of(l->out)->close != '\0')])))
		return false;
	if (format_of(l->out)->blanks)
		return last->from - line->at[l->reads - 2].to == 1;
	return !line->object &&
	    (!format_of(l->out)->header || last->to == line->size ||
		line->s[last->to] != '"');
}

static inline char added_separator(const struct layout *l,
    const struct line *line)
{
	return format_of(l->out)->blanks ? line->s[line->at[l->reads - 2].to] :
					   l->out.separator;
}

/* Copies the n bytes at s, which precede a coordinate or end the line. Copies the first
 * byte without a branch, even if n is 0, because n is mostly 1. */
static inline char *put_gap(const char *s, size_t n, char *out)
{
	*out = *s;
	if (n > 1)
		memcpy(out, s, n);
	return out + n;
}

/* Writes a point. If append is set, copies the line and adds all values at its end.
 * Otherwise replaces the coordinates, which are on the line in the order order[] (NULL:
 * x, y, z, w), and adds the other values after them. Returns the end of the output. */
static inline __attribute__((always_inline)) char *
write_in_place(const struct layout *l, const struct line *line, bool append,
    const int *order, const struct numbers n, const struct flags *flags,
    char *out)
{
	uint32_t done = 0;
	int written = append ? 0 : l->reads;

	for (int i = 0; i < written; i++) {
		int k = order != NULL ? order[i] : i;

		out = put_gap(line->s + done, line->at[k].from - done, out);
		out = put_coordinate(l, n, k, out);
		done = line->at[k].to;
	}
	if (append) {
		done = line->size - (*format_of(l->out)->close != '\0');
		out = put_gap(line->s, done, out);
	}
	for (int k = written; k < l->writes; k++) {
		*out++ = added_separator(l, line);
		out = put_coordinate(l, n, k, out);
	}
	if (flags != NULL) {
		*out++ = added_separator(l, line);
		out = put_word(l, flags, out);
	}
	out = put_gap(line->s + done, line->size - done, out);
	*out = '\n';
	return out + line->newline;
}

#endif
