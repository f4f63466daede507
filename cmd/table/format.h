/* SPDX-License-Identifier: MIT */
/* The formats of points, in a table, and what tells the format of an input. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "../../core/refusal/refusal.h"
#include "../message/utf8.h"

enum format {
	FORMAT_TEXT,
	FORMAT_CSV,
	FORMAT_TSV, /* csv with tabs */
	FORMAT_JSON,
	FORMAT_OBJ,   /* text in which points are behind v */
	FORMAT_F64,   /* little-endian doubles; no lines, as all that follow */
	FORMAT_F32,   /* little-endian floats */
	FORMAT_SNIFF, /* not known: the input's first line tells it */
};

/* A format with its separator. The dialect of tsv is FORMAT_CSV with a tab. */
struct dialect {
	enum format format;
	char separator; /* between fields; of text only between added ones */
};

struct format_row {
	char separator;           /* 0: the user chooses it by --separator */
	size_t size;              /* bytes of a number; 0: a format of lines */
	const char *open, *close; /* what begins and ends a line of numbers, or "" */
	const char *nan_text;     /* how nan is written */
	const char *ends;         /* of names of files, with blanks between; or NULL */
	bool blanks;              /* blanks separate fields */
	bool table;               /* csv and tsv: each row has as many fields */
	bool header;              /* the first line may name the fields */
};

/* The rows and names of the formats, indexed by enum format. NULL ends the names. */
extern const struct format_row format_rows[];
extern const char *const format_names[];

/* Returns the dialect of a format. Only that of csv has the given separator. */
struct dialect dialect_of(enum format, char separator);

/* Returns the format that the end of a file's name tells, or FORMAT_SNIFF. */
enum format format_of_name(const char *name);

/* Returns the format that the first line which is neither blank nor a comment tells. */
enum format format_of_line(struct span line);

/* Returns whether the n bytes that an input begins with are those of a file of another
 * kind, such as a picture; says which. Binary points may begin with any bytes, so that
 * only .npy and what is like three Latin-1 characters in UTF-16 are told. */
bool format_is_foreign(const char *s, size_t n, bool binary, struct refusal *);

/* A .npy file of NumPy begins with these six bytes; twelve tell its header's size. */
#define NPY_MAGIC "\x93NUMPY"
enum { NPY_HEADER = 12 };

static inline const struct format_row *format_of(struct dialect d)
{
	return &format_rows[d.format];
}

static inline bool same_dialect(struct dialect a, struct dialect b)
{
	return a.format == b.format && a.separator == b.separator;
}

static inline bool format_is_binary(enum format f)
{
	return format_rows[f].size > 0;
}

static inline size_t format_point_size(enum format f, int coordinates)
{
	return (size_t)coordinates * format_rows[f].size;
}

/* Reads the number at s, or nan if [s, end) stands for a missing value, such as NA.
 * Returns the end of the number or word, or NULL if neither is at s. */
const char *format_read(struct dialect, const char *s, const char *end, double *v);

/* Says what to write instead of a field that is no number, such as 1,5; or "". */
const char *format_number_remedy(struct dialect, struct span field);

static inline bool is_blank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}

/* Returns is_blank(c), but false for \v and \f in JSON and for the separator of csv. */
static inline __attribute__((always_inline)) bool is_blank_of(struct dialect d, char c)
{
	return is_blank(c) && (d.format != FORMAT_CSV || c != d.separator) &&
	    (d.format != FORMAT_JSON || (c != '\v' && c != '\f'));
}

static inline const char *skip_blanks(struct dialect d, const char *s, const char *end)
{
	while (s < end && is_blank_of(d, *s))
		s++;
	return s;
}

static inline size_t span_size(struct span f)
{
	return (size_t)(f.end - f.s);
}

static inline bool span_is(struct span f, const char *s)
{
	return span_size(f) == strlen(s) && memcmp(f.s, s, strlen(s)) == 0;
}

/* Returns the field without the double quotes that it may have. */
static inline struct span unquoted(struct span f)
{
	if (span_size(f) > 1 && *f.s == '"' && f.end[-1] == '"')
		f = (struct span){ f.s + 1, f.end - 1 };
	return f;
}

static inline struct span trimmed(struct dialect d, struct span f)
{
	f.s = skip_blanks(d, f.s, f.end);
	while (f.end > f.s && is_blank_of(d, f.end[-1]))
		f.end--;
	return f;
}

static inline const char *skip_bom(const char *s, const char *end)
{
	return end - s >= 3 && memcmp(s, "\xef\xbb\xbf", 3) == 0 ? s + 3 : s;
}
