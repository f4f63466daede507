/* SPDX-License-Identifier: MIT */
#ifndef OPTIONS_READ_H
#define OPTIONS_READ_H

#include "options.h"

/* Reads the options and operands that follow a command's name. Stops as soon as
 * the help or the version is asked for. */
void options_read(const struct command *, char **words, struct options *);

#endif
