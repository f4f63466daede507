/* SPDX-License-Identifier: MIT */
/* The parameters that inspect prints, against MPFR. */
#include "../derive/picture.h"
#include "../points/point.h"

#include "claims.h"

static struct refusals faults;

/* Returns the largest difference, in ndc, between images under s and under r, the scene
 * that inspect prints, at points of the view volume. Their maps are equal but for a
 * factor and the rounding of parameters. */
static double most_off(const struct scene *s, const struct scene *r,
    const struct picture *t)
{
	struct transform a, b;
	double worst = 0;

	assert_true(transform_of_scene(s, SPACE_WORLD, SPACE_NDC, false, &a, NULL));
	if (!transform_of_scene(r, SPACE_WORLD, SPACE_NDC, false, &b, &faults))
		fail_msg("%s: %s", faults.list[0].where, faults.list[0].what);
	for (int i = 0; i < 8; i++) {
		double at[4], is[4] = { 0 }, was[4] = { 0 };

		for (int k = 0; k < 3; k++)
			at[k] = 0.4 * t->taxonomy.corner[i][k] +
			    0.3 * t->taxonomy.corner[i ^ 1][k] +
			    0.3 * t->taxonomy.corner[i ^ 6][k];
		at[3] = 1;
		if (isnan(at[0] + at[1] + at[2]))
			continue;
		point_exact(&a, at, was);
		point_exact(&b, at, is);
		for (int k = 0; k < 3; k++) {
			double off = fabs(is[k] - was[k]);

			worst = isnan(off) || off > worst ? off : worst;
		}
	}
	return worst;
}

/* Returns whether near and far give the projection's planes. */
static bool has_planes(const struct projection *p)
{
	return projection_family(p) == FAMILY_PERSP ||
	    projection_family(p) == FAMILY_PARALLEL;
}

static void scenes_make_the_same_picture(void **state)
{
	struct scene s;
	static struct picture r;
	int n = 0, made = 0, types[PROJECTION_TYPES] = { 0 };

	(void)state;
	SAMPLES(k, 2000) {
		sample_scene(&s, 0);
		sample_answer(&s);
		if (!picture_of(&s, &r, NULL))
			continue;
		assert_null(r.scene.answer);
		n++;
		if (!r.has_scene || fabs(r.far - r.near) < 1e-3 * fabs(r.near))
			continue;
		double off = most_off(&s, &r.scene, &r);

		if (!(off < 1e-6))
			print_message("%d: type %d off %g %g %g\n", k,
			    (int)s.projection.type, off, r.near, r.far);
		assert_true(off < 1e-6);
		made++;
		types[s.projection.type]++;
	}
	print_message("%d scenes, %d by parameters:", n, made);
	for (int i = 0; i < PROJECTION_TYPES; i++)
		print_message(" %d", types[i]);
	print_message("\n");
	assert_true(made > 800 && types[PROJECTION_PERSP] > 150);
}

/* Turns the camera and the projection into matrices of the nearest doubles. */
static void to_matrices(struct scene *s)
{
	struct map camera, projection;

	s->answer = NULL;
	assert_true(scene_map(s, SPACE_WORLD, SPACE_VIEW, &camera, NULL));
	assert_true(scene_map(s, SPACE_VIEW, SPACE_CLIP, &projection, NULL));
	for (int i = 0; i < 16; i++) {
		s->camera.steps.matrix[i / 4][i % 4] = element(&camera, i / 4, i % 4);
		s->projection.matrix[i / 4][i % 4] = element(&projection, i / 4, i % 4);
	}
	s->camera.way = CAMERA_MATRIX;
	s->camera.orthonormalize = s->camera.has_axes = false;
	s->viewport.has_full = s->viewport.has_offset = false;
	s->projection.type = PROJECTION_MATRIX;
}

/* The parameters that inspect finds in a matrix are those that the matrix was made of,
 * but for rounding. */
