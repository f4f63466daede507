/* SPDX-License-Identifier: MIT */
/* The table of the members of a scene, with the tables of the objects among them. From
 * these rows come the reading and printing of scenes, help, completions and the schema.
 * The rows are constants; their fields are in struct document of document.h. */
#pragma once

#include "../json/object.h"

/* The members of a scene as bits. */
enum scene_member {
	SCENE_CONVENTION = 1,
	SCENE_ANGLE_UNIT = 2,
	SCENE_WORLD = 4,
	SCENE_CAMERA = 8,
	SCENE_PROJECTION = 16,
	SCENE_VIEWPORT = 32,
	SCENE_WINDOW = 64,
	SCENE_DEVICE = 128,
	SCENE_POINTS = 256,
	SCENE_BOUNDS = 512,
	SCENE_PICK = 1024,
	SCENE_MARGIN = 2048,
	SCENE_ALL = 2 * SCENE_MARGIN - 1,
	/* members of a 3D scene, which map model space to the device */
	SCENE_SPATIAL = SCENE_WORLD | SCENE_CAMERA | SCENE_PROJECTION | SCENE_VIEWPORT,
};

/* The members of struct document; row i has bit i in enum scene_member. */
extern const struct member scene_members[];

/* Examples for the help. SCENE_EXAMPLE takes its aspect from the viewport. */
#define CAMERA_EXAMPLE "{\"eye\": [0,0,-5], \"at\": [0,0,0]}"
#define PICK_EXAMPLE "{\"at\": [320,240], \"radius\": 3}"
#define PERSP_EXAMPLE                                           \
	"{\"type\": \"persp\", \"fovy\": 60, \"aspect\": 1.5, " \
	"\"near\": 1, \"far\": 10}"
#define RECTANGLE_EXAMPLE "{\"width\": 640, \"height\": 480}"
#define WINDOW_EXAMPLE "{\"center\": [20,30], \"width\": 10, \"height\": 10}"

#define SCENE_EXAMPLE                                                            \
	"{\"camera\": " CAMERA_EXAMPLE ", \"projection\": {\"type\": \"persp\"," \
	" \"fovy\": 60, \"near\": 1, \"far\": 10}, "                             \
	"\"viewport\": " RECTANGLE_EXAMPLE "}"
