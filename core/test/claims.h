/* SPDX-License-Identifier: MIT */
/* Assertions about errors, maps and refusals. Includes cmocka for the tests of core. */
#pragma once

#include "numbers.h"
#include "sample.h"
#include "truth.h"

/* A test that fails within SAMPLES names the sample. */
static inline int tell_sample(void **state)
{
	(void)state;
	if (*sample_name() != '\0')
		print_error("%s; SEED=N repeats it first\n", sample_name());
	return 0;
}

#undef cmocka_unit_test
#define cmocka_unit_test(f) cmocka_unit_test_teardown(f, tell_sample)

static inline void assert_at_most(const char *what, double worst, double bound)
{
	print_message("%s: %.3g, at most %.3g\n", what, worst, bound);
	if (!(worst <= bound))
		fail_msg("%s: came %.17g, expected at most %.17g", what, worst, bound);
}

static inline void assert_largest(const char *what, const struct largest *l,
    double bound)
{
	if (!(l->value <= bound))
		print_error("%s\n", l->where);
	assert_at_most(what, l->value, bound);
}

/* Asserts what truth_compare found in many maps. Every element is the nearest double
 * and the nearest float, but for at most 1 % that TRUTH_TOLERANCE excuses. The pair of
 * doubles of an element is within EX_ROUND_BOUND 2^-106 of the sum. Every sum is within
 * its own bound of the error. The largest such bound, in units of TRUTH_TOLERANCE times
 * the size of the element, is at most bound. An element is 0 where the truth is 0. */
static inline void assert_errors(const char *what, const struct worst *w, double bound)
{
	const int *n = w->verdicts;

	print_message("%s: %d numbers, %d within the tolerance\n", what,
	    n[NEAREST] + n[WITHIN_TOLERANCE], n[WITHIN_TOLERANCE]);
	if (n[WRONG] > 0 || w->beyond_error > 0 || w->false_nonzeros > 0)
		fail_msg("%s: expected nearest elements, came %d wrong, %d "
			 "beyond their error, %d not 0 where the truth is 0; "
			 "first: %s",
		    what, n[WRONG], w->beyond_error, w->false_nonzeros, w->fault.where);
	assert_true(n[NEAREST] > 0 && n[WITHIN_TOLERANCE] <= n[NEAREST] / 100);
	assert_largest("errors of pairs of doubles", &w->pair_error, EX_ROUND_BOUND);
	assert_largest("bounds of errors", &w->sum_bound, bound);
}

/* Each sum and product at most doubles a bound, as an error is a power of two. The
 * longest maps, from device to model, come to 0.6; 1 is what
 * TRUTH_TOLERANCE excuses. */
static inline void assert_maps(const char *what, const struct worst *w)
{
	assert_errors(what, w, 1);
}

/* Asserts that a call has returned false, as it has refused one thing: the member
 * `where`, for the reason `what`, with a remedy. NULL stands for any what or remedy.
 * Empties the list for the next call. */
static inline void assert_refusal(bool done, struct refusals *faults, const char *where,
    const char *what, const char *remedy)
{
	const struct refusal *r = &faults->list[0];

	if (done || faults->n != 1)
		fail_msg("expected a refusal of %s, came %zu", where, faults->n);
	if (strcmp(r->where, where) != 0 || *r->what == '\0' ||
	    (what != NULL && strcmp(r->what, what) != 0) ||
	    (remedy != NULL && strcmp(r->remedy, remedy) != 0))
		fail_msg("expected a refusal of %s: %s, came: %s: %s; %s", where,
		    what != NULL ? what : "...", r->where, r->what, r->remedy);
	faults->n = 0;
}
