/* SPDX-License-Identifier: MIT */
#include "read_text.h"
#include "../scene/convention_member.h"

static const struct document_wants no_points = { .used = ~0u };

static void test_bare(void **state)
{
	const struct document_wants lookat = { WANTS, .lone_member = SCENE_CAMERA,
		.needed = SCENE_CAMERA };
	struct document d = read_as(&lookat,
	    "{\"$schema\":1,\"_a\":[{\"\":1e999}],\"_a\":2,\"eye\":[1,2,3],"
	    "\"gaze\":[4,5,6]}");

	(void)state;
	assert_string_equal(d.source.row->name, "camera");
	assert_string_equal(d.source.name, "s.json");
	assert_true(d.scene.has_camera);
	assert_false(d.scene.has_world);
	assert_null(d.points);
	d = read_as(&lookat, "{\"camera\":{\"eye\":[1,2,3],\"at\":[4,5,6]}}");
	assert_null(d.source.row->name);
	assert_true(d.scene.has_camera);
	d = read_as(&(struct document_wants){ WANTS }, "{}");
	assert_null(d.source.row->name);
	assert_false(d.scene.has_camera);
	assert_int_equal(d.scene.projection.type, PROJECTION_NONE);
}

static void test_numbers(void **state)
{
	static const char *const texts[] = { "0.1", "-0.0", "1e-400",
		"4.9406564584124654e-324", "123456789012345678901234567890",
		"0.10000000000000000555111512312578270211815834045410156250000",
		"1.00000000000000011102230246251565404236316680908203125",
		"1.000000000000000111022302462515654042363166809082031250000000"
		"00000000000000000000000000000000000001",
		"90071992547409930000000000000000000000000000000000000000000000"
		"0000000000000000000000e-70" };
	char document[300];

	(void)state;
	for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
		strcpy(document,
		    "{\"camera\":{\"eye\":[0,0,0],\"at\":[0,0,1],\"roll\":");
		strcat(strcat(document, texts[i]), "}}");
		assert_true(scene_of(document).camera.roll == strtod(texts[i], NULL));
	}
}

static void assert_convention(const struct convention *c, const char *bits)
{
	const bool members[] = { c->right_handed, c->depth_minus_one, c->column_vectors,
		c->ndc_y_down, c->origin_bottom_left, c->view_y_down };
	char got[7] = "";

	for (int i = 0; i < 6; i++)
		got[i] = members[i] ? '1' : '0';
	assert_text(got, bits, "convention");
}

/* Asserts the members of each convention as bits, in the order of assert_convention. A
 * bit is 1 where the member differs from d3d. */
static void test_convention(void **state)
{
	static const char *const table[][2] = { { "d3d", "000000" }, { "gl", "111010" },
		{ "vulkan", "101100" }, { "webgpu", "101000" },
		{ "opencv", "101101" } };
	struct convention c;
	char text[40];

	(void)state;
	for (int i = 0; i < CONVENTIONS; i++) {
		assert_string_equal(convention_names[i], table[i][0]);
		assert_convention(&conventions[i], table[i][1]);
		strcat(strcat(strcpy(text, "{\"convention\":\""), table[i][0]), "\"}");
		c = scene_of(text).convention;
		assert_convention(&c, table[i][1]);
	}
	c = scene_of("{}").convention;
	assert_convention(&c, "000000");
	c = scene_of("{\"convention\":{\"handedness\":\"right\",\"depth\":"
		     "\"minus_one_to_one\",\"vectors\":\"column\","
		     "\"ndc_y\":\"down\",\"origin\":\"bottom-left\",\"view_y\":"
		     "\"down\"}}")
		.convention;
	assert_convention(&c, "111111");
	c = scene_of("{\"convention\":{\"origin\":\"top-left\",\"vectors\":"
		     "\"column\"}}")
		.convention;
	assert_convention(&c, "001000");
	/* the option gives another convention for the answer than the document has */
	const struct document_wants wants = { WANTS,
		.convention = &conventions[CONVENTION_WEBGPU] };
	struct scene s = read_as(&wants, "{\"convention\":\"gl\"}").scene;

	assert_convention(&s.convention, "111010");
	assert_ptr_equal(s.answer, wants.convention);
	s = read_as(&wants, "{\"convention\":\"webgpu\"}").scene;
	assert_null(s.answer);
	s = read_as(&wants, "{}").scene;
	assert_convention(&s.convention, "101000");
	assert_null(s.answer);
}

/* Asserts that the number 2 of the text of a matrix becomes element i, j of world. */
static void assert_world(const struct convention *option, const char *convention,
    const char *matrix, int i, int j)
{
	const struct document_wants wants = { WANTS, .convention = option };
	char text[300] = "{\"world\":";

	strcat(strcat(strcat(text, matrix), convention), "}");
	struct scene s = read_as(&wants, text).scene;

	if (!s.has_world || s.world.matrix[i][j] != 2 || s.world.matrix[j][i] != 0)
		fail_msg("%s: expected 2 as element %d, %d of world", text, i, j);
}

