/* SPDX-License-Identifier: MIT */
/* Compares words as users type them, and finds what an unknown word may mean, wherever
 * it stands: on the command line, as an option's argument, as a member's name or value.
 * The table of words.c has those words of other programs that have no alias here, as
 * they mean something with another unit, order or place. */
#pragma once

#include <stdbool.h>

enum { LIST_ROOM = 512 };

/* Returns whether two names are equal but for case, and _ and - inside of them. */
bool word_equals(const char *word, const char *name);

/* Returns whether `word` equals one of `words`, which have blanks between them; NULL
 * has none. */
bool word_is_one_of(const char *word, const char *words);

/* Returns the index of a word in words[], which NULL ends: it equals the word, or one
 * of aliases[index]; aliases, or an element of it, may be NULL. Returns -1 if there is
 * none. */
int word_index(const char *word, const char *const *words, const char *const *aliases);

/* A word of other programs may stand in these places, as bits. */
enum word_place {
	WORD_COMMAND = 1, /* a command, or a topic of help */
	WORD_OPTION = 2,
	WORD_VALUE = 4,  /* the argument of an option, the string of a member */
	WORD_MEMBER = 8, /* the name of a member */
};

/* What is said of words of other programs. */
struct remark {
	unsigned places; /* where they may stand, as bits of enum word_place */
	/* The words, in lower case without _ and -, with blanks between them; and the
	 * names that the remark says to write, as `words`, or NULL. */
	const char *words, *names;
	const char *text;
};

/* Returns the remark on a word of other programs in a place, or NULL: what to write
 * instead of it. If there are several, it is that which says to write one of names[],
 * which NULL ends. Of a value no other is. `names` may be NULL. */
const struct remark *word_remark(const char *word, enum word_place place,
    const char *const *names);

/* Returns the word of words[], which NULL ends, that is nearest to `word`, itself or by
 * an alias (see word_index), if few edits make one of the other, else NULL. An edit
 * changes, adds or drops a letter, or swaps two neighbours; a word of two to five
 * letters may have one edit, of six to eight two, a longer one three. Or one begins
 * with the other, by three letters or more. */
const char *word_nearest(const char *word, const char *const *words,
    const char *const *aliases);

/* Writes a remedy for a word that is none of words[]: its remark, the nearest of them
 * ("did you mean NAME?"), which may be NULL, or all of them if there are at most
 * twelve, with `quote` before and after each. Returns out, which may be "". */
const char *word_remedy(char out[LIST_ROOM], const struct remark *, const char *near,
    const char *const *words, const char *quote);

/* Writes a remedy for the argument of an option, or the string of a member, that is
 * none of words[] or their aliases. */
const char *word_remedy_of_value(char out[LIST_ROOM], const char *word,
    const char *const *words, const char *const *aliases, const char *quote);

/* Writes words[] as a list such as "a", "b" or "c": with `quote` before and after each,
 * and `before_last`, such as " or ", before the last. Cuts the list at LIST_ROOM bytes.
 * Returns out. */
const char *words_join(char out[LIST_ROOM], const char *const *words,
    const char *before_last, const char *quote);
