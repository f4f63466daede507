/* SPDX-License-Identifier: MIT */
/* Refuses unknown commands, topics of help and options, with a hint at what is meant. */
#ifndef SYNONYMS_H
#define SYNONYMS_H

#include "command.h"

struct member;

/* Returns the member called `name` of a scene or of one of its objects; else a member
 * with the alias `name`; else NULL. Searches from the last object to the first. Sets
 * *object to the member of the scene that is the result or contains it. */
const struct member *synonym_find(const char *name,
    const struct member **object);

/* Refuses `word`, an unknown command or, if `topic` is true, an unknown topic of help.
 * A name of NULL ends the table `commands`. */
_Noreturn void synonym_refuse_word(const struct command *commands, bool topic,
    const char *word);

/* Refuses the word `option`, such as "--eye", if `name` is an option or member, or has
 * a hint by word_hint. `name` is the word without dashes or, for "-t", "tolerance". */
void synonym_check_option(const struct command *, const char *option,
    const char *name);

#endif
