/* SPDX-License-Identifier: MIT */
/* The view matrix and its inverse against MPFR, exact zeros, and refusals. */
#include "../exact/rotation.h"
#include "claims.h"

static struct refusals faults;

static const struct convention d3d;

/* Compares the map to view space and its inverse with the truth. Returns false if the
 * camera is refused. */
static bool compare(const struct camera *c, const struct convention *convention,
    struct worst *w)
{
	struct scene s = {
		.has_camera = true,
		.camera = *c,
		.convention = *convention,
	};
	struct map m, back;
	struct truth t;
	int mark = real_mark();

	if (!camera_map(c, convention, false, &m, NULL) ||
	    !camera_map(c, convention, true, &back, NULL))
		return false;
	truth_scene(&s, SPACE_WORLD, SPACE_VIEW, &t);
	truth_compare(&t, &m, w);
	truth_scene(&s, SPACE_VIEW, SPACE_WORLD, &t);
	if (map_is_finite(&back))
		truth_compare(&t, &back, w);
	real_release(mark);
	return true;
}

static void check_cameras(const char *what, int e, int tries)
{
	struct worst w = { 0 };
	int refusals = 0;

	SAMPLES(i, tries) {
		struct convention convention;
		struct camera c;

		sample_convention(&convention);
		sample_camera(&c, e);
		refusals += !compare(&c, &convention, &w);
	}
	assert_maps(what, &w);
	/* up is often refused: it is within 1e-15 to 1e-12 of the gaze */
	assert_true(refusals < tries / 2);
}

static void random_cameras(void **state)
{
	(void)state;
	check_cameras("ordinary", 0, 400);
	check_cameras("hostile, to 1e2", 2, 300);
	check_cameras("hostile, to 1e20", 20, 150);
	check_cameras("hostile, to 1e150", 150, 150);
}

static void check_orthonormalized(const char *what, int e, int tries)
{
	struct worst w = { 0 };

	SAMPLES(i, tries) {
		struct camera c;

		sample_orthonormalize(&c, e);
		compare(&c, &d3d, &w);
	}
	assert_errors(what, &w, ROTATION_BOUND / TRUTH_TOLERANCE);
}

static void rotation_is_nearest(void **state)
{
	(void)state;
	check_orthonormalized("drifted", 0, 60);
	check_orthonormalized("hardly a rotation", 20, 60);
}

static void set_diagonal(struct camera *c, double a, double b, double d)
{
	memset(c, 0, sizeof *c);
	c->way = CAMERA_MATRIX;
	c->orthonormalize = true;
	c->steps.matrix[0][0] = a;
	c->steps.matrix[1][1] = b;
	c->steps.matrix[2][2] = d;
	c->steps.matrix[3][3] = 1;
}

/* The nearest rotation of a stretched permutation of the axes has exact zeros and
 * ones. */
static void nearest_rotation_of_permutations(void **state)
{
	static const double stretched[][3] = { { 1, 1, 1 }, { 3, 2, 1 },
		{ 1e150, 1e150, 1e150 }, { 1e-150, 1e-150, 1e-150 }, { 1, 1, 1e-150 },
		{ 1, 1e-80, 1e-100 }, { 0.1, 0.7, 1e9 } };
	struct camera c;
	struct map m;

	(void)state;
	for (size_t i = 0; i < sizeof stretched / sizeof *stretched; i++)
		for (int turn = 0; turn < 3; turn++) {
			const double *d = stretched[i];

			set_diagonal(&c, d[0], d[1], d[2]);
			for (int k = 0; k < 9; k++)
				c.steps.matrix[k / 3][k % 3] = k % 3 ==
					(k / 3 + turn) % 3 ?
				    d[k / 3] :
				    0;
			assert_true(camera_map(&c, &d3d, false, &m, NULL));
			for (int k = 0; k < 9; k++)
				assert_true(element(&m, k / 3, k % 3) ==
				    (k % 3 == (k / 3 + turn) % 3));
		}
}

/* Asserts that an element is 0 where its numerator, a polynomial in whole numbers, is
 * 0. */
