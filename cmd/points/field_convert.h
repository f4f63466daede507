/* A field that is no coordinate, from one format to another. */
#ifndef FOREIGN_H
#define FOREIGN_H

#include "field.h"

/* Writes field f and returns the end: plain where it can be, else quoted. At
 * most three times as long as f, and a separator, allow. */
char *foreign_write(enum format in, enum format out, struct span f, char *at);

#endif
