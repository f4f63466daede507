/* SPDX-License-Identifier: MIT */
#include "camera.h"

#include <string.h>

void convention_change(const struct convention *from,
    const struct convention *to, bool clip, bool rows, struct map *r)
{
	bool flips_y = clip ? from->ndc_y_down != to->ndc_y_down :
			      from->view_y_down != to->view_y_down;
	bool flips_z = !clip && looks_back(from) != looks_back(to);
	bool depth = clip && from->minus_one != to->minus_one;
	double t = to->minus_one != rows ? -1 : 0.5, size = t < 0 ? 2 : 0.5;

	for (int i = 0; i < 4; i++) {
		struct sum *y = rows ? &r->m[1][i] : &r->m[i][1];
		struct sum *z = rows ? &r->m[2][i] : &r->m[i][2];
		struct sum *w = rows ? &r->m[3][i] : &r->m[i][3];

		y->value.sign *= flips_y ? -1 : 1;
		z->value.sign *= flips_z ? -1 : 1;
		if (depth && rows)
			*w = sum_add(*w, sum_scale(*z, t));
		if (depth)
			*z = sum_scale(*z, size);
		if (depth && !rows)
			*z = sum_add(*z, sum_scale(*w, t));
	}
	if (rows && (flips_y || flips_z || depth))
		memset(r->origin, 0, sizeof r->origin);
}

/* The unit vector v / length. v is not divided because it is an exact polynomial of the
 * parameters, in which terms cancel exactly. If the length of axis y is exact, the
 * three lengths are equal, and become the map's divisor. */
struct axis {
	struct sum v[3];
	struct sum length;
};

enum { AXIS_SUMS = sizeof(struct axis) / sizeof(struct sum) };

static void axis_scale(struct axis *a, struct sum s)
{
	for (int i = 0; i < 3; i++)
		a->v[i] = sum_mul(a->v[i], s);
	a->length = sum_mul(a->length, s);
}

/* Computes the axes of projcalc(1), FORMULAS, lookat: z = +-gaze, x = up x z, y = z x
 * x, of lengths |z|, |up x z| and |z| |up x z|. */
static const char *axes_of_gaze(const struct camera *c,
    const struct convention *convention, struct axis axis[3])
{
	struct sum up[3];
	struct axis *x = &axis[0], *y = &axis[1], *z = &axis[2];
	bool at = c->kind == CAMERA_AT;

	for (int i = 0; i < 3; i++) {
		z->v[i] = sum_diff(c->at[i], at ? c->eye[i] : 0);
		if (convention->right_handed)
			z->v[i] = sum_neg(z->v[i]);
		up[i] = sum_of_double(c->up[i]);
	}
	if (vec3_is_zero(z->v))
		return at ? "/camera/at: equal to the eye; "
			    "choose another point to look at" :
			    "/camera/gaze: has no direction; "
			    "at least one element must not be 0";
	if (vec3_is_zero(up))
		return "/camera/up: has no direction; "
		       "at least one element must not be 0";
	vec3_cross(up, z->v, x->v);
	vec3_cross(z->v, x->v, y->v);
	struct sum xx = vec3_dot(x->v, x->v), zz = vec3_dot(z->v, z->v);
	/* the sine of the angle between up and gaze, |x| / (|up| |z|) */
	struct sum most = sum_mul(vec3_dot(up, up), zz);

	if (sum_compare(xx, sum_scale(most, 0x1p-100)) < 0)
		return "/camera/up: parallel to the gaze; "
		       "choose another up vector";
	x->length = sum_sqrt(xx);
	z->length = sum_sqrt(zz);
	y->length = sum_mul(x->length, z->length);
	for (int i = 0; i < 3 && convention->view_y_down; i++) {
		y->v[i] = sum_neg(y->v[i]);
		z->v[i] = sum_neg(z->v[i]);
	}
	if (sum_is_exact(&y->length)) {
		struct sum along = x->length;

		axis_scale(x, z->length);
		axis_scale(z, along);
	}
	return NULL;
}

/* Computes the columns of the rotation matrix of a quaternion, times its norm. */
static void axes_of_quaternion(const struct sum q[4], struct axis axis[3])
{
	struct sum p[4][4];

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			p[i][j] = sum_mul(q[i], q[j]);
	struct sum norm = sum_add(sum_add(p[0][0], p[1][1]),
	    sum_add(p[2][2], p[3][3]));

	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;
		struct sum along = sum_add(p[3][3], p[i][i]);

		axis[i].length = norm;
		axis[i].v[i] = sum_sub(along, sum_add(p[j][j], p[k][k]));
		axis[i].v[j] = sum_scale(sum_add(p[i][j], p[k][3]), 2);
		axis[i].v[k] = sum_scale(sum_sub(p[i][k], p[j][3]), 2);
	}
}

static const char *axes_of_orientation(const struct camera *c,
    struct axis axis[3])
{
	struct sum q[4];

	for (int i = 0; i < 4; i++)
		q[i] = sum_of_double(c->orientation[i]);
	if (vec3_is_zero(q) && sum_sign(q[3]) == 0)
		return "/camera/orientation: is zero; "
		       "no turn is [0, 0, 0, 1]";
	axes_of_quaternion(q, axis);
	return NULL;
}

static const char *axes_of_rvec(const struct camera *c, struct axis axis[3])
{
	struct sum r[3][3];

	if (!rotation_about(c->rvec, r))
		return "/camera/rvec: is longer than 2 pi; its length is the "
		       "angle in radians";
	for (int i = 0; i < 3; i++) {
		memcpy(axis[i].v, r[i], sizeof r[i]);
		axis[i].length = sum_of_double(1);
	}
	return NULL;
}

