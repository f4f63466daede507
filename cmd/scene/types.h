/* SPDX-License-Identifier: MIT */
/* The types of members, for the tables of object.h. */
#ifndef TYPES_H
#define TYPES_H

#include "../json/object.h"

/* A number, or an array of n numbers; in the struct doubles. */
extern const struct type type_numbers;

/* true or false; in the struct a bool. */
extern const struct type type_flag;

/* type_word: one of the row's words; in the struct an enum in the order of the words, from
 * the row's first. type_second: one of two words; in the struct a bool, true for the
 * second word. */
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

/* The intrinsics of a calibrated camera: the numbers fx, fy, cx, cy, or the matrix K or P.
 * In the struct it is P, a double[3][4]. */
extern const struct type type_intrinsics;

/* A number, or "infinity"; in the struct a double. */
extern const struct type type_far;
void put_distance(struct printer *, double);

/* An object with the members and ways of the row. */
extern const struct type type_object;

/* Calls object_way for each struct ways of the row and the kind, and sets the index of the
 * way in the struct at base. Refuses an object that fits no way. */
void take_ways(const struct value *, const struct member *, int kind,
    uint64_t seen, void *base);

/* Returns as bits the members of the ways whose indices the struct at base has, and those
 * of no way. */
uint64_t taken_ways(const struct member *, int kind, const void *base);

/* Points. They are read as lines of text, not through a table. */
extern const struct type type_points;

#endif
