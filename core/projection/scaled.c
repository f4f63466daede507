/* SPDX-License-Identifier: MIT */
#include "scaled.h"

void scaled_clear(struct scaled_matrix *f)
{
	for (int k = 0; k < 4; k++) {
		sum_set(&f->z[k], 0);
		sum_set(&f->t[k], 0);
	}
	sum_set(&f->divisor, 1);
	f->plane = 0;
}

void scaled_set_sizes(const double aspect[2], int k, struct sum scale, double divisor,
    struct scaled_matrix *f)
{
	sum_copy(&f->s[k], &scale);
	sum_set(&f->d[k], divisor);
	f->s[!k] = sum_scale(scale, aspect[k]);
	f->d[!k] = sum_scale(f->d[k], aspect[!k]);
}

bool scaled_is_exact(const struct scaled_matrix *f)
{
	return sum_is_exact(&f->z[0]) && sum_is_exact(&f->z[1]) &&
	    sum_is_exact(&f->z[2]);
}

static void map_of_scaled(const struct scaled_matrix *f, struct map *r)
{
	map_identity(r);
	for (int k = 0; k < 2; k++)
		sum_copy(&r->m[k][k], &f->s[k]);
	for (int k = 0; k < 4; k++) {
		sum_copy(&r->m[2][k], &f->z[k]);
		sum_copy(&r->m[3][k], &f->t[k]);
		sum_copy(&r->m[4][k], f->plane != 0 ? &f->in_plane[k] : &f->t[k]);
	}
	r->origin[2] = f->plane;
	map_divide(r, f->divisor);
	for (int k = 0; k < 3; k++)
		map_divide_column(r, k, f->d[k]);
}

/* Writes the inverse (A', 0; -B' C A', B') of the matrix of 2x2 blocks (A, 0; C, B),
 * where A = (s0 0; 0 s1), B = (z2 z3; t2 t3) and C = (z0 z1; t0 t1). A' and B' are the
 * inverses of A and B, and det is the determinant of B. The divisors of columns become
 * factors of the inverse's rows. */
static void scaled_inverse(const struct scaled_matrix *f, struct scaled_matrix *r)
{
	const struct sum *z = f->z, *t = f->t;
	struct sum det = sum_minor(z[2], t[3], z[3], t[2]), d = f->divisor;

	if (!sum_is_exact(&det)) {
		d = sum_quotient(d, det);
		sum_set(&det, 1);
	}
	struct sum s = sum_mul(f->divisor, det), dz = sum_mul(d, f->d[2]);

	for (int k = 0; k < 2; k++) {
		r->s[k] = sum_mul(f->d[k], s);
		r->z[k] = sum_mul(dz, sum_minor(z[3], t[k], t[3], z[k]));
		r->t[k] = sum_mul(d, sum_minor(t[2], z[k], z[2], t[k]));
		sum_copy(&r->d[k], &f->s[k]);
	}
	r->z[2] = sum_mul(dz, t[3]);
	r->z[3] = sum_neg(sum_mul(dz, z[3]));
	r->t[2] = sum_neg(sum_mul(d, t[2]));
	r->t[3] = sum_mul(d, z[2]);
	sum_set(&r->d[2], 1);
	sum_copy(&r->divisor, &det);
	r->plane = 0;
}

void scaled_map(const struct scaled_matrix *f, bool inverse, struct map *r)
{
	struct scaled_matrix back;

	if (inverse)
		scaled_inverse(f, &back);
	map_of_scaled(inverse ? &back : f, r);
}
