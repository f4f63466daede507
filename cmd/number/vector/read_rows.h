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

#endif
