#include "options.h"

#include <ctype.h>
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "nearest.h"
#include "talk.h"

/* A letter that is upper case stands for an option without one, but for -H. */
static const struct {
	int letter;
	const char *name, *argument, *about;
} options[] = {
	{ 'c', "convention", "NAME", "d3d (default), gl, vulkan or webgpu" },
	{ 'i', "input", "FORMAT",
	    "of points: text (default), csv, json, f64, f32" },
	{ 'o', "output", "FORMAT", "the same; default the input's" },
	{ 'C', "columns", "LIST",
	    "the coordinates' fields: 2,3,4, or names in csv" },
	{ 'd', "decimals", "N", "round to N decimals" },
	{ 'D', "digits", "N", "round to N significant digits" },
	{ 'p', "precision", "NAME", "exact (default), double or single" },
	{ 't', "tolerance", "T", "the cheapest precision within T units" },
	{ 'F', "from", "SPACE", "model, world, view, clip, ndc or device" },
	{ 'T', "to", "SPACE", "the same; default device, else ndc" },
	{ 'H', "homogeneous", NULL, "x y z w, not divided" },
	{ 'm', "matrix", NULL, "print the matrix, read no points" },
	{ 'A', "at", "X,Y", "the device position" },
	{ 'Q', "radius", "R", "how far around it, in device units" },
	{ 'R', "ray", NULL,
	    "x y on the device: point on the near plane, direction" },
	{ 'G', "flags", NULL,
	    "add in, or the planes that the point is outside of" },
	{ 'I', "visible", NULL, "print only points in the view volume" },
	{ 'K', "keep-going", NULL, "print nan for a bad line and go on" },
	{ 'j', "jobs", "N", "threads; default all cores" },
	{ 'P', "progress", NULL, "tell how far it is, also in a file or pipe" },
	{ 'h', "help", NULL, "this help" },
	{ 'V', "version", NULL, "the version" },
};

enum { OPTIONS = sizeof options / sizeof *options };

static const char *const precision_names[] = { "exact", "double", "single",
	NULL };
static const char *const space_names[] = { "model", "world", "view", "clip",
	"ndc", "device", NULL };

static bool has_letter(int letter)
{
	return islower(letter) || letter == 'H';
}

static bool uses(const struct command *c, int letter)
{
	return strchr("hV", letter) != NULL ||
	    strchr(c->letters, letter) != NULL;
}

void options_print(const struct command *c)
{
	for (int i = 0; i < OPTIONS; i++) {
		char left[40], letter[] = "-x, ";

		if (!uses(c, options[i].letter))
			continue;
		letter[1] = (char)options[i].letter;
		snprintf(left, sizeof left, "%s--%s %s",
		    has_letter(options[i].letter) ? letter : "    ",
		    options[i].name,
		    options[i].argument != NULL ? options[i].argument : "");
		printf("  %-24s %s\n", left, options[i].about);
	}
}

static int choose(const char *const *names, const char *what, const char *word)
{
	char all[80] = "";

	for (int i = 0; names[i] != NULL; i++) {
		if (strcmp(names[i], word) == 0)
			return i;
		if (i > 0)
			strcat(all, names[i + 1] == NULL ? " or " : ", ");
		strcat(all, names[i]);
	}
	die(EXIT_USAGE, "unknown %s '%s'; it is one of %s", what, word, all);
}

static enum format choose_format(const char *word, bool output)
{
	if (output && strpbrk(word, "./") != NULL)
		die(EXIT_USAGE,
		    "unknown format '%s'; to write a file use "
		    "> %s",
		    word, word);
	return (enum format)choose(format_names, "format", word);
}

static int whole_number(const char *option, const char *word, int min, int max)
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

static double positive_number(const char *option, const char *word)
{
	const char *end = word + strlen(word);
	double v;

	if (number_read(word, end, &v) != end ||
	    !(v >= SIZE_MIN && v <= MAGNITUDE_MAX))
		die(EXIT_USAGE, "--%s: '%s' is not a positive number", option,
		    word);
	return v;
}

static void read_at(const char *word, double at[2])
{
	const char *end = word + strlen(word);
	const char *comma = number_read(word, end, &at[0]);

	if (comma == NULL || *comma != ',' ||
	    number_read(comma + 1, end, &at[1]) != end ||
	    !(fabs(at[0]) <= MAGNITUDE_MAX) || !(fabs(at[1]) <= MAGNITUDE_MAX))
		die(EXIT_USAGE, "--at: '%s' is not X,Y", word);
}

/* "2,3,4" or names of a csv header, mixed as it comes. */
static struct columns read_columns(char *list)
{
	struct columns c = { 0 };

	for (char *word = list; word != NULL; c.n++) {
		char *comma = strchr(word, ',');

		if (comma != NULL)
			*comma++ = '\0';
		if (c.n == 4)
			die(EXIT_USAGE, "--columns: more than four fields");
		if (*word == '\0')
			die(EXIT_USAGE,
			    "--columns: an empty field; write "
			    "2,3,4");
		if (strspn(word, "0123456789") == strlen(word))
			c.field[c.n] = whole_number("columns", word, 1,
					   1000000) -
			    1;
		else
			c.name[c.n] = word;
		for (int i = 0; i < c.n; i++)
			if (c.name[i] == NULL && c.name[c.n] == NULL &&
			    c.field[i] == c.field[c.n])
				die(EXIT_USAGE,
				    "--columns: field %d stands "
				    "twice",
				    c.field[i] + 1);
		word = comma;
	}
	return c;
}

