/* SPDX-License-Identifier: MIT */
#include "textbook.h"

#include <math.h>
#include <string.h>

#include "../test/truth.h"

/* Replaces the upper 3x3 part by its nearest rotation, as the member
 * orthonormalize does. */
static void nearest_rotation(double m[4][4])
{
	struct camera c = { .way = CAMERA_MATRIX, .orthonormalize = true };
	const struct convention any = { 0 };
	struct map r;

	memcpy(c.steps.matrix, m, sizeof c.steps.matrix);
	if (!camera_map(&c, &any, false, &r, NULL))
		return;
	for (int i = 0; i < 9; i++)
		m[i / 3][i % 3] = element(&r, i / 3, i % 3);
}

#define REAL float
#define SQRT sqrtf
#define SIN sinf
#define COS cosf
#define TAN tanf
#define NAME(x) single_##x
#include "textbook_body.h"
#undef REAL
#undef SQRT
#undef SIN
#undef COS
#undef TAN
#undef NAME

#define REAL double
#define SQRT sqrt
#define SIN sin
#define COS cos
#define TAN tan
#define NAME(x) double_##x
#include "textbook_body.h"

void naive_carry(const struct scene *s, enum way way, bool back, double (*in)[3],
    double (*out)[4], size_t n)
{
	if (way == SINGLE)
		single_carry(s, way, back, in, out, n);
	else
		double_carry(s, way, back, in, out, n);
}
