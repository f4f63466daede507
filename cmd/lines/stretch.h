/* SPDX-License-Identifier: MIT */
/* A stretch of text with an index of its stops, which are the bytes that can end a field
 * or make a line not simple. Vector code makes the index. The text is the caller's. */
#pragma once

#include "../number/vector/loops.h"
#include "formats.h"

/* It stays in the first-level cache, and the place of a stop fits into 16 bits. */
enum { STRETCH_MAX = 1 << 14 };

struct stretch {
	const char *readable;             /* vector code may read from here on */
	const char *text;                 /* the beginning of the stretch */
	uint32_t at;                      /* the place of the next line */
	uint32_t end;                     /* the place after the last line */
	const uint16_t *next;             /* the first stop at or after `at` */
	uint16_t stop[STRETCH_MAX + 128]; /* the places of the stops */
};

struct byte_set stretch_stops(struct dialect);

/* Begins a stretch at text and makes its index. Returns false if it has no
 * newline before a NUL. */
bool stretch_open(struct stretch *, const struct byte_set *stops, const char *text,
    const char *end);
