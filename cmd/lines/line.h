/* SPDX-License-Identifier: MIT */
/* Reads lines with a point each, and writes them with other numbers in the place of the
 * coordinates. All other bytes of a line stay.
 *
 * Most lines are simple, and walk.c finds the numbers of many simple lines at once.
 * line_read in read.c reads every other line, and alone decides what a legal line is:
 * a cursor goes over the fields of the line, choose.c finds the coordinates among these
 * fields, and say.c writes what is wrong. The first line of csv may be a header, which
 * header.c reads. in_place.h writes a line of which only numbers change, and splice.c
 * writes every other line. */
#ifndef LINE_H
#define LINE_H

#include <stddef.h>
#include <stdint.h>

#include "../number/number.h"
#include "formats.h"
#include "../number/plain.h"

enum {
	COORDINATES_MAX = 6, /* numbers written for a point: a ray's are 6 */
	NAME_ROOM = 16,      /* bytes for the name of a written number */
	WORD_MAX = 48,       /* bytes of the word of --flags */
	PREFIX_ROOM = 64,    /* bytes for separator and name before a value */
	SOUGHT = 4 + COORDINATES_MAX + 1, /* things in struct chosen */
};

/* The fields that hold the coordinates, from --columns or a csv header. */
struct columns {
	int n;        /* 0: the coordinates are the first fields of a line */
	int field[4]; /* the number of each coordinate's field, from 0 */
	/* The name of each coordinate's column or member, by default x, y, z, w. A
	 * name of JSON that begins with / is a pointer. NULL: by number. */
	const char *name[4];
	bool by_default; /* --columns is not given */
};

/* What is read next of a source: its first byte, its first line that is neither blank
 * nor a comment, the first row after a header, or NONE of the three. */
enum first { FIRST_NONE, FIRST_LINE, FIRST_ROW, FIRST_BYTE };

/* HEADER_FIRST: --header, HEADER_NONE: --no-header, else HEADER_MAYBE. */
enum header { HEADER_MAYBE, HEADER_FIRST, HEADER_NONE };

