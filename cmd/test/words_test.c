/* SPDX-License-Identifier: MIT */
#include "../message/words.h"

#include "../../core/test/numbers.h"

static const char *const words[] = { "eye", "at", "up", "orientation", "near_ratio",
	"reverse_z", "persp", "x", "gl", NULL };

static void test_equals(void **state)
{
	static const struct {
		const char *word, *name;
		bool equal;
	} cases[] = {
		{ "near_ratio", "near_ratio", true },
		{ "nearRatio", "near_ratio", true },
		{ "NEAR-RATIO", "near_ratio", true },
		{ "n_e_ar__ratio", "near_ratio", true },
		{ "near_rati", "near_ratio", false },
		{ "near_ratios", "near_ratio", false },
		/* a note, and a name that goes on */
		{ "_eye", "eye", false },
		{ "-eye", "eye", false },
		{ "eye_", "eye", false },
		{ "_eye", "_EYE", true },
		{ "", "", true },
		{ "", "eye", false },
		{ "eye", "", false },
		{ "top-left", "topleft", true },
	};

	(void)state;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
		if (word_equals(cases[i].word, cases[i].name) != cases[i].equal)
			fail_msg("%s and %s", cases[i].word, cases[i].name);
}

static void test_lists(void **state)
{
	static const char *const aliases[] = { "position lookfrom", "target", NULL, "q",
		NULL, NULL, NULL, NULL, "opengl" };

	(void)state;
	assert_true(word_is_one_of("look_from", "position lookfrom"));
	assert_true(word_is_one_of("Position", "position lookfrom"));
	assert_false(word_is_one_of("look", "position lookfrom"));
	assert_false(word_is_one_of("from", "position lookfrom"));
	assert_false(word_is_one_of("position lookfrom", "position lookfrom"));
	assert_false(word_is_one_of("", "position lookfrom"));
	assert_false(word_is_one_of("eye", ""));
	assert_false(word_is_one_of("eye", NULL));
	assert_int_equal(word_index("reverseZ", words, NULL), 5);
	assert_int_equal(word_index("LookFrom", words, aliases), 0);
	assert_int_equal(word_index("q", words, aliases), 3);
	assert_int_equal(word_index("OpenGL", words, aliases), 8);
	assert_int_equal(word_index("q", words, NULL), -1);
	assert_int_equal(word_index("", words, aliases), -1);
}

static void test_nearest(void **state)
{
	static const struct {
		const char *word, *near;
	} cases[] = {
		{ "EYE", "eye" },
		{ "ey", "eye" },
		{ "eyes", "eye" },
		{ "yee", "eye" },
		{ "ta", "at" },
		{ "orentaton", "orientation" },
		{ "reverseZ", "reverse_z" },
		{ "revers_z_", "reverse_z" },
		{ "nearRatio", "near_ratio" },
		{ "perspective", "persp" },
		{ "orient", "orientation" },
		{ "y", NULL }, /* not x */
		{ "", NULL },
		{ "parsap", "persp" }, /* two edits */
		{ "parsx", NULL },     /* two edits, and five letters allow one */
		{ "bat", "at" },
		{ "view", NULL },
		{ "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", NULL },
		{ "perspaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"
		  "a",
		    "persp" },
	};

	(void)state;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
		assert_text(word_nearest(cases[i].word, words, NULL), cases[i].near,
		    cases[i].word);
}

static void test_nearest_by_alias(void **state)
{
	static const char *const names[] = { "near", "far", "left", NULL };
	static const char *const aliases[] = { "znear near_plane", NULL, "l" };

	(void)state;
	assert_text(word_nearest("znaer", names, aliases), "near", "znaer");
	assert_text(word_nearest("near_plan", names, aliases), "near", "near_plan");
	assert_null(word_nearest("znaer", names, NULL));
	/* an alias of a letter or two is near to too much */
	assert_null(word_nearest("lx", names, aliases));
}

