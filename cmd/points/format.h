/* The formats that points come and go in. */
#ifndef FORMAT_H
#define FORMAT_H

#include <stdbool.h>
#include <stddef.h>

/* The first three are of lines; the others are binary, little-endian doubles or
 * floats in a row. */
enum format { FORMAT_TEXT, FORMAT_CSV, FORMAT_JSON, FORMAT_F64, FORMAT_F32 };

/* In the order of the enum, with NULL at the end. */
extern const char *const format_names[];

bool is_binary(enum format);

/* Bytes of one binary point. */
size_t point_size(enum format, int coordinates);

#endif
