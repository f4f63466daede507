/* SPDX-License-Identifier: MIT */
#include "depth.h"

#include <math.h>

#include "../exact/vec3.h"

/* Depth is linear in 1/w, which is inverse[0] on the near and inverse[1] on the
 * far plane, times a common factor. With L the distance between them, a share d
 * of the depth range inward from plane a reaches
 *
 *	d L inverse[b] / (inverse[a] (1 - d) + inverse[b] d)
 *
 * from it, and span / under = L inverse[a] inverse[b] is finite where a plane
 * lies at infinity. */
struct slab {
	struct sum inverse[2];
	struct sum span, under;
};

/* c2 and c3 are cofactors of the inverse's last column, and 1/w = (c2 z + c3) / det
 * for ndc z on the axis through the device's middle. Distances run along the gradient
 * of w or, where w is constant, of z. */
static void slab_of(const struct scene *s, bool reversed, struct slab *r)
{
	double first = s->convention.minus_one ? -1 : 0;
	struct sum w[3], z[3];
	struct map m;

	/* whose reasons the scene has not, as it is not degenerate */
	projection_map(&s->projection, &s->convention, false, &m);
	for (int i = 0; i < 3; i++) {
		w[i] = m.m[i][3];
		z[i] = m.m[i][2];
	}
	bool parallel = vec3_is_zero(w);
	struct sum c2 = sum_neg(map_minor(3, m.m, 8, 4));
	struct sum c3 = map_minor(3, m.m, 8, 8), det = map_minor(4, m.m, 0, 0);

	for (int k = 0; k < 2; k++) {
		double depth = (k == 1) != reversed ? 1 : first;
		struct sum at = sum_add(c3, sum_scale(c2, depth));

		r->inverse[k] = sum_negated_if(sum_sign(det) < 0, at);
	}
	r->span = sum_scale(sum_abs(sum_mul(parallel ? c3 : c2, det)),
	    1 - first);
	r->under = vec3_length(parallel ? z : w);
}

/* The distance of a share over / under of the depth range, inward from plane
 * a. */
static double slab_distance(const struct slab *s, int a, struct sum over,
    struct sum under)
{
	struct sum at = sum_add(sum_mul(s->inverse[a], sum_sub(under, over)),
	    sum_mul(s->inverse[1 - a], over));

	if (sum_sign(s->span) == 0 || sum_sign(s->inverse[a]) <= 0 ||
	    sum_sign(at) <= 0)
		return (double)NAN;
	return sum_over_or_nan(sum_mul(over, s->span),
	    sum_mul(sum_mul(s->inverse[a], at), s->under));
}

/* The whole number nearest to z most, for z clamped to 0..1. The product and its rest
 * are exact. */
static double whole_nearest(double z, double most)
{
	double clamped = fmin(fmax(z, 0), 1), product = clamped * most;
	double rest = fma(clamped, most, -product);
	double whole = floor(product), beyond = (product - whole - 0.5) + rest;

	if (beyond > 0 || (beyond == 0 && fmod(whole, 2) != 0))
		whole++;
	return whole;
}

/* Where from z towards other the stored value changes, as a quotient: halfway
 * to the next one. False where it does not. */
static bool whole_boundary(double z, double other, double most,
    struct sum *over, struct sum *under)
{
	double k = whole_nearest(z, most);

	*over = sum_of_double(2 * k + (other > z ? 1 : -1));
	*under = sum_of_double(2 * most);
	return whole_nearest(other, most) != k;
}

/* Beyond the largest float the next is 2^128, which is stored as infinity. */
static double float_value(float a)
{
	return isinf(a) ? copysign(0x1p128, (double)a) : (double)a;
}

static bool float_boundary(double z, double other, struct sum *over,
    struct sum *under)
{
	float f = (float)z, end = (float)other;

	*over = sum_of_double(
	    (float_value(f) + float_value(nextafterf(f, end))) / 2);
	*under = sum_of_double(1);
	return f != end;
}

void depth_steps(const struct scene *s, bool reversed, double step[BUFFERS][2])
{
	double z[2] = { 0, 1 };
	struct slab slab;

	if (s->has_viewport) {
		z[0] = s->viewport.min_z;
		z[1] = s->viewport.max_z;
	}
	slab_of(s, reversed, &slab);
	for (int b = 0; b < BUFFERS; b++)
		for (int k = 0; k < 2; k++) {
			double from = z[k ^ reversed], to = z[!(k ^ reversed)];
			struct sum over, under;
			bool any = b == BUFFER_FLOAT32 ?
			    float_boundary(from, to, &over, &under) :
			    whole_boundary(from, to,
				b == BUFFER_UNORM16 ? 0xffff : 0xffffff, &over,
				&under);

			step[b][k] = (double)NAN;
			if (!any || projection_is_open(&s->projection))
				continue;
			over = sum_abs(sum_sub(over, sum_scale(under, from)));
			step[b][k] = slab_distance(&slab, k, over,
			    sum_mul(under, sum_abs(sum_diff(to, from))));
		}
}
