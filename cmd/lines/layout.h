/* SPDX-License-Identifier: MIT */
/* Where a point's coordinates stand in its line or record, and what is written there.
 * One thread at a time uses a layout before its first row; then none changes it. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "../number/number.h"
#include "formats.h"

enum {
	COORDINATES_MAX = 6, /* the most numbers written for a point */
	NAME_ROOM = 16,      /* bytes for the name of a written number */
	PREFIX_ROOM = 64,    /* bytes for the separator and name before a value */
	LINE_MARGIN = 16,    /* bytes after a line that may be read */
};

/* The fields that hold the coordinates, from --columns or a csv header. */
struct columns {
	int n;        /* 0: the coordinates are the first fields of a line */
	int field[4]; /* the index, from 0, of each coordinate's field */
	/* of each column or member; or a JSON pointer; NULL: use field[] */
	const char *name[4];
	bool by_default; /* --columns is not given */
};

/* HEADER_YES: by --header. HEADER_NONE: by --no-header. HEADER_MAYBE: by neither. */
enum header { HEADER_MAYBE, HEADER_YES, HEADER_NONE };

/* What a source has told so far, of its header, its first row and its comments. */
struct seen {
	size_t header_fields; /* fields of the header; 0: no header */
	size_t max_fields;    /* of the header or a longer first row; 0: not known */
	long long size;       /* bytes of the source; 0: unknown */
	bool reordered;       /* layout_in_order was false for the last header */
	size_t first_line;    /* the line number of FIRST_LINE, from 1 */
	/* A # comment above names columns. A first row of comment_names fields, with
	 * numbers in comment_numbers, lacks a header: it has comment_reason. */
	size_t comment_names;     /* 0: no names, or the coordinates are first */
	uint32_t comment_numbers; /* bit i: column i, from 0, needs a number */
	bool comment_list;        /* after these columns the row has a list */
	char comment_reason[REASON_MAX];
	/* The comment names no coordinates: its line, from 1, or 0. If the row has as
	 * many fields, `note` is set, as the comment may be a header all the same. */
	size_t comment_line;
	bool note;
};

struct output {
	bool flags;  /* the word of --flags is written after the numbers */
	bool append; /* the line stays, and the numbers are written after it */
	bool keeps;  /* records are written whole, with new coordinates */
	bool single; /* numbers are written as floats */
	/* of each written number and, last, of the word of --flags; "": no name */
	char name[COORDINATES_MAX + 1][NAME_ROOM];
	struct number_style style[COORDINATES_MAX];
};

/* A source sets `seen` and, by its header, `columns`; options of the call the rest. */
struct layout {
	struct dialect in, out;
	int reads, writes; /* numbers of a point in the input; in the output */
	enum header header;
	struct columns columns;
	int record;         /* numbers in a binary record; 0: the coordinates alone */
	const char *z_hint; /* ends the message that z is missing; or NULL */
	const char *from;   /* the input space, such as world; or NULL */
	struct output output;
	struct seen seen;
};

static inline size_t layout_record_size(const struct layout *l)
{
	return format_point_size(l->in.format, l->record > 0 ? l->record : l->reads);
}

static inline int layout_field(const struct layout *l, int i)
{
	return l->columns.n > 0 ? l->columns.field[i] : i;
}

/* Returns whether the coordinates are fields one after another. */
static inline bool layout_in_row(const struct layout *l)
{
	for (int i = 1; i < l->reads; i++)
		if (layout_field(l, i) != layout_field(l, 0) + i)
			return false;
	return true;
}

/* Returns whether the coordinates are the first fields. */
static inline bool layout_in_order(const struct layout *l)
{
	return layout_field(l, 0) == 0 && layout_in_row(l);
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
