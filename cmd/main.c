/* SPDX-License-Identifier: MIT */
#include <fenv.h>
#include <string.h>
#include <unistd.h>

#include "call/input.h"
#include "call/operands.h"
#include "call/unknown.h"
#include "help.h"
#include "message/message.h"

#define VERSION "2.0.0"

/* clang-format off */

#define DEVICE_EXAMPLE "{\"width\": 300, \"height\": 300}"
#define FLAT_EXAMPLE "'{\"window\": " WINDOW_EXAMPLE                       \
	", \"device\": " DEVICE_EXAMPLE "}'"

/* The command needs one member, which may be the whole document, and uses others. */
#define NEEDS_ONE(member, others)                                          \
	.lone_member = SCENE_##member, .needed = SCENE_##member,           \
	.used = SCENE_##member | SCENE_POINTS | (others)

/* The command is for one type of projection. A viewport may determine its aspect. */
#define VIEW_TO_CLIP(type)                                                 \
	COMMAND_MATRIX_3D, &matrix_work,                                   \
	.wants = { NEEDS_ONE(PROJECTION, SCENE_VIEWPORT),                  \
	    .source.implied_type = type },                                 \
	.from = SPACE_VIEW, .to = SPACE_CLIP

/* A window adapts to the device if the document has a device. */
#define NEEDS_WINDOW NEEDS_ONE(WINDOW, SCENE_DEVICE)
#define NEEDS_DEVICE NEEDS_ONE(DEVICE, 0)
#define NEEDS_BOTH                                                         \
	.needed = SCENE_WINDOW | SCENE_DEVICE,                             \
	.used = SCENE_WINDOW | SCENE_DEVICE | SCENE_POINTS

