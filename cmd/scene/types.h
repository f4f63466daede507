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

/* What a calibrated camera makes of a point in view space, in pixels: double[3][4]. */
extern const struct type type_intrinsics;

/* A number, or "infinity". */
extern const struct type type_far;
void put_distance(struct printer *, double);

/* An object of the row's members and ways. */
extern const struct type type_object;

/* Checks by which of a row's ways an object of that kind takes its members, and keeps the
 * indices in the struct; and returns, as bits, the members of these ways, and those in
 * none. */
void take_ways(const struct value *, const struct member *, int kind,
    uint64_t seen, void *base);
uint64_t taken_ways(const struct member *, int kind, const void *base);

/* Points, which are read as lines of text. */
extern const struct type type_points;

#endif
