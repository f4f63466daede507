/* SPDX-License-Identifier: MIT */
/* Rays, and the points where they meet planes, are the nearest doubles and floats to
 * their true values by MPFR. */
#include "../derive/frustum.h"
#include "../derive/ray.h"

#include "claims.h"
#include "block.h"

/* The homogeneous world point n of a position and depth on the device, and gain, which
 * is the derivative of n / w by depth times w squared. gain is along the ray. */
struct truth_ray {
	struct sized n[4], gain[3], length;
};

static void truth_ray(const struct truth *back, const double at[2], double depth,
    bool against, struct truth_ray *r)
{
	const double p[4] = { at[0], at[1], depth, 1 };
	struct sized sign = sized_of(against ? -1 : 1);

	for (int j = 0; j < 4; j++)
		r->n[j] = truth_column(back, j, p);
	for (int j = 0; j < 3; j++) {
		struct sized a = sized_mul(truth_element(back, 2, j), r->n[3]);
		struct sized b = sized_mul(r->n[j], truth_element(back, 2, 3));

		r->gain[j] = sized_mul(sign, sized_sub(a, b));
	}
	r->length = sized_length(r->gain);
}

/* A block of rays: x, y, the point and the direction. */
struct rays {
	double at[2][POINTS_BLOCK], ray[6][POINTS_BLOCK];
};

static void cast_block(const struct ray_maker *r, bool single, size_t n, struct rays *b)
{
	const double *const at[2] = { b->at[0], b->at[1] };
	double *const out[6] = { b->ray[0], b->ray[1], b->ray[2], b->ray[3], b->ray[4],
		b->ray[5] };

	rays_cast(r, single, at, out, out + 3, n);
}

/* Checks a ray. If there are no near and far planes, it begins at the eye, where clip
 * x, y and w are 0. */
static void check_ray(const struct ray_maker *r, const struct truth *back,
    const struct truth *eye, bool against, const struct rays *b, size_t i, bool single,
    int verdicts[VERDICTS])
{
	const double at[2] = { b->at[0][i], b->at[1][i] };
	struct truth_ray ray;
	bool doubtful;
	int mark = real_mark();

	truth_ray(back, at, r->depth, against, &ray);
	int w = truth_sign(ray.n[3], &doubtful);

	for (int j = 0; j < 3 && !(w != 0 && doubtful); j++) {
		double point = b->ray[j][i], direction = b->ray[3 + j][i];

		if (w <= 0) {
			assert_true(isnan(point) && isnan(direction));
			continue;
		}
		struct sized n = eye != NULL ? truth_element(eye, 2, j) : ray.n[j];
		struct sized d = eye != NULL ? truth_element(eye, 2, 3) : ray.n[3];

		verdicts[truth_verdict(point, n, d, single)]++;
		verdicts[truth_verdict(direction, ray.gain[j], ray.length, single)]++;
	}
	real_release(mark);
}

/* Returns whether device depth falls along rays. */
static bool is_depth_against_rays(const struct scene *s)
{
	return (s->viewport.max_z > s->viewport.min_z) ==
	    projection_is_reversed(&s->projection, &s->convention);
}

/* Samples positions in the middle of the viewport, on its edges and beyond. */
static void sample_positions(const struct viewport *v, size_t n, struct rays *b)
{
	for (size_t i = 0; i < n; i++) {
		b->at[0][i] = v->x + v->width * sample_between(-0.1, 1.1);
		b->at[1][i] = v->y + v->height * sample_unit();
		if (sample_below(2))
			b->at[0][i] = v->x + v->width / 2;
		if (sample_below(4) == 0)
			b->at[1][i] = v->y + v->height / 2;
	}
}

static void rays_are_exact(void **state)
{
	static struct ray_maker r;
	static struct rays b;
	struct scene s;
	int verdicts[VERDICTS] = { 0 };

	(void)state;
	SAMPLES(k, 600) {
		struct truth back = { 0 }, eye = { 0 };
		int mark = real_mark();

		sample_scene(&s, k % 3 * 4);
		sample_answer(&s);
		if (!ray_maker_of(&s, &r, NULL))
			continue;
		bool open = projection_is_open(&s.projection);

		truth_scene(&s, SPACE_DEVICE, SPACE_WORLD, &back);
		truth_scene(&s, SPACE_CLIP, SPACE_WORLD, &eye);
		for (int single = 0; single < 2; single++) {
			sample_positions(&s.viewport, 10, &b);
			cast_block(&r, single, 10, &b);
			for (size_t i = 0; i < 10; i++)
				check_ray(&r, &back, open ? &eye : NULL,
				    is_depth_against_rays(&s), &b, i, single, verdicts);
		}
		real_release(mark);
	}
	print_message("%d numbers, %d within the tolerance\n",
	    verdicts[NEAREST] + verdicts[WITHIN_TOLERANCE], verdicts[WITHIN_TOLERANCE]);
	assert_int_equal(verdicts[WRONG], 0);
	assert_true(verdicts[NEAREST] > 20000 && verdicts[WITHIN_TOLERANCE] < 10);
}

/* A ray does not depend on the other rays of its block. */
static void copies_give_the_same_rays(void **state)
{
	static struct ray_maker r;
	static struct rays first, b;
	struct scene s;

	(void)state;
	SAMPLES(k, 300) {
		size_t n = 1 + sample_below(40);
		bool single = k % 2;

		sample_scene(&s, k % 3 * 4);
		if (!ray_maker_of(&s, &r, NULL))
			continue;
		sample_positions(&s.viewport, n, &first);
		kernels_choose("baseline");
		memcpy(&b, &first, sizeof b);
		cast_block(&r, single, n, &first);
		for (int c = 0; c < COPIES; c++) {
			if (!kernels_choose(copies[c]))
				continue;
			cast_block(&r, single, n, &b);
			for (int j = 0; j < 6; j++)
				assert_memory_equal(first.ray[j], b.ray[j],
				    n * sizeof(double));
			cast_block(&r, single, 1, &b);
			for (int j = 0; j < 6; j++)
				assert_memory_equal(first.ray[j], b.ray[j],
				    sizeof(double));
		}
	}
	kernels_choose(NULL);
}

