/* The syntax of JSON (RFC 8259), strictly, with the line of what is wrong. */
#ifndef SCAN_H
#define SCAN_H

#include <stddef.h>

/* Checks that text[0..size) is one JSON value of at most 100 levels in UTF-8,
 * or prints "projcalc: NAME:LINE: ..." and exits. A byte order mark becomes
 * blanks, and so does the tail of a number of more than 63 characters, whose
 * place its shortest equal takes. \u0000 is refused in strings. */
void syntax_check(const char *name, char *text, size_t size);

#endif
