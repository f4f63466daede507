/* SPDX-License-Identifier: MIT */
/* The types of members, for the tables of object.h. */
#ifndef TYPES_H
#define TYPES_H

#include "../json/object.h"

/* A number, or an array of n numbers: double. */
extern const struct type type_numbers;

/* true or false: bool. */
extern const struct type type_flag;

/* One of words: an enum in the same order, from first. One of two words: bool, whether
 * it is the second. */
extern const struct type type_word, type_second;

/* In the order of enum angle_unit; NULL ends them. */
extern const char *const angle_units[];

/* Which vectors a matrix is for: "row" or "column"; NULL ends them. */
extern const char *const vector_names[];

/* A matrix, double[4][4] for row vectors: 16 numbers in memory order; or 4 rows, which
 * are for column vectors if source->column; or the object that -o json prints, which
 * says itself which vectors it is for. An affine one may be without what they all have:
 * 3 rows of 4 for column vectors, 4 rows of 3 for row vectors. */
extern const struct type type_matrix, type_affine;
void read_affine(const struct value *, const struct member *, void *);

/* What a calibrated camera makes of a point in view space, in pixels: double[3][4]. */
extern const struct type type_intrinsics;

/* A number, or "infinity". */
extern const struct type type_far;
void put_distance(struct printer *, double);

/* A value that is read later: struct value. */
extern const struct type type_value, type_later_matrix, type_points,
    type_convention;

#endif
