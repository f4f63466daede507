/* SPDX-License-Identifier: MIT */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../json/value.h"
#include "../message/utf8.h"
#include "../message/message.h"
#include "options.h"

/* Refuses an unknown option: "--name", "--name=value" or "-name". */
static _Noreturn void refuse_option(const struct command *c, const char *word)
{
	const char *names[OPTIONS_MAX + 1], *near;
	const int n = (int)strcspn(word, "=");
	char name[64];
	int count = 0;

	synonym_check_option(c, word, false);
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (option_is_for(r, c))
			names[count++] = r->name;
	names[count] = NULL;
	snprintf(name, sizeof name, "%.*s", n - 2, word + 2);
	near = nearest_word(name, names);
	if (near != NULL)
		die(EXIT_USAGE, "%s: unknown option %.*s; did you mean --%s?",
		    c->name, n, word, near);
	die(EXIT_USAGE,
	    "%s: unknown option %.*s; 'projcalc help %s' lists them", c->name,
	    n, word, c->name);
}

/* Returns the option that a word names, or the only option of the command whose name
 * begins with the word. */
static const struct option_row *long_option(const struct command *c,
    const char *word)
{
	const char *name = word + 2, *names[OPTIONS_MAX + 1];
	const size_t n = strcspn(name, "=");
	const struct option_row *found = NULL;
	char list[LISTED];
	int count = 0;

	for (const struct option_row *r = option_rows; r->name != NULL; r++) {
		if (n == 0 || strncmp(r->name, name, n) != 0)
			continue;
		if (r->name[n] == '\0')
			return r;
		if (option_is_for(r, c))
			names[count++] = (found = r)->name;
	}
	names[count] = NULL;
	if (count == 0)
		refuse_option(c, word);
	if (count > 1)
		die(EXIT_USAGE, "%s: --%.*s is ambiguous; it may be %s",
		    c->name, (int)n, name, list_words(list, names, " or ", ""));
	return found;
}

/* Returns the option of a letter. Refuses the name of an option or member behind a single
 * dash: "-to" would be -t with the argument o. */
static const struct option_row *letter_option(const struct command *c,
    const char *word, const char *letter)
{
	const struct option_row *r = option_named(word + 1);
	char shown[ESCAPED_MAX];

	if (word[2] != '\0' && r != NULL && option_is_for(r, c))
		die(EXIT_USAGE, "%s: unknown option %s; did you mean --%s?",
		    c->name, word, r->name);
	if (word[2] != '\0')
		synonym_check_option(c, word, false);
	for (r = option_rows; r->name != NULL; r++)
		if (r->letter == *letter)
			return r;
	die(EXIT_USAGE, "%s: unknown option -%s; 'projcalc help %s' lists them",
	    c->name, escaped(shown, letter, 1), c->name);
}

/* Sets the option of a word. The argument is value or, if that is NULL, the next word, at
 * *next. */
static void set_option(const struct command *c, const struct option_row *r,
    const char *word, char *value, char ***next, struct options *o)
{
	char list[LISTED];

	if (!option_is_for(r, c)) {
		synonym_check_option(c, word, true);
		die(EXIT_USAGE,
		    "%s: --%s is not an option of this command; it is an "
		    "option of %s",
		    c->name, r->name, option_takers(r, list));
	}
	if (r->argument == NULL && value != NULL)
		die(EXIT_USAGE, "%s: --%s takes no argument", c->name, r->name);
	if (r->argument != NULL && value == NULL && **next == NULL)
		die(EXIT_USAGE, "%s: --%s needs an argument: %s", c->name,
		    r->name, r->argument);
	if (r->argument != NULL)
		r->read(o, r, value != NULL ? value : *(*next)++);
	if (r->on != 0)
		*(bool *)((char *)o + r->on) = true;
	options_apply(o);
}

/* Sets the options of a word: "--name=value" or "-mdvalue". */
static void set_options(const struct command *c, char *word, char ***next,
    struct options *o)
{
	const struct option_row *r;
	char *equals = strchr(word, '=');

	if (word[1] == '-') {
		set_option(c, long_option(c, word), word,
		    equals != NULL ? equals + 1 : NULL, next, o);
		return;
	}
	for (char *s = word + 1; *s != '\0'; s++) {
		r = letter_option(c, word, s);
		if (r->argument != NULL && s[1] != '\0') {
			set_option(c, r, word, s + 1, next, o);
			return;
		}
		set_option(c, r, word, NULL, next, o);
	}
}

/* Returns whether a word is an operand. "-" is one, and a word that begins with a negative
 * number. */
static bool is_operand(const char *word)
{
	return *word != '-' || word[1] == '\0' || word[1] == '.' ||
	    isdigit((unsigned char)word[1]);
}

/* Sets the format of trace, inspect and fit: text or JSON. The default is text, but JSON
 * for trace of points in JSON. */
static void choose_output(const struct command *c, struct options *o)
{
	if (!o->has_out)
		o->out = c->kind == TRACE && o->in == FORMAT_JSON ?
		    FORMAT_JSON :
		    FORMAT_TEXT;
	o->has_out = true;
	if (o->out != FORMAT_TEXT && o->out != FORMAT_JSON)
		die(EXIT_USAGE,
		    "%s prints text or json; use -o text or -o json", c->name);
}

/* Operands are moved to the beginning, as options may follow operands unless POSIXLY_CORRECT
 * is set. */
void options_read(const struct command *c, char **words, struct options *o)
{
	char **operand = o->points = words;
	bool mixed = getenv("POSIXLY_CORRECT") == NULL, options = true;

	while (*words != NULL) {
		char *word = *words++;

		if (options && strcmp(word, "--") == 0) {
			options = false;
		} else if (options && !is_operand(word)) {
			set_options(c, word, &words, o);
		} else {
			*operand++ = word;
			options = options && mixed;
		}
		if (o->help || o->version)
			return;
	}
	if ((c->kind & (TRACE | INSPECT | FIT)) != 0)
		choose_output(c, o);
	o->n_points = (int)(operand - o->points) - 1;
	if (o->n_points < 0)
		o->n_points = 0;
	else
		o->params = *o->points++;
	if (o->out_record > 0 &&
	    (o->out_record != o->in_record || o->out != o->in || o->matrix))
		die(EXIT_USAGE,
		    "--output: records are only for points, in the format "
		    "of the input; use -o %s for coordinates alone",
		    format_names[o->out]);
}