static void matrices_give_their_parameters(void **state)
{
	struct scene s;
	static struct picture was, is;
	int n = 0;

	(void)state;
	SAMPLES(k, 1000) {
		sample_scene(&s, 0);
		s.answer = NULL;
		if (!has_planes(&s.projection) || projection_is_open(&s.projection) ||
		    !picture_of(&s, &was, NULL))
			continue;
		/* a matrix alone would mirror what such axes do not */
		if (camera_mirrors(&s.camera, &s.convention))
			continue;
		if (!was.has_scene || !(was.near < was.far) ||
		    was.far - was.near < 1e-3 * fabs(was.near) ||
		    s.projection.section.way == SECTION_INTRINSICS)
			continue;
		to_matrices(&s);
		assert_true(picture_of(&s, &is, NULL));
		assert_true(is.has_scene && is.reverse_z == was.reverse_z);
		assert_true(fabs(is.near - was.near) <=
		    1e-9 * (fabs(was.near) + fabs(was.far)));
		assert_true(isinf(was.far) ?
			isinf(is.far) :
			fabs(is.far - was.far) <= 1e-9 * fabs(was.far));
		assert_true(most_off(&s, &is.scene, &is) < 1e-6);
		n++;
	}
	print_message("%d scenes in matrices\n", n);
	assert_true(n > 100);
}

static void count_verdict(double got, struct sized n, struct sized d,
    int tally[VERDICTS])
{
	tally[truth_verdict(got, n, d, false)]++;
}

/* Computes, by the inverse map, the homogeneous point of view space where the side
 * plane with number side meets the near or far plane and the other of x and y in ndc
 * is 0. */
static void corner_at(const struct scene *s, const struct truth *back,
    const real limit[2], bool reversed, bool far, int side, struct sized h[4])
{
	double up = truth_answer(s)->ndc_y_down ? -1 : 1;
	double low = truth_answer(s)->depth_minus_one ? -1 : 0;
	const double sign[4] = { -1, 1, -up, up };
	struct sized at = sized_mul((struct sized){ limit[side / 2], limit[side / 2] },
	    sized_of(sign[side]));

	for (int j = 0; j < 4; j++)
		h[j] = sized_add(truth_column(back, j,
				     (double[]){ 0, 0, far != reversed ? 1 : low, 1 }),
		    sized_mul(at, truth_element(back, side / 2, j)));
}

static void corner_of(const struct scene *s, const struct truth *back, bool reversed,
    bool far, int side, struct sized h[4])
{
	real limit[2];

	truth_limits(s, limit);
	corner_at(s, back, limit, reversed, far, side, h);
}

/* Checks left, right, bottom and top of the scene that inspect prints, without their
 * signs: in a perspective, the side's point on the nearer plane less the eye. */
static void check_edges(const struct scene *s, const struct truth *back,
    const struct picture *r, int tally[VERDICTS])
{
	const struct projection *p = &r->scene.projection;
	const real one[2] = { real_of(1), real_of(1) };
	const double *edge = p->section.edges;
	const double(*k)[4] = s->projection.section.intrinsics;

	if (!r->has_scene || p->section.way != SECTION_EDGES ||
	    p->type == PROJECTION_OBLIQUE)
		return;
	/* the camera of r->scene turns a P that slants */
	if (projection_is_tilted(&s->projection) || k[1][0] != 0)
		return;
	/* a shear within the tolerance is not in r->scene */
	if (s->projection.type == PROJECTION_MATRIX && p->type == PROJECTION_ORTHO &&
	    (s->projection.matrix[2][0] != 0 || s->projection.matrix[2][1] != 0))
		return;
	for (int side = 0; side < 4; side++) {
		struct sized h[4], n, d, eye[2];

		/* without planes the edges are at distance 1, where depth is 1 */
		corner_at(s, back, one, r->reverse_z,
		    !projection_is_open(p) && p->near != r->near, side, h);
		n = h[side / 2];
		d = h[3];
		eye[0] = truth_element(back, 2, side / 2);
		eye[1] = truth_element(back, 2, 3);
		if (p->type == PROJECTION_PERSP) {
			n = sized_sub(sized_mul(n, eye[1]), sized_mul(eye[0], d));
			d = sized_mul(d, eye[1]);
		}
		count_verdict(copysign(edge[side],
				  mpfr_sgn(n.value) * mpfr_sgn(d.value)),
		    n, d, tally);
	}
}

