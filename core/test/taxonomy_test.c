/* SPDX-License-Identifier: MIT */
/* The names and numbers that inspect prints of a projection, against MPFR. */
#include "../derive/picture.h"

#include "claims.h"

/* The count of numbers of each verdict. */
struct tally {
	int n[VERDICTS];
};

static void count_verdict(double got, struct sized n, struct sized d,
    struct tally *tally)
{
	tally->n[truth_verdict(got, n, d, false)]++;
}

/* Checks that got is h / w, or nan if the point is not visible or w is 0. */
static void check_point(const double *got, const struct sized h[4], int n, bool visible,
    struct tally *tally)
{
	bool doubtful;
	int w = truth_sign(h[3], &doubtful);

	for (int j = 0; j < n; j++)
		if (w == 0 || !visible)
			assert_true(isnan(got[j]) != 0);
		else if (!doubtful)
			count_verdict(got[j], h[j], h[3], tally);
}

static void matrix_row(const struct truth *t, int i, struct sized h[4])
{
	for (int j = 0; j < 4; j++)
		h[j] = truth_element(t, i, j);
}

static void check_vanishing_points(const struct scene *s, const struct taxonomy *t,
    struct tally *tally)
{
	struct truth truth;

	truth_scene(s, SPACE_WORLD, SPACE_DEVICE, &truth);
	for (int i = 0; i < 3; i++) {
		struct sized h[4];

		matrix_row(&truth, i, h);
		check_point(t->vanishing_point[i], h, 2, true, tally);
	}
}

/* Checks the eye, where clip x, y and w are 0, and the corners, by the inverse matrix.
 * The viewport's scale decides where the side planes are. */
static void check_places(const struct scene *s, const struct picture *p,
    struct tally *tally)
{
	static const int side[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
	double low = truth_answer(s)->depth_minus_one ? -1 : 0;
	double up = truth_answer(s)->ndc_y_down ? -1 : 1;
	struct truth truth;
	struct sized h[4];
	real limit[2];

	truth_scene(s, SPACE_CLIP, SPACE_WORLD, &truth);
	truth_limits(s, limit);
	matrix_row(&truth, 2, h);
	check_point(p->taxonomy.eye, h, 3, true, tally);
	for (int c = 0; c < 8; c++) {
		double depth = (c >= 4) != p->reverse_z ? 1 : low;
		struct sized at[2];

		for (int k = 0; k < 2; k++)
			at[k] = sized_mul((struct sized){ limit[k], limit[k] },
			    sized_of(side[c % 4][k] * (k == 0 ? 1 : up)));
		for (int j = 0; j < 4; j++) {
			h[j] = truth_column(&truth, j, (double[]){ 0, 0, depth, 1 });
			for (int k = 0; k < 2; k++)
				h[j] = sized_add(h[j],
				    sized_mul(at[k], truth_element(&truth, k, j)));
		}
		check_point(p->taxonomy.corner[c], h, 3,
		    mpfr_sgn(h[3].value) > 0 && !projection_is_open(&s->projection),
		    tally);
	}
}

/* Checks the angles of view: the arc cosine of the normals of opposite planes. */
static void check_fov(const struct scene *s, const struct taxonomy *t,
    struct tally *tally)
{
	real m[4][4], limit[2];

	truth_matrix(s, SPACE_VIEW, SPACE_CLIP, m);
	truth_limits(s, limit);
	for (int k = 0; k < 2; k++) {
		real a[3], b[3];

		for (int i = 0; i < 3; i++) {
			real w = mul(limit[k], m[i][3]);

			a[i] = add(w, m[i][k]);
			b[i] = sub(m[i][k], w);
		}
		normalise(a, 3);
		normalise(b, 3);
		real angle = dot(a, b, 3);

		/* of parallel planes, rounded */
		if (mpfr_cmpabs(angle, real_of(1)) > 0)
			angle = real_of(mpfr_sgn(angle));
		mpfr_acos(angle, angle, MPFR_RNDN);
		mpfr_mul_ui(angle, angle, 180, MPFR_RNDN);
		mpfr_const_pi(a[0], MPFR_RNDN);
		count_verdict(t->fov[k], (struct sized){ angle, angle },
		    (struct sized){ a[0], a[0] }, tally);
	}
}

/* Checks foreshortening. A world axis is a sum of a vector along the projectors and two
 * perpendicular vectors in the plane. The length of the sum of these two vectors is the
 * length of the image. */
static void check_foreshortening(const struct scene *s, const struct taxonomy *t,
    struct tally *tally)
{
	real m[4][4], axis[4][4], basis[4][4], in[4][4];
	real x[3], y[3], n[3], zero[3], *d = basis[0];

