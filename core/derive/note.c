/* SPDX-License-Identifier: MIT */
#include "note.h"

#include <math.h>

/* Returns whether z is up: worlds with z up are right-handed, and d3d would show them
 * mirrored. If the gaze is within a degree of the y axis, it is a plan or an elevation,
 * whose up is z in a world with y up, too. */
static bool has_up_z(const struct scene *s)
{
	const struct camera *c = &s->camera;
	const double tan_degree = 0.017455064928217585;
	double gaze[3];

	if (!s->has_camera || !camera_is_by_gaze(c) || c->up[0] != 0 || c->up[1] != 0 ||
	    c->up[2] == 0)
		return false;
	for (int i = 0; i < 3; i++)
		gaze[i] = c->at[i] - (c->way == CAMERA_AT ? c->eye[i] : 0);
	return hypot(gaze[0], gaze[2]) > tan_degree * fabs(gaze[1]);
}

/* Returns whether |x| is k pi / 360, k whole from 1 to 720, to the digits of its
 * shortest form, which are five or more. As such a number is below 10, it has four
 * decimals or more, and so is no whole number of twentieths of a degree. A quotient of
 * a whole number by a power of ten up to 10^22 is the double of the decimal. From 16
 * digits on, the double itself is coarser than its last digit: k pi / 360 computed in
 * doubles is within 2^-51 of x. */
static bool is_radians(double x)
{
	double size = fabs(x), unit = 1000; /* four digits of 1 to 10 */
	double k = rint(size * (360 / PI));

	if (!(k >= 1 && k <= 720))
		return false;
	for (double least = 1; size < least; least /= 10)
		unit *= 10;
	if (rint(size * unit) / unit == size)
		return false;
	for (int n = 4; n < 15 && rint(size * unit) / unit != size; n++)
		unit *= 10;
	return fabs(size - k * (PI / 360)) <=
	    0.5 / unit * (1 + 0x1p-20) + 0x1p-51 * size;
}

/* Returns whether a list of steps, if there is one, has an angle as of radians. */
static bool steps_have_radians(const struct steps *l)
{
	for (int i = 0; l->step != NULL && i < l->n; i++)
		if (l->unit == ANGLE_DEGREES &&
		    (step_is_about_axis(&l->step[i]) ||
			l->step[i].kind == STEP_ROTATE) &&
		    is_radians(l->step[i].angle))
			return true;
	return false;
}

/* An angle of view in degrees is likely in radians, too, if it is 0.2 to 3.2 with three
 * decimals or more. */
static bool has_radians(const struct scene *s)
{
	const struct projection *p = &s->projection;
	const enum projection_family family = projection_family(p);
	const bool persp = family == FAMILY_PERSP;
	bool found = (s->has_world && steps_have_radians(&s->world)) ||
	    (s->has_camera && steps_have_radians(&s->camera.steps));
	double view = 0;

	if (s->has_camera && s->camera.unit == ANGLE_DEGREES &&
	    !camera_is_by_steps(&s->camera))
		found |= is_radians(s->camera.roll);
	if (p->unit != ANGLE_DEGREES)
		return found;
	if (persp && section_is_by_angle(p->section.way))
		view = p->section.angle;
	if (family == FAMILY_VOLUME && p->volume.eye_given_by == EYE_BY_ANGLE)
		view = p->volume.view_angle;
	for (int i = 0; i < 4 && persp && p->section.way == SECTION_ANGLES; i++)
		found |= is_radians(p->section.angles[i]);
	if (projection_is_sheared(p))
		found |= is_radians(p->shear.direction) ||
		    (p->shear.kind == OBLIQUE_ANGLE &&
			is_radians(p->shear.projector_angle));
	return found || is_radians(view) ||
	    (view >= 0.2 && view <= 3.2 && rint(view * 100) / 100 != view);
}

/* Returns whether |x| or |y| is within a relative 2^-20 of |cot(k / 2)|, k whole from 4
 * to 179, k / 2 in radians. The cosine c and sine s of k / 2 come from those of k / 2 -
 * 1/2 by the sine and cosine of 1/2. Each step adds less than 2^-51 to their errors,
 * and no |c| is below 2^-8, so that cot has a relative error below 2^-35. 2^-20 is
 * coarser than a float's digits, and the cotangents of half of whole and half degrees
 * differ by more (note_test). */
static bool is_cot_of_degrees(double x, double y)
{
	const double cos_half = 0.87758256189037271612,
		     sin_half = 0.47942553860420300027;
	double c = -0.41614683654714238700, s = 0.90929742682568169540;

	for (int k = 4; k <= 179; k++) {
		const double next = c * cos_half - s * sin_half;

		if (fabs(fabs(x * s) - fabs(c)) <= 0x1p-20 * fabs(c) ||
		    fabs(fabs(y * s) - fabs(c)) <= 0x1p-20 * fabs(c))
			return true;
		s = s * cos_half + c * sin_half;
		c = next;
	}
	return false;
}

static bool has_matrix_of_radians(const struct scene *s)
{
	const struct projection *p = &s->projection;
	double full[2] = { 1, 1 };

	if (s->has_viewport)
		viewport_full(&s->viewport, full);
	const double aspect = full[0] / full[1];
	const double(*m)[4] = p->matrix, xs = m[0][0], ys = m[1][1];
	const bool parallel = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0;

	return projection_is_given_matrix(p) && !parallel &&
	    (is_cot_of_degrees(xs, ys) ||
		(aspect != 1 && is_cot_of_degrees(xs * aspect, ys * aspect)));
}

