/* SPDX-License-Identifier: MIT */
/* First tries: what is meant by a call that can't be, and the call that would do
 * it. */
#ifndef MISTAKEN_H
#define MISTAKEN_H

#include "options.h"

/* Refuses words[0], which stands where a command should; what follows it may tell
 * more. commands end with a name that is NULL. */
_Noreturn void mistaken_command(const struct command *commands, char **words);

/* The same where it is what help is asked for. */
_Noreturn void mistaken_topic(const struct command *commands, const char *word);

/* Refuses an option, words[0], "--eye=0,0,5" or "-eye", if its name is one of a member
 * of a scene, or where exact is true the very name of one that the command reads.
 * What follows may be its value, and more such options. */
void mistaken_member(const struct command *, char **words, bool exact);

/* The option that others call so, or NULL. */
const char *mistaken_option(const char *name);

/* Refuses operands that can't be opened, and PARAMS and POINTS that have traded
 * places. */
void mistaken_params(const struct command *, const struct options *);
void mistaken_points(const struct command *, const struct options *, int i);

/* Refuses a typed position on the device in place of a point: pick has an option for
 * that, and project one that takes it back. */
void mistaken_position(const struct command *, const struct options *);

#endif