	truth_matrix(s, SPACE_VIEW, SPACE_CLIP, m);
	truth_matrix(s, SPACE_WORLD, SPACE_VIEW, axis);
	set_identity(basis);
	for (int i = 0; i < 3; i++) {
		x[i] = m[i][0];
		y[i] = m[i][1];
		n[i] = m[i][2];
	}
	normalise(n, 3);
	cross(x, y, d);
	normalise(d, 3);
	set_reals(zero, 3, (double[]){ 0.6, -0.48, 0.64 });
	cross(n, zero, basis[1]);
	normalise(basis[1], 3);
	cross(n, basis[1], basis[2]);
	set_inverse(in, basis);
	for (int i = 0; i < 3; i++) {
		real part[3], size = root(dot(axis[i], axis[i], 3));

		for (int k = 0; k < 3; k++) {
			real column[3] = { in[0][k], in[1][k], in[2][k] };

			part[k] = dot(axis[i], column, 3);
		}
		struct sized f = { root(dot(part + 1, part + 1, 2)), size };

		count_verdict(t->foreshortening[i], f,
		    (struct sized){ real_of(1),
			divide(real_of(1), magnitude(dot(n, d, 3))) },
		    tally);
	}
}

/* Checks that the gaze leads from near to far. */
static void check_ahead(const struct taxonomy *t)
{
	for (int i = 0; i < 4; i++) {
		double ahead = 0, least = 0;

		for (int j = 0; j < 3; j++) {
			ahead += t->gaze[j] * t->corner[4 + i][j];
			ahead -= t->gaze[j] * t->corner[i][j];
			least += 0x1p-40 *
			    (fabs(t->corner[i][j]) + fabs(t->corner[4 + i][j]));
		}
		assert_true(ahead >= -least || isnan(ahead));
	}
}

/* Checks the gaze: the gradient of w or, in a parallel projection, of z. */
static void check_gaze(const struct scene *s, const struct taxonomy *t,
    struct tally *tally)
{
	bool parallel = t->taxon <= TAXON_OBLIQUE;
	struct truth truth;
	struct sized n[3];

	truth_scene(s, SPACE_WORLD, SPACE_CLIP, &truth);
	for (int i = 0; i < 3; i++) {
		n[i] = truth_element(&truth, i, parallel ? 2 : 3);
		n[i].value = magnitude(n[i].value);
	}
	for (int i = 0; i < 3; i++)
		count_verdict(fabs(t->gaze[i]), n[i], sized_length(n), tally);
	check_ahead(t);
}

static void numbers_are_nearest(void **state)
{
	static const char *const what[] = { "places", "gazes", "foreshortenings",
		"vanishing points", "angles" };
	struct tally tally[5] = { 0 };
	struct scene s;
	static struct picture p;
	const struct taxonomy *t = &p.taxonomy;
	int n[2] = { 0, 0 };

	(void)state;
	SAMPLES(k, 400) {
		int mark = real_mark();

		sample_scene(&s, k % 3 * 10);
		sample_answer(&s);
		if (!picture_of(&s, &p, NULL))
			continue;
		bool parallel = t->taxon <= TAXON_OBLIQUE;

		n[parallel]++;
		assert_true(isnan(t->fov[0]) == parallel);
		assert_true(isnan(t->foreshortening[0]) == !parallel);
		check_places(&s, &p, &tally[0]);
		check_gaze(&s, t, &tally[1]);
		if (parallel) {
			check_foreshortening(&s, t, &tally[2]);
		} else {
			check_vanishing_points(&s, t, &tally[3]);
			check_fov(&s, t, &tally[4]);
		}
		real_release(mark);
	}
	print_message("%d perspective, %d parallel\n", n[0], n[1]);
	assert_true(n[0] > 90 && n[1] > 90);
	for (int i = 0; i < 5; i++) {
		const int *v = tally[i].n;

		print_message("%s: %d numbers, %d within the tolerance, %d "
			      "wrong\n",
		    what[i], v[NEAREST] + v[WITHIN_TOLERANCE], v[WITHIN_TOLERANCE],
		    v[WRONG]);
	}
	for (int i = 0; i < 5; i++)
		assert_int_equal(tally[i].n[WRONG], 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(numbers_are_nearest),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
