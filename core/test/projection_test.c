/* SPDX-License-Identifier: MIT */
/* The projections and their inverses against MPFR, and refusals. */
#include "block.h"
#include "claims.h"

static const struct convention d3d, gl = { true, true, true, false, true, false };

static struct refusals faults;

/* Compares the matrix of a projection and its inverse with the truth. Returns whether
 * the projection is not refused. */
static bool compare(const struct projection *p, const struct convention *c,
    struct worst *w)
{
	struct scene s = { .projection = *p, .convention = *c };
	struct map m;
	struct truth t;
	int mark = real_mark();
	bool is = projection_map(p, c, false, &m, &faults);

	if (is) {
		truth_scene(&s, SPACE_VIEW, SPACE_CLIP, &t);
		truth_compare(&t, &m, w);
		is = projection_map(p, c, true, &m, &faults);
	}
	if (is && map_is_finite(&m)) {
		truth_scene(&s, SPACE_CLIP, SPACE_VIEW, &t);
		truth_compare(&t, &m, w);
	}
	real_release(mark);
	return is;
}

static void check_projections(const char *what, int e, int tries)
{
	struct worst w = { 0 };
	int refused = 0, compared[PROJECTION_TYPES] = { 0 };

	SAMPLES(i, tries) {
		struct projection p;
		struct convention c;

		sample_projection(&p, e);
		sample_convention(&c);
		bool is = compare(&p, &c, &w);

		compared[p.type] += is;
		refused += !is;
	}
	assert_maps(what, &w);
	assert_true(refused < tries / 4);
	for (int type = 1; type < PROJECTION_TYPES; type++)
		if (compared[type] < tries / 4 / PROJECTION_TYPES)
			fail_msg("type %d is hardly sampled", type);
}

static void random_projections(void **state)
{
	(void)state;
	check_projections("ordinary", 0, 600);
	check_projections("hostile, to 1e2", 2, 600);
	check_projections("hostile, to 1e20", 20, 400);
	check_projections("hostile, to 1e150", 150, 400);
}

/* Volumes whose eye is at infinity, where inverse_eye_z is 0, or nearly there on both
 * sides. */
static void eyes_through_infinity(void **state)
{
	static const double tiny[] = { 0, 1e-150, 1e-30, 1e-16, 1e-9, 0.01 };
	struct worst w = { 0 };
	struct projection p = {
		.type = PROJECTION_VOLUME,
		.volume.half_width = 3,
		.volume.half_height = 2,
		.volume.z_near = 7,
		.volume.z_far = -11,
		.volume.tan_skew = { 0.1, 0.7 },
	};

	(void)state;
	for (int i = 0; i < 24; i++) {
		p.volume.inverse_eye_z = i % 2 ? -tiny[i / 4] : tiny[i / 4];
		assert_true(compare(&p, i & 2 ? &gl : &d3d, &w));
	}
	p.volume.eye_given_by = EYE_BY_POINT;
	for (int i = 0; i < 20; i++) {
		p.volume.eye[0] = 5;
		p.volume.eye[2] = (i % 2 ? -1 : 1) * pow(10, 2 + 7 * i);
		assert_true(compare(&p, i & 2 ? &gl : &d3d, &w));
	}
	assert_maps("volume through q = 0", &w);
}

static void volumes_by_angle(void **state)
{
	struct worst w = { 0 };
	struct projection p = {
		.type = PROJECTION_VOLUME,
		.volume.half_width = 3,
		.volume.half_height = 2,
		.volume.tan_skew = { 0.1, 0.7 },
		.volume.eye_given_by = EYE_BY_ANGLE,
	};

	(void)state;
	for (int i = 0; i < 120; i++) {
		p.unit = i % 3 == 0 ? ANGLE_RADIANS : ANGLE_DEGREES;
		p.volume.view_angle = ldexp(i % 3 == 0 ? 1.5 : 170, -(i / 4));
		p.volume.z_near = i & 1 ? -0.09 : 0.09;
		p.volume.z_far = i & 1 ? 11 : -11;
		p.aspect[0] = i % 5;
		p.aspect[1] = i % 5 == 0 ? 0 : i % 7 + 1;
		p.volume.half_height = p.aspect[1] == 0 ? 2 : p.volume.half_width;
		assert_true(compare(&p, i & 2 ? &gl : &d3d, &w));
	}
	assert_maps("volumes by angle", &w);
}

