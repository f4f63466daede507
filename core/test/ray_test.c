/* Rays: the nearest doubles and floats. */
#include "../ray.h"

#include "claims.h"

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

/* Where there are no planes it begins where clip x, y and w are 0. */
static void check_ray(const struct ray_maker *r, const struct truth *back,
    const struct truth *eye, const double at[2], bool single,
    int verdicts[VERDICTS])
{
	double point[3], direction[3];
	struct truth_ray ray;
	bool doubtful;
	int mark = real_mark();

	ray_exact(r, at, single, point, direction);
	truth_ray(back, at, r->depth, r->against, &ray);
	int w = truth_sign(ray.n[3], &doubtful);

	for (int j = 0; j < 3 && !(w != 0 && doubtful); j++) {
		if (w <= 0) {
			assert_true(isnan(point[j]) && isnan(direction[j]));
			continue;
		}
		struct form n = eye != NULL ? truth_element(eye, 2, j) :
					      ray.n[j];
		struct form d = eye != NULL ? truth_element(eye, 2, 3) :
					      ray.n[3];

		verdicts[truth_verdict(point[j], n, d, single)]++;
		verdicts[truth_verdict(direction[j], ray.gain[j], ray.length,
		    single)]++;
	}
	real_release(mark);
}

/* In the middle, on the edges and beyond. */
static void sample_position(const struct viewport *v, double at[2])
{
	at[0] = v->x + v->width * sample_between(-0.1, 1.1);
	at[1] = v->y + v->height * sample_unit();
	if (sample_below(2))
		at[0] = v->x + v->width / 2;
	if (sample_below(4) == 0)
		at[1] = v->y + v->height / 2;
}

static void rays_are_exact(void **state)
{
	static struct ray_maker r;
	struct scene s;
	int verdicts[VERDICTS] = { 0 };

	(void)state;
	sample_seed(3);
	for (int k = 0; k < 600; k++) {
		struct truth back = { 0 }, eye = { 0 };
		bool open;
		int mark = real_mark();

		sample_scene(&s, k % 3 * 4);
		sample_answer(&s);
		if (ray_maker_of(&s, &r) != NULL)
			continue;
		truth_scene(&s, SPACE_DEVICE, SPACE_WORLD, &back);
		truth_scene(&s, SPACE_CLIP, SPACE_WORLD, &eye);
		open = projection_is_open(&s.projection);
		for (int i = 0; i < 20; i++) {
			double at[2];

			sample_position(&s.viewport, at);
			check_ray(&r, &back, open ? &eye : NULL, at, i % 2,
			    verdicts);
		}
		real_release(mark);
	}
	print_message("%d numbers, %d by the 2^-190 rule\n",
	    verdicts[NEAREST] + verdicts[RULED], verdicts[RULED]);
	assert_int_equal(verdicts[WRONG], 0);
	assert_true(verdicts[NEAREST] > 20000 && verdicts[RULED] < 10);
}

static void no_position_no_ray(void **state)
{
	static struct ray_maker r;
	struct scene s;
	double point[3], direction[3];

	(void)state;
	sample_seed(4);
	do
		sample_scene(&s, 0);
	while (ray_maker_of(&s, &r) != NULL);
	ray_exact(&r, (double[]){ (double)NAN, 0 }, false, point, direction);
	for (int j = 0; j < 3; j++)
		assert_true(isnan(point[j]) && isnan(direction[j]));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(rays_are_exact),
		cmocka_unit_test(no_position_no_ray),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
