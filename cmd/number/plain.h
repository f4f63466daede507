/* SPDX-License-Identifier: MIT */
/* Reads many plain numbers at a time, [-] digits [. digits]: find gives the bytes that
 * can end a number, read the values of the numbers between them. All other numbers
 * are for number_read. */
#ifndef PLAIN_H
#define PLAIN_H

#include <stddef.h>
#include <stdint.h>

#include "number.h"

/* The set of the bytes b for which low[b & 15] & high[b >> 4] is not 0. */
struct byte_set {
	uint8_t low[16], high[16];
};

enum {
	PLAIN_MAX = 32,    /* characters of a plain number */
	PLAIN_BEFORE = 33, /* bytes that are loaded before its end */
	PLAIN_BATCH = NUMBER_BATCH,
	PLAIN_GROUP = 8, /* numbers that are read together */
};

/* The places of numbers: 1 to PLAIN_MAX characters before end. */
struct plain_places {
	const char *end[PLAIN_BATCH];
	uint8_t size[PLAIN_BATCH];
};

struct plain_reader {
	/* Finds the bytes of the set in text and writes their offsets to at, which
	 * has room for 64 more than size rounded up to 64. Returns how many there
	 * are. */
	size_t (*find)(const struct byte_set *, const char *text, size_t size,
	    uint16_t *at);
	/* Reads the first n numbers, rounded to nearest. There must be places for
	 * n rounded up to PLAIN_GROUP. Returns bit i for each number i that is for
	 * number_read, whose v[i] is undefined: it is not plain, has more than 22
	 * decimals, more than 19 digits from the first that is not 0 on, or is
	 * midway between two doubles or too near to that. */
	uint64_t (*read)(const struct plain_places *, size_t n,
	    double v[PLAIN_BATCH]);
};

/* Returns the reader for the processor that number_choose chose; NULL: it has none. */
const struct plain_reader *plain_reader(void);

#endif