/* The message that refuses a matrix or a pose for a reason. */
#define REFUSAL(pose, reason) \
	((pose) ? "/camera/pose: " reason : "/camera/matrix: " reason)

/* Computes the axes of the rotation nearest to the upper 3x3. An element that is not
 * above the error of the quaternion becomes 0. */
static const char *axes_of_matrix(const struct camera *c, struct axis axis[3])
{
	struct sum q[4];
	enum rotation found = rotation_nearest(c->matrix, q);

	if (found == ROTATION_NONE)
		return REFUSAL(c->kind == CAMERA_POSE,
		    "its determinant is not positive; a rotation's is 1");
	if (found == ROTATION_MANY)
		return REFUSAL(c->kind == CAMERA_POSE,
		    "two directions have all but vanished; no rotation is the "
		    "nearest");
	axes_of_quaternion(q, axis);
	for (int i = 0; i < 9; i++) {
		struct sum *v = &axis[i / 3].v[i % 3];

		*v = sum_snap_zero(*v);
	}
	return NULL;
}

/* Computes the map to view space, whose rows are the transposed axes and the origin, or
 * its inverse, whose rows are the axes and the eye:
 *	 x0  y0  z0  0		 x0  x1  x2  0
 *	 x1  y1  z1  0		 y0  y1  y2  0
 *	 x2  y2  z2  0		 z0  z1  z2  0
 *	 origin      1		 eye         1
 * at is the eye or, if at_is_origin, the origin. The other is -x.eye, -y.eye, -z.eye,
 * or -x origin0 - y origin1 - z origin2: an exact polynomial, divided once. For an eye
 * (1,2,3) that looks at the origin, x.eye is so 0; rounded axes give -4.9e-32. */
static void map_of_axes(const struct axis a[3], const double at[3],
    bool at_is_origin, bool inverse, struct map *r)
{
	bool exact = sum_is_exact(&a[1].length);
	struct sum d = exact ? a[1].length : sum_of_double(1), minus[3];

	for (int i = 0; i < 3; i++)
		minus[i] = sum_of_double(-at[i]);
	map_identity(r);
	for (int i = 0; i < 3; i++) {
		struct sum given = sum_scale(d, at[i]), found;
		struct sum over = sum_quotient(sum_of_double(1),
		    exact ? sum_of_double(1) : a[i].length);

		if (at_is_origin)
			sum_dot(3, minus, &a[0].v[i], AXIS_SUMS, &found);
		else
			found = vec3_dot(a[i].v, minus);
		found = sum_mul(found, over);
		for (int k = 0; k < 3; k++)
			sum_dot(1, &a[i].v[k], &over, 1,
			    &r->m[inverse ? i : k][inverse ? k : i]);
		r->m[3][i] = at_is_origin == inverse ? found : given;
		if (!inverse)
			r->origin[i] = at_is_origin ? sum_ratio(found, d) :
						      at[i];
	}
	r->m[3][3] = d;
	map_divide(r, d);
}

/* Rotates view space about its z axis. */
static void camera_roll(double roll, enum angle_unit unit, bool inverse,
    struct map *r)
{
	const struct sum o = sum_of_double(0), l = sum_of_double(1);
	const struct sum c = trig_cos(roll, unit);
	const struct sum s = sum_negated_if(inverse, trig_sin(roll, unit));
	const struct map turn = { .m = { { c, s, o, o },
				      { sum_neg(s), c, o, o }, { o, o, l, o },
				      { o, o, o, l } },
		.divisor = l };

	map_append(r, &turn, inverse);
}

/* Computes the map of the matrix, or of a pose, which is a matrix from view to world.
 * If orthonormalize is set, the nearest rotation replaces the upper 3x3. */
static const char *camera_matrix_map(const struct camera *c, bool inverse,
    struct map *r)
{
	bool pose = c->kind == CAMERA_POSE, back = inverse != pose;
	struct axis axis[3];

	map_of_doubles(c->matrix, r);
	if (!map_is_affine(r))
		return REFUSAL(pose, NOT_AFFINE);
	if (!c->orthonormalize) {
		if ((pose || inverse) && !map_inverse(c->matrix, r))
			return REFUSAL(pose, "singular; it can't be inverted");
		if (!back)
			map_of_doubles(c->matrix, r);
		return NULL;
	}
	const char *why = axes_of_matrix(c, axis);

	if (why != NULL)
		return why;
	map_of_axes(axis, c->matrix[3], true, back, r);
	for (int i = 0; i < 3 && pose; i++)
		r->origin[i] = inverse ? 0 : c->matrix[3][i];
	return NULL;
}

const char *camera_map(const struct camera *c,
    const struct convention *convention, bool inverse, struct map *r)
{
	bool at_is_origin = c->kind == CAMERA_TRANSLATION ||
	    c->kind == CAMERA_RVEC_TRANSLATION;
	bool by_rvec = c->kind == CAMERA_RVEC ||
	    c->kind == CAMERA_RVEC_TRANSLATION;
	struct axis axis[3];

	if (c->kind == CAMERA_MATRIX || c->kind == CAMERA_POSE)
		return camera_matrix_map(c, inverse, r);
	const char *why = c->kind <= CAMERA_GAZE ?
	    axes_of_gaze(c, convention, axis) :
	    by_rvec ? axes_of_rvec(c, axis) :
		      axes_of_orientation(c, axis);

	if (why != NULL)
		return why;
	map_of_axes(axis, c->eye, at_is_origin, inverse, r);
	if (c->roll != 0)
		camera_roll(convention->view_y_down ? -c->roll : c->roll,
		    c->unit, inverse, r);
	return NULL;
}
