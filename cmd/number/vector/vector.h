/* SPDX-License-Identifier: MIT */
/* Reads and writes several numbers at a time, by code that is compiled once for each kind
 * of processor. Every kind gives the bits of number_read and the bytes of number_write. */
#ifndef VECTOR_H
#define VECTOR_H

#include <stdint.h>

#include "../number.h"
#include "../plain.h"

enum { TEXTS = NUMBER_BATCH };

/* Does what number_texts does, for n that is a multiple of TEXTS. */
typedef void number_writer(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t);

extern number_writer number_texts_avx512, number_texts_avx2, number_texts_neon;

extern const struct plain_reader plain_avx512, plain_avx2, plain_neon;

#endif
