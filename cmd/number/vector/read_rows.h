/* SPDX-License-Identifier: MIT */
/* Plain numbers as rows of digits, from which read_body.h makes doubles. */
#ifndef READ_ROWS_H
#define READ_ROWS_H

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "../plain.h"

/* Digits, right-aligned, the last 16 of them in low, and what the number that they
 * make is divided by. What is no digit shows as a byte above 9. */
struct rows {
	uint8_t low[PLAIN_BATCH][16], high[PLAIN_BATCH][16];
	double scale[PLAIN_BATCH];
};

/* Of the numbers of a group, PLAIN_GROUP of them. */
struct look {
	bool others; /* some of their digits are none */
	bool many;   /* some have more than 15 */
};

/* By sign and decimals. Powers up to 10^22 are doubles. With more decimals, or
 * without digits, a number is not for this reader; 32 stands for no point. */
enum { NO_POINT = 32, UNREAD = 23 };
#define NO (double)NAN
static const double power[2][NO_POINT + 1] = {
	{ 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12,
	    1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22, NO, NO,
	    NO, NO, NO, NO, NO, NO, NO, 1e0 },
	{ -1e0, -1e1, -1e2, -1e3, -1e4, -1e5, -1e6, -1e7, -1e8, -1e9, -1e10,
	    -1e11, -1e12, -1e13, -1e14, -1e15, -1e16, -1e17, -1e18, -1e19,
	    -1e20, -1e21, -1e22, NO, NO, NO, NO, NO, NO, NO, NO, NO, -1e0 },
};

#ifdef DOTS
/* The rows of a group are set one after the other. */
typedef uint8_t row __attribute__((vector_size(32)));

static inline row row_at(const void *p)
{
	row r;

	memcpy(&r, p, sizeof r);
	return r;
}

#define EIGHT 255, 255, 255, 255, 255, 255, 255, 255
static const uint8_t window[64] = { [32] = EIGHT, EIGHT, EIGHT, EIGHT };

/* The last n <= 32 bytes set. */
static inline row last(size_t n)
{
	return row_at(window + n);
}

/* Loads what stands before end twice, one byte apart: the decimals of the first
 * and the whole digits of the second are side by side, without the point. Returns
 * the digits. */
static inline row set_row(struct rows *r, size_t i, const char *end, size_t n,
    size_t *digits)
{
	row x = row_at(end - 32), before = row_at(end - 33);
	uint64_t dots = DOTS(x) & (uint32_t)(0xffffffff00000000 >> n);
	size_t decimals = (size_t)__builtin_clzll(dots << 32 | 0x80000000);
	size_t minus = end[-(ptrdiff_t)n] == '-';
	row fraction = last(decimals);

	*digits = n - minus - (dots != 0);
	x = ((x & fraction) | (before & ~fraction)) - '0';
	x &= last(*digits);
	memcpy(r->high[i], &x, 16);
	memcpy(r->low[i], (const uint8_t *)&x + 16, 16);
	r->scale[i] = power[minus][*digits == 0 ? UNREAD : decimals];
	return x;
}

static inline struct look set_group(struct rows *r, size_t i,
    const struct plain_places *at)
{
	size_t any = 0;
	row odd = { 0 };

	for (size_t end = i + PLAIN_GROUP; i < end; i++) {
		size_t digits;
		row x = set_row(r, i, at->end[i], at->size[i], &digits);

		odd |= x | (x + (128 - 10));
		any |= digits;
	}
	return (struct look){ .others = ANY_TOP_BIT(odd), .many = any > 15 };
}

static inline void set_rows(struct rows *r, struct look *look, size_t n,
    const struct plain_places *at)
{
	for (size_t i = 0; i < n; i += PLAIN_GROUP)
		look[i / PLAIN_GROUP] = set_group(r, i, at);
}
#endif

#endif
