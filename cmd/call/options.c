/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <stdio.h>
#include <string.h>

#include "../json/value.h"
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

/* Reads the name of a format, and in *record the numbers of a binary record. */
static enum format format_of_word(const char *option, char *word, int *record)
{
	const int record_max = 64;

	*record = 0;
	if (strncmp(word, "f32x", 4) == 0 || strncmp(word, "f64x", 4) == 0) {
		*record = whole_number(option, word + 4, 2, record_max);
		word[3] = '\0';
	}
	return (enum format)one_of(format_names, "format", word);
}

static void set_input(struct options *o, char *word)
{
	if (strpbrk(word, "./") != NULL)
		die(EXIT_USAGE,
		    "unknown format '%s'; a file of points stands after the "
		    "scene, without an option",
		    word);
	o->in = format_of_word("input", word, &o->in_record);
}

static void set_output(struct options *o, char *word)
{
	if (strpbrk(word, "./") != NULL)
		die(EXIT_USAGE, "unknown format '%s'; to write a file use > %s",
		    word, word);
	o->out = format_of_word("output", word, &o->out_record);
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

static void set_tolerance(struct options *o, char *word)
{
	o->tolerance = positive_number("tolerance", word);
}

static void set_distances(struct options *o, char *word)
{
	o->n_distances = distances_of("distances", word, o->distance);
}

static void set_at(struct options *o, char *word)
{
	numbers_of("at", "X,Y", "320,240", word, 2, o->at);
}

static void set_plane(struct options *o, char *word)
{
	const double *p = o->plane;

	numbers_of("plane", "A,B,C,D", "0,0,1,0", word, 4, o->plane);
	if (p[0] == 0 && p[1] == 0 && p[2] == 0)
		die(EXIT_USAGE,
		    "--plane: %s is no plane; A, B or C is other than 0: "
		    "--plane 0,0,1,0",
		    word);
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
	message_state.json = one_of(message_forms, "--errors", word) == 1;
}

static void set_color(struct options *o, char *word)
{
	(void)o;
	message_state.color = (enum color)one_of(color_names, "--color", word);
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
#define WORD(member, kind, names) \
	.words = names, .what = kind, .at = offsetof(struct options, member)

/* clang-format off */
const struct option_row option_rows[] = {
	{ "convention", 'c', ALL, "of the answer: d3d, gl, vulkan, webgpu or opencv",
	    .argument = "NAME", .set = set_convention,
	    .words = convention_names },
	{ "input", 'i', POINTS,
	    "of points: text (default), csv, tsv, json, f64, f32, f32x4",
	    .argument = "FORMAT", .set = set_input, .words = format_names },
	{ "output", 'o', ALL, "the same; default the input's",
	    .argument = "FORMAT", .set = set_output, .words = format_names,
	    ON(has_out) },
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
	    .argument = "NAME", WORD(precision, "precision", precision_names) },
	{ "tolerance", 't', INSPECT,
	    "the error that the -p told may have; default 0.5",
	    .argument = "T", .set = set_tolerance },
	{ "distances", 0, INSPECT,
	    "add the depth_step toward the eye at these distances",
	    .argument = "D,...", .set = set_distances },
	{ "from", 0, PROJECT | TRACE, "model, world, view, clip, ndc or device",
	    .argument = "SPACE", ON(has_from), WORD(from, "space", space_names) },
	{ "to", 0, PROJECT, "the same; default device, else ndc",
	    .argument = "SPACE", ON(has_to), WORD(to, "space", space_names) },
	{ "homogeneous", 'H', PROJECT, "x y z w, not divided",
	    ON(homogeneous) },
	{ "matrix", 'm', MATRIX | PROJECT | PLANAR,
	    "print the matrix, read no points", ON(matrix) },
	{ "at", 0, PICK, "the device position",
	    .argument = "X,Y", .set = set_at, ON(has_at) },
	{ "radius", 0, PICK, "how far around it, in device units",
	    .argument = "R", .set = set_radius },
	{ "ray", 0, PROJECT,
	    "x y on the device: point on the near plane, direction",
	    ON(ray) },
	{ "plane", 0, PROJECT,
	    "x y: where their ray meets a x + b y + c z + d = 0",
	    .argument = "A,B,C,D", .set = set_plane, ON(has_plane) },
	{ "append", 0, MATRIX | PROJECT | PLANAR,
	    "keep the line whole, and print the image behind it",
	    ON(append) },
	{ "flags", 0, PLANES,
	    "add in, or the planes that the point is outside of",
	    ON(flags) },
	{ "visible", 0, PLANES,
	    "print only points in the view volume or window", ON(visible) },
	{ "keep-going", 0, ALL, "print nan for a bad line, go on after a bad scene",
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
	    .argument = "WHEN", .set = set_color, .words = color_names },
	{ "help", 'h', EVERY, "this help", ON(help) },
	{ "version", 0, EVERY, "the version", ON(version) },
	{ .name = NULL },
};
/* clang-format on */

_Static_assert(sizeof option_rows / sizeof *option_rows <= OPTIONS_MAX + 1,
    "OPTIONS_MAX is too small");

const struct option_row *option_named(const char *name)
{
	const size_t n = strcspn(name, "= ");

	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (strlen(r->name) == n && strncmp(r->name, name, n) == 0)
			return r;
	return NULL;
}

bool option_is_for(const struct option_row *r, const struct command *c)
{
	return (r->commands & c->kind) != 0;
}

void options_first(char **words)
{
	struct options none = { 0 };

	for (char **w = words; *w != NULL && strcmp(*w, "--") != 0; w++) {
		const struct option_row *r = strncmp(*w, "--", 2) == 0 ?
		    option_named(*w + 2) :
		    NULL;
		char *equals = strchr(*w, '=');
		char *argument = equals != NULL ? equals + 1 : w[1];

		if (r != NULL && argument != NULL &&
		    (r->set == set_errors || r->set == set_color))
			r->set(&none, argument);
	}
}

int coordinates_of(const struct command *c, const struct options *o)
{
	if (c->kind == PLANAR || o->ray || o->has_plane)
		return 2;
	return o->from == SPACE_CLIP ||
		(o->from == SPACE_DEVICE && o->homogeneous) ?
	    4 :
	    3;
}

enum format options_output(const struct options *o)
{
	return o->has_out ? o->out : o->in;
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
