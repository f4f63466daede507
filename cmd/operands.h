/* The operands of a command: PARAMS, a document, and POINTS. */
#ifndef OPERANDS_H
#define OPERANDS_H

#include "options.h"
#include "points/stream.h"

/* Reads PARAMS; points of it have so many coordinates. */
void read_document(const struct command *, const struct options *,
    int coordinates, struct document *);

/* Whether points are given: as operands or in the document. */
bool has_points(const struct options *, const struct document *);

/* Fills in what the options say of a job that has its transform or ray maker,
 * and makes ready for it. */
void stream_options(struct job *, const struct options *);

/* Sends all points: operands, else the document's, else standard input. */
void stream_points(const struct options *, const struct document *,
    struct job *);

#endif
