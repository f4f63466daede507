/* SPDX-License-Identifier: MIT */
/* A line with a point: its coordinates are read, and the line is written with other
 * numbers in their place. All other bytes of the line stay.
 *
 * Most lines are simple, and walk.c finds the numbers of many of them at once. Every
 * other line goes to line_read in read.c, which alone decides what a legal line is:
 * struct cut is a cursor over the fields of the line, choose.c finds the coordinates
 * among these fields, and say.c writes what is wrong. The first line of csv
 * may be a header (header.c), which names the fields.
 *
 * in_place.h writes a line of which numbers alone change. Every other line goes to
 * line_write in splice.c, which cuts it again and copies its fields.
 *
 * A format of lines, such as csv, is a row of functions in formats.c. */
#ifndef LINE_H
#define LINE_H

#include <stddef.h>
#include <stdint.h>

#include "../number/number.h"
#include "formats.h"
#include "../number/plain.h"

/* The most numbers written for a point: a ray's position and direction. */
enum { COORDINATES_MAX = 6 };

/* The room for the name of a number that is written. */
enum { NAME_ROOM = 16 };

/* The fields that hold the coordinates, from --columns or a csv header. */
struct columns {
	int n;        /* 0: the coordinates are the first fields of a line */
	int field[4]; /* numbers of fields, from 0 */
	/* Names of columns in csv; of members in JSON, where a name that begins
	 * with / is a pointer. NULL: a number is given. Without --columns they
	 * are x, y, z and w. */
	const char *name[4];
	bool by_header; /* there is no --columns */
};

/* What comes next: the first byte of a source, its first line that is neither blank nor
 * a comment, the first row after a header, or no special line. */
enum first { FIRST_IS_READ, FIRST_LINE, FIRST_ROW, FIRST_BYTE };

/* Whether csv has a header: FIRST by --header, NONE by --no-header, else MAYBE. */
enum header { HEADER_MAYBE, HEADER_FIRST, HEADER_NONE };

/* The formats of points, and the numbers that are read and written. */
struct layout {
	struct dialect in, out;
	enum header header;
	struct columns columns;
	int reads, writes; /* the number of coordinates */
	bool flags;  /* the word of --flags is written after the numbers */
	bool append; /* the line stays, and all is written after it */
	/* The names of the numbers that are written, and last of the word of --flags;
	 * "" if the number or the word is not written. */
	char name[COORDINATES_MAX + 1][NAME_ROOM];
	size_t fields; /* of the header; 0: there is none */
	size_t most;   /* the most fields of a row of csv; 0: any number */
	bool moved; /* the last header has coordinates elsewhere than first */
	/* by a comment above the first row; n is the number of its names */
	struct columns told;
	int record; /* numbers in a binary record; 0: the coordinates alone */
	bool keeps; /* binary records are copied whole, beside the image */
	const char *two; /* a hint for points of two numbers; or NULL */
	bool single;     /* numbers are written as floats */
	struct number_style style[COORDINATES_MAX];
};

enum line_kind {
	LINE_POINT,
	LINE_COPY, /* blank, or a comment */
	LINE_HEADER,
	LINE_BAD,     /* a coordinate is wrong; the other fields are kept */
	LINE_LOST,    /* bad, and the fields are not known */
	LINE_REFUSED, /* a header, or the row after it: the source is refused */
};

/* A part of a line, in bytes from its beginning. A line has at most 64 MiB with its
 * newline; a line in a document at most 256 MiB, as the document has. */
struct part {
	uint32_t from, to;
};

