/* SPDX-License-Identifier: MIT */
#include "stack.h"

#include <sys/resource.h>

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "../message/message.h"

/* A map is 7 KB of exact numbers, of which inspect makes some while others wait: it
 * takes between 144 and 160 KB where gcc compiles with -O2, and less than 192 with
 * -O0. */
enum { STACK_SIZE = 1 << 20 };

int start_with_stack(pthread_t *t, void *(*run)(void *), void *with)
{
	pthread_attr_t attributes;
	int error = pthread_attr_init(&attributes);

	if (error != 0)
		return error;
	pthread_attr_setstacksize(&attributes, STACK_SIZE);
	error = pthread_create(t, &attributes, run, with);
	pthread_attr_destroy(&attributes);
	return error;
}

static bool stack_is_small(void)
{
	struct rlimit limit;

	return getrlimit(RLIMIT_STACK, &limit) == 0 &&
	    limit.rlim_cur < STACK_SIZE;
}

void call_with_stack(void *(*run)(void *), void *with)
{
	pthread_t t;
	int error;

	if (!stack_is_small()) {
		run(with);
		return;
	}
	error = start_with_stack(&t, run, with);
	if (error != 0)
		die(EXIT_SYSTEM, "the stack is too small, and a thread: %s",
		    strerror(error));
	pthread_join(t, NULL);
}
