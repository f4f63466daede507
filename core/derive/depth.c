/* SPDX-License-Identifier: MIT */
#include "depth.h"

/* Depth is linear in 1/w, which is inverse[0] on the near and inverse[1] on the
 * far plane, times a common factor. With L the distance between them, a share d
 * of the depth range inward from plane a reaches
 *
 *	d L inverse[b] / (inverse[a] (1 - d) + inverse[b] d)
 *
 * from it, and span / under = L inverse[a] inverse[b] is finite where a plane
 * lies at infinity. */
struct slab {
	ex inverse[2];
	ex span, under;
};

/* Of a bare matrix: c2 and c3 are cofactors of its inverse's last column, and
 * 1/w = (c2 z + c3) / det for ndc z on the axis through the device's middle. */
static void matrix_slab(const double matrix[4][4], bool minus_one,
    bool reversed, struct slab *s)
{
	struct map m;
	ex g[3], z[3];
	bool parallel = true;

	map_of_doubles(matrix, &m);
	for (int i = 0; i < 3; i++) {
		ex a = m.m[i][3].value, b = m.m[i][2].value;

		g[i] = ex_mul(a, a);
		z[i] = ex_mul(b, b);
		parallel &= ex_sign(a) == 0;
	}
	ex c2 = ex_neg(map_minor(3, m.m, 8, 4).value);
	ex c3 = map_minor(3, m.m, 8, 8).value;
	ex det = map_minor(4, m.m, 0, 0).value;
	ex *normal = parallel ? z : g;

	for (int k = 0; k < 2; k++) {
		ex at = ex_add(c3,
		    (k == 1) != reversed ? c2 :
					   ex_scale(c2, minus_one ? -1 : 0));

		s->inverse[k] = ex_sign(det) < 0 ? ex_neg(at) : at;
	}
	s->span = ex_abs(ex_mul(parallel ? c3 : c2, det));
	s->span = ex_scale(s->span, minus_one ? 2 : 1);
	s->under = ex_sqrt(ex_add(ex_add(normal[0], normal[1]), normal[2]));
}

static void persp_slab(double near, double far, struct slab *s)
{
	ex n = ex_of(near);

	s->inverse[0] = ex_of(1);
	s->inverse[1] = (ex){ 0 };
	s->span = n;
	if (isinf(far))
		return;
	s->inverse[0] = ex_of(far);
	s->inverse[1] = n;
	s->span = ex_mul(ex_mul(n, ex_of(far)), ex_diff(far, near));
}

/* w is a multiple of 1 - q z. */
static void volume_slab(const struct projection *p, struct slab *s)
{
	struct sum over, under;

	projection_inverse_eye_z(p, &over, &under);
	ex q = over.value, one = under.value;

	s->inverse[0] = ex_abs(ex_sub(one, ex_scale(q, p->z_far)));
	s->inverse[1] = ex_abs(ex_sub(one, ex_scale(q, p->z_near)));
	s->span = ex_mul(ex_mul(s->inverse[0], s->inverse[1]),
	    ex_abs(ex_diff(p->z_far, p->z_near)));
}

static void slab_of(const struct scene *s, bool reversed, struct slab *r)
{
	const struct projection *p = &s->projection;
	bool minus_one = s->convention.minus_one;

	r->inverse[0] = r->inverse[1] = r->under = ex_of(1);
	switch (p->type) {
	case PROJECTION_NONE:
		r->span = ex_of(minus_one ? 2 : 1);
		break;
	case PROJECTION_PERSP:
		persp_slab(p->near, p->far, r);
		break;
	case PROJECTION_ORTHO:
	case PROJECTION_OBLIQUE:
		r->span = ex_abs(ex_diff(p->far, p->near));
		break;
	case PROJECTION_VOLUME:
		volume_slab(p, r);
		break;
	case PROJECTION_MATRIX:
		matrix_slab(p->matrix, minus_one, reversed, r);
		break;
	}
}

/* The distance of a share over / under of the depth range, inward from plane
 * a. */
static double distance(const struct slab *s, int a, ex over, ex under)
{
	ex at = ex_add(ex_mul(s->inverse[a], ex_sub(under, over)),
	    ex_mul(s->inverse[1 - a], over));

	if (ex_sign(s->span) == 0 || ex_sign(s->inverse[a]) <= 0 ||
	    ex_sign(at) <= 0)
		return (double)NAN;
	ex far = ex_mul(ex_mul(s->inverse[a], at), s->under);
	double d = ex_div(ex_mul(over, s->span), far).hi;

	return isfinite(d) ? d : (double)NAN;
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
static bool whole_boundary(double z, double other, double most, ex *over,
    ex *under)
{
	double k = whole_nearest(z, most);

	*over = ex_of(2 * k + (other > z ? 1 : -1));
	*under = ex_of(2 * most);
	return whole_nearest(other, most) != k;
}

/* Beyond the largest float the next is 2^128, which is stored as infinity. */
static double float_value(float a)
{
	return isinf(a) ? copysign(0x1p128, (double)a) : (double)a;
}

static bool float_boundary(double z, double other, ex *over, ex *under)
{
	float f = (float)z, end = (float)other;

	*over = ex_of((float_value(f) + float_value(nextafterf(f, end))) / 2);
	*under = ex_of(1);
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
			ex over, under;
			bool any = b == BUFFER_FLOAT32 ?
			    float_boundary(from, to, &over, &under) :
			    whole_boundary(from, to,
				b == BUFFER_UNORM16 ? 0xffff : 0xffffff, &over,
				&under);

			step[b][k] = (double)NAN;
			if (!any)
				continue;
			over = ex_abs(ex_sub(over, ex_scale(under, from)));
			step[b][k] = distance(&slab, k, over,
			    ex_mul(under, ex_abs(ex_diff(to, from))));
		}
}
