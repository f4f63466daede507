/* SPDX-License-Identifier: MIT */
/* The formats of points, each a row of a table. */
#ifndef FORMATS_H
#define FORMATS_H

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "../message/utf8.h"

/* The last two are binary: sequences of little-endian doubles or floats. All others
 * are formats of lines. */
enum format {
	FORMAT_TEXT,
	FORMAT_CSV,
	FORMAT_TSV, /* csv with tabs */
	FORMAT_JSON,
	FORMAT_F64,
	FORMAT_F32,
};

/* A format with its separator. FORMAT_TSV is FORMAT_CSV with tabs. */
struct dialect {
	enum format format;
	char separator; /* between fields that are added */
};

/* A field of a line, an element of a JSON array, or a member of an object. */
struct field {
	/* without blanks around it, without the quotes of csv, without a name */
	struct span value;
	struct span whole; /* the value with quotes or name */
	struct span name;  /* of a member, with quotes; s is NULL elsewhere */
	const char *from;  /* where the separator before begins; NULL: none */
	const char *next;  /* where the next field begins; NULL: none */
	bool comma;        /* in text: the separator before has a comma */
	bool open;         /* in csv: the quote of the field is not closed */
};

/* A cursor over the fields of a line, of which there may be any number. */
struct cut {
	struct dialect in;
	const char *s, *end; /* the next field, or NULL; the line's end */
	const char *from;    /* the end of the last field, or NULL before any */
	const char *bracket; /* in JSON: after the opening bracket */
	bool members;        /* the fields are members of a JSON object */
	bool names;          /* the fields are names of a header */
	bool words;          /* fields of text end at blanks only */
	bool comma;          /* the last separator has a comma */
};

enum { REASON_MAX = 320 };

/* The properties of a format. */
struct format_row {
	enum format alike;        /* of its dialect: csv for tsv, else itself */
	char separator;           /* 0: the one of --separator */
	size_t size;              /* of a binary number; 0: a format of lines */
	const char *open, *close; /* brackets round the fields, or "" */
	const char *unknown;      /* the text of a nan */
	char quote;               /* round a field that needs it; 0: none */
	char escape;              /* before a quote inside of quotes */
	int missing; /* how many words of format_number stand for a nan */
	bool blanks; /* blanks separate fields, too */
	bool header; /* the first line may name the fields */

	/* Returns whether a line can be cut into fields; writes the reason if
	 * not. NULL: every line can. */
	bool (
	    *check)(struct dialect, struct span line, char reason[REASON_MAX]);
	/* Sets the field that begins at c->s, except its members from and comma.
	 * Sets c->from to the end of the field. */
	void (*next)(struct cut *c, struct field *);
};

/* Both are in the order of enum format; NULL ends the names. */
extern const struct format_row format_rows[];
extern const char *const format_names[];

/* Returns the dialect of a format; separator is that of --separator. */
struct dialect dialect_of(enum format, char separator);

static inline const struct format_row *format_of(struct dialect d)
{
	return &format_rows[d.format];
}

static inline bool same_dialect(struct dialect a, struct dialect b)
{
	return a.format == b.format && a.separator == b.separator;
}

static inline bool is_binary(enum format f)
{
	return format_rows[f].size > 0;
}

/* Returns the size of a binary point in bytes. */
static inline size_t point_size(enum format f, int coordinates)
{
	return (size_t)coordinates * format_rows[f].size;
}

/* Reads the number at s; a word for a missing value, such as NA, is nan. Returns where
 * the number ends, NULL if none begins. */
const char *format_number(struct dialect, const char *s, const char *end,
    double *v);

/* Writes the field f, which is of dialect in, for dialect out: copied if it means the
 * same there, else in quotes. Returns where the text ends. It has at most six bytes for
 * each byte of f, as in \u0001, and two quotes. */
char *format_convert(struct dialect in, struct dialect out, struct span f,
    char *at);

/* Returns whether the lines of a source end in carriage returns alone, so that line is
 * all of them: it has a carriage return outside of quotes before other text. If so,
 * writes the reason. */
bool format_is_old(struct dialect, struct span line, char reason[REASON_MAX]);

/* Returns whether c is white space within a line. */
static inline bool is_blank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}

/* Returns whether c is white space in a dialect: in JSON \v and \f are not, and in csv
 * the separator is not. */
static inline __attribute__((always_inline)) bool is_blank_of(struct dialect d,
    char c)
{
	return is_blank(c) && (d.format == FORMAT_TEXT || c != d.separator) &&
	    (d.format != FORMAT_JSON || (c != '\v' && c != '\f'));
}

static inline const char *skip_blanks(struct dialect d, const char *s,
    const char *end)
{
	while (s < end && is_blank_of(d, *s))
		s++;
	return s;
}

/* Returns f without white space at its ends. */
static inline struct span trimmed(struct dialect d, struct span f)
{
	f.s = skip_blanks(d, f.s, f.end);
	while (f.end > f.s && is_blank_of(d, f.end[-1]))
		f.end--;
	return f;
}

/* Returns s, after a byte order mark if one is there. */
static inline const char *skip_mark(const char *s, const char *end)
{
	return end - s >= 3 && memcmp(s, "\xef\xbb\xbf", 3) == 0 ? s + 3 : s;
}

/* Returns where the separator of text at s ends: blanks with at most one comma. */
static inline const char *skip_separator(const char *s, const char *end)
{
	while (s < end && is_blank(*s))
		s++;
	s += s < end && *s == ',';
	while (s < end && is_blank(*s))
		s++;
	return s;
}

#endif
