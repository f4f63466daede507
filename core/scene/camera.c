/* SPDX-License-Identifier: MIT */
#include "camera.h"

#include <string.h>

#include "../exact/rotation.h"

/* An axis is v / length. The two are kept apart, as v is an exact polynomial of
 * the parameters, in sums of which terms cancel exactly. Where the second's length
 * is exact all lengths are the same, by which the map divides. */
struct axis {
	struct sum v[3];
	struct sum length;
};

static void lengthen(struct axis *a, struct sum by)
{
	for (int i = 0; i < 3; i++)
		a->v[i] = sum_mul(a->v[i], by);
	a->length = sum_mul(a->length, by);
}

/* x = up x z and y = z x x before either is normalised: exact polynomials of
 * lengths |up x z| and |z| |up x z|. */
static const char *look(const struct camera *c,
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
	/* |sin| of the angle between up and gaze is below 2^-50 */
	struct sum bound = sum_mul(vec3_dot(up, up), zz);

	if (sum_compare(xx, sum_scale(bound, 0x1p-100)) < 0)
		return "/camera/up: parallel to the gaze; "
		       "choose another up vector";
	x->length = sum_sqrt(xx);
	z->length = sum_sqrt(zz);
	y->length = sum_mul(x->length, z->length);
	for (int i = 0; i < 3 && convention->view_y_down; i++) {
		y->v[i] = sum_neg(y->v[i]);
		z->v[i] = sum_neg(z->v[i]);
	}
	if (y->length.error.m == 0) {
		struct sum along = x->length;

		lengthen(x, z->length);
		lengthen(z, along);
	}
	return NULL;
}

/* The columns of the rotation matrix of a quaternion, times its norm. */
static void turn(const struct sum q[4], struct axis axis[3])
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

static const char *orient(const struct camera *c, struct axis axis[3])
{
	struct sum q[4];

	for (int i = 0; i < 4; i++)
		q[i] = sum_of_double(c->orientation[i]);
	if (vec3_is_zero(q) && sum_sign(q[3]) == 0)
		return "/camera/orientation: is zero; "
		       "no turn is [0, 0, 0, 1]";
	turn(q, axis);
	return NULL;
}

static const char *turn_about(const struct camera *c, struct axis axis[3])
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

/* What is wrong with a matrix, and with a pose. */
#define BOTH(reason)                                               \
	{                                                          \
		"/camera/matrix: " reason, "/camera/pose: " reason \
	}

static const char *const refusals[][2] = {
	[ROTATION_NONE] = BOTH("its determinant is not positive; "
			       "a rotation's is 1"),
	[ROTATION_MANY] = BOTH("two directions have all but vanished; "
			       "no rotation is the nearest"),
};

static const char *const not_affine[2] = BOTH(NOT_AFFINE);
static const char *const singular[2] = BOTH("singular; it can't be inverted");

/* The nearest rotation to the upper 3x3. An element that is not above the error of
 * the quaternion is 0. */
static const char *orthonormal(const struct camera *c, struct axis axis[3])
{
	struct sum q[4];
	enum rotation found = rotation_nearest(c->matrix, q);

	if (found != ROTATION_FOUND)
		return refusals[found][c->kind == CAMERA_POSE];
	turn(q, axis);
	for (int i = 0; i < 9; i++) {
		struct sum *v = &axis[i / 3].v[i % 3];

		*v = sum_snap_zero(*v);
	}
	return NULL;
}

/* Makes the map to view, p axes + origin, or back, p axes' + eye. Of origin and eye
 * one is given, at, and the other is minus the products of at with the axes, or with
 * their transpose: an exact polynomial, divided once. So for an eye (1,2,3) that looks
 * at the origin x . eye is 0, where rounded axes would give -4.9e-32. */
static void camera_stand(const struct axis a[3], const double at[3],
    bool by_origin, bool inverse, struct map *r)
{
	bool exact = a[1].length.error.m == 0;
	struct sum d = exact ? a[1].length : sum_of_double(1), minus[3];

	for (int i = 0; i < 3; i++)
		minus[i] = sum_of_double(-at[i]);
	map_identity(r);
	for (int i = 0; i < 3; i++) {
		const struct sum across[3] = { a[0].v[i], a[1].v[i],
			a[2].v[i] };
		struct sum given = sum_mul(d, sum_of_double(at[i]));
		struct sum found = vec3_dot(by_origin ? across : a[i].v, minus);

		if (!exact)
			found = sum_quotient(found, a[i].length);
		for (int k = 0; k < 3; k++)
			r->m[inverse ? i : k][inverse ? k : i] = exact ?
			    a[i].v[k] :
			    sum_quotient(a[i].v[k], a[i].length);
		r->m[3][i] = by_origin == inverse ? found : given;
		r->origin[i] = inverse ?
		    0 :
		    sum_ratio(by_origin ? found : given, d);
	}
	r->m[3][3] = d;
	map_divide(r, d);
}

/* Turns view space about its z. */
static void camera_roll(double roll, enum angle_unit unit, bool inverse,
    struct map *r)
{
	struct sum s = trig_sin(roll, unit);
	struct map turn;

	map_identity(&turn);
	turn.m[0][0] = turn.m[1][1] = trig_cos(roll, unit);
	turn.m[0][1] = sum_negated_if(inverse, s);
	turn.m[1][0] = sum_negated_if(!inverse, s);
	map_append(r, &turn, inverse);
}

/* Makes the map of the matrix or pose as it is given, or of its nearest rotation above
 * its last row. A pose is a matrix that leads back. */
static const char *camera_bare(const struct camera *c, bool inverse,
    struct map *r)
{
	bool pose = c->kind == CAMERA_POSE, back = inverse != pose;
	struct axis axis[3];

	map_of_doubles(c->matrix, r);
	if (!map_is_affine(r))
		return not_affine[pose];
	if (!c->orthonormalize) {
		struct map regular;

		if ((pose || inverse) && !map_inverse(c->matrix, &regular))
			return singular[pose];
		if (back)
			*r = regular;
		return NULL;
	}
	const char *why = orthonormal(c, axis);

	if (why != NULL)
		return why;
	camera_stand(axis, c->matrix[3], true, back, r);
	for (int i = 0; i < 3 && pose; i++)
		r->origin[i] = inverse ? 0 : c->matrix[3][i];
	return NULL;
}

const char *camera_map(const struct camera *c,
    const struct convention *convention, bool inverse, struct map *r)
{
	bool by_origin = c->kind == CAMERA_TRANSLATION ||
	    c->kind == CAMERA_RVEC_TRANSLATION;
	bool by_rvec = c->kind == CAMERA_RVEC ||
	    c->kind == CAMERA_RVEC_TRANSLATION;
	struct axis axis[3];

	if (c->kind == CAMERA_MATRIX || c->kind == CAMERA_POSE)
		return camera_bare(c, inverse, r);
	const char *why = c->kind <= CAMERA_GAZE ? look(c, convention, axis) :
	    by_rvec                              ? turn_about(c, axis) :
						   orient(c, axis);

	if (why != NULL)
		return why;
	camera_stand(axis, c->eye, by_origin, inverse, r);
	if (c->roll != 0)
		camera_roll(convention->view_y_down ? -c->roll : c->roll,
		    c->unit, inverse, r);
	return NULL;
}