static void check_zeros(const int eye[3], const int gaze[3], const int up[3],
    const struct map *m)
{
	int axis[3][3];

	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		axis[0][i] = up[j] * gaze[k] - up[k] * gaze[j];
	}
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		axis[1][i] = gaze[j] * axis[0][k] - gaze[k] * axis[0][j];
		axis[2][i] = gaze[i];
	}
	for (int i = 0; i < 3; i++) {
		int image = 0;

		for (int k = 0; k < 3; k++) {
			image += axis[i][k] * eye[k];
			assert_true((element(m, k, i) == 0) == (axis[i][k] == 0));
		}
		assert_true((element(m, 3, i) == 0) == (image == 0));
	}
}

static void check_whole_numbers(int eye_number, const int up[3], int *zeros)
{
	struct camera c = { .way = CAMERA_AT };
	int eye[3], gaze[3];
	struct map m;

	for (int i = 0; i < 3; i++, eye_number /= 7) {
		eye[i] = eye_number % 7 - 3;
		gaze[i] = (int)sample_below(7) - 3 - eye[i];
		c.eye[i] = eye[i];
		c.at[i] = eye[i] + gaze[i];
		c.up[i] = up[i];
	}
	if (!camera_map(&c, &d3d, false, &m, NULL))
		return;
	check_zeros(eye, gaze, up, &m);
	for (int i = 0; i < 3; i++)
		*zeros += element(&m, 3, i) == 0;
}

static void zeros_of_whole_numbers(void **state)
{
	static const int ups[][3] = { { 0, 1, 0 }, { 0, 0, 1 }, { 1, 2, 3 },
		{ -1, 1, 0 } };
	int zeros = 0;

	(void)state;
	SAMPLES(i, 7 * 7 * 7 * 12)
		check_whole_numbers(i % 343, ups[i % 4], &zeros);
	assert_true(zeros > 500);
}

/* Isometric axes, rolled by multiples of 15 degrees: elements are sums of irrational
 * products, and are 0 where these cancel. */
static void zeros_of_rolled_cameras(void **state)
{
	struct camera c = { .up = { 0, 1, 0 } };
	struct worst w = { 0 };

	(void)state;
	for (int i = 0; i < 8 * 24; i++) {
		for (int k = 0; k < 3; k++) {
			c.eye[k] = i % 3 ? k : 0;
			c.at[k] = c.eye[k] + (i >> k & 1 ? 1 : -1);
		}
		c.roll = 15 * (i / 8);
		assert_true(compare(&c, &d3d, &w));
	}
	assert_maps("isometric and rolled", &w);
}

/* The nearest rotations of these matrices are irrational but for one 0. */
static void zeros_of_nearest_rotations(void **state)
{
	static const double drifted[][3][3] = {
		{ { -2, 2, -1 }, { 3, 0, 2 }, { -1, -2, -2 } },
		{ { 0, -2, -3 }, { 2, 0, -3 }, { 3, -3, -2 } },
		{ { 3, 1, 3 }, { -1, 1, 0 }, { -3, -1, 3 } },
		{ { 0, -2, -3 }, { 1, 3, -2 }, { 2, 3, -2 } },
	};
	struct worst w = { 0 };

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct camera c;

		set_diagonal(&c, 1, 1, 1);
		for (int k = 0; k < 3; k++)
			memcpy(c.steps.matrix[k], drifted[i][k], sizeof drifted[i][k]);
		assert_true(compare(&c, &d3d, &w));
	}
	assert_errors("a rotation with one 0", &w, 0x1p-245 / TRUTH_TOLERANCE);
}

/* Compares elements with digits of bc. As the camera looks from (1, 2, 3) to the
 * origin, x . eye and y . eye are 0. */
static void elements_by_bc(void **state)
{
	const struct camera c = { .eye = { 1, 2, 3 }, .up = { 0, 1, 0 } };
	struct map m;

	(void)state;
	assert_true(camera_map(&c, &d3d, false, &m, NULL));
	assert_number(element(&m, 3, 0), 0);
	assert_number(element(&m, 3, 1), 0);
	/* sqrt(14), -3/sqrt(10), 5/sqrt(35) and -1/sqrt(14) */
	assert_number(element(&m, 3, 2), 3.7416573867739413855837487323165);
	assert_number(element(&m, 0, 0), -0.94868329805051379959966806332981);
	assert_number(element(&m, 1, 1), 0.84515425472851657750961832736594);
	assert_number(element(&m, 0, 2), -0.26726124191242438468455348087975);
}

