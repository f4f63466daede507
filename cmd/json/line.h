/* JSON within a line of points. */
#ifndef JSON_LINE_H
#define JSON_LINE_H

#include "../points/field.h"

/* Of what number_read takes, whether JSON has it too: not +1, 01, 1., .5. */
bool is_json_number(struct span);

/* NULL where the text is one JSON value of at most 100 levels, else where it
 * goes wrong. */
const char *json_wrong(const char *s, const char *end);

#endif
