/* SPDX-License-Identifier: MIT */
/* The help of a command and of a member, made from the tables of commands, options and
 * members. */
#pragma once

#include "call/command.h"

/* Print help. help_all lists the commands, up to a row without a name. help_command
 * describes one command. help_member describes a member of the scene or of its objects,
 * and returns false if no member has the name. */
void help_all(const struct command *);
void help_command(const struct command *);
bool help_member(const char *name);

/* Prints all help as JSON, from which scripts make the schema and the completions. */
void help_json(const struct command *, const char *version);
