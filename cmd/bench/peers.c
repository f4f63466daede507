/* SPDX-License-Identifier: MIT */
/* Measures the precisions of projcalc beside other people's libraries, on points in
 * memory: nanoseconds per point, and the worst error in device units against MPFR.
 *
 * usage: peers                   a row each, with tabs between its fields: name,
 *                                median ns a point, worst error in ordinary
 *                                scenes, the same in scenes 1e9 away ("-" for
 *                                those whose numbers have no room for one)
 *        peers versions          what it was built with
 *        peers FILTER NAME       a whole program around a peer, from standard
 *                                input to standard output; fails if NAME was
 *                                not there when it was built. FILTER is
 *                                stdio: scanf and printf
 *                                standard: fast_float and std::to_chars
 *                                hand: eight digits in a word, 16 in a vector
 *                                binary: rows of numbers */
#include <stdio.h>

#include "../../core/bench/clock.h"
#include "../../core/points/point.h"
#include "../../core/points/points.h"
#include "../../core/test/sample.h"
#include "view.h"

enum { RUNS = 201, CALLS = 4, SCENES = 40, POINTS = 200, ENTRIES_MAX = 16 };
enum { ORDINARY, FAR, DISTANCES };

struct entry {
	const char *name;
	const struct peer *peer; /* NULL: projcalc, in this precision */
	enum precision precision;
	double times[RUNS];
	double error[DISTANCES];
};

static struct entry entries[ENTRIES_MAX] = {
	{ .name = "projcalc, exact", .precision = PRECISION_EXACT },
	{ .name = "projcalc, -p double", .precision = PRECISION_DOUBLE },
	{ .name = "projcalc, -p single", .precision = PRECISION_SINGLE },
};
static int n_entries = 3;

static const struct peer *const peers[] = { peers_plain, peers_glm, peers_cglm,
	peers_eigen, peers_wide };

enum { PEERS = sizeof peers / sizeof *peers };

/* A block of points whose coordinates are floats: in columns for projcalc, and in the
 * layout of each peer. */
static COLUMN_ALIGNED double in[3][POINTS_BLOCK], out[4][POINTS_BLOCK];
static _Alignas(64) double peer_in[4 * PEER_BLOCK], peer_out[4 * PEER_BLOCK];

static void set_point(size_t i, const double p[3])
{
	for (int k = 0; k < 3; k++)
		in[k][i] = p[k];
}

static void give(const struct peer *p, size_t n)
{
	float *singles = (float *)(void *)peer_in;

	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < 4; k++) {
			size_t at = i * p->layout.point + k * p->layout.coordinate;
			double value = k < 3 ? in[k][i] : 1;

			if (k == 3 && p->layout.point != 4)
				continue;
			if (p->single)
				singles[at] = (float)value;
			else
				peer_in[at] = value;
		}
}

static double image(const struct entry *e, size_t i, size_t k)
{
	if (e->peer == NULL)
		return out[k][i];
	size_t at = i * e->peer->layout.point + k * e->peer->layout.coordinate;

	return e->peer->single ? (double)((float *)(void *)peer_out)[at] : peer_out[at];
}

/* Returns a random number with ten bits after the point, so that it is a float. */
static double float_between(double a, double b)
{
	return rint(0x1p10 * sample_between(a, b)) * 0x1p-10;
}

/* Returns a random view whose camera is a few units from the point at which it looks;
 * both are far_away from the origin. If far_away is 0, all numbers are floats. A
 * quarter of the views has no far plane. */
static struct view random_view(double far_away)
{
	struct view v = bench_view;
	double direction[3], length = 0;

	for (int k = 0; k < 3; k++) {
		direction[k] = sample_between(-1, 1);
		length = hypot(length, direction[k]);
	}
	for (int k = 0; k < 3; k++) {
		double away = far_away * direction[k] / length;

		v.eye[k] = away + float_between(-5, 5);
		v.at[k] = away + float_between(-5, 5);
	}
	v.fovy = float_between(20, 90);
	v.near = float_between(0.1, 1);
	v.far = sample_below(4) == 0 ? HUGE_VAL : float_between(10, 100);
	compose(&v);
	return v;
}

/* Fills the block with points of the view volume, made from random device points. */
static bool fill(const struct scene *s, const struct view *v, bool floats, size_t n)
{
	struct transform t;

	if (!transform_of_scene(s, SPACE_DEVICE, SPACE_WORLD, false, &t, NULL))
		return false;
	for (size_t i = 0; i < n; i++) {
		double w = sample_between(v->near, fmin(v->far, 100)), p[4],
		       at[4] = { sample_between(0, v->width),
			       sample_between(0, v->height),
			       (1 - v->near / w) / (1 - v->near / v->far) };

		point_exact(&t, at, p);
		for (int k = 0; k < 3; k++)
			p[k] = floats ? (double)(float)p[k] : p[k];
		set_point(i, p);
	}
	return true;
}