/* Returns 2^100 times the squared sine of the angle between up and the gaze. */
static double scaled_sine_squared(const struct camera *c)
{
	real g[3], u[3], x[3];

	set_reals(g, 3, c->at);
	set_reals(u, 3, c->up);
	cross(u, g, x);
	return mpfr_get_d(mul(real_of(0x1p100),
			      divide(dot(x, x, 3), mul(dot(u, u, 3), dot(g, g, 3)))),
	    MPFR_RNDN);
}

static void up_parallel_to_the_gaze(void **state)
{
	int refusals = 0;

	(void)state;
	SAMPLES(i, 500) {
		struct camera c = { .way = CAMERA_GAZE };
		int mark = real_mark();
		struct map m;

		for (int k = 0; k < 3; k++) {
			c.at[k] = sample_between(-10, 10);
			c.up[k] = -2 * c.at[k];
		}
		c.up[0] *= 1 + ldexp(sample_below(16), -52);
		double near = scaled_sine_squared(&c);
		bool done = camera_map(&c, &d3d, false, &m, &faults);

		if (near < 1)
			assert_refusal(done, &faults, "/camera/up", NULL, NULL);
		else
			assert_true(done);
		refusals += near < 1;
		real_release(mark);
	}
	assert_in_range(refusals, 100, 400);
}

/* The map of a camera with a pose is the inverse of the map of a camera with the same
 * matrix as "matrix". */
static void pose_is_the_inverse(void **state)
{
	(void)state;
	SAMPLES(i, 40) {
		struct camera c, pose;
		struct map m, back;

		sample_orthonormalize(&c, i % 2 ? 5 : 0);
		c.way = CAMERA_MATRIX;
		c.has_axes = false;
		c.orthonormalize = i % 4 < 2;
		pose = c;
		pose.way = CAMERA_POSE;
		for (int inverse = 0; inverse < 2; inverse++) {
			if (!camera_map(&c, &d3d, inverse, &m, NULL))
				continue;
			assert_true(camera_map(&pose, &d3d, !inverse, &back, NULL));
			for (int k = 0; k < 16; k++)
				assert_number(element(&m, k / 4, k % 4),
				    element(&back, k / 4, k % 4));
		}
	}
}

static double determinant(const double m[4][4])
{
	double sum = 0;

	for (int j = 0; j < 3; j++) {
		int k = (j + 1) % 3, l = (j + 2) % 3;

		sum += m[0][j] * (m[1][k] * m[2][l] - m[1][l] * m[2][k]);
	}
	return sum;
}

/* Cameras whose matrices are the 24 rotations of a cube, stretched along the axes.
 * Their quaternions have one, two or four numbers of the same size, and the others are
 * 0. */
static void turns_of_a_cube(void **state)
{
	int turns = 0;

	(void)state;
	for (int k = 0; k < 27 * 8; k++) {
		int axis[3] = { k % 3, k / 3 % 3, k / 9 % 3 };
		struct camera c;
		struct map m;

		set_diagonal(&c, 0, 0, 0);
		for (int i = 0; i < 3; i++)
			c.steps.matrix[i][axis[i]] = (k / 27 >> i & 1 ? -1 : 1) *
			    (i + 1);
		if (!(determinant(c.steps.matrix) > 0))
			continue;
		turns++;
		assert_true(camera_map(&c, &d3d, false, &m, NULL));
		for (int i = 0; i < 9; i++)
			assert_number(element(&m, i / 3, i % 3),
			    c.steps.matrix[i / 3][i % 3] / (1 + i / 3));
	}
	assert_int_equal(turns, 24);
}

static void assert_camera_refused(struct camera c, bool inverse, const char *where,
    const char *what, const char *remedy)
{
	struct map m;

	assert_refusal(camera_map(&c, &d3d, inverse, &m, &faults), &faults, where, what,
	    remedy);
}

