/* A line of points: where its coordinates stand, and the line that goes out.
 * Everything that is not a coordinate stays as it was. */
#ifndef RECORD_H
#define RECORD_H

#include <stddef.h>

#include "../number/number.h"
#include "field.h"

/* Of a coordinate. */
#define MAGNITUDE_MAX 1e150

enum { COORDINATES_MAX = 6 }; /* four in; a ray's point and direction out */

/* From --columns: field numbers from 0, or names to be found in a header. */
struct columns {
	int n; /* 0: the first ones */
	int field[4];
	const char *name[4]; /* or NULL where field holds */
};

struct layout {
	enum format in, out;
	struct columns columns;
	int reads, writes; /* coordinates */
	bool flags;        /* a word after them */
	struct number_style style;
};

/* What a line turned out to be. */
enum record_kind {
	RECORD_POINT,
	RECORD_COPY, /* blank, comment or header */
	RECORD_BAD,
};

struct record {
	enum record_kind kind;
	struct span line;  /* without its newline */
	struct span at[4]; /* the coordinates, in their own order */
	bool newline;
	bool single; /* the numbers written are floats */
};

enum { REASON_MAX = 200 };

/* Reads one line. RECORD_BAD writes what is wrong and what would be right to
 * reason. *header says that a csv header may still come, and then resolves
 * the names of columns. Bytes up to readable may be looked at. */
void record_read(struct layout *, struct span line, const char *readable,
    bool *header, struct record *, double v[4], char reason[REASON_MAX]);

/* The most bytes that a record's line can become. */
size_t record_room(const struct layout *, const struct record *);

/* Write a record's line and return its end; v are the new coordinates, flags
 * the word after them or NULL. */
char *record_write(const struct layout *, const struct record *,
    const double v[COORDINATES_MAX], const char *flags, char *out);

#endif
