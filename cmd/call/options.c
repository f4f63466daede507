/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "../message/message.h"
#include "../message/words.h"
#include "option_row.h"
#include "unknown.h"

/* Returns c's option for `word`: "--", then the name or a unique beginning of it. */
static const struct option_row *find_long_option(const struct command *c,
    const char *word)
{
	const char *name = word + 2, *names[OPTIONS_MAX + 1];
	const struct option_row *found = NULL;
	const size_t n = strlen(name);
	char list[LIST_ROOM];
	int count = 0;

	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (option_is_for(r, c) && strncmp(r->name, name, n) == 0) {
			if (r->name[n] == '\0')
				return r;
			names[count++] = r->name;
			found = r;
		}
	names[count] = NULL;
	if (n == 0 || count == 0 || option_find(name) != NULL)
		unknown_check_option(c, word, name, true);
	if (count > 1)
		die(EXIT_USAGE, text("%s: %s is ambiguous", c->name, word),
		    text("it may be %s", words_join(list, names, " or ", "")));
	return found;
}

static const struct option_row *find_letter_option(const struct command *c, char letter)
{
	const char word[] = { '-', letter, '\0' };
	const struct option_row *r = option_rows;

	while (r->name != NULL && r->letter != letter)
		r++;
	if (r->name == NULL || !option_is_for(r, c))
		unknown_check_option(c, word, r->name != NULL ? r->name : word + 1,
		    true);
	return r;
}

/* If `value` is NULL, an argument is the next word, **next, and *next moves past it. */
static void set_option(struct options *o, const struct option_row *r, char *value,
    char ***next)
{
	if (r->argument == NULL && value != NULL)
		die(EXIT_USAGE,
		    text("%s: --%s takes no argument", o->command->name, r->name),
		    NULL);
	if (r->argument != NULL && value == NULL && **next == NULL)
		die(EXIT_USAGE,
		    text("%s: --%s needs an argument: %s", o->command->name, r->name,
			r->argument),
		    NULL);
	if (r->argument != NULL)
		r->read(o, r, value != NULL ? value : *(*next)++);
	if (r->points_only)
		o->points_only_option = r->name;
	if (r->flag != 0)
		*(bool *)((char *)o + r->flag) = true;
}

/* Sets the options of a word such as "--name=value", or "-md3" for -m -d 3. Refuses the
 * name of an option or member after one dash: "-to" is not -t with the argument o. */
static void set_options_of_word(struct options *o, char *word, char ***next)
{
	const struct command *c = o->command;
	const struct option_row *r;
	char *equals = strchr(word, '=');

	if (equals != NULL)
		*equals = '\0';
	if (word[1] == '-') {
		set_option(o, find_long_option(c, word),
		    equals != NULL ? equals + 1 : NULL, next);
		return;
	}
	if (word[1] != '\0' && word[2] != '\0')
		unknown_check_option(c, word, word + 1, false);
	if (equals != NULL)
		*equals = '=';
	do {
		r = find_letter_option(c, *++word);
		set_option(o, r,
		    r->argument != NULL && word[1] != '\0' ? word + 1 : NULL, next);
	} while (r->argument == NULL && word[1] != '\0');
}

/* Returns whether a word is an operand, not an option. "-" and "-1.5" are operands. */
static bool is_operand(const char *word)
{
	return *word != '-' || word[1] == '\0' || word[1] == '.' ||
	    isdigit((unsigned char)word[1]);
}

/* inspect and fit print text by default, and trace JSON if its points are JSON. */
static void check_output(struct options *o)
{
	o->has_out |= o->command->kind != COMMAND_TRACE;
	if (o->has_out && o->out != FORMAT_TEXT && o->out != FORMAT_JSON)
		die(EXIT_USAGE, text("%s prints text or json", o->command->name),
		    "use -o text or -o json");
}

