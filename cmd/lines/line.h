/* SPDX-License-Identifier: MIT */
/* A line with a point: finding its coordinates, and writing the line with
 * others in their place. Everything else on it stays as it was. */
#ifndef LINE_H
#define LINE_H

#include <stddef.h>
#include <stdint.h>

#include "../number/number.h"
#include "formats.h"

/* The most that are written, a ray's: a point and a direction. No more than
 * four are read. */
enum { COORDINATES_MAX = 6 };

/* From --columns: field numbers from 0, or names to be found in a csv header, or of
 * members of JSON objects, of which those that begin with / are pointers. */
struct columns {
	int n; /* 0: the first fields are the coordinates, or the members x, y, z, w */
	int field[4];
	/* NULL if a field is given by its number; x, y, z and w without --columns */
	const char *name[4];
	bool by_header; /* there is no --columns */
};

/* Which line of a source is still to come: the first that counts, or the first row
 * behind a header. */
enum first { FIRST_IS_READ, FIRST_LINE, FIRST_ROW };

enum header { HEADER_MAYBE, HEADER_FIRST, HEADER_NONE };

/* How lines, or binary points, are laid out. */
struct layout {
	struct dialect in, out;
	enum header header; /* of csv */
	struct columns columns;
	int reads, writes; /* how many coordinates */
	bool flags;        /* a word is written after them */
	bool append; /* what is written stands behind the whole line */
	/* of the numbers that are written, and the word; "": there is none */
	char name[COORDINATES_MAX + 1][16];
	size_t fields; /* of the header, by --append; 0: there is none */
	int record; /* numbers of a binary record; 0: the coordinates alone */
	bool keeps; /* binary records are written whole */
	const char *two; /* as struct document_wants has it */
	bool single;     /* they are floats, and written as such */
	struct number_style style[COORDINATES_MAX];
};

/* What a line turned out to be. */
enum line_kind {
	LINE_POINT,
	LINE_COPY, /* blank or comment */
	LINE_HEADER,
	LINE_BAD, /* its coordinates have places, but for those that are missing */
	LINE_LOST,    /* bad, and not to be taken apart */
	LINE_REFUSED, /* a header that lacks a coordinate: no line is read */
};

/* Of a line's text, counted from its beginning. With its newline a line is at most
 * 64 MiB, one of a document at most 256 MiB as that is. */
struct part {
	uint32_t from, to;
};

struct line {
	const char *s;     /* its text */
	uint32_t size;     /* without its newline */
	struct part at[4]; /* where x, y, z and w stand */
	enum line_kind kind;
	bool newline; /* it ends in one */
	bool object;  /* it is one of JSON */
	bool words;   /* its commas may be decimal points */
	bool mark;    /* it begins with a byte order mark */
};

/* Where a coordinate of a bad line stands that has no place. */
static const struct part part_missing = { 1, 0 };

static inline bool is_missing(struct part p)
{
	return p.from > p.to;
}

static inline bool line_is_bad(const struct line *line)
{
	return line->kind >= LINE_BAD;
}

/* The coordinates that are written in a line. Number k is v[k * step], and its
 * text, if any was made, text[k * text_step]. */
struct numbers {
	const double *v;
	const struct number_text *text;
	size_t step, text_step;
};

/* Room for the separator, and in an object the name, before a value that is added. */
enum { ADDED_ROOM = 64 };

enum { WORD_MAX = 48 };

/* What is written after them. */
struct word {
	char s[WORD_MAX];
	size_t size;
};

static inline struct span line_text(const struct line *line)
{
	return (struct span){ line->s, line->s + line->size };
}

/* Where coordinate i stands. */
static inline struct span line_at(const struct line *line, int i)
{
	return (struct span){ line->s + line->at[i].from,
		line->s + line->at[i].to };
}

static inline struct part line_part(const struct line *line, struct span f)
{
	return (struct part){ (uint32_t)(f.s - line->s),
		(uint32_t)(f.end - line->s) };
}

/* Returns the bytes of one binary point, with what else is in its record. */
static inline size_t layout_record(const struct layout *l)
{
	return point_size(l->in.format, l->record > 0 ? l->record : l->reads);
}

/* Returns the number of the field that coordinate i is, from 0. */
static inline int layout_field(const struct layout *l, int i)
{
	return l->columns.n > 0 ? l->columns.field[i] : i;
}

/* Returns what coordinate i is called. */
static inline const char *coordinate_name(int i)
{
	static const char names[][2] = { "x", "y", "z", "w" };

	return names[i];
}

/* Reads the coordinates v of a line. For a bad line, reason says what is wrong and
 * what would be right. While *first is true the source's first line that counts is
 * still to come: a byte order mark may stand before it, and in csv it may be a
 * header, which says in the layout where the columns are. */
void line_read(struct layout *, struct span text, enum first *, struct line *,
    double v[4], char reason[REASON_MAX]);

/* Writes v, which is number k and has no text; nan as the format's word for a number
 * that is not known. Returns where it ends. */
char *line_put_rare(const struct layout *, int k, double v, char *out);

/* The most bytes that line_write may touch for so many lines of so many bytes
 * in all. */
size_t lines_room(const struct layout *, size_t lines, size_t bytes);

/* Writes the line with the numbers in the place of those it was read with, or behind
 * them by --append, and the word flags after them unless that is NULL; returns where
 * it ends. A bad
 * line that was not to be taken apart becomes the numbers alone. Blank lines and
 * comments stay as they are, and headers but for the names of what is added and left
 * out; in text those are comments. All are left out from JSON and to JSON. */
char *line_write(const struct layout *, const struct line *,
    const struct numbers *, const struct word *flags, char *out);

/* Writes what else is on a line with a point, each field with a separator of the
 * format out before it; of text to text, without columns, as it stands. Returns
 * where it ends. For each byte of the line it takes six, and three more for each field. */
char *line_rest(const struct layout *, const struct line *, char *out);

#endif
