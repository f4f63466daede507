/* SPDX-License-Identifier: MIT */
/* Characters of UTF-8. */
#ifndef UTF8_H
#define UTF8_H

/* Reads the code of the character at s, and returns its length in bytes; 0 if what
 * stands there is none. */
int utf8_read(const char *s, const char *end, unsigned *code);

/* Writes the character with that code, which is not half of a surrogate pair,
 * and returns its length in bytes. */
int utf8_write(unsigned code, char out[4]);

#endif
