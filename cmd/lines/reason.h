/* SPDX-License-Identifier: MIT */
/* Writes why a line is refused, and how to mend it. The message names the place. */
#pragma once

#include "../../core/refusal/refusal.h"
#include "lookup.h"

/* Sets a refusal from a reason, whose remedy is behind the first "; " out of quotes. */
void reason_refuse(struct refusal *, const char *reason);

/* Writes why the field can't be read as coordinate i, and how to mend it. */
void reason_field(const struct layout *, int i, const struct field *,
    char reason[REASON_MAX]);

/* Returns whether v, coordinate i, is in range or nan; if not, writes the reason. */
bool reason_in_range(const struct layout *, int i, double v, char reason[REASON_MAX]);

/* Writes that coordinate i was not found, or was found twice. */
void reason_missing(const struct lookup *, int i, char reason[REASON_MAX]);

/* Sets comment_names, comment_numbers and comment_reason if `text`, a comment, names
 * columns. comment_names becomes 0 if the coordinates are the first columns. */
void reason_comment_columns(struct layout *, struct span text);

/* If a bad line has a NUL, or control bytes that text has not among its first 4,096,
 * writes which formats of numbers its file may have. */
void reason_binary(const struct layout *, struct span line, bool has_nul,
    char reason[REASON_MAX]);

/* Returns whether the first row lacks a header: --columns gives names and it is a
 * LINE_LOST (`lost`), which has a reason; or, without --columns and --no-header, an
 * earlier file's header reordered columns, or comment_names fit it. Then writes why;
 * but if the comment names no coordinates, only sets seen.note. */
bool reason_needs_header(struct layout *, struct span row, bool lost,
    char reason[REASON_MAX]);

/* Writes that a first line in FORMAT_TEXT looks like a header, unless it has a = or its
 * first field is a number or NA, or the reason tells already how to mend this field. */
void reason_text_header(const struct layout *, struct span line,
    char reason[REASON_MAX]);
