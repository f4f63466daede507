/* SPDX-License-Identifier: MIT */
/* Words that are no command, option or topic of help: their refusal suggests a synonym, a
 * member of the scene, or the nearest name. */
#ifndef SYNONYMS_H
#define SYNONYMS_H

#include "options.h"

struct member;

/* Returns the member with a name or, if there is none, with that alias; or NULL. Sets
 * *object to the scene's member that has it or is it. If several have it, returns that of
 * the last: the viewport has a width, and the projection another. */
const struct member *synonym_find(const char *name,
    const struct member **object);

/* Refuses a word in the place of a command. A name of NULL ends the table. */
_Noreturn void synonym_refuse_command(const struct command *commands,
    const char *word);

/* Refuses a word that is no command, or no topic of help. */
_Noreturn void synonym_refuse_word(const struct command *commands, bool topic,
    const char *word);

/* Refuses an option, such as "--eye=0,0,5" or "-eye", that has a synonym or the name of a
 * member of a scene; else returns. If elsewhere, other commands have the option: it is
 * refused only if this command reads the member, as lookat reads at. */
void synonym_check_option(const struct command *, const char *option,
    bool elsewhere);

#endif
