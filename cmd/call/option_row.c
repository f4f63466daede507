/* SPDX-License-Identifier: MIT */
#include "option_row.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../message/message.h"
#include "../message/words.h"
#include "../scene/convention_member.h"

const char *const precision_names[] = {
	[PRECISION_EXACT] = "exact",
	[PRECISION_DOUBLE] = "double",
	[PRECISION_SINGLE] = "single",
	[PRECISION_SINGLE + 1] = NULL,
};

const char *const space_names[] = {
	[SPACE_MODEL] = "model",
	[SPACE_WORLD] = "world",
	[SPACE_VIEW] = "view",
	[SPACE_CLIP] = "clip",
	[SPACE_NDC] = "ndc",
	[SPACE_DEVICE] = "device",
	[SPACE_DEVICE + 1] = NULL,
};
const char *const space_aliases[] = {
	[SPACE_MODEL] = "object object_space model_space",
	[SPACE_WORLD] = "world_space",
	[SPACE_VIEW] = "eye eye_space view_space",
	[SPACE_CLIP] = "clip_space",
	[SPACE_NDC] = "ndc_space",
	[SPACE_DEVICE] = "device_space",
};

/* Sets *r->global, or the option's member, to the index of `word` in r->words. */
static void option_read_word(struct options *o, const struct option_row *r, char *word)
{
	unsigned *at = r->global != NULL ? r->global : (void *)((char *)o + r->offset);
	const int found = word_index(word, r->words, r->word_aliases);
	char remedy[LIST_ROOM];

	if (found < 0)
		die(EXIT_USAGE, text("--%s: unknown word '%s'", r->name, word),
		    word_remedy_of_value(remedy, word, r->words, r->word_aliases, ""));
	*at = (unsigned)found;
}

static int whole_number(const struct option_row *r, const char *word, int min, int max)
{
	char *end;
	long n = strtol(word, &end, 10);

	if (end == word || *end != '\0' || n < min || n > max)
		die(EXIT_USAGE,
		    text("--%s: '%s' is not a whole number from %d to %d", r->name,
			word, min, max),
		    NULL);
	return (int)n;
}

static void option_read_format(struct options *o, const struct option_row *r,
    char *word)
{
	const int record_max = 64;
	int *record = r->letter == 'o' ? &o->out_record : &o->in_record;

	if (strpbrk(word, "./") != NULL)
		die(EXIT_USAGE, text("--%s: '%s' is not a format", r->name, word),
		    r->letter == 'o' ? "> writes a file" : "give files after PARAMS");
	*record = 0;
	if (strncmp(word, "f32x", 4) == 0 || strncmp(word, "f64x", 4) == 0) {
		*record = whole_number(r, word + 4, 2, record_max);
		word[3] = '\0';
	}
	option_read_word(o, r, word);
}

/* Reads r->min to r->max numbers with commas between them. */
static void option_read_numbers(struct options *o, const struct option_row *r,
    char *word)
{
	struct number_list *list = (void *)((char *)o + r->offset);
	const char *at = word, *end = word + strlen(word);
	double v;

	for (list->n = 0; list->n < r->max; at++) {
		at = number_read(at, end, &v);
		if (at == NULL || !(v >= r->least && v <= r->most) ||
		    (r->whole && v != floor(v)))
			break;
		list->v[list->n++] = v;
		if (at == end && list->n >= r->min)
			return;
		if (*at != ',')
			break;
	}
	die(EXIT_USAGE, text("--%s: '%s' is not %s", r->name, word, r->wanted), NULL);
}

