/* SPDX-License-Identifier: MIT */
/* Reads lines with a point each, and writes them with other numbers in the place of the
 * coordinates. All other bytes of a line stay.
 *
 * A line is simple if walk.c can read it. Most lines are, and walk.c reads many of them
 * at once. line_read in read.c reads any line, and alone decides which lines are legal:
 * a cursor goes over the fields of the line, choose.c finds the coordinates among these
 * fields, and say.c writes what is wrong. The first line of csv may be a header, which
 * header.c reads. in_place.h writes a point if only numbers of its line change or are
 * added, and splice.c writes all other lines. */
#ifndef LINE_H
#define LINE_H

#include <stddef.h>
#include <stdint.h>

#include "../number/number.h"
#include "formats.h"
#include "../number/plain.h"

enum {
	COORDINATES_MAX = 6, /* the most numbers written for a point */
	NAME_ROOM = 16,      /* bytes for the name of a written number */
	WORD_MAX = 48,       /* the most bytes of the word of --flags */
	PREFIX_ROOM = 64, /* bytes for the separator and name before a value */
	/* fields sought in a line: the elements of arrays of struct chosen */
	SOUGHT_MAX = 4 + COORDINATES_MAX + 1,
};

/* The fields that hold the coordinates, from --columns or a csv header. */
struct columns {
	int n;        /* 0: the coordinates are the first fields of a line */
	int field[4]; /* the index, from 0, of each coordinate's field */
	/* The name of each coordinate's column or member, by default x, y, z or
	 * w; or a JSON pointer, which begins with /. NULL: use field[]. */
	const char *name[4];
	bool by_default; /* --columns is not given */
};

/* What is read next of a source. FIRST_BYTE: its beginning. FIRST_LINE: its first line
 * that is neither blank nor a comment. FIRST_ROW: the first row after a header.
 * FIRST_NONE: any later line. */
enum first { FIRST_NONE, FIRST_LINE, FIRST_ROW, FIRST_BYTE };

/* HEADER_FIRST by --header, HEADER_NONE by --no-header, else HEADER_MAYBE. */
enum header { HEADER_MAYBE, HEADER_FIRST, HEADER_NONE };

/* How points are read and written: the formats of their lines or records, the fields of
 * their coordinates, the numbers written for each point, and what is known of the
 * source so far: its header, its first row and its comments. */
struct layout {
	struct dialect in, out;
	enum header header;
	struct columns columns;
	int reads, writes; /* numbers read for each point; written for it */
	bool flags;  /* the word of --flags is written after the numbers */
	bool append; /* the line stays, and the numbers are written after it */
	/* The name of each written number and, last, of the word of --flags; ""
	 * for a number or word that gets no name or is not written. */
	char name[COORDINATES_MAX + 1][NAME_ROOM];
	size_t header_fields; /* how many the header has; 0: no header */
	/* how many the header or a longer first row has; 0: not known */
	size_t max_fields;
	bool reordered;    /* layout_in_order was false for the last header */
	size_t first_line; /* the line number of FIRST_LINE, from 1 */
	/* comment_names is the number of columns that a # comment above the first row
	 * names; 0 if no comment does, or if its first names are those of the
	 * coordinates. The first row is taken to lack a header if it has as many
	 * fields, and a number in each field i, from 0, whose bit i is set in
	 * comment_numbers. comment_reason is the message then. */
	size_t comment_names;
	uint32_t comment_numbers;
	char comment_reason[REASON_MAX];
	int record; /* numbers in a binary record; 0: the coordinates alone */
	bool keeps; /* records are written whole, with new coordinates */
	const char *two_hint; /* ends the message that z is missing; or NULL */
	bool single;          /* numbers are written as floats */
	const char *from;     /* the name of the space of points, or NULL */
	struct number_style style[COORDINATES_MAX];
};

