/* SPDX-License-Identifier: MIT */
/* Reads documents for tests, and asserts numbers and refusals. Includes cmocka. */
#pragma once

#include "../scene/document.h"
#include "refusal.h"

struct refusal {
	const struct document_wants *
	    wants; /* given to document_read; if NULL, document_read_points reads the text */
	const char *text;
	const char *line; /* the expected message after "projcalc: s.json: " */
};

static inline void read_text(const void *argument)
{
	const struct refusal *r = argument;
	struct document d;
	size_t size = strlen(r->text), n;
	char *text = malloc(size);

	memcpy(text, r->text, size);
	if (r->wants == NULL)
		document_read_points("s.json", text, size, 3, NULL, &n);
	else
		document_read(&d, "s.json", text, size, r->wants);
	free(text);
}

static inline void assert_all_refused(const struct refusal *r, size_t n)
{
	for (; n > 0; r++, n--) {
		char line[1024];

		snprintf(line, sizeof line, "s.json: %s", r->line);
		assert_refused(read_text, r, r->text, line);
	}
}

#define WANTS .used = ~0u, .coordinates = 3

static inline struct document read_as(const struct document_wants *wants,
    const char *text)
{
	struct document d;
	size_t size = strlen(text);
	char *copy = malloc(
	    size); /* not ended by a NUL, so that a sanitizer finds reads beyond the end */

	memcpy(copy, text, size);
	document_read(&d, "s.json", copy, size, wants);
	free(copy);
	return d;
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

#define REFUSES(table)                                                   \
	static void test_##table(void **state)                           \
	{                                                                \
		(void)state;                                             \
		assert_all_refused(table, sizeof table / sizeof *table); \
	}
