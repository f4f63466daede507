/* SPDX-License-Identifier: MIT */
/* Operands that are neither a scene nor points, or the one in place of the other. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "input.h"
#include "mistaken.h"
#include "talk.h"
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

/* PARAMS that are points, where POINTS are a scene, which objects of JSON need not
 * be. What is wrong with PARAMS alone is seen when they are read. */
static void check_traded(const struct command *c, const struct options *o)
{
	char first[GLANCE_MAX], second[GLANCE_MAX], list[200] = "";
	const char *params = glance(o->params, first);
	const char *points = o->n_points > 0 ? glance(o->points[0], second) :
					       NULL;

	if (params == NULL || *params == '{' || points == NULL ||
	    *points != '{' || (o->in == FORMAT_JSON && !is_numbers(params)))
		return;
	bool file = access(o->params, F_OK) == 0;

	if (!file)
		add_numbers(list, 0, sizeof list, params);
	points = first_char(o->points[0]) == '{' ? "'{...}'" : o->points[0];
	if (!command_reads_points(c))
		die(EXIT_USAGE,
		    "'%s' holds points, and %s reads none; write projcalc %s "
		    "%s",
		    o->params, c->name, c->name, points);
	die(EXIT_USAGE,
	    "'%s' holds points, and the scene comes first; write projcalc %s "
	    "%s %s%s%s",
	    o->params, c->name, points, file ? "" : "'[",
	    file ? o->params : list, file ? "" : "]'");
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
}

/* The points that operands are meant for, as JSON: one of each, or one of all where
 * each is a single number. */
static void write_points(char *out, size_t room, char **words)
{
	char list[100];
	bool points = strpbrk(*words, ",; \t") != NULL;
	size_t at = 0;

	for (; *words != NULL && is_numbers(*words) && at + 9 < room; words++) {
		size_t n = add_numbers(list, 0, sizeof list, *words);
		const char *comma = at > 0 ? "," : "";

		if (at + n + 4 > room)
			break;
		at += (size_t)sprintf(out + at, points ? "%s[%s]" : "%s%s",
		    comma, list);
	}
}

void mistaken_points(const struct command *c, const struct options *o, int i)
{
	const char *name = o->points[i];
	const struct place place = { .file = name };
	struct stat st;
	char list[200];

	strcpy(list, c->kind == PLANAR ? "0,0" : "0,0,0");
	if (stat(name, &st) == 0 && S_ISDIR(st.st_mode))
		die_at(EXIT_USAGE, &place, "is a directory");
	if (access(name, R_OK) == 0)
		return;
	const char *why = strerror(errno);
	bool numbers = is_numbers(name);

	if (numbers)
		write_points(list, sizeof list, o->points + i);
	if (numbers || strpbrk(name, "{\"") != NULL)
		die_at(EXIT_USAGE, &place,
		    *list == '[' && strchr(list + 1, '[') == NULL ?
			"%s; POINTS are a file, - or '%s'" :
			"%s; POINTS are a file, - or '[%s]'",
		    why, list);
	die_at(EXIT_USAGE, &place, "%s", why);
}
