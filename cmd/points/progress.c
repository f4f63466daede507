#include "progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

/* Seconds until it begins, and between two times. */
#define PATIENCE 0.5
#define PAUSE 0.2

static struct {
	bool on, asked, terminal, shown;
	double start, last;
	size_t lines, bytes, of;
} progress;

static double now(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

void progress_start(bool asked)
{
	progress.asked = asked;
	progress.terminal = isatty(STDERR_FILENO);
	progress.on = asked || (progress.terminal && !isatty(STDOUT_FILENO));
	progress.start = progress.last = now();
}

void progress_source(size_t bytes)
{
	progress.bytes = 0;
	progress.of = bytes;
}

static void show(double time)
{
	double rate = (double)progress.lines / (time - progress.start);
	char share[16] = "";

	if (progress.of > 0)
		snprintf(share, sizeof share, ", %.0f %%",
		    100 * (double)progress.bytes / (double)progress.of);
	fprintf(stderr, "%sprojcalc: %zu lines, %.3g a second%s%s",
	    progress.terminal ? "\r\033[K" : "", progress.lines, rate, share,
	    progress.terminal ? "" : "\n");
	progress.shown = progress.terminal;
	progress.last = time;
}

void progress_add(size_t lines, size_t bytes)
{
	progress.lines += lines;
	progress.bytes += bytes;
	if (!progress.on)
		return;
	double time = now();

	if (time - progress.start > PATIENCE && time - progress.last > PAUSE)
		show(time);
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
		show(now());
	if (progress.shown && progress.asked)
		fputc('\n', stderr);
	else
		progress_clear();
	progress.shown = false;
}
