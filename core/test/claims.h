/* SPDX-License-Identifier: MIT */
/* This header includes what every test of core needs: cmocka, and claims of
 * bounds. */
#ifndef CLAIM_H
#define CLAIM_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "sample.h"
#include "truth.h"

static inline void assert_at_most(const char *what, double worst, double bound)
{
	print_message("%s: %.3g, claimed %.3g\n", what, worst, bound);
	assert_true(worst <= bound);
}

/* Claims of the maps that were compared: every element is the nearest double and
 * float, but for the few that TRUTH_RULE excuses, and within EX_ROUND_BOUND u^2; sums are
 * within their errors, and these below the rule's; zeros are where the truth has
 * zeros. */
static inline void assert_errors(const char *what, const struct worst *w,
    double bound)
{
	const int *n = w->verdicts;

	print_message("%s: %d numbers, %d within the rule\n", what,
	    n[NEAREST] + n[WITHIN_TOLERANCE], n[WITHIN_TOLERANCE]);
	assert_int_equal(n[WRONG], 0);
	assert_true(n[NEAREST] > 0 && n[WITHIN_TOLERANCE] <= n[NEAREST] / 100);
	assert_at_most("dd", w->error, EX_ROUND_BOUND);
	assert_int_equal(w->beyond, 0);
	assert_at_most("errors", w->bound, bound);
	assert_int_equal(w->false_nonzeros, 0);
}

static inline void assert_maps(const char *what, const struct worst *w)
{
	assert_errors(what, w, 0.5);
}

/* Claims that a reason begins with a member or more, up to a colon or semicolon. */
static inline void assert_reason(const char *why, const char *begins)
{
	assert_non_null(why);
	assert_memory_equal(why, begins, strlen(begins));
	assert_non_null(strchr(":;", why[strlen(begins)]));
}

#endif
