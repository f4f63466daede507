/* SPDX-License-Identifier: MIT */
#include "note.h"

bool note_is_rotation(const double r[3][3], double tolerance, bool mirrored)
{
	double det = 0;

	for (int i = 0; i < 9; i++) {
		const double *a = r[i / 3], *b = r[i % 3];

		if (!(fabs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] -
			  (i / 3 == i % 3)) <= tolerance))
			return false;
	}
	for (int j = 0, k = 1, n = 2; j < 3; j++, k = n, n = (n + 1) % 3)
		det += r[0][j] * (r[1][k] * r[2][n] - r[1][n] * r[2][k]);
	return mirrored ? det < 0 : det > 0;
}

/* A slip is as large as 1e-2; the rounding of four digits is not. */
bool note_is_no_rotation(const struct camera *c)
{
	const struct steps *s = &c->steps;
	double r[3][3];
	struct map m;

	if (!camera_gives_3x3(c) || c->orthonormalize)
		return false;
	if (!camera_is_by_steps(c))
		return !note_is_rotation(c->rotation, 1e-2, false);
	if (s->step != NULL && !steps_map(s, "", false, false, &m, NULL))
		return false;
	for (int i = 0; i < 9; i++)
		r[i / 3][i % 3] = s->step == NULL ?
		    s->matrix[i % 3][i / 3] :
		    map_element_nearest(&m, i % 3, i / 3, false);
	/* the flag is set by a product that no image needs */
	return !(s->step != NULL && ex_has_overflowed()) &&
	    !note_is_rotation(r, 1e-2, false);
}

/* Returns half a unit of the last digit of the shortest decimal of a size from 1e-6 to
 * 1e4, and sets *digits to its digits, but to 4 and 15 at least and at most. A quotient
 * of a whole number by a power of ten up to 10^22 is the double of the decimal. */
static double half_digit(double size, int *digits)
{
	double unit = 1000; /* four digits of 1 to 10 */

	for (double least = 1; size < least && least > 1e-6; least /= 10)
		unit *= 10;
	for (double most = 10; size >= most && most < 1e4; most *= 10)
		unit /= 10;
	for (*digits = 4; *digits < 15 && rint(size * unit) / unit != size; ++*digits)
		unit *= 10;
	return 0.5 / unit;
}

/* Returns whether |x| is k pi / 360, k whole from 1 to 720, to the digits of its
 * shortest form, which are five or more, or whether their floats are the same. As such
 * a number is below 10, it has four decimals or more, and so is no whole number of
 * twentieths of a degree. From 16 digits on, the double itself is coarser than its last
 * digit: k pi / 360 computed in doubles is within 2^-51 of x. */
static bool is_radians(double x)
{
	const double size = fabs(x), k = rint(size * (360 / PI)), part = k * (PI / 360);
	int digits;

	if (!(k >= 1 && k <= 720))
		return false;
	const double half = half_digit(size, &digits);

	return digits > 4 &&
	    (fabs(size - part) <= half * (1 + 0x1p-20) + 0x1p-51 * size ||
		(float)size == (float)part);
}

/* Returns whether four angles from the gaze, of which all are below 1.6 and one has
 * three decimals or more, are likely in radians. */
static bool are_radians(const double angles[4])
{
	bool below = true, fine = false;

	for (int i = 0; i < 4; i++) {
		below &= fabs(angles[i]) < 1.6;
		fine |= rint(angles[i] * 100) / 100 != angles[i];
	}
	return below && fine;
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
	if (persp && p->section.way == SECTION_ANGLES)
		found |= are_radians(p->section.angles);
	if (projection_is_sheared(p))
		found |= is_radians(p->shear.direction) ||
		    (p->shear.kind == OBLIQUE_ANGLE &&
			is_radians(p->shear.projector_angle));
	return found || is_radians(view) ||
	    (view >= 0.2 && view <= 3.2 && rint(view * 100) / 100 != view);
}

/* Returns whether the size x, which may be off by `half`, is |cot(k t)|, k whole from
 * `first` to `last`, where t has this sine and cosine and first t those of the array.
 * Each step adds less than 2^-51 to their errors, and no cosine is below 2^-8, so that
 * the cotangent has a relative error below 2^-35. */
