/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "../message/escape.h"
#include "../json/value.h"
#include "mistaken.h"
#include "../message/nearest.h"
#include "../scene/convention_member.h"
#include "../message/message.h"

const char *const precision_names[] = { "exact", "double", "single", NULL };

/* In the order of enum space. */
const char *const space_names[] = { "model", "world", "view", "clip", "ndc",
	"device", NULL };

static void set_convention(struct options *o, char *word)
{
	o->convention =
	    &conventions[one_of(convention_names, "convention", word)];
}

static void set_input(struct options *o, char *word)
{
	if (strpbrk(word, "./") != NULL)
		die(EXIT_USAGE,
		    "unknown format '%s'; a file of points stands after the "
		    "scene, without an option",
		    word);
	o->in = (enum format)one_of(format_names, "format", word);
}

static void set_output(struct options *o, char *word)
{
	if (strpbrk(word, "./") != NULL)
		die(EXIT_USAGE, "unknown format '%s'; to write a file use > %s",
		    word, word);
	o->out = (enum format)one_of(format_names, "format", word);
	o->has_out = true;
}

static void set_separator(struct options *o, char *word)
{
	o->separator = separator_of("separator", word);
}

static void set_columns(struct options *o, char *word)
{
	o->columns = columns_of("columns", word);
}

static void set_styles(struct options *o, enum number_kind kind,
    const char *option, char *word, int min)
{
	if (o->styles.n > 0 && o->styles.style[0].kind != kind)
		die(EXIT_USAGE,
		    "--decimals and --digits exclude each other; give one "
		    "number for each coordinate to either");
	o->styles = styles_of(option, kind, word, min, 100);
}

static void set_decimals(struct options *o, char *word)
{
	set_styles(o, NUMBER_DECIMALS, "decimals", word, 0);
}

static void set_digits(struct options *o, char *word)
{
	set_styles(o, NUMBER_DIGITS, "digits", word, 1);
}

static void set_precision(struct options *o, char *word)
{
	o->precision = (enum precision)one_of(precision_names, "precision",
	    word);
}

static void set_tolerance(struct options *o, char *word)
{
	o->tolerance = positive_number("tolerance", word);
}

static void set_from(struct options *o, char *word)
{
	o->from = (enum space)one_of(space_names, "space", word);
	o->has_from = true;
}

static void set_to(struct options *o, char *word)
{
	o->to = (enum space)one_of(space_names, "space", word);
	o->has_to = true;
}

static void set_at(struct options *o, char *word)
{
	position("at", word, o->at);
	o->has_at = true;
}

static void set_radius(struct options *o, char *word)
{
	o->radius = positive_number("radius", word);
}

static void set_jobs(struct options *o, char *word)
{
	o->jobs = whole_number("jobs", word, 1, 256);
}

/* How messages are said, and coloured. */
static const char *const message_forms[] = { "text", "json", NULL };
static const char *const color_names[] = { "auto", "always", "never", NULL };

static void set_errors(struct options *o, char *word)
{
	(void)o;
	say_in_json(one_of(message_forms, "--errors", word) == 1);
}

static void choose_color(struct options *o, char *word)
{
	(void)o;
	set_color((enum color)one_of(color_names, "--color", word));
}

/* Kinds of commands that share options, as unions of enum command_kind. */
enum {
	PLANES = PROJECT | TRACE | PLANAR, /* ask what points are outside of */
	IMAGES = MATRIX | PLANES,          /* print points' images */
	PRINTED = IMAGES | PICK,           /* print points */
	POINTS = PRINTED | FIT,            /* read them */
	NUMBERS = PRINTED | INSPECT,       /* print numbers to be rounded */
	ALL = POINTS | INSPECT,
	EVERY = ALL | HELP,
};

#define ON(member) .on = offsetof(struct options, member)

