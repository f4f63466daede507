/* SPDX-License-Identifier: MIT */
/* The names that inspect gives projections, and the near plane that it finds in a
 * matrix. */
#include "../derive/picture.h"

#include "claims.h"

static struct refusals faults;

static void kinds_have_their_names(void **state)
{
	static const double along[5][3] = { { 0, 0, 1 }, { 1, 1, 1 }, { 1, 1, 3 },
		{ 1, 2, 3 }, { 1, 0, 3 } };
	static const enum taxon_kind orthographic[] = { TAXON_MULTIVIEW,
		TAXON_ISOMETRIC, TAXON_DIMETRIC, TAXON_TRIMETRIC, TAXON_TRIMETRIC };
	static const enum taxon_kind perspective[] = { TAXON_ONE_POINT,
		TAXON_THREE_POINT, TAXON_THREE_POINT, TAXON_THREE_POINT,
		TAXON_TWO_POINT };
	struct scene s = { .has_camera = true };
	struct picture t;

	(void)state;
	for (int i = 0; i < 5; i++) {
		struct camera *c = &s.camera;
		struct projection *p = &s.projection;

		*c = (struct camera){ .way = CAMERA_GAZE, .up = { 0, 1, 0 } };
		memcpy(c->at, along[i], sizeof c->at);
		*p = (struct projection){ .type = PROJECTION_PERSP,
			.section.way = SECTION_FOVY,
			.section.angle = 50 + i,
			.aspect = { 4, 3 },
			.near = 1,
			.far = HUGE_VAL };
		assert_true(picture_of(&s, &t, NULL));
		assert_int_equal(t.taxonomy.taxon, TAXON_PERSPECTIVE);
		assert_int_equal(t.taxonomy.kind, perspective[i]);
		assert_number(t.taxonomy.fov[1], 50 + i);

		*p = (struct projection){ .type = PROJECTION_ORTHO,
			.section.way = SECTION_SIZE,
			.section.width = 3,
			.section.height = 2,
			.far = 5 };
		assert_true(picture_of(&s, &t, NULL));
		assert_int_equal(t.taxonomy.taxon, TAXON_ORTHOGRAPHIC);
		assert_int_equal(t.taxonomy.kind, orthographic[i]);
	}
}

static void obliques_have_their_names(void **state)
{
	struct scene s = { .projection = { .type = PROJECTION_OBLIQUE,
			       .section.way = SECTION_SIZE,
			       .section.width = 3,
			       .section.height = 2,
			       .far = 5,
			       .shear.direction = 30 } };
	struct projection *p = &s.projection;
	struct picture t;

	(void)state;
	for (int angle = 0; angle <= 90; angle += 15) {
		p->shear.kind = angle > 0 ? OBLIQUE_ANGLE : OBLIQUE_CABINET;
		p->shear.projector_angle = angle;
		assert_true(picture_of(&s, &t, NULL));
		assert_int_equal(t.taxonomy.taxon,
		    angle == 90 ? TAXON_ORTHOGRAPHIC : TAXON_OBLIQUE);
		assert_int_equal(t.taxonomy.kind,
		    angle == 0      ? TAXON_CABINET :
			angle == 45 ? TAXON_CAVALIER :
			angle == 90 ? TAXON_MULTIVIEW :
				      TAXON_GENERAL);
		assert_number(t.taxonomy.foreshortening[0], 1);
		assert_true(angle > 0 || t.taxonomy.foreshortening[2] == 0.5);
	}
}

/* The same view volume in each convention, as a volume and as a matrix without a
 * camera, whose near plane is the plane nearer to the eye. */
static void eyes_are_on_their_side(void **state)
{
	struct scene s = { 0 };
	struct projection *p = &s.projection;
	struct picture t;

	(void)state;
	for (int k = 0; k < 16; k++) {
		bool reverse = k & 1, right = k & 2, bare = k & 4;
		bool turned = reverse && bare;
		enum taxon taxon = reverse && !bare ? TAXON_REVERSE : TAXON_PERSPECTIVE;
		double sign = right ? -1 : 1;
		struct map m;

		s.convention = (struct convention){ .right_handed = right,
			.depth_minus_one = k & 8,
			.origin_bottom_left = right };
		*p = (struct projection){ .type = PROJECTION_VOLUME,
			.volume.half_width = 1,
			.volume.half_height = 1,
			.volume.z_near = sign,
			.volume.z_far = 2 * sign,
			.volume.inverse_eye_z = reverse ? 0.25 * sign : -sign };
		assert_true(projection_map(p, &s.convention, false, &m, &faults));
		for (int i = 0; i < 16; i++)
			p->matrix[i / 4][i % 4] = element(&m, i / 4, i % 4);
		if (bare)
			p->type = PROJECTION_MATRIX;
		assert_true(picture_of(&s, &t, NULL));
		assert_int_equal(t.taxonomy.taxon, taxon);
		assert_true(t.taxonomy.eye[2] == (reverse ? 4 : -1) * sign);
		assert_int_equal(t.reverse_z, turned);
		assert_true(t.taxonomy.gaze[2] == (turned ? -sign : sign));
		assert_true(fabs(t.taxonomy.corner[0][2]) == (turned ? 2 : 1));
		assert_true(fabs(t.taxonomy.corner[7][2]) == (turned ? 1 : 2));
	}
}

/* Reversed depth does not change the picture, also of a matrix without a camera. */
static void depth_may_be_reversed(void **state)
{
	struct scene s = { .projection = { .type = PROJECTION_PERSP,
			       .section.way = SECTION_SIZE,
			       .section.width = 2,
			       .section.height = 2,
			       .near = 1,
			       .reverse_z = true } };
	struct projection *p = &s.projection;
	struct picture t;
	struct map m;

	(void)state;
	for (int k = 0; k < 8; k++) {
		s.convention = (struct convention){ .right_handed = k & 1 };
		p->type = PROJECTION_PERSP;
		p->far = k & 2 ? HUGE_VAL : 10;
		p->reverse_z = true;
		assert_true(projection_map(p, &s.convention, false, &m, &faults));
		if (k & 4) {
			p->type = PROJECTION_MATRIX;
			p->reverse_z = false;
			for (int i = 0; i < 16; i++)
				p->matrix[i / 4][i % 4] = element(&m, i / 4, i % 4);
		}
		assert_true(picture_of(&s, &t, NULL));
		assert_true(t.reverse_z);
		assert_int_equal(t.taxonomy.taxon, TAXON_PERSPECTIVE);
		assert_true(t.taxonomy.gaze[2] == (k & 1 ? -1 : 1));
		assert_true(t.taxonomy.corner[0][2] == t.taxonomy.gaze[2]);
		assert_true(isnan(t.taxonomy.corner[4][0]) == ((k & 2) != 0));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(kinds_have_their_names),
		cmocka_unit_test(obliques_have_their_names),
		cmocka_unit_test(eyes_are_on_their_side),
		cmocka_unit_test(depth_may_be_reversed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
