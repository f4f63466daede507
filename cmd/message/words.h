/* SPDX-License-Identifier: MIT */
/* What an unknown word may mean: the nearest of the words that are known in its place,
 * or the hint of a table of words that other programs use. */
#ifndef WORDS_H
#define WORDS_H

#include <stdbool.h>

/* Returns the word in the list `words`, which NULL ends, that `word` may mean, or NULL.
 * This is the last word of a hint of several words for `word` (word_hint) or, if the
 * list lacks it, the word that is the fewest edits away: at most one edit if `word` has
 * two to five letters, two if six to eight, three if more. An edit changes, adds or
 * drops a letter, or swaps two neighbours. Else this is the first word that
 * begins with `word` or that `word` begins with, if the shorter of the two has at least
 * three letters. Case does not count. */
const char *word_nearest(const char *word, const char *const *words);

/* Returns whether `word` is in `words`: lower-case words with blanks between them, or
 * NULL for no words. Ignores case, _ and -: LookAt, look_at and look-at are lookat. */
bool word_is_one_of(const char *word, const char *words);

/* Returns the hint for a word of other programs, or NULL. The hint is an option
 * ("--jobs"), a call ("project -m") or a remark (": ..."); a * stands for the word.
 * If `first` is not NUL, ignores hints that do not begin with this character. */
const char *word_hint(const char *word, char first);

#endif
