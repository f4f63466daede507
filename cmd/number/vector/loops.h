/* SPDX-License-Identifier: MIT */
/* Reads and writes many numbers at a time, by loops that are compiled once for each
 * kind of processor. The loops read plain numbers: [+-] digits [. digits], or these
 * with an exponent as %e writes it; number_read reads all other legal numbers. The
 * loops give the same bits as number_read and the same bytes as number_write. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "../number.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The text of a number. layout has four bytes, from the lowest: the digits begin at
 * chars + `first`; a minus precedes them if `minus` is 1; the point follows `before`
 * digits; the text has `size` bytes without the minus. layout is 0 if number_write has
 * to make the text. Each struct is in one line of the cache. */
struct number_text {
	char chars[60];
	uint32_t layout;
} __attribute__((aligned(64)));

enum { NUMBER_BATCH = 64 }; /* numbers that are read or written together */

/* A set of bytes: b is in the set if low[b & 15] & high[b >> 4] is not 0. */
struct byte_set {
	uint8_t low[16], high[16];
};

/* Adds a byte to a set that was 0 with *bits 0. Bytes with the same upper four bits
 * share one of 8 bits, so that at most eight such groups fit. */
static inline void byte_set_add(struct byte_set *set, int *bits, uint8_t b)
{
	uint8_t *bit = &set->high[b >> 4];

	if (*bit == 0)
		*bit = (uint8_t)(1 << (*bits)++);
	set->low[b & 15] |= *bit;
}

/* The most characters of a plain number; bytes before its end that may be read. */
enum { PLAIN_MAX = 32, PLAIN_READABLE = 37 };
enum { PLAIN_BATCH = NUMBER_BATCH, PLAIN_GROUP = 8 }; /* a group is read as a whole */

/* Number i is the size[i] characters, 1 to PLAIN_MAX, before end[i]. */
struct plain_places {
	const char *end[PLAIN_BATCH];
	uint8_t size[PLAIN_BATCH];
};

struct number_loops {
	/* Stores in `at` the indexes of the bytes of text that are in the set, but
	 * maybe not of spaces that follow two others; returns how many. `at` has room
	 * for size rounded up to a multiple of 64, plus 64. */
	size_t (*find)(const struct byte_set *, const char *text, size_t size,
	    uint16_t *at);
	/* Reads n numbers, rounded to nearest. There are places for n rounded up to a
	 * multiple of PLAIN_GROUP. Returns a mask: bit i is set if number i was not
	 * read. It is not read if it is not plain, has more than 22 decimals, has more
	 * than 22 digits after leading zeros, or is too near to the middle between two
	 * doubles. An exponent has to have a sign and two digits, and the number of
	 * decimals less the exponent has to be 0 to 22. */
	uint64_t (*read)(const struct plain_places *, size_t n, double v[PLAIN_BATCH]);
	/* Does what number_texts does. */
	void (*write)(const double *v, size_t n, bool single, struct number_style style,
	    struct number_text *t);
};

extern const struct number_loops number_loops_avx512, number_loops_avx2,
    number_loops_neon;

/* Returns the loops for the processor of kernels_chosen, or NULL if it has none. */
const struct number_loops *number_loops_chosen(void);

/* Makes the texts of n numbers, or floats (single). t and v have room for n rounded up
 * to a multiple of NUMBER_BATCH. Without number_loops all layouts become 0. */
void number_texts(const double *v, size_t n, bool single, struct number_style style,
    struct number_text *t);

/* The most characters of a struct number_text on either side of the point. */
enum { NUMBER_SIDE = 24 };

/* Copies a text that number_texts has made. Returns its end. */
static inline char *number_text_copy(char *s, const struct number_text *t)
{
	uint32_t layout = t->layout;
	const char *from = t->chars + (layout & 255);
	size_t minus = layout >> 8 & 255, before = layout >> 16 & 255;

	*s = '-';
	s += minus;
	memcpy(s, from, NUMBER_SIDE);
	s[before] = '.';
	memcpy(s + before + 1, from + before, NUMBER_SIDE);
	return s + (layout >> 24);
}

/* Writes v as number_write does, but copies its text t if number_texts has made it. */
static inline char *number_text_put(char *s, const struct number_text *t, double v,
    bool single, struct number_style style)
{
	if (__builtin_expect(t->layout == 0, 0))
		return single ? number_write_float(s, (float)v, style) :
				number_write(s, v, style);
	return number_text_copy(s, t);
}

#ifdef __cplusplus
}
#endif
