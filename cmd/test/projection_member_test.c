/* SPDX-License-Identifier: MIT */
#include "../scene/projection_member.h"
#include "read_text.h"

#include <math.h>

static const struct document_wants persp = { .lone_member = SCENE_PROJECTION,
	.needed = SCENE_PROJECTION,
	WANTS,
	.source.implied_type = PROJECTION_PERSP };
static const struct document_wants ortho = { .lone_member = SCENE_PROJECTION,
	.needed = SCENE_PROJECTION,
	WANTS,
	.source.implied_type = PROJECTION_ORTHO };
static const struct document_wants project = { WANTS };

#define PLANES "\"near\":1,\"far\":2"

static void test_section(void **state)
{
#define PERSP(members)                                                          \
	scene_of("{\"projection\":{\"type\":\"persp\",\"near\":1,\"far\":"      \
		 "9," members "},\"viewport\":{\"width\":640,\"height\":480}}") \
	    .projection
	struct projection p = PERSP("\"fovy\":60");

	(void)state;
	assert_int_equal(p.type, PROJECTION_PERSP);
	assert_int_equal(p.section.way, SECTION_FOVY);
	assert_number(p.section.angle, 60);
	assert_number(p.near, 1);
	assert_number(p.far, 9);
	assert_true(!p.reverse_z && p.near_ratio == 0.0005);
	assert_numbers(p.aspect, 2, 640.0, 480.0);
	p = PERSP("\"fovx\":179.99999999999997,\"aspect\":2,\"reverse_z\":true");
	assert_int_equal(p.section.way, SECTION_FOVX);
	assert_numbers(p.aspect, 2, 2.0, 1.0);
	assert_true(p.reverse_z);
	assert_int_equal(PERSP("\"view_angle\":1").section.way, SECTION_VIEW_ANGLE);
	p = PERSP("\"field\":1e-150");
	assert_int_equal(p.section.way, SECTION_FIELD);
	assert_number(p.section.field, 1e-150);
	p = PERSP("\"width\":2,\"height\":3");
	assert_int_equal(p.section.way, SECTION_SIZE);
	assert_number(p.section.width, 2);
	assert_number(p.section.height, 3);
	p = PERSP("\"left\":-1,\"right\":2,\"bottom\":-3,\"top\":4");
	assert_int_equal(p.section.way, SECTION_EDGES);
	assert_numbers(&p.section.left, 4, -1.0, 2.0, -3.0, 4.0);
	p = scene_of("{\"viewport\":{\"width\":4,\"height\":3,\"scale\":"
		     "\"uniform\"},\"projection\":{\"type\":\"persp\","
		     "\"near\":1,\"far\":\"infinity\",\"fovy\":90}}")
		.projection;
	assert_numbers(p.aspect, 2, 1.0, 1.0);
	assert_true(isinf(p.far));
}

static void assert_rows(const struct projection *p, int n, ...)
{
	va_list wanted;

	va_start(wanted, n);
	for (int i = 0; i < 12; i++)
		assert_number(p->section.intrinsics[i / 4][i % 4],
		    va_arg(wanted, double));
	va_end(wanted);
	assert_int_equal(p->section.way, SECTION_INTRINSICS);
	assert_numbers(&p->section.width, 2, 640.0, 480.0);
	assert_int_equal(projection_is_open(p), n);
}

static void test_intrinsics(void **state)
{
#define CALIBRATED(members)                                                 \
	scene_of("{\"convention\":\"d3d\",\"projection\":{\"type\":"        \
		 "\"persp\",\"intrinsics\":" members                        \
		 "},\"viewport\":{\"width\":640,\"height\":480,\"x\":-0.5," \
		 "\"scale\":\"fill\"}}")                                    \
	    .projection
	struct projection p = CALIBRATED("[1,2,3,4]");

	(void)state;
	assert_rows(&p, 1, 1.0, 0.0, 3.0, 0.0, 0.0, 2.0, 4.0, 0.0, 0.0, 0.0, 1.0, 0.0);
	assert_true(isinf(p.far) && p.reverse_z);
	p = CALIBRATED("[[1,2,3],[0,4,5],[0,0,1]],\"near\":7");
	assert_rows(&p, 0, 1.0, 2.0, 3.0, 0.0, 0.0, 4.0, 5.0, 0.0, 0.0, 0.0, 1.0, 0.0);
	assert_true(p.near == 7 && isinf(p.far) && !p.reverse_z);
	p = CALIBRATED("[[1,2,3,-4],[0,5,6,7],[0,0,1,8]],\"near\":7,\"far\":9,"
		       "\"reverse_z\":true");
	assert_rows(&p, 0, 1.0, 2.0, 3.0, -4.0, 0.0, 5.0, 6.0, 7.0, 0.0, 0.0, 1.0, 8.0);
	assert_true(p.far == 9 && p.reverse_z);
	p = CALIBRATED("[1,2,3, 0,4,5, 0,0,1]");
	assert_rows(&p, 1, 1.0, 2.0, 3.0, 0.0, 0.0, 4.0, 5.0, 0.0, 0.0, 0.0, 1.0, 0.0);
	p = CALIBRATED("[-1,2,3,4, 5,6,7,8, 9,10,11,12]");
	assert_rows(&p, 1, -1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0,
	    12.0);
}