#define THE_WINDOW "the window"
#define THE_NDC "ndc"
#define THE_DEVICE "the device"
#define FLAT_MAP(name, a, b, members, call)                                \
	{ name, "take 2D points from " THE_##a " to " THE_##b              \
		", or print the matrix",                                   \
	    COMMAND_MATRIX_2D, &matrix_work,                               \
	    .wants = { NEEDS_##members },                                  \
	    .from = FLAT_##a, .to = FLAT_##b, .example = call }

static const struct command commands[] = {
	{ "lookat", "print the matrix from world to view",
	    COMMAND_MATRIX_3D, &matrix_work,
	    .wants = { NEEDS_ONE(CAMERA, 0) },
	    .from = SPACE_WORLD, .to = SPACE_VIEW,
	    .example = "-c d3d '{\"eye\": [0,0,-5], \"at\": [0,0,0]}'" },
	{ "persp", "print the matrix from view to clip of a perspective",
	    VIEW_TO_CLIP(PROJECTION_PERSP),
	    .example = "-c gl '{\"fovy\": 60, \"aspect\": 1.5, \"near\": 1, "
	    "\"far\": 10}'" },
	{ "ortho", "print the matrix from view to clip of an orthographic projection",
	    VIEW_TO_CLIP(PROJECTION_ORTHO),
	    .example = "-c d3d '{\"height\": 2, \"aspect\": 1.5, \"near\": 0, "
		       "\"far\": 10}'" },
	{ "oblique", "print the matrix from view to clip of an oblique projection",
	    VIEW_TO_CLIP(PROJECTION_OBLIQUE),
	    .example = "-c d3d '{\"kind\": \"cabinet\", \"width\": 3, \"height\": 2, "
	    "\"near\": 0, \"far\": 10}'" },
	FLAT_MAP("w2n", WINDOW, NDC, WINDOW, "'" WINDOW_EXAMPLE "' '[22,32]'"),
	FLAT_MAP("n2w", NDC, WINDOW, WINDOW, "'" WINDOW_EXAMPLE "' '[0.5,0.5]'"),
	FLAT_MAP("n2d", NDC, DEVICE, DEVICE, "'" DEVICE_EXAMPLE "' '[0.5,0.5]'"),
	FLAT_MAP("d2n", DEVICE, NDC, DEVICE, "'" DEVICE_EXAMPLE "' '[210,90]'"),
	FLAT_MAP("w2d", WINDOW, DEVICE, BOTH, FLAT_EXAMPLE " '[22,32]'"),
	FLAT_MAP("d2w", DEVICE, WINDOW, BOTH, FLAT_EXAMPLE " '[210,210]'"),
	{ "volume",
	    "print the matrix from view to clip of a view volume of seven numbers",
	    VIEW_TO_CLIP(PROJECTION_VOLUME),
	    .example = "-c d3d '{\"size\": 2, \"aspect\": 1.5, \"view_angle\": 60, "
	    "\"z_near\": 1, \"z_far\": 10}'" },
	{ "project", "take points from any space to any other: to pixels, or back",
	    COMMAND_PROJECT, &project_work,
	    .wants = { .used = SCENE_SPATIAL | SCENE_POINTS },
	    .example = "-c d3d '" SCENE_EXAMPLE "' '[[0,0,0], [1,1,1]]'" },
	{ "trace",
	    "print points in every space, and the planes that they are outside of",
	    COMMAND_TRACE, &trace_work,
	    .wants = { .used = SCENE_SPATIAL | SCENE_POINTS },
	    .example = "-c d3d '" SCENE_EXAMPLE "' '[1,1,1]'" },
	{ "pick",
	    "print the points within a radius of a device position, nearest first",
	    COMMAND_PICK, &pick_work,
	    .wants = { .needed = SCENE_VIEWPORT,
		.used = SCENE_SPATIAL | SCENE_POINTS | SCENE_PICK },
	    .example = "-c d3d --at 320,240 --radius 3 '" SCENE_EXAMPLE
		"' '[[0,0,0], [1,1,1]]'" },
	{ "fit", "print the scene with a camera that holds bounds or points tightly",
	    COMMAND_FIT, &fit_work,
	    .wants = { .needed = SCENE_PROJECTION, .source.task = TASK_FIT,
		.flat_members = SCENE_WINDOW | SCENE_DEVICE,
		.used = SCENE_SPATIAL | SCENE_POINTS | SCENE_BOUNDS |
		    SCENE_MARGIN },
	    .example = "-c d3d '{\"projection\": {\"type\": \"persp\", \"fovy\": 60, "
		"\"aspect\": 1.5}}' '[[-1,-1,-1], [1,1,1]]'" },
	{ "draw",
	    "draw points, lines and OBJ files: SVG or, on a terminal, Braille",
	    COMMAND_DRAW, &draw_work,
	    .wants = { .needed = SCENE_VIEWPORT,
		.flat_members = SCENE_WINDOW | SCENE_DEVICE,
		.used = SCENE_SPATIAL | SCENE_POINTS },
	    .example = "-c d3d --text '" SCENE_EXAMPLE "' '[[0,0,0], [1,1,1]]'" },
	{ "inspect",
	    "describe the projection or 2D window: angles, edges, error bounds",
	    COMMAND_INSPECT, &inspect_work,
	    .wants = { .flat_members = SCENE_WINDOW,
		.used = SCENE_SPATIAL | SCENE_BOUNDS },
	    .example = "-c d3d '" SCENE_EXAMPLE "'" },
	{ "help", "describe a command, or a member of the scene", COMMAND_HELP,
	    .example = "camera" },
	{ .name = NULL },
};
/* clang-format on */

static const struct command *find_command(const char *name)
{
	for (const struct command *c = commands; c->name != NULL; c++)
		if (strcmp(name, c->name) == 0)
			return c;
	return NULL;
}

static void run_help(const struct options *o)
{
	const char *what = o->params;
	const struct command *c = find_command(what);

	if (o->n_points > 0 || (o->json && !input_is_stdin(what)))
		die(EXIT_USAGE,
		    text("help: '%s' is one word too many",
			o->n_points > 0 ? o->points[0] : what),
		    "give one command or member");
	if (o->json)
		help_json(commands, VERSION);
	else if (input_is_stdin(what))
		help_all(commands);
	else if (c != NULL)
		help_command(c);
	else if (!help_member(what))
		unknown_refuse_command(commands, true, what);
}

/* Answers one document, and returns false if it is refused, which *answered may
 * precede. */
static bool run_scene(const struct options *o, struct document *d, struct job *j,
    struct refusals *faults, bool *answered)
{
	faults->n = 0;
	ex_has_overflowed(); /* forgets what a refused scene has left */
	*answered = params_read_document(o, d, faults) &&
	    o->command->work->run(o, d, j);
	if (!*answered && !d->ends_run)
		o->command->work->judge(o, d);
	if (!*answered)
		return false;
	return !ex_has_overflowed() ||
	    document_refuse(d, NULL, "what is printed is not exact: " SCENE_TOO_WIDE,
		SCENE_TOO_WIDE_REMEDY);
}

/* Returns EXIT_OK, or the exit status of a refusal that ends the run. */
static int run_scenes(const struct options *o)
{
	static struct refusals faults;
	static struct job j;
	struct document d;
	bool answered;
	const enum format out = options_out_format(o);
	const bool skips = o->scenes && o->keep_going && !format_is_binary(out);

	if (o->scenes)
		output_gather();
	while (params_next_document(o)) {
		if (run_scene(o, &d, &j, &faults, &answered))
			continue;
		const int status = d.is_usage && (!skips || d.ends_run) ? EXIT_USAGE :
									  EXIT_INPUT;

		document_tell(&d.source, status);
		if (!skips || d.ends_run)
			return status;
		answer_refused_scene(!answered && out == FORMAT_JSON);
	}
	return EXIT_OK;
}

int main(int argc, char **argv)
{
	struct options o = { .params = "-", .in = FORMAT_SNIFF, .separator = ',' };
	int status = EXIT_OK;

	/* undoes the startup code of -ffast-math, which flushes subnormals */
	fesetenv(FE_DFL_ENV);
	options_read_first(argv + 1);
	if (argc < 2) {
		dup2(STDERR_FILENO, STDOUT_FILENO);
		help_all(commands);
		output_close();
		return EXIT_USAGE;
	}
	if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
		argv[1] = "help";
	const struct command *c = o.command = find_command(argv[1]);

	o.version = strcmp(argv[1], "--version") == 0 || strcmp(argv[1], "-V") == 0;
	if (c == NULL && !o.version)
		unknown_refuse_command(commands, false, argv[1]);
	if (c != NULL)
		options_read(&o, argv + 2);
	message_state.quiet = o.quiet;
	if (o.version) {
		output_printf("projcalc " VERSION "\n");
	} else if (o.help) {
		help_command(c);
	} else if (c->kind == COMMAND_HELP) {
		run_help(&o);
	} else {
		if (c->work->check != NULL)
			c->work->check(&o);
		operands_check(&o);
		status = run_scenes(&o);
		if (c->work->finish != NULL)
			c->work->finish();
	}
	return answer_end(status);
}
