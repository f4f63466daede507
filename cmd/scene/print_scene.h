/* A fitted scene as a document. */
#ifndef PRINT_SCENE_H
#define PRINT_SCENE_H

#include "document.h"

/* Prints a document that reads back as the same scene, window, device and
 * pick, a member a line, without what has its default. Camera and projection
 * are as fit leaves them: the camera by its gaze; the projection persp, ortho
 * or oblique, and its cross-section not by height and aspect. */
void print_scene(const struct document *);

#endif
