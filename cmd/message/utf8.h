/* SPDX-License-Identifier: MIT */
/* Spans of text, and the characters of UTF-8. */
#ifndef UTF8_H
#define UTF8_H

/* The characters from s to before end. */
struct span {
	const char *s, *end;
};

/* Reads the code of the character at s. Returns its length in bytes, or 0 if the bytes
 * there are no character. */
int utf8_read(const char *s, const char *end, unsigned *code);

/* Writes the character of a code that is not half of a surrogate pair. Returns its
 * length in bytes. */
int utf8_write(unsigned code, char out[4]);

#endif