/* The formats of points, and the numbers that are read and written. */
struct layout {
	struct dialect in, out;
	enum header header;
	struct columns columns;
	int reads, writes; /* the numbers read of a point, and written for it */
	bool flags;  /* the word of --flags is written after the numbers */
	bool append; /* the line stays, and the numbers are written after it */
	/* names of the written numbers and, last, of the word of --flags; or "" */
	char name[COORDINATES_MAX + 1][NAME_ROOM];
	size_t header_fields; /* 0: there is no header */
	size_t
	    max_fields; /* of the header or a longer first row; 0: not known */
	bool reordered; /* in the last header field i is not coordinate i */
	size_t first_line; /* the number of the first line, from 1 */
	/* a first row with as many fields as a comment names is refused; 0: none */
	size_t comment_names;
	uint32_t
	    comment_numbers; /* bit i is set if field i is to be a number */
	char comment_reason[REASON_MAX];
	int record; /* numbers in a binary record; 0: the coordinates alone */
	bool keeps; /* the output keeps binary records, and adds the images */
	const char *two_hint; /* for points of two numbers; or NULL */
	bool single;          /* numbers are written as floats */
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

/* The bytes [from, to) of a line, which has at most 256 MiB, in a document. */
struct part {
	uint32_t from, to;
};

struct line {
	const char *s;     /* the beginning of the line */
	uint32_t size;     /* in bytes, without the newline */
	struct part at[4]; /* where x, y, z and w, or their names, are */
	enum line_kind kind;
	bool newline;   /* the line ends in a newline */
	bool object;    /* the line is a JSON object */
	bool no_commas; /* only blanks end a field of text: 1,5 is one */
	bool has_bom;   /* the line begins with a byte order mark */
};

/* The part of a coordinate that a line lacks. */
static const struct part part_missing = { 1, 0 };

static inline bool is_missing(struct part p)
{
	return p.from > p.to;
}

static inline bool line_is_bad(const struct line *line)
{
	return line->kind >= LINE_BAD;
}

/* The written numbers: number k is v[k * stride], with digits text[k * text_stride]. */
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

/* Returns the number of the field that holds coordinate i, from 0. */
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

/* Returns the name of coordinate i: x, y, z or w. */
static inline const char *coordinate_name(int i)
{
	static const char names[][2] = { "x", "y", "z", "w" };

	return names[i];
}

/* Reads a line and its coordinates v. Writes to reason what is wrong with a line and
 * what would be right. *first says which line this may be, and is set for the next
 * line. The first line may begin with a byte order mark, and in csv it may be a header,
 * which sets the columns of the layout. */
void line_read(struct layout *, struct span text, enum first *, struct line *,
    double v[4], char reason[REASON_MAX]);

/* Writes v, which is number k of a point and has no digits by number_texts. nan becomes
 * the format's nan_text. Returns the end of the output. */
char *line_put_rare_number(const struct layout *, int k, double v, char *out);

/* Returns the room that line_write needs for lines of so many bytes together. */
size_t lines_room(const struct layout *, size_t lines, size_t bytes);

/* Writes the line with the numbers in the place of its coordinates, or by --append
 * after the line. The word of --flags follows the numbers unless flags is NULL. A
 * LINE_LOST becomes the numbers alone. Blank lines and comments are copied. A header
 * loses the names of coordinates that are not written, and gets the names of added
 * values; in text the header becomes a comment. From JSON or to JSON, blank lines,
 * comments and headers are left out. Returns the end of the output. */
char *line_write(const struct layout *, const struct line *,
    const struct numbers *, const struct word *flags, char *out);

/* Writes all fields that hold no coordinate, each after a separator of the output's
 * format. From text to text without --columns, copies the text after the coordinates.
 * Returns the end of the output, which has at most six bytes for each byte of the line,
 * and three more for each field. */
char *line_put_rest(const struct layout *, const struct line *, char *out);

/* Returns a cursor before the first field of a line, which its format takes. */
struct cursor line_cursor(struct dialect, struct span line);

/* Returns a cursor over a JSON array or object in a line that ends at end. */
struct cursor value_cursor(struct span value, const char *end);

/* Sets the next field and moves the cursor past it; returns false if there is none. */
bool cursor_next(struct cursor *, struct field *);

/* Returns the number of fields after the cursor. */
size_t cursor_count(struct cursor);

/* What choose looks for and finds: things 0 to 3 are the coordinates, and thing 4 + k
 * is a field with the name k of the layout, which the output adds. */
struct chosen {
	struct field field[SOUGHT]; /* the first field of each thing */
	int times[SOUGHT];          /* the number of its fields */
	/* the numbers of its first and second field, from 0 */
	long index[SOUGHT], second_index[SOUGHT];
	bool mixed_commas; /* only some separators of text have a comma */
};

/* Finds all things of struct chosen in one pass over the fields after the cursor. */
void choose(const struct layout *, struct cursor, struct chosen *);

/* Sets the parts of the line that are its coordinates. */
void choose_parts(const struct layout *, const struct chosen *, struct line *);

/* Returns a coordinate that shares its column with another coordinate or whose JSON
 * pointer leads into, or around, the value of another; 0 if there is none. */
int choose_overlap(const struct layout *, const struct chosen *);

/* Returns whether a column or member has a name that the output adds; says which. */
bool choose_clashes(const struct layout *, const struct chosen *, bool members,
    char reason[REASON_MAX]);

/* Returns whether the first line is no row: no coordinate is a number, and not all are
 * missing values such as NA, or begin with a digit, as 1,5 does. */
bool choose_is_header(const struct layout *, struct cursor);

/* Returns whether the token is the number k in decimal, without leading zeros. */
bool is_index(struct span token, long k);

/* Returns whether a line that begins with # is a comment. The first line is a header if
 * # is a field alone or the names of all coordinates follow #. A later line, such as
 * #N/A,2,3, is a row if it has as many fields as the header or the first row. */
bool header_is_comment(const struct layout *, struct span text, bool first);

/* Reads the first line, whose text has no byte order mark. Returns false if the line is
 * a row. A good header gets the kind LINE_HEADER and sets the layout's columns and
 * numbers of fields; another header gets LINE_REFUSED and a reason. */
bool header_read(struct layout *, struct span text, struct line *,
    char reason[REASON_MAX]);

/* Returns whether a row of csv has more fields than max_fields, and writes the reason.
 * A longer first row raises max_fields if no coordinate has a name. An empty last field
 * does not count. R writes such tables: the header lacks a name for the column of row
 * names, so that each name is one column too far to the left. */
bool header_row_is_long(struct layout *, struct cursor row, enum first,
    char reason[REASON_MAX]);

/* Returns a cursor over the names of a header, whose text has no byte order mark. */
struct cursor header_cursor(struct dialect, struct span text);

/* Writes why f is not coordinate i; an empty f is a missing coordinate. */
void say_field(const struct layout *, int i, struct span f,
    char reason[REASON_MAX]);

/* Returns whether f is an empty field between blanks of csv, and writes the reason. */
bool say_empty_field(const struct layout *, struct span f,
    char reason[REASON_MAX]);

/* Writes that coordinate i was not found after the cursor, or was found twice. */
void say_missing(const struct layout *, int i, struct cursor,
    const struct chosen *, char reason[REASON_MAX]);

/* Sets comment_names if a comment names columns, of which the first may be wrong. */
void say_note_columns(struct layout *, struct span text);

/* Returns whether a first row can't be read without a header, and writes the reason:
 * the header of a file before reordered the columns, or a comment names as many
 * columns. With --columns by name: the row is lost, and has a reason already. */
bool say_needs_header(const struct layout *, struct span row, bool lost,
    char reason[REASON_MAX]);

/* Writes that the first line of text looks like a header. */
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
	const char *readable;         /* the bytes from here on may be read */
	const char *text;             /* the beginning of the stretch */
	uint32_t at;                  /* the place of the next line */
	uint32_t end;                 /* the place after the last line */
	const uint16_t *next;         /* the first stop that is not before at */
	uint16_t stop[STRETCH + 128]; /* the places of the stops */
};