/* Checks the distance of near or far: its z less the eye's z or, in a parallel
 * projection, its z. */
static void check_distance(const struct scene *s, const struct truth *back,
    const struct picture *r, bool far, int tally[VERDICTS])
{
	double got = far ? r->far : r->near;
	const struct projection *p = &s->projection;
	struct sized h[4], eye[4];

	if (projection_is_tilted(p)) {
		if (far && isinf(p->far))
			assert_true(isinf(got));
		else
			count_verdict(got, sized_of(far ? p->far : p->near),
			    truth_w_gradient(p), tally);
		return;
	}

	corner_of(s, back, r->reverse_z, far, 0, h);
	for (int j = 0; j < 4; j++)
		eye[j] = truth_element(back, 2, j);
	if (truth_sign(eye[3], NULL) == 0) {
		got *= truth_gaze_sign(truth_answer(s));
		count_verdict(got, h[2], h[3], tally);
	} else if (truth_sign(h[3], NULL) == 0) {
		assert_true(isinf(got));
	} else {
		struct sized n = sized_sub(sized_mul(h[2], eye[3]),
		    sized_mul(eye[2], h[3]));
		struct sized d = sized_mul(h[3], eye[3]);

		got = copysign(got, mpfr_sgn(n.value) * mpfr_sgn(d.value));
		count_verdict(got, n, d, tally);
	}
}

/* Checks the frustum planes against the coefficients of limit w + x, limit w - x and so
 * on, divided by the length of the gradient. */
static void check_frustum_planes(const struct scene *s, const struct picture *r,
    int tally[VERDICTS])
{
	const struct convention *c = truth_answer(s);
	double up = c->ndc_y_down ? -1 : 1, turn = r->reverse_z ? -1 : 1;
	const double sign[6] = { 1, -1, up, -up, turn, -turn };
	struct truth t;
	real limit[2];

	truth_scene(s, SPACE_WORLD, SPACE_CLIP, &t);
	truth_limits(s, limit);
	for (int k = 0; k < 6; k++) {
		struct sized v[4], most = sized_of(sign[k] < 0 || c->depth_minus_one);

		if (k < 4)
			most = (struct sized){ limit[k / 2], limit[k / 2] };
		for (int i = 0; i < 4; i++)
			v[i] = sized_add(sized_mul(most, truth_element(&t, i, 3)),
			    sized_mul(sized_of(sign[k]), truth_element(&t, i, k / 2)));
		struct sized length = sized_length(v);

		for (int i = 0; i < 4; i++)
			if (truth_sign(length, NULL) != 0 &&
			    !(k >= 4 && projection_is_open(&s->projection)))
				count_verdict(r->frustum_plane[k][i], v[i], length,
				    tally);
			else
				assert_true(isnan(r->frustum_plane[k][i]));
	}
}

/* Clears elements so that x, y, z and w of clip space depend only on x or y, and
 * depth. */
static void clear_slants(double m[4][4])
{
	for (int i = 0; i < 2; i++)
		for (int j = 0; j < 4; j++)
			if (i != j)
				m[i][j] = 0;
}

