/* SPDX-License-Identifier: MIT */
/* Printing scenes as documents. */
#ifndef PRINT_SCENE_H
#define PRINT_SCENE_H

#include "../json/print.h"
#include "document.h"

/* Prints a document that reads back as the same scene and pick: a member a
 * line, or on_line all, without what has its default. The camera must be given by its gaze; the
 * projection must not be a matrix, and its cross-section not given by height and
 * aspect: so fit leaves them. Of a flat document it leaves out what is of three
 * dimensions. */
void print_scene(const struct document *, bool on_line);

/* Puts what leads from model space to the device, in one line. */
void put_scene(struct printer *, const struct scene *);

void put_device(struct printer *, const struct device *);

#endif
