/* SPDX-License-Identifier: MIT */
#include "options_read.h"

#include <ctype.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../json/value.h"
#include "../message/escape.h"
#include "../message/message.h"
#include "../message/nearest.h"
#include "synonyms.h"

/* The command's options, or where name is not NULL those that begin with it. */
static int option_names(const struct command *c, const char *name,
    const char *names[OPTIONS_MAX + 1])
{
	int n = 0;

	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (option_is_for(r, c) &&
		    (name == NULL || strncmp(r->name, name, strlen(name)) == 0))
			names[n++] = r->name;
	names[n] = NULL;
	return n;
}

static _Noreturn void refuse_letter(const struct command *c, char letter)
{
	const char *names[OPTIONS_MAX + 1], name[] = { letter, '\0' };
	char shown[ESCAPED_MAX], list[LISTED];

	if (option_names(c, name, names) > 0)
		die(EXIT_USAGE, "%s: unknown option -%c; with two dashes: %s",
		    c->name, letter, list_words(list, names, " and ", ""));
	die(EXIT_USAGE, "%s: unknown option -%s; 'projcalc help %s' lists them",
	    c->name, escaped(shown, &letter, 1), c->name);
}

/* The word is "--name" or "--name=value". */
static _Noreturn void refuse_name(const struct command *c, const char *word)
{
	const char *names[OPTIONS_MAX + 1] = { NULL }, *near;
	const int n = (int)strcspn(word, "=");
	char name[64], list[LISTED];

	snprintf(name, sizeof name, "%.*s", n - 2, word + 2);
	if (*name != '\0' && option_names(c, name, names) > 1)
		die(EXIT_USAGE, "%s: --%s may be %s; write more of it", c->name,
		    name, list_words(list, names, " or ", ""));
	near = names[0];
	if (near == NULL)
		synonym_option(c, word);
	option_names(c, NULL, names);
	if (near == NULL)
		near = nearest(name, names);
	if (near != NULL)
		die(EXIT_USAGE, "%s: unknown option %.*s; did you mean --%s?",
		    c->name, n, word, near);
	die(EXIT_USAGE,
	    "%s: unknown option %.*s; 'projcalc help %s' lists them", c->name,
	    n, word, c->name);
}

/* Refuses an option's name, or a member's, behind a single dash: "-to", which
 * would be -t with the argument o. */
static void check_dash(const struct command *c, const char *word)
{
	if (*word != '-' || word[1] == '-' || strlen(word) < 3)
		return;
	const struct option_row *row = option_named(word + 1);

	if (row != NULL && option_is_for(row, c))
		die(EXIT_USAGE, "%s: unknown option %s; did you mean --%s?",
		    c->name, word, row->name);
	synonym_option(c, word);
}

/* getopt_long returns an option's letter, or LONG + the number of its row if it
 * was given by its name, or OPERAND. */
enum { OPERAND = 1, LONG = 256 };

static void getopt_tables(struct option longs[OPTIONS_MAX + 1],
    char letters[2 * OPTIONS_MAX + 3])
{
	int n = 0;

	*letters++ = '-'; /* an operand is returned as OPERAND */
	*letters++ = ':'; /* a missing argument as ':' */
	for (const struct option_row *r = option_rows; r->name != NULL; r++) {
		bool argument = r->argument != NULL;

		longs[n] = (struct option){ r->name,
			argument ? required_argument : no_argument, NULL,
			LONG + n };
		n++;
		if (r->letter != 0)
			*letters++ = r->letter;
		if (r->letter != 0 && argument)
			*letters++ = ':';
	}
	longs[n] = (struct option){ 0 };
	*letters = '\0';
}

/* The row of what getopt_long returned, or NULL. */
static const struct option_row *row_of(int got)
{
	if (got >= LONG)
		return &option_rows[got - LONG];
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (got != 0 && r->letter == got)
			return r;
	return NULL;
}

/* Refuses what getopt_long could not take in a word: got is ':' for a missing
 * argument. optopt is the option's letter or LONG + its row, or 0 for an unknown
 * name. A letter is called by itself, as it may be one of several: -mx. */
static _Noreturn void refuse_option(const struct command *c, int got,
    const char *word)
{
	const char letter = (char)optopt;

	if (optopt >= LONG)
		die(EXIT_USAGE, "%s: --%s %s argument", c->name,
		    row_of(optopt)->name, got == ':' ? "needs an" : "takes no");
	if (got == ':')
		die(EXIT_USAGE, "%s: -%c needs an argument", c->name, letter);
	if (letter == '\0')
		refuse_name(c, word);
	check_dash(c, word);
	refuse_letter(c, letter);
}

