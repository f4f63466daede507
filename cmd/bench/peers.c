/* Our precisions beside other people's libraries, on points in memory:
 * nanoseconds a point, and the worst error in device units against MPFR.
 *
 * usage: peers              a row each, with tabs between its fields: name,
 *                           least and median ns a point, worst error in
 *                           ordinary scenes, the same in scenes 1e9 away
 *        peers versions     the versions of the libraries it was built with
 *        peers filter NAME  text in, text out; fails if NAME was not there
 *                           when it was built */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../../core/bench/clock.h"
#include "../../core/points.h"
#include "../../core/test/sample.h"
#include "../../core/test/truth.h"
#include "peer/peer.h"

enum { RUNS = 201, CALLS = 4, SCENES = 40, POINTS = 200, OURS = 4 };
enum { ENTRIES_MAX = 16 };

struct entry {
	const char *name;
	const struct peer *peer; /* NULL: ours, with this accuracy */
	struct accuracy accuracy;
	double times[RUNS];
	double error[2]; /* ordinary, far */
};

static struct entry entries[ENTRIES_MAX] = {
	{ .name = "projcalc exact", .accuracy = { PRECISION_EXACT, { 0 } } },
	{ .name = "projcalc double", .accuracy = { PRECISION_DOUBLE, { 0 } } },
	{ .name = "projcalc single", .accuracy = { PRECISION_SINGLE, { 0 } } },
	{ .name = "projcalc -t 0.5",
	    .accuracy = { PRECISION_EXACT, { 0.5, 0.5, 0.5 } } },
};
static int n_entries = OURS;

static const struct peer *const peers[] = { peers_glm, peers_cglm,
	peers_eigen };

enum { PEERS = sizeof peers / sizeof *peers };

static const struct view bench_view = { .eye = { 1, 2, -5 },
	.at = { 0.1, 0.2, 0.3 },
	.up = { 0, 1, 0 },
	.fovy = 60,
	.near = 1,
	.far = 10,
	.width = 640,
	.height = 480 };

/* One block of points, in columns for us and side by side for the others. */
static COLUMN_ALIGNED double in[3][POINTS_BLOCK], out[4][POINTS_BLOCK];
static double doubles_in[POINTS_BLOCK][3], doubles_out[POINTS_BLOCK][3];
static float floats_in[POINTS_BLOCK][3], floats_out[POINTS_BLOCK][3];

static struct scene scene_of(const struct view *v)
{
	struct scene s = {
		.has_camera = true,
		.camera = { .by = CAMERA_AT },
		.projection = { .type = PROJECTION_PERSP,
		    .extent = EXTENT_FOVY,
		    .angle = v->fovy,
		    .aspect = { v->width, v->height },
		    .near = v->near,
		    .far = v->far },
		.has_viewport = true,
		.viewport = { .width = v->width,
		    .height = v->height,
		    .max_z = 1 },
	};

	memcpy(s.camera.eye, v->eye, sizeof v->eye);
	memcpy(s.camera.at, v->at, sizeof v->at);
	memcpy(s.camera.up, v->up, sizeof v->up);
	return s;
}

/* Fills the block with points of the view volume: device points, taken back
 * into the world. */
static bool fill(const struct scene *s, const struct view *v, size_t n)
{
	struct transform t;

	if (scene_transform(s, SPACE_DEVICE, SPACE_WORLD, false, &t) != NULL)
		return false;
	for (size_t i = 0; i < n; i++) {
		double w = sample_between(v->near, v->far);
		double p[4],
		    at[4] = { sample_between(0, v->width),
			    sample_between(0, v->height),
			    v->far * (w - v->near) / (w * (v->far - v->near)) };

		point_exact(&t, at, p);
		for (int k = 0; k < 3; k++) {
			in[k][i] = doubles_in[i][k] = p[k];
			floats_in[i][k] = (float)p[k];
		}
	}
	return true;
}

static void carry(const struct entry *e, const struct transform *t, size_t n)
{
	const double *const from[4] = { in[0], in[1], in[2] };
	double *const to[4] = { out[0], out[1], out[2], out[3] };

	if (e->peer == NULL)
		points_carry(t, &e->accuracy, from, to, n);
	else if (e->peer->single)
		e->peer->carry(floats_in, floats_out, n);
	else
		e->peer->carry(doubles_in, doubles_out, n);
}

static double image(const struct entry *e, size_t i, int k)
{
	if (e->peer == NULL)
		return out[k][i];
	return e->peer->single ? (double)floats_out[i][k] : doubles_out[i][k];
}

/* The worst error of the images that an entry has computed, against the truth.
 * What is no number counts as infinitely wrong. */