static void numbers_are_nearest(void **state)
{
	static const char *const what[] = { "distances", "sides", "frustum planes",
		"edges" };
	int tally[4][VERDICTS] = { 0 };
	struct scene s;
	static struct picture r;

	int told = 0;

	(void)state;
	SAMPLES(k, 400) {
		int mark = real_mark();
		struct truth back;
		struct sized h[4];

		sample_scene(&s, k % 3 * 10);
		sample_answer(&s);
		clear_slants(s.projection.matrix);
		if (!picture_of(&s, &r, NULL))
			continue;
		told += s.projection.type == PROJECTION_MATRIX && !isnan(r.near);
		check_frustum_planes(&s, &r, tally[2]);
		truth_scene(&s, SPACE_CLIP, SPACE_VIEW, &back);
		if (!isnan(r.near))
			check_distance(&s, &back, &r, false, tally[0]);
		if (!isnan(r.far))
			check_distance(&s, &back, &r, true, tally[0]);
		check_edges(&s, &back, &r, tally[3]);
		for (int side = 0; side < 4; side++) {
			corner_of(&s, &back, r.reverse_z, false, side, h);
			if (!isnan(r.near_edge[side]))
				count_verdict(r.near_edge[side], h[side / 2], h[3],
				    tally[1]);
		}
		real_release(mark);
	}
	for (int i = 0; i < 4; i++)
		print_message("%s: %d numbers, %d within the tolerance, %d "
			      "wrong\n",
		    what[i], tally[i][NEAREST] + tally[i][WITHIN_TOLERANCE],
		    tally[i][WITHIN_TOLERANCE], tally[i][WRONG]);
	for (int i = 0; i < 4; i++) {
		assert_true(told > 10 && tally[i][NEAREST] > 200);
		assert_int_equal(tally[i][WRONG], 0);
	}
}

/* inspect finds near, far, reverse_z and the edges of a document again. */
static void parameters_are_found_again(void **state)
{
	struct scene s;
	static struct picture r;
	int n = 0;

	(void)state;
	SAMPLES(k, 1000) {
		const struct projection *p = &s.projection;

		sample_scene(&s, k % 2 * 10);
		sample_answer(&s);
		s.has_viewport &= p->section.way == SECTION_INTRINSICS;
		if (!has_planes(p) || projection_is_open(p) ||
		    !picture_of(&s, &r, NULL))
			continue;
		if (!projection_is_tilted(p))
			assert_true(r.near == p->near && r.far == p->far);
		assert_true(r.reverse_z == p->reverse_z);
		n++;
		if (p->section.way != SECTION_EDGES || p->section.edges_at > 0 ||
		    !r.has_scene)
			continue;
		const struct projection *q = &r.scene.projection;
		const bool other = s.convention.right_handed !=
		    r.scene.convention.right_handed;
		int mirror = other != camera_mirrors(&s.camera, &s.convention) ? -1 : 1;

		assert_number(q->section.left, mirror * p->section.left);
		assert_number(q->section.right, mirror * p->section.right);
		assert_number(q->section.bottom, p->section.bottom);
		assert_number(q->section.top, p->section.top);
	}
	assert_true(n > 300);
}

/* Multiplies the camera into the matrix of the projection, with each element the
 * nearest double. */
static void to_one_matrix(struct scene *s)
{
	struct map clip;

	s->answer = NULL;
	assert_true(scene_map(s, SPACE_WORLD, SPACE_CLIP, &clip, NULL));
	for (int i = 0; i < 16; i++)
		s->projection.matrix[i / 4][i % 4] = element(&clip, i / 4, i % 4);
	s->projection.type = PROJECTION_MATRIX;
	s->projection.without_camera = true;
	s->has_camera = false;
	s->viewport.has_full = s->viewport.has_offset = false;
}

static real value_at(real gradient[4], real point[3])
{
	return add(dot(gradient, point, 3), gradient[3]);
}

static void count_nearest(double got, real exact, int tally[2])
{
	tally[got == mpfr_get_d(exact, MPFR_RNDN)]++;
}

/* Checks a perspective given as a matrix with the columns x, y, z and w. The eye is the
 * point where x, y and w are 0. The gaze n is w' / |w'|, with gradients written x', y',
 * z', w'. The plane of ndc depth k is at the distance D from the eye for which z(eye) +
 * D z' . n = k D |w'|. The edges on this plane are (side |w'| - x' . n) D / (x' .
 * right), and the same with y' and up. */
