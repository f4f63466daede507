/* SPDX-License-Identifier: MIT */
/* Arrays that grow. */
#pragma once

#include "../message/message.h"

/* Returns the array, moved if n + more elements of `size` bytes do not fit into *room,
 * which then grows by half at least. */
static inline void *array_grow(void *array, size_t *room, size_t n, size_t more,
    size_t size)
{
	if (n + more <= *room)
		return array;
	*room += *room / 2;
	if (*room < n + more)
		*room = n + more;
	return xrealloc(array, *room * size);
}

/* GROW(a, n, more, room) makes room for n + more elements in the array a. */
#define GROW(a, n, more, room) \
	((a) = array_grow((a), &(room), (n), (more), sizeof *(a)))
