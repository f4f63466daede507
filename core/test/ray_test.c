/* SPDX-License-Identifier: MIT */
/* Rays: the nearest doubles and floats. */
#include "../derive/ray.h"

#include "claims.h"
#include "points.h"

/* The image of a device position and depth, and what it gains with depth, times
 * w squared. */
struct truth_ray {
	struct form n[4], gain[3], length;
};

static void truth_ray(const struct truth *back, const double at[2],
    double depth, bool against, struct truth_ray *r)
{
	const double p[4] = { at[0], at[1], depth, 1 };
	struct form sign = form_of(against ? -1 : 1);

	for (int j = 0; j < 4; j++)
		r->n[j] = truth_column(back, j, p);
	for (int j = 0; j < 3; j++) {
		struct form a = form_mul(truth_element(back, 2, j), r->n[3]);
		struct form b = form_mul(r->n[j], truth_element(back, 2, 3));

		r->gain[j] = form_mul(sign, form_sub(a, b));
	}
	r->length = form_length(r->gain);
}

/* A block of rays: x, y, the point and the direction. */
struct rays {
	double at[2][POINTS_BLOCK], ray[6][POINTS_BLOCK];
};

static void cast(const struct ray_maker *r, bool single, size_t n,
    struct rays *b)
{
	const double *const at[2] = { b->at[0], b->at[1] };
	double *const out[6] = { b->ray[0], b->ray[1], b->ray[2], b->ray[3],
		b->ray[4], b->ray[5] };

	rays_cast(r, single, at, out, out + 3, n);
}

/* Where there are no planes it begins where clip x, y and w are 0. */
static void check_ray(const struct ray_maker *r, const struct truth *back,
    const struct truth *eye, bool against, const struct rays *b, size_t i,
    bool single, int verdicts[VERDICTS])
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
		struct form n = eye != NULL ? truth_element(eye, 2, j) :
					      ray.n[j];
		struct form d = eye != NULL ? truth_element(eye, 2, 3) :
					      ray.n[3];

		verdicts[truth_verdict(point, n, d, single)]++;
		verdicts[truth_verdict(direction, ray.gain[j], ray.length,
		    single)]++;
	}
	real_release(mark);
}

/* Whether device depth falls away from the eye. */
static bool against(const struct scene *s)
{
	return (s->viewport.max_z > s->viewport.min_z) ==
	    projection_is_reversed(&s->projection, &s->convention);
}

/* In the middle, on the edges and beyond. */
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
	sample_seed(3);
	for (int k = 0; k < 600; k++) {
		struct truth back = { 0 }, eye = { 0 };
		int mark = real_mark();

		sample_scene(&s, k % 3 * 4);
		sample_answer(&s);
		if (ray_maker_of(&s, &r) != NULL)
			continue;
		bool open = projection_is_open(&s.projection);

		truth_scene(&s, SPACE_DEVICE, SPACE_WORLD, &back);
		truth_scene(&s, SPACE_CLIP, SPACE_WORLD, &eye);
		for (int single = 0; single < 2; single++) {
			sample_positions(&s.viewport, 10, &b);
			cast(&r, single, 10, &b);
			for (size_t i = 0; i < 10; i++)
				check_ray(&r, &back, open ? &eye : NULL,
				    against(&s), &b, i, single, verdicts);
		}
		real_release(mark);
	}
	print_message("%d numbers, %d within the rule\n",
	    verdicts[NEAREST] + verdicts[RULED], verdicts[RULED]);
	assert_int_equal(verdicts[WRONG], 0);
	assert_true(verdicts[NEAREST] > 20000 && verdicts[RULED] < 10);
}

/* Nor does a ray depend on the others of its block. */
static void copies_give_the_same_rays(void **state)
{
	static struct ray_maker r;
	static struct rays first, b;
	struct scene s;

	(void)state;
	sample_seed(5);
	for (int k = 0; k < 300; k++) {
		size_t n = 1 + sample_below(40);
		bool single = k % 2;

		sample_scene(&s, k % 3 * 4);
		if (ray_maker_of(&s, &r) != NULL)
			continue;
		sample_positions(&s.viewport, n, &first);
		points_choose("baseline");
		memcpy(&b, &first, sizeof b);
		cast(&r, single, n, &first);
		for (int c = 0; c < COPIES; c++) {
			if (!points_choose(copies[c]))
				continue;
			cast(&r, single, n, &b);
			for (int j = 0; j < 6; j++)
				assert_memory_equal(first.ray[j], b.ray[j],
				    n * sizeof(double));
			cast(&r, single, 1, &b);
			for (int j = 0; j < 6; j++)
				assert_memory_equal(first.ray[j], b.ray[j],
				    sizeof(double));
		}
	}
	points_choose(NULL);
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
	while (ray_maker_of(&s, &r) != NULL);
	b.at[0][0] = (double)NAN;
	cast(&r, false, 1, &b);
	for (int j = 0; j < 6; j++)
		assert_true(isnan(b.ray[j][0]));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(rays_are_exact),
		cmocka_unit_test(copies_give_the_same_rays),
		cmocka_unit_test(no_position_no_ray),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