static void carry(const struct entry *e, const struct transform *t, size_t n)
{
	const double *const from[4] = { in[0], in[1], in[2] };
	double *const to[4] = { out[0], out[1], out[2], out[3] };

	if (e->peer == NULL)
		points_map(t, e->precision, from, to, n);
	else
		e->peer->carry(peer_in, peer_out, n);
}

static bool takes_part(const struct entry *e, int distance)
{
	return distance == ORDINARY || e->peer == NULL || !e->peer->single;
}

static bool measure_errors(int distance, double far_away)
{
	for (int scene = 0; scene < SCENES; scene++) {
		struct view v = random_view(far_away);
		struct scene s = scene_of(&v);
		struct transform t;
		struct truth truth = { 0 };
		int mark = real_mark();

		if (!fill(&s, &v, distance == ORDINARY, POINTS) ||
		    !transform_of_scene(&s, SPACE_WORLD, SPACE_DEVICE, false, &t, NULL))
			return false;
		truth_scene(&s, SPACE_WORLD, SPACE_DEVICE, &truth);
		for (struct entry *e = entries; e < entries + n_entries; e++) {
			if (!takes_part(e, distance))
				continue;
			if (e->peer != NULL) {
				e->peer->prepare(&v);
				give(e->peer, POINTS);
			}
			carry(e, &t, POINTS);
			for (size_t i = 0; i < POINTS; i++)
				e->error[distance] = fmax(e->error[distance],
				    error_of(&truth,
					(double[]){ in[0][i], in[1][i], in[2][i] },
					(double[]){ image(e, i, 0), image(e, i, 1),
					    image(e, i, 2) }));
		}
		real_release(mark);
	}
	return true;
}

/* Measures the entries in turn, so that a slow moment of the machine slows a run of
 * each. */
static bool measure_times(void)
{
	struct scene s = scene_of(&bench_view);
	struct transform t;

	if (!fill(&s, &bench_view, true, POINTS_BLOCK) ||
	    !transform_of_scene(&s, SPACE_WORLD, SPACE_DEVICE, false, &t, NULL))
		return false;
	for (int run = 0; run < RUNS; run++)
		for (struct entry *e = entries; e < entries + n_entries; e++) {
			if (e->peer != NULL) {
				e->peer->prepare(&bench_view);
				give(e->peer, POINTS_BLOCK);
			}
			carry(e, &t, POINTS_BLOCK); /* into the cache */
			double start = clock_ns();

			for (int i = 0; i < CALLS; i++)
				carry(e, &t, POINTS_BLOCK);
			e->times[run] = (clock_ns() - start) / (CALLS * POINTS_BLOCK);
		}
	return true;
}

static int print_versions(void)
{
#ifdef __clang__
	puts(__VERSION__);
#else
	puts("gcc " __VERSION__);
#endif
	for (int i = 0; i < PEERS; i++) {
		const struct peer *p = peers[i];

		while (p->name != NULL && p->version == NULL)
			p++;
		if (p->name != NULL)
			printf("%.*s %s\n", (int)strcspn(p->name, ","), p->name,
			    p->version);
	}
	return 0;
}

static int run_filter(const char *filter, const char *name)
{
	for (int i = 0; i < PEERS; i++)
		for (const struct peer *p = peers[i]; p->name != NULL; p++) {
			if (strcmp(p->name, name) != 0)
				continue;
			p->prepare(&bench_view);
			return !peer_filter(p, filter);
		}
	return 1;
}

static void print_entry(struct entry *e)
{
	struct timing t = timing_of(e->times, RUNS);

	printf("%s\t%.2f\t%.1e\t", e->name, t.median, e->error[ORDINARY]);
	if (takes_part(e, FAR))
		printf("%.1e\n", e->error[FAR]);
	else
		puts("-");
}

int main(int argc, char **argv)
{
	if (argc == 2 && strcmp(argv[1], "versions") == 0)
		return print_versions();
	compose(&bench_view);
	if (argc == 3)
		return run_filter(argv[1], argv[2]);
	for (int i = 0; i < PEERS; i++)
		for (const struct peer *p = peers[i]; p->name != NULL; p++)
			entries[n_entries++] = (struct entry){ .name = p->name,
				.peer = p };
	kernels_choose(NULL);
	sample_seed(1);
	if (!measure_times() || !measure_errors(ORDINARY, 0) ||
	    !measure_errors(FAR, 1e9))
		return 1;
	for (int e = 0; e < n_entries; e++)
		print_entry(&entries[e]);
	return 0;
}
