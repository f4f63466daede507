// SPDX-License-Identifier: MIT
/* Reads numbers with fast_float, which consists of headers, so that the program starts
 * without loading a C++ library. */
#include "number.h"

/* NDEBUG removes fast_float's assertions. */
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
	/* fast_float also reads what follows nan in nan(...) */
	return std::isnan(*v) ? s + (*s == '-') + 3 : r.ptr;
}