static void narrow_and_wide_angles(void **state)
{
	struct worst w = { 0 };
	struct projection p = { .near = 1,
		.far = (double)INFINITY,
		.aspect = { 16, 9 } };

	(void)state;
	for (int k = 0; k < 45; k++)
		for (p.section.way = SECTION_FOVY; p.section.way <= SECTION_VIEW_ANGLE;
		     p.section.way++) {
			p.type = PROJECTION_PERSP;
			p.section.angle = 180 - ldexp(1, -k);
			assert_true(compare(&p, &d3d, &w));
			p.section.angle = ldexp(1, -11 * k);
			assert_true(compare(&p, &gl, &w));
			p.far = 1 + pow(10, -k / 3);
		}
	assert_maps("narrow and wide angles", &w);
}

/* Judges images of points that are at most 1e-30 from the plane of view z `z`, which is
 * at least 1e45 from the eye. The world adds the distance from the plane to the points'
 * z, which doubles could not hold. */
static void judge_beside_plane(struct scene *s, double z, struct tally *tally)
{
	static struct block b;
	static struct transform t;
	static struct truth truth;
	const int mark = real_mark();
	const double beside = pow(10, -30 - (double)sample_below(40));

	s->has_world = true;
	s->world.matrix[3][2] = sample_below(2) ? beside : -beside;
	for (int i = 0; i < 4; i++)
		s->world.matrix[i][i] = 1;
	for (int i = 0; i < POINTS; i++) {
		b.in[0][i] = i % 2 ? 0 : sample_number(3) * beside;
		b.in[1][i] = i % 3 ? 0 : sample_number(3) * beside;
		b.in[2][i] = z;
	}
	truth = (struct truth){ .n = 0 };
	truth_scene(s, SPACE_MODEL, SPACE_NDC, &truth);
	assert_true(transform_of_scene(s, SPACE_MODEL, SPACE_NDC, false, &t, NULL));
	map_block_exactly(&t, &b, POINTS);
	judge_block(&truth, &t, &b, POINTS, false, tally);
	real_release(mark);
}

static void assert_all_nearest(const struct tally *tally)
{
	assert_int_equal(tally->n[WITHIN_TOLERANCE], 0);
	assert_int_equal(tally->n[WRONG], 0);
	assert_true(tally->n[NEAREST] > 2000);
}

/* The difference from the plane must be multiplied by the shear: the difference of two
 * products by the shear, whose error is 2^-309, has lost it. */
static void oblique_beside_its_plane(void **state)
{
	struct tally tally = { 0 };

	(void)state;
	SAMPLES(i, 80) {
		struct scene s = { .projection = { .type = PROJECTION_OBLIQUE,
				       .shear.kind = sample_below(3),
				       .shear.projector_angle = 50,
				       .shear.direction = sample_between(1, 89),
				       .section.way = SECTION_SIZE,
				       .section.width = 3,
				       .section.height = 7,
				       .near = 1,
				       .far = 10 } };
		double plane = pow(10, 45 + (double)sample_below(20));

		sample_convention(&s.convention);
		s.projection.shear.plane = i & 1 ? plane : -plane;
		judge_beside_plane(&s,
		    s.projection.shear.plane * truth_gaze_sign(&s.convention), &tally);
	}
	assert_all_nearest(&tally);
}

/* Depth is 0 in the near plane: the difference from it must be multiplied by what the
 * view angle makes. */
static void volume_beside_its_near_plane(void **state)
{
	struct tally tally = { 0 };

	(void)state;
	SAMPLES(i, 80) {
		double z_near = pow(10, 45 + (double)sample_below(20));
		struct scene s = { .projection = { .type = PROJECTION_VOLUME,
				       .volume.half_width = 1e40,
				       .volume.half_height = 2e40,
				       .volume.z_near = i & 1 ? z_near : -z_near,
				       .volume.eye_given_by = EYE_BY_ANGLE,
				       .volume.view_angle = sample_between(1, 99),
				       .volume.tan_skew = { 0.1, 0.7 } } };
		struct projection_volume *v = &s.projection.volume;

		sample_convention(&s.convention);
		v->z_far = (2 + sample_unit()) * v->z_near;
		judge_beside_plane(&s, v->z_near, &tally);
	}
	assert_all_nearest(&tally);
}

