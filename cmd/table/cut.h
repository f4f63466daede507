/* SPDX-License-Identifier: MIT */
/* Cuts lines into fields: any line by a cursor and, faster, lines in the usual form by
 * a walk from stop to stop. A line that a walk leaves is cut by cursors, with the same
 * result. */
#pragma once

#include "../number/vector/loops.h"
#include "format.h"

enum line_kind {
	LINE_POINT,
	LINE_COPY,    /* blank, a comment, or of obj no point: stays as it is */
	LINE_HEADER,  /* the names of columns */
	LINE_SILENT,  /* a header that an input before had, too: is left out */
	LINE_BAD,     /* wrong, but the fields of the coordinates are known */
	LINE_LOST,    /* wrong, and they are not */
	LINE_REFUSED, /* wrong, so that nothing of the source after it is read */
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
	bool newline; /* the line ends in a newline */
	bool object;  /* the line is a JSON object */
	bool has_bom; /* the line begins with a byte order mark */
};

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

/* Sorts order[], a list of the coordinates 0 to n - 1, by their places on the line. */
static inline void line_order(const struct line *line, int n, int order[4])
{
	for (int i = 0; i < n; i++) {
		int k = i;

		for (; k > 0 && line->at[order[k - 1]].from > line->at[i].from; k--)
			order[k] = order[k - 1];
		order[k] = i;
	}
}

/* A field of a line, an element of a JSON array, or a member of an object. */
struct field {
	struct span value;        /* without name, quotes of csv and outer blanks */
	struct span whole;        /* with name; in csv with quotes and blanks */
	struct span name;         /* a member's name, quoted; else s is NULL */
	const char *previous_end; /* the end of the field before, or NULL */
	const char *next;         /* where the next field begins; NULL: none */
};

struct cursor {
	struct dialect in;
	const char *s;            /* the next field, or NULL after the last */
	const char *end;          /* the end of the line */
	const char *previous_end; /* the end of the field before s, or NULL */
	const char *bracket;      /* the byte after [ or {; NULL: not JSON */
	bool members;             /* the fields are members of a JSON object */
};

/* Returns whether the line can be cut: JSON is valid, quotes of csv are closed. Says
 * what is wrong if it is not, and where in the line. */
bool line_check(struct dialect, struct span line, struct refusal *);

/* Returns whether all bytes are UTF-8. */
bool is_utf8(struct span);

/* Returns whether the line is one that has no point: obj has them in lines of v
 * alone. */
bool line_is_other(struct dialect, struct span line);

/* Returns a cursor before the first field of a line that line_check accepts. */
struct cursor line_cursor(struct dialect, struct span line);

/* Reads the next field and moves the cursor past it; returns false if there is none. */
bool cursor_next(struct cursor *, struct field *);

/* A stretch is text with an index of its stops, which are the bytes that can end a
 * field or make a line not usual. The text is the caller's. A stretch stays in the
 * first-level cache, and the place of a stop fits into 16 bits. */
enum { STRETCH_MAX = 1 << 14 };

struct stretch {
	const char *readable;             /* vector code may read from here on */
	const char *text;                 /* the beginning of the stretch */
	uint32_t at;                      /* the place of the next line */
	uint32_t end;                     /* the place after the last line */
	const uint16_t *next;             /* the first stop at or after `at` */
	bool usual;                       /* no byte makes its lines not usual */
	uint16_t stop[STRETCH_MAX + 128]; /* the places of the stops */
};

/* The form of usual lines, and the way to their n coordinates. */
struct walk {
	struct dialect in;
	struct byte_set stops;
	int n;
	int fields;     /* that a line has; 0: any number */
	bool one_more;  /* or one more, if it is empty and the last */
	bool by_column; /* coordinate i is in column field[i], else column i */
	int field[4];
	/* Of objects: the name of coordinate i, of size[i] bytes; and names, NULL after
	 * the last, that no member has. NULL: the usual lines are no objects. */
	const char *name[4];
	size_t size[4];
	const char *taken[8];
	bool arrays; /* the usual lines of JSON are arrays */
};

/* Sets the stops of the dialect w->in. */
void walk_set_stops(struct walk *w);

/* Begins a stretch at text and makes its index, by vector code. Returns false if it has
 * no newline before a NUL. */
bool stretch_open(struct stretch *, const struct walk *, const char *text,
    const char *end);

/* Walks up to n <= PLAIN_BATCH lines, and returns how many; 0 at the end. Stores places
 * of coordinate k in element k. Sets bit i of *left if line i has to be cut by cursors.
 */
size_t walk_lines(struct stretch *, const struct walk *, size_t n,
    struct line[PLAIN_BATCH], struct plain_places[4], uint64_t *left);

/* Reads the numbers of the n lines of walk_lines, except of those set in `left`.
 * Returns `left` plus further lines to cut by cursors; all others are points. */
uint64_t walk_numbers(const struct walk *, const struct line *, size_t n,
    const struct plain_places[4], uint64_t left, double v[4][PLAIN_BATCH]);
