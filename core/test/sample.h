/* SPDX-License-Identifier: MIT */
/* Random parameters for tests, the same in every run. With e = 0 the numbers are
 * ordinary: what people write, among them small whole numbers. With e > 0 they are
 * hostile: magnitudes are mixed, from 10^-e to 10^e, cameras are far from the origin,
 * and scenes are nearly degenerate. */
#pragma once

#include "../scene/scene.h"

/* Begins the stream of random numbers that belongs to a seed. */
void sample_seed(unsigned seed);

/* Runs the statement that follows for i from 0 to tries - 1, divided among SEEDS seeds.
 * They begin with the SEED of the environment, or 1. Each sample has a stream of its
 * own, so that SEED=5 repeats first what another run did with the seed 5. */
#define SAMPLES(i, tries) for (int i = 0; sample_begin(i, tries); i++)
enum { SEEDS = 8 };
bool sample_begin(int i, int tries);

/* Returns the seed and the number of the present sample, and what was sampled last; or
 * an empty string outside of SAMPLES. */
const char *sample_name(void);

/* Makes sample_name tell of a projection whose type was changed. */
void sample_remember(const struct projection *);

unsigned sample_below(unsigned n);
double sample_unit(void); /* in [0, 1) */
double sample_between(double a, double b);
double sample_size(int e);   /* positive, from 10^-e to 10^e */
double sample_number(int e); /* of either sign, or 0 */

void sample_convention(struct convention *);
void sample_camera(struct camera *, int e);
void sample_orthonormalize(struct camera *, int e);
void sample_affine(double m[4][4], int e);
void sample_steps(struct step *, int n, int e); /* n steps of all kinds */
void sample_projection(struct projection *, int e);
void sample_viewport(struct viewport *, int e);
void sample_flat(struct window *, struct device *, int e);
void sample_scene(struct scene *, int e);

/* Sets the convention of the answer to another one, or to none. */
void sample_answer(struct scene *);

/* Samples a scene of numbers with few digits in which no angle and no length occurs, so
 * that all elements of its maps are rational. */
void sample_round_scene(struct scene *);
