/* A line with a point: where its coordinates stand, and the line with others in
 * their place. Everything else on it stays as it was. */
#ifndef LINE_H
#define LINE_H

#include <stddef.h>

#include "../number/number.h"
#include "field.h"

/* Those of a ray: a point and a direction. Of what is read, there are four. */
enum { COORDINATES_MAX = 6 };

/* From --columns: field numbers from 0, or names to be found in a header. */
struct columns {
	int n; /* 0: the first fields are the coordinates */
	int field[4];
	const char *name[4]; /* NULL where the field has a number alone */
};

/* How lines, or binary points, are laid out. */
struct layout {
	enum format in, out;
	struct columns columns;
	int reads, writes; /* coordinates */
	bool flags;        /* a word after them */
	struct number_style style;
};

/* What a line turned out to be. */
enum line_kind {
	LINE_POINT,
	LINE_COPY, /* blank, comment or header */
	LINE_BAD,
};

struct line {
	enum line_kind kind;
	struct span text;  /* without its newline */
	struct span at[4]; /* of text: where x, y, z and w stand */
	bool newline;      /* it ends in one */
	bool single;       /* the numbers written are floats */
};

enum { REASON_MAX = 200 };

/* Reads one line. Of a bad one, reason says what is wrong and what would be
 * right. Where *header, a csv header may still come; it turns the names of
 * columns into numbers. Bytes behind the line may be looked at, up to
 * readable. */
void line_read(struct layout *, struct span line, const char *readable,
    bool *header, struct line *, double v[4], char reason[REASON_MAX]);

/* The most bytes that line_write may write. */
size_t line_room(const struct layout *, const struct line *);

/* Writes a line with the new coordinates v, and flags, the word after them, or
 * NULL; returns the end. A bad line becomes v alone. Blank lines, comments and
 * headers stay, but nothing is left of them from or to JSON. */
char *line_write(const struct layout *, const struct line *,
    const double v[COORDINATES_MAX], const char *flags, char *out);

#endif
