/* SPDX-License-Identifier: MIT */
/* Refuses unknown commands, topics of help and options, with a remedy from the tables
 * of commands, options and members and from words.h. */
#pragma once

#include "command.h"

struct member;

/* Returns the member called `name` of a scene; else of one of its objects, that of the
 * first type first; else a member with the alias `name`; else NULL. Searches from the
 * last object to the first. Sets *object to the member of the scene that is the result
 * or contains it. */
const struct member *unknown_find_member(const char *name,
    const struct member **object);

/* Refuses `word`, an unknown command or, if `topic` is true, an unknown topic of help.
 * A name of NULL ends the table `commands`. */
_Noreturn void unknown_refuse_command(const struct command *commands, bool topic,
    const char *word);

/* Refuses `word`, such as "--eye", if is_unknown is true, or if `name` is an option, a
 * member or a word with a hint. `name` is the word without dashes or, for the letter of
 * an option that c does not take, the name of that option. */
void unknown_check_option(const struct command *c, const char *word, const char *name,
    bool is_unknown);
