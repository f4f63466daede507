/* SPDX-License-Identifier: MIT */
/* Regimes: scenes with one number that makes them hard to compute, from harmless to
 * extreme values. */
#pragma once

#include "textbook.h"

/* The powers of ten that a regime tries: from first to last by step, and then beyond,
 * unless that is 0. 10^-400 is 0, which makes a scene that is refused. */
struct sweep {
	int first, last, step, beyond;
};

struct regime {
	const char *name;
	const char *title;
	const char *swept; /* the number of the scene that varies */
	struct sweep sweep;
	void (*scene)(struct scene *, double severity);
	/* Places a point in view space, or in the ndc of a 2D window. */
	void (*place)(const struct projection *, const struct map *clip, double p[3]);
	bool back; /* from the device to the world */
	/* The regime shows that the ways with the bit 1 << way lose some image, or have
	 * an error of more than so many units. */
	unsigned broken;
	double units;
};

enum { REGIMES = 21 };

extern const struct regime regimes[REGIMES];

enum { ROWS = 40 };

void regime_scene(const struct regime *, double severity, struct scene *);

/* Sets severity to the values of a regime, and returns how many there are. */
int regime_sweep(const struct regime *, double severity[ROWS]);
