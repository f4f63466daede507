/* SPDX-License-Identifier: MIT */
/* Runs commands in turn, so that a slow moment of the machine slows a run of each. A
 * slow command skips most rounds.
 *
 * usage: turns SECONDS
 *        a line of standard input is a command for sh; prints a line for each:
 *        the medians of its wall time and of its CPU time, user's and system's,
 *        in seconds, and its greatest resident size in bytes. Rounds go on for
 *        SECONDS, and there are at least three. */
#define _DEFAULT_SOURCE /* wait4 */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../../core/bench/clock.h"

/* The seconds per round that a command may take on average; a slower one skips rounds.
 */
#define SHARE 0.3

enum { RUNS_MAX = 999, COMMANDS_MAX = 99, COMMAND_MAX = 4096, ROUNDS_MIN = 3 };

struct command {
	char text[COMMAND_MAX];
	double wall[RUNS_MAX], cpu[RUNS_MAX], spent;
	size_t runs;
	long kilobytes;
};

static struct command commands[COMMANDS_MAX];

static double wall_seconds(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static double seconds_of(struct timeval t)
{
	return (double)t.tv_sec + (double)t.tv_usec * 1e-6;
}

/* Runs the command once. The times include those of its children: sh waits for them. */
static bool run(struct command *c)
{
	struct rusage used;
	int status;
	double start = wall_seconds();
	pid_t child = fork();

	if (child == 0) {
		execl("/bin/sh", "sh", "-c", c->text, (char *)NULL);
		_exit(127);
	}
	if (child < 0 || wait4(child, &status, 0, &used) != child)
		return false;
	c->wall[c->runs] = wall_seconds() - start;
	c->spent += c->wall[c->runs];
	c->cpu[c->runs++] = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
	if (c->kilobytes < used.ru_maxrss)
		c->kilobytes = used.ru_maxrss;
	if (status == 0)
		return true;
	fprintf(stderr, "turns: failed: %s\n", c->text);
	return false;
}

int main(int argc, char **argv)
{
	double end = wall_seconds() + (argc == 2 ? strtod(argv[1], NULL) : 0);
	size_t n = 0;

	while (n < COMMANDS_MAX && fgets(commands[n].text, COMMAND_MAX, stdin) != NULL)
		n++;
	for (size_t round = 0; round < RUNS_MAX; round++) {
		bool enough = round >= ROUNDS_MIN && wall_seconds() >= end;

		for (size_t i = 0; !enough && i < n; i++) {
			struct command *c = &commands[i];
			bool dear = c->spent > SHARE * (double)round;

			if (!(dear && c->runs >= ROUNDS_MIN) && !run(c))
				return 1;
		}
		if (enough)
			break;
	}
	for (size_t i = 0; i < n; i++) {
		struct command *c = &commands[i];

		printf("%.6f\t%.6f\t%ld\n", timing_of(c->wall, c->runs).median,
		    timing_of(c->cpu, c->runs).median, c->kilobytes * 1024);
	}
	return 0;
}
