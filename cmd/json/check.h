/* SPDX-License-Identifier: MIT */
/* Whether a text is JSON (RFC 8259), and if not, where and why. */
#ifndef JSON_CHECK_H
#define JSON_CHECK_H

#include <stdbool.h>

#include "../message/span.h"

/* Two kinds of text are checked. A document is UTF-8, and its strings hold
 * neither \u0000 nor half of a surrogate pair. A line of points has no newline. As
 * its strings are copied and not read, they may hold any bytes but control
 * characters, and any \u. */
enum json_kind { JSON_DOCUMENT, JSON_LINE };

struct json_error {
	const char *at; /* where the text goes wrong */
	long line;      /* on which line that is */
	char reason[256];
};

/* Whether the text is one JSON value of at most 100 levels; if not, says why.
 * Lines are counted from 1. Bytes at end and after it are not read. */
bool json_check(enum json_kind, const char *text, const char *end,
    struct json_error *);

/* The same of a document, which begins on that line. Says, too, where the value
 * stands that the member of that name has, the first one if there are several, and
 * NULL if there is none; or where name is NULL, the document's own. */
bool json_check_part(const char *text, const char *end, long line,
    const char *name, struct span *, struct json_error *);

#endif
