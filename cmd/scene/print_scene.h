/* A fitted scene as a document. */
#ifndef PRINT_SCENE_H
#define PRINT_SCENE_H

#include "document.h"

/* Prints a document that reads back as the same scene, window, device and
 * pick, a member a line, without what has its default. The camera is by gaze,
 * the projection persp, ortho or oblique, not by height and aspect. */
void print_scene(const struct document *);

#endif
