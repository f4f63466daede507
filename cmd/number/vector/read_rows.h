/* SPDX-License-Identifier: MIT */
/* Makes rows of digits of plain numbers (loops.h), for read_body.h. */
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "loops.h"

/* Number i is the integer of the right-aligned digits[i], divided by divisor[i], which
 * is negative for a minus. A byte above 9 was no digit. */
struct digit_rows {
	_Alignas(64) uint8_t digits[PLAIN_BATCH][32];
	double divisor[PLAIN_BATCH];
};

/* The slower operations that a group of PLAIN_GROUP numbers needs. */
struct group_needs {
	bool digit_test;    /* a number has a character that is no digit */
	bool long_integers; /* a number has more than 15 digits */
};

/* The divisors of positive numbers, indexed by the number of decimals, or by NO_POINT
 * if there is no point; then the divisors of negative numbers. Powers of ten to 10^22
 * are doubles. With more decimals, or no digits (NO_DIGITS), the divisor is nan. */
enum { NO_POINT = 32, NO_DIGITS = 23, POWER_END = 23 };
#define BAD (double)NAN
static const double divisors[] = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9,
	1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
	BAD, BAD, BAD, BAD, BAD, BAD, BAD, BAD, BAD, 1e0, -1e0, -1e1, -1e2, -1e3, -1e4,
	-1e5, -1e6, -1e7, -1e8, -1e9, -1e10, -1e11, -1e12, -1e13, -1e14, -1e15, -1e16,
	-1e17, -1e18, -1e19, -1e20, -1e21, -1e22, BAD, BAD, BAD, BAD, BAD, BAD, BAD,
	BAD, BAD, -1e0 };

typedef uint32_t counts __attribute__((vector_size(4 * PLAIN_GROUP)));

#ifndef LAST_BYTES
/* Rows of one number. The head of read_body.h says what each macro is. */
#define LAST_BYTES(keys) last_bytes_mask(*(keys))
#define LAST_KEYS(n) (n)
#define PICK(m, a, b) (((a) & (m)) | ((b) & ~(m)))
#define KEEP(m, a) ((a) & (m))
#define ROW_BEFORE(end, n) row_at((end)[0] - (n))
#define ANY_ABOVE_9(x) any_above_9(x)
#define MASK8 255, 255, 255, 255, 255, 255, 255, 255

enum { ROW_NUMBERS = 1 };
typedef uint8_t row __attribute__((vector_size(32)));
typedef uint32_t row_mask;

static inline row row_at(const void *p)
{
	row r;

	memcpy(&r, p, sizeof r);
	return r;
}

static inline bool any_above_9(row x)
{
	x |= x + (128 - 10);
	return ANY_TOP_BIT(x);
}

static inline row last_bytes_mask(size_t n)
{
	static const uint8_t window[64] = { [32] = MASK8, MASK8, MASK8, MASK8 };

	return row_at(window + n);
}
#endif

#ifndef LEADING_ZEROS
typedef int32_t ints __attribute__((vector_size(4 * PLAIN_GROUP)));
typedef float reals __attribute__((vector_size(4 * PLAIN_GROUP)));
#define LEADING_ZEROS(x) leading_zeros(x)
/* By the exponent of x as a float. x has at most one bit set, except for two points as
 * in 1.2.3, which is no number: then any result will do. */
static inline counts leading_zeros(counts x)
{
	const counts zero = { 0 };
	counts e = (counts) __builtin_convertvector((ints)x, reals) >> 23 & 255;

	return ((158 - e) & (counts)(x != zero)) + (32 & (counts)(x == zero));
}
#endif

/* The results of the first steps of set_rows, for each number. */
struct marks {
	/* bit i: byte i of the 32 before the number's end is a point, plus or minus */
	uint32_t points[PLAIN_BATCH], pluses[PLAIN_BATCH], minuses[PLAIN_BATCH];
	/* LAST_KEYS (read_body.h) of the numbers of digits and of decimals; until
	 * count_digits is called, `digits` has the sizes of the numbers instead */
	uint32_t digits[PLAIN_BATCH], decimals[PLAIN_BATCH];
	uint32_t divisor[PLAIN_BATCH]; /* indexes of divisors[] */
};

static inline counts counts_at(const uint32_t *p)
{
	counts c;

	memcpy(&c, p, sizeof c);
	return c;
}

/* Counts for the group of numbers from i on. Returns whether one has over 15 digits. */
static inline bool count_digits(struct marks *m, size_t i)
{
	const counts zero = { 0 };
	counts n = counts_at(m->digits + i), start = 32 - n;
	counts points = counts_at(m->points + i) & (~zero << start);
	counts plus = counts_at(m->pluses + i) >> start & 1;
	counts minus = counts_at(m->minuses + i) >> start & 1;
	counts decimals = LEADING_ZEROS(points);
	counts digits = n - plus - minus + (counts)(points != zero);
	counts no_digits = (counts)(digits == zero);
	counts divisor = (decimals & ~no_digits) + (no_digits & NO_DIGITS) +
	    minus * (NO_POINT + 1);
	counts over_15 = digits + (128 - 16);
	counts digit_keys = LAST_KEYS(digits);
	counts decimal_keys = LAST_KEYS(decimals);

	memcpy(m->digits + i, &digit_keys, sizeof digit_keys);
	memcpy(m->decimals + i, &decimal_keys, sizeof decimal_keys);
	memcpy(m->divisor + i, &divisor, sizeof divisor);
	return ANY_TOP_BIT(over_15);
}

/* Sets row i to digits without the point, and returns it. Decimals come from the 32
 * bytes before a number's end, the digits before the point from one byte earlier. */
static inline row set_row(struct digit_rows *r, size_t i, const char *const *end,
    const struct marks *m)
{
	row x = PICK(LAST_BYTES(m->decimals + i), ROW_BEFORE(end, 32),
	    ROW_BEFORE(end, 33));

	x = KEEP(LAST_BYTES(m->digits + i), x - '0');
	memcpy(r->digits[i], &x, sizeof x);
	return x;
}

/* Each step has a loop of its own over all n numbers: to load a vector just after its
 * parts were stored waits for these stores. */
static inline void set_rows(struct digit_rows *r, struct group_needs *needs, size_t n,
    const struct plain_places *at)
{
	struct marks m;

	for (size_t i = 0; i < n; i++)
		m.digits[i] = at->size[i];
	for (size_t i = 0; i < n; i += ROW_NUMBERS) {
		row x = ROW_BEFORE(at->end + i, 32);
		row_mask points = MATCH(x, '.'), pluses = MATCH(x, '+');
		row_mask minuses = MATCH(x, '-');

		memcpy(m.points + i, &points, sizeof points);
		memcpy(m.pluses + i, &pluses, sizeof pluses);
		memcpy(m.minuses + i, &minuses, sizeof minuses);
	}
	for (size_t i = 0; i < n; i += PLAIN_GROUP)
		needs[i / PLAIN_GROUP].long_integers = count_digits(&m, i);
	for (size_t i = 0; i < n; i++)
		r->divisor[i] = divisors[m.divisor[i]];
	for (size_t i = 0; i < n; i += PLAIN_GROUP) {
		row most = { 0 };

		for (size_t k = i; k < i + PLAIN_GROUP; k += ROW_NUMBERS)
			most = LARGER(most, set_row(r, k, at->end + k, &m));
		needs[i / PLAIN_GROUP].digit_test = ANY_ABOVE_9(most);
	}
}
