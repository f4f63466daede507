/* SPDX-License-Identifier: MIT */
/* Reads documents for tests, and asserts numbers and refusals. Includes cmocka. What
 * the program says of wrong documents is in testdata/transcripts. */
#pragma once

#include "../scene/document.h"
#include "output_of.h"

/* What is refused in the documents that this header reads. */
static struct refusals faults;

#define WANTS .used = ~0u, .coordinates = 3

/* Reads a text, and returns false if it is refused. */
static inline bool read_quietly(struct document *d, const struct document_wants *wants,
    const char *text)
{
	struct document_wants w = *wants;
	size_t size = strlen(text);
	/* not ended by a NUL, so that a sanitizer finds reads beyond the end */
	char *copy = malloc(size);

	w.source.faults = &faults;
	faults.n = 0;
	memcpy(copy, text, size);
	const bool good = document_read(d, "s.json", copy, size, &w);

	free(copy);
	return good;
}

static inline struct document read_as(const struct document_wants *wants,
    const char *text)
{
	struct document d;

	if (!read_quietly(&d, wants, text))
		fail_msg("%s: %s: %s", text, faults.list[0].where, faults.list[0].what);
	return d;
}

/* Asserts that a text is refused, at `where` first. */
static inline void assert_refused_at(const struct document_wants *wants,
    const char *text, const char *where, size_t n)
{
	struct document d;

	if (read_quietly(&d, wants, text) || faults.n != n)
		fail_msg("%s: %zu faults, not %zu", text, faults.n, n);
	assert_text(faults.list[0].where, where, text);
}

static inline struct scene scene_of(const char *text)
{
	return read_as(&(struct document_wants){ WANTS }, text).scene;
}

/* Fails unless the first n numbers of got are the doubles that follow n. */
#define assert_numbers(...) assert_numbers_at(__FILE__, __LINE__, __VA_ARGS__)

static inline void assert_numbers_at(const char *file, int line, const double *got,
    int n, ...)
{
	va_list expected;
	char name[40];

	va_start(expected, n);
	for (int i = 0; i < n; i++) {
		snprintf(name, sizeof name, "number %d of %d", i, n);
		assert_number_at(got[i], va_arg(expected, double), name, file, line);
	}
	va_end(expected);
}
