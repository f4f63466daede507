/* SPDX-License-Identifier: MIT */
/* Prints pictures for a terminal, in the characters of Braille. */
#pragma once

#include "picture.h"

/* Prints a picture in lines of so many columns. */
void braille_print(const struct picture *, int columns);

/* Returns the columns of the terminal that is standard output, or 80. */
int braille_columns(void);
