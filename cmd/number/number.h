/* SPDX-License-Identifier: MIT */
/* Decimal text to double and back. Reading rounds to the nearest double.
 * Writing gives the shortest text that reads back as the same, or rounds the
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

/* Room for the longest text of a number: sign, 309 digits, point, 100 more. */
enum { NUMBER_MAX = 416 };

struct number_style {
	enum number_kind {
		NUMBER_SHORTEST,
		NUMBER_DECIMALS,
		NUMBER_DIGITS,
	} kind;
	int n; /* decimals 0..100, or digits 1..100 */
};

/* Reads the number that begins at s: [+-] digits [. digits] [e [+-] digits],
 * a digit before or after the point, as awk reads it: no hex; or nan, inf,
 * infinity in any case. Returns where it ends, NULL if none begins at s.
 * What is beyond the range of doubles is read as inf, what is below as 0. */
const char *number_read(const char *s, const char *end, double *v);

/* Write v at s, not terminated, and return where the text ends. What is behind
 * that, up to NUMBER_MAX bytes from s, may change, too. Plain from
 * 1e-6 to below 1e21, else with an exponent, as JavaScript prints; with
 * NUMBER_DECIMALS always plain; never -0; nan and inf are "nan". */
char *number_write(char *s, double v, struct number_style style);

/* The same for a float: NUMBER_SHORTEST means the shortest that reads back as the
 * same float. */
char *number_write_float(char *s, float v, struct number_style style);

/* The text of a number that was made with many others: the digits and zeros from
 * b + first on, with a point after the first so many, size bytes in all; before them
 * a minus or none. first, minus, before and size are the bytes of layout, from the
 * lowest; it is 0 for a text that is left to number_write. None is in two lines of
 * the cache. */
struct number_text {
	char b[60];
	uint32_t layout;
} __attribute__((aligned(64)));

/* Numbers are read and written so many at a time. */
enum { NUMBER_BATCH = 64 };

/* The texts of n numbers, which are floats where single says so. There is room
 * in t and v for n rounded up to NUMBER_BATCH; what v holds there is read, and no matter.
 * points_choose chooses the loops; before, there are no texts. */
void number_texts(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t);

/* Writes v at s from its text t, or as number_write does where it has none, and
 * returns where the text ends. What is behind that, up to NUMBER_MAX bytes from s,
 * may change, too. On either side of the point of a text there are NUMBER_SIDE
 * characters at most. */
enum { NUMBER_SIDE = 24 };

static inline char *number_put(char *s, const struct number_text *t, double v,
    bool single, struct number_style style)
{
	uint32_t layout = t->layout;
	const char *from = t->b + (layout & 255);
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
