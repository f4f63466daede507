/* SPDX-License-Identifier: MIT */
#include "parallel.h"

#include "projection.h"

/* Computes the matrix
 *	 s0  0   0   0
 *	 0   s1  0   0
 *	 0   0   1   0
 *	 t0  t1  t2  1 */
static void ortho_matrix(const struct projection *p, struct scaled_matrix *f)
{
	double a = p->reverse_z ? p->far : p->near;
	double b = p->reverse_z ? p->near : p->far;
	struct sum sums[2];

	scaled_clear(f);
	section_sizes(p, 1, f, sums);
	f->d[2] = sum_difference(b, a);
	sum_set(&f->z[2], 1);
	sum_set(&f->t[2], -a);
	for (int k = 0; k < 2; k++)
		f->t[k] = sum_neg(sums[k]);
	sum_set(&f->t[3], 1);
}

static bool parallel_check(const struct projection *p, struct refusals *faults)
{
	const bool is_right = section_check(p, faults);

	if (p->near == p->far)
		return refuse(faults, "/projection/far", "equal to near",
		    "the planes must differ");
	return is_right;
}

/* Shears the matrix of ortho by x' = x + c cos(direction) (depth - plane), y' = y + c
 * sin(direction) (depth - plane). c is cot(projector angle). In the plane the images
 * are those of ortho, where c, cos and sin have no part. */
static void shear(const struct projection *p, struct scaled_matrix *f)
{
	const struct projection_shear *s = &p->shear;
	struct sum cot = sum_of_double(s->kind == OBLIQUE_CABINET ? 0.5 : 1), turn[2];

	if (s->kind == OBLIQUE_ANGLE)
		cot = trig_cot(s->projector_angle, p->unit);
	trig_sin_cos(s->direction, s->direction_unit, &turn[1], &turn[0]);
	for (int k = 0; k < 2; k++)
		f->z[k] = sum_mul(sum_mul(cot, turn[k]), f->s[k]);
	if (!scaled_is_exact(f)) {
		f->plane = s->plane;
		for (int k = 0; k < 4; k++)
			sum_copy(&f->in_plane[k], &f->t[k]);
		f->in_plane[2] = sum_add(f->t[2], sum_of_double(s->plane));
	}
	for (int k = 0; k < 2; k++)
		f->t[k] = sum_sub(f->t[k], sum_scale(f->z[k], s->plane));
}

static bool parallel_map(const struct projection *p, const struct convention *c,
    bool inverse, struct map *r, struct refusals *faults)
{
	struct scaled_matrix f;

	(void)c, (void)faults;
	ortho_matrix(p, &f);
	if (p->type == PROJECTION_OBLIQUE)
		shear(p, &f);
	scaled_map(&f, inverse, r);
	return true;
}

const struct projection_row projection_row_ortho = { .family = FAMILY_PARALLEL,
	.map = parallel_map,
	.check = parallel_check,
	.frame = FRAME_D3D };

const struct projection_row projection_row_oblique = { .family = FAMILY_PARALLEL,
	.map = parallel_map,
	.check = parallel_check,
	.frame = FRAME_D3D,
	.is_sheared = true };
