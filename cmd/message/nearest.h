/* SPDX-License-Identifier: MIT */
/* The known word that an unknown one may stand for. */
#ifndef NEAREST_H
#define NEAREST_H

#include <stdbool.h>

/* Returns the one of words, which NULL ends, with the fewest edits from word. An edit
 * changes, adds or drops a letter, or exchanges it with the next. A word of two to five
 * letters may have one edit, one of up to eight two, a longer one three. If no word is
 * so near, returns the first that begins with word or with which word begins, in three
 * letters at least; else NULL. Upper case counts as lower case. */
const char *nearest_word(const char *word, const char *const *words);

/* Returns whether a word is one of words, which stand in lower case with blanks between
 * them. The word's case and its _ and - do not count: LookAt, look_at and look-at are
 * lookat. */
bool word_is_one_of(const char *word, const char *words);

#endif
