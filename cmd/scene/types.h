/* SPDX-License-Identifier: MIT */
/* The types of members, for the tables of object.h. The comment on a type says what its
 * members are in JSON and, after "in the struct", what their fields are. */
#ifndef TYPES_H
#define TYPES_H

#include "../json/object.h"
#include "document.h"

/* A number or, if the row has n, an array of n numbers; in the struct doubles. */
extern const struct type type_numbers;

/* true or false or, if the row has words, one of its two words; in the struct a bool,
 * which is true for the second word. */
extern const struct type type_flag;

/* One of the row's words; in the struct an enum: row.word_0 plus the word's index. */
extern const struct type type_word;

/* The names of enum angle_unit, in its order; NULL ends them. */
extern const char *const angle_units[];

/* "row" and "column", the vectors that a matrix may be for; NULL ends them. */
extern const char *const vector_names[];

/* A matrix: 16 numbers, by rows for row vectors or by columns for column vectors; or 4
 * rows, for row vectors unless source->column_vectors is set; or an object with members
 * "matrix" and "vectors". type_affine may also be 3 rows of 4 for column vectors, or 4
 * rows of 3 for row vectors. In the struct a double[4][4] for row vectors. */
extern const struct type type_matrix, type_affine;

/* The intrinsics of a calibrated camera: the numbers fx, fy, cx, cy, or the matrix K or
 * P; in the struct a double[3][4], the matrix P. */
extern const struct type type_intrinsics;

/* A number, or "infinity"; in the struct a double. put_distance prints it. */
extern const struct type type_far;
void put_distance(struct printer *, double);

/* An object with the members and ways of the row. */
extern const struct type type_object;

/* A point or a list of points. document.c makes lines of them for the job. */
extern const struct type type_points;

/* The members of struct document; row i has bit i in enum scene_member. */
extern const struct member scene_members[];

/* The members of a projection, and the ways to combine them. */
extern const struct member projection_members[];
extern const struct ways projection_ways[];
extern const struct type type_projection;

/* The names of the types of projections, from PROJECTION_PERSP on; NULL ends them. */
extern const char *const projection_types[];

/* Completes a projection that was read from the value: takes a missing aspect and, for
 * intrinsics, the size of the image from the viewport, which may be NULL. */
void projection_complete(const struct value *, const struct viewport *,
    struct projection *);

/* Examples for the help. SCENE_EXAMPLE takes its aspect from the viewport. */
#define CAMERA_EXAMPLE "{\"eye\": [0,0,-5], \"at\": [0,0,0]}"
#define PERSP_EXAMPLE                                           \
	"{\"type\": \"persp\", \"fovy\": 60, \"aspect\": 1.5, " \
	"\"near\": 1, \"far\": 10}"
#define RECTANGLE_EXAMPLE "{\"width\": 640, \"height\": 480}"
#define WINDOW_EXAMPLE "{\"center\": [20,30], \"width\": 10, \"height\": 10}"

#define SCENE_EXAMPLE                                \
	"{\"camera\": " CAMERA_EXAMPLE               \
	", \"projection\": {\"type\": \"persp\","    \
	" \"fovy\": 60, \"near\": 1, \"far\": 10}, " \
	"\"viewport\": " RECTANGLE_EXAMPLE "}"

/* The conventions that have a name, in the order of convention_names. */
enum {
	CONVENTION_D3D, /* the default */
	CONVENTION_GL,
	CONVENTION_VULKAN,
	CONVENTION_WEBGPU,
	CONVENTION_OPENCV,
	CONVENTIONS,
};

extern const struct convention conventions[CONVENTIONS];
extern const char *const convention_names[CONVENTIONS + 1]; /* NULL ends them */

/* The members of a convention that is an object. Each has one of two words, and is a
 * bool in struct convention: false for the first word, which d3d has, else true. */
extern const struct member convention_members[];

/* A convention: a name, or an object of convention_members. */
extern const struct type type_convention;

/* Refuses the object's member `name`, whose numbers depend on the view axes, if neither
 * the document nor the command line gives a convention. */
void require_convention(const struct value *object, const char *name);

#endif
