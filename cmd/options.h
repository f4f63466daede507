/* The options of all commands, in one table. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "command.h"

/* Reads a command's options and operands; argv[0] is its name. Returns 'h' or
 * 'V' where help or the version is asked for, else 0. */
int options_read(const struct command *, int argc, char **argv,
    struct options *);

/* A line of help for each option that the command uses. */
void options_print(const struct command *);

#endif
