/* SPDX-License-Identifier: MIT */
/* Examples of members, as help and hints show them. */
#ifndef EXAMPLES_H
#define EXAMPLES_H

#define CAMERA_LIKE "{\"eye\": [0,0,-5], \"at\": [0,0,0]}"
#define LENS_LIKE                                               \
	"{\"type\": \"persp\", \"fovy\": 60, \"aspect\": 1.5, " \
	"\"near\": 1, \"far\": 10}"
#define RECTANGLE_LIKE "{\"width\": 640, \"height\": 480}"
#define WINDOW_LIKE "{\"center\": [20,30], \"width\": 10, \"height\": 10}"

/* The viewport gives the aspect. */
#define SCENE_LIKE                                                            \
	"{\"camera\": " CAMERA_LIKE ", \"projection\": {\"type\": \"persp\"," \
	" \"fovy\": 60, \"near\": 1, \"far\": 10}, "                          \
	"\"viewport\": " RECTANGLE_LIKE "}"

#endif
