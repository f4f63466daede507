/* SPDX-License-Identifier: MIT */
/* Operands that are neither a scene nor points, or the one in place of the other. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "input.h"
#include "mistaken.h"
#include "../message/message.h"
#include "typed.h"

enum { GLANCE_MAX = 4096 };

/* Reads a regular file until there is more than blanks. Returns where that is in out,
 * or NULL. */
static const char *glance_into(const char *name, char out[GLANCE_MAX])
{
	int fd = open_input(name);
	size_t blank = 0;
	ssize_t n;

	do {
		n = read(fd, out, GLANCE_MAX - 1);
		out[n > 0 ? n : 0] = '\0';
		blank = strncmp(out, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
		blank += strspn(out + blank, " \t\r\n");
	} while (n > 0 && blank == (size_t)n);
	close_input(fd);
	return n > 0 ? out + blank : NULL;
}

/* The beginning of a file, or what is typed, without blanks before it; NULL for what
 * can be read but once, or not at all, and what is blank. */
static const char *glance(const char *name, char out[GLANCE_MAX])
{
	char typed = first_char(name);
	struct stat st;

	if (typed == '{' || typed == '[')
		return strchr(name, typed);
	if (is_stdin(name))
		return NULL;
	if (stat(name, &st) != 0)
		return name;
	return S_ISREG(st.st_mode) && access(name, R_OK) == 0 ?
	    glance_into(name, out) :
	    NULL;
}

/* What the numbers of words are meant for, as it is to be written: points, or for pick
 * where it looks. */
static void write_meant(char out[TYPED_MAX + 8], const struct command *c,
    const struct options *o, char **words)
{
	char list[TYPED_MAX];

	if (c->kind == PICK && write_points(list, words, 2) == 2) {
		sprintf(out, "--at %.*s", (int)strlen(list) - 2, list + 1);
		return;
	}
	write_points(list, words, coordinates_of(c, o));
	sprintf(out, "'%s'", list);
}

/* PARAMS that are points, where POINTS are a scene, which objects of JSON need not
 * be. What is wrong with PARAMS alone is seen when they are read. */
static void check_traded(const struct command *c, const struct options *o)
{
	char first[GLANCE_MAX], second[GLANCE_MAX], list[TYPED_MAX + 8];
	const char *params = glance(o->params, first), *scene = NULL;
	bool file = access(o->params, F_OK) == 0;
	int i = 0;

	/* numbers may be several words */
	while (!file && i < o->n_points && is_numbers(o->points[i]))
		i++;
	if (i < o->n_points)
		scene = glance(o->points[i], second);
	if (params == NULL || *params == '{' || scene == NULL ||
	    *scene != '{' || (o->in == FORMAT_JSON && !is_numbers(params)))
		return;
	if (!file)
		write_meant(list, c, o, o->points - 1);
	scene = first_char(o->points[i]) == '{' ? "'{...}'" : o->points[i];
	if (!command_reads_points(c))
		die(EXIT_USAGE,
		    "'%s' holds points, and %s reads none; write projcalc %s "
		    "%s",
		    o->params, c->name, c->name, scene);
	die(EXIT_USAGE,
	    "'%s' holds points, and the scene comes first; write projcalc %s "
	    "%s %s",
	    o->params, c->name, scene, file ? o->params : list);
}

/* An option without its dashes, or with those that editors make of them. */
static void check_option(const struct command *c, const char *word,
    const char *why)
{
	const struct option_row *r;
	const char *name = word;

	/* U+2010 to U+2015 in UTF-8 */
	while (strncmp(name, "\xe2\x80", 2) == 0 && (name[2] & 0xf0) == 0x90)
		name += 3;
	r = option_named(name);
	if (r != NULL && option_is_for(r, c))
		die_at(EXIT_USAGE, &(struct place){ .file = word },
		    "%s; the option is --%s", why, name);
}

/* JSON that the shell has taken apart: {"eye": [0,0,5]} without quotes. */
static bool is_torn(const struct options *o)
{
	if (strchr(o->params, '}') != NULL)
		return false;
	for (int i = 0; i < o->n_points; i++)
		if (strchr(o->points[i], '}') != NULL)
			return true;
	return false;
}

void mistaken_params(const struct command *c, const struct options *o)
{
	const char *name = o->params;
	bool typed = first_char(name) == '{';

	if (is_stdin(name) || (typed && !is_torn(o)))
		return;
	if (!typed && access(name, F_OK) == 0) {
		check_traded(c, o);
		return;
	}
	if (is_numbers(name) && o->n_points > 0)
		check_traded(c, o);
	if (typed || is_numbers(name) || strpbrk(name, "\":{=") != NULL ||
	    strcmp(name, "help") == 0)
		die(EXIT_USAGE,
		    "'%s' is no scene; PARAMS is a JSON file, - or JSON in "
		    "quotes: projcalc %s %s",
		    name, c->name, c->example != NULL ? c->example : "'{...}'");
	check_option(c, name, strerror(ENOENT));
}

void mistaken_points(const struct command *c, const struct options *o, int i)
{
	const char *name = o->points[i];
	const struct place place = { .file = name };
	char **words = o->points + i, list[TYPED_MAX + 8], decimals[TYPED_MAX];
	struct stat st;

	if (stat(name, &st) == 0 && S_ISDIR(st.st_mode))
		die_at(EXIT_USAGE, &place, "is a directory");
	if (access(name, R_OK) == 0)
		return;
	const char *why = strerror(errno);

	check_option(c, name, why);
	if (!is_numbers(name) && strpbrk(name, "{\"") == NULL)
		die_at(EXIT_USAGE, &place, "%s", why);
	/* the shell takes [0, 0, 0] apart */
	while (words > o->points && is_numbers(*words) && is_numbers(words[-1]))
		words--;
	write_meant(list, c, o, words);
	if (*list == '-')
		die_at(EXIT_USAGE, &place, "%s; where to look is %s", why,
		    list);
	if (write_decimals(decimals, words, coordinates_of(c, o)))
		die_at(EXIT_USAGE, &place,
		    "%s; POINTS are a file, - or %s; with decimal points for "
		    "the commas: '%s'",
		    why, c->kind == PLANAR ? list : "'[0,0,0]'", decimals);
	die_at(EXIT_USAGE, &place, "%s; POINTS are a file, - or %s", why, list);
}

void mistaken_position(const struct command *c, const struct options *o)
{
	char *words[] = { o->n_points > 0 ? o->points[0] : NULL, NULL };
	char list[TYPED_MAX];

	if (o->n_points == 0 || first_char(*words) != '[' ||
	    write_points(list, words, 2) != 2)
		return;
	if (c->kind == PICK)
		die(EXIT_USAGE, "'%s' is no point; where to look is --at %.*s",
		    *words, (int)strlen(list) - 2, list + 1);
	if (c->kind == PROJECT && o->from == SPACE_DEVICE && !o->ray &&
	    !o->homogeneous && (!o->has_to || o->to == SPACE_WORLD))
		die(EXIT_USAGE,
		    "'%s' has no depth; --ray takes it to the ray behind it",
		    *words);
}