enum line_kind {
	LINE_POINT,
	LINE_COPY, /* blank, or a comment */
	LINE_HEADER,
	LINE_BAD,     /* a coordinate is wrong; the other fields are kept */
	LINE_LOST,    /* wrong, and no field can be kept */
	LINE_REFUSED, /* a wrong header or first row: the source is refused */
};

/* The bytes [from, to) of a line. A line has at most 64 MiB, or 256 MiB in a
 * JSON document. */
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
	bool no_commas; /* only blanks end a field of text: 1,5 is one field */
	bool has_bom;   /* the line begins with a byte order mark */
};

/* Stands for the part of a coordinate that the line lacks. */
static const struct part part_missing = { 1, 0 };

static inline bool is_missing(struct part p)
{
	return p.from > p.to;
}

static inline bool line_is_bad(const struct line *line)
{
	return line->kind >= LINE_BAD;
}

/* The numbers written for a point: v[k * stride] is number k, and text[k * text_stride]
 * is its text. */
struct numbers {
	const double *v;
	const struct number_text *text;
	size_t stride, text_stride;
};

/* The word of --flags, such as left+near. */
struct word {
	char s[WORD_MAX];
	size_t size;
};

static inline struct span line_text(const struct line *line)
{
	return (struct span){ line->s, line->s + line->size };
}

/* Returns the text of coordinate i. */
static inline struct span line_field(const struct line *line, int i)
{
	return (struct span){ line->s + line->at[i].from,
		line->s + line->at[i].to };
}

static inline struct part line_part(const struct line *line, struct span f)
{
	return (struct part){ (uint32_t)(f.s - line->s),
		(uint32_t)(f.end - line->s) };
}

/* Returns the size of a binary record in bytes. */
static inline size_t record_size(const struct layout *l)
{
	return point_size(l->in.format, l->record > 0 ? l->record : l->reads);
}

/* Returns the index, from 0, of the field that holds coordinate i. */
static inline int layout_field(const struct layout *l, int i)
{
	return l->columns.n > 0 ? l->columns.field[i] : i;
}

/* Returns whether the coordinates are the first fields, in their order. */
static inline bool layout_in_order(const struct layout *l)
{
	for (int i = 0; i < l->reads; i++)
		if (layout_field(l, i) != i)
			return false;
	return true;
}

/* Returns whether any coordinate is looked up by the name of its column or member. */
static inline bool layout_has_names(const struct layout *l)
{
	for (int i = 0; i < l->reads; i++)
		if (l->columns.name[i] != NULL)
			return true;
	return false;
}

static inline const char *coordinate_name(int i)
{
	static const char names[][2] = { "x", "y", "z", "w" };

	return names[i];
}

/* Reads a line and its coordinates v. Writes to reason what is wrong with the line and
 * what would be right. *first says which line the text may be, and is set for the next
 * line. The first line may begin with a byte order mark, and in csv it may be a header,
 * which sets the columns of the layout. */
void line_read(struct layout *, struct span text, enum first *, struct line *,
    double v[4], char reason[REASON_MAX]);

/* Writes v, number k of a point, if number_texts made no text for v. nan becomes the
 * nan_text of the format. Returns the end of the output. */
char *line_put_rare_number(const struct layout *, int k, double v, char *out);

/* Returns the room that line_write needs for `lines` lines of `bytes` bytes in all. */
size_t lines_room(const struct layout *, size_t lines, size_t bytes);

/* Writes the line with the numbers in the place of its coordinates, or by --append
 * after the line. If the flags of the layout are set, the word of --flags follows the
 * numbers. A LINE_LOST becomes the numbers alone. Blank lines and comments are copied.
 * A header loses the names of coordinates that are not written, and gets the names of
 * added values; in text the header becomes a comment. From JSON or to JSON, blank
 * lines, comments and headers are left out. Returns the end of the output. */
char *line_write(const struct layout *, const struct line *,
    const struct numbers *, const struct word *flags, char *out);

