/* SPDX-License-Identifier: MIT */
/* All help as JSON, from which scripts make the schema and the completions. */
#ifndef HELP_JSON_H
#define HELP_JSON_H

#include "call/command.h"

/* Prints the tables of commands, options and members. A NULL name ends `commands`. */
void help_json(const struct command *commands, const char *version);

#endif
