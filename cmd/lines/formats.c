/* SPDX-License-Identifier: MIT */
#include "formats.h"

const char *const format_names[] = { "text", "csv", "tsv", "json", "f64", "f32",
	NULL };

struct dialect dialect_of(enum format f, char separator)
{
	switch (f) {
	case FORMAT_TEXT:
		return (struct dialect){ f, ' ' };
	case FORMAT_CSV:
		return (struct dialect){ f, separator };
	case FORMAT_TSV:
		return (struct dialect){ FORMAT_CSV, '\t' };
	default:
		return (struct dialect){ f, ',' };
	}
}

bool same_dialect(struct dialect a, struct dialect b)
{
	return a.format == b.format && a.separator == b.separator;
}

bool is_binary(enum format f)
{
	return f == FORMAT_F64 || f == FORMAT_F32;
}

size_t point_size(enum format f, int coordinates)
{
	return (size_t)coordinates *
	    (f == FORMAT_F64 ? sizeof(double) : sizeof(float));
}
