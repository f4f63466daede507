/* SPDX-License-Identifier: MIT */
/* The usual point on its way out: its coordinates change where they stand. */
#ifndef IN_PLACE_H
#define IN_PLACE_H

#include <math.h>

#include "line.h"

static inline char *put_word(const struct layout *l, const struct word *w,
    char *out)
{
	bool quoted = *format_of(l->out)->open != '\0';

	*out = '"';
	memcpy(out + quoted, w->s, sizeof w->s);
	out += quoted + w->size;
	*out = '"';
	return out + quoted;
}

static inline char *put_number(const struct layout *l, struct numbers n, int k,
    char *out)
{
	const struct number_text *text = &n.text[(size_t)k * n.text_step];
	double v = n.v[(size_t)k * n.step];

	if (__builtin_expect(text->layout == 0, 0))
		return line_put_rare(l, k, v, out);
	return number_put(out, text, v, l->single, l->style[k]);
}

/* Returns whether the n coordinates of a line stand in their order. */
static inline bool is_in_order(const struct line *line, int n)
{
	for (int k = 1; k < n; k++)
		if (line->at[k].from < line->at[k - 1].from)
			return false;
	return true;
}

/* Sorts the coordinates of a line by where they stand. */
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

/* Returns the end of a line's text without a closing bracket. */
static inline uint32_t end_of_fields(const struct layout *l,
    const struct line *line)
{
	return line->size - (*format_of(l->out)->close != '\0');
}

/* Returns whether what is added can follow the last of n coordinates at once: no quote
 * and no name is needed, and the separator is the one byte before that coordinate. By --append it can follow the
 * line if no blanks end it. */
static inline bool can_add_in_place(const struct layout *l,
    const struct line *line, int n)
{
	uint32_t last = line->at[n - 1].to;

	if (l->append &&
	    (is_blank(line->s[line->size - 1]) ||
		is_blank(line->s[end_of_fields(l, line) - 1])))
		return false;
	if (format_of(l->out)->blanks)
		return line->at[n - 1].from - line->at[n - 2].to == 1;
	return !line->object &&
	    (!format_of(l->out)->header || last == line->size ||
		line->s[last] != '"');
}

/* Returns that separator. */
static inline char added_separator(const struct layout *l,
    const struct line *line)
{
	return format_of(l->out)->blanks ? line->s[line->at[l->reads - 2].to] :
					   l->out.separator;
}

/* Copies the line from done up to next; as most gaps are of one byte, a byte is copied
 * even where there is none. */
static inline char *put_gap(const struct line *line, uint32_t done,
    uint32_t next, char *out)
{
	*out = line->s[done];
	if (next - done > 1)
		memcpy(out, line->s + done, next - done);
	return out + (next - done);
}

/* Writes a point of which the coordinates, in that order, change where they stand, and
 * what is added follows the last of them, or by --append the line. */
static inline __attribute__((always_inline)) char *
write_in_place(const struct layout *l, const struct line *line, bool append,
    const int *order, const struct numbers n, const struct word *flags,
    char *out)
{
	uint32_t done = 0;
	int written = append ? 0 : l->reads;

	for (int i = 0; i < written; i++) {
		int k = order != NULL ? order[i] : i;

		out = put_gap(line, done, line->at[k].from, out);
		out = put_number(l, n, k, out);
		done = line->at[k].to;
	}
	if (append) {
		done = end_of_fields(l, line);
		out = put_gap(line, 0, done, out);
	}
	for (int k = written; k < l->writes; k++) {
		*out++ = added_separator(l, line);
		out = put_number(l, n, k, out);
	}
	if (flags != NULL) {
		*out++ = added_separator(l, line);
		out = put_word(l, flags, out);
	}
	out = put_gap(line, done, line->size, out);
	*out = '\n';
	return out + line->newline;
}

#endif
