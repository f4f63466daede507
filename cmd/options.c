#include "options.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "escape.h"
#include "nearest.h"
#include "scene/convention_member.h"
#include "talk.h"

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

static void set_decimals(struct options *o, char *word)
{
	o->style.kind = NUMBER_DECIMALS;
	o->style.n = whole_number("decimals", word, 0, 100);
}

static void set_digits(struct options *o, char *word)
{
	o->style.kind = NUMBER_DIGITS;
	o->style.n = whole_number("digits", word, 1, 100);
}

static void set_precision(struct options *o, char *word)
{
	o->precision = (enum precision)one_of(precision_names, "precision",
	    word);
	o->has_precision = true;
}

static void set_tolerance(struct options *o, char *word)
{
	o->tolerances = tolerances_of("tolerance", word);
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

/* Kinds of commands that share options, as unions of enum command_kind. */
enum {
	PLANES = PROJECT | TRACE | PLANAR, /* ask what points are outside of */
	WITHIN = MATRIX | PLANES,          /* to a precision or tolerance */
	PRINTED = WITHIN | PICK,           /* print points */
	POINTS = PRINTED | FIT,            /* read them */
	NUMBERS = PRINTED | INSPECT,       /* print numbers to be rounded */
	ALL = POINTS | INSPECT,
};

#define ON(member) .on = offsetof(struct options, member)

/* clang-format off */
static const struct row {
	const char *name;
	char letter;       /* or 0 */
	unsigned commands; /* the kinds that take it, as bits */
	const char *about; /* one line of help */
	/* With an argument: what the help calls that, and what reads it. */
	const char *argument;
	void (*set)(struct options *, char *word);
	/* Without one: the bool of struct options that becomes true. */
	size_t on;
} rows[] = {
	{ "convention", 'c', ALL, "of the answer: d3d, gl, vulkan, webgpu or opencv",
	    .argument = "NAME", .set = set_convention },
	{ "input", 'i', POINTS,
	    "of points: text (default), csv, tsv, json, f64, f32",
	    .argument = "FORMAT", .set = set_input },
	{ "output", 'o', PRINTED, "the same; default the input's",
	    .argument = "FORMAT", .set = set_output },
	{ "separator", 0, POINTS, "between fields of csv: a character, or tab",
	    .argument = "C", .set = set_separator },
	{ "header", 0, POINTS, "the first line of csv is a header", ON(header) },
	{ "no-header", 0, POINTS, "it is not", ON(no_header) },
	{ "columns", 0, POINTS,
	    "the coordinates: fields 2,3,4, or names in csv and JSON",
	    .argument = "LIST", .set = set_columns },
	{ "decimals", 'd', NUMBERS, "round to N decimals",
	    .argument = "N", .set = set_decimals },
	{ "digits", 0, NUMBERS, "round to N significant digits",
	    .argument = "N", .set = set_digits },
	{ "precision", 'p', WITHIN,
	    "exact (default), double or single",
	    .argument = "NAME", .set = set_precision },
	{ "tolerance", 't', WITHIN | INSPECT,
	    "within T of the exact value, a list for x,y,z",
	    .argument = "T,...", .set = set_tolerance },
	{ "from", 0, PROJECT | TRACE, "model, world, view, clip, ndc or device",
	    .argument = "SPACE", .set = set_from },
	{ "to", 0, PROJECT, "the same; default device, else ndc",
	    .argument = "SPACE", .set = set_to },
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
	{ "help", 'h', ALL, "this help", ON(help) },
	{ "version", 0, ALL, "the version", ON(version) },
};
/* clang-format on */

enum { ROWS = sizeof rows / sizeof *rows };

static bool takes(const struct command *c, const struct row *r)
{
	return (r->commands & c->kind) != 0;
}

void options_print(const struct command *c)
{
	for (const struct row *r = rows; r < rows + ROWS; r++) {
		const char letter[] = { '-', r->letter, ',', ' ', '\0' };
		char left[40];

		if (!takes(c, r))
			continue;
		snprintf(left, sizeof left, "%s--%s %s",
		    r->letter != 0 ? letter : "    ", r->name,
		    r->argument != NULL ? r->argument : "");
		printf("  %-24s %s\n", left, r->about);
	}
}

static _Noreturn void refuse_unknown(const struct command *c, const char *word)
{
	const char *names[ROWS + 1], *near = NULL;
	int n = 0;

	for (const struct row *r = rows; r < rows + ROWS; r++)
		if (takes(c, r))
			names[n++] = r->name;
	names[n] = NULL;
	if (strncmp(word, "--", 2) == 0)
		near = nearest(word + 2, names);
	if (near != NULL)
		die(EXIT_USAGE, "%s: unknown option %s; did you mean --%s?",
		    c->name, word, near);
	die(EXIT_USAGE, "%s: unknown option %s; 'projcalc help %s' lists them",
	    c->name, word, c->name);
}

/* getopt_long returns an option's letter, or LONG + the number of its row if it
 * was given by its name. */
enum { LONG = 256 };

static void getopt_tables(struct option longs[ROWS + 1],
    char letters[2 * ROWS + 2])
{
	*letters++ = ':'; /* a missing argument is returned as ':' */
	for (int i = 0; i < ROWS; i++) {
		bool argument = rows[i].argument != NULL;

		longs[i] = (struct option){ rows[i].name,
			argument ? required_argument : no_argument, NULL,
			LONG + i };
		if (rows[i].letter != 0) {
			*letters++ = rows[i].letter;
			if (argument)
				*letters++ = ':';
		}
	}
	longs[ROWS] = (struct option){ 0 };
	*letters = '\0';
}

/* The row of what getopt_long returned, or NULL. */
static const struct row *row_of(int got)
{
	if (got >= LONG)
		return &rows[got - LONG];
	for (const struct row *r = rows; r < rows + ROWS; r++)
		if (got != 0 && r->letter == got)
			return r;
	return NULL;
}

/* Refuses what getopt_long could not take: got is '?' for an unknown option,
 * ':' for a missing argument. optopt is the option's letter, or 0 for an
 * unknown name, which is last_word. A letter is called by itself, as it may be
 * one of several in a word: -mx. */
static _Noreturn void refuse(const struct command *c, int got,
    const char *last_word)
{
	const struct row *r = row_of(optopt);
	const char letter = r != NULL ? r->letter : (char)optopt;
	char shown[ESCAPED_MAX], short_word[ESCAPED_MAX + 1];
	const char *word = letter != '\0' ? short_word : last_word;

	snprintf(short_word, sizeof short_word, "-%s",
	    escaped(shown, &letter, 1));

	if (got == ':')
		die(EXIT_USAGE, "%s: %s needs an argument", c->name, word);
	refuse_unknown(c, word);
}

/* Says for which commands an option is. */
static _Noreturn void refuse_here(const struct command *c, const struct row *r)
{
	/* in the order of the bits of enum command_kind */
	static const char *const names[] = { "the 3D matrix commands",
		"project", "pick", "fit", "inspect", "trace",
		"the 2D commands" };
	char list[160];
	size_t n = 0;

	for (unsigned i = 0; i < sizeof names / sizeof *names; i++) {
		unsigned more = r->commands >> i >> 1;

		if (r->commands >> i & 1)
			n += (size_t)snprintf(list + n, sizeof list - n, "%s%s",
			    names[i],
			    more == 0                    ? "" :
				(more & (more - 1)) == 0 ? " and " :
							   ", ");
	}
	die(EXIT_USAGE, "%s: --%s is not for this command; it is for %s",
	    c->name, r->name, list);
}

static void set(const struct command *c, const struct row *r, char *word,
    struct options *o)
{
	if (!takes(c, r))
		refuse_here(c, r);
	if (r->set != NULL)
		r->set(o, word);
	else
		*(bool *)((char *)o + r->on) = true;
}

/* What -t says of itself: the precision, the digits, and that they be enough. */
static void check_tolerances(const struct command *c, const struct options *o)
{
	if (o->has_precision)
		die(EXIT_USAGE,
		    "%s: -p and -t exclude each other; -t chooses "
		    "the precision",
		    c->name);
	if (o->style.kind != NUMBER_SHORTEST && c->kind != INSPECT)
		die(EXIT_USAGE,
		    "%s: %s and -t exclude each other; -t says how many "
		    "decimals there are",
		    c->name,
		    o->style.kind == NUMBER_DIGITS ? "--digits" : "-d");
	if ((o->has_out ? o->out : o->in) == FORMAT_F32)
		die(EXIT_USAGE,
		    "%s: floats are not within a tolerance; with -t say "
		    "-o f64 or -o text",
		    c->name);
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
			refuse(c, got, argv[optind - 1]);
		set(c, row_of(got), optarg, o);
		if (o->help || o->version)
			return;
	}
	if (c->kind == TRACE)
		choose_output(c, o);
	if (o->tolerances.n > 0)
		check_tolerances(c, o);
	char **operands = argv + optind;

	if (*operands != NULL)
		o->params = *operands++;
	o->points = operands;
	while (operands[o->n_points] != NULL)
		o->n_points++;
}