/* Writes all fields that hold no coordinate, each after a separator of the output's
 * format. From text to text without --columns, copies the text after the coordinates.
 * Returns the end of the output, which has at most six bytes for each byte of the line
 * plus three for each field. */
char *line_put_rest(const struct layout *, const struct line *, char *out);

/* Returns a cursor before the first field of a line. A line of JSON has to be an array
 * or object that json_check accepts. */
struct cursor line_cursor(struct dialect, struct span line);

/* Returns a cursor over the fields of a JSON array or object; end is the line's end. */
struct cursor value_cursor(struct span value, const char *end);

/* Reads the next field and moves the cursor past it; returns false if there is none. */
bool cursor_next(struct cursor *, struct field *);

/* Returns the number of fields after the cursor. */
size_t cursor_count(struct cursor);

/* The fields that choose finds: elements 0 to 3 of each array for the coordinates, and
 * element 4 + k for name k of the layout, if the output adds a field with this name. */
struct chosen {
	struct field field[SOUGHT_MAX]; /* the first field that is found */
	int times[SOUGHT_MAX];          /* how many fields are found */
	/* the indexes, from 0, of the first and the second field found */
	long index[SOUGHT_MAX], second_index[SOUGHT_MAX];
	bool mixed_commas; /* only some separators of text have a comma */
};

/* Finds the fields of struct chosen in one pass over the fields after the cursor. */
void choose(const struct layout *, struct cursor, struct chosen *);

/* Sets the parts of the line that hold its coordinates. */
void choose_parts(const struct layout *, const struct chosen *, struct line *);

/* Returns the index, from 0, of a coordinate whose value overlaps an earlier one: they
 * share a column, or one is inside of the other in JSON. Returns 0 if there is none. */
int chosen_overlap(const struct layout *, const struct chosen *);

/* Returns whether a column of a header or a member of an object has a name that the
 * output adds; if so, writes the reason. */
bool chosen_clashes(const struct layout *, const struct chosen *, bool members,
    char reason[REASON_MAX]);

/* Returns whether f is a name: no digit or decimal point precedes its first letter. _
 * and other alphabets count as letters; signs such as U+2212 do not. */
bool choose_is_name(struct span f);

/* Returns whether a first line is a header: no field at a coordinate's index is a
 * number, and at least one is a name. */
bool choose_is_header(const struct layout *, struct cursor);

/* Returns whether the token, of a JSON pointer, is k in decimal, less leading zeros. */
bool is_index(struct span token, long k);

/* Returns whether a line that begins with # is a comment. In csv the first line is a
 * header if # is a whole field or the names of all coordinates follow #. A later line,
 * such as #N/A,2,3, is a row if it has as many fields as the header or first row. */
bool header_is_comment(const struct layout *, struct span text, bool first);

/* Forgets what the layout knows of a source. Call it before the next source. */
void layout_begin_source(struct layout *);

/* Reads the first line, whose text has no byte order mark. Returns false if the line is
 * a row. A header that can be used gets the kind LINE_HEADER, and sets the columns,
 * header_fields and max_fields. Any other header gets LINE_REFUSED and a reason. */
bool header_read(struct layout *, struct span text, struct line *,
    char reason[REASON_MAX]);

/* Returns whether a row of csv has more fields than max_fields; if so, writes the
 * reason. An empty last field does not count. A longer first row raises max_fields if
 * no coordinate has a name, unless it has one field more than the header: R writes such
 * tables, whose header lacks a name for the column of row names. */
bool header_row_is_long(struct layout *, struct cursor row, enum first,
    char reason[REASON_MAX]);

/* Returns a cursor over the names of a header, whose text has no byte order mark. */
struct cursor header_cursor(struct dialect, struct span text);

/* Writes why the field can't be read as coordinate i, and how to mend it. */
void say_field(const struct layout *, int i, const struct field *,
    char reason[REASON_MAX]);

/* Returns whether f is an empty field of csv that has a blank as separator; if so,
 * writes the reason. */
