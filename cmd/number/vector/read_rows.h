/* SPDX-License-Identifier: MIT */
/* Plain numbers as rows of digits, from which read_body.h makes doubles. */
#ifndef READ_ROWS_H
#define READ_ROWS_H

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "../plain.h"

/* Digits, right-aligned, and what the number that they make is divided by. What is no
 * digit shows as a byte above 9. */
struct rows {
	uint8_t digits[PLAIN_BATCH][32];
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
static const double power[] = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8,
	1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
	1e21, 1e22, NO, NO, NO, NO, NO, NO, NO, NO, NO, 1e0, -1e0, -1e1, -1e2,
	-1e3, -1e4, -1e5, -1e6, -1e7, -1e8, -1e9, -1e10, -1e11, -1e12, -1e13,
	-1e14, -1e15, -1e16, -1e17, -1e18, -1e19, -1e20, -1e21, -1e22, NO, NO,
	NO, NO, NO, NO, NO, NO, NO, -1e0 };

typedef uint8_t row __attribute__((vector_size(32)));

static inline row row_at(const void *p)
{
	row r;

	memcpy(&r, p, sizeof r);
	return r;
}

#ifndef LAST
#define LAST(n) last(n)
#define PICK(m, a, b) (((a) & (m)) | ((b) & ~(m)))
#define KEEP(m, a) ((a) & (m))
#define EIGHT 255, 255, 255, 255, 255, 255, 255, 255
static const uint8_t window[64] = { [32] = EIGHT, EIGHT, EIGHT, EIGHT };

/* The last n <= 32 bytes set. */
static inline row last(size_t n)
{
	return row_at(window + n);
}
#endif

/* Of each number: bits for the points among the 32 bytes before its end, whether it
 * has a minus, how many digits follow the point, how many there are (its size, before
 * they are counted), and where its divisor stands in power. */
struct marks {
	uint32_t points[PLAIN_BATCH], minus[PLAIN_BATCH];
	uint32_t decimals[PLAIN_BATCH], digits[PLAIN_BATCH],
	    divisor[PLAIN_BATCH];
};

typedef uint32_t counts __attribute__((vector_size(4 * PLAIN_GROUP)));
#ifndef LEADING_ZEROS
/* Of 0 or one bit; other numbers are not plain. The exponent of a float tells it. */
typedef int32_t ints __attribute__((vector_size(4 * PLAIN_GROUP)));
typedef float reals __attribute__((vector_size(4 * PLAIN_GROUP)));
#define LEADING_ZEROS(x) leading_zeros(x)
static inline counts leading_zeros(counts x)
{
	const counts zero = { 0 };
	counts e = (counts) __builtin_convertvector((ints)x, reals) >> 23 & 255;

	return ((158 - e) & (counts)(x != zero)) + (32 & (counts)(x == zero));
}
#endif

static inline counts counts_at(const uint32_t *p)
{
	counts c;

	memcpy(&c, p, sizeof c);
	return c;
}

static inline void count(struct marks *m, size_t i)
{
	const counts zero = { 0 };
	counts n = counts_at(m->digits + i), start = 32 - n;
	counts points = counts_at(m->points + i) & (~zero << start);
	counts minus = counts_at(m->minus + i);
	counts decimals = LEADING_ZEROS(points);
	counts digits = n - minus + (counts)(points != zero);
	counts none = (counts)(digits == zero);
	counts divisor = (decimals & ~none) + (none & UNREAD) +
	    minus * (NO_POINT + 1);

	memcpy(m->decimals + i, &decimals, sizeof decimals);
	memcpy(m->digits + i, &digits, sizeof digits);
	memcpy(m->divisor + i, &divisor, sizeof divisor);
}

/* Loads what stands before the end twice, one byte apart: the decimals of the first
 * and the whole digits of the second are side by side, without the point. */
static inline row set_row(struct rows *r, size_t i, const char *end,
    const struct marks *m)
{
	row x = PICK(LAST(m->decimals[i]), row_at(end - 32), row_at(end - 33));

	x = KEEP(LAST(m->digits[i]), x - '0');
	memcpy(r->digits[i], &x, sizeof x);
	r->scale[i] = power[m->divisor[i]];
	return x;
}

/* One after the other, for all numbers: what has just been stored one by one would
 * have to be waited for as a vector. */
static inline void set_rows(struct rows *r, struct look *look, size_t n,
    const struct plain_places *at)
{
	struct marks m;

	for (size_t i = 0; i < n; i++)
		m.digits[i] = at->size[i];
	for (size_t i = 0; i < n; i++) {
		row x = row_at(at->end[i] - 32);

		m.points[i] = DOTS(x);
		m.minus[i] = at->end[i][-(ptrdiff_t)at->size[i]] == '-';
	}
	for (size_t i = 0; i < n; i += PLAIN_GROUP)
		count(&m, i);
	for (size_t i = 0; i < n; i += PLAIN_GROUP) {
		uint32_t any = 0;
		row odd = { 0 };

		for (size_t k = i; k < i + PLAIN_GROUP; k++) {
			odd = LARGER(odd, set_row(r, k, at->end[k], &m));
			any |= m.digits[k];
		}
		odd |= odd + (128 - 10);
		look[i / PLAIN_GROUP] = (struct look){
			.others = ANY_TOP_BIT(odd),
			.many = any > 15,
		};
	}
}
#endif
