/* SPDX-License-Identifier: MIT */
/* The table of the members of a scene, with the tables of the objects among them. From
 * these rows come the reading and printing of scenes, help, completions and the schema.
 * The rows are constants; their fields are in struct document of document.h. */
#pragma once

#include "../json/object.h"

/* The rows of scene_members. */
enum scene_row {
	SCENE_ROW_CONVENTION,
	SCENE_ROW_ANGLE_UNIT,
	SCENE_ROW_WORLD,
	SCENE_ROW_CAMERA,
	SCENE_ROW_PROJECTION,
	SCENE_ROW_VIEWPORT,
	SCENE_ROW_WINDOW,
	SCENE_ROW_DEVICE,
	SCENE_ROW_POINTS,
	SCENE_ROW_BOUNDS,
	SCENE_ROW_PICK,
	SCENE_ROW_MARGIN,
	SCENE_ROWS,
};

/* The members of a scene as bits. */
enum scene_member {
	SCENE_CONVENTION = 1 << SCENE_ROW_CONVENTION,
	SCENE_ANGLE_UNIT = 1 << SCENE_ROW_ANGLE_UNIT,
	SCENE_WORLD = 1 << SCENE_ROW_WORLD,
	SCENE_CAMERA = 1 << SCENE_ROW_CAMERA,
	SCENE_PROJECTION = 1 << SCENE_ROW_PROJECTION,
	SCENE_VIEWPORT = 1 << SCENE_ROW_VIEWPORT,
	SCENE_WINDOW = 1 << SCENE_ROW_WINDOW,
	SCENE_DEVICE = 1 << SCENE_ROW_DEVICE,
	SCENE_POINTS = 1 << SCENE_ROW_POINTS,
	SCENE_BOUNDS = 1 << SCENE_ROW_BOUNDS,
	SCENE_PICK = 1 << SCENE_ROW_PICK,
	SCENE_MARGIN = 1 << SCENE_ROW_MARGIN,
	/* members of a 3D scene, which map model space to the device */
	SCENE_SPATIAL = SCENE_WORLD | SCENE_CAMERA | SCENE_PROJECTION | SCENE_VIEWPORT,
};

/* The members of struct document. */
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
