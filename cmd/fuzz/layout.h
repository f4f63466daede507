/* SPDX-License-Identifier: MIT */
/* The layout of lines that the first bytes of a fuzzer's input choose. */
#pragma once

#include <stdint.h>

#include "../table/emit.h"

enum { HEADER = 4, FORMATS = FORMAT_SNIFF + 1 };

/* Returns the layout that the HEADER bytes at b choose. The first three bytes choose
 * formats, counts, style, header and columns; the last bit of all chooses the separator
 * of csv. The other bits are for the caller. */
static inline struct layout layout_of(const uint8_t *b)
{
	static const int sizes[][2] = { { 3, 3 }, { 3, 4 }, { 4, 3 }, { 2, 2 },
		{ 2, 6 }, { 4, 4 } };
	static const int fields[][4] = { { 0, 1, 2, 3 }, { 3, 2, 1, 0 }, { 1, 0, 2, 5 },
		{ 9, 4, 0, 2 } };
	static const char *const names[] = { "x", "y", "z", "w" };
	static const char separators[] = ",;";
	const int *size = sizes[b[1] % 6], out = b[0] / FORMATS % FORMATS;
	struct layout l = {
		.in = dialect_of((enum format)(b[0] % FORMATS), separators[b[3] & 1]),
		.out = dialect_of(out == FORMAT_SNIFF ? FORMAT_TEXT : (enum format)out,
		    separators[b[3] & 1]),
		.header = (enum header)(b[1] / 72 % 3),
		.reads = size[0],
		.writes = size[1],
		.output.flags = b[1] / 6 & 1,
		.from = "a",
		.output.space = "b",
		.output.copies = true,
	};
	static const char *const written[] = { "x", "y", "z", "w", "v", "u" };
	enum format in = l.in.format;
	int columns = b[1] / 12 % 6;

	for (int k = 0; k < COORDINATES_MAX; k++) {
		l.output.style[k].kind = b[2] % 3;
		if (k < l.writes)
			strcpy(l.output.name[k], written[k]);
		l.output.style[k].n = b[2] / 4 % 3 == 1 ? 100 : 1 + (b[2] + k) % 17;
	}
	strcpy(l.output.name[COORDINATES_MAX], l.output.flags ? "flags" : "");
	if (format_is_binary(in) || columns == 0)
		return l;
	l.columns.n = l.reads;
	for (int i = 0; i < l.reads; i++) {
		l.columns.field[i] = fields[columns & 3][i];
		if (columns > 3 && in != FORMAT_OBJ)
			l.columns.name[i] = names[i];
	}
	return l;
}
