/* SPDX-License-Identifier: MIT */
/* Which known word was meant by an unknown one. */
#ifndef NEAREST_H
#define NEAREST_H

/* The one of words, which NULL ends, with the fewest edits from word: letters changed,
 * added, left out or exchanged with the next. A word of two to five letters may have
 * one edit, one of up to eight two, a longer one three. If none is so near, the first
 * that is the beginning of word or begins with it, in three letters at least; else
 * NULL. Upper case counts as lower case. */
const char *nearest(const char *word, const char *const *words);

#endif
