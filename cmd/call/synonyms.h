/* SPDX-License-Identifier: MIT */
/* Refuses words that are no command, option or topic of help, and says what
 * leads on: a synonym, a member of the scene, or the nearest name. */
#ifndef SYNONYMS_H
#define SYNONYMS_H

#include "options.h"

struct member;

/* Returns the member that has a name or, where there is none, an alias, and in *object
 * the scene's member that has it or is it; or NULL. The later object goes first: the
 * viewport has a width, and the projection another. */
const struct member *synonym_find(const char *name,
    const struct member **object);

/* Refuses a word that stands where a command should. The table of commands ends with
 * a name that is NULL. */
_Noreturn void synonym_command(const struct command *commands,
    const char *word);

/* Refuses a word that is no command, or of which as a topic help knows nothing. */
_Noreturn void synonym_word(const struct command *commands, bool topic,
    const char *word);

/* Refuses an option, "--eye=0,0,5" or "-eye", that has a synonym or is a member of a
 * scene; else returns. One that is elsewhere, of other commands, is refused where it is
 * a member that this command reads, as --at is of lookat. */
void synonym_option(const struct command *, const char *option, bool elsewhere);

#endif
