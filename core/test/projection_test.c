/* SPDX-License-Identifier: MIT */
/* The projections and their inverses against MPFR, and refusals. */
#include "claims.h"

static const struct convention d3d, gl = { true, true, true, false, true, false };

/* Compares the matrix of a projection and its inverse with the truth. Returns the
 * reason if the projection is refused. */
static const char *compare(const struct projection *p, const struct convention *c,
    struct worst *w)
{
	struct scene s = { .projection = *p, .convention = *c };
	struct map m;
	struct truth t;
	int mark = real_mark();
	const char *why = projection_map(p, c, false, &m);

	if (why == NULL) {
		truth_scene(&s, SPACE_VIEW, SPACE_CLIP, &t);
		truth_compare(&t, &m, w);
		why = projection_map(p, c, true, &m);
	}
	if (why == NULL && map_is_finite(&m)) {
		truth_scene(&s, SPACE_CLIP, SPACE_VIEW, &t);
		truth_compare(&t, &m, w);
	}
	real_release(mark);
	return why;
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
		bool is = compare(&p, &c, &w) == NULL;

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
		assert_null(compare(&p, i & 2 ? &gl : &d3d, &w));
	}
	p.volume.eye_given_by = EYE_BY_POINT;
	for (int i = 0; i < 20; i++) {
		p.volume.eye[0] = 5;
		p.volume.eye[2] = (i % 2 ? -1 : 1) * pow(10, 2 + 7 * i);
		assert_null(compare(&p, i & 2 ? &gl : &d3d, &w));
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
		assert_null(compare(&p, i & 2 ? &gl : &d3d, &w));
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
			assert_null(compare(&p, &d3d, &w));
			p.section.angle = ldexp(1, -11 * k);
			assert_null(compare(&p, &gl, &w));
			p.far = 1 + pow(10, -k / 3);
		}
	assert_maps("narrow and wide angles", &w);
}

static void map_for(const struct projection *p, struct map *m)
{
	assert_null(projection_map(p, &d3d, false, m));
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
    const char *member)
{
	struct map m;

	assert_reason(projection_map(p, &d3d, inverse, &m), member);
	assert_reason(projection_map(p, &gl, inverse, &m), member);
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
	assert_null(compare(&p, &d3d, &(struct worst){ 0 }));
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
		for (int inverse = 0; inverse < 2 && cases[k].refused; inverse++)
			assert_projection_refused(&p, inverse,
			    "/projection/matrix: is transposed");
		if (!cases[k].refused)
			assert_null(projection_map(&p, &d3d, false, &m));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(random_projections),
		cmocka_unit_test(eyes_through_infinity),
		cmocka_unit_test(volumes_by_angle),
		cmocka_unit_test(narrow_and_wide_angles),
		cmocka_unit_test(elements_by_bc),
		cmocka_unit_test(refusals),
		cmocka_unit_test(transposed_matrices),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
