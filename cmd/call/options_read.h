/* SPDX-License-Identifier: MIT */
#ifndef OPTIONS_READ_H
#define OPTIONS_READ_H

#include "options.h"

/* Reads a command's options and operands; argv[0] is its name. Stops as soon as
 * the help or the version is asked for. */
void options_read(const struct command *, int argc, char **argv,
    struct options *);

#endif
