/* SPDX-License-Identifier: MIT */
/* Reads and writes doubles as decimal text. Reading rounds to the nearest double.
 * Writing gives the shortest text that reads back as the same double, or rounds the
 * double's exact value to a number of digits. */
#ifndef NUMBER_H
#define NUMBER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Room for the longest text of a number: sign, 309 digits, point, 100 decimals. */
enum { NUMBER_MAX = 416 };

struct number_style {
	enum number_kind {
		NUMBER_SHORTEST,
		NUMBER_DECIMALS,
		NUMBER_DIGITS,
	} kind;
	int n; /* 0 to 100 decimals, or 1 to 100 digits */
};

/* Reads the number that begins at s: [+-] digits [. digits] [e [+-] digits] with a
 * digit before or after the point; or nan, inf, infinity in upper or lower case.
 * Returns the number's end, or NULL if no number begins at s. A number that is too
 * large for a double is read as inf, a number that is too small as 0. */
const char *number_read(const char *s, const char *end, double *v);

/* number_write and number_write_float write v at s without a null byte and return the
 * end. Up to NUMBER_MAX bytes from s may change. As in JavaScript, numbers below 1e-6
 * and from 1e21 on have an exponent, but not with NUMBER_DECIMALS. -0 becomes 0; nan
 * and inf become "nan". The shortest text of a float has to read back as this float. */
char *number_write(char *s, double v, struct number_style style);
char *number_write_float(char *s, float v, struct number_style style);

/* The text of a number, made by number_texts. layout has four bytes, from the lowest:
 * `first`, `minus`, `before` and `size`. The digits begin at chars + first. A minus
 * precedes them if `minus` is 1; the point follows the first `before` digits. The text
 * has `size` bytes without the minus. layout is 0 if number_write has to make the text.
 * Each struct is in one line of the cache. */
struct number_text {
	char chars[60];
	uint32_t layout;
} __attribute__((aligned(64)));

enum { NUMBER_BATCH = 64 }; /* numbers that are read or written together */

/* Makes the texts of n numbers, of floats if single is true. t and v have room for n
 * rounded up to a multiple of NUMBER_BATCH; the numbers in v after the first n are
 * ignored. If number_loops (plain.h) returns NULL, all layouts become 0. */
void number_texts(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t);

/* The most characters of a struct number_text on either side of the point. */
enum { NUMBER_SIDE = 24 };

/* Writes v as number_write does, but copies its text t if number_texts has made it. */
static inline char *number_put(char *s, const struct number_text *t, double v,
    bool single, struct number_style style)
{
	uint32_t layout = t->layout;
	const char *from = t->chars + (layout & 255);
	size_t minus = layout >> 8 & 255, before = layout >> 16 & 255;

	if (__builtin_expect(layout == 0, 0))
		return single ? number_write_float(s, (float)v, style) :
				number_write(s, v, style);
	*s = '-';
	s += minus;
	memcpy(s, from, NUMBER_SIDE);
	s[before] = '.';
	memcpy(s + before + 1, from + before, NUMBER_SIDE);
	return s + (layout >> 24);
}

#ifdef __cplusplus
}
#endif

#endif
