/* Printing a fitted scene as a document. */
#ifndef PRINT_SCENE_H
#define PRINT_SCENE_H

#include "document.h"

/* Prints a document that reads back as the same scene and pick: a member a
 * line, without what has its default. The camera must be given by its gaze; the
 * projection must be persp, ortho or oblique, and its cross-section not given
 * by height and aspect: so fit leaves them. */
void print_scene(const struct document *);

#endif
