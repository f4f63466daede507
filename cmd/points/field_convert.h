/* A field that is no coordinate, from one format to another. */
#ifndef FOREIGN_H
#define FOREIGN_H

#include "field.h"

/* Writes field f, as it stands where that means the same, else in quotes, and
 * returns the end: at most six bytes for one of f, \u0001, and the quotes. */
char *foreign_write(enum format in, enum format out, struct span f, char *at);

#endif
