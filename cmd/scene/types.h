/* SPDX-License-Identifier: MIT */
/* The types of members that several tables of cmd/scene share: how a value of a row is
 * read to a field and printed again (struct member_type in object.h). Types are
 * constants, and a field owns its value: nothing points to the document. The comment on
 * a type says what its members are in JSON and, after "in the struct", what their
 * fields are. */
#pragma once

#include "../json/object.h"

/* A number or, if the row has n, an array of n numbers; in the struct doubles. */
extern const struct member_type type_numbers;

/* true or false or, if the row has words, one of its two words; in the struct a bool,
 * which is true for the second word. */
extern const struct member_type type_flag;

/* One of the row's words; in the struct an enum: row.word_0 plus the word's index. */
extern const struct member_type type_word;

/* The names of enum angle_unit, in its order; NULL ends them. */
extern const char *const angle_unit_names[];

/* "row" and "column", the vectors that a matrix may be for; NULL ends them. */
extern const char *const vector_names[];

/* "up" and "down", where y may point; NULL ends them. */
extern const char *const y_names[];

/* A matrix: 16 numbers, by rows for row vectors or by columns for column vectors; or 4
 * rows, for row vectors unless source->column_vectors is set; or an object with members
 * "matrix" and "vectors". type_affine may also be 3 rows of 4 for column vectors, or 4
 * rows of 3 for row vectors, and in a row of its own, of a step, 3 rows of 3 for column
 * vectors unless "vectors" says row. In the struct a double[4][4] for row vectors. */
extern const struct member_type type_matrix, type_affine;

/* Reads an array as type_affine or type_matrix does, whose row it is. `object` is the
 * array itself, or an object with it and "vectors". */
bool matrix_read_member(const struct value *object, const struct value *array,
    const struct member *row, double out[4][4]);

/* The intrinsics of a calibrated camera: the numbers fx, fy, cx, cy, or the matrix K or
 * P; in the struct a double[3][4], the matrix P. */
extern const struct member_type type_intrinsics;

/* A number, or "infinity"; in the struct a double. */
extern const struct member_type type_far;

/* Three rows of three numbers, for column vectors; in the struct a double[3][3]. */
extern const struct member_type type_rotation;

/* The directions of three axes, as "flu"; in the struct an enum camera_axis[3]. */
extern const struct member_type type_axes;

/* A matrix as type_affine's, or a list of steps; in the struct a struct steps. */
extern const struct member_type type_steps;
extern const struct member step_members[];
extern const struct rule step_rules[];

/* A point or a list of points. document.c makes lines of them for the job. */
extern const struct member_type type_points;
