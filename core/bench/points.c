/* SPDX-License-Identifier: MIT */
/* Measures nanoseconds a point of points_map, for every copy of the kernels that this
 * processor runs, every precision and every kind of transform, on a block that lies in
 * the cache. Prints a table in markdown. */
#include <stdio.h>

#include "clock.h"
#include "../points/points.h"
#include "../test/sample.h"

enum { RUNS = 101, CALLS = 4, PRECISIONS = 3, CASES = 4, COPIES = 4 };

static const char *const copies[COPIES] = { "baseline", "avx2", "avx512", "neon" };

static const struct scene scene = {
	.has_camera = true,
	.camera = { .way = CAMERA_AT,
	    .eye = { 1, 2, -5 },
	    .at = { 0.1, 0.2, 0.3 },
	    .up = { 0, 1, 0 } },
	.projection = { .type = PROJECTION_PERSP,
	    .section.way = SECTION_FOVY,
	    .section.angle = 60,
	    .aspect = { 640, 480 },
	    .near = 1,
	    .far = 10 },
	.has_viewport = true,
	.viewport = { .width = 640, .height = 480, .max_z = 1 },
	.has_window = true,
	.window = { .center = { 0.1, 0.2 }, .width = 4, .height = 3, .zoom = 1 },
	.has_device = true,
	.device = { .width = 640, .height = 480, .top_left = true },
};

/* A transform and a block of points for it. */
struct sample {
	const char *name;
	struct transform transform;
	COLUMN_ALIGNED double in[3][POINTS_BLOCK];
	double times[COPIES][PRECISIONS][RUNS];
};

static struct sample cases[CASES];

static void fill(struct sample *s, const double low[3], const double high[3])
{
	for (int i = 0; i < POINTS_BLOCK; i++)
		for (int k = 0; k < 3; k++)
			s->in[k][i] = sample_between(low[k], high[k]);
}

/* Makes samples of points in front of the eye, whose images the kernels can all round.
 */
static bool make_cases(struct refusals *faults)
{
	const double low[3] = { -2, -2, -2 }, high[3] = { 2, 2, 2 };
	const double corner[3] = { 0, 0, 0 }, other[3] = { 640, 480, 1 };

	if (!transform_of_scene(&scene, SPACE_WORLD, SPACE_DEVICE, false,
		&cases[0].transform, faults) ||
	    !transform_of_scene(&scene, SPACE_DEVICE, SPACE_WORLD, false,
		&cases[1].transform, faults) ||
	    !transform_of_scene(&scene, SPACE_WORLD, SPACE_VIEW, false,
		&cases[2].transform, faults) ||
	    !transform_of_scene(&scene, FLAT_WINDOW, FLAT_DEVICE, false,
		&cases[3].transform, faults))
		return false;
	cases[0].name = "perspective";
	cases[1].name = "projective";
	cases[2].name = "affine";
	cases[3].name = "flat";
	for (int c = 0; c < CASES; c++)
		fill(&cases[c], c == 1 ? corner : low, c == 1 ? other : high);
	return true;
}

static double measure(const struct sample *s, enum precision p)
{
	static COLUMN_ALIGNED double image[4][POINTS_BLOCK];
	const double *const in[4] = { s->in[0], s->in[1], s->in[2] };
	double *const out[4] = { image[0], image[1], image[2], image[3] };
	double start = clock_ns();

	for (int i = 0; i < CALLS; i++)
		points_map(&s->transform, p, in, out, POINTS_BLOCK);
	return (clock_ns() - start) / (CALLS * POINTS_BLOCK);
}

/* Measures each sample once, so that a slow moment of the machine slows one run of
 * each. */
static void measure_all(int run)
{
	for (int copy = 0; copy < COPIES; copy++) {
		if (!kernels_choose(copies[copy]))
			continue;
		for (int c = 0; c < CASES; c++)
			for (int e = 0; e < PRECISIONS; e++)
				cases[c].times[copy][e][run] = measure(&cases[c],
				    (enum precision)e);
	}
}

static void print_row(struct sample *s, int copy)
{
	printf("| %s | %s |", s->name, copies[copy]);
	for (int e = 0; e < PRECISIONS; e++) {
		struct timing t = timing_of(s->times[copy][e], RUNS);

		printf(" %.2f (%.2f) |", t.min, t.median);
	}
	putchar('\n');
}

int main(void)
{
	static struct refusals faults;

	sample_seed(1);
	if (!make_cases(&faults)) {
		fprintf(stderr, "points: %s: %s\n", faults.list[0].where,
		    faults.list[0].what);
		return 1;
	}
	measure_all(0);
	for (int run = 0; run < RUNS; run++)
		measure_all(run);
	printf("| kind | copy | exact | double | single |\n"
	       "|---|---|--:|--:|--:|\n");
	for (int c = 0; c < CASES; c++)
		for (int copy = 0; copy < COPIES; copy++)
			if (kernels_choose(copies[copy]))
				print_row(&cases[c], copy);
	return 0;
}