/* The path of names or indexes from a JSON value to each coordinate, and the bytes of
 * the path's first name or index; SIZE_MAX if the coordinate is not in the value. */
struct paths {
	const char *path[4];
	size_t size[4];
};

/* What simple lines have in common, and how their n coordinates are found. */
struct walk {
	struct dialect in;
	struct byte_set stops;
	int n;
	int exact_fields;   /* the fields of each line; 0: up to max_fields */
	int max_fields;     /* the most fields of a row of csv */
	bool arrays;        /* lines may be JSON arrays */
	bool objects;       /* lines may be JSON objects */
	struct paths paths; /* the paths to the coordinates in an object */
	/* NULL or, by --append, the names that an object may not have yet */
	const char (*added_names)[NAME_ROOM];
	bool by_column; /* coordinate i is field[i]; false: field i */
	int field[4];
};

/* Sets the walk for a layout. Returns false if no line of the layout is simple. */
bool walk_plan(const struct layout *, struct walk *);

/* Sets the stretch that begins at text, and its index. Returns false without a line. */
bool stretch_open(struct stretch *, const struct walk *, const char *text,
    const char *end);

/* Walks up to n <= PLAIN_BATCH lines, and sets the places of coordinate k of all lines
 * in element k of the plain_places. Sets bit i of *left if line i is left to line_read.
 * Returns the number of lines, which is at least one if at < end. */
size_t walk_lines(struct stretch *, const struct walk *, size_t n,
    struct line[PLAIN_BATCH], struct plain_places[4], uint64_t *left);

/* Reads the numbers of the n lines that walk_lines walked. A line whose bit is set in
 * left gets any numbers. Returns left with the bits of further lines that are left to
 * line_read; all other lines are points. */
uint64_t walk_numbers(const struct walk *, const struct line *, size_t n,
    const struct plain_places[4], uint64_t left, double v[4][PLAIN_BATCH]);

#endif
