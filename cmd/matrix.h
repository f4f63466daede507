/* SPDX-License-Identifier: MIT */
/* Prints matrices: the answer of many commands, and of project -m. */
#pragma once

#include "call/options.h"

/* Prints the matrix of a transform in the format and precision of the options, for row
 * or column vectors as the convention of the answer says. For a space whose points have
 * two coordinates, the matrix lacks the row or column of z. */
void matrix_print(const struct options *, const struct document *,
    const struct transform *);