static void test_angles(void **state)
{
	struct projection p = PERSP("\"angles\":[-54,40,-54,42]");

	(void)state;
	assert_int_equal(p.section.way, SECTION_ANGLES);
	assert_numbers(p.section.angles, 4, -54.0, 40.0, -54.0, 42.0);
	p = PERSP("\"width\":2,\"height\":3,\"edges_at\":0.5");
	assert_int_equal(p.section.way, SECTION_SIZE);
	assert_number(p.section.edges_at, 0.5);
	p = PERSP("\"width\":2,\"aspect\":3,\"edges_at\":0.5");
	assert_int_equal(p.section.way, SECTION_WIDTH);
	p = PERSP("\"height\":2,\"aspect\":3");
	assert_int_equal(p.section.way, SECTION_HEIGHT);
	assert_numbers(p.aspect, 2, 3.0, 1.0);
	p = PERSP("\"left\":-1,\"right\":2,\"bottom\":-3,\"top\":4,"
		  "\"edges_at\":1");
	assert_int_equal(p.section.way, SECTION_EDGES);
	assert_number(p.section.edges_at, 1);
}

static void test_parallel(void **state)
{
	struct document_wants wants = ortho;

	(void)state;
	struct document d = read_as(&wants,
	    "{\"near\":-1,\"far\":-2,\"height\":2,\"aspect\":1.5}");

	assert_int_equal(d.scene.projection.type, PROJECTION_ORTHO);
	assert_int_equal(d.scene.projection.section.way, SECTION_HEIGHT);
	assert_number(d.scene.projection.near, -1);
	assert_numbers(d.scene.projection.aspect, 2, 1.5, 1.0);
	wants.source.implied_type = PROJECTION_OBLIQUE;
#define SHEARED(members)                                  \
	read_as(&wants,                                   \
	    "{\"type\":\"oblique\",\"near\":0,\"far\":1," \
	    "\"width\":1,\"height\":1," members "}")      \
	    .scene.projection
	struct projection p = SHEARED("\"kind\":\"cavalier\"");

	assert_int_equal(p.section.way, SECTION_SIZE);
	assert_int_equal(p.shear.kind, OBLIQUE_CAVALIER);
	assert_number(p.shear.direction, 45);
	assert_number(p.shear.plane, 0);
	p = SHEARED("\"kind\":\"cabinet\",\"direction\":-30,\"plane\":7");
	assert_int_equal(p.shear.kind, OBLIQUE_CABINET);
	assert_number(p.shear.direction, -30);
	assert_number(p.shear.plane, 7);
	p = SHEARED("\"angle\":90");
	assert_int_equal(p.shear.kind, OBLIQUE_ANGLE);
	assert_number(p.shear.projector_angle, 90);
}

/* angle_unit is read from the document, wherever the projection stands in it. In a
 * document that is a projection alone, angle_unit stands beside its members. */
static void test_angle_unit(void **state)
{
#define LENS "\"fovy\":3,\"aspect\":1," PLANES
	struct document d = read_as(&persp, "{" LENS ",\"angle_unit\":\"radians\"}");

	(void)state;
	assert_number(d.scene.projection.unit, ANGLE_RADIANS);
	assert_number(d.scene.projection.section.angle, 3);
	assert_number(d.source.unit, ANGLE_RADIANS);
	d = read_as(&project,
	    "{\"projection\":{\"type\":\"persp\"," LENS "},\"angle_unit\":"
	    "\"radians\",\"camera\":{\"eye\":[0,0,0],\"at\":[0,0,1],\"roll\":2}"
	    "}");
	assert_number(d.scene.projection.unit, ANGLE_RADIANS);
	assert_number(d.scene.camera.unit, ANGLE_RADIANS);
	d = read_as(&persp, "{" LENS ",\"angle_unit\":\"degrees\"}");
	assert_number(d.scene.projection.unit, ANGLE_DEGREES);
	/* the default direction is in degrees */
	struct projection p = scene_of(
	    "{\"angle_unit\":\"radians\","
	    "\"projection\":{\"type\":\"oblique\","
	    "\"kind\":\"cabinet\"," PLANES ",\"width\":1,\"height\":1}}")
				  .projection;

	assert_number(p.shear.direction, 45);
	assert_number(p.shear.direction_unit, ANGLE_DEGREES);
	p = scene_of("{\"projection\":{\"type\":\"oblique\",\"direction\":1,"
		     "\"kind\":\"cabinet\"," PLANES
		     ",\"width\":1,\"height\":1},\"angle_unit\":\"radians\"}")
		.projection;
	assert_number(p.shear.direction, 1);
	assert_number(p.shear.direction_unit, ANGLE_RADIANS);
}