/* Reads the word tab, or a character that can't be part of a number or a name. */
static void option_read_separator(struct options *o, const struct option_row *r,
    char *word)
{
	if (strcmp(word, "tab") == 0 || strcmp(word, "\\t") == 0)
		o->separator = '\t';
	else if (strcmp(word, " ") == 0)
		die(EXIT_USAGE,
		    text("--%s: fields with blanks between them are -i text", r->name),
		    NULL);
	else if (strlen(word) != 1 || (unsigned char)*word >= 0x7f ||
	    strchr("\"'+-.#_\r\n\v\f", *word) != NULL || isalnum(*word))
		die(EXIT_USAGE,
		    text("--%s: '%s' can't separate fields, as ;, | or tab can",
			r->name, word),
		    NULL);
	else
		o->separator = *word;
}

/* Reads a list of fields of a line, each by its number, from 1, or its name: "2,z". */
static void option_read_columns(struct options *o, const struct option_row *r,
    char *list)
{
	const int fields_max = 1000000;
	struct columns *c = &o->columns;

	for (*c = (struct columns){ 0 }; list != NULL; c->n++) {
		char *word = list;

		list = strchr(word, ',');
		if (list != NULL)
			*list++ = '\0';
		if (c->n == 4)
			die(EXIT_USAGE, text("--%s: more than four fields", r->name),
			    NULL);
		if (strspn(word, "0123456789") == strlen(word))
			c->field[c->n] = whole_number(r, word, 1, fields_max) - 1;
		else
			c->name[c->n] = word;
		for (int i = 0; i < c->n; i++)
			if (c->field[i] == c->field[c->n] &&
			    strcmp(c->name[i] != NULL ? c->name[i] : "",
				c->name[c->n] != NULL ? word : "") == 0)
				die(EXIT_USAGE,
				    text("--%s: '%s' is there twice", r->name, word),
				    NULL);
	}
}

static void option_read_background(struct options *o, const struct option_row *r,
    char *word)
{
	if (strcmp(word, "-") == 0)
		die(EXIT_USAGE, text("--%s: - is no file", r->name), NULL);
	o->background = word;
}

static const char *const message_forms[] = { "text", "json", NULL };
static const char *const color_names[] = { "auto", "always", "never", NULL };

/* Kinds of commands that share options, as unions of bits of enum command_kind. */
enum {
	TAKE_FLAGS = COMMAND_PROJECT | COMMAND_TRACE | COMMAND_MATRIX_2D,
	PRINT_IMAGES = COMMAND_MATRIX_3D | TAKE_FLAGS,
	PRINT_POINTS = PRINT_IMAGES | COMMAND_PICK,
	READ_POINTS = PRINT_POINTS | COMMAND_FIT | COMMAND_DRAW,
	PRINT_NUMBERS = PRINT_POINTS | COMMAND_INSPECT,
	ALL_BUT_HELP = COMMAND_ALL - COMMAND_HELP,
};

#define FLAG(member) .flag = offsetof(struct options, member)
#define OFFSET(member) .offset = offsetof(struct options, member)

/* clang-format off */
/* What option_read_numbers reads: up to n whole numbers; a size; min to max numbers. */
#define WHOLE(n, a, b) .min = 1, .max = n, .least = a, .most = b, .whole = true
#define A_SIZE \
	.min = 1, .max = 1, .least = SCENE_SIZE_MIN, .most = SCENE_MAGNITUDE_MAX, \
	.wanted = "a number from 1e-150 to 1e150"
#define NUMBERS(a, b, name, example) \
	.min = a, .max = b, .least = -SCENE_MAGNITUDE_MAX, \
	.most = SCENE_MAGNITUDE_MAX, \
	.wanted = name ", numbers up to 1e150 as in " example

