/* SPDX-License-Identifier: MIT */
#include "progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

#include "../message/message.h"

/* Seconds until the line is shown first, and between two times. */
#define PATIENCE 0.5
#define PAUSE 0.2

/* It needs no lock, as no two chunks are answered at a time. */
static struct {
	bool on, asked;
	bool terminal;         /* standard error is one */
	bool shown;            /* the line stands in the terminal */
	double start, last;    /* seconds: the beginning, when it was shown */
	long long lines;       /* of all sources */
	long long bytes, size; /* of this one: done, and in all or 0 */
} progress;

static double now(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

void progress_start(bool asked)
{
	if (progress.start > 0)
		return;
	progress.asked = asked;
	progress.terminal = isatty(STDERR_FILENO) && !message_state.json;
	progress.on = asked || (progress.terminal && !isatty(STDOUT_FILENO));
	progress.start = progress.last = now();
}

void progress_source(long long size)
{
	progress.bytes = 0;
	progress.size = size;
}

static void progress_show(double time)
{
	double rate = (double)progress.lines / (time - progress.start);
	char share[16] = "";

	if (progress.size > 0)
		snprintf(share, sizeof share, ", %.0f %%",
		    100 * (double)progress.bytes / (double)progress.size);
	if (message_state.json) {
		say_at(EXIT_OK, NULL, "%lld lines, %.3g a second%s",
		    progress.lines, rate, share);
		progress.last = time;
		return;
	}
	fprintf(stderr, "%sprojcalc: %lld lines, %.3g a second%s%s",
	    progress.terminal ? "\r\033[K" : "", progress.lines, rate, share,
	    progress.terminal ? "" : "\n");
	progress.shown = progress.terminal;
	progress.last = time;
}

void progress_add(size_t lines, size_t bytes)
{
	progress.lines += (long long)lines;
	progress.bytes += (long long)bytes;
	if (!progress.on)
		return;
	double time = now();

	if (time - progress.start > PATIENCE && time - progress.last > PAUSE)
		progress_show(time);
}

void progress_clear(void)
{
	if (progress.shown)
		fputs("\r\033[K", stderr);
	progress.shown = false;
}

void progress_end(void)
{
	if (progress.asked)
		progress_show(now());
	if (progress.shown && progress.asked)
		fputc('\n', stderr);
	else
		progress_clear();
	progress.shown = false;
}