/* If z of view space is multiplied by a number with an error, the map's origin is in a
 * plane where it is multiplied by 0, so that its image has no error. */
static void errors_of_every_type_have_a_plane(void **state)
{
	int inexact[PROJECTION_TYPES] = { 0 };

	(void)state;
	SAMPLES(i, 2000) {
		struct projection p;
		struct map m;

		sample_projection(&p, 0);
		p.shear.plane = sample_number(2);
		if (!projection_map(&p, &d3d, false, &m, &faults))
			continue;
		for (int j = 0; j < 3; j++) {
			if (sum_is_exact(&m.m[2][j]))
				continue;
			inexact[p.type]++;
			if (!sum_is_exact(&m.m[4][j]))
				fail_msg("type %d lacks its plane", (int)p.type);
		}
	}
	assert_true(inexact[PROJECTION_PERSP] > 50);
	assert_true(inexact[PROJECTION_OBLIQUE] > 50);
	assert_true(inexact[PROJECTION_VOLUME] > 50);
}

/* Every type has a row, and is the one that its family and shear choose, or has the
 * same of them. */
static void types_by_properties(void **state)
{
	(void)state;
	for (unsigned type = 1; type < PROJECTION_TYPES; type++) {
		struct projection p = { .type = type }, q = { .near = 1 };
		const bool sheared = projection_is_sheared(&p);

		if (projection_family(&p) == FAMILY_FIXED &&
		    !projection_is_given_matrix(&p))
			fail_msg("type %u has no row", type);
		projection_set_defaults(&q,
		    projection_type_of(projection_family(&p), sheared));
		assert_false(projection_is_none(&p));
		assert_false(projection_is_none(&q));
		assert_int_equal(projection_family(&q), projection_family(&p));
		assert_int_equal(projection_is_sheared(&q), sheared);
		assert_number(q.near, 0);
		assert_number(q.near_ratio, 0.0005);
		assert_number(q.shear.direction, 45);
		assert_int_equal(q.shear.direction_unit, ANGLE_DEGREES);
	}
	assert_true(projection_is_none(&(struct projection){ .near = 1 }));
	assert_int_equal(projection_type_of(FAMILY_VOLUME, true), PROJECTION_NONE);
}

static void map_for(const struct projection *p, struct map *m)
{
	assert_true(projection_map(p, &d3d, false, m, &faults));
}

/* Elements that are short are exact, and others have the digits of bc. */
static void elements_by_bc(void **state)
{
	struct projection p = { .type = PROJECTION_PERSP,
		.section.angle = 90,
		.aspect = { 2, 1 },
		.near = 1,
		.far = (double)INFINITY };
	struct map m;

	(void)state;
	map_for(&p, &m);
	assert_number(element(&m, 0, 0), 0.5);
	assert_number(element(&m, 1, 1), 1);
	assert_number(element(&m, 2, 2), 1);
	assert_number(element(&m, 2, 3), 1);
	assert_number(element(&m, 3, 2), -1);
	assert_number(element(&m, 3, 3), 0);
	p.section.angle = 60;
	map_for(&p, &m);
	assert_number(element(&m, 1, 1), 1.7320508075688772935274463415058723669);
	assert_number(element(&m, 0, 0), 0.8660254037844386467637231707529361835);

	p = (struct projection){ .type = PROJECTION_OBLIQUE,
		.shear.kind = OBLIQUE_CABINET,
		.shear.direction = 90,
		.shear.plane = 1,
		.section.way = SECTION_SIZE,
		.section.width = 2,
		.section.height = 2,
		.near = 1,
		.far = 2 };
	map_for(&p, &m);
	assert_number(element(&m, 2, 0), 0);
	assert_number(element(&m, 3, 0), 0);
	assert_number(element(&m, 2, 1), 0.5);
	assert_number(element(&m, 3, 1), -0.5);
	p.shear.kind = OBLIQUE_CAVALIER;
	p.shear.direction = 45;
	map_for(&p, &m);
	assert_number(element(&m, 2, 0), 0.7071067811865475244008443621048490393);
}

