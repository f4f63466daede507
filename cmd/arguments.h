/* The arguments of options, each to what it means. What is wrong is printed,
 * with the option's name, and ends in exit status 2. */
#ifndef ARGUMENTS_H
#define ARGUMENTS_H

#include "points/line.h"

/* Which of names (their end is NULL) a word is; what says what they name. */
int one_of(const char *const *names, const char *what, const char *word);

int whole_number(const char *option, const char *word, int min, int max);

/* Within the range of sizes, from 1e-150 to 1e150. */
double positive_number(const char *option, const char *word);

/* "X,Y" */
void position(const char *option, const char *word, double xy[2]);

/* Fields by number, from 1, or by name in a csv header, in any mixture: "2,z".
 * Cuts the list up; the names stay in it. */
struct columns columns_of(const char *option, char *list);

#endif
