/* SPDX-License-Identifier: MIT */
/* Numbers as people type them: 1,1,1 or (1 1 1). */
#ifndef TYPED_H
#define TYPED_H

#include <stdbool.h>
#include <stddef.h>

/* Whether a text is of numbers, and of what stands between and around them. */
bool is_numbers(const char *);

/* Adds the numbers of a text to a list of at characters, with a comma before each but
 * the first, as far as there is room. Returns how long the list is then. */
size_t add_numbers(char *list, size_t at, size_t room, const char *text);

#endif
