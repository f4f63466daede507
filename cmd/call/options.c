/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../json/value.h"
#include "../message/message.h"
#include "../message/utf8.h"
#include "../scene/types.h"

const char *const precision_names[] = { "exact", "double", "single", NULL };

const char *const space_names[] = { "model", "world", "view", "clip", "ndc",
	"device", NULL };

/* Reads one of the words of a row, and sets the row's member or global to its index. */
static void option_read_word(struct options *o, const struct option_row *r,
    char *word)
{
	unsigned *at = r->global != NULL ? r->global :
					   (void *)((char *)o + r->at);
	char all[LIST_ROOM];

	for (unsigned i = 0; r->words[i] != NULL; i++)
		if (strcmp(r->words[i], word) == 0) {
			*at = i;
			return;
		}
	die(EXIT_USAGE, "--%s: unknown word '%s'; use %s", r->name, word,
	    list_words(all, r->words, " or ", ""));
}

static int whole_number(const struct option_row *r, const char *word, int min,
    int max)
{
	char *end;
	long n = strtol(word, &end, 10);

	if (end == word || *end != '\0' || n < min || n > max)
		die(EXIT_USAGE,
		    "--%s: '%s' is not a whole number from %d to %d", r->name,
		    word, min, max);
	return (int)n;
}

static void option_read_whole_number(struct options *o,
    const struct option_row *r, char *word)
{
	*(int *)((char *)o + r->at) = whole_number(r, word, r->min, r->max);
}

/* Reads the name of a format, or of binary records, "f32x4". */
static void option_read_format(struct options *o, const struct option_row *r,
    char *word)
{
	const int record_max = 64;
	int *record = r->letter == 'o' ? &o->out_record : &o->in_record;

	if (strpbrk(word, "./") != NULL)
		die(EXIT_USAGE, "--%s: '%s' is not a format; %s", r->name, word,
		    r->letter == 'o' ? "use > to write a file" :
				       "give files of points after PARAMS");
	*record = 0;
	if (strncmp(word, "f32x", 4) == 0 || strncmp(word, "f64x", 4) == 0) {
		*record = whole_number(r, word + 4, 2, record_max);
		word[3] = '\0';
	}
	option_read_word(o, r, word);
}

/* Reads a number from SIZE_MIN to MAGNITUDE_MAX. */
static void option_read_size(struct options *o, const struct option_row *r,
    char *word)
{
	const char *end = word + strlen(word);
	double *v = (void *)((char *)o + r->at);

	if (number_read(word, end, v) != end ||
	    !(*v >= SIZE_MIN && *v <= MAGNITUDE_MAX))
		die(EXIT_USAGE,
		    "--%s: '%s' is not a number from 1e-150 to 1e150", r->name,
		    word);
}

/* Reads a list of r->min to r->max numbers with commas between them. */
static void option_read_numbers(struct options *o, const struct option_row *r,
    char *word)
{
	struct number_list *list = (void *)((char *)o + r->at);
	const char *at = word, *end = word + strlen(word);

	for (int n = 0; n < r->max; n++) {
		at = number_read(at, end, &list->v[n]);
		if (at == NULL || !(fabs(list->v[n]) <= MAGNITUDE_MAX))
			break;
		list->n = n + 1;
		if (at == end && list->n >= r->min)
			return;
		if (*at++ != ',')
			break;
	}
	die(EXIT_USAGE,
	    "--%s: '%s' is not %s: numbers up to 1e150 with commas between "
	    "them; write --%s %s",
	    r->name, word, r->argument, r->name, r->example);
}

/* Reads a character that can't be part of a number or a name, or the word tab. */
static void option_read_separator(struct options *o, const struct option_row *r,
    char *word)
{
	if (strcmp(word, "tab") == 0 || strcmp(word, "\\t") == 0)
		o->separator = '\t';
	else if (strlen(word) != 1 || (unsigned char)*word >= 0x7f ||
	    strchr("\"'+-.#_\r\n\v\f", *word) != NULL || isalnum(*word))
		die(EXIT_USAGE,
		    "--%s: '%s' can't separate fields; use one character "
		    "such as ; or |, or tab",
		    r->name, word);
	else
		o->separator = *word;
}

/* Returns the first word of a list that commas divide. Sets *list to the next word, or
 * to NULL if there is none. */
static char *cut_word(char **list)
{
	char *word = *list;

	*list = strchr(word, ',');
	if (*list != NULL)
		*(*list)++ = '\0';
	return word;
}

