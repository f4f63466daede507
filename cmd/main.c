#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "nearest.h"
#include "operands.h"
#include "params.h"
#include "points/answer.h"
#include "stack.h"
#include "talk.h"

#define VERSION "0.3.0"

/* clang-format off */

/* A command for one type of projection. A viewport may give the aspect. */
#define VIEW_TO_CLIP(type)                                                 \
	MATRIX, run_matrix,                                                \
	.wants = { .bare = SCENE_PROJECTION, .needed = SCENE_PROJECTION,   \
	    .used = SCENE_PROJECTION | SCENE_VIEWPORT | SCENE_POINTS,      \
	    .projection = type },                                          \
	.from = SPACE_VIEW, .to = SPACE_CLIP, .points_to = SPACE_NDC

static const struct command commands[] = {
	{ "lookat", "world to view matrix", MATRIX, run_matrix,
	    .wants = { .bare = SCENE_CAMERA, .needed = SCENE_CAMERA,
		.used = SCENE_CAMERA | SCENE_POINTS },
	    .from = SPACE_WORLD, .to = SPACE_VIEW, .points_to = SPACE_VIEW },
	{ "persp", "view to clip matrix of a perspective",
	    VIEW_TO_CLIP(PROJECTION_PERSP) },
	{ "ortho", "view to clip matrix of an orthographic projection",
	    VIEW_TO_CLIP(PROJECTION_ORTHO) },
	{ "oblique", "view to clip matrix of an oblique projection",
	    VIEW_TO_CLIP(PROJECTION_OBLIQUE) },
	/* a window may adapt to the device, where there is one */
	{ "w2n", "2D window to NDC matrix", MATRIX, run_matrix,
	    .wants = { .bare = SCENE_WINDOW, .needed = SCENE_WINDOW,
		.used = SCENE_WINDOW | SCENE_DEVICE | SCENE_POINTS },
	    .flat = true, .from = FLAT_WINDOW, .to = FLAT_NDC,
	    .points_to = FLAT_NDC },
	{ "n2d", "2D NDC to device matrix", MATRIX, run_matrix,
	    .wants = { .bare = SCENE_DEVICE, .needed = SCENE_DEVICE,
		.used = SCENE_DEVICE | SCENE_POINTS },
	    .flat = true, .from = FLAT_NDC, .to = FLAT_DEVICE,
	    .points_to = FLAT_DEVICE },
	{ "w2d", "2D window to device matrix", MATRIX, run_matrix,
	    .wants = { .needed = SCENE_WINDOW | SCENE_DEVICE,
		.used = SCENE_WINDOW | SCENE_DEVICE | SCENE_POINTS },
	    .flat = true, .from = FLAT_WINDOW, .to = FLAT_DEVICE,
	    .points_to = FLAT_DEVICE },
	{ "d2w", "2D device to window matrix", MATRIX, run_matrix,
	    .wants = { .needed = SCENE_WINDOW | SCENE_DEVICE,
		.used = SCENE_WINDOW | SCENE_DEVICE | SCENE_POINTS },
	    .flat = true, .from = FLAT_DEVICE, .to = FLAT_WINDOW,
	    .points_to = FLAT_WINDOW },
	{ "volume", "view to clip matrix of the seven-parameter view volume",
	    VIEW_TO_CLIP(PROJECTION_VOLUME) },
	{ "project", "points from any space to any other",
	    PROJECT, run_project,
	    .wants = { .used = SCENE_SPATIAL | SCENE_POINTS } },
	{ "trace", "where points are in every space, and what they are outside of",
	    TRACE, run_trace,
	    .wants = { .used = SCENE_SPATIAL | SCENE_POINTS } },
	{ "pick", "points within a radius of a device position, nearest first",
	    PICK, run_pick,
	    .wants = { .used = SCENE_SPATIAL | SCENE_POINTS | SCENE_PICK } },
	{ "fit", "a scene completed to hold bounds or points and no more",
	    FIT, run_fit,
	    .wants = { .needed = SCENE_PROJECTION, .fit = true,
		.used = SCENE_SPATIAL | SCENE_POINTS | SCENE_BOUNDS |
		    SCENE_MARGIN } },
	{ "inspect",
	    "what the projection is, its angles, corners and error bounds",
	    INSPECT, run_inspect,
	    .wants = { .used = SCENE_SPATIAL } },
};
/* clang-format on */

enum { COMMANDS = sizeof commands / sizeof *commands };

static _Noreturn void finish_help(void)
{
	if (fflush(stdout) != 0)
		die(EXIT_SYSTEM, "standard output: %s", strerror(errno));
	close_output();
	exit(EXIT_OK);
}

static _Noreturn void version(void)
{
	puts("projcalc " VERSION);
	finish_help();
}

static _Noreturn void help_command(const struct command *c)
{
	printf("usage: projcalc %s [OPTION...] [PARAMS%s]\n"
	       "%s\n\n",
	    c->name, command_reads_points(c) ? " [POINTS...]" : "", c->about);
	options_print(c);
	finish_help();
}

static _Noreturn void help(void)
{
	printf("usage: projcalc COMMAND [OPTION...] [PARAMS [POINTS...]]\n\n");
	for (int i = 0; i < COMMANDS; i++)
		printf("  %-10s %s\n", commands[i].name, commands[i].about);
	printf("\nPARAMS is a JSON file, - for standard input (default), or "
	       "'{...}'.\nPOINTS are files, -, or '[0,0,0]'.\n"
	       "See projcalc help COMMAND and man projcalc.\n");
	finish_help();
}

static const struct command *find_command(const char *name)
{
	const char *names[COMMANDS + 2] = { [COMMANDS] = "help" };

	for (int i = 0; i < COMMANDS; i++) {
		names[i] = commands[i].name;
		if (strcmp(name, names[i]) == 0)
			return &commands[i];
	}
	const char *near = nearest(name, names);

	if (near != NULL)
		die(EXIT_USAGE, "unknown command '%s'; did you mean '%s'?",
		    name, near);
	die(EXIT_USAGE, "unknown command '%s'; 'projcalc help' lists them",
	    name);
}

struct call {
	const struct command *command;
	struct options options;
};

static void run_scenes(void *with)
{
	struct call *call = with;

	while (params_next(&call->options))
		call->command->run(call->command, &call->options);
}

int main(int argc, char **argv)
{
	struct call call = { .options = { .params = "-" } };
	struct options *o = &call.options;
	const char *name = argc > 1 ? argv[1] : "help";

	if (argc < 2)
		die(EXIT_USAGE, "no command; 'projcalc help' lists them");
	if (strcmp(name, "--version") == 0)
		version();
	if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 ||
	    (strcmp(name, "help") == 0 && argc == 2))
		help();
	if (strcmp(name, "help") == 0)
		help_command(find_command(argv[2]));
	const struct command *c = call.command = find_command(name);

	options_read(c, argc - 1, argv + 1, o);
	if (o->help)
		help_command(c);
	if (o->version)
		version();
	check_operands(c, o);
	call_with_stack(run_scenes, &call);
	return answer_end();
}
