/* Decimal text to double and back. Reading rounds to the nearest double.
 * Writing gives the shortest text that reads back as the same, or rounds the
 * double's exact value to a number of digits. */
#ifndef NUMBER_H
#define NUMBER_H

#ifdef __cplusplus
extern "C" {
#endif

/* Room for the longest text of a number: sign, 309 digits, point, 100 more. */
enum { NUMBER_MAX = 416 };

struct number_style {
	enum {
		NUMBER_SHORTEST,
		NUMBER_DECIMALS,
		NUMBER_DIGITS,
		/* The shortest where that has no more than n decimals, else
		 * rounded to n; without trailing zeros. */
		NUMBER_WITHIN
	} kind;
	/* Decimals, 0..100 or, within, up to 160; or significant digits
	 * 1..100. */
	int n;
};

/* Reads the number that begins at s: [+-] digits [. digits] [e [+-] digits],
 * a digit before or after the point, as awk reads it: no hex; or nan, inf,
 * infinity in any case. Returns where it ends, NULL if none begins at s.
 * What is beyond the range of doubles is read as inf, what is below as 0. */
const char *number_read(const char *s, const char *end, double *v);

/* Write v at s, not terminated, and return where the text ends. Plain from
 * 1e-6 to below 1e21, else with an exponent, as JavaScript prints; with
 * NUMBER_DECIMALS always plain; never -0; nan and inf are "nan". */
char *number_write(char *s, double v, struct number_style style);

/* The same for a float: shortest means the shortest that reads back as the
 * same float. */
char *number_write_float(char *s, float v, struct number_style style);

#ifdef __cplusplus
}
#endif

#endif
