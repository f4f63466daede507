/* SPDX-License-Identifier: MIT */
/* textbook_error is what a program in floats or doubles gets wrong: the test is such a
 * program, and MPFR says how far its images are from the true ones. */
#include "../derive/textbook.h"

#include "claims.h"

/* The numbers from which a program starts: matrices, and factors and constants of the
 * viewport. */
struct start {
	int n;
	real matrix[3][4][4], viewport[4];
};

/* Returns a number rounded first to fewer bits, so that its rounding errors do not
 * decide to which side a tie is rounded. */
static double rounded(real a, bool single)
{
	mpfr_t few;

	mpfr_init2(few, REAL_BITS / 2);
	mpfr_set(few, a, MPFR_RNDN);
	double r = single ? (double)mpfr_get_flt(few, MPFR_RNDN) :
			    mpfr_get_d(few, MPFR_RNDN);

	mpfr_clear(few);
	return r;
}

#define GET_float(a) (float)rounded(a, true)
#define GET_double(a) rounded(a, false)

/* Defines run_TYPE: writes x and y of the image of p, and returns w. */
#define PROGRAM(TYPE)                                                                  \
	static double run_##TYPE(const struct start *s, const double p[4],             \
	    double image[2])                                                           \
	{                                                                              \
		TYPE m[4][4] = { { 1 }, { 0, 1 }, { 0, 0, 1 }, { 0, 0, 0, 1 } };       \
		TYPE a[4][4], q[4] = { 0 };                                            \
                                                                                       \
		for (int k = 0; k < s->n; k++) {                                       \
			memcpy(a, m, sizeof m);                                        \
			memset(m, 0, sizeof m);                                        \
			for (int i = 0; i < 64; i++)                                   \
				m[i / 16][i / 4 % 4] += a[i / 16][i % 4] *             \
				    GET_##TYPE(s->matrix[k][i % 4][i / 4 % 4]);        \
		}                                                                      \
		for (int i = 0; i < 16; i++)                                           \
			q[i / 4] += (TYPE)p[i % 4] * m[i % 4][i / 4];                  \
		for (int j = 0; j < 2; j++)                                            \
			image[j] = (double)(q[j] / q[3] * GET_##TYPE(s->viewport[j]) + \
			    GET_##TYPE(s->viewport[2 + j]));                           \
		return (double)q[3];                                                   \
	}

PROGRAM(float)
PROGRAM(double)

/* A change of view's axes is a matrix without a camera, too. */
static void set_start(const struct scene *s, struct start *r)
{
	const struct convention *a = &s->convention, *b = truth_answer(s);
	const bool turns = a->view_y_down != b->view_y_down ||
	    truth_gaze_sign(a) != truth_gaze_sign(b);
	const bool has[3] = { s->has_world, s->has_camera || turns,
		s->projection.type != PROJECTION_NONE };
	real device[4][4];

	r->n = 0;
	for (int k = 0; k < 3; k++)
		if (has[k])
			truth_matrix(s, (enum space)k, (enum space)(k + 1),
			    r->matrix[r->n++]);
	truth_matrix(s, SPACE_NDC, s->has_viewport ? SPACE_DEVICE : SPACE_NDC, device);
	for (int j = 0; j < 2; j++) {
		r->viewport[j] = device[j][j];
		r->viewport[2 + j] = device[3][j];
	}
}

/* Sets p to point i of 125 in the volume, rounded. Returns false at infinity. */
static bool volume_point(const struct scene *s, const struct truth *back, int i,
    bool single, double p[4])
{
	const double low = truth_answer(s)->depth_minus_one ? -1 : 0;
	real limit[2], at[4];
	struct sized h[4];

	truth_limits(s, limit);
	at[0] = mul(limit[0], real_of(i % 5 / 2.0 - 1));
	at[1] = mul(limit[1], real_of(i / 5 % 5 / 2.0 - 1));
	at[2] = real_of(low + (1 - low) * (i / 25) / 4);
	at[3] = real_of(1);
	for (int j = 0; j < 4; j++) {
		h[j] = sized_of(0);
		for (int k = 0; k < 4; k++)
			h[j] = sized_add(h[j],
			    sized_mul((struct sized){ at[k], magnitude(at[k]) },
				truth_element(back, k, j)));
	}
	if (truth_sign(h[3], NULL) == 0)
		return false;
	for (int j = 0; j < 4; j++) {
		p[j] = rounded(divide(h[j].value, h[3].value), single);
		if (truth_sign(h[j], NULL) == 0)
			p[j] = 0;
	}
	return true;
}

/* Returns the greatest error of a program, or nan. */
static double expected_error(const struct scene *s, bool single)
{
	static struct truth back, image;
	static struct start start;
	real most = real_of(0);

	truth_scene(s, SPACE_NDC, SPACE_MODEL, &back);
	truth_scene(s, SPACE_MODEL, s->has_viewport ? SPACE_DEVICE : SPACE_NDC, &image);
	set_start(s, &start);
	for (int i = 0; i < 125; i++) {
		const int mark = real_mark();
		double p[4], got[2];
		real off[2];

		if (!volume_point(s, &back, i, single, p))
			continue;
		const double w = single ? run_float(&start, p, got) :
					  run_double(&start, p, got);

		if (!(w > 0) || !isfinite(w) || !isfinite(got[0]) || !isfinite(got[1]))
			return (double)NAN;
		for (int j = 0; j < 2; j++)
			off[j] = sub(divide(truth_column(&image, j, p).value,
					 truth_column(&image, 3, p).value),
			    real_of(got[j]));
		real square = dot(off, off, 2);

		if (mpfr_cmp(square, most) > 0)
			mpfr_set(most, square, MPFR_RNDN);
		real_release(mark);
	}
	return mpfr_get_d(root(most), MPFR_RNDN);
}

static void errors_are_those_of_programs(void **state)
{
	int found = 0, none = 0;
	struct scene s;
	struct map back;

	(void)state;
	SAMPLES(k, 64) {
		double error[2];

		sample_scene(&s, k % 5 == 0 ? 3 : 0);
		sample_answer(&s);
		s.has_viewport = k % 3 != 0;
		s.has_camera = k % 4 != 0;
		if (!textbook_errors(&s, error, NULL))
			continue;
		const bool has_points = !projection_is_open(&s.projection) &&
		    scene_map_factor(&s, SPACE_NDC, SPACE_MODEL, &back, NULL);

		for (int i = 0; i < 2; i++) {
			const int mark = real_mark();
			double expected = has_points ? expected_error(&s, i == 0) :
						       (double)NAN;

			real_release(mark);
			if (isnan(expected) != isnan(error[i]) ||
			    (!isnan(expected) && error[i] != expected))
				fail_msg("%s: came %.17g, expected %.17g",
				    i == 0 ? "float" : "double", error[i], expected);
			found += !isnan(expected);
			none += isnan(expected) != 0;
		}
	}
	print_message("%d errors, %d times none\n", found, none);
	assert_true(found > 60 && none > 5);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(errors_are_those_of_programs),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
