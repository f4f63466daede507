/* SPDX-License-Identifier: MIT */
/* Texts of numbers several at a time: one body, compiled once for each kind of
 * processor, with the same bytes from each as from number_write. */
#ifndef VECTOR_H
#define VECTOR_H

#include <stdint.h>

#include "../number.h"
#include "../plain.h"

enum { TEXTS = NUMBER_BATCH };

struct number_vector {
	/* as number_texts, but that n is a multiple of TEXTS */
	void (*texts)(const double *v, size_t n, bool single,
	    struct number_style style, struct number_text *t);
};

extern const struct number_vector number_avx512, number_avx2, number_neon;

extern const struct plain_reader plain_avx512, plain_avx2, plain_neon;

#endif