/* Returns whether an aspect, or that of a sensor, whose width and height are at a focal
 * length, differs from the viewport's by more than 1 %. */
static bool has_other_aspect(const struct scene *s)
{
	const struct projection *p = &s->projection;
	const struct projection_section *c = &p->section;
	const struct viewport *v = &s->viewport;
	const bool sensor = projection_family(p) == FAMILY_PERSP &&
	    c->way == SECTION_SIZE && c->edges_at > 0;
	const double width = sensor ? c->width : p->aspect[0];
	const double height = sensor ? c->height : p->aspect[1];

	if (projection_is_none(p) || !s->has_viewport || v->scale != SCALE_FILL ||
	    height == 0)
		return false;
	double full[2];

	viewport_full(v, full);
	const double share = width / height * full[1] / full[0];

	return share > 1.01 || share < 0.99;
}

/* Returns whether the intrinsics fx, fy, cx, cy are f, cx, cy, k of COLMAP's model
 * SIMPLE_RADIAL: k is below 1, and cx and cy are within a tenth of half the width and
 * height from the middle. */
static bool has_colmap_order(const struct projection *p)
{
	const double(*k)[4] = p->section.intrinsics;
	const double half[2] = { p->section.width / 2, p->section.height / 2 };

	return projection_has_intrinsics(p) && k[0][1] == 0 && fabs(k[1][2]) < 1 &&
	    fabs(k[1][1] - half[0]) <= 0.1 * half[0] &&
	    fabs(k[0][2] - half[1]) <= 0.1 * half[1];
}

bool note_judges_center(const struct scene *s)
{
	return s->projection.section.is_sized || s->viewport.has_full ||
	    !s->viewport.has_offset;
}

bool note_principal_point_is_inside(double coordinate, double viewport_size)
{
	return 0.01 * viewport_size < coordinate && coordinate < 0.99 * viewport_size;
}

unsigned note_of_members(const struct scene *s, const struct written *w)
{
	return (unsigned)(!w->convention && has_up_z(s)) << NOTE_UP_Z |
	    (unsigned)(!w->angle_unit && has_radians(s)) << NOTE_RADIANS |
	    (unsigned)has_matrix_of_radians(s) << NOTE_MATRIX_RADIANS |
	    (unsigned)(!w->scale && has_other_aspect(s)) << NOTE_ASPECT |
	    (unsigned)has_colmap_order(&s->projection) << NOTE_COLMAP;
}

/* A transposed perspective matrix has the gaze, a unit vector, in its last row and the
 * image of the origin in its last column. A transposed parallel projection has the last
 * row 0 0 0 1. */
bool note_seems_transposed(const double m[4][4])
{
	double row = 0, column = 0; /* squares of lengths */

	for (int i = 0; i < 3; i++) {
		row += m[3][i] * m[3][i];
		column += m[i][3] * m[i][3];
	}
	bool unit = fabs(row - 1) < 0x1p-20 && fabs(column - 1) > 0x1p-20;

	return column > 0 && (unit || (row == 0 && m[3][3] == 1));
}

/* Returns whether a matrix shows no mirror image, does not look transposed and, if it
 * may be upright in view axes, looks along the convention's gaze. It mirrors unless
 * right, up and gaze, the gradients of x, y and w (if w is constant, of z), have the
 * convention's handedness. A determinant in doubles has an error below 2^-48 of the
 * lengths' product, and 2^-30 decides. */
static bool is_plain_matrix(const struct scene *s)
{
	const struct convention *c = &s->convention;
	const double(*m)[4] = s->projection.matrix;
	const bool parallel = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0;
	const bool turned = m[0][1] != 0 || m[0][2] != 0 || m[1][2] != 0 ||
	    m[0][3] != 0 || m[1][3] != 0;
	const int gaze = parallel ? 2 : 3;
	const double along = convention_looks_back(c) ? -m[2][gaze] : m[2][gaze];
	double length = 1, det = 0;

	if (note_seems_transposed(m) || (parallel && !(m[3][3] > 0)) ||
	    (!turned && !(along > 0)))
		return false;
	for (int i = 0; i < 3; i++) {
		const double *a = m[i], *b = m[(i + 1) % 3], *d = m[(i + 2) % 3];
		const int k = i < 2 ? i : gaze;

		det += a[0] * (b[1] * d[gaze] - b[gaze] * d[1]);
		length *= hypot(hypot(m[0][k], m[1][k]), m[2][k]);
	}
	return (c->right_handed != c->ndc_y_down ? -det : det) > 0x1p-30 * length;
}

bool note_is_plain(const struct scene *s)
{
	const struct projection *p = &s->projection;
	const struct projection_section *c = &p->section;

	if (projection_family(p) == FAMILY_FIXED)
		return projection_is_none(p) || is_plain_matrix(s);
	if (projection_family(p) == FAMILY_VOLUME)
		return !s->has_camera;
	/* edges are as they are written */
	return p->near <= p->far &&
	    (!projection_has_intrinsics(p) ||
		(!projection_is_tilted(p) && c->intrinsics[0][0] > 0 &&
		    c->intrinsics[1][1] > 0 &&
		    (!note_judges_center(s) ||
			(note_principal_point_is_inside(c->intrinsics[0][2],
			     c->width) &&
			    note_principal_point_is_inside(c->intrinsics[1][2],
				c->height)))));
}
