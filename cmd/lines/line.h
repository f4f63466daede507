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
	FLAG_MAX = 48,       /* bytes for the word of --flags, as left+near */
	PREFIX_ROOM = 64, /* bytes for the separator and name before a value */
	/* array elements in struct chosen: 4 coordinates, then added fields */
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

/* The part of a source that is read next. FIRST_BYTE: the beginning. FIRST_LINE: the
 * first line that is neither blank nor a comment. FIRST_ROW: the first row after a
 * header. FIRST_NONE: any later line. */
enum first { FIRST_NONE, FIRST_LINE, FIRST_ROW, FIRST_BYTE };

/* HEADER_YES: by --header. HEADER_NONE: by --no-header. HEADER_MAYBE: by neither. */
enum header { HEADER_MAYBE, HEADER_YES, HEADER_NONE };

/* How points are read and written: the formats of their lines or records, the fields of
 * their coordinates, the numbers written for each point, and what is known of the
 * source so far: its header, its first row and its comments. */
struct layout {
	struct dialect in, out;
	enum header header;
	struct columns columns;
	int reads, writes; /* numbers of a point in the input; in the output */
	bool flags;  /* the word of --flags is written after the numbers */
	bool append; /* the line stays, and the numbers are written after it */
	/* The name of each written number and, last, of the word of --flags; ""
	 * for a number or word that gets no name or is not written. */
	char name[COORDINATES_MAX + 1][NAME_ROOM];
	size_t header_fields; /* fields of the header; 0: no header */
	/* fields of the header, or of a longer first row; 0: not known */
	size_t max_fields;
	bool reordered;    /* layout_in_order was false for the last header */
	size_t first_line; /* the line number of FIRST_LINE, from 1 */
	/* The columns that a # comment above the first row names. If the row has
	 * comment_names fields, and numbers in the columns of comment_numbers, then it
	 * lacks a header, and is refused with comment_reason. */
	size_t comment_names; /* 0: no names, or the coordinates are first */
	uint32_t comment_numbers; /* bit i: column i, from 0, needs a number */
	char comment_reason[REASON_MAX];
	int record; /* numbers in a binary record; 0: the coordinates alone */
	bool keeps; /* records are written whole, with new coordinates */
	const char *z_hint; /* ends the message that z is missing; or NULL */
	bool single;        /* numbers are written as floats */
	const char *from;   /* the input space, such as world; or NULL */
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
	bool no_commas; /* FORMAT_TEXT: only blanks end a field */
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
struct flags {
	char s[FLAG_MAX];
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

/* Returns whether the coordinates are the first fields, in the order x, y, z, w. */
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

/* Reads a line and its coordinates v. If the line is wrong, writes to reason why, and
 * how to mend it. *first says which part of the source the line is, and is updated for
 * the next line. The first line may begin with a byte order mark, and in csv it may be
 * a header, which sets the columns of the layout. */
void line_read(struct layout *, struct span text, enum first *, struct line *,
    double v[4], char reason[REASON_MAX]);

/* Writes v, number k of a point, for which number_texts (number.h) made no text. nan
 * becomes the nan_text of the output's format. Returns the end of the output. */
char *line_put_rare_number(const struct layout *, int k, double v, char *out);

/* Returns the room that line_write needs for `lines` lines of `bytes` bytes in all. */
size_t lines_room(const struct layout *, size_t lines, size_t bytes);

/* Writes the line with the numbers in the place of its coordinates, or by --append
 * after the line. If `flags` of the layout is set, the word of --flags follows the
 * numbers. A LINE_LOST becomes the numbers alone. Blank lines and comments are copied.
 * A header loses the names of coordinates that are not written, and gets the names of
 * added values; in FORMAT_TEXT the header becomes a comment. From JSON or to JSON,
 * leaves out blank lines, comments and headers. Returns the end of the output. */
char *line_write(const struct layout *, const struct line *,
    const struct numbers *, const struct flags *flags, char *out);

/* Writes all fields that hold no coordinate, each after a separator of the output's
 * format. If both formats are FORMAT_TEXT and --columns is not given, writes a blank
 * and the text after the coordinates. Returns the end of the output, which has at most
 * six bytes for each byte of the line plus three for each field. */
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

/* The fields that choose_fields finds: elements 0 to 3 of each array for coordinates,
 * element 4 + k for name k of the layout, if the output adds a field with this name. */
struct chosen {
	struct field field[SOUGHT_MAX]; /* the first field that is found */
	int times[SOUGHT_MAX];          /* the number of fields found */
	/* the indexes, from 0, of the first and the second field found */
	long index[SOUGHT_MAX], second_index[SOUGHT_MAX];
	bool mixed_commas; /* FORMAT_TEXT: only some separators have a comma */
};

/* Finds the fields of struct chosen in one pass over the fields after the cursor. */
void choose_fields(const struct layout *, struct cursor, struct chosen *);

/* Sets the parts of the line that hold its coordinates. */
void choose_parts(const struct layout *, const struct chosen *, struct line *);

/* Returns the index, from 0, of a coordinate whose value overlaps the value of an
 * earlier coordinate, as in the same column or JSON element; 0 if there is none. */
int chosen_overlap(const struct layout *, const struct chosen *);

/* Returns whether a column of a header or, if `members` is set, a member of an object
 * has a name that the output adds; if so, writes the reason. */
bool chosen_clashes(const struct layout *, const struct chosen *, bool members,
    char reason[REASON_MAX]);

/* Returns whether f is a name: no digit or decimal point precedes its first letter.
 * Underscores and other alphabets count as letters; signs such as U+2212 do not. */
bool choose_is_name(struct span f);

/* Returns whether a first line is a header: the fields at the indexes of coordinates
 * include at least one name and no number. */
bool choose_is_header(const struct layout *, struct cursor);

/* Returns whether a token of a JSON pointer is k in decimal, without leading zeros. */
bool is_index(struct span token, long k);

/* Returns whether a line that begins with # is a comment. In csv a first line is none
 * if # is a whole field or, without --no-header, the names of all coordinates follow #.
 * A later line such as #N/A,2,3 is none if it has as many fields as the first line. */
bool header_is_comment(const struct layout *, struct span text, bool first);

/* Forgets what the layout knows of a source. Call it before the next source. */
void layout_begin_source(struct layout *);

/* Reads the first line, whose text has no byte order mark. Returns false if the line is
 * a row. A header that can be used gets the kind LINE_HEADER, and sets the columns,
 * header_fields and max_fields. Any other header gets LINE_REFUSED and a reason. */
bool header_read(struct layout *, struct span text, struct line *,
    char reason[REASON_MAX]);

/* Returns whether a row of csv is too long: there is a header, and the row has more
 * than max_fields fields. If so, writes the reason. An empty last field does not count.
 * A longer first row raises max_fields, but not below a header if a coordinate has a
 * name, or if the row has just one field more than the header. R writes such tables,
 * without a name for the column of row names: each name is one column off. */
bool header_row_is_long(struct layout *, struct cursor row, enum first,
    char reason[REASON_MAX]);

/* Returns a cursor over the names of a header, whose text has no byte order mark. */
struct cursor header_cursor(struct dialect, struct span text);

/* Writes why the field can't be read as coordinate i, and how to mend it. */
void say_field(const struct layout *, int i, const struct field *,
    char reason[REASON_MAX]);

/* If f is an empty field of csv between blanks, writes the reason and returns true. */
bool say_empty_field(const struct layout *, struct span f,
    char reason[REASON_MAX]);

/* Writes that coordinate i was not found after the cursor, or was found twice. */
void say_missing(const struct layout *, int i, struct cursor,
    const struct chosen *, char reason[REASON_MAX]);

/* Sets comment_names, comment_numbers and comment_reason if `text`, a comment, names
 * columns. comment_names becomes 0 if the coordinates are the first columns. */
void say_comment_columns(struct layout *, struct span text);

/* Returns whether the first row lacks a header that it needs. If --columns gives names,
 * a LINE_LOST (`lost`) lacks a header, and already has a reason. Without --columns and
 * --no-header, a row lacks one if the last header, in an earlier file, reordered the
 * columns, or if the row fits comment_names and comment_numbers; then writes why. */
bool say_needs_header(const struct layout *, struct span row, bool lost,
    char reason[REASON_MAX]);

/* Writes that a first line in FORMAT_TEXT looks like a header, unless it has a = or its
 * first field is a number or NA, or the reason tells already how to mend this field. */
void say_text_header(const struct layout *, struct span line,
    char reason[REASON_MAX]);

/* walk.c reads simple lines fast, by an index of a stretch of text. The index lists the
 * stops, which are the bytes that can end a field. A walk goes from stop to stop and
 * finds the coordinates without looking at the bytes between the stops; vector code
 * then reads many numbers at once. A line that is not simple is left to line_read. */

/* The most bytes of a stretch. A stretch of this size stays in the first-level cache
 * until its numbers are read, and the place of a stop fits into 16 bits. */
enum { STRETCH_MAX = 1 << 14 };

/* A stretch of text with its index. Places are counted in bytes from text. */
struct stretch {
	const char *readable; /* vector code may read from here on */
	const char *text;     /* the beginning of the stretch */
	uint32_t at;          /* the place of the next line */
	uint32_t end;         /* the place after the last line */
	const uint16_t *next; /* the first stop at or after `at` */
	uint16_t stop[STRETCH_MAX + 128]; /* the places of the stops */
};

/* path[i] leads from a JSON value to coordinate i, by names and indexes with / between.
 * The first name or index has size[i] bytes; SIZE_MAX: coordinate i is elsewhere. */
struct paths {
	const char *path[4];
	size_t size[4];
};

/* The properties of simple lines, and the way to their n coordinates. */
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
	bool by_column; /* coordinate i is in column field[i], else column i */
	int field[4];
};

/* Sets the walk for a layout. Returns false if no line of the layout is simple. */
bool walk_plan(const struct layout *, struct walk *);

/* Begins a stretch at text and makes its index. Returns false if it has no newline. */
bool stretch_open(struct stretch *, const struct walk *, const char *text,
    const char *end);

/* Walks up to n <= PLAIN_BATCH lines. Stores the places of coordinate k of all lines in
 * element k of the plain_places. Sets bit i of *left if line i is left to line_read.
 * Returns the number of lines walked; 0 only at the end of the stretch. */
size_t walk_lines(struct stretch *, const struct walk *, size_t n,
    struct line[PLAIN_BATCH], struct plain_places[4], uint64_t *left);

/* Reads the numbers of the n lines that walk_lines walked. If bit i is set in left, the
 * numbers of line i mean nothing. Returns `left` plus the bits of further lines that
 * are left to line_read; all other lines are points. */
uint64_t walk_numbers(const struct walk *, const struct line *, size_t n,
    const struct plain_places[4], uint64_t left, double v[4][PLAIN_BATCH]);

#endif