static void test_remark(void **state)
{
	static const char *const window[] = { "left", "right", "bottom", "top", NULL };
	static const char *const camera[] = { "matrix", "eye", NULL };
	const struct remark *r = word_remark("r", WORD_MEMBER, NULL);

	(void)state;
	assert_non_null(word_remark("unproject", WORD_COMMAND, NULL));
	assert_non_null(word_remark("Un_Project", WORD_OPTION, NULL));
	assert_null(word_remark("unproject", WORD_MEMBER, NULL));
	assert_null(word_remark("unproject", WORD_VALUE, NULL));
	assert_null(word_remark("_fov", WORD_MEMBER, NULL));
	assert_null(word_remark("", WORD_MEMBER, NULL));
	assert_null(word_remark("eye", WORD_MEMBER, NULL));
	assert_ptr_equal(word_remark("K", WORD_MEMBER, NULL),
	    word_remark("P2", WORD_MEMBER, NULL));
	/* of two the one that says to write what there is */
	assert_ptr_equal(word_remark("r", WORD_MEMBER, camera), r);
	assert_ptr_not_equal(word_remark("r", WORD_MEMBER, window), r);
	assert_true(
	    word_is_one_of("right", word_remark("r", WORD_MEMBER, window)->names));
	/* a value's remark is of use only where its words are known */
	assert_null(word_remark("metal", WORD_VALUE, window));
}

static void test_remedy(void **state)
{
	static const char *const none[] = { NULL }, *const one[] = { "fill", NULL };
	static const char *const petal[] = { "petal", "d3d", NULL };
	static const char *const twelve[] = { "a", "b", "c", "d", "e", "f", "g", "h",
		"i", "j", "k", "l", NULL };
	static const char *const more[] = { "a", "b", "c", "d", "e", "f", "g", "h", "i",
		"j", "k", "l", "m", NULL };
	static const struct {
		const char *word;
		const char *const *words;
		const char *quote, *remedy;
	} cases[] = {
		{ "orient", words, "\"", "did you mean \"orientation\"?" },
		{ "orient", words, "", "did you mean orientation?" },
		{ "view", words, "\"",
		    "there are \"eye\", \"at\", \"up\", \"orientation\", "
		    "\"near_ratio\", \"reverse_z\", \"persp\", \"x\" and \"gl\"" },
		{ "view", one, "\"", "there is \"fill\"" },
		{ "view", none, "\"", "" },
		{ "view", twelve, "",
		    "there are a, b, c, d, e, f, g, h, i, j, k and l" },
		{ "view", more, "", "" },
		/* a remark is before a near name */
		{ "metal", petal, "\"",
		    "it is \"d3d\" if view space is left-handed, else \"webgpu\"" },
	};
	char out[LIST_ROOM];

	(void)state;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
		assert_text(word_remedy_of_value(out, cases[i].word, cases[i].words,
				NULL, cases[i].quote),
		    cases[i].remedy, cases[i].word);
}

static void test_join(void **state)
{
	const char *many[200];
	char out[LIST_ROOM];

	(void)state;
	assert_text(words_join(out, words + 6, " or ", "\""),
	    "\"persp\", \"x\" or \"gl\"", "three");
	assert_text(words_join(out, words + 8, " or ", ""), "gl", "one");
	assert_text(words_join(out, words + 9, " or ", ""), "", "none");
	for (int i = 0; i < 199; i++)
		many[i] = "name";
	many[199] = NULL;
	assert_int_equal(strlen(words_join(out, many, " and ", "\"")), LIST_ROOM - 1);
	/* a list that does not fit is cut in a remedy, too */
	many[12] = NULL;
	many[0] =
	    "a name of many letters, so that twelve of them are too long for a list";
	for (int i = 1; i < 12; i++)
		many[i] = many[0];
	assert_int_equal(strlen(word_remedy(out, NULL, NULL, many, "\"")),
	    LIST_ROOM - 1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_equals),
		cmocka_unit_test(test_lists),
		cmocka_unit_test(test_nearest),
		cmocka_unit_test(test_nearest_by_alias),
		cmocka_unit_test(test_remark),
		cmocka_unit_test(test_remedy),
		cmocka_unit_test(test_join),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