/* clang-format off */
const struct option_row option_rows[] = {
	{ "convention", 'c', ALL, "of the answer: d3d, gl, vulkan, webgpu or opencv",
	    .argument = "NAME", .set = set_convention,
	    .words = convention_names },
	{ "input", 'i', POINTS,
	    "of points: text (default), csv, tsv, json, f64, f32",
	    .argument = "FORMAT", .set = set_input, .words = format_names },
	{ "output", 'o', PRINTED, "the same; default the input's",
	    .argument = "FORMAT", .set = set_output, .words = format_names },
	{ "separator", 0, POINTS, "between fields of csv: a character, or tab",
	    .argument = "C", .set = set_separator },
	{ "header", 0, POINTS, "the first line of csv is a header", ON(header) },
	{ "no-header", 0, POINTS, "it is not", ON(no_header) },
	{ "columns", 0, POINTS,
	    "the coordinates: fields 2,3,4, or names in csv and JSON",
	    .argument = "LIST", .set = set_columns },
	{ "decimals", 'd', NUMBERS, "round to N decimals, a list for x,y,z",
	    .argument = "N,...", .set = set_decimals },
	{ "digits", 0, NUMBERS, "round to N significant digits, the same",
	    .argument = "N,...", .set = set_digits },
	{ "precision", 'p', IMAGES,
	    "exact (default), double or single",
	    .argument = "NAME", .set = set_precision,
	    .words = precision_names },
	{ "tolerance", 't', INSPECT,
	    "the error that the -p told may have; default 0.5",
	    .argument = "T", .set = set_tolerance },
	{ "from", 0, PROJECT | TRACE, "model, world, view, clip, ndc or device",
	    .argument = "SPACE", .set = set_from, .words = space_names },
	{ "to", 0, PROJECT, "the same; default device, else ndc",
	    .argument = "SPACE", .set = set_to, .words = space_names },
	{ "homogeneous", 'H', PROJECT, "x y z w, not divided",
	    ON(homogeneous) },
	{ "matrix", 'm', MATRIX | PROJECT | PLANAR,
	    "print the matrix, read no points", ON(matrix) },
	{ "at", 0, PICK, "the device position",
	    .argument = "X,Y", .set = set_at },
	{ "radius", 0, PICK, "how far around it, in device units",
	    .argument = "R", .set = set_radius },
	{ "ray", 0, PROJECT,
	    "x y on the device: point on the near plane, direction",
	    ON(ray) },
	{ "flags", 0, PLANES,
	    "add in, or the planes that the point is outside of",
	    ON(flags) },
	{ "visible", 0, PLANES,
	    "print only points in the view volume or window", ON(visible) },
	{ "keep-going", 0, POINTS, "print nan for a bad line and go on",
	    ON(keep_going) },
	{ "jobs", 'j', POINTS, "threads; default all cores",
	    .argument = "N", .set = set_jobs },
	{ "progress", 0, POINTS, "tell how far it is, also in a file or pipe",
	    ON(progress) },
	{ "scenes", 0, ALL, "PARAMS is any number of scenes in a row",
	    ON(scenes) },
	{ "json", 0, HELP, "all that the program says of itself, for programs",
	    ON(json) },
	{ "errors", 0, EVERY, "messages as text (default), or json, one a line",
	    .argument = "FORM", .set = set_errors, .words = message_forms },
	{ "color", 0, EVERY, "messages and help: auto (default), always, never",
	    .argument = "WHEN", .set = choose_color, .words = color_names },
	{ "help", 'h', EVERY, "this help", ON(help) },
	{ "version", 0, EVERY, "the version", ON(version) },
	{ .name = NULL },
};
/* clang-format on */

enum { ROWS = sizeof option_rows / sizeof *option_rows - 1 };

const struct option_row *option_named(const char *name)
{
	const size_t n = strcspn(name, "=");

	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (strlen(r->name) == n && strncmp(r->name, name, n) == 0)
			return r;
	return NULL;
}

bool option_is_for(const struct option_row *r, const struct command *c)
{
	return (r->commands & c->kind) != 0;
}

/* The argument of the option in these words, if it is that; else NULL. */
static char *argument_of(const struct option_row *r, char **words)
{
	size_t n = strlen(r->name);

	if (strncmp(*words, "--", 2) != 0 ||
	    strncmp(*words + 2, r->name, n) != 0)
		return NULL;
	return (*words)[2 + n] == '=' ? *words + n + 3 :
	    (*words)[2 + n] == '\0'   ? words[1] :
					NULL;
}

void options_first(char **words)
{
	struct options none = { 0 };

	for (const struct option_row *r = option_rows; r->name != NULL; r++) {
		if (r->set != set_errors && r->set != choose_color)
			continue;
		for (char **w = words; *w && strcmp(*w, "--") != 0; w++) {
			char *argument = argument_of(r, w);

			if (argument != NULL)
				r->set(&none, argument);
		}
	}
}

/* The command's options, or where name is not NULL those that begin with it. */
static int names_of(const struct command *c, const char *name,
    const char *names[ROWS + 1])
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
	const char *names[ROWS + 1], name[] = { letter, '\0' };
	char shown[ESCAPED_MAX], list[LISTED];

	if (names_of(c, name, names) > 0)
		die(EXIT_USAGE, "%s: unknown option -%c; with two dashes: %s",
		    c->name, letter, list_words(list, names, " and ", ""));
	die(EXIT_USAGE, "%s: unknown option -%s; 'projcalc help %s' lists them",
	    c->name, escaped(shown, &letter, 1), c->name);
}

/* words[0] is "--name" or "--name=value". */
static _Noreturn void refuse_name(const struct command *c, char **words)
{
	const char *names[ROWS + 1] = { NULL }, *near;
	const char *word = *words + 2;
	const int n = (int)strcspn(word, "=");
	char name[64], list[LISTED];

	snprintf(name, sizeof name, "%.*s", n, word);
	if (*name != '\0' && names_of(c, name, names) > 1)
		die(EXIT_USAGE, "%s: --%s may be %s; write more of it", c->name,
		    name, list_words(list, names, " or ", ""));
	near = names[0];
	if (near == NULL)
		mistaken_member(c, words, false);
	if (near == NULL)
		near = mistaken_option(name);
	names_of(c, NULL, names);
	if (near == NULL)
		near = nearest(name, names);
	if (near != NULL)
		die(EXIT_USAGE, "%s: unknown option --%.*s; did you mean --%s?",
		    c->name, n, word, near);
	die(EXIT_USAGE,
	    "%s: unknown option --%.*s; 'projcalc help %s' lists them", c->name,
	    n, word, c->name);
}