static void check_combined(const struct scene *s, const struct picture *r, int tally[2])
{
	const struct convention *c = &s->convention;
	const struct projection *p = &r->scene.projection;
	const struct camera *camera = &r->scene.camera;
	const double edge[4] = { p->section.left, p->section.right, p->section.bottom,
		p->section.top };
	const double first = c->depth_minus_one ? -1 : 0,
		     distance[2] = { r->near, r->far };
	real g[4][4], m[4][4], back[4][4], eye[3], n[3], up[3], right[3];

	for (int i = 0; i < 16; i++)
		m[i / 4][i % 4] = real_of(s->projection.matrix[i / 4][i % 4]);
	for (int i = 0; i < 4 && c->ndc_y_down; i++)
		m[i][1] = negative(m[i][1]);
	set_inverse(back, m);
	for (int i = 0; i < 16; i++)
		g[i / 4][i % 4] = m[i % 4][i / 4];
	for (int i = 0; i < 3; i++) {
		eye[i] = divide(back[2][i], back[2][3]);
		n[i] = g[3][i];
	}
	real w = root(dot(n, n, 3)), depth = value_at(g[2], eye);

	normalise(n, 3);
	for (int i = 0; i < 3; i++)
		up[i] = sub(g[1][i], mul(n[i], dot(g[1], n, 3)));
	normalise(up, 3);
	cross(up, n, right);
	for (int i = 0; i < 3; i++) {
		right[i] = c->right_handed ? negative(right[i]) : right[i];
		count_nearest(camera->eye[i], eye[i], tally);
		count_nearest(camera->at[i], n[i], tally);
		count_nearest(camera->up[i], up[i], tally);
	}
	real d[2];

	for (int i = 0; i < 2; i++) {
		double k = (i == 1) != r->reverse_z ? 1 : first;

		d[i] = divide(depth, sub(mul(real_of(k), w), dot(g[2], n, 3)));
		if (!isinf(distance[i]))
			count_nearest(distance[i], d[i], tally);
	}
	for (int i = 0; i < 4; i++) {
		real *axis = i < 2 ? right : up, *x = g[i / 2];
		real off = sub(mul(real_of(i % 2 ? 1 : -1), w), dot(x, n, 3));

		count_nearest(edge[i], divide(mul(off, d[0]), dot(x, axis, 3)), tally);
	}
}

/* From a matrix that contains the camera, eye, gaze and projection are the nearest
 * doubles. */
static void cameras_are_found_in_matrices(void **state)
{
	int tally[2] = { 0 }, parallel = 0;
	struct scene s;
	static struct picture was, is;

	(void)state;
	SAMPLES(k, 1500) {
		int mark = real_mark();

		sample_scene(&s, 0);
		s.answer = NULL;
		if (!has_planes(&s.projection) || projection_is_open(&s.projection) ||
		    s.projection.section.way == SECTION_INTRINSICS ||
		    camera_mirrors(&s.camera, &s.convention) ||
		    !picture_of(&s, &was, NULL))
			continue;
		if (!was.has_scene || !(was.near < was.far) ||
		    was.far - was.near < 1e-3 * fabs(was.near) || fabs(was.near) < 1e-3)
			continue;
		to_one_matrix(&s);
		assert_true(picture_of(&s, &is, NULL));
		if (is.notes >> NOTE_NO_ROTATION != 0)
			print_message("%d: notes %x\n", k, is.notes);
		assert_true(is.has_scene);
		assert_true(most_off(&s, &is.scene, &is) < 1e-6);
		if (is.scene.projection.type == PROJECTION_PERSP) {
			assert_number(is.reverse_z, was.reverse_z);
			assert_true(fabs(is.near - was.near) <=
				1e-9 * (fabs(was.near) + fabs(was.far)) ||
			    isinf(was.far));
			check_combined(&s, &is, tally);
		} else {
			parallel++;
		}
		real_release(mark);
	}
	print_message("%d numbers are nearest, %d are not; %d parallel\n", tally[1],
	    tally[0], parallel);
	assert_true(tally[1] > 500 && parallel > 50);
	assert_int_equal(tally[0], 0);
}

