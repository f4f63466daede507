/* SPDX-License-Identifier: MIT */
/* The types of members, for the tables of object.h. */
#ifndef TYPES_H
#define TYPES_H

#include "../json/object.h"

/* A number, or an array of n numbers; in the struct doubles. */
extern const struct type type_numbers;

/* true or false; in the struct a bool. */
extern const struct type type_flag;

/* One of words; in the struct an enum in the same order, from first. One of two words; in
 * the struct a bool, true for the second. */
extern const struct type type_word, type_second;

/* In the order of enum angle_unit; NULL ends them. */
extern const char *const angle_units[];

/* "row" and "column", the vectors of a matrix; NULL ends them. */
extern const char *const vector_names[];

/* A matrix: 16 numbers in memory order; or 4 rows, for column vectors if source->column; or
 * the object that -o json prints, with its vectors. An affine one may also be 3 rows of 4
 * for column vectors, or 4 rows of 3 for row vectors. In the struct it is double[4][4] for
 * row vectors. */
extern const struct type type_matrix, type_affine;

/* The intrinsics of a calibrated camera: fx, fy, cx, cy, or K, or P. In the struct P, a
 * double[3][4]. */
extern const struct type type_intrinsics;

/* A number, or "infinity"; in the struct a double. */
extern const struct type type_far;
void put_distance(struct printer *, double);

/* An object with the members and ways of the row. */
extern const struct type type_object;

/* Finds the way of each of the row's ways that an object of that kind takes, and sets its
 * index in the struct at base; refuses an object that takes none. */
void take_ways(const struct value *, const struct member *, int kind,
    uint64_t seen, void *base);

/* Returns the members of the ways that the struct at base has, and of no way, as bits. */
uint64_t taken_ways(const struct member *, int kind, const void *base);

/* Points. They are read as lines of text, not through a table. */
extern const struct type type_points;

#endif
