/* SPDX-License-Identifier: MIT */
/* Spans of text, characters of UTF-8, escapes, and the nearest of several words. */
#ifndef UTF8_H
#define UTF8_H

#include <stdbool.h>
#include <stddef.h>

/* The bytes from s to end - 1. */
struct span {
	const char *s, *end;
};

/* Sets *code to the code of the character at s. Returns the length of the character in
 * bytes, or 0 if the bytes at s are no character. */
int utf8_read(const char *s, const char *end, unsigned *code);

/* Writes a character whose code is not half of a surrogate pair. Returns its length. */
int utf8_write(unsigned code, char out[4]);

/* Messages show text of the user with escapes: control characters and invisible
 * characters become \u001b, and bytes that are not UTF-8 become \xff. So the text can't
 * move a terminal's cursor, end the line, or change the direction of writing. */

enum { JSON_ESCAPE_MAX = 6 }; /* bytes that one character may become */

/* Copies s[0..n) to out[0..room) with escapes. If json is true, also escapes quotes and
 * backslashes, as between the quotes of a JSON string, and writes U+FFFD for a byte
 * that is not UTF-8. A copy that does not fit is cut and ends in the string ellipsis.
 * Returns the length of the copy. */
size_t escape_copy(char *out, size_t room, const char *s, size_t n, bool json,
    const char *ellipsis);

/* escaped copies s[0..n) to out with escapes; a cut copy ends in "...". Returns out. */
enum { ESCAPED_MAX = 64 };
const char *escaped(char out[ESCAPED_MAX], const char *s, size_t n);

/* Returns the code of the first invisible character that a text has as \u..., or 0. */
unsigned escape_find_invisible(const char *);

/* Returns the word in the list `words`, which NULL ends, that `word` may mean, or NULL.
 * This is the last word of a hint of several words for `word` (synonym_of) or, if the
 * list lacks it, the word that is the fewest edits away: at most one edit if `word` has
 * two to five letters, two if six to eight, three if more. An edit changes, adds or
 * drops a letter, or swaps two neighbours. Else this is the first word that
 * begins with `word` or that `word` begins with, if the shorter of the two has at least
 * three letters. Case does not count. */
const char *nearest_word(const char *word, const char *const *words);

/* Returns whether `word` is in `words`: lower-case words with blanks between them, or
 * NULL for no words. Ignores case, _ and -: LookAt, look_at and look-at are lookat. */
bool word_is_one_of(const char *word, const char *words);

/* Returns the hint for a word of other programs, or NULL. The hint is an option
 * ("--jobs"), a call ("project -m") or a remark (": ..."); a * stands for the word.
 * If `first` is not NUL, ignores hints that do not begin with this character. */
const char *synonym_of(const char *word, char first);

#endif