/* --lines prints runs of images, which are text. */
static void check_lines(struct options *o)
{
	if (o->homogeneous || o->matrix || o->ray || o->plane.n > 0 || o->append ||
	    o->flags || o->visible || o->directions)
		die(EXIT_USAGE,
		    "--lines excludes -H, -m, --ray, --plane, --append, --flags, "
		    "--visible and --directions",
		    NULL);
	if (format_is_binary(o->in))
		die(EXIT_USAGE, "--lines reads no binary points",
		    "blank lines part its runs: use a format of lines");
	if (o->has_out && o->out != FORMAT_TEXT)
		die(EXIT_USAGE, "--lines prints text", "use -o text, or leave it out");
	o->has_out = true;
}

/* Moves the operands to the beginning of `words`. Options may stand between operands,
 * unless the environment has POSIXLY_CORRECT. */
void options_read(struct options *o, char **words)
{
	char **operand = o->points = words;
	bool mixed = getenv("POSIXLY_CORRECT") == NULL, options = true;

	while (*words != NULL) {
		char *word = *words++;

		if (options && strcmp(word, "--") == 0) {
			options = false;
		} else if (options && !is_operand(word)) {
			set_options_of_word(o, word, &words);
		} else {
			*operand++ = word;
			options = options && mixed;
		}
		if (o->help || o->version)
			return;
	}
	if (operand > o->points)
		o->params = *o->points++;
	o->n_points = (int)(operand - o->points);
	if (o->in == FORMAT_SNIFF && o->has_separator)
		o->in = FORMAT_CSV;
	if ((o->command->kind & (COMMAND_TRACE | COMMAND_INSPECT | COMMAND_FIT)) != 0)
		check_output(o);
	if (o->command->kind == COMMAND_DRAW)
		o->has_out = true; /* inputs may have several formats */
	if (o->lines)
		check_lines(o);
	if (o->decimals.n > 0 && o->digits.n > 0)
		die(EXIT_USAGE, "--decimals and --digits exclude each other", NULL);
	if (o->has_separator && o->out != FORMAT_CSV) {
		if (o->in != FORMAT_CSV || o->matrix)
			die(EXIT_USAGE, "--separator is for csv",
			    "use -i csv or -o csv");
		o->points_only_option = "separator";
	}
	if (o->out_record > 0 &&
	    (o->out_record != o->in_record || o->out != o->in || o->matrix))
		die(EXIT_USAGE, "--output: records are for points and as in --input",
		    text("use -o %s for coordinates alone", format_names[o->out]));
}

void options_read_first(char **words)
{
	for (char **w = words; *w != NULL && strcmp(*w, "--") != 0; w++) {
		const struct option_row *r = strncmp(*w, "--", 2) == 0 ?
		    option_find(*w + 2) :
		    NULL;
		char *equals = strchr(*w, '=');
		char *argument = equals != NULL ? equals + 1 : w[1];

		if (r != NULL && argument != NULL && r->global != NULL)
			r->read(NULL, r, argument);
	}
}

int options_coordinates(const struct options *o)
{
	if (o->command->kind == COMMAND_MATRIX_2D || o->ray || o->plane.n > 0)
		return 2;
	if (o->from == SPACE_CLIP || (o->from == SPACE_DEVICE && o->homogeneous))
		return 4;
	return 3;
}

enum format options_out_format(const struct options *o)
{
	return o->has_out ? o->out : o->in;
}

struct number_style options_style(const struct options *o, int k)
{
	const bool decimals = o->decimals.n > 0;
	const struct number_list *list = decimals ? &o->decimals : &o->digits;

	if (list->n == 0)
		return (struct number_style){ NUMBER_SHORTEST, 0 };
	return (struct number_style){ decimals ? NUMBER_DECIMALS : NUMBER_DIGITS,
		(int)list->v[k < list->n ? k : list->n - 1] };
}

struct number_style options_matrix_style(const struct options *o)
{
	const int n = o->decimals.n + o->digits.n;

	if (n > 1)
		die(EXIT_USAGE,
		    text("--decimals or --digits: one number is wanted here, not %d",
			n),
		    NULL);
	return options_style(o, 0);
}
