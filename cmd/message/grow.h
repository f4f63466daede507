/* SPDX-License-Identifier: MIT */
/* Arrays that grow. One of n elements has room for the least power of two from n on, so
 * that n alone tells it. */
#pragma once

#include "message.h"

static inline size_t array_room(size_t n)
{
	return n < 2 ? n : (size_t)2 << (63 - __builtin_clzll(n - 1));
}

/* Returns the array, moved if there is no room for n + more elements. */
static inline void *array_grow(void *array, size_t n, size_t more, size_t size)
{
	return n + more <= array_room(n) ? array :
					   xrealloc(array, array_room(n + more) * size);
}

/* GROW(a, n, more) makes room for n + more elements in the array a of n. */
#define GROW(a, n, more) ((a) = array_grow((a), (n), (more), sizeof *(a)))