bool say_empty_field(const struct layout *, struct span f,
    char reason[REASON_MAX]);

/* Writes that coordinate i was not found after the cursor, or was found twice. */
void say_missing(const struct layout *, int i, struct cursor,
    const struct chosen *, char reason[REASON_MAX]);

/* Sets comment_names, comment_numbers and comment_reason if `text`, a comment, names
 * columns. comment_names becomes 0 if the coordinates are the first columns. */
void say_comment_columns(struct layout *, struct span text);

/* Returns whether the first row lacks a header that it needs. With --columns by name
 * this is so if the row is a LINE_LOST (`lost`), which has a reason. Otherwise it is so
 * if an earlier file had a header that reordered the columns, or if the row fits a
 * comment that names columns: then writes the reason. */
bool say_needs_header(const struct layout *, struct span row, bool lost,
    char reason[REASON_MAX]);

/* Writes that the first line of a source of text looks like a header, unless the reason
 * already has a remedy for the first field of the line. */
void say_text_header(const struct layout *, struct span line,
    char reason[REASON_MAX]);

/* walk.c reads simple lines fast, by an index of a stretch of text. The index lists the
 * stops, which are the bytes that can end a field. A walk goes from stop to stop and
 * finds the coordinates without looking at the bytes between the stops; vector code
 * then reads many numbers at once. A line that is not simple is left to line_read. */

/* The most bytes of a stretch. So few bytes stay in the first-level cache until their
 * numbers are read, and the place of a stop fits into 16 bits. */
enum { STRETCH = 1 << 14 };

/* A stretch of text with its index. Places are counted in bytes from text. */
struct stretch {
	const char *readable;         /* vector code may read from here on */
	const char *text;             /* the beginning of the stretch */
	uint32_t at;                  /* the place of the next line */
	uint32_t end;                 /* the place after the last line */
	const uint16_t *next;         /* the first stop at or after `at` */
	uint16_t stop[STRETCH + 128]; /* the places of the stops */
};

/* path[i] leads from a JSON value to coordinate i: names or indexes, with / between.
 * The first has size[i] bytes. SIZE_MAX: the coordinate is not in the value. */
struct paths {
	const char *path[4];
	size_t size[4];
};

/* What simple lines have in common, and how their n coordinates are found. */
struct walk {
	struct dialect in;
	struct byte_set stops;
	int n;
	int exact_fields; /* fields that a line must have; 0: up to max_fields */
	int max_fields;   /* the most fields of a row of csv */
	bool arrays;      /* lines may be JSON arrays */
	bool objects;     /* lines may be JSON objects */
	struct paths paths; /* the paths to the coordinates in an object */
	/* NULL or, by --append, the names that an object must not have */
	const char (*added_names)[NAME_ROOM];
	bool by_column; /* coordinate i has index field[i]; false: i */
	int field[4];
};

/* Sets the walk for a layout. Returns false if no line of the layout is simple. */
bool walk_plan(const struct layout *, struct walk *);

/* Sets the stretch at text, and its index. Returns false if no newline is in it. */
bool stretch_open(struct stretch *, const struct walk *, const char *text,
    const char *end);

/* Walks up to n <= PLAIN_BATCH lines, and sets the places of coordinate k of all lines
 * in element k of the plain_places. Sets bit i of *left if line i is left to line_read.
 * Returns the number of lines walked; 0 only at the end of the stretch. */
size_t walk_lines(struct stretch *, const struct walk *, size_t n,
    struct line[PLAIN_BATCH], struct plain_places[4], uint64_t *left);

/* Reads the numbers of the n lines that walk_lines walked. If bit i is set in left, the
 * numbers of line i mean nothing. Returns `left` plus the bits of further lines that
 * are left to line_read; all other lines are points. */
uint64_t walk_numbers(const struct walk *, const struct line *, size_t n,
    const struct plain_places[4], uint64_t left, double v[4][PLAIN_BATCH]);

#endif
