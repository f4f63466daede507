/* SPDX-License-Identifier: MIT */
/* The arguments of options, from words to what they mean. A word that is wrong
 * is refused with the option's name and exit status 2. */
#ifndef ARGUMENTS_H
#define ARGUMENTS_H

#include "../lines/line.h"

/* The index of word in names, which NULL ends. what says, for the message, what
 * they are names of: "format", ... */
int one_of(const char *const *names, const char *what, const char *word);

/* From min to max. */
int whole_number(const char *option, const char *word, int min, int max);

/* From 1e-150 to 1e150, the range of sizes. */
double positive_number(const char *option, const char *word);

/* From --decimals or --digits: one for each coordinate printed, the last for the
 * rest. */
struct styles {
	int n; /* 0: none, all are the shortest */
	struct number_style style[COORDINATES_MAX];
};

/* "N,N", each from min to max. Cuts the list at its commas. */
struct styles styles_of(const char *option, enum number_kind, char *list,
    int min, int max);

/* So many numbers up to 1e150 in magnitude, between commas. what and example say what
 * is wanted: "X,Y", "320,240". */
void numbers_of(const char *option, const char *what, const char *example,
    const char *word, int n, double v[]);

/* "D,D,...", as many as there is room for, up to 1e150 in magnitude. Returns how
 * many. */
enum { DISTANCES_MAX = 32 };

int distances_of(const char *option, const char *word,
    double distance[DISTANCES_MAX]);

/* A character that can separate fields; or the word tab. */
char separator_of(const char *option, const char *word);

/* Fields by their number, from 1, or by their name: "2,z". Cuts
 * the list at its commas; the names in the result stand in it. */
struct columns columns_of(const char *option, char *list);

#endif