/* Options without an argument. */
static bool *switch_of(struct options *o, int letter)
{
	switch (letter) {
	case 'H':
		return &o->homogeneous;
	case 'm':
		return &o->matrix;
	case 'R':
		return &o->ray;
	case 'G':
		return &o->flags;
	case 'I':
		return &o->visible;
	case 'K':
		return &o->keep_going;
	case 'P':
		return &o->progress;
	default:
		return NULL;
	}
}

static void set_option(struct options *o, int letter, char *word)
{
	struct convention convention;

	switch (letter) {
	case 'c':
		if (!convention_find(word, &convention))
			die(EXIT_USAGE,
			    "unknown convention '%s'; it is one "
			    "of d3d, gl, vulkan or webgpu",
			    word);
		o->convention = word;
		break;
	case 'i':
		o->in = choose_format(word, false);
		break;
	case 'o':
		o->out = choose_format(word, true);
		o->out_given = true;
		break;
	case 'C':
		o->columns = read_columns(word);
		break;
	case 'd':
		o->style.kind = NUMBER_DECIMALS;
		o->style.n = whole_number("decimals", word, 0, 100);
		break;
	case 'D':
		o->style.kind = NUMBER_DIGITS;
		o->style.n = whole_number("digits", word, 1, 100);
		break;
	case 'p':
		o->accuracy.precision = (enum precision)choose(precision_names,
		    "precision", word);
		o->precision_given = true;
		break;
	case 't':
		o->accuracy.tolerance = positive_number("tolerance", word);
		break;
	case 'F':
		o->has_from = true;
		o->from = (enum space)choose(space_names, "space", word);
		break;
	case 'T':
		o->has_to = true;
		o->to = (enum space)choose(space_names, "space", word);
		break;
	case 'A':
		read_at(word, o->at);
		o->has_at = true;
		break;
	case 'Q':
		o->radius = positive_number("radius", word);
		break;
	case 'j':
		o->jobs = whole_number("jobs", word, 1, 256);
		break;
	}
}

static const char *name_of(int letter)
{
	for (int i = 0; i < OPTIONS; i++)
		if (options[i].letter == letter)
			return options[i].name;
	return "";
}

/* What getopt could not take. */
static _Noreturn void bad_option(const struct command *c, int got,
    const char *word)
{
	const char *names[OPTIONS + 1] = { NULL };
	int n = 0;

	if (got == ':')
		die(EXIT_USAGE, "%s: %s needs an argument", c->name, word);
	for (int i = 0; i < OPTIONS; i++)
		if (uses(c, options[i].letter))
			names[n++] = options[i].name;
	const char *near = strncmp(word, "--", 2) == 0 ?
	    nearest(word + 2, names) :
	    NULL;

	if (near != NULL)
		die(EXIT_USAGE, "%s: unknown option %s; did you mean --%s?",
		    c->name, word, near);
	die(EXIT_USAGE,
	    "%s: unknown option %s; 'projcalc help %s' lists "
	    "them",
	    c->name, word, c->name);
}

/* Options may stand among the operands, which getopt moves behind them. */
int options_read(const struct command *c, int argc, char **argv,
    struct options *o)
{
	struct option longs[OPTIONS + 1] = { 0 };
	char shorts[2 * OPTIONS + 2] = ":", *s = shorts + 1;
	int got;

	for (int i = 0; i < OPTIONS; i++) {
		bool argument = options[i].argument != NULL;

		longs[i] = (struct option){ options[i].name,
			argument ? required_argument : no_argument, NULL,
			options[i].letter };
		if (has_letter(options[i].letter))
			*s++ = (char)options[i].letter;
		if (has_letter(options[i].letter) && argument)
			*s++ = ':';
	}
	opterr = 0;
	while ((got = getopt_long(argc, argv, shorts, longs, NULL)) != -1) {
		if (got == 'h' || got == 'V')
			return got;
		if (got == '?' || got == ':') {
			char letter[] = { '-', (char)optopt, '\0' };

			bad_option(c, got,
			    has_letter(optopt) ? letter : argv[optind - 1]);
		}
		if (!uses(c, got))
			die(EXIT_USAGE,
			    "%s: --%s is not for this command; "
			    "'projcalc help %s' lists what is",
			    c->name, name_of(got), c->name);
		bool *on = switch_of(o, got);

		if (on != NULL)
			*on = true;
		else
			set_option(o, got, optarg);
	}
	if (o->precision_given && o->accuracy.tolerance > 0)
		die(EXIT_USAGE,
		    "%s: -p and -t exclude each other; -t chooses "
		    "the precision",
		    c->name);
	char **operands = argv + optind;

	if (*operands != NULL)
		o->params = *operands++;
	o->points = operands;
	while (operands[o->n_points] != NULL)
		o->n_points++;
	return 0;
}