static void refused_cameras(void **state)
{
	struct camera c = { .eye = { 1, 2, 3 }, .at = { 1, 2, 3 }, .up = { 0, 1, 0 } };

	(void)state;
	assert_camera_refused(c, false, "/camera/at", NULL, NULL);
	memcpy(c.at, (double[]){ 1, 5, 3 }, sizeof c.at);
	assert_camera_refused(c, true, "/camera/up", NULL, NULL);
	memset(c.up, 0, sizeof c.up);
	assert_camera_refused(c, false, "/camera/up", NULL, NULL);
	c.way = CAMERA_GAZE;
	memset(c.at, 0, sizeof c.at);
	c.up[1] = 1;
	assert_camera_refused(c, false, "/camera/gaze", NULL, NULL);
	c.way = CAMERA_ORIENTATION;
	assert_camera_refused(c, false, "/camera/orientation", NULL, NULL);
	c.way = CAMERA_TRANSLATION;
	assert_camera_refused(c, true, "/camera/orientation", NULL, NULL);
	c.way = CAMERA_RVEC;
	c.rvec[1] = nextafter(2 * PI, 7);
	assert_camera_refused(c, false, "/camera/rvec", "is longer than 2 pi", NULL);
	c.way = CAMERA_RVEC_TRANSLATION;
	assert_camera_refused(c, true, "/camera/rvec", "is longer than 2 pi", NULL);
	set_diagonal(&c, 1, 1, -1);
	assert_camera_refused(c, false, "/camera/matrix",
	    "its determinant is not positive", NULL);
	c.way = CAMERA_POSE;
	assert_camera_refused(c, true, "/camera/pose",
	    "its determinant is not positive", NULL);
	set_diagonal(&c, 1, 1, 0);
	assert_camera_refused(c, false, "/camera/matrix", NULL, NULL);
	c.way = CAMERA_POSE;
	assert_camera_refused(c, false, "/camera/pose", NULL, NULL);
	c.orthonormalize = false;
	assert_camera_refused(c, false, "/camera/pose", "singular", NULL);
	assert_camera_refused(c, true, "/camera/pose", "singular", NULL);
	c.steps.matrix[0][3] = 1;
	assert_camera_refused(c, true, "/camera/pose", STEPS_NOT_AFFINE,
	    STEPS_NOT_AFFINE_REMEDY);
	c.steps.matrix[0][3] = 0;
	c.way = CAMERA_MATRIX;
	c.orthonormalize = false;
	assert_camera_refused(c, true, "/camera/matrix", NULL, NULL);
	c.steps.matrix[2][2] = 1;
	c.steps.matrix[0][3] = 1e-9;
	assert_camera_refused(c, false, "/camera/matrix", STEPS_NOT_AFFINE,
	    STEPS_NOT_AFFINE_REMEDY);
	c.steps.matrix[3][0] = 1e-9;
	assert_camera_refused(c, false, "/camera/matrix", STEPS_NOT_AFFINE,
	    STEPS_NOT_AFFINE_REMEDY);
	set_diagonal(&c, 1, 1e-140, 1e-150);
	assert_camera_refused(c, false, "/camera/matrix", NULL, NULL);
	for (int i = 0; i < 4; i++) {
		c.way = i < 2 ? CAMERA_ROTATION : CAMERA_ROTATION_TRANSLATION;
		c.orthonormalize = false;
		assert_camera_refused(c, i % 2, "/camera/rotation", "singular", NULL);
		c.orthonormalize = true;
		assert_camera_refused(c, i % 2, "/camera/rotation", NULL, NULL);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(random_cameras),
		cmocka_unit_test(rotation_is_nearest),
		cmocka_unit_test(nearest_rotation_of_permutations),
		cmocka_unit_test(turns_of_a_cube),
		cmocka_unit_test(zeros_of_whole_numbers),
		cmocka_unit_test(zeros_of_rolled_cameras),
		cmocka_unit_test(zeros_of_nearest_rotations),
		cmocka_unit_test(elements_by_bc),
		cmocka_unit_test(up_parallel_to_the_gaze),
		cmocka_unit_test(pose_is_the_inverse),
		cmocka_unit_test(refused_cameras),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
