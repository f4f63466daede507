/* SPDX-License-Identifier: MIT */
/* The camera that inspect prints, against MPFR, and read back. */
#include "../derive/picture.h"

#include "claims.h"

/* Numbers that are the nearest doubles, and others. */
static int tally[2];

static void count_nearest(double got, real exact)
{
	const double nearest = mpfr_get_d(exact, MPFR_RNDN);

	/* a number that is 0 but for the errors of roots and angles */
	tally[got == nearest || (got == 0 && fabs(nearest) < 0x1p-240)]++;
}

/* Sets the numbers of the unit quaternion from view to world of the rotation r from
 * world to view, from its largest number. */
static void true_quaternion(real r[3][3], real q[4])
{
	real square[4];
	int best = 0;

	for (int k = 0; k < 4; k++) {
		square[k] = real_of(1);
		for (int i = 0; i < 3; i++)
			square[k] = k == 3 || k == i ? add(square[k], r[i][i]) :
						       sub(square[k], r[i][i]);
		if (mpfr_cmp(square[k], square[best]) > 0)
			best = k;
	}
	real four = mul(real_of(2), root(square[best]));

	for (int k = 0; k < 3; k++) {
		const int i = (k + 1) % 3, j = (k + 2) % 3;

		q[k] = best == k ? divide(four, real_of(4)) :
		    best == 3    ? divide(sub(r[i][j], r[j][i]), four) :
				   divide(add(r[best][k], r[k][best]), four);
	}
	q[3] = best == 3 ? divide(four, real_of(4)) :
			   divide(sub(r[(best + 1) % 3][(best + 2) % 3],
				      r[(best + 2) % 3][(best + 1) % 3]),
			       four);
	const bool minus = mpfr_sgn(q[3]) < 0;

	for (int k = 0; k < 4 && minus; k++)
		q[k] = negative(q[k]);
}

static void check_numbers(const struct scene *s, const struct rigid *r)
{
	const bool mirrors = (s->convention.right_handed !=
				 truth_answer(s)->right_handed) !=
	    camera_mirrors(&s->camera, &s->convention);
	real m[4][4], row[3][3], q[4], length, angle = real_of(0);

	truth_matrix(s, SPACE_WORLD, SPACE_VIEW, m);
	for (int i = 0; i < 4 && mirrors; i++)
		m[i][0] = negative(m[i][0]);
	for (int k = 0; k < 3; k++) {
		real eye = real_of(0);

		for (int i = 0; i < 3; i++) {
			row[k][i] = m[i][k];
			count_nearest(r->rotation[k][i], m[i][k]);
			eye = sub(eye, mul(m[3][i], m[k][i]));
		}
		count_nearest(r->translation[k], m[3][k]);
		count_nearest(r->eye[k], eye);
	}
	true_quaternion(row, q);
	length = root(dot(q, q, 3));
	mpfr_atan2(angle, length, q[3], MPFR_RNDN);
	angle = mul(angle, real_of(2));
	/* the sign at half a turn has a test of its own */
	for (int k = 0; k < 4 && mpfr_get_d(q[3], MPFR_RNDN) > 0x1p-200; k++) {
		count_nearest(r->orientation[k], q[k]);
		if (k < 3 && mpfr_get_d(length, MPFR_RNDN) > 0x1p-200)
			count_nearest(r->rvec[k],
			    negative(divide(mul(q[k], angle), length)));
	}
}

/* Each number of a camera that is a rotation, or is made one, is the nearest double. */
static void numbers_are_nearest(void **state)
{
	static struct picture p;
	struct scene s;
	int n = 0, ways[CAMERA_MATRIX + 1] = { 0 };

	(void)state;
	SAMPLES(k, 600) {
		int mark = real_mark();

		sample_scene(&s, 0);
		sample_answer(&s);
		s.camera.orthonormalize = camera_gives_3x3(&s.camera);
		if (!s.has_camera || !picture_of(&s, &p, NULL) || !p.rigid.exists)
			continue;
		check_numbers(&s, &p.rigid);
		ways[s.camera.way]++;
		n++;
		real_release(mark);
	}
	print_message("%d cameras: %d numbers are nearest, %d are not\n", n, tally[1],
	    tally[0]);
	for (int i = 0; i <= CAMERA_MATRIX; i++)
		assert_true(ways[i] > 3);
	assert_int_equal(tally[0], 0);
}

/* Read back by orientation or rvec, with the eye or the translation, the camera is that
 * of the scene that inspect prints, also the one that it finds in a single matrix. */