/* Says for which commands an option is. */
static _Noreturn void refuse_here(const struct command *c,
    const struct option_row *r)
{
	/* in the order of the bits of enum command_kind */
	static const char *const names[] = { "the 3D matrix commands",
		"project", "pick", "fit", "inspect", "trace", "the 2D commands",
		"help" };
	const char *takers[sizeof names / sizeof *names + 1] = { NULL };
	char list[LISTED];
	int n = 0;

	if (r->letter == 't')
		die(EXIT_USAGE,
		    "%s: -t is for inspect, which tells the -p that a "
		    "tolerance needs",
		    c->name);
	for (unsigned i = 0; i < sizeof names / sizeof *names; i++)
		if (r->commands >> i & 1)
			takers[n++] = names[i];
	die(EXIT_USAGE, "%s: --%s is not for this command; it is for %s",
	    c->name, r->name, list_words(list, takers, " and ", ""));
}

/* Takes the option in a word, whose argument is optarg. */
static void take_option(const struct command *c, const struct option_row *r,
    const char *word, struct options *o)
{
	if (!option_is_for(r, c)) {
		synonym_member(c, word);
		refuse_here(c, r);
	}
	if (r->words != NULL && r->set == NULL)
		*(unsigned *)((char *)o + r->at) = (unsigned)one_of(r->words,
		    r->what, optarg);
	else if (r->set != NULL)
		r->set(o, optarg);
	if (r->on != 0)
		*(bool *)((char *)o + r->on) = true;
}

/* Trace, inspect and fit print text, or JSON; trace, of points as JSON, that. */
static void choose_output(const struct command *c, struct options *o)
{
	if (!o->has_out)
		o->out = c->kind == TRACE && o->in == FORMAT_JSON ?
		    FORMAT_JSON :
		    FORMAT_TEXT;
	o->has_out = true;
	if (o->out != FORMAT_TEXT && o->out != FORMAT_JSON)
		die(EXIT_USAGE, "%s prints -o text or -o json", c->name);
}

/* The same as getopt_long, but what begins as a number below 0 is an operand. */
static int next_option(int argc, char **argv, const char *letters,
    const struct option *longs)
{
	const char *word = argv[optind];

	if (word != NULL && *word == '-' &&
	    (word[1] == '.' || isdigit((unsigned char)word[1]))) {
		optarg = argv[optind++];
		return OPERAND;
	}
	return getopt_long(argc, argv, letters, longs, NULL);
}

/* Operands are moved to the beginning: options may stand among them, unless
 * POSIXLY_CORRECT is set. */
void options_read(const struct command *c, int argc, char **argv,
    struct options *o)
{
	struct option longs[OPTIONS_MAX + 1];
	char letters[2 * OPTIONS_MAX + 3], **operand = o->points = argv;
	bool mixed = getenv("POSIXLY_CORRECT") == NULL;

	getopt_tables(longs, letters);
	opterr = 0;
	while (operand == argv || mixed) {
		char *word = argv[optind];
		int got = next_option(argc, argv, letters, longs);

		if (got == -1)
			break;
		if (got == '?' || got == ':')
			refuse_option(c, got, word);
		if (got == OPERAND) {
			*operand++ = optarg;
			continue;
		}
		if (got < LONG && optarg != NULL && optarg != argv[optind - 1])
			check_dash(c, word);
		take_option(c, row_of(got), word, o);
		if (o->help || o->version)
			return;
	}
	if ((c->kind & (TRACE | INSPECT | FIT)) != 0)
		choose_output(c, o);
	while (optind < argc)
		*operand++ = argv[optind++];
	o->n_points = (int)(operand - argv) - 1;
	if (o->n_points < 0)
		o->n_points = 0;
	else
		o->params = *o->points++;
	if (o->out_record > 0 &&
	    (o->out_record != o->in_record || o->out != o->in || o->matrix))
		die(EXIT_USAGE,
		    "-o %sx%d: records are read and written alike; say "
		    "-i %sx%d, or -o %s for coordinates alone",
		    format_names[o->out], o->out_record, format_names[o->out],
		    o->out_record, format_names[o->out]);
}
