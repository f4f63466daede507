#include <math.h>

#include "../ray.h"
#include "claims.h"

/* The image of a device position and depth, and what it gains with depth. */
static void exact_ray(const struct truth *back, const double at[2],
    double depth, double sign, real point[3], real direction[3], real size[3])
{
	double p[2][4] = { { at[0], at[1], depth, 1 }, { 0, 0, 1, 0 } };
	real q[4], s[4], gain[4], gain_size[4];

	truth_image(back, p[0], q, s);
	truth_image(back, p[1], gain, gain_size);
	for (int j = 0; j < 3; j++) {
		point[j] = over(q[j], q[3]);
		size[j] = over(s[j], q[3]);
		direction[j] = mul(number(sign),
		    sub(mul(gain[j], q[3]), mul(q[j], gain[3])));
	}
	normalise(direction, 3);
}

/* Nearest doubles, where a coordinate is more than a 2^40th of its products. */
static void rays_are_exact(void **state)
{
	struct scene s;
	struct ray_maker r;
	size_t n = 0;

	(void)state;
	sample_seed(3);
	for (int k = 0; k < 600; k++) {
		struct truth back = { 0 };
		int mark = real_mark();

		sample_scene(&s, k % 3 * 4);
		s.has_viewport = true;
		if (ray_maker_of(&s, &r) != NULL)
			continue;
		truth_scene(&s, SPACE_DEVICE, SPACE_WORLD, &back);
		for (int i = 0; i < 20; i++) {
			const struct viewport *v = &s.viewport;
			double at[2] = { v->x + v->width * sample_unit(),
				v->y + v->height * sample_unit() };
			double point[3], direction[3];
			real p[3], d[3], size[3];
			int ray = real_mark();

			if (i % 2)
				at[0] = v->x + v->width / 2;
			ray_exact(&r, at, point, direction);
			if (isnan(point[0]))
				continue;
			exact_ray(&back, at, r.depth, r.sign, p, d, size);
			for (int j = 0; j < 3; j++) {
				double cost = mpfr_get_d(over(size[j],
							     magnitude(p[j])),
				    MPFR_RNDN);
				double large = mpfr_get_d(d[j], MPFR_RNDN);

				if (cost < 0x1p40)
					assert_true(
					    ulps(point[j], p[j]) < 0.51);
				if (fabs(large) > 0x1p-20)
					assert_true(
					    ulps(direction[j], d[j]) < 0.51);
				n++;
			}
			real_release(ray);
		}
		real_release(mark);
	}
	assert_true(n > 5000);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(rays_are_exact),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
