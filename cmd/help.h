/* SPDX-License-Identifier: MIT */
/* What the program says of itself. All of it stands in the rows that the program
 * goes by: commands, options, members. */
#ifndef HELP_H
#define HELP_H

#include "call/command.h"

/* name is NULL after the last command. */
void help_all(const struct command *);
void help_command(const struct command *);

/* The help for a member of a scene, or of one of its objects; false if there is
 * none. */
bool help_member(const char *name);

/* All of it as one JSON object. */
void help_json(const struct command *, const char *version);

#endif
