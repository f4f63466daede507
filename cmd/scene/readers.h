/* SPDX-License-Identifier: MIT */
/* Readers of members, for the tables of object.h. */
#ifndef READERS_H
#define READERS_H

#include "../json/object.h"

/* Keeps the value, to struct value, to be read later. */
void read_value(const struct value *, const struct member *, void *);

/* A number, or an array of n numbers, to double. */
void read_numbers(const struct value *, const struct member *, void *);

/* An angle, to double; range is a pair, for degrees and for radians. */
void read_angle(const struct value *, const struct member *, void *);

/* In the order of enum angle_unit; NULL ends them. */
extern const char *const angle_units[];

/* true or false, to bool. */
void read_flag(const struct value *, const struct member *, void *);

/* One of words, to an enum in the same order from 0. */
void read_word(const struct value *, const struct member *, void *);

/* One of two words, to bool: whether it is the second. */
void read_second(const struct value *, const struct member *, void *);

/* Which vectors a matrix is for: "row" or "column"; NULL ends them. */
extern const char *const vector_names[];

/* A matrix, to double[4][4] for row vectors: 16 numbers in memory order; or 4
 * rows, which are for column vectors if source->column; or the object that -o
 * json prints, which says itself which vectors it is for. */
void read_matrix(const struct value *, const struct member *, void *);

/* The same, or without what every affine matrix has: 3 rows of 4 for column
 * vectors, 4 rows of 3 for row vectors. */
void read_affine(const struct value *, const struct member *, void *);

#endif
