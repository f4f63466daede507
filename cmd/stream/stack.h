/* SPDX-License-Identifier: MIT */
/* Stacks of a size that is asked for: what systems give to threads is from 128 KB
 * on, and to a program what its user allows. */
#ifndef STACK_H
#define STACK_H

#include <pthread.h>

/* As pthread_create, without attributes. */
int start_with_stack(pthread_t *, void *(*run)(void *), void *with);

/* Calls run, in a thread where the program's own stack may be too small, and returns
 * when it does. */
void call_with_stack(void *(*run)(void *), void *with);

#endif
