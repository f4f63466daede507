/* SPDX-License-Identifier: MIT */
/* Counts the points that the kernels of exact.h leave undecided, and those of them that
 * the kernels of doubled.h leave to core/points/point.c, which has more bits. A bound
 * that is too large, or a test that is too strict, changes no printed number and only
 * costs time. The counts are recorded: a change of a count needs a reason. Every
 * compiler gives the same counts, and kernels with fused products differ by at most
 * two. The coordinates are made without the mathematical library, as its last bits
 * differ between systems. */
#include "claims.h"
#include "block.h"

#include "../derive/ray.h"

enum { BLOCKS = 24 };

/* The counters of undecided points, one for each transform in count_block. */
enum { AFFINE, RATIONAL, FLAT, DEPTH, PROJECTIVE, RAY, COUNTERS };

/* A kind of scenes and points. Coordinates of the eye are from 2^eye_low to
 * 2^eye_high, and coordinates relative to the eye from 2^low to 2^high, with this many
 * binary digits. Blocks are scaled in turn by the powers from 2^least to below 2^most.
 * undecided and left have the recorded counts of the two phases, out of BLOCKS times
 * POINTS_BLOCK points. Rays have no second phase. */
static const struct regime {
	const char *name;
	int eye_low, eye_high, low, high, digits, least, most;
	unsigned undecided[COUNTERS], left[COUNTERS];
} regimes[] = {
	{ "usual", 0, 4, -3, 4, 53, 0, 1, { 12, 39, 9, 12, 3, 3 }, { 0 } },
	{ "short", 0, 4, -3, 4, 7, 0, 1, { 8, 0, 19, 20, 6, 3 },
	    { 0, 0, 19, 0, 0, 0 } },
	{ "far off", 30, 34, -3, 4, 53, 0, 1, { 6, 20, 6, 13, 1, 4 }, { 0 } },
	{ "farther off", 44, 74, -3, 4, 53, 0, 1, { 947, 29, 5, 6071, 1, 5 },
	    { 943, 0, 0, 6063, 0, 0 } },
	{ "mixed", 0, 4, -24, 14, 53, 0, 1, { 13381, 14069, 8638, 5383, 1, 2 },
	    { 0, 2 } },
	{ "times 2^40", 0, 4, -3, 4, 53, 40, 64, { 15, 11, 19, 14, 6, 2 }, { 0 } },
	{ "times 2^84", 0, 4, -3, 4, 53, 84, 108, { 14, 11270, 8, 11, 2, 6 },
	    { 0, 10686, 0, 0, 0, 0 } },
	{ "times 2^110", 0, 4, -3, 4, 53, 110, 134, { 15, 24576, 4, 11, 5, 5 },
	    { 0, 24576, 0, 0, 0, 0 } },
	{ "times 2^182", 0, 4, -3, 4, 53, 182, 206,
	    { 9223, 24576, 10242, 18436, 7169, 3 }, { 7987, 24576, 0, 11972, 0, 0 } },
	{ "times 2^208", 0, 4, -3, 4, 53, 208, 232,
	    { 24576, 24576, 24576, 24576, 24576, 4 },
	    { 24576, 24576, 0, 24576, 4, 0 } },
	{ "times 2^-92", 0, 4, -3, 4, 53, -92, -68, { 18, 0, 9, 16, 1, 3 }, { 0 } },
	{ "times 2^-142", 0, 4, -3, 4, 53, -142, -118, { 10, 0, 0, 7, 3, 4 }, { 0 } },
	{ "times 2^-206", 0, 4, -3, 4, 53, -206, -182,
	    { 3087, 6144, 3088, 3079, 6147, 3 }, { 0, 0, 0, 0, 6144, 0 } },
};

enum { REGIMES = sizeof regimes / sizeof *regimes };

static int scale; /* all random numbers are scaled by 2^scale */

static double random_number(int low, int high, int digits)
{
	int e = scale + low + (int)sample_below((unsigned)(high - low));
	double v = ldexp(floor(ldexp(1 + sample_unit(), digits - 1)), e + 1 - digits);

	return sample_below(2) ? v : -v;
}

static double random_size(const struct regime *r)
{
	return fabs(random_number(r->low, r->high, r->digits));
}

static void sample_regime_scene(const struct regime *r, struct scene *s)
{
	*s = (struct scene){ .has_world = true,
		.has_camera = true,
		.camera = { .way = CAMERA_GAZE, .up = { 0, 1, 0.25 } },
		.projection = { .type = PROJECTION_PERSP,
		    .section.way = SECTION_EDGES,
		    .section.left = -1.25,
		    .section.bottom = -1,
		    .section.right = 1,
		    .section.top = 1.5,
		    .near = random_size(r),
		    .section.edges_at = 1 },
		.has_viewport = true,
		.viewport = { .width = 640, .height = 480, .max_z = 1 },
		.has_window = true,
		.window = { .width = random_size(r),
		    .height = random_size(r),
		    .zoom = 1 },
		.has_device = true,
		.device = { .width = 640, .height = 480 } };
	s->projection.far = s->projection.near * 64;
	for (int i = 0; i < 4; i++) {
		double eye = random_number(r->eye_low, r->eye_high, r->digits);

		for (int k = 0; k < 3; k++)
			s->world.matrix[i][k] = random_number(r->low, r->high,
			    r->digits);
		s->world.matrix[i][3] = i == 3;
		if (i == 3)
			break;
		s->camera.eye[i] = eye;
		s->camera.at[i] = random_number(r->low, r->high, r->digits);
		s->window.center[i % 2] = eye;
	}
}