/* up and the gaze of a camera that turns are the images of view space's axes. */
static void axes_are_nearest(void **state)
{
	struct scene s;
	int n = 0;

	(void)state;
	SAMPLES(k, 400) {
		int mark = real_mark();
		const struct convention *c;
		double gaze[3], up[3];
		struct truth back;

		sample_scene(&s, 0);
		sample_answer(&s);
		c = scene_answer_convention(&s);
		if (camera_gives_3x3(&s.camera) || !s.has_camera ||
		    projection_is_given_matrix(&s.projection) ||
		    projection_has_intrinsics(&s.projection) ||
		    projection_family(&s.projection) == FAMILY_VOLUME ||
		    s.projection.near > s.projection.far)
			continue;
		picture_axes(&s, gaze, up);
		if (isnan(gaze[0]) || isnan(up[0]))
			continue;
		truth_scene(&s, SPACE_VIEW, SPACE_WORLD, &back);
		for (int i = 0; i < 3; i++) {
			const double y = c->view_y_down ? -1 : 1;
			const struct sized one = sized_of(1);

			assert_true(truth_verdict(up[i] * y, truth_element(&back, 1, i),
					one, false) != WRONG);
			assert_true(
			    truth_verdict(gaze[i] * truth_gaze_sign(c),
				truth_element(&back, 2, i), one, false) != WRONG);
		}
		n++;
		real_release(mark);
	}
	assert_true(n > 40);
}

/* A matrix of floats is taken apart: near, far and the eye are those of the scene that
 * it was made of, but for the errors of floats; and where far is lost to these, its
 * range holds it. The same matrix of 17 digits would be tilted. */
static void floats_are_taken_apart(void **state)
{
	static struct picture was, is;
	struct scene s;
	int n = 0, ranges = 0;

	(void)state;
	SAMPLES(k, 4000) {
		struct projection *p = &s.projection;

		sample_scene(&s, 0);
		s.answer = NULL;
		if (projection_family(p) != FAMILY_PERSP || projection_is_open(p) ||
		    s.camera.way > CAMERA_RVEC || p->section.way == SECTION_INTRINSICS)
			continue;
		p->far = p->near * (k % 2 ? 1e5 : 30);
		for (int i = 0; i < 3; i++) {
			s.camera.eye[i] = sample_between(-9, 9) * p->near;
			s.camera.at[i] = sample_between(-9, 9) * p->near;
		}
		if (!picture_of(&s, &was, NULL) || !was.has_scene || was.aspect > 4 ||
		    was.aspect < 0.25 || was.taxonomy.fov[1] < 20 ||
		    was.taxonomy.fov[1] > 120)
			continue;
		to_one_matrix(&s);
		for (int i = 0; i < 16; i++)
			p->matrix[i / 4][i % 4] = (double)(float)
						      p->matrix[i / 4][i % 4];
		p->matrix_digits = 9;
		p->matrix_of_floats = true;
		assert_true(picture_of(&s, &is, NULL));
		if (!is.has_scene) /* far is behind the eye */
			continue;
		assert_true(fabs(is.near - was.near) <= 1e-3 * was.near);
		for (int i = 0; i < 3; i++)
			assert_true(fabs(is.scene.camera.eye[i] -
					was.taxonomy.eye[i]) <= 1e-3 * was.near);
		n++;
		assert_true(is.residual <= 0x1p-18);
		if ((is.notes >> NOTE_FAR_RANGE & 1) == 0) {
			assert_true(fabs(is.far - was.far) <= 0.03 * was.far);
			continue;
		}
		ranges++;
		assert_true(is.far_range[0] <= was.far && was.far <= is.far_range[1]);
	}
	print_message("%d matrices of floats, %d ranges of far\n", n, ranges);
	assert_true(n > 40 && ranges > 5);
}

/* A depth that grows across the picture is a rounding error up to 2^-18, or 2^-40, of
 * how it grows along the gaze, and beyond an oblique plane. */
