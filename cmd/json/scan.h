/* Where the parts of JSON text (RFC 8259) begin and end. Where it says so, the
 * text must have passed json_check, as either kind; else it may be any. Bytes
 * at end and behind it are not read. */
#ifndef JSON_SCAN_H
#define JSON_SCAN_H

/* Reads the number that begins at s, as number_read does, and returns where it
 * ends. NULL where none begins, or one that JSON doesn't have: +1, 01, 1., .5,
 * 1e, inf. */
const char *json_number(const char *s, const char *end, double *v);

/* Past the string whose opening quote is at s; end where it isn't closed. */
const char *json_string(const char *s, const char *end);

/* Where the value or member that begins at s ends: at the comma behind it or
 * at the bracket, of either kind, that closes what it is in, else at end. In
 * unchecked text, quotes and brackets alone say what belongs together. */
const char *json_skip(const char *s, const char *end);

/* Goes through an array or object of checked text. at is its opening bracket
 * or what the last call returned. Sets *value to where the next value begins
 * and returns the comma or bracket behind it, or NULL after the last. */
const char *json_next(const char *at, const char *end, const char **value);

/* Past the hexadecimal digits that begin at s, four at most. */
const char *json_hex4(const char *s, const char *end, unsigned *code);

/* What code >> 10 is for the halves of a surrogate pair. */
enum { FIRST_HALF = 0xd800 >> 10, SECOND_HALF = 0xdc00 >> 10 };

/* In a string of checked text: writes what the escape at s stands for as UTF-8
 * of *n bytes, half of a surrogate pair as U+FFFD, and returns past it. */
const char *json_unescape(const char *s, const char *end, char out[4], int *n);

#endif
