/* SPDX-License-Identifier: MIT */
/* The formats that points come and go in: one row of a table each. */
#ifndef FORMATS_H
#define FORMATS_H

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "../message/utf8.h"

/* The last two are binary, little-endian doubles or floats in a row; the others are
 * formats of lines. */
enum format {
	FORMAT_TEXT,
	FORMAT_CSV,
	FORMAT_TSV, /* csv with tabs */
	FORMAT_JSON,
	FORMAT_F64,
	FORMAT_F32,
};

/* A format as it is read and written: never FORMAT_TSV, which is csv. */
struct dialect {
	enum format format;
	char separator; /* between fields that are added */
};

/* A field of a line, an element of a JSON array, or a member of an object. */
struct field {
	struct span
	    value; /* without blanks, quotes of csv, or the member's name */
	struct span whole; /* with quotes or name */
	struct span name;  /* a member's, with its quotes; else s is NULL */
	const char *from;  /* the separator before it begins here; NULL: none */
	const char *next;  /* the next field begins here; NULL: none */
	bool comma;        /* in text, the separator before it has a comma */
	bool open;         /* in csv, its quote is not closed */
};

/* A cursor over the fields of a line. Passed fields are not kept, so that a line
 * may have any number of them. */
struct cut {
	struct dialect in;
	const char *s, *end; /* the next field, or NULL; the line's end */
	const char *from;    /* the end of the field before */
	const char *bracket; /* in JSON, behind the one that opens */
	bool members;        /* the fields are members of a JSON object */
	bool words;          /* text whose commas may be decimal points */
	bool comma;          /* the separator that was passed last has one */
};

enum { REASON_MAX = 320 };

/* The properties of a format. */
struct format_row {
	enum format alike;        /* the format of its dialect */
	char separator;           /* 0: option --separator says it */
	size_t size;              /* bytes of a binary number; 0: of lines */
	const char *open, *close; /* brackets round a line's fields, or "" */
	const char *unknown; /* how a number that is not known is written */
	char quote;          /* round a field that needs it; 0: none */
	char escape;         /* before a quote inside of quotes */
	bool blanks;         /* blanks separate fields, too */
	bool header;         /* the first line may name the fields */

	/* Returns whether a line can be taken apart; else says why not. NULL: any
	 * can be. */
	bool (
	    *check)(struct dialect, struct span line, char reason[REASON_MAX]);
	/* Finds the field at c->s: all of it but from and the comma before it; and
	 * c->from, its end. */
	void (*next)(struct cut *c, struct field *);
	/* Reads the number at s, nan for a missing value. Returns where it ends;
	 * NULL: none begins. */
	const char *(*number)(const char *s, const char *end, double *);
	/* Returns whether a field means the same as it stands. */
	bool (*stands)(struct dialect, struct span);
};

/* Both in the order of enum format; NULL ends the names. */
extern const struct format_row format_rows[];
extern const char *const format_names[];

/* separator is what option --separator says. */
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

/* Returns the bytes of one binary point. */
static inline size_t point_size(enum format f, int coordinates)
{
	return (size_t)coordinates * format_rows[f].size;
}

/* Writes the field f of dialect in for dialect out: as it stands if it means the
 * same there, else in quotes. Returns where it ends. For each byte of f it takes six
 * at most, as in \u0001, and two for the quotes. */
char *format_convert(struct dialect in, struct dialect out, struct span f,
    char *at);

/* Returns whether a carriage return, outside of quotes, stands where more of the
 * line comes after it; says so then. */
bool format_is_old(struct dialect, struct span line, char reason[REASON_MAX]);

/* White space within a line. */
static inline bool is_blank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}

/* White space of a dialect: \v and \f are none in JSON, and in csv the separator is
 * none. */
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

/* Returns f without the blanks at its ends. */
static inline struct span trimmed(struct dialect d, struct span f)
{
	f.s = skip_blanks(d, f.s, f.end);
	while (f.end > f.s && is_blank_of(d, f.end[-1]))
		f.end--;
	return f;
}

/* Returns what follows the byte order mark that a text may begin with. */
static inline const char *skip_mark(const char *s, const char *end)
{
	return end - s >= 3 && memcmp(s, "\xef\xbb\xbf", 3) == 0 ? s + 3 : s;
}

/* Returns what follows the separator of text at s: blanks, at most one comma. */
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
