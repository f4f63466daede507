/* SPDX-License-Identifier: MIT */
#include "projection.h"

/* Sets z[2] / d[2] = f/(f-n) and t[2] / d[2] = -nf/(f-n) for near n and far f, or their
 * limits for an infinite f. reverse_z exchanges n and f. Without planes, where near is
 * 0, depth is 1/w. */
static void depth_column(const struct projection *p, struct scaled_matrix *f)
{
	double n = p->near == 0 ? 1 : p->near;

	if (isinf(p->far)) {
		sum_set(&f->d[2], 1);
		sum_set(&f->z[2], p->reverse_z ? 0 : 1);
		sum_set(&f->t[2], p->reverse_z ? n : -n);
	} else {
		double a = p->reverse_z ? p->far : n;
		double b = p->reverse_z ? n : p->far;

		f->d[2] = sum_difference(b, a);
		sum_set(&f->z[2], b);
		f->t[2] = sum_scale(sum_of_double(-a), b);
	}
}

/* Computes the matrix
 *	 s0  0   0   0
 *	 0   s1  0   0
 *	 z0  z1  z2  1
 *	 0   0   t2  0
 * With intrinsics, it leads from the canonical space of prepend_intrinsics. */
static void persp_matrix(const struct projection *p, const struct convention *c,
    struct scaled_matrix *f)
{
	bool pixels = p->section.way == SECTION_INTRINSICS;
	bool down = pixels && !c->origin_bottom_left;
	double distance = pixels    ? 1 :
	    p->section.edges_at > 0 ? p->section.edges_at :
				      p->near;
	struct sum sums[2];

	scaled_clear(f);
	section_sizes(p, distance, f, sums);
	depth_column(p, f);
	f->z[0] = sum_neg(sums[0]);
	f->z[1] = sum_negated_if(!down, sums[1]);
	sum_set(&f->z[3], 1);
}

static bool persp_check(const struct projection *p, struct refusals *faults)
{
	const bool is_right = section_check(p, faults);

	if (p->near >= p->far)
		return refuse(faults, "/projection/near", "not less than far",
		    "near is the plane nearer to the eye, also with "
		    "\"reverse_z\": true");
	return is_right;
}

/* Puts the affine map of P before r or, if inverse, its inverse after r. The map leads
 * from view space (d3d) to the canonical space of u w, v w, w (section.h). In both, y
 * is upward: if device y points down, y is -Y in view space and -v w in the other. */
static bool prepend_intrinsics(const struct projection *p, const struct convention *c,
    bool inverse, struct map *r, struct refusals *faults)
{
	const double sign[4] = { 1, c->origin_bottom_left ? 1 : -1, 1, 1 };
	double m[4][4];
	struct map canonical;

	for (int i = 0; i < 4; i++) {
		for (int j = 0; j < 3; j++)
			m[i][j] = sign[i] * sign[j] * p->section.intrinsics[j][i];
		m[i][3] = i == 3;
	}
	map_of_doubles(m, &canonical);
	if (inverse && !map_invert(&canonical))
		return refuse(faults, "/projection/intrinsics",
		    "the left three columns of P are singular", "it can't be inverted");
	map_multiply(r, &canonical, !inverse);
	map_set_origin(r, NULL);
	return true;
}

static bool persp_map(const struct projection *p, const struct convention *c,
    bool inverse, struct map *r, struct refusals *faults)
{
	struct scaled_matrix f;

	persp_matrix(p, c, &f);
	scaled_map(&f, inverse, r);
	return p->section.way != SECTION_INTRINSICS ||
	    prepend_intrinsics(p, c, inverse, r, faults);
}

static bool persp_check_map(const struct projection *p, bool inverse,
    struct refusals *faults)
{
	static const struct convention any;
	struct map r;

	if (!inverse || p->section.way != SECTION_INTRINSICS)
		return true;
	for (int i = 0; i < 9; i++)
		if (isnan(p->section.intrinsics[i / 3][i % 3]))
			return true;
	map_identity(&r);
	return prepend_intrinsics(p, &any, true, &r, faults);
}

const struct projection_row projection_row_persp = { .family = FAMILY_PERSP,
	.map = persp_map,
	.check = persp_check,
	.check_map = persp_check_map,
	.frame = FRAME_D3D };
