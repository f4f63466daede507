/* SPDX-License-Identifier: MIT */
#include "arguments.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../../core/scene/scene.h"
#include "../json/value.h"
#include "../message/message.h"

int one_of(const char *const *names, const char *what, const char *word)
{
	char all[LISTED];

	for (int i = 0; names[i] != NULL; i++)
		if (strcmp(names[i], word) == 0)
			return i;
	die(EXIT_USAGE, "unknown %s '%s'; it is one of %s", what, word,
	    list_words(all, names, " or ", ""));
}

int whole_number(const char *option, const char *word, int min, int max)
{
	char *end;
	long n = strtol(word, &end, 10);

	if (end == word || *end != '\0' || n < min || n > max)
		die(EXIT_USAGE,
		    "--%s: '%s' is not a whole number from %d to "
		    "%d",
		    option, word, min, max);
	return (int)n;
}

double positive_number(const char *option, const char *word)
{
	const char *end = word + strlen(word);
	double v;

	if (number_read(word, end, &v) != end || !(v > 0))
		die(EXIT_USAGE, "--%s: '%s' is not a positive number", option,
		    word);
	if (!(v >= SIZE_MIN && v <= MAGNITUDE_MAX))
		die(EXIT_USAGE,
		    "--%s: %s is out of range; a number from 1e-150 to 1e150 "
		    "is wanted",
		    option, word);
	return v;
}

/* Cuts the first word off *list, which becomes NULL behind the last. */
static char *cut_word(char **list)
{
	char *word = *list;

	*list = strchr(word, ',');
	if (*list != NULL)
		*(*list)++ = '\0';
	return word;
}

struct styles styles_of(const char *option, enum number_kind kind, char *list,
    int min, int max)
{
	struct styles s = { 0 };

	while (list != NULL) {
		const char *word = cut_word(&list);

		if (s.n == COORDINATES_MAX)
			die(EXIT_USAGE, "--%s: more than six numbers", option);
		s.style[s.n].kind = kind;
		s.style[s.n++].n = whole_number(option, word, min, max);
	}
	for (int k = s.n; k < COORDINATES_MAX; k++)
		s.style[k] = s.style[s.n - 1];
	return s;
}

void numbers_of(const char *option, const char *what, const char *example,
    const char *word, int n, double v[])
{
	const char *at = word, *end = word + strlen(word);
	bool good = true, within = true;

	for (int k = 0; k < n && good; k++) {
		at = number_read(at, end, &v[k]);
		good = at != NULL &&
		    (k < n - 1 ? at < end && *at++ == ',' : at == end);
		within &= good && fabs(v[k]) <= MAGNITUDE_MAX;
	}
	if (!good)
		die(EXIT_USAGE,
		    "--%s: '%s' is not %s; write %d numbers with commas "
		    "between them: --%s %s",
		    option, word, what, n, option, example);
	if (!within)
		die(EXIT_USAGE,
		    "--%s: %s is out of range; numbers go up to 1e150", option,
		    word);
}

int distances_of(const char *option, const char *word,
    double distance[DISTANCES_MAX])
{
	const char *at = word, *end = word + strlen(word);

	for (int n = 0; n < DISTANCES_MAX; n++) {
		at = number_read(at, end, &distance[n]);
		if (at == NULL || !(fabs(distance[n]) <= MAGNITUDE_MAX))
			break;
		if (at == end)
			return n + 1;
		if (*at++ != ',')
			break;
	}
	die(EXIT_USAGE,
	    "--%s: '%s' is not a list of up to %d numbers to 1e150; write --%s "
	    "10,1000",
	    option, word, DISTANCES_MAX, option);
}

char separator_of(const char *option, const char *word)
{
	if (strcmp(word, "tab") == 0 || strcmp(word, "\\t") == 0)
		return '\t';
	if (strlen(word) != 1 || (unsigned char)*word >= 0x7f ||
	    strchr("\"'+-.#_\r\n\v\f", *word) != NULL || isalnum(*word))
		die(EXIT_USAGE,
		    "--%s: '%s' can't separate fields; it is one character "
		    "such "
		    "as ; or |, or tab",
		    option, word);
	return *word;
}

static void refuse_twice(const char *option, const struct columns *c)
{
	const int last = c->n - 1;
	const char *name = c->name[last];

	for (int i = 0; i < last; i++)
		if (name != NULL && c->name[i] != NULL &&
		    strcmp(c->name[i], name) == 0)
			die(EXIT_USAGE, "--%s: '%s' stands twice", option,
			    name);
		else if (name == NULL && c->name[i] == NULL &&
		    c->field[i] == c->field[last])
			die(EXIT_USAGE, "--%s: field %d stands twice", option,
			    c->field[i] + 1);
}

struct columns columns_of(const char *option, char *list)
{
	const int fields_max = 1000000;
	struct columns c = { 0 };

	while (list != NULL) {
		char *word = cut_word(&list);

		if (c.n == 4)
			die(EXIT_USAGE, "--%s: more than four fields", option);
		if (*word == '\0')
			die(EXIT_USAGE, "--%s: an empty field; write 2,3,4",
			    option);
		if (strspn(word, "0123456789") == strlen(word))
			c.field[c.n] = whole_number(option, word, 1,
					   fields_max) -
			    1;
		else
			c.name[c.n] = word;
		c.n++;
		refuse_twice(option, &c);
	}
	return c;
}
