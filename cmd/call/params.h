/* SPDX-License-Identifier: MIT */
/* PARAMS: a document or, with --scenes, any number of them one after another. */
#ifndef PARAMS_H
#define PARAMS_H

#include "options.h"

/* Goes on to the next document; false where there is none. What is said from now
 * on is about that scene. */
bool params_next(const struct options *);

/* Reads the document, which may leave points in the text: they are there until
 * params_next. */
void params_read(const struct options *, const struct document_wants *,
    struct document *);

#endif
