/* SPDX-License-Identifier: MIT */
#include "projection.h"

/* Returns whether a matrix that is not affine has the last row, but not the last
 * column, 0 0 1 0 or 0 0 -1 0, as transposed perspective matrices have. */
static bool is_transposed(const double m[4][4])
{
	bool row = true, column = true, affine = true;

	for (int i = 0; i < 4; i++) {
		row &= fabs(m[3][i]) == (i == 2);
		column &= fabs(m[i][3]) == (i == 2);
		affine &= m[i][3] == (i == 3);
	}
	return row && !column && !affine;
}

static bool matrix_check(const struct projection *p, struct refusals *faults)
{
	return !is_transposed(p->matrix) ||
	    refuse(faults, "/projection/matrix", "is transposed",
		"of 16 numbers w is made by 4, 8, 12 and 16; of rows, by the "
		"last column in d3d and by the last row in other conventions");
}

static bool matrix_map(const struct projection *p, const struct convention *c,
    bool inverse, struct map *r, struct refusals *faults)
{
	(void)c;
	map_of_doubles(p->matrix, r);
	return !inverse || map_invert(r) ||
	    refuse(faults, "/projection/matrix", "singular", "it can't be inverted");
}

static bool matrix_check_map(const struct projection *p, bool inverse,
    struct refusals *faults)
{
	struct map r;

	return isnan(p->matrix[0][0]) || matrix_map(p, NULL, inverse, &r, faults);
}

/* Returns whether a parallel projection's matrix contains a turned camera. It does if
 * depth depends on x or y, or if y depends on x. In a scene without a camera, it also
 * does if just one of x and y is mirrored, as by half a turn. */
static bool contains_camera(const struct projection *p, const struct convention *c)
{
	const double(*m)[4] = p->matrix;
	bool down = c->ndc_y_down != c->view_y_down;
	bool mirrors = ((m[0][0] < 0) != (m[1][1] < 0)) != down;

	return m[0][1] != 0 || m[0][2] != 0 || m[1][2] != 0 ||
	    (p->without_camera && mirrors);
}

/* A matrix does not say which plane is near: it is the plane of smaller positive w or,
 * if w is constant, the plane that the convention's gaze meets first. But a parallel
 * matrix that contains a turned or mirrored camera is never reversed. On the z axis of
 * ndc, 1/w is z m[2][3] + m[3][3], where m is the inverse matrix. 1/w is larger at the
 * near plane than at the far plane. */
static bool matrix_is_reversed(const struct projection *p, const struct convention *c)
{
	struct map back;

	map_of_doubles(p->matrix, &back);
	if (!map_invert(&back))
		return p->reverse_z;
	int grows = sum_sign(back.m[2][3]);
	int along_z = sum_sign(back.m[2][2]) * sum_sign(back.m[3][3]);

	if (grows == 0 && contains_camera(p, c))
		return false;
	return grows != 0 ? grows > 0 : along_z == (convention_looks_back(c) ? 1 : -1);
}

static bool none_map(const struct projection *p, const struct convention *c,
    bool inverse, struct map *r, struct refusals *faults)
{
	(void)p, (void)c, (void)inverse, (void)faults;
	map_identity(r);
	return true;
}

/* Near is the plane that the convention's gaze meets first. */
static bool none_is_reversed(const struct projection *p, const struct convention *c)
{
	(void)p;
	return convention_looks_back(c);
}

const struct projection_row projection_row_none = { .family = FAMILY_FIXED,
	.map = none_map,
	.frame = FRAME_SCENE,
	.is_reversed = none_is_reversed };

const struct projection_row projection_row_matrix = { .family = FAMILY_FIXED,
	.map = matrix_map,
	.check = matrix_check,
	.check_map = matrix_check_map,
	.frame = FRAME_SCENE,
	.is_reversed = matrix_is_reversed };
