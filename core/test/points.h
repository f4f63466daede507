/* SPDX-License-Identifier: MIT */
/* Blocks of points for tests, and their exact images. */
#ifndef BLOCK_H
#define BLOCK_H

#include "../points/transform.h"
#include "sample.h"
#include "truth.h"

enum { POINTS = 24 };

/* A block of points with its images. */
struct block {
	double in[4][POINTS_BLOCK], out[4][POINTS_BLOCK];
};

static const char *const copies[] = { "baseline", "avx2", "avx512", "neon" };

enum { COPIES = sizeof copies / sizeof *copies };

void map_block(const struct transform *, enum precision, struct block *,
    size_t n);

/* Transforms n points of a block exactly. */
void map_block_exactly(const struct transform *, struct block *, size_t n);

void block_point(const struct block *, size_t i, double p[4]);

/* Samples points about the target of the camera, some of them far, in its plane, or
 * equal to the eye. */
void sample_points(const struct scene *, enum space from, struct block *,
    size_t n);

/* Samples whole numbers times powers of two far from one another: large ones often
 * cancel. */
void sample_round_points(struct block *, size_t n);

/* Samples a transform of a scene between any two spaces, of any format, flat ones too,
 * and its truth; of round numbers if e is negative. Returns false if it is refused. */
bool sample_transform(int e, struct scene *, enum space *from,
    struct transform *, struct truth *);

/* The image of a point before the division: n[j] / d. */
struct image {
	struct sized n[4], d;
	bool seen;     /* there is one */
	bool doubtful; /* within the rule it may be the other way round */
};

void image_of(const struct truth *, const struct transform *, const double p[4],
    struct image *);

/* Counts of coordinates by their verdict. */
struct tally {
	size_t n[VERDICTS];
};

/* Judges an image; it must be nan if there is none. */
void judge_image(const struct image *, int coordinates, const double *got,
    bool single, struct tally *);

/* Judges the images of a block, or the floats as which they are printed; sets which
 * points are wrong. */
void judge_block(const struct truth *, const struct transform *,
    const struct block *, size_t n, bool single, struct tally *);

#endif
