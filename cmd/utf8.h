/* Characters of UTF-8. */
#ifndef UTF8_H
#define UTF8_H

/* The length of the character at s; 0 where it is none. */
int utf8_length(const char *s, const char *end);

/* Writes the character of that code, which is none of a surrogate pair, and
 * returns its length. */
int utf8_write(unsigned code, char out[4]);

#endif
