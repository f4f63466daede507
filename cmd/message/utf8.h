/* SPDX-License-Identifier: MIT */
/* Spans of text, and characters of UTF-8. A span borrows its bytes from its owner. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* The bytes from s to end - 1. */
struct span {
	const char *s, *end;
};

/* Sets *code to the code of the character at s. Returns the length of the character in
 * bytes, or 0 if the bytes at s are no character. */
int utf8_read(const char *s, const char *end, unsigned *code);

/* Returns how many of the first `most` bytes of a string are whole characters. */
size_t utf8_fit(const char *s, size_t most);

/* Writes a character whose code is not half of a surrogate pair. Returns its length. */
int utf8_write(unsigned code, char out[4]);
