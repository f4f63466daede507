/* SPDX-License-Identifier: MIT */
/* Matrices out, in each format. */
#ifndef PRINT_MATRIX_H
#define PRINT_MATRIX_H

#include "call/options.h"

/* Prints the matrix of a transform's map, without rows and columns for z where it
 * takes or makes two coordinates, for row or column vectors as the convention of the
 * answer says, in the format and precision of the options. */
void print_matrix(const struct options *, const struct document *,
    const struct transform *);

#endif
