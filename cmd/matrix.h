/* SPDX-License-Identifier: MIT */
/* Prints matrices: the answer of many commands, and of project -m. */
#pragma once

#include "call/options.h"

/* Refuses --unit-w unless a matrix of these spaces is printed whose column of w has an
 * element for z: from model, world or view to clip, ndc or device. */
void matrix_check_unit_w(const struct options *, bool is_printed, enum space from,
    enum space to);

/* Prints the matrix of a transform in the format and precision of the options, for row
 * or column vectors as the convention of the answer says. For a space whose points have
 * two coordinates, the matrix lacks the row or column of z. For --unit-w divides the
 * map. Returns false if the document is refused. */
bool matrix_print(const struct options *, const struct document *, struct transform *);
