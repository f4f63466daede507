/* SPDX-License-Identifier: MIT */
/* Counts the coordinates that are not the double, or the float, nearest to the true
 * value, in random scenes, between any two spaces, for every copy of the kernels.
 * usage: oracle_test [COORDINATES [SEED]] */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "block.h"

/* Counts of coordinates by their verdict, of points that a kernel took, and of those
 * among them that it left undecided. */
struct count {
	struct tally tally;
	size_t points, undecided;
};

static void count_undecided(const struct transform *t, struct block *b, struct count *c)
{
	const double *const in[3] = { b->in[0], b->in[1], b->in[2] };
	double *const out[4] = { b->out[0], b->out[1], b->out[2], b->out[3] };
	exact_kernel fast = kernels_chosen()->exact[t->kernel];

	if (fast == NULL)
		return;
	c->points += POINTS;
	fast(&t->for_kernel, in, out, POINTS);
	for (int i = 0; i < POINTS; i++)
		c->undecided += isnan(b->out[0][i]) != 0;
}

static void try_scene(int e, struct count *c)
{
	static struct transform t;
	static struct block b;
	struct truth truth = { 0 };
	struct scene s;
	enum space from;
	int mark = real_mark();

	if (sample_transform(e, &s, &from, &t, &truth)) {
		if (e < 0)
			sample_round_points(&b, POINTS);
		else
			sample_points(&s, from, &b, POINTS);
		for (int i = 0; i < COPIES; i++) {
			if (!kernels_choose(copies[i]))
				continue;
			count_undecided(&t, &b, c);
			map_block_exactly(&t, &b, POINTS);
			judge_block(&truth, &t, &b, POINTS, false, &c->tally);
		}
		judge_block(&truth, &t, &b, POINTS, true, &c->tally);
	}
	real_release(mark);
}

/* Tries scenes with magnitudes of 10^-e to 10^e, or with round numbers if e is
 * negative. Returns how many coordinates are wrong. */
static size_t try_scenes(int e, size_t coordinates)
{
	struct count c = { 0 };
	const size_t *n = c.tally.n;

	while (n[NEAREST] + n[WITHIN_TOLERANCE] + n[WRONG] < coordinates)
		try_scene(e, &c);
	char what[16] = "round";

	if (e >= 0)
		snprintf(what, sizeof what, "10^%d", e);
	printf("%s - %s: of %zu coordinates %zu not the nearest, %zu "
	       "within the tolerance; %.3g %% of the kernels' points were left "
	       "undecided\n",
	    n[WRONG] == 0 ? "ok" : "not ok", what,
	    n[NEAREST] + n[WITHIN_TOLERANCE] + n[WRONG], n[WRONG], n[WITHIN_TOLERANCE],
	    100.0 * (double)c.undecided / (double)c.points);
	fflush(stdout);
	return n[WRONG];
}

int main(int argc, char **argv)
{
	static const int magnitudes[] = { -1, 0, 3, 9, 40 };
	size_t coordinates = argc > 1 ? strtoul(argv[1], NULL, 10) : 50000;
	size_t wrong = 0;

	sample_seed(argc > 2 ? (unsigned)strtoul(argv[2], NULL, 10) : 1);
	puts("1..5");
	for (int i = 0; i < 5; i++)
		wrong += try_scenes(magnitudes[i], coordinates / 5);
	return wrong > 0;
}
