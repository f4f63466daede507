/* What every test of core needs: cmocka, and claims of bounds. */
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

static inline void claim(const char *what, double worst, double bound)
{
	print_message("%s: %.3g, claimed %.3g\n", what, worst, bound);
	assert_true(worst <= bound);
}

/* Of the maps that were compared: the error claimed in units of u^2, the
 * promise of 1/2 + kappa/2^47 for what is printed, no sum larger than the
 * truth's, and zeros where the truth has zeros. */
static inline void claim_maps(const char *what, const struct worst *w,
    double bound)
{
	claim(what, w->error, bound);
	assert_true(w->printed <= 1);
	assert_true(w->size <= 1 + 0x1p-40);
	assert_int_equal(w->ghosts, 0);
}

/* A refusal, by the member that it begins with. */
static inline void claim_refused(const char *why, const char *member)
{
	assert_non_null(why);
	assert_memory_equal(why, member, strlen(member));
	assert_int_equal(why[strlen(member)], ':');
}

#endif