static void test_matrix(void **state)
{
#define NESTED "[[1,0,0,0],[0,1,0,0],[0,2,1,0],[0,0,0,1]]"
#define FLAT "[1,0,0,0,0,1,0,0,0,0,1,0,0,2,0,1]"
#define GL ",\"convention\":\"gl\""
	const struct convention *d3d = &conventions[CONVENTION_D3D];
	const struct convention *gl = &conventions[CONVENTION_GL];

	(void)state;
	assert_world(NULL, "", NESTED, 2, 1);
	assert_world(NULL, GL, NESTED, 1, 2);
	assert_world(NULL, ",\"convention\":{\"vectors\":\"column\"}", NESTED, 1, 2);
	assert_world(gl, "", NESTED, 1, 2);
	assert_world(gl, ",\"convention\":\"d3d\"", NESTED, 2, 1);
	assert_world(d3d, GL, NESTED, 1, 2);
	assert_world(NULL, "", FLAT, 3, 1);
	assert_world(NULL, GL, FLAT, 3, 1);
	assert_world(NULL, GL, "{\"matrix\":" NESTED "}", 1, 2);
	assert_world(NULL, GL, "{\"matrix\":" NESTED ",\"vectors\":\"row\"}", 2, 1);
	assert_world(NULL, "", "{\"vectors\":\"column\",\"matrix\":" NESTED "}", 1, 2);
	assert_world(NULL, "", "{\"vectors\":\"column\",\"matrix\":" FLAT "}", 3, 1);
	assert_true(scene_of("{\"projection\":{\"type\":\"matrix\","
			     "\"matrix\":" NESTED "}}")
			.projection.matrix[2][1] == 2);
}

static void assert_points(const char *typed, const char *lines)
{
	struct document_wants wants = { WANTS, .source.faults = &faults };
	struct json_source source = { .name = "POINTS", .faults = &faults };
	size_t size = strlen(typed), n = strlen(lines);
	struct document d;
	struct span points;
	char text[400];

	faults.n = 0;
	memcpy(text, typed, size);
	assert_true(document_read_points(&source, text, size, 3, &points));
	assert_int_equal(points.end - points.s, n);
	assert_memory_equal(points.s, lines, n);
	strcat(strcat(strcpy(text,
			  "{\"_a\":{\"points\":[[7]]},\"_b\":\"[:\",\"points\" "
			  ": "),
		   typed),
	    " ,\"_points\":[[8]]}");
	assert_true(document_read(&d, "s.json", text, strlen(text), &wants));
	assert_int_equal(d.points_size, n);
	assert_memory_equal(d.points, lines, n);
}

static void test_points(void **state)
{
	(void)state;
	assert_points("[]", "");
	assert_points("[0,0,0]", "[0,0,0]\n");
	assert_points("[ 1 , -2.50e0 ,\n3 ]", "[1,-2.50e0,3]\n");
	assert_points("[[0,0,0]]", "[0,0,0]\n");
	assert_points(" [ [1,2,3] ,\n\t[4,null,6] ] ", "[1,2,3]\n[4,null,6]\n");
	assert_points("[[1,2,3,\"a \\\"b ,]\\\\\",true,\"\\u00e9 :\",1e999]]",
	    "[1,2,3,\"a \\\"b ,]\\\\\",true,\"\\u00e9 :\",1e999]\n");
	/* a number of more digits than cJSON reads */
#define TEN "1234567890"
	assert_points("[[" TEN TEN TEN TEN TEN TEN TEN
		      ",0,1e-3," TEN TEN TEN TEN TEN TEN TEN "]]",
	    "[" TEN TEN TEN TEN TEN TEN TEN ",0,1e-3," TEN TEN TEN TEN TEN TEN TEN
	    "]\n");
	assert_null(read_as(&no_points, "{\"points\":[[0]]}").points);
	assert_null(read_as(&no_points, "{}").points);
}

/* All faults of a document are refused in one call, each once. */
static void test_all_faults(void **state)
{
	static const struct {
		const char *text, *first;
		size_t n;
	} rows[] = {
		{ "{\"camera\":{\"eye\":[0,0],\"at\":[0,0,true],\"up\":1}}",
		    "/camera/eye", 3 },
		{ "{\"camera\":{\"eye\":[0,0,1],\"position\":[0,0,1],\"at\":[0,0,0]}}",
		    "/camera/position", 1 },
		{ "{\"qqq\":1,\"_q\":2,\"viewport\":{\"width\":0,\"height\":-1}}",
		    "/qqq", 3 },
		{ "{\"points\":[[1,2,3],[4,5],[6,\"7\",8]]}", "/points/1", 2 },
		{ "{\"viewport\":{\"width\":1,\"hight\":2}}", "/viewport/hight", 1 },
	};

	(void)state;
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		assert_refused_at(&(struct document_wants){ WANTS }, rows[i].text,
		    rows[i].first, rows[i].n);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_bare),
		cmocka_unit_test(test_numbers),
		cmocka_unit_test(test_convention),
		cmocka_unit_test(test_matrix),
		cmocka_unit_test(test_points),
		cmocka_unit_test(test_all_faults),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