const struct option_row option_rows[] = {
	{ "convention", 'c', ALL_BUT_HELP,
	    "answer in this convention: d3d, gl, vulkan, webgpu or opencv",
	    "NAME", option_read_word, OFFSET(convention), .words = convention_names,
	    .word_aliases = convention_aliases,
	    FLAG(has_convention) },
	{ "input", 'i', READ_POINTS,
	    "read points as text, csv, tsv, json, obj, f64, f32 or f32x4; default by "
	    "name or first line",
	    "FORMAT", option_read_format, OFFSET(in), .words = format_names,
	    .points_only = true },
	{ "output", 'o', ALL_BUT_HELP - COMMAND_DRAW,
	    "print in this format; the default for points is the format of the input",
	    "FORMAT", option_read_format, OFFSET(out), .words = format_names,
	    FLAG(has_out) },
	{ "separator", 0, READ_POINTS,
	    "separate fields of csv by this character, or by tab",
	    "C", .read = option_read_separator, FLAG(has_separator) },
	{ "header", 0, READ_POINTS, "take the first line for a header",
	    FLAG(header), .points_only = true },
	{ "no-header", 0, READ_POINTS, "take the first line for a row",
	    FLAG(no_header), .points_only = true },
	{ "columns", 0, READ_POINTS,
	    "find coordinates in these fields: 2,3,4, or names of a header or of JSON",
	    "LIST", .read = option_read_columns, .points_only = true },
	{ "decimals", 'd', PRINT_NUMBERS,
	    "print N decimals; for points a list may have one N for each coordinate",
	    "N,...", option_read_numbers, OFFSET(decimals), WHOLE(6, 0, 100),
	    .wanted = "a whole number from 0 to 100, or a list of up to six" },
	{ "digits", 0, PRINT_NUMBERS,
	    "print at most N significant digits; a list as for -d",
	    "N,...", option_read_numbers, OFFSET(digits), WHOLE(6, 1, 100),
	    .wanted = "a whole number from 1 to 100, or a list of up to six" },
	{ "precision", 'p', PRINT_IMAGES,
	    "compute points in exact (default), double or single arithmetic",
	    "NAME", option_read_word, OFFSET(precision), .words = precision_names },
	{ "tolerance", 't', COMMAND_INSPECT,
	    "name the cheapest precision whose error is at most T; default 0.5",
	    "T", option_read_numbers, OFFSET(tolerance), A_SIZE },
	{ "distances", 0, COMMAND_INSPECT,
	    "print depth_step also at these distances, from near to far",
	    "D,...", option_read_numbers, OFFSET(distances),
	    NUMBERS(1, NUMBER_LIST_MAX, "D,...", "--distances 10,1000") },
	{ "textbook", 0, COMMAND_INSPECT,
	    "print textbook_error: what programs get that work in float or double",
	    FLAG(textbook) },
	{ "from", 0, COMMAND_PROJECT | COMMAND_TRACE | COMMAND_DRAW,
	    "read points in this space: model, world, view, clip, ndc or "
	    "device; draw takes the first three",
	    "SPACE", option_read_word, OFFSET(from), .words = space_names,
	    .word_aliases = space_aliases, FLAG(has_from) },
	{ "to", 0, COMMAND_PROJECT,
	    "print points in this space; default device, or ndc without a viewport",
	    "SPACE", option_read_word, OFFSET(to), .words = space_names,
	    .word_aliases = space_aliases, FLAG(has_to) },
	{ "homogeneous", 'H', COMMAND_PROJECT, "print x y z w without division",
	    FLAG(homogeneous) },
	{ "matrix", 'm', COMMAND_MATRIX_3D | COMMAND_PROJECT | COMMAND_MATRIX_2D,
	    "print the matrix and read no points", FLAG(matrix) },
	{ "unit-w", 0, COMMAND_MATRIX_3D | COMMAND_PROJECT,
	    "divide the printed matrix so that the element from z to w is 1 or -1",
	    FLAG(unit_w) },
	{ "at", 0, COMMAND_PICK, "find points around this position on the device",
	    "X,Y", option_read_numbers, OFFSET(pick_at),
	    NUMBERS(2, 2, "X,Y", "--at 320,240") },
	{ "radius", 0, COMMAND_PICK, "find points within this radius, in device units",
	    "R", option_read_numbers, OFFSET(radius), A_SIZE },
	{ "ray", 0, COMMAND_PROJECT,
	    "read x y on the device; print a point of the ray, and its direction",
	    FLAG(ray) },
	{ "plane", 0, COMMAND_PROJECT,
	    "read x y; print where the ray meets a x + b y + c z + d = 0",
	    "A,B,C,D", option_read_numbers, OFFSET(plane),
	    NUMBERS(4, 4, "A,B,C,D of a x + b y + c z + d = 0",
	    "--plane 0,1,0,0 for y = 0") },
	{ "directions", 0, COMMAND_PROJECT,
	    "take directions, not points, among model, world and view: no translation",
	    FLAG(directions), .points_only = true },
	{ "append", 0, COMMAND_MATRIX_3D | COMMAND_PROJECT | COMMAND_MATRIX_2D,
	    "keep each line whole and add the image behind it",
	    FLAG(append), .points_only = true },
	{ "flags", 0, TAKE_FLAGS,
	    "add a word: in, or the planes that the point is outside of",
	    FLAG(flags), .points_only = true },
	{ "visible", 0, TAKE_FLAGS,
	    "print only points inside the view volume or window",
	    FLAG(visible), .points_only = true },
	{ "lines", 0, COMMAND_PROJECT | COMMAND_MATRIX_2D | COMMAND_DRAW,
	    "join points, and print the parts inside the view volume or window",
	    FLAG(lines), .points_only = true },
	{ "names", 0, COMMAND_DRAW,
	    "write the rest of a point's line beside its dot",
	    FLAG(names), .points_only = true },
	{ "background", 0, COMMAND_DRAW,
	    "put this PNG or JPEG file behind the picture, stretched to the viewport",
	    "FILE", .read = option_read_background },
	{ "text", 0, COMMAND_DRAW, "draw in Braille of 80 columns, as on a terminal",
	    FLAG(text) },
	{ "keep-going", 0, ALL_BUT_HELP,
	    "go on after a wrong scene or a bad line, whose image is nan",
	    FLAG(keep_going) },
	{ "jobs", 'j', READ_POINTS, "use N threads; default one for each processor",
	    "N", option_read_numbers, OFFSET(jobs), WHOLE(1, 1, 256),
	    .wanted = "a whole number from 1 to 256" },
	{ "progress", 0, READ_POINTS,
	    "report on standard error how many lines are done",
	    FLAG(progress) },
	{ "quiet", 'q', ALL_BUT_HELP,
	    "leave out notes, and how many points have no image", FLAG(quiet) },
	{ "scenes", 0, ALL_BUT_HELP,
	    "read any number of scenes from PARAMS, one after another",
	    FLAG(scenes) },
	{ "json", 0, COMMAND_HELP, "print all that the program knows of itself as JSON",
	    FLAG(json) },
	{ "errors", 0, COMMAND_ALL, "print messages as text (default) or json",
	    "FORM", option_read_word, .words = message_forms,
	    .global = &message_state.json },
	{ "color", 0, COMMAND_ALL,
	    "colour messages and help: auto (default), always or never",
	    "WHEN", option_read_word, .words = color_names,
	    .global = &message_state.color },
	{ "help", 'h', COMMAND_ALL, "print the help of the command", FLAG(help) },
	{ "version", 'V', COMMAND_ALL, "print the version", FLAG(version) },
	{ .name = NULL },
};
/* clang-format on */

_Static_assert(sizeof option_rows / sizeof *option_rows <= OPTIONS_MAX + 1,
    "OPTIONS_MAX is too small");

const struct option_row *option_find(const char *name)
{
	const size_t n = strcspn(name, "= ");

	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (strlen(r->name) == n && strncmp(r->name, name, n) == 0)
			return r;
	return NULL;
}

bool option_is_for(const struct option_row *r, const struct command *c)
{
	return r != NULL && c != NULL && (r->kinds & c->kind) != 0;
}
