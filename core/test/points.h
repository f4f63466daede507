/* Blocks of points for tests, and their exact images. */
#ifndef BLOCK_H
#define BLOCK_H

#include <math.h>

#include "../points.h"
#include "sample.h"
#include "truth.h"

enum { POINTS = 24 };

/* A block of points with its images. */
struct block {
	double in[4][POINTS_BLOCK], out[4][POINTS_BLOCK];
	bool single[POINTS_BLOCK];
};

static inline void carry(const struct transform *t, struct accuracy e,
    struct block *b, size_t n)
{
	const double *const in[4] = { b->in[0], b->in[1], b->in[2], b->in[3] };
	double *const out[4] = { b->out[0], b->out[1], b->out[2], b->out[3] };

	points_carry(t, &e, in, out, b->single, n);
}

/* Points about what the camera looks at, some of them far, in its plane, or
 * equal to the eye. */
static inline void sample_points(const struct scene *s, enum space from,
    struct block *b, size_t n)
{
	for (size_t i = 0; i < n; i++)
		for (int j = 0; j < 4; j++) {
			double near = from <= SPACE_WORLD && s->has_camera &&
				s->camera.by != CAMERA_MATRIX && j < 3 ?
			    s->camera.eye[j] :
			    0;
			double d = sample_number(sample_below(4) == 0 ? 6 : 1);

			if (from >= SPACE_NDC)
				d = sample_between(-1, 2);
			if (sample_below(6) == 0)
				d = rint(d);
			b->in[j][i] = near + d;
		}
}

/* The exact image of point i, divided where it is. Returns false where there
 * is none: w is not positive, or lost in its bound. */
static inline bool exact_image(const struct truth *truth,
    const struct transform *t, const struct block *b, size_t i, real q[4],
    real sum[4])
{
	double p[4] = { b->in[0][i], b->in[1][i], b->in[2][i],
		t->in == 4 ? b->in[3][i] : 1 };

	truth_image(truth, p, q, sum);
	if (!t->divide)
		return true;
	double w = mpfr_get_d(over(q[3], sum[3]), MPFR_RNDN);

	return t->front ? w > 0x1p-90 : fabs(w) > 0x1p-90;
}

#endif