struct line {
	const char *s;
	uint32_t size;     /* in bytes, without the newline */
	struct part at[4]; /* the coordinates x, y, z and w, or their names */
	enum line_kind kind;
	bool newline; /* the line ends in a newline */
	bool object;  /* the line is a JSON object */
	bool words;   /* fields of text end at blanks only: 1,5 is one field */
	bool mark;    /* the line begins with a byte order mark */
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

/* The numbers that are written in a line: number k is v[k * step], with the text
 * text[k * text_step]. */
struct numbers {
	const double *v;
	const struct number_text *text;
	size_t step, text_step;
};

/* The most bytes before an added value: a separator, and in an object its name. */
enum { ADDED_ROOM = 64 };

enum { WORD_MAX = 48 };

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

/* Returns the size of a binary record in bytes. */
static inline size_t layout_record(const struct layout *l)
{
	return point_size(l->in.format, l->record > 0 ? l->record : l->reads);
}

/* Returns the number, from 0, of the field that holds coordinate i. */
static inline int layout_field(const struct layout *l, int i)
{
	return l->columns.n > 0 ? l->columns.field[i] : i;
}

/* Returns whether the coordinates are the first fields, in their order. */
static inline bool layout_is_first(const struct layout *l)
{
	int i = 0;

	while (i < l->reads && layout_field(l, i) == i)
		i++;
	return i == l->reads;
}

/* Returns whether any coordinate is found by the name of its column or member. */
static inline bool layout_is_named(const struct layout *l)
{
	int i = 0;

	while (i < l->reads && l->columns.name[i] == NULL)
		i++;
	return i < l->reads;
}

/* Returns the name of coordinate i: x, y, z or w. */
static inline const char *coordinate_name(int i)
{
	static const char names[][2] = { "x", "y", "z", "w" };

	return names[i];
}

/* Reads a line and its coordinates v. Writes to reason what is wrong with a bad line
 * and what would be right. *first says which line this may be, and changes with it:
 * before the first line a byte order mark may stand, and in csv this line may be a
 * header, which sets the columns of the layout. */
void line_read(struct layout *, struct span text, enum first *, struct line *,
    double v[4], char reason[REASON_MAX]);

/* Writes v, number k of a point, for which number_texts made no text. nan becomes the
 * format's word for an unknown number. Returns the end of the text. */
char *line_put_rare(const struct layout *, int k, double v, char *out);

/* Returns the most bytes that line_write may touch for lines of so many bytes in all. */
size_t lines_room(const struct layout *, size_t lines, size_t bytes);

/* Writes the line with the numbers in the place of its coordinates, or by --append
 * after the line, and then the word flags unless it is NULL. Returns the end of the
 * line. A LINE_LOST becomes the numbers alone. Blank lines and comments are copied. A
 * header loses the names of coordinates that are not written, and gets the names of
 * added values; in text it becomes a comment. From JSON and to JSON, blank lines,
 * comments and headers are left out. */
char *line_write(const struct layout *, const struct line *,
    const struct numbers *, const struct word *flags, char *out);

/* Writes all fields that hold no coordinate, each after a separator of the format out.
 * From text to text without --columns, copies the text after the coordinates. Returns
 * the end of what is written: at most six bytes for each byte of the line, and three
 * for each field. */
char *line_rest(const struct layout *, const struct line *, char *out);

/* Returns a cut before the first field of a line. JSON must be checked text that begins
 * with an array or object. */
struct cut cut_line(struct dialect, struct span line);

/* Returns a cut before the first element or member of a JSON value; the line has end. */
struct cut cut_value(struct span value, const char *end);

/* Sets the next field and moves behind it. Returns false after the last field. */
bool cut_next(struct cut *, struct field *);

/* Returns the number of fields after the cut. */
size_t cut_count(struct cut);

enum { SOUGHT = 4 + COORDINATES_MAX + 1 };

/* The coordinates that choose found and, from 4 on, the names of the layout. */
struct chosen {
	struct field field[SOUGHT]; /* the first of each that was found */
	int times[SOUGHT];          /* how often it was found; 0: missing */
	/* the numbers of the fields where it was found first, and again */
	long place[SOUGHT], again[SOUGHT];
	bool mixed; /* only some separators of text have a comma */
};

/* Finds the coordinates and names in one pass over the fields of the cut. */
void choose(const struct layout *, struct cut, struct chosen *);

/* Notes where on the line the coordinates stand. */
void choose_places(const struct layout *, const struct chosen *, struct line *);

/* Returns a coordinate that lies inside the value of another, as pointers allow, or has
 * the same column; 0 if there is none. */
int choose_overlap(const struct layout *, const struct chosen *);

/* Returns whether a column of a header or a member of an object has a name that
 * --append adds, and writes the reason. */
bool choose_clashes(const struct layout *, const struct chosen *, bool members,
    char reason[REASON_MAX]);

/* Returns whether the token is the decimal number k without leading zeros. */
bool is_index(struct span token, long k);

/* Returns whether a line that begins with #, the first line or another, is a comment.
 * If not, it is a header or a row: # is a field alone, the names of all coordinates
 * follow, or a table with a header has a row such as #N/A,2,3. */
bool header_in_comment(const struct layout *, struct span text, bool first);

/* Reads the first line, whose text has no byte order mark. Returns false if the line is
 * a row. Else sets its kind to LINE_HEADER, and the layout's columns and fields; or to
 * LINE_REFUSED, with the reason. */
bool header_read(struct layout *, struct span text, struct line *,
    char reason[REASON_MAX]);

/* Returns whether a row of csv has more fields than the header has names, or than the
 * first row if no coordinate is found by name; if so, writes the reason. An empty last
 * field does not count. R writes such tables: its column of row names has no name in
 * the header, so that each name is one column too far to the left. */
bool header_is_short(struct layout *, struct cut row, enum first,
    char reason[REASON_MAX]);

/* Returns a cut before the first name of a header without a byte order mark. */
struct cut header_cut(struct dialect, struct span text);

/* Writes why the field f cannot be coordinate i; if f is empty, that it is missing. */
void say_field(const struct layout *, int i, struct span f,
    char reason[REASON_MAX]);

/* Returns whether f is an empty field of csv between blanks that separate; writes what
 * to do. */
bool say_blanks(const struct layout *, const struct field *f,
    char reason[REASON_MAX]);

/* Writes why coordinate i was not found in the cut, or found twice. */
void say_missing(const struct layout *, int i, struct cut,
    const struct chosen *, char reason[REASON_MAX]);

/* Sets the layout's told if the words of a comment name the coordinates, and these are
 * not its first words. */
void say_comment(struct layout *, struct span text);

/* Returns whether a first row can't be read without a header: the row is lost and the
 * columns have names; or the coordinates do not stand first by the header of a file
 * before, or by a comment above that has as many words as the row has fields and names
 * numbers of the row. Writes the reason; a lost row has one. */
bool say_headless(const struct layout *, struct span row, bool lost,
    char reason[REASON_MAX]);

/* Writes that the first line of text looks like a header, if none of its first fields
 * is a number. */
void say_text_header(const struct layout *, struct span line,
    const struct chosen *, char reason[REASON_MAX]);

/* Reads simple lines fast, by an index. The index lists the stops of a stretch of text:
 * the bytes that can end a field. A walk goes from stop to stop and finds the
 * coordinates without a look at the bytes between; vector code then reads many numbers
 * at once. A line that is not simple is left to line_read. */

/* The most bytes of a stretch: so few that they stay in the first-level cache until
 * their numbers are read. A stop has 16 bits. */
enum { STRETCH = 1 << 14 };

/* A stretch of text with its index. */
struct stretch {
	const char *readable; /* bytes from here on may be read */
	const char *text;     /* the beginning of the stretch */
	uint32_t at;          /* the beginning of the next line */
	uint32_t end;         /* the end of the last line */
	const uint16_t *next; /* the first stop from the byte at on */
	uint16_t stop[STRETCH + 128];
};

/* The path to each coordinate from the value that the walk is in, and the size of the
 * path's first token in bytes; SIZE_MAX if the path does not lead into this value. */
struct trail {
	const char *path[4];
	size_t size[4];
};

/* How the n coordinates of a line are found. */
struct walk {
	struct dialect in;
	struct byte_set stops;
	int n;
	int fields;           /* of each line; 0: up to most */
	int most;             /* fields of csv */
	bool arrays, objects; /* the lines of JSON that are walked */
	struct trail trail;   /* paths to members of objects */
	/* NULL, or names that a line may not have, as --append adds them */
	const char (*added)[NAME_ROOM];
	bool columns; /* coordinate i is field[i]; false: field i */
	int field[4];
};

/* Makes the walk of a layout. Returns false where every line is left to line_read. */
bool walk_plan(const struct layout *, struct walk *);

/* Makes the stretch that begins at text, and its index. Returns false where no line
 * ends in the stretch. */
bool stretch_open(struct stretch *, const struct walk *, const char *text,
    const char *end);

/* Walks up to n <= PLAIN_BATCH lines and sets the places of their numbers, by
 * coordinate. Sets bit i of *left if line i is left to line_read. Returns the number of
 * lines, at least one if at < end. */
size_t walk_lines(struct stretch *, const struct walk *, size_t n,
    struct line[PLAIN_BATCH], struct plain_places[4], uint64_t *left);

/* Reads the numbers of the n lines that walk_lines walked. Lines with a bit in left may
 * get any numbers. Returns left, and the bits of other lines that are left to
 * line_read; all other lines are points. */
uint64_t walk_numbers(const struct walk *, const struct line *, size_t n,
    const struct plain_places[4], uint64_t left, double v[4][PLAIN_BATCH]);

#endif
