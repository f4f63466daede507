/* SPDX-License-Identifier: MIT */
/* The formats of points, in a table, and cursors over the fields of a line. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "../message/utf8.h"

enum format {
	FORMAT_TEXT,
	FORMAT_CSV,
	FORMAT_TSV, /* csv with tabs */
	FORMAT_JSON,
	FORMAT_F64, /* little-endian doubles; no lines, as all that follow */
	FORMAT_F32, /* little-endian floats */
};

/* A format with its separator. The dialect of tsv is FORMAT_CSV with a tab. */
struct dialect {
	enum format format;
	char separator; /* between fields; FORMAT_TEXT: only for added ones */
};

/* A field of a line, an element of a JSON array, or a member of an object. */
struct field {
	struct span value;        /* without name, quotes of csv and outer blanks */
	struct span whole;        /* with name; in csv with quotes and blanks */
	struct span name;         /* a member's name, quoted; else s is NULL */
	const char *previous_end; /* the end of the field before, or NULL */
	const char *next;         /* where the next field begins; NULL: none */
	bool comma;               /* FORMAT_TEXT: the separator before it has a comma */
};

struct cursor {
	struct dialect in;
	const char *s;            /* the next field, or NULL after the last */
	const char *end;          /* the end of the line */
	const char *previous_end; /* the end of the field before s, or NULL */
	const char *bracket;      /* the byte after [ or {; NULL: not JSON */
	bool members;             /* the fields are members of a JSON object */
	bool names;               /* the fields are names of a header */
	bool no_commas;           /* FORMAT_TEXT: fields end at blanks only */
	bool comma;               /* FORMAT_TEXT: the separator before s has a comma */
};

enum { REASON_MAX = 320 }; /* bytes of a message that says what is wrong */

struct format_row {
	enum format base;         /* FORMAT_CSV for tsv, else the format */
	char separator;           /* 0: the user chooses it by --separator */
	size_t size;              /* bytes of a number; 0: a format of lines */
	const char *open, *close; /* brackets around all fields, or "" */
	const char *nan_text;     /* how nan is written */
	char quote;               /* at both ends of a field; 0: no quotes */
	char escape;              /* before a quote inside of quotes */
	int nan_words;            /* how many words of format_read mean nan */
	bool blanks; /* blanks separate fields, with or without one comma */
	bool header; /* the first line may name the fields */

	/* Returns whether a line has fields; if not, writes why. NULL: it has. */
	bool (*check)(struct dialect, struct span line, char reason[REASON_MAX]);
	/* Sets the field at c->s, for cursor_next, and c->previous_end to its end. */
	void (*next)(struct cursor *c, struct field *);
};

/* The rows and names of the formats, indexed by enum format. NULL ends the names. */
extern const struct format_row format_rows[];
extern const char *const format_names[];

/* Returns the dialect of a format. Only that of csv has the given separator. */
struct dialect dialect_of(enum format, char separator);

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

/* Reads the number at s, or nan if [s, end) is a word for a missing value, such as NA.
 * Returns the end of the number or word, or NULL if neither is at s. */
const char *format_read(struct dialect, const char *s, const char *end, double *v);

/* Writes the field f of the dialect `in` as one of `out`. Returns the end of the
 * output: at most two quotes, and six bytes for each byte of f (\u0001 in JSON). */
char *format_convert(struct dialect in, struct dialect out, struct span f, char *at);

/* Converts fields of csv from c->s on, each after a separator, as format_convert does.
 * Stops before or at a field with a quote or a control character or, for FORMAT_TEXT,
 * an empty one. */
char *format_convert_plain(struct cursor *, struct dialect out, char *at);

/* Returns whether text follows a carriage return, out of quotes; if so, writes why. */
bool format_has_only_cr(struct dialect, struct span line, char reason[REASON_MAX]);

static inline bool is_blank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}

/* Returns is_blank(c), but false for \v and \f in JSON and for the separator of csv. */
static inline __attribute__((always_inline)) bool is_blank_of(struct dialect d, char c)
{
	return is_blank(c) && (d.format == FORMAT_TEXT || c != d.separator) &&
	    (d.format != FORMAT_JSON || (c != '\v' && c != '\f'));
}

static inline const char *skip_blanks(struct dialect d, const char *s, const char *end)
{
	while (s < end && is_blank_of(d, *s))
		s++;
	return s;
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

/* Returns the end of the FORMAT_TEXT separator at s: blanks with at most one comma. */
static inline const char *skip_text_separator(const char *s, const char *end)
{
	const struct dialect text = { FORMAT_TEXT, ' ' };

	s = skip_blanks(text, s, end);
	s += s < end && *s == ',';
	return skip_blanks(text, s, end);
}

/* Returns a cursor before a line's first field; a line of JSON has to be legal. */
struct cursor line_cursor(struct dialect, struct span line);

/* Returns a cursor over the fields of a JSON array or object; end is the line's end. */
struct cursor value_cursor(struct span value, const char *end);

/* Reads the next field and moves the cursor past it; returns false if there is none. */
bool cursor_next(struct cursor *, struct field *);

size_t cursor_count(struct cursor);
