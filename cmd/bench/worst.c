/* SPDX-License-Identifier: MIT */
/* Prints the worst error of a program's images of points, against MPFR.
 *
 * usage: worst SPACE FORMAT POINTS FORMAT IMAGES
 *        of the bench's view, from the world to SPACE, view or device; FORMAT is
 *        text, f64 or f32. Prints the error in units of that space, inf if there
 *        are fewer images than points. */
#include <stdio.h>

#include "view.h"

/* Reads the next point; in text, it is the first three numbers of a line. */
static bool get(FILE *f, const char *format, double p[3])
{
	char line[1024];
	float singles[3];

	if (strcmp(format, "text") == 0)
		return fgets(line, sizeof line, f) != NULL &&
		    sscanf(line, "%lf %lf %lf", &p[0], &p[1], &p[2]) == 3;
	if (strcmp(format, "f64") == 0)
		return fread(p, sizeof *p, 3, f) == 3;
	if (fread(singles, sizeof *singles, 3, f) != 3)
		return false;
	for (int k = 0; k < 3; k++)
		p[k] = (double)singles[k];
	return true;
}

int main(int argc, char **argv)
{
	FILE *points = argc == 6 ? fopen(argv[3], "r") : NULL;
	FILE *images = argc == 6 ? fopen(argv[5], "r") : NULL;

	if (points == NULL || images == NULL) {
		fputs("usage: worst SPACE FORMAT POINTS FORMAT IMAGES\n", stderr);
		return 2;
	}
	struct scene s = scene_of(&bench_view);
	struct truth truth = { 0 };
	double worst = 0, p[3], image[3];

	truth_scene(&s, SPACE_WORLD,
	    strcmp(argv[1], "view") == 0 ? SPACE_VIEW : SPACE_DEVICE, &truth);
	while (get(points, argv[2], p)) {
		if (!get(images, argv[4], image))
			worst = HUGE_VAL;
		worst = fmax(worst, error_of(&truth, p, image));
	}
	printf("%.1e\n", worst);
	return 0;
}