static void no_position_no_ray(void **state)
{
	static struct ray_maker r;
	static struct rays b;
	struct scene s;

	(void)state;
	sample_seed(4);
	do
		sample_scene(&s, 0);
	while (!ray_maker_of(&s, &r, NULL));
	b.at[0][0] = (double)NAN;
	cast_block(&r, false, 1, &b);
	for (int j = 0; j < 6; j++)
		assert_true(isnan(b.ray[j][0]));
}

/* Computes the homogeneous point where the ray meets the plane p: a (p . b) - b (p .
 * a), on the line through the images a and b of two depths. The point is visible if its
 * clip w has the sign of w, or if the rays are parallel and w is constant. */
static void truth_meeting(const struct truth *back, const struct truth *clip,
    const double plane[4], const double at[2], struct image *image)
{
	const double p[2][4] = { { at[0], at[1], 0, 1 }, { 0, 0, 1, 0 } };
	struct sized h[2][4], through[2], w = sized_of(0);
	bool w_is_constant = true, doubtful;

	for (int k = 0; k < 2; k++) {
		through[k] = sized_of(0);
		for (int j = 0; j < 4; j++) {
			h[k][j] = truth_column(back, j, p[k]);
			through[k] = sized_add(through[k],
			    sized_mul(sized_of(plane[j]), h[k][j]));
		}
	}
	for (int j = 0; j < 4; j++) {
		struct sized n = sized_of(0);

		for (int k = 0; k < 4; k++)
			if (k != j)
				n = sized_add(n,
				    sized_mul(sized_of(plane[k]),
					sized_sub(sized_mul(h[0][j], h[1][k]),
					    sized_mul(h[1][j], h[0][k]))));
		if (j < 3)
			image->n[j] = n;
		else
			image->d = n;
		w = sized_add(w, sized_mul(n, truth_element(clip, j, 3)));
	}
	for (int i = 0; i < 3; i++)
		w_is_constant &= truth_sign(truth_element(clip, i, 3), NULL) == 0;
	int side = truth_sign(w, NULL);
	int w_sign = truth_sign(image->d, &doubtful);

	image->doubtful = doubtful;
	image->exists = w_sign != 0 && (w_is_constant || side == w_sign);
}

static void judge_meetings(const struct scene *s, enum space from, enum space to,
    const double plane[4], const struct transform *t, struct tally *tally)
{
	static struct rays b;
	static struct block block;
	struct truth back = { 0 }, clip = { 0 };
	double depth = sample_unit();

	truth_scene(s, from, to, &back);
	truth_scene(s, to, SPACE_CLIP, &clip);
	sample_positions(&s->viewport, POINTS, &b);
	memcpy(block.in, b.at, sizeof b.at);
	for (size_t i = 0; i < POINTS && from == SPACE_NDC; i++)
		for (int k = 0; k < 2; k++)
			block.in[k][i] = sample_between(-1, 1) * depth;
	map_block_exactly(t, &block, POINTS);
	for (size_t i = 0; i < POINTS; i++) {
		const double at[2] = { block.in[0][i], block.in[1][i] };
		double got[3] = { block.out[0][i], block.out[1][i], block.out[2][i] };
		int mark = real_mark();
		struct image image;

		truth_meeting(&back, &clip, plane, at, &image);
		judge_image(&image, 3, got, false, tally);
		real_release(mark);
	}
}

/* Samples planes near the origin, through the origin, or far from it. */
static void sample_plane(int e, double plane[4])
{
	do
		for (int k = 0; k < 4; k++)
			plane[k] = e > 0    ? sample_number(e) :
			    sample_below(2) ? (double)sample_below(5) - 2 :
					      sample_between(-5, 5);
	while (plane[0] == 0 && plane[1] == 0 && plane[2] == 0);
}

static void planes_are_met(void **state)
{
	struct scene s;
	struct tally tally = { { 0 } };
	static struct transform t;
	int n = 0;

	(void)state;
	kernels_choose(NULL);
	SAMPLES(k, 600) {
		enum space from = sample_below(2) ? SPACE_DEVICE : SPACE_NDC;
		enum space to = (enum space)sample_below(3);
		double plane[4];
		int mark = real_mark();

		sample_scene(&s, k % 3 * 4);
		sample_answer(&s);
		sample_plane(k % 3 * 2, plane);
		if (!ray_plane_transform(&s, from, to, plane, &t, NULL))
			continue;
		judge_meetings(&s, from, to, plane, &t, &tally);
		real_release(mark);
		n++;
	}
	print_message("%d planes, %zu numbers, %zu within the tolerance\n", n,
	    tally.n[NEAREST] + tally.n[WITHIN_TOLERANCE], tally.n[WITHIN_TOLERANCE]);
	assert_true(n > 300 && tally.n[NEAREST] > 10000);
	assert_true(tally.n[WITHIN_TOLERANCE] < tally.n[NEAREST] / 100);
	assert_int_equal(tally.n[WRONG], 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(rays_are_exact),
		cmocka_unit_test(copies_give_the_same_rays),
		cmocka_unit_test(no_position_no_ray),
		cmocka_unit_test(planes_are_met),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