static void option_read_styles(struct options *o, const struct option_row *r,
    char *list)
{
	enum number_kind kind = r->letter == 'd' ? NUMBER_DECIMALS :
						   NUMBER_DIGITS;
	struct styles *s = &o->styles;

	if (s->n > 0 && s->style[0].kind != kind)
		die(EXIT_USAGE,
		    "--decimals and --digits exclude each other; give one of "
		    "them a number for each coordinate");
	for (s->n = 0; list != NULL; s->n++) {
		int n = whole_number(r, cut_word(&list), r->min, r->max);

		if (s->n == COORDINATES_MAX)
			die(EXIT_USAGE, "--%s: more than six numbers", r->name);
		for (int k = s->n; k < COORDINATES_MAX; k++)
			s->style[k] = (struct number_style){ .kind = kind,
				.n = n };
	}
}

/* Reads fields by their number, from 1, or by their name: "2,z". */
static void option_read_columns(struct options *o, const struct option_row *r,
    char *list)
{
	const int fields_max = 1000000;
	struct columns *c = &o->columns;

	for (*c = (struct columns){ 0 }; list != NULL; c->n++) {
		char *word = cut_word(&list);

		if (c->n == 4)
			die(EXIT_USAGE, "--%s: more than four fields", r->name);
		if (strspn(word, "0123456789") == strlen(word))
			c->field[c->n] = whole_number(r, word, 1, fields_max) -
			    1;
		else
			c->name[c->n] = word;
		for (int i = 0; i < c->n; i++)
			if (c->field[i] == c->field[c->n] &&
			    strcmp(c->name[i] != NULL ? c->name[i] : "",
				c->name[c->n] != NULL ? word : "") == 0)
				die(EXIT_USAGE, "--%s: '%s' is there twice",
				    r->name, word);
	}
}

static const char *const message_forms[] = { "text", "json", NULL };
static const char *const color_names[] = { "auto", "always", "never", NULL };

/* Kinds of commands that share options, as unions of enum command_kind. */
enum {
	PLANES = PROJECT | TRACE | PLANAR, /* take --flags and --visible */
	IMAGES = MATRIX | PLANES,          /* print points' images */
	PRINTED = IMAGES | PICK,           /* print points */
	POINTS = PRINTED | FIT,            /* read points */
	NUMBERS = PRINTED | INSPECT,       /* print numbers that -d rounds */
	ALL = POINTS | INSPECT,
	EVERY = ALL | HELP,
};

#define ON(member) .on = offsetof(struct options, member)
#define AT(member) .at = offsetof(struct options, member)

