/* SPDX-License-Identifier: MIT */
/* Blocks of points for tests, and their exact images. */
#pragma once

#include "../points/point.h"
#include "../points/points.h"
#include "sample.h"
#include "truth.h"

enum { POINTS = 24 };

/* A block of points with its images. */
struct block {
	double in[4][POINTS_BLOCK], out[4][POINTS_BLOCK];
};

/* The names of the copies of the kernels, each for a kind of processor. */
static const char *const copies[] = { "baseline", "avx2", "avx512", "neon" };

enum { COPIES = sizeof copies / sizeof *copies };

/* Sets out to the images of n points of in. */
void map_block(const struct transform *, enum precision, struct block *, size_t n);

/* Calls map_block with PRECISION_EXACT. */
void map_block_exactly(const struct transform *, struct block *, size_t n);

void block_point(const struct block *, size_t i, double p[4]);

/* Samples coordinates: from -1 to 2 in ndc and on the device, else with magnitudes from
 * 0.1 to 10 or, one in four, from 1e-6 to 1e6. One in six is a whole number. In model
 * and world space they are relative to the eye. */
void sample_points(const struct scene *, enum space from, struct block *, size_t n);

/* Samples whole numbers times 2^-300, 1 or 2^300. In sums of products the large terms
 * often cancel. */
void sample_round_points(struct block *, size_t n);

/* Samples a scene by sample_scene with e, or by sample_round_scene if e is negative,
 * and the transform between two of its spaces or flat spaces, with its truth. Returns
 * false if the transform is refused. */
bool sample_transform(int e, struct scene *, enum space *from, struct transform *,
    struct truth *);

/* A point's image before the division: coordinate j is n[j] / d. */
struct image {
	struct sized n[4], d;
	bool exists;   /* false on the eye plane, and behind it if transform.front */
	bool doubtful; /* d is within TRUTH_TOLERANCE of 0, so exists may be wrong */
};

void image_of(const struct truth *, const struct transform *, const double p[4],
    struct image *);

/* The number of coordinates of each verdict. */
struct tally {
	size_t n[VERDICTS];
};

/* Judges the coordinates of a computed image, which must be nan if exists is false. */
void judge_image(const struct image *, int coordinates, const double *got, bool single,
    struct tally *);

/* Judges the images of a block; if single is true, their nearest floats. */
void judge_block(const struct truth *, const struct transform *, const struct block *,
    size_t n, bool single, struct tally *);
