/* SPDX-License-Identifier: MIT */
#ifndef SPAN_H
#define SPAN_H

/* The characters from s to before end. */
struct span {
	const char *s, *end;
};

#endif