static void assert_projection_refused(const struct projection *p, bool inverse,
    const char *where)
{
	const struct convention *const both[] = { &d3d, &gl };
	struct map m;

	for (int i = 0; i < 2; i++) {
		faults.n = 0;
		assert_false(projection_map(p, both[i], inverse, &m, &faults));
		assert_int_equal(faults.n, 1);
		assert_string_equal(faults.list[0].where, where);
		assert_true(*faults.list[0].what != '\0');
	}
}

static void refusals(void **state)
{
	const struct projection good = {
		.section.way = SECTION_EDGES,
		.near = 1,
		.far = 2,
		.section.left = -1,
		.section.right = 1,
		.section.bottom = -1,
		.section.top = 1,
		.volume.half_width = 1,
		.volume.half_height = 1,
		.volume.z_near = 1,
		.volume.z_far = -1,
	};
	struct projection p = good;

	(void)state;
	p.type = PROJECTION_PERSP;
	p.near = 2;
	assert_projection_refused(&p, false, "/projection/near");
	p.type = PROJECTION_ORTHO;
	assert_projection_refused(&p, false, "/projection/far");
	p = good;
	p.type = PROJECTION_PERSP;
	p.section.left = 1;
	assert_projection_refused(&p, false, "/projection/right");
	p = good;
	p.type = PROJECTION_OBLIQUE;
	p.section.top = -1;
	assert_projection_refused(&p, true, "/projection/top");
	p.type = PROJECTION_VOLUME;
	p.volume.inverse_eye_z = 1;
	assert_projection_refused(&p, false, "/projection/inverse_eye_z");
	p.volume.inverse_eye_z = nextafter(1, 0);
	assert_true(compare(&p, &d3d, &(struct worst){ 0 }));
	p.volume.eye_given_by = EYE_BY_POINT;
	assert_projection_refused(&p, false, "/projection/eye");
	p.volume.eye[2] = 0.5;
	assert_projection_refused(&p, true, "/projection/eye");
	p.volume.z_near = -1;
	assert_projection_refused(&p, false, "/projection/z_far");
	p.type = PROJECTION_MATRIX;
	assert_projection_refused(&p, true, "/projection/matrix");
}

/* The last row of a transposed perspective is 0 0 1 0 or 0 0 -1 0. A perspective with
 * w = z or w = -z and an affine matrix may have this row, too: they are not refused. */
static void transposed_matrices(void **state)
{
	static const struct {
		double column[4], row[3];
		bool refused;
	} cases[] = {
		{ { 0, 0, -1, 0 }, { 0, 0, 1 }, false },
		{ { 0, 0, 1, 0 }, { 0, 0, -1 }, false },
		{ { 0, 0, 0, 1 }, { 0, 0, 1 }, false },
		{ { 0, 0, -2, 0 }, { 0, 0, 1 }, true },
		{ { 0, 0, -2, 0 }, { 0, 0, -1 }, true },
		{ { 0, 1, 1, 0 }, { 0, 0, -1 }, true },
		{ { 0, 0, -2, 0 }, { 0, 1, -1 }, false },
		{ { 0, 0, -2, 0 }, { 0, 0, -2 }, false },
	};

	(void)state;
	for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
		struct projection p = { .type = PROJECTION_MATRIX,
			.matrix = { { 1 }, { 0, 1 }, { 0, 0, 1 } } };
		struct map m;

		memcpy(p.matrix[3], cases[k].row, sizeof cases[k].row);
		for (int i = 0; i < 4; i++)
			p.matrix[i][3] = cases[k].column[i];
		for (int inverse = 0; inverse < 2 && cases[k].refused; inverse++) {
			assert_projection_refused(&p, inverse, "/projection/matrix");
			assert_string_equal(faults.list[0].what, "is transposed");
		}
		if (!cases[k].refused)
			assert_true(projection_map(&p, &d3d, false, &m, &faults));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(types_by_properties),
		cmocka_unit_test(random_projections),
		cmocka_unit_test(eyes_through_infinity),
		cmocka_unit_test(volumes_by_angle),
		cmocka_unit_test(narrow_and_wide_angles),
		cmocka_unit_test(errors_of_every_type_have_a_plane),
		cmocka_unit_test(oblique_beside_its_plane),
		cmocka_unit_test(volume_beside_its_near_plane),
		cmocka_unit_test(elements_by_bc),
		cmocka_unit_test(refusals),
		cmocka_unit_test(transposed_matrices),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
