/* SPDX-License-Identifier: MIT */
/* This module finds what an unknown word may mean, wherever it stands: on the command
 * line, as the argument of an option, as the name of a member or as its value. Who
 * reads the word offers all meanings to a struct word_guess, which keeps the remedy of
 * the closest, for the end of one message. The table of words.c has words of other
 * programs that are no aliases in the tables of members. */
#pragma once

#include <stdbool.h>

enum { LIST_ROOM = 512, REMEDY_ROOM = LIST_ROOM + 64 };

/* These tell how close a word is to a meaning. */
enum {
	WORD_ELSE = 1, /* is not; the remedy is for words without meaning */
	WORD_BEGINS,   /* one begins with the other, by three letters or more */
	WORD_EDITED,   /* three edits apart; + 1: two; + 2: one; + 3: equal */
	WORD_KNOWN = WORD_EDITED + 4, /* an alias, or a word with a hint */
};

struct word_guess {
	const char *word;
	int closeness;            /* of the remedy; 0: there is none */
	char remedy[REMEDY_ROOM]; /* such as "did you mean --to?" */
};

/* Sets the remedy if its meaning is closer than those offered before. */
void word_offer(struct word_guess *, int closeness, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Offers each of words[], which NULL ends, by a format with one %s. */
void word_offer_list(struct word_guess *, const char *const *words, const char *format);

/* Returns how close `word` is to `name`, or 0. An edit changes, adds or drops a letter,
 * or swaps two neighbours; a word of two to five letters may have one edit, of six to
 * eight two, a longer one three. Case does not count. */
int word_closeness(const char *word, const char *name);

/* Returns whether `word` is in `words`: words with blanks between them, or NULL for no
 * words. Ignores _ and -, and case but of capitals in `words`: LookAt, look_at and
 * look-at are lookat, and p2 is not P2. */
bool word_is_one_of(const char *word, const char *words);

/* A word of other programs may stand in these places, as bits. */
enum word_place {
	WORD_COMMAND = 1, /* a command, or a topic of help */
	WORD_OPTION = 2,
	WORD_VALUE = 4,  /* the argument of an option, the string of a member */
	WORD_MEMBER = 8, /* the name of a member */
	WORD_JSON = 16,  /* a value of JSON without quotes */
};

/* Returns the hint for a word of other programs in a place, or NULL. The hint is an
 * option ("--jobs"), a call ("project -m") or a remark (": ..."); a * stands for the
 * word. If `first` is not NUL, ignores hints that do not begin with it. */
const char *word_hint(const char *word, enum word_place, char first);

/* Writes words[] as a list such as "a", "b" or "c": with `quote` before and after each,
 * and `before_last`, such as " or ", before the last. Cuts the list at LIST_ROOM bytes.
 * Returns out. */
const char *words_join(char out[LIST_ROOM], const char *const *words,
    const char *before_last, const char *quote);
