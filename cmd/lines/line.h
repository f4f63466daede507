/* SPDX-License-Identifier: MIT */
/* Reads any line of points, and alone decides which are legal. lookup.h finds the
 * coordinates, reason.h says what is wrong, and header.h reads headers. */
#pragma once

#include "layout.h"

/* What of a source is read next. FIRST_LINE: the first neither blank nor a comment.
 * FIRST_ROW: the first row after a header. FIRST_NONE: any later line. */
enum next_part { FIRST_NONE, FIRST_LINE, FIRST_ROW, FIRST_BYTE };

enum line_kind {
	LINE_POINT,
	LINE_COPY, /* blank, or a comment */
	LINE_HEADER,
	LINE_BAD,     /* a coordinate is wrong; the other fields are kept */
	LINE_LOST,    /* wrong, and no field can be kept */
	LINE_REFUSED, /* a wrong header or first row: the source is refused */
};

/* Bytes [from, to) of a line of at most 64 MiB, or of 256 MiB in a JSON document. */
struct part {
	uint32_t from, to;
};

struct line {
	const char *s;     /* the beginning of the line */
	uint32_t size;     /* in bytes, without the newline */
	struct part at[4]; /* of each coordinate or, in a header, its name */
	enum line_kind kind;
	bool newline;   /* the line ends in a newline */
	bool object;    /* the line is a JSON object */
	bool no_commas; /* FORMAT_TEXT: only blanks end a field */
	bool has_bom;   /* the line begins with a byte order mark */
};

static const struct part part_missing = { 1, 0 };

static inline bool part_is_missing(struct part p)
{
	return p.from > p.to;
}

static inline bool line_is_bad(const struct line *line)
{
	return line->kind >= LINE_BAD;
}

static inline struct span line_text(const struct line *line)
{
	return (struct span){ line->s, line->s + line->size };
}

static inline struct span line_field(const struct line *line, int i)
{
	return (struct span){ line->s + line->at[i].from, line->s + line->at[i].to };
}

static inline struct part line_part(const struct line *line, struct span f)
{
	return (struct part){ (uint32_t)(f.s - line->s), (uint32_t)(f.end - line->s) };
}

/* Reads a line and its coordinates v. If it is wrong, writes why, and how to mend it.
 * Updates *first; a first line may have a byte order mark, and in csv be a header. */
void line_read(struct layout *, struct span text, enum next_part *, struct line *,
    double v[4], char reason[REASON_MAX]);