/* Refuses an option's name, or a member's, behind a single dash: "-to", which
 * would be -t with the argument o. */
static void check_dash(const struct command *c, char **words)
{
	const char *word = *words;

	if (word == NULL || *word != '-' || word[1] == '-' || strlen(word) < 3)
		return;
	const struct option_row *row = option_named(word + 1);
	const char *near = row != NULL ? row->name : mistaken_option(word + 1);

	if (near != NULL)
		die(EXIT_USAGE, "%s: unknown option %s; did you mean --%s?",
		    c->name, word, near);
	mistaken_member(c, words, false);
}

/* getopt_long returns an option's letter, or LONG + the number of its row if it
 * was given by its name. */
enum { LONG = 256 };

static void getopt_tables(struct option longs[ROWS + 1],
    char letters[2 * ROWS + 2])
{
	*letters++ = ':'; /* a missing argument is returned as ':' */
	for (int i = 0; i < ROWS; i++) {
		bool argument = option_rows[i].argument != NULL;

		longs[i] = (struct option){ option_rows[i].name,
			argument ? required_argument : no_argument, NULL,
			LONG + i };
		if (option_rows[i].letter != 0) {
			*letters++ = option_rows[i].letter;
			if (argument)
				*letters++ = ':';
		}
	}
	longs[ROWS] = (struct option){ 0 };
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

/* The word whose letter getopt_long has refused: it goes on with it, or has gone past
 * it if that was its last. */
static char **word_with(char letter, char **next)
{
	const char *before = next[-1];
	bool past = *before == '-' && before[1] != '-' &&
	    before[strlen(before) - 1] == letter;

	return past ? next - 1 : next;
}

/* Refuses what getopt_long could not take, before argv[optind]: got is ':' for a missing
 * argument. optopt is the option's letter or LONG + its row, or 0 for an unknown
 * name. A letter is called by itself, as it may be one of several in a word: -mx. */
static _Noreturn void refuse(const struct command *c, int got, char **argv)
{
	const char letter = (char)optopt;

	if (optopt >= LONG)
		die(EXIT_USAGE, "%s: --%s %s argument", c->name,
		    row_of(optopt)->name, got == ':' ? "needs an" : "takes no");
	if (got == ':')
		die(EXIT_USAGE, "%s: -%c needs an argument", c->name, letter);
	if (letter == '\0')
		refuse_name(c, argv + optind - 1);
	check_dash(c, word_with(letter, argv + optind));
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

/* next is the word behind the option and its argument, optarg. */
static void set(const struct command *c, const struct option_row *r,
    char **next, struct options *o)
{
	if (!option_is_for(r, c)) {
		mistaken_member(c, next - (optarg == next[-1] ? 2 : 1), true);
		refuse_here(c, r);
	}
	if (r->set != NULL)
		r->set(o, optarg);
	else
		*(bool *)((char *)o + r->on) = true;
}

int coordinates_of(const struct command *c, const struct options *o)
{
	if (c->kind == PLANAR || o->ray)
		return 2;
	return o->from == SPACE_CLIP ||
		(o->from == SPACE_DEVICE && o->homogeneous) ?
	    4 :
	    3;
}

struct number_style one_style(const struct options *o, const char *what)
{
	const struct number_style *style = &o->styles.style[0];

	if (o->styles.n > 1)
		die(EXIT_USAGE, "--%s: %d numbers; %s is rounded alike, by one",
		    style->kind == NUMBER_DIGITS ? "digits" : "decimals",
		    o->styles.n, what);
	return *style;
}

/* What is traced is text or JSON. */
static void choose_output(const struct command *c, struct options *o)
{
	if (!o->has_out)
		o->out = o->in == FORMAT_JSON ? FORMAT_JSON : FORMAT_TEXT;
	o->has_out = true;
	if (o->out != FORMAT_TEXT && o->out != FORMAT_JSON)
		die(EXIT_USAGE, "%s prints -o text or -o json", c->name);
}

/* Options may stand among the operands: getopt_long moves those to the end. */
void options_read(const struct command *c, int argc, char **argv,
    struct options *o)
{
	struct option longs[ROWS + 1];
	char letters[2 * ROWS + 2];
	int got;

	getopt_tables(longs, letters);
	opterr = 0;
	while ((got = getopt_long(argc, argv, letters, longs, NULL)) != -1) {
		if (got == '?' || got == ':')
			refuse(c, got, argv);
		if (got < LONG && optarg != NULL && optarg != argv[optind - 1])
			check_dash(c, argv + optind - 1);
		set(c, row_of(got), argv + optind, o);
		if (o->help || o->version)
			return;
	}
	if (c->kind == TRACE)
		choose_output(c, o);
	char **operands = argv + optind;

	if (*operands != NULL)
		o->params = *operands++;
	o->points = operands;
	while (operands[o->n_points] != NULL)
		o->n_points++;
}
