/* SPDX-License-Identifier: MIT */
/* Plain numbers, [-] digits [. digits], many at a time: first where the bytes
 * stand that can end one, then what the numbers between them are. Whatever else
 * is legal is left to number_read. */
#ifndef PLAIN_H
#define PLAIN_H

#include <stddef.h>
#include <stdint.h>

#include "number.h"

/* A set of bytes: b is in it if low[b & 15] & high[b >> 4] is not 0. */
struct byte_set {
	uint8_t low[16], high[16];
};

enum {
	PLAIN_MAX = 32,    /* characters of a plain number that are read */
	PLAIN_BEFORE = 33, /* bytes before its end that are looked at */
	PLAIN_BATCH = NUMBER_BATCH,
	PLAIN_GROUP = 8, /* so many are read in one go */
};

/* Where numbers stand: before end, 1 to PLAIN_MAX characters each. */
struct plain_places {
	const char *end[PLAIN_BATCH];
	uint8_t size[PLAIN_BATCH];
};

struct plain_reader {
	/* Where in text[0] to text[size - 1] the bytes of the set stand; at has
	 * room for size rounded up to 64, and 64 more. Returns how many. */
	size_t (*find)(const struct byte_set *, const char *text, size_t size,
	    uint16_t *at);
	/* The first n numbers, rounded to nearest. Places there are for n
	 * rounded up to PLAIN_GROUP. Bit i of what it returns says that the i-th
	 * is left: it is not plain, has more than 22 decimals or, from the first
	 * that is not 0 on, 19 digits, or lies midway between two doubles or too
	 * near to that; v[i] says nothing then. */
	uint64_t (*read)(const struct plain_places *, size_t n,
	    double v[PLAIN_BATCH]);
};

/* What reads for the processor that number_choose has chosen; NULL where that is
 * the scalar code. */
const struct plain_reader *plain_reader(void);

#endif
