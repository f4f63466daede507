/* SPDX-License-Identifier: MIT */
/* Reads and writes decimal text. Reading rounds to the nearest double. Writing rounds
 * the exact value, or gives the shortest text that reads back as the same number. */
#pragma once

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
	enum number_kind { NUMBER_SHORTEST, NUMBER_DECIMALS, NUMBER_DIGITS } kind;
	int n; /* 0 to 100 decimals, or 1 to 100 digits */
};

/* Reads the number that begins at s: [+-] digits [. digits] [e [+-] digits] with a
 * digit before or after the point; or nan, inf, infinity in any case. Returns its end,
 * or NULL if there is none. Too large a number is read as inf, too small a one as 0. */
const char *number_read(const char *s, const char *end, double *v);

/* These write v at s without a null byte and return the end; up to NUMBER_MAX bytes may
 * change. As in JavaScript, below 1e-6 and from 1e21 on there is an exponent, but not
 * with NUMBER_DECIMALS. -0 becomes 0; nan and inf become "nan". */
char *number_write(char *s, double v, struct number_style style);
char *number_write_float(char *s, float v, struct number_style style);

#ifdef __cplusplus
}
#endif
