/* SPDX-License-Identifier: MIT */
/* Checks whether a line of points is JSON (RFC 8259). Its strings, which are only
 * copied, may hold any \u escape, and any bytes but control characters. */
#pragma once

#include <stdbool.h>

/* A line that is checked from `at` up to `end`: the caller owns it. */
struct json_check {
	const char *at; /* the next character; after an error, the wrong one */
	const char *end;
	const char *wanted; /* after an error: what is wanted at `at` */
	int level;          /* the number of open brackets */
};

/* Returns whether the line is one JSON value with at most JSON_LEVELS_MAX levels of
 * brackets. */
bool json_check(struct json_check *);
