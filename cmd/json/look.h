/* SPDX-License-Identifier: MIT */
/* Looks at the text of a document: before cJSON reads it, as cJSON takes some of what
 * is no JSON; where cJSON stopped, to say why; and for the places of values, which
 * cJSON does not know. Nothing here is from cJSON. */
#pragma once

#include "value.h"

/* What was seen of a text. */
struct look {
	const char *s, *end; /* the next byte; the end of the text */
	int level;           /* the number of open brackets */
	const char *open[JSON_LEVELS_MAX + 1];
	/* the array `points` of the outermost object; its s is NULL if there is none */
	struct span points;
	const char *closed; /* the end of the outermost brackets, or NULL */
	const char *string; /* the last string, and whether the text ends in it */
	bool in_string;
	const char *what, *remedy; /* what is wrong at s, or NULL */
};

/* Sets the source's text, keeps a copy of it for messages, and looks it over. Refuses
 * control characters, a NUL by its escape, and bytes that are not UTF-8. A byte order
 * mark becomes blanks. */
bool look_at_text(struct json_source *, char *text, size_t size, struct look *);

/* Sets *array to the text of an array, without blanks around it, of which only the
 * brackets and the bytes are looked at; or refuses what is not in brackets. */
bool look_for_array(struct json_source *, char *text, size_t size, struct span *array);

/* Refuses what stands at `at`, which is no JSON; names its line and column. */
bool look_refuse(const struct json_source *, const char *at, const char *what,
    const char *remedy);

/* Refuses the text from `at` on, which is no JSON, and says what JSON has there. */
bool look_refuse_no_json(const struct json_source *, const char *at, const char *end);

/* Refuses a text that ends within brackets or a string. */
bool look_refuse_end(const struct json_source *, const struct look *);

/* Returns the byte that is wrong where cJSON stopped at `at`: blanks may precede it,
 * but of what is no name of a member cJSON passes a byte. */
const char *look_for_wrong(const char *begin, const char *at, const char *end);

/* Returns the first number that cJSON reads though it is none of JSON, as 010 and 1.
 * are, or `end`. Those of points are read elsewhere. */
const char *look_for_wrong_number(const char *s, const char *end, struct span points);

/* Returns the place of the value to which a pointer leads or, if the value is missing,
 * of the object or array that lacks it. */
struct place look_at_pointer(const struct json_source *, const char *pointer);

/* Returns the line and column of a value, by its index and those of the values around
 * it, or 0 without the source's text. */
struct place look_at_value(const struct value *);
