/* SPDX-License-Identifier: MIT */
/* Calls functions that print, and maybe exit, in a child process. Includes cmocka. */
#pragma once

#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../../core/test/numbers.h"

/* Calls run in a child process. Returns what the child writes to standard output and
 * standard error, and sets *status to its exit status, which is 0 if run returns. */
static inline const char *output_of(void (*run)(const void *), const void *argument,
    int *status)
{
	static char text[4096];
	size_t n = 0;
	ssize_t got;
	int ends[2];

	fflush(NULL);
	assert_int_equal(pipe(ends), 0);
	pid_t child = fork();

	assert_true(child >= 0);
	if (child == 0) {
		dup2(ends[1], STDOUT_FILENO);
		dup2(ends[1], STDERR_FILENO);
		run(argument);
		fflush(NULL);
		_exit(0);
	}
	close(ends[1]);
	while ((got = read(ends[0], text + n, sizeof text - 1 - n)) > 0)
		n += (size_t)got;
	close(ends[0]);
	text[n] = '\0';
	assert_int_equal(waitpid(child, status, 0), child);
	assert_true(WIFEXITED(*status));
	*status = WEXITSTATUS(*status);
	return text;
}
