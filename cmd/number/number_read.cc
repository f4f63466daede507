// SPDX-License-Identifier: MIT
/* The library is headers only: no C++ library is loaded, which would double the
 * 0.6 ms of a start. */
#include "number.h"

/* The library's assertions are for its own tests, and cost time. */
#undef NDEBUG
#define NDEBUG

#include <cmath>

#include <fast_float/fast_float.h>

const char *number_read(const char *s, const char *end, double *v)
{
	bool plus = s != end && *s == '+';

	s += plus;
	if (s == end || (plus && *s == '-'))
		return NULL;
	fast_float::from_chars_result r = fast_float::from_chars(s, end, *v);
	if (r.ec == std::errc::invalid_argument)
		return NULL;
	/* The library would go on to take in the (...) of a nan(...). */
	return std::isnan(*v) ? s + (*s == '-') + 3 : r.ptr;
}
