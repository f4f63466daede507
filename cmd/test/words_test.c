/* SPDX-License-Identifier: MIT */
#include "../message/words.h"

#include "../../core/test/numbers.h"

static const char *const words[] = { "eye", "at", "up", "orientation",
	"near_ratio", "reverse_z", "persp", "x", "gl", NULL };

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
		{ "nearRatio", "near_ratio" },
		{ "perspective", "persp" },
		{ "orient", "orientation" },
		{ "y", NULL }, /* not x */
		{ "", NULL },
		{ "parsap", "persp" }, /* two edits */
		{ "parsx", NULL }, /* two edits, and five letters allow one */
		{ "bat", "at" },
		{ "view", NULL },
		{ "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", NULL },
	};

	(void)state;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
		const char *near = word_nearest(cases[i].word, words);

		assert_text(near, cases[i].near, cases[i].word);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_nearest),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
