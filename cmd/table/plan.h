/* SPDX-License-Identifier: MIT */
/* The law of tables: where a source has the coordinates of its points, and which of its
 * lines are right. The options of the call and the first lines of a source make the
 * plan; then it does not change, and each line is cut, read and written by it. */
#pragma once

#include "cut.h"

enum {
	COORDINATES_MAX = 6, /* the most numbers written for a point */
	NAME_ROOM = 16,      /* bytes for the name of a written number */
	/* bytes after a line that may be read and, behind the last point of a document,
	 * written: its newline */
	LINE_MARGIN = 16,
	WORD_ROOM = 32, /* bytes for a word of a comment and a blank */
};

/* The fields that hold the coordinates, from --columns; by default those of law 3. */
struct columns {
	int n;               /* 0: by default */
	int field[4];        /* the index, from 0, of each coordinate's field */
	const char *name[4]; /* its name; NULL: use field[] */
};

/* HEADER_YES: by --header. HEADER_NONE: by --no-header. HEADER_MAYBE: by neither. */
enum header { HEADER_MAYBE, HEADER_YES, HEADER_NONE };

struct output {
	bool flags;  /* the word of --flags is written after the numbers */
	bool append; /* the line stays, and the numbers are written after it */
	bool keeps;  /* records are written whole, with new coordinates */
	bool single; /* numbers are written as floats */
	bool copies; /* lines of the input are printed, with images or without */
	/* of each written number and, last, of the word of --flags; "": no name */
	char name[COORDINATES_MAX + 1][NAME_ROOM];
	struct number_style style[COORDINATES_MAX];
	const char *space; /* of the images; or NULL */
};

/* What a source has told. */
struct plan {
	bool has_none;     /* the source has no lines but comments: no format */
	bool sniffed;      /* the first line told the format */
	bool is_list;      /* the lines are elements of a list of JSON */
	bool drops_bom;    /* another source comes before */
	bool has_header;   /* the first line named the fields */
	int field[4];      /* the index, from 0, of each coordinate's field */
	unsigned in_space; /* coordinates named S_x, S_y ..., as bits 1 << i */
	size_t fields;     /* that each row has; 0: any number */
	/* The names of the coordinates in objects; "": the first row tells none. */
	char member[4][2 * NAME_ROOM];
	/* Words of a comment, each after a blank, that are x, y and z of the row's
	 * fields from comment_field on; 0: there are none. */
	int comment_field;
	char comment[3 * WORD_ROOM + 1];
};

/* The header that the sources of a scene have in common. */
struct common_header {
	bool known; /* a source has had a line */
	char *text; /* NULL: the sources have none */
	size_t size;
};

/* A source sets `plan`, and `in` if it is sniffed; the call all other members. */
struct layout {
	struct dialect in, out;
	int reads, writes; /* numbers of a point in the input; in the output */
	enum header header;
	struct columns columns;
	int record;         /* numbers in a binary record; 0: the coordinates alone */
	const char *z_hint; /* a further remedy if z is missing; or NULL */
	const char *from;   /* the input space, such as world; or NULL */
	struct output output;
	struct common_header common;
	struct plan plan;
};

/* What of a source is read next. FIRST_LINE: the first neither blank nor a comment.
 * FIRST_ROW: the first row after a header, or after rows that can't be cut. FIRST_NONE:
 * any later line. */
enum next_part { FIRST_NONE, FIRST_LINE, FIRST_ROW, FIRST_BYTE };

/* Forgets the last source, before the next; plan.drops_bom tells whether it had
 * lines. */
void plan_begin(struct layout *);

/* Reads a line and its coordinates v. If it is wrong, says why, and how to mend it.
 * Updates *first and, before the first row is read, the plan. */
void plan_line(struct layout *, struct span text, enum next_part *first, struct line *,
    double v[4], struct refusal *);

/* Reads the comments above a list, as plan_line does those above other rows. */
void plan_comments(struct layout *, struct span text);

/* Law 8: the sources of a scene whose lines are printed have one header, or none (.s is
 * NULL). Returns LINE_HEADER if it is to be printed, LINE_SILENT if it was before,
 * LINE_POINT if there is none, and LINE_REFUSED if it is another; then says so. */
enum line_kind plan_join_header(struct layout *, struct span header, struct refusal *);

/* Sets the walk of a plan whose first row has been read. Returns false if none of its
 * lines is in a usual form. */
bool plan_walk(const struct layout *, struct walk *);

/* Returns whether v is within the range of coordinates; if not, says so. */
bool plan_in_range(const struct layout *, int i, double v, struct refusal *);

/* Returns the name of value k of the output: a number or, at COORDINATES_MAX, the
 * flags. Where the names are S_x, those of numbers are those of the output's space. */
void plan_name(const struct layout *, int k, char name[2 * NAME_ROOM]);

static inline size_t layout_record_size(const struct layout *l)
{
	return format_point_size(l->in.format, l->record > 0 ? l->record : l->reads);
}

/* Returns the field of coordinate i in a binary record. */
static inline int layout_field(const struct layout *l, int i)
{
	return l->columns.n > 0 ? l->columns.field[i] : i;
}

static inline bool layout_has_names(const struct layout *l)
{
	for (int i = 0; i < l->columns.n; i++)
		if (l->columns.name[i] != NULL)
			return true;
	return false;
}

static inline const char *coordinate_name(int i)
{
	static const char names[][2] = { "x", "y", "z", "w" };

	return names[i];
}
