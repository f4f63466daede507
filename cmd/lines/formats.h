/* SPDX-License-Identifier: MIT */
/* The formats that points come and go in. */
#ifndef FORMAT_H
#define FORMAT_H

#include <stdbool.h>
#include <stddef.h>

/* The last two are binary, little-endian doubles or floats in a row; the others are
 * of lines. */
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
	char separator; /* of fields, or what stands for it where it is added */
};

/* separator is that of csv. */
struct dialect dialect_of(enum format, char separator);

bool same_dialect(struct dialect, struct dialect);

/* In the order of the enum, with NULL at the end. */
extern const char *const format_names[];

bool is_binary(enum format);

/* Bytes of one binary point. */
size_t point_size(enum format, int coordinates);

#endif
