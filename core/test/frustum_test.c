/* SPDX-License-Identifier: MIT */
/* The OUT_ bits of frustum_outside, one for each plane of the view volume, agree with
 * the signs that MPFR computes. */
#include "../derive/frustum.h"

#include "claims.h"
#include "block.h"

/* Moves every second point onto a plane of the volume, but for rounding. */
static void onto_planes(const struct scene *s, enum space from, struct block *b)
{
	struct transform t;
	static struct block image;

	if (!transform_of_scene(s, SPACE_NDC, from, false, &t, NULL))
		return;
	for (size_t i = 0; i < POINTS; i++) {
		for (int j = 0; j < 3; j++)
			image.in[j][i] = sample_between(-1, 1);
		image.in[sample_below(3)][i] = (double)sample_below(3) - 1;
	}
	map_block_exactly(&t, &image, POINTS);
	for (size_t i = 0; i < POINTS; i += 2)
		for (int j = 0; j < 3 && !isnan(image.out[0][i]); j++)
			b->in[j][i] = image.out[j][i];
}

struct count {
	size_t planes, on, doubtful;
};

static void check_planes(const struct scene *s, const struct truth *to_clip,
    const struct truth *to_view, bool back, const double p[4], unsigned out,
    struct count *c)
{
	struct sized q[4], plane[6];
	bool doubtful;

	for (int j = 0; j < 4; j++)
		q[j] = truth_column(to_clip, j, p);
	int w = truth_sign(back ? truth_column(to_view, 3, p) : q[3], &doubtful);

	doubtful &= to_view->irrational || to_clip->irrational;
	c->doubtful += w != 0 && doubtful;
	if (w != 0 && doubtful)
		return;
	assert_int_equal(out == OUT_BEHIND, w <= 0);
	if (w <= 0)
		return;
	truth_planes(s, q, plane);
	if (projection_is_open(&s->projection))
		assert_false(out & (OUT_NEAR | OUT_FAR));
	for (int k = 0; k < (projection_is_open(&s->projection) ? 4 : 6); k++) {
		int sign = truth_sign(plane[k], &doubtful);

		doubtful &= to_clip->irrational;
		c->planes++;
		c->on += sign == 0;
		c->doubtful += sign != 0 && doubtful;
		if (sign == 0 || !doubtful)
			assert_int_equal(out >> k & 1, sign < 0);
	}
}

/* Samples a scene, a space, the frustum in this space, and points, some on planes. The
 * scene has round numbers if e is negative. */
static bool sample_frustum(int e, struct scene *s, enum space *from, struct frustum *f,
    struct block *b)
{
	static const enum space spaces[] = { SPACE_MODEL, SPACE_WORLD, SPACE_VIEW,
		SPACE_NDC, SPACE_DEVICE };

	if (e < 0)
		sample_round_scene(s);
	else
		sample_scene(s, e);
	sample_answer(s);
	s->has_viewport = sample_below(4) > 0;
	*from = spaces[sample_below(s->has_viewport ? 5 : 4)];
	if (!frustum_of(s, *from, false, f, NULL))
		return false;
	if (e < 0) {
		sample_round_points(b, POINTS);
		return true;
	}
	sample_points(s, *from, b, POINTS);
	onto_planes(s, *from, b);
	if (sample_below(2))
		b->in[sample_below(3)][0] = (double)NAN;
	return true;
}

static bool has_nan(const double p[4])
{
	return isnan(p[0]) || isnan(p[1]) || isnan(p[2]);
}

