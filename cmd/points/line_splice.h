/* SPDX-License-Identifier: MIT */
/* Lines in their own dialect: coordinates are replaced where they stand. */
#ifndef LINE_SPLICE_H
#define LINE_SPLICE_H

#include "line.h"

/* What is added follows the last coordinate. If numbers is NULL the line is a header,
 * whose names stay. */
char *line_splice(const struct layout *, const struct line *,
    const struct numbers *, const struct word *flags, char *out);

/* The same of a JSON object, where what is added takes the place of a member of its
 * name, or becomes one. */
char *line_splice_object(const struct layout *, const struct line *,
    const struct numbers *, const struct word *flags, char *out);

#endif