static void sample_regime_points(const struct regime *r, const double about[3],
    struct block *b)
{
	for (size_t i = 0; i < POINTS_BLOCK; i++)
		for (int k = 0; k < 3; k++)
			b->in[k][i] = about[k] +
			    random_number(r->low, r->high, r->digits);
}

static void sample_pixels(const struct regime *r, struct block *b)
{
	scale = 0;
	for (size_t i = 0; i < POINTS_BLOCK; i++)
		for (int k = 0; k < 3; k++)
			b->in[k][i] = fabs(
			    random_number(k < 2 ? 0 : -6, k < 2 ? 9 : 0, r->digits));
}

/* The counters of both phases. */
struct counts {
	unsigned undecided[COUNTERS], left[COUNTERS];
};

static unsigned count_nan(const struct block *b)
{
	unsigned n = 0;

	for (size_t i = 0; i < POINTS_BLOCK; i++)
		n += isnan(b->out[0][i]) ? 1 : 0;
	return n;
}

/* Counts the points that the kernels leave undecided: they set them to nan. */
static void count_kernels(enum kernel_kind kind, const struct kernel_map *m,
    struct block *b, struct counts *n, int counter)
{
	const double *const in[3] = { b->in[0], b->in[1], b->in[2] };
	double *const out[3] = { b->out[0], b->out[1], b->out[2] };

	kernels_chosen()->exact[kind](m, in, out, POINTS_BLOCK);
	n->undecided[counter] += count_nan(b);
	if (counter == RAY)
		return;
	kernels_chosen()->doubled[kind](m, in, out, POINTS_BLOCK);
	n->left[counter] += count_nan(b);
}

static void count_transform(const struct transform *t, enum kernel_kind kind,
    struct block *b, struct counts *n, int counter)
{
	assert_int_equal(t->kernel, kind);
	count_kernels(kind, &t->for_kernel, b, n, counter);
}

static void count_block(const struct regime *r, struct block *b, struct counts *n)
{
	struct scene s;
	struct transform t;
	struct ray_maker ray;
	static const double origin[3] = { 0 };

	sample_regime_scene(r, &s);
	sample_regime_points(r, origin, b);
	assert_true(transform_of_scene(&s, SPACE_MODEL, SPACE_WORLD, false, &t, NULL));
	count_transform(&t, KERNEL_AFFINE, b, n, RATIONAL);
	sample_regime_points(r, s.camera.eye, b);
	assert_true(transform_of_scene(&s, FLAT_WINDOW, FLAT_DEVICE, false, &t, NULL));
	count_transform(&t, KERNEL_FLAT, b, n, FLAT);
	sample_regime_points(r, s.camera.eye, b);
	assert_true(transform_of_scene(&s, SPACE_WORLD, SPACE_VIEW, false, &t, NULL));
	count_transform(&t, KERNEL_AFFINE, b, n, AFFINE);
	assert_true(transform_of_scene(&s, SPACE_WORLD, SPACE_DEVICE, false, &t, NULL));
	count_transform(&t, KERNEL_DEPTH, b, n, DEPTH);
	sample_pixels(r, b);
	assert_true(transform_of_scene(&s, SPACE_DEVICE, SPACE_WORLD, false, &t, NULL));
	count_transform(&t, KERNEL_PROJECTIVE, b, n, PROJECTIVE);
	assert_true(ray_maker_of(&s, &ray, NULL));
	count_kernels(KERNEL_DIRECTION, &ray.direction.for_kernel, b, n, RAY);
}

/* Asserts that the counts differ from the recorded ones by at most most_off. */
static void check_counts(const char *copy, const struct regime *r,
    const unsigned n[COUNTERS], const unsigned recorded[COUNTERS], double most_off)
{
	bool same = true;

	for (int w = 0; w < COUNTERS; w++)
		same &= fabs((double)n[w] - recorded[w]) <= most_off;
	if (same)
		return;
	print_error("%s, %s: expected and came", copy, r->name);
	for (int w = 0; w < COUNTERS; w++)
		print_error(" %u %u,", recorded[w], n[w]);
	print_error("\n");
	fail_msg("if the change is meant, record the counts of baseline in "
		 "regimes, core/test/sure_test.c");
}

static void counts_are_as_recorded(void **state)
{
	static struct block b;

	(void)state;
	for (int c = 0; c < COPIES; c++) {
		if (!kernels_choose(copies[c]))
			continue;
		sample_seed(1);
		for (int k = 0; k < REGIMES; k++) {
			const struct regime *r = &regimes[k];
			const double off = c == 0 ? 0 : 2;
			struct counts n = { 0 };

			for (int i = 0; i < BLOCKS; i++) {
				scale = r->least + i % (r->most - r->least);
				count_block(r, &b, &n);
			}
			check_counts(copies[c], r, n.undecided, r->undecided, off);
			check_counts(copies[c], r, n.left, r->left, off);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(counts_are_as_recorded),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
