/* SPDX-License-Identifier: MIT */
/* What makes a projection hard, from harmless to extreme. */
#ifndef REGIMES_H
#define REGIMES_H

#include "textbook.h"

/* Powers of ten, from harmless to extreme, and one beyond, or 0 for none. The power
 * of -400 is 0, and such a scene is one to refuse. */
struct sweep {
	int first, last, step, beyond;
};

struct regime {
	const char *name;
	const char *title;
	const char *swept; /* what the severity is */
	struct sweep sweep;
	void (*scene)(struct scene *, double severity);
	/* Places a point in view space, or a window's in its ndc. */
	void (*place)(const struct projection *, const struct map *clip,
	    double p[3]);
	bool back; /* from the device to the world */
	/* What the regime is there to show: in these ways, 1 << way, an image
	 * is somewhere lost or wrong by more than so many units. */
	unsigned broken;
	double units;
};

enum { REGIMES = 21 };

extern const struct regime regimes[REGIMES];

enum { ROWS = 40 };

void regime_scene(const struct regime *, double severity, struct scene *);

/* The severities of a regime; returns their number. */
int regime_sweep(const struct regime *, double severity[ROWS]);

#endif
