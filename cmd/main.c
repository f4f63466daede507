#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "nearest.h"
#include "options.h"
#include "talk.h"

#define VERSION "0.1.0"

#define MATRIX_OPTIONS "ciodDCptmKjP"

/* clang-format off */
/* from and to are the spaces of the matrix; points go to points_to. */
static const struct command commands[] = {
	{ "lookat", run_matrix, MATRIX_OPTIONS, "world to view matrix",
	    false, SPACE_WORLD, SPACE_VIEW, SPACE_VIEW,
	    SCENE_CAMERA, SCENE_CAMERA, -1 },
	{ "persp", run_matrix, MATRIX_OPTIONS,
	    "view to clip matrix of a perspective",
	    false, SPACE_VIEW, SPACE_CLIP, SPACE_NDC,
	    SCENE_PROJECTION, SCENE_PROJECTION, PROJECTION_PERSP },
	{ "ortho", run_matrix, MATRIX_OPTIONS,
	    "view to clip matrix of an orthographic projection",
	    false, SPACE_VIEW, SPACE_CLIP, SPACE_NDC,
	    SCENE_PROJECTION, SCENE_PROJECTION, PROJECTION_ORTHO },
	{ "oblique", run_matrix, MATRIX_OPTIONS,
	    "view to clip matrix of an oblique projection",
	    false, SPACE_VIEW, SPACE_CLIP, SPACE_NDC,
	    SCENE_PROJECTION, SCENE_PROJECTION, PROJECTION_OBLIQUE },
	{ "w2n", run_matrix, MATRIX_OPTIONS, "2D window to NDC matrix",
	    true, FLAT_WINDOW, FLAT_NDC, FLAT_NDC,
	    SCENE_WINDOW, SCENE_WINDOW, -1 },
	{ "n2d", run_matrix, MATRIX_OPTIONS, "2D NDC to device matrix",
	    true, FLAT_NDC, FLAT_DEVICE, FLAT_DEVICE,
	    SCENE_DEVICE, SCENE_DEVICE, -1 },
	{ "w2d", run_matrix, MATRIX_OPTIONS, "2D window to device matrix",
	    true, FLAT_WINDOW, FLAT_DEVICE, FLAT_DEVICE,
	    0, SCENE_WINDOW | SCENE_DEVICE, -1 },
	{ "d2w", run_matrix, MATRIX_OPTIONS, "2D device to window matrix",
	    true, FLAT_DEVICE, FLAT_WINDOW, FLAT_WINDOW,
	    0, SCENE_WINDOW | SCENE_DEVICE, -1 },
	{ "volume", run_matrix, MATRIX_OPTIONS,
	    "view to clip matrix of the seven-parameter view volume",
	    false, SPACE_VIEW, SPACE_CLIP, SPACE_NDC,
	    SCENE_PROJECTION, SCENE_PROJECTION, PROJECTION_VOLUME },
	{ "project", run_project, MATRIX_OPTIONS "FTHRGI",
	    "points from any space to any other", .projection = -1 },
	{ "pick", run_pick, "cioCdDjKAQP",
	    "points within a radius of a device position, nearest first",
	    .projection = -1 },
	{ "fit", run_fit, "ciCKjP",
	    "a scene completed to hold bounds or points and no more",
	    .needed = SCENE_PROJECTION, .projection = -1 },
	{ "inspect", run_inspect, "cdDt",
	    "what the projection is, its angles, corners and error bounds",
	    .projection = -1 },
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
	    c->name, c->run == run_inspect ? "" : " [POINTS...]", c->about);
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

int main(int argc, char **argv)
{
	struct options o = { .params = "-" };
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
	const struct command *c = find_command(name);

	switch (options_read(c, argc - 1, argv + 1, &o)) {
	case 'h':
		help_command(c);
	case 'V':
		version();
	}
	return c->run(c, &o);
}
