/* SPDX-License-Identifier: MIT */
/* Numbers as people type them: 1,1,1 or (1 1 1). */
#ifndef TYPED_H
#define TYPED_H

#include <stdbool.h>
#include <stddef.h>

enum { TYPED_MAX = 512 };

/* Whether a text is of numbers, and of what stands between and around them. */
bool is_numbers(const char *);

/* Adds the numbers of a text to a list of at characters, with a comma before each but
 * the first, as far as there is room. Returns how long the list is then. */
size_t add_numbers(char *list, size_t at, size_t room, const char *text);

/* Writes the numbers of words, up to the first word that has others, as JSON: a point,
 * or a list of points; or where they are not points of so many coordinates, or too
 * many, one point. Returns how many numbers they are. */
int write_points(char out[TYPED_MAX], char **words, int coordinates);

/* The same of numbers with decimal commas, "1,5 2,5". Returns whether they may be
 * such. */
bool write_decimals(char out[TYPED_MAX], char **words, int coordinates);

#endif