static bool is_cot(double x, double half, const double first[2], double sine,
    double cosine, int n)
{
	double s = first[0], c = first[1];

	for (int k = 0; k < n; k++) {
		const double next = c * cosine - s * sine;

		if (fabs(x * fabs(s) - fabs(c)) <= half * fabs(s) + 0x1p-20 * fabs(c))
			return true;
		s = s * cosine + c * sine;
		c = next;
	}
	return false;
}

/* Returns whether |x|, of five digits or more, is |cot(k / 2)| to its digits, but
 * within a relative 2^-20, which is coarser than a float's digits: with k whole from 4
 * to 179, k / 2 in radians, or from 1 to 179 and in degrees. Of radians five digits of
 * six are enough, as the last may be lost by an aspect that was multiplied later. */
static bool is_cot_of_whole(double x, double aspect, enum angle_unit unit)
{
	/* sine and cosine of 2 and of 1/2 radians, and of half a degree */
	static const double two[2] = { 0.90929742682568169540,
		-0.41614683654714238700 },
			    half[2] = { 0.47942553860420300027,
				    0.87758256189037271612 },
			    degree[2] = { 0.0087265354983739347,
				    0.99996192306417128874 };
	const bool radians = unit == ANGLE_RADIANS;
	const double size = fabs(x), *const step = radians ? half : degree;
	int digits;

	if (!(size > 1e-4 && size < 1e4))
		return false;
	double off = half_digit(size, &digits) * aspect;

	off *= radians && digits == 6 ? 10 : 1;

	return digits > 4 &&
	    is_cot(size * aspect, off, radians ? two : degree, step[0], step[1],
		radians ? 176 : 179);
}

/* A matrix of so few digits that one of its numbers is a cotangent of degrees, too, is
 * right. */
static bool has_matrix_of_radians(const struct scene *s)
{
	const struct projection *p = &s->projection;
	double full[2] = { 1, 1 };

	if (s->has_viewport)
		viewport_full(&s->viewport, full);
	const double aspect = full[0] / full[1];
	const double(*m)[4] = p->matrix;
	const bool parallel = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0;
	bool radians = false, degrees = false;

	for (int i = 0; i < 4 && projection_is_given_matrix(p) && !parallel; i++) {
		const double x = m[i / 2][i / 2], by = i % 2 == 0 ? 1 : aspect;

		radians |= is_cot_of_whole(x, by, ANGLE_RADIANS);
		degrees |= is_cot_of_whole(x, by, ANGLE_DEGREES);
	}
	return radians && !degrees;
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

/* Returns whether the part of a picture that the viewport shows is outside of it. The
 * size of a picture of intrinsics need not be known. */
static bool has_part_outside(const struct scene *s)
{
	const struct viewport *v = &s->viewport;
	const double size[2] = { v->width, v->height };
	double full[2];
	bool outside = false;

	if (!s->has_viewport || !v->has_offset ||
	    (projection_has_intrinsics(&s->projection) && !v->has_full))
		return false;
	viewport_full(v, full);
	for (int i = 0; i < 2; i++)
		outside |= v->offset[i] >= full[i] || v->offset[i] <= -size[i];
	return outside;
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

bool note_has_central_intrinsics(const struct projection_section *c)
{
	return note_principal_point_is_inside(c->intrinsics[0][2], c->width) &&
	    note_principal_point_is_inside(c->intrinsics[1][2], c->height);
}

unsigned note_of_members(const struct scene *s, const struct written *w)
{
	return note_if(s->has_camera && note_is_no_rotation(&s->camera),
		   NOTE_ROTATION) |
	    note_if(!w->angle_unit && has_radians(s), NOTE_RADIANS) |
	    note_if(!w->angle_unit && has_matrix_of_radians(s), NOTE_MATRIX_RADIANS) |
	    note_if(!w->scale && has_other_aspect(s), NOTE_ASPECT) |
	    note_if(has_colmap_order(&s->projection), NOTE_COLMAP) |
	    note_if(has_part_outside(s), NOTE_PART);
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
		    (!note_judges_center(s) || note_has_central_intrinsics(c))));
}
