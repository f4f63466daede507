/* SPDX-License-Identifier: MIT */
#include "../message/words.h"

#include "../../core/test/numbers.h"

static const char *const words[] = { "eye", "at", "up", "orientation", "near_ratio",
	"reverse_z", "persp", "x", "gl", NULL };

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
		{ "parsx", NULL },     /* two edits, and five letters allow one */
		{ "bat", "at" },
		{ "view", NULL },
		{ "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", NULL },
	};

	(void)state;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
		struct word_guess g = { .word = cases[i].word };

		word_offer_list(&g, words, "%s");
		assert_text(g.closeness > 0 ? g.remedy : NULL, cases[i].near, g.word);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_nearest),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