static void tilts_have_a_tolerance(void **state)
{
	static struct picture r;

	(void)state;
	for (int digits = 8; digits <= 11; digits++)
		for (int i = -1; i <= 1; i += 2) {
			const double most = digits <= 9 ? 0x1p-18 : 0x1p-40;
			const double tilt = 1.5 * most * (1 + i * 0x1p-10);
			struct scene s = { .projection = { .type = PROJECTION_MATRIX,
					       .without_camera = true,
					       .matrix_digits = digits,
					       .matrix = { { 1, 0, tilt, 0 },
						   { 0, 1, 0, 0 }, { 0, 0, 1.5, 1 },
						   { 0, 0, -1.5, 0 } } } };

			assert_true(picture_of(&s, &r, NULL));
			assert_int_equal(r.has_scene, i < 0);
			assert_int_equal(r.notes >> NOTE_TILTED & 1, i > 0);
			assert_int_equal(r.notes >> NOTE_RESIDUAL & 1,
			    i < 0 && digits <= 9);
			if (i < 0)
				assert_true(
				    fabs(r.residual - tilt / 1.5) <= 0x1p-50 * tilt);
		}
}

/* A scene that is plain by its members has a picture without notes: as sampled, and as
 * one matrix with the camera, of which every second is mirrored. */
static void plain_scenes_have_no_notes(void **state)
{
	int plain = 0, noted = 0;
	struct picture was;
	struct scene s;

	(void)state;
	SAMPLES(k, 1500) {
		sample_scene(&s, 0);
		s.answer = NULL;
		if (k % 3 > 0 && has_planes(&s.projection) &&
		    picture_of(&s, &was, NULL)) {
			to_one_matrix(&s);
			for (int i = 0; i < 4 && k % 3 == 2; i++)
				s.projection.matrix[i][0] *= -1;
		}
		unsigned notes = picture_notes(&s);

		/* edges mirror on purpose */
		if (note_is_plain(&s) && s.projection.section.way == SECTION_EDGES)
			notes &= ~(1u << NOTE_MIRRORED);
		if (note_is_plain(&s) && notes != 0)
			fail_msg("notes %x of a plain scene of type %d", notes,
			    (int)s.projection.type);
		plain += note_is_plain(&s);
		noted += notes != 0;
	}
	print_message("%d plain, %d with notes\n", plain, noted);
	assert_true(plain > 200 && noted > 200);
}

/* A world given in radians makes the whole scene one in radians. */
static void radians_are_kept(void **state)
{
	static struct picture r;
	struct scene s;
	int n = 0, below = 0;

	(void)state;
	SAMPLES(k, 6000) {
		struct projection *p = &s.projection;

		sample_scene(&s, 0);
		s.answer = NULL;
		s.camera.has_axes = false;
		if (p->type != PROJECTION_OBLIQUE || !s.has_world)
			continue;
		s.world.unit = p->unit = p->shear.direction_unit = ANGLE_RADIANS;
		p->shear.kind = OBLIQUE_ANGLE;
		p->shear.projector_angle = sample_between(0.01, 1.5);
		p->shear.direction = sample_between(-9, 9);
		if (!picture_of(&s, &r, NULL) || !r.has_scene)
			continue;
		assert_int_equal(r.scene.projection.type, PROJECTION_OBLIQUE);
		assert_number(r.scene.projection.shear.projector_angle,
		    p->shear.projector_angle);
		assert_number(r.scene.projection.shear.direction, p->shear.direction);
		n++;
		below += fabs(p->shear.direction) < PI;
	}
	print_message("%d oblique scenes in radians, %d below pi\n", n, below);
	assert_true(n > 100 && below > 20 && n - below > 20);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(plain_scenes_have_no_notes),
		cmocka_unit_test(scenes_make_the_same_picture),
		cmocka_unit_test(matrices_give_their_parameters),
		cmocka_unit_test(numbers_are_nearest),
		cmocka_unit_test(parameters_are_found_again),
		cmocka_unit_test(cameras_are_found_in_matrices),
		cmocka_unit_test(radians_are_kept),
		cmocka_unit_test(axes_are_nearest),
		cmocka_unit_test(floats_are_taken_apart),
		cmocka_unit_test(tilts_have_a_tolerance),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
