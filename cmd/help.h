/* SPDX-License-Identifier: MIT */
/* Prints help of commands and of the members of a scene. */
#pragma once

#include "call/command.h"

/* Lists the commands, up to a row without a name. */
void help_all(const struct command *);

void help_command(const struct command *);

/* Describes a member of the scene or of its objects. Returns false if no member has the
 * name. */
bool help_member(const char *name);

/* Prints all help as JSON, from which scripts make the schema and the completions. */
void help_json(const struct command *, const char *version);
