/* SPDX-License-Identifier: MIT */
#include "camera.h"

#include <stdlib.h>
#include <string.h>

#include "../exact/rotation.h"

/* The axes of view space: axis i is the unit vector v[i] scale[i] / divisor. The
 * elements of v are polynomials, whose terms cancel exactly. */
struct axes {
	struct sum v[3][3], scale[3], divisor;
};

static bool is_same(const double a[3], const double b[3])
{
	return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Refuses a gaze, which may be at - eye, and an up that have no direction. */
static bool check_directions(const struct camera *c, struct refusals *faults)
{
	static const double zero[3] = { 0 };
	static const char no_direction[] = "has no direction",
			  remedy[] = "at least one element must not be 0";
	bool is_right = true;

	if (c->way == CAMERA_AT && is_same(c->at, c->eye))
		is_right = refuse(faults, "/camera/at", "equal to the eye",
		    "choose another point to look at");
	if (c->way == CAMERA_GAZE && is_same(c->at, zero))
		is_right = refuse(faults, "/camera/gaze", no_direction, remedy);
	if (is_same(c->up, zero))
		is_right = refuse(faults, "/camera/up", no_direction, remedy);
	return is_right;
}

/* Computes the axes of projcalc-numbers(7), FORMULAS, lookat: z = gaze or -gaze, then
 * x = cross(up, z) and y = cross(z, x). The length of y is |z| |x|. */
static bool axes_of_gaze(const struct camera *c, const struct convention *convention,
    struct axes *a, struct refusals *faults)
{
	struct sum up[3], *x = a->v[0], *y = a->v[1], *z = a->v[2];
	bool at = c->way == CAMERA_AT;

	if (!check_directions(c, faults))
		return false;
	for (int i = 0; i < 3; i++) {
		z[i] = sum_negated_if(convention->right_handed,
		    sum_difference(c->at[i], at ? c->eye[i] : 0));
		sum_set(&up[i], c->up[i]);
	}
	vec3_cross(up, z, x);
	vec3_cross(z, x, y);
	struct sum xx = vec3_dot(x, x), zz = vec3_dot(z, z);
	struct sum product = sum_mul(vec3_dot(up, up), zz);

	/* up and z count as parallel if the sine |x| / (|up| |z|) is below 2^-50 */
	if (sum_compare(xx, sum_scale(product, 0x1p-100)) < 0)
		return c->has_default_up ?
		    refuse(faults, "/camera/up",
			"is 0 1 0 by default, parallel to the gaze",
			"give one, such as [0, 0, 1]") :
		    refuse(faults, "/camera/up", "parallel to the gaze",
			"choose another up vector");
	struct sum x_length = sum_sqrt(xx), z_length = sum_sqrt(zz);

	a->divisor = sum_mul(x_length, z_length);
	if (sum_is_exact(&a->divisor)) {
		sum_copy(&a->scale[0], &z_length);
		sum_set(&a->scale[1], 1);
		sum_copy(&a->scale[2], &x_length);
	} else {
		a->scale[0] = sum_quotient(x_length, xx);
		a->scale[2] = sum_quotient(z_length, zz);
		sum_dot(1, &a->scale[0], &a->scale[2], 1, &a->scale[1]);
		sum_set(&a->divisor, 1);
	}
	for (int i = 0; i < 3 && convention->view_y_down; i++) {
		y[i] = sum_neg(y[i]);
		z[i] = sum_neg(z[i]);
	}
	return true;
}

/* The conjugate of the orientation turns from world to view space, as the rvec does. */
static bool axes_of_rotation(const struct camera *c, struct axes *a,
    struct refusals *faults)
{
	const bool by_rvec = c->way == CAMERA_RVEC || c->way == CAMERA_RVEC_TRANSLATION;
	struct sum q[4];

	sum_set(&a->divisor, 1);
	for (int i = 0; i < 3; i++)
		sum_set(&a->scale[i], 1);
	for (int i = 0; i < 4; i++)
		sum_set(&q[i], i < 3 ? -c->orientation[i] : c->orientation[i]);
	if (!by_rvec)
		rotation_of_quaternion(q, a->v, &a->divisor);
	else if (!rotation_about(c->rvec, a->v))
		return refuse(faults, "/camera/rvec", "is longer than 2 pi",
		    "its length is the angle in radians");
	return !sum_is_exact_zero(&a->divisor) ||
	    refuse(faults, "/camera/orientation", "is 0", "the identity is 0, 0, 0, 1");
}

/* Computes the map to view space or, if inverse, the map to world space:
 *	 x0  y0  z0  0		 x0  x1  x2  0
 *	 x1  y1  z1  0		 y0  y1  y2  0
 *	 x2  y2  z2  0		 z0  z1  z2  0
 *	 translation 1		 eye         1
 * `given` is the translation t, if is_translation, or else the eye. The other vector is
 * computed: t = (-x.eye, -y.eye, -z.eye), or, if all axes have the same length, eye =
 * -t0 x - t1 y - t2 z. Its elements are polynomials, divided only at the end. */
static void map_of_axes(const struct axes *a, const double given[3],
    bool is_translation, bool inverse, struct map *r)
{
	const struct sum *const d = &a->divisor;
	struct sum minus[3], found;
	double origin[3] = { 0 };

	for (int i = 0; i < 3; i++)
		sum_set(&minus[i], -given[i]);
	map_identity(r);
	for (int i = 0; i < 3; i++) {
		for (int k = 0; k < 3; k++)
			sum_dot(1, &a->v[i][k], &a->scale[i], 1,
			    &r->m[inverse ? i : k][inverse ? k : i]);
		sum_dot(3, minus, is_translation ? &a->v[0][i] : a->v[i],
		    is_translation ? 3 : 1, &found);
		sum_dot(1, &found, &a->scale[i], 1, &found);
		r->m[3][i] = is_translation == inverse ? found :
							 sum_scale(*d, given[i]);
		if (!inverse)
			origin[i] = is_translation ? sum_ratio(found, *d) : given[i];
	}
	sum_copy(&r->m[3][3], d);
	sum_copy(&r->m[4][3], d);
	map_divide(r, *d);
	if (is_translation || inverse)
		map_set_origin(r, origin);
	else /* row 4 is 0 0 0 1, the eye's image */
		memcpy(r->origin, origin, sizeof r->origin);
}

/* Rotates view space about its z axis: appends the rotation to r or, if inverse, puts
 * the inverse rotation before r. */
static void camera_roll(double roll, enum angle_unit unit, bool inverse, struct map *r)
{
	const struct sum one = sum_of_double(1);
	struct sum c, s;

	trig_sin_cos(inverse ? -roll : roll, unit, &s, &c);
	const struct map turn = { .m = { { c, s }, { sum_neg(s), c }, { [2] = one },
				      { [3] = one }, { [3] = one } },
		.divisor = one };

	map_multiply(r, &turn, inverse);
}

bool camera_mirrors(const struct camera *c, const struct convention *convention)
{
	bool odd = false,
	     right_handed = true; /* right, up and forward are left-handed */

	for (int i = 0; i < 3; i++)
		for (int k = 0; k <= i; k++)
			odd ^= abs(c->axes[k]) > abs(c->axes[i]);
	for (int i = 0; i < 3; i++)
		right_handed ^= c->axes[i] > 0;
	return c->has_axes && (right_handed != odd) != convention->right_handed;
}

/* Appends to a map to the camera's own frame the map from there to view space or, if
 * inverse, puts the map back before r, which leads from this frame: permutes columns or
 * rows, and negates those that point the other way. */
static void append_axes(const struct camera *c, const struct convention *convention,
    bool inverse, struct map *r)
{
	const int view[3] = { AXIS_RIGHT, convention->view_y_down ? AXIS_DOWN : AXIS_UP,
		convention_looks_back(convention) ? AXIS_BACK : AXIS_FORWARD };
	struct map own;

	map_copy(&own, r);
	for (int i = 0; i < 3; i++) {
		const int k = abs(c->axes[i]) - 1;
		const bool minus = c->axes[i] != view[k];

		for (int j = 0; j < 5; j++)
			if (!inverse)
				r->m[j][k] = sum_negated_if(minus, own.m[j][i]);
			else if (j < 4)
				r->m[k][j] = sum_negated_if(minus, own.m[i][j]);
		if (inverse)
			r->origin[k] = minus ? 0 - own.origin[i] : own.origin[i];
	}
}

const char *camera_3x3_pointer(const struct camera *c)
{
	return c->way == CAMERA_POSE ? "/camera/pose" :
	    c->way == CAMERA_MATRIX  ? "/camera/matrix" :
				       "/camera/rotation";
}

/* Replaces the upper 3x3 of an affine map by the nearest rotation or, if `inverts`, the
 * map by the inverse of this. An element of the rotation whose magnitude is at most its
 * error becomes 0. The origin of the inverse is the rounded translation. */
static bool orthonormalize(const char *pointer, struct map *r, bool inverts,
    struct refusals *faults)
{
	const struct sum divisor = r->divisor;
	struct sum q[4], v[3][3], d;
	struct map move;
	enum rotation_result found = rotation_nearest(r->m, q);
	double origin[3];

	if (found == ROTATION_NONE)
		return refuse(faults, pointer, "its determinant is not positive",
		    "a rotation's is 1");
	if (found == ROTATION_MANY)
		return refuse(faults, pointer, "two directions have all but vanished",
		    "no rotation is the nearest");
	rotation_of_quaternion(q, v, &d);
	map_identity(&move);
	for (int k = 0; k < 3; k++) {
		origin[k] = inverts ? map_element_nearest(r, 3, k, false) : 0;
		move.m[3][k] = sum_negated_if(inverts, r->m[3][k]);
		move.m[k][k] = divisor;
	}
	move.m[3][3] = move.divisor = divisor;
	map_set_origin(&move, origin);
	map_identity(r);
	for (int i = 0; i < 9; i++)
		r->m[i / 3][i % 3] = sum_quotient(
		    sum_snap_zero(inverts ? v[i % 3][i / 3] : v[i / 3][i % 3]), d);
	map_multiply(r, &move, inverts);
	return true;
}

/* Computes a map of a matrix or of steps or, if `inverts`, its inverse. If `regular`, a
 * singular matrix is refused in both directions. */
static bool map_of_steps(const struct camera *c, const struct steps *s, bool inverts,
    bool regular, struct map *r, struct refusals *faults)
{
	const char *const pointer = camera_3x3_pointer(c);
	const bool whole = !c->orthonormalize;

	return steps_map(s, pointer, whole && inverts, whole && regular, r, faults) &&
	    (whole || orthonormalize(pointer, r, inverts, faults));
}

/* Computes, by the camera's rotation with the translation or the eye, the map from
 * world to view space or, if inverse, back. */
static bool camera_rotation_map(const struct camera *c, bool inverse, struct map *r,
    struct refusals *faults)
{
	const bool is_translation = !camera_has_eye(c);
	struct steps s = { .matrix = { { 0 }, { 0 }, { 0 }, { 0, 0, 0, 1 } } };
	struct sum minus[3];

	for (int i = 0; i < 9; i++)
		s.matrix[i / 3][i % 3] = c->rotation[i % 3][i / 3];
	for (int k = 0; k < 3 && is_translation; k++)
		s.matrix[3][k] = c->eye[k];
	if (!map_of_steps(c, &s, inverse, true, r, faults))
		return false;
	if (is_translation)
		return true;
	for (int k = 0; k < 3; k++)
		sum_set(&minus[k], -c->eye[k]);
	for (int k = 0; k < 3; k++)
		if (inverse)
			r->m[3][k] = sum_scale(r->divisor, c->eye[k]);
		else
			sum_dot(3, minus, &r->m[0][k], 4, &r->m[3][k]);
	map_set_origin(r, inverse ? NULL : c->eye);
	for (int k = 0; k < 3 && !inverse; k++)
		sum_set(&r->m[4][k], 0); /* the eye's image */
	return true;
}

/* Computes the map from the world to the camera's own frame or, if inverse, back. */
static bool own_map(const struct camera *c, const struct convention *convention,
    bool inverse, struct map *r, struct refusals *faults)
{
	const bool is_pose = c->way == CAMERA_POSE;
	struct axes axes;

	if (camera_is_by_steps(c))
		return map_of_steps(c, &c->steps, inverse != is_pose, is_pose, r,
		    faults);
	if (camera_gives_3x3(c))
		return camera_rotation_map(c, inverse, r, faults);
	if (!(camera_is_by_gaze(c) ? axes_of_gaze(c, convention, &axes, faults) :
				     axes_of_rotation(c, &axes, faults)))
		return false;
	map_of_axes(&axes, c->eye, !camera_has_eye(c), inverse, r);
	return true;
}

bool camera_map(const struct camera *c, const struct convention *convention,
    bool inverse, struct map *r, struct refusals *faults)
{
	if (!own_map(c, convention, inverse, r, faults))
		return false;
	if (c->has_axes)
		append_axes(c, convention, inverse, r);
	if (c->roll != 0 && !camera_is_by_steps(c))
		camera_roll(convention->view_y_down ? -c->roll : c->roll, c->unit,
		    inverse, r);
	return true;
}

static bool are_known(int n, const double *v)
{
	bool are = true;

	for (int i = 0; i < n; i++)
		are &= !isnan(v[i]);
	return are;
}

/* Returns whether the numbers are known that turn a camera of this way. */
static bool knows_turn(const struct camera *c)
{
	switch (c->way) {
	case CAMERA_AT:
	case CAMERA_GAZE:
		return are_known(3, c->eye) && are_known(3, c->at) &&
		    are_known(3, c->up);
	case CAMERA_ORIENTATION:
	case CAMERA_TRANSLATION:
		return are_known(4, c->orientation);
	case CAMERA_RVEC:
	case CAMERA_RVEC_TRANSLATION:
		return are_known(3, c->rvec);
	case CAMERA_ROTATION:
	case CAMERA_ROTATION_TRANSLATION:
		return are_known(9, c->rotation[0]);
	case CAMERA_POSE:
	case CAMERA_MATRIX: /* its steps are marked */
		break;
	}
	return true;
}

/* Axes and a roll are compared with nothing, and an eye or a translation only with the
 * point that is looked at: else one that is not known becomes 0. */
bool camera_check(const struct camera *given, const struct convention *convention,
    bool inverse, struct refusals *faults)
{
	struct camera c = *given;
	struct map r;

	for (int k = 0; k < 3; k++)
		if (isnan(c.eye[k]) && c.way != CAMERA_AT)
			c.eye[k] = 0;
	c.has_axes = false;
	c.roll = 0;
	if (knows_turn(&c))
		return camera_map(&c, convention, inverse, &r, faults);
	return !camera_is_by_gaze(&c) || check_directions(&c, faults);
}