/* clang-format off */
const struct option_row option_rows[] = {
	{ "convention", 'c', ALL, 
	    "convention of the answer: d3d, gl, vulkan, webgpu or opencv",
	    "NAME", option_read_word, AT(convention), .words = convention_names,
	    ON(has_convention) },
	{ "input", 'i', POINTS,
	    "format of the points: text (default), csv, tsv, json, f64, f32, f32x4",
	    "FORMAT", option_read_format, AT(in), .words = format_names,
	    .of_points = true },
	{ "output", 'o', ALL, "format of the output; default that of the input",
	    "FORMAT", option_read_format, AT(out), .words = format_names, ON(has_out) },
	{ "separator", 0, POINTS, "character between fields of csv, or tab",
	    "C", .read = option_read_separator },
	{ "header", 0, POINTS, "the first line of csv is a header", ON(header), .of_points = true },
	{ "no-header", 0, POINTS, "the first line of csv is no header", ON(no_header), .of_points = true },
	{ "columns", 0, POINTS,
	    "fields of the coordinates: 2,3,4, or names in csv and JSON",
	    "LIST", .read = option_read_columns, .of_points = true },
	{ "decimals", 'd', NUMBERS, "print N decimals; for points also a list: x,y,z",
	    "N,...", option_read_styles, .min = 0, .max = 100 },
	{ "digits", 0, NUMBERS, 
	    "print at most N significant digits; for points also a list",
	    "N,...", option_read_styles, .min = 1, .max = 100 },
	{ "precision", 'p', IMAGES, 
	    "arithmetic for points: exact (default), double or single",
	    "NAME", option_read_word, AT(precision), .words = precision_names },
	{ "tolerance", 't', INSPECT,
	    "name the cheapest precision with errors up to T; default 0.5",
	    "T", option_read_size, AT(tolerance) },
	{ "distances", 0, INSPECT,
	    "distances from near to far at which to print depth_step too",
	    "D,...", option_read_numbers, AT(distances), .min = 1,
	    .max = NUMBER_LIST_MAX, .example = "10,1000" },
	{ "from", 0, PROJECT | TRACE, 
	    "space of the input: model, world, view, clip, ndc or device",
	    "SPACE", option_read_word, AT(from), .words = space_names, ON(has_from) },
	{ "to", 0, PROJECT, "space of the output; default device, or ndc without a viewport",
	    "SPACE", option_read_word, AT(to), .words = space_names, ON(has_to) },
	{ "homogeneous", 'H', PROJECT, "print x y z w without division",
	    ON(homogeneous) },
	{ "matrix", 'm', MATRIX | PROJECT | PLANAR,
	    "print the matrix and read no points", ON(matrix) },
	{ "at", 0, PICK, "position on the device around which to look",
	    "X,Y", option_read_numbers, AT(pick_at), .min = 2, .max = 2,
	    .example = "320,240" },
	{ "radius", 0, PICK, "radius around the position of --at, in device units",
	    "R", option_read_size, AT(radius) },
	{ "ray", 0, PROJECT,
	    "read x y on the device; print the ray: point, direction",
	    ON(ray) },
	{ "plane", 0, PROJECT,
	    "read x y; print where the ray meets a x + b y + c z + d = 0",
	    "A,B,C,D", option_read_numbers, AT(plane), .min = 4, .max = 4,
	    .example = "0,0,1,0" },
	{ "append", 0, MATRIX | PROJECT | PLANAR,
	    "keep each line whole and add the image behind it",
	    ON(append), .of_points = true },
	{ "flags", 0, PLANES,
	    "add a word: in, or the planes that the point is outside of",
	    ON(flags), .of_points = true },
	{ "visible", 0, PLANES,
	    "print only points inside the view volume or window", ON(visible), .of_points = true },
	{ "keep-going", 0, ALL, "go on after a wrong scene or a bad line (prints nan)",
	    ON(keep_going) },
	{ "jobs", 'j', POINTS, "number of threads; default one for each processor",
	    "N", option_read_whole_number, AT(jobs), .min = 1, .max = 256 },
	{ "progress", 0, POINTS, "report on standard error how many lines are done",
	    ON(progress) },
	{ "scenes", 0, ALL, "PARAMS is any number of scenes, one after another",
	    ON(scenes) },
	{ "json", 0, HELP, "print all that the program knows of itself as JSON",
	    ON(json) },
	{ "errors", 0, EVERY, "form of messages: text (default) or json",
	    "FORM", option_read_word, .words = message_forms,
	    .global = &message_state.json },
	{ "color", 0, EVERY, "colour messages and help: auto (default), always or never",
	    "WHEN", option_read_word, .words = color_names,
	    .global = &message_state.color },
	{ "help", 'h', EVERY, "print this help", ON(help) },
	{ "version", 'V', EVERY, "print the version", ON(version) },
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

const char *option_takers(const struct option_row *r, char list[LIST_ROOM])
{
	/* in the order of the bits of enum command_kind */
	static const char *const names[] = { "the 3D matrix commands",
		"project", "pick", "fit", "inspect", "trace", "the 2D commands",
		"help" };
	const char *takers[sizeof names / sizeof *names + 1] = { NULL };
	int n = 0;

	for (unsigned i = 0; i < sizeof names / sizeof *names; i++)
		if (r->commands >> i & 1)
			takers[n++] = names[i];
	return list_words(list, takers, " and ", "");
}

bool option_is_for(const struct option_row *r, const struct command *c)
{
	return (r->commands & c->kind) != 0;
}

void options_read_first(char **words)
{
	for (char **w = words; *w != NULL && strcmp(*w, "--") != 0; w++) {
		const struct option_row *r = strncmp(*w, "--", 2) == 0 ?
		    option_named(*w + 2) :
		    NULL;
		char *equals = strchr(*w, '=');
		char *argument = equals != NULL ? equals + 1 : w[1];

		if (r != NULL && argument != NULL && r->global != NULL)
			r->read(NULL, r, argument);
	}
}

int coordinates_of(const struct command *c, const struct options *o)
{
	if (c->kind == PLANAR || o->ray || o->plane.n > 0)
		return 2;
	bool w = o->from == SPACE_CLIP ||
	    (o->from == SPACE_DEVICE && o->homogeneous);

	return w ? 4 : 3;
}

enum format options_output(const struct options *o)
{
	return o->has_out ? o->out : o->in;
}

struct number_style options_style(const struct options *o)
{
	if (o->styles.n > 1)
		die(EXIT_USAGE,
		    "--decimals or --digits: %d numbers; a matrix and the "
		    "output of inspect and pick take one",
		    o->styles.n);
	return o->styles.style[0];
}
