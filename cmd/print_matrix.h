/* Matrices out, in each format. */
#ifndef PRINT_MATRIX_H
#define PRINT_MATRIX_H

#include "options.h"

/* Prints the matrix of a map as the document's convention has it, a 2D one
 * where flat. */
void print_matrix(const struct options *, const struct document *,
    const struct map *, bool flat);

#endif