static double worst_error(const struct entry *e, const struct truth *truth,
    size_t n)
{
	double worst = 0;

	for (size_t i = 0; i < n; i++) {
		int mark = real_mark();
		double p[4] = { in[0][i], in[1][i], in[2][i], 1 };
		real q[4], sum[4];

		truth_image(truth, p, q, sum);
		for (int k = 0; k < 3; k++) {
			double got = image(e, i, k);

			if (!isfinite(got)) {
				worst = (double)INFINITY;
				continue;
			}
			real error = sub(over(q[k], q[3]), number(got));

			worst = fmax(worst,
			    mpfr_get_d(magnitude(error), MPFR_RNDU));
		}
		real_release(mark);
	}
	return worst;
}

/* A camera a few units from what it looks at, and both as far from the origin
 * as far_away. */
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

		v.eye[k] = away + sample_between(-5, 5);
		v.at[k] = away + sample_between(-5, 5);
	}
	v.fovy = sample_between(20, 90);
	v.near = sample_between(0.1, 1);
	v.far = sample_between(10, 100);
	return v;
}

static bool measure_errors(int which, double far_away)
{
	for (int k = 0; k < SCENES; k++) {
		struct view v = random_view(far_away);
		struct scene s = scene_of(&v);
		struct transform t;
		struct truth truth = { 0 };
		int mark = real_mark();

		if (!fill(&s, &v, POINTS) ||
		    scene_transform(&s, SPACE_WORLD, SPACE_DEVICE, false, &t) !=
			NULL)
			return false;
		truth_scene(&s, SPACE_WORLD, SPACE_DEVICE, &truth);
		for (int e = 0; e < n_entries; e++) {
			struct entry *a = &entries[e];

			if (a->peer != NULL)
				a->peer->prepare(&v);
			carry(a, &t, POINTS);
			a->error[which] = fmax(a->error[which],
			    worst_error(a, &truth, POINTS));
		}
		real_release(mark);
	}
	return true;
}

/* The entries take turns, so that what slows the machine down for a while slows
 * a run of each. */
static bool measure_times(void)
{
	struct scene s = scene_of(&bench_view);
	struct transform t;

	if (!fill(&s, &bench_view, POINTS_BLOCK) ||
	    scene_transform(&s, SPACE_WORLD, SPACE_DEVICE, false, &t) != NULL)
		return false;
	for (int e = 0; e < n_entries; e++)
		if (entries[e].peer != NULL)
			entries[e].peer->prepare(&bench_view);
	for (int run = -1; run < RUNS; run++)
		for (int e = 0; e < n_entries; e++) {
			double start = clock_ns();

			for (int i = 0; i < CALLS; i++)
				carry(&entries[e], &t, POINTS_BLOCK);
			if (run >= 0) /* the first warms up */
				entries[e].times[run] = (clock_ns() - start) /
				    (CALLS * POINTS_BLOCK);
		}
	return true;
}

static void find_peers(void)
{
	for (int i = 0; i < PEERS; i++)
		for (const struct peer *p = peers[i]; p->name != NULL; p++)
			entries[n_entries++] = (struct entry){ .name = p->name,
				.peer = p };
}

static int print_versions(void)
{
#ifdef __clang__
	puts(__VERSION__);
#else
	puts("gcc " __VERSION__);
#endif
	for (int i = 0; i < PEERS; i++)
		if (peers[i]->name != NULL)
			printf("%.*s %s\n", (int)strcspn(peers[i]->name, " "),
			    peers[i]->name, peers[i]->version);
	return 0;
}

static int run_filter(const char *name)
{
	for (int e = OURS; e < n_entries; e++) {
		const struct peer *p = entries[e].peer;

		if (strcmp(p->name, name) != 0 || p->filter == NULL)
			continue;
		p->prepare(&bench_view);
		p->filter();
		return fflush(stdout) != 0;
	}
	return 1;
}

int main(int argc, char **argv)
{
	find_peers();
	if (argc == 2 && strcmp(argv[1], "versions") == 0)
		return print_versions();
	if (argc == 3 && strcmp(argv[1], "filter") == 0)
		return run_filter(argv[2]);
	points_choose(NULL);
	sample_seed(1);
	if (!measure_times() || !measure_errors(0, 0) ||
	    !measure_errors(1, 1e9))
		return 1;
	for (int e = 0; e < n_entries; e++) {
		struct timing t = timing_of(entries[e].times, RUNS);

		printf("%s\t%.2f\t%.2f\t%.1e\t%.1e\n", entries[e].name, t.min,
		    t.median, entries[e].error[0], entries[e].error[1]);
	}
	return 0;
}