static void planes_agree_with_mpfr(void **state)
{
	static struct block b;
	static struct frustum f;
	struct scene s;
	enum space from;
	struct count c = { 0 };
	unsigned char all[POINTS];

	(void)state;
	kernels_choose(NULL);
	SAMPLES(k, 1200) {
		struct truth to_clip = { 0 }, to_view = { 0 };
		int mark = real_mark();

		if (!sample_frustum((k % 4 - 1) * 4, &s, &from, &f, &b))
			continue;
		truth_scene(&s, from, SPACE_CLIP, &to_clip);
		truth_scene(&s, from, SPACE_VIEW, &to_view);
		frustum_outside_all(&f,
		    (const double *[4]){ b.in[0], b.in[1], b.in[2] }, all, POINTS);
		for (size_t i = 0; i < POINTS; i++) {
			double p[4] = { b.in[0][i], b.in[1][i], b.in[2][i], 1 };
			unsigned out = frustum_outside(&f, p);
			int point = real_mark();

			assert_int_equal(all[i], out);
			if (has_nan(p))
				assert_int_equal(out, OUT_NAN);
			else
				check_planes(&s, &to_clip, &to_view, from >= SPACE_NDC,
				    p, out, &c);
			real_release(point);
		}
		real_release(mark);
	}
	print_message("%zu planes, on %zu of them the point; %zu within the "
		      "tolerance\n",
	    c.planes, c.on, c.doubtful);
	assert_true(c.planes > 10000 && c.on > 500 && c.doubtful < c.planes / 1000);
}

/* Points one unit in the last place from a plane, and at far smaller distances that
 * doubles can tell from 0. */
static void tiny_distances_are_exact(void **state)
{
	struct scene s = { .has_world = true,
		.world.matrix = { { 1, 0, 0, 0 }, { 1, 1, 0, 0 }, { 0, 0, 1, 0 },
		    { 0, 0, 0, 1 } } };
	struct frustum f;

	(void)state;
	assert_true(frustum_of(&s, SPACE_MODEL, false, &f, NULL));
	for (int e = 1; e < 1074; e++) {
		double tiny = ldexp(1, -e), y = e < 54 ? 0 : tiny;
		double x = e < 54 ? 1 + tiny : 1;

		if (x > 1 || y > 0)
			assert_int_equal(frustum_outside(&f,
					     (double[4]){ x, y, 0.5, 1 }),
			    OUT_RIGHT);
		x = e < 54 ? 1 - tiny : 1;
		assert_int_equal(frustum_outside(&f, (double[4]){ x, -y, 0.5, 1 }), 0);
		assert_int_equal(frustum_outside(&f, (double[4]){ -x, -y, 0.5, 1 }),
		    y > 0 ? OUT_LEFT : 0);
	}
}

/* Many points give the same bits at once and one by one. Their magnitudes let products
 * underflow, overflow, or neither. There are more points than a call of the kernel
 * takes. */
static void all_points_agree_with_each(void **state)
{
	enum { MANY = 1000 };
	static double in[4][MANY];
	static unsigned char out[MANY];
	struct scene s;
	struct frustum f;

	(void)state;
	SAMPLES(k, 300) {
		/* the last choice stays if the processor lacks this one */
		kernels_choose(copies[k / 6 % 4]);
		sample_scene(&s, k % 3 * 4);
		bool homogeneous = k % 5 == 0 && s.has_viewport;
		enum space from = homogeneous ? SPACE_DEVICE : SPACE_WORLD;

		if (!frustum_of(&s, from, homogeneous, &f, NULL))
			continue;
		for (size_t i = 0; i < MANY; i++)
			for (int j = 0; j < 4; j++)
				in[j][i] = ldexp(sample_between(-1, 1),
				    k % 2 ? (int)sample_below(20) :
					    (int)sample_below(1560) - 1070);
		in[k % 3][k] = (double)NAN;
		frustum_outside_all(&f,
		    (const double *[4]){ in[0], in[1], in[2], in[3] }, out, MANY);
		for (size_t i = 0; i < MANY; i++)
			assert_int_equal(out[i],
			    frustum_outside(&f,
				(double[4]){ in[0][i], in[1][i], in[2][i], in[3][i] }));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(planes_agree_with_mpfr),
		cmocka_unit_test(tiny_distances_are_exact),
		cmocka_unit_test(all_points_agree_with_each),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