static void test_volume(void **state)
{
#define VOLUME(members)                                                      \
	scene_of("{\"projection\":{\"type\":\"volume\",\"half_width\":1,"    \
		 "\"half_height\":2,\"z_near\":-3,\"z_far\":4" members "}}") \
	    .projection
	struct projection p = VOLUME("");

	(void)state;
	assert_int_equal(p.type, PROJECTION_VOLUME);
	assert_numbers(&p.volume.half_width, 4, 1.0, 2.0, -3.0, 4.0);
	assert_number(p.volume.eye_given_by, EYE_BY_INVERSE_Z);
	assert_number(p.volume.inverse_eye_z, 0);
	p = VOLUME(",\"inverse_eye_z\":-0.1,\"tan_skew\":[5,6]");
	assert_number(p.volume.eye_given_by, EYE_BY_INVERSE_Z);
	assert_number(p.volume.inverse_eye_z, -0.1);
	assert_numbers(p.volume.tan_skew, 2, 5.0, 6.0);
	p = VOLUME(",\"eye\":[7,8,-9]");
	assert_number(p.volume.eye_given_by, EYE_BY_POINT);
	assert_numbers(p.volume.eye, 3, 7.0, 8.0, -9.0);
	p = VOLUME(",\"view_angle\":0,\"tan_skew\":[5,6]");
	assert_number(p.volume.eye_given_by, EYE_BY_ANGLE);
	assert_number(p.volume.view_angle, 0);
	assert_number(p.aspect[1], 0);
	p = scene_of("{\"angle_unit\":\"radians\",\"projection\":{\"type\":"
		     "\"volume\",\"size\":3,\"view_angle\":3,\"z_near\":1,"
		     "\"z_far\":0},\"viewport\":{\"width\":4,\"height\":2}}")
		.projection;
	assert_number(p.volume.eye_given_by, EYE_BY_ANGLE);
	assert_number(p.volume.view_angle, 3);
	assert_number(p.unit, ANGLE_RADIANS);
	assert_numbers(&p.volume.half_width, 4, 1.5, 1.5, 1.0, 0.0);
	assert_number(p.aspect[0], 4);
	assert_number(p.aspect[1], 2);
}

static void every_type_has_rows(void **state)
{
	(void)state;
	for (int i = 0; i < PROJECTION_TYPES - 1; i++) {
		bool member = false, rule = false;

		if (projection_type_names[i] == NULL)
			fail_msg("type %d has no name", i + 1);
		for (const struct member *m = projection_members; m->name != NULL; m++)
			member |= (m->variants >> i & 1) != 0;
		for (const struct rule *r = projection_rules; r->ways != NULL; r++)
			rule |= (r->variants >> i & 1) != 0;
		if (!member || !rule)
			fail_msg("type %s lacks members or rules",
			    projection_type_names[i]);
	}
}

/* Returns whether a rule for the type names the row. */
static bool is_ruled(const struct member *row, int type)
{
	const uint64_t bit = MEMBER_BIT(row - projection_members);
	bool is = false;

	for (const struct rule *r = projection_rules; r->n > 0; r++)
		for (size_t k = 0; k < r->n; k++)
			is |= (r->variants >> type & 1) != 0 &&
			    ((r->ways[k].has | r->ways[k].optional) & bit) != 0;
	return is;
}

/* A member without a default that no rule names would be 0 if it is not given, as only
 * min_near may be. */
static void members_have_rules_or_defaults(void **state)
{
	(void)state;
	for (int i = 0; i < PROJECTION_TYPES - 1; i++)
		for (const struct member *m = projection_members; m->name != NULL; m++)
			if ((m->variants >> i & 1) != 0 && m->fallback == NULL &&
			    strcmp(m->name, "min_near") != 0 && !is_ruled(m, i))
				fail_msg("no rule of type %s names %s",
				    projection_type_names[i], m->name);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_section),
		cmocka_unit_test(test_parallel),
		cmocka_unit_test(test_intrinsics),
		cmocka_unit_test(test_angles),
		cmocka_unit_test(test_angle_unit),
		cmocka_unit_test(test_volume),
		cmocka_unit_test(every_type_has_rows),
		cmocka_unit_test(members_have_rules_or_defaults),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
