/* SPDX-License-Identifier: MIT */
/* Which known word was meant by an unknown one. */
#ifndef NEAREST_H
#define NEAREST_H

/* The one of words, which NULL ends, that word is a synonym of, as opengl is of gl;
 * else that with the fewest edits from word: letters changed, added, left out or
 * exchanged with the next. A word of two to five letters may have one edit, a longer
 * one as many as a third of its letters. If none is so near, the first that is the
 * beginning of word or begins with it, in three letters at least; else NULL. Upper
 * case counts as lower case. */
const char *nearest(const char *word, const char *const *words);

#endif