static void cameras_read_back(void **state)
{
	static struct picture p;
	struct scene s;
	int n = 0, single = 0;

	(void)state;
	SAMPLES(k, 600) {
		struct map was, is, clip;

		sample_scene(&s, 0);
		sample_answer(&s);
		if (s.has_camera && camera_gives_3x3(&s.camera))
			continue;
		if (k % 2 == 0 && s.has_camera) {
			s.answer = NULL;
			if (!scene_map(&s, SPACE_WORLD, SPACE_CLIP, &clip, NULL))
				continue;
			for (int i = 0; i < 16; i++)
				s.projection.matrix[i / 4][i % 4] = element(&clip,
				    i / 4, i % 4);
			s.projection.type = PROJECTION_MATRIX;
			s.projection.without_camera = true;
			s.has_camera = false;
		}
		if (!picture_of(&s, &p, NULL) || !p.has_scene || !p.rigid.exists ||
		    (s.has_camera && projection_is_given_matrix(&s.projection)) ||
		    projection_has_intrinsics(&s.projection) ||
		    projection_family(&s.projection) == FAMILY_VOLUME)
			continue;
		struct scene r = p.scene, back = p.scene;
		double most = 1;

		memcpy(back.camera.orientation, p.rigid.orientation,
		    sizeof back.camera.orientation);
		memcpy(back.camera.rvec, p.rigid.rvec, sizeof back.camera.rvec);
		assert_true(scene_map(&r, SPACE_WORLD, SPACE_VIEW, &was, NULL));
		for (int i = 0; i < 3; i++)
			most = fmax(most, fabs(p.rigid.eye[i]));
		for (int way = CAMERA_ORIENTATION; way <= CAMERA_RVEC_TRANSLATION;
		     way++) {
			back.camera.way = (enum camera_way)way;
			memcpy(back.camera.eye,
			    way < CAMERA_TRANSLATION ? p.rigid.eye :
						       p.rigid.translation,
			    sizeof back.camera.eye);
			assert_true(
			    scene_map(&back, SPACE_WORLD, SPACE_VIEW, &is, NULL));
			for (int i = 0; i < 12; i++)
				assert_true(fabs(element(&was, i / 3, i % 3) -
						element(&is, i / 3, i % 3)) <=
				    0x1p-48 * (i < 9 ? 1 : most));
		}
		n++;
		single += !s.has_camera && projection_is_given_matrix(&s.projection);
	}
	print_message("%d cameras, %d of a single matrix\n", n, single);
	assert_true(n > 60 && single > 30);
}

/* Half turns about an axis with signs: the first number that is not 0 is positive. */
static void half_turns(void **state)
{
	static const double axis[][3] = { { -0.6, 0.8, 0 }, { 0.6, -0.8, 0 },
		{ 0, 0, -1 }, { 0, -0.6, 0.8 } };
	static struct picture p;

	(void)state;
	for (size_t i = 0; i < sizeof axis / sizeof *axis; i++) {
		struct scene s = { .has_camera = true };
		int first = 0;

		s.camera.way = CAMERA_ORIENTATION;
		memcpy(s.camera.orientation, axis[i], sizeof axis[i]);
		assert_true(picture_of(&s, &p, NULL) && p.rigid.exists);
		while (axis[i][first] == 0)
			first++;
		for (int k = 0; k < 3; k++) {
			const double v = copysign(1, axis[i][first]) * axis[i][k];

			assert_number(p.rigid.orientation[k], v);
			assert_true(fabs(p.rigid.rvec[k] - PI * v) <= 0x1p-50);
		}
		assert_number(p.rigid.orientation[3], 0);
	}
}

/* A camera that scales or mirrors has no rotation, and one with rounding errors has. */
static void scales_have_none(void **state)
{
	static const struct {
		double x;
		bool exists;
	} cases[] = { { 1, true }, { 1.004, true }, { 1.006, false }, { 2, false },
		{ -1, false } };
	static struct picture p;

	(void)state;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
		struct scene s = { .has_camera = true };

		s.camera.way = CAMERA_MATRIX;
		s.camera.steps.matrix[0][0] = cases[i].x;
		for (int k = 1; k < 4; k++)
			s.camera.steps.matrix[k][k] = 1;
		assert_true(picture_of(&s, &p, NULL));
		assert_int_equal(p.rigid.exists, cases[i].exists);
		for (int k = 0; k < 9 && p.rigid.exists; k++)
			assert_number(p.rigid.rotation[k / 3][k % 3], k / 3 == k % 3);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(numbers_are_nearest),
		cmocka_unit_test(cameras_read_back),
		cmocka_unit_test(half_turns),
		cmocka_unit_test(scales_have_none),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
