#include "camera.h"

#include <string.h>

#include "rotation.h"
#include "trig.h"
#include "vec3.h"

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
static const char *look(const struct camera *c, bool right_handed,
    struct axis axis[3])
{
	struct sum up[3];
	struct axis *x = &axis[0], *y = &axis[1], *z = &axis[2];
	bool at = c->by == CAMERA_AT;

	for (int i = 0; i < 3; i++) {
		z->v[i] = sum_of(
		    at ? ex_diff(c->at[i], c->eye[i]) : ex_of(c->at[i]));
		if (right_handed)
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
	ex bound = ex_mul(vec3_dot(up, up).value, zz.value);

	if (ex_compare(xx.value, ex_shift(bound, -100)) < 0)
		return "/camera/up: parallel to the gaze; "
		       "choose another up vector";
	x->length = sum_sqrt(xx);
	z->length = sum_sqrt(zz);
	y->length = sum_mul(x->length, z->length);
	if (y->length.size.m == 0) {
		struct sum along = x->length;

		lengthen(x, z->length);
		lengthen(z, along);
	}
	return NULL;
}

static struct sum twice(struct sum a)
{
	return sum_add(a, a);
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
		axis[i].v[j] = twice(sum_add(p[i][j], p[k][3]));
		axis[i].v[k] = twice(sum_sub(p[i][k], p[j][3]));
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

/* The nearest rotation to the upper 3x3, of which nothing is left that may be no
 * more than the error of its quaternion. */
static const char *orthonormal(const struct camera *c, struct axis axis[3])
{
	struct sum q[4];
	const char *why = nearest_rotation(c->matrix, q);

	if (why != NULL)
		return why;
	turn(q, axis);
	for (int i = 0; i < 9; i++) {
		struct sum *v = &axis[i / 3].v[i % 3];

		v->size = axis[i / 3].length.size;
		*v = sum_settled(*v);
	}
	return NULL;
}

/* The matrix without roll: the axes as columns, and as its fourth row minus
 * their products with the eye, at: an exact polynomial, divided once. So for an
 * eye (1,2,3) that looks at the origin x . eye is 0, where rounded axes would
 * give -4.9e-32. */
static void elements(const struct axis axis[3], const double at[3], bool exact,
    struct sum e[4][3])
{
	struct sum p[3];

	for (int k = 0; k < 3; k++)
		p[k] = sum_of_double(-at[k]);
	for (int i = 0; i < 3; i++) {
		struct sum image = vec3_dot(axis[i].v, p);

		for (int k = 0; k < 4; k++) {
			e[k][i] = k < 3 ? axis[i].v[k] : image;
			if (!exact)
				e[k][i] = sum_quotient(e[k][i], axis[i].length);
		}
	}
}

/* Times [cos sin; -sin cos]. */
static void turn_image(double roll, struct sum e[4][3])
{
	struct sum s = sin_deg(roll), c = cos_deg(roll);

	for (int k = 0; k < 4; k++) {
		struct sum x = e[k][0], y = e[k][1];

		e[k][0] = sum_sub(sum_mul(x, c), sum_mul(y, s));
		e[k][1] = sum_add(sum_mul(y, c), sum_mul(x, s));
	}
}

/* Where a camera stands: to view (p - at) axes, or back p axes' + at. */
static void stand(const struct axis axis[3], double roll, const double at[3],
    bool inverse, struct map *r)
{
	bool exact = axis[1].length.size.m == 0;
	struct sum e[4][3], d = exact ? axis[1].length : sum_of_double(1);

	elements(axis, at, exact, e);
	turn_image(roll, e);
	map_identity(r);
	for (int i = 0; i < 3; i++) {
		for (int k = 0; k < 3; k++)
			r->m[inverse ? i : k][inverse ? k : i] = e[k][i];
		r->m[3][i] = inverse ? sum_mul(d, sum_of_double(at[i])) :
				       e[3][i];
		r->origin[i] = inverse ? 0 : at[i];
	}
	r->m[3][3] = d;
	map_over(r, d);
}

static void transpose(struct axis axis[3])
{
	for (int i = 0; i < 3; i++)
		for (int k = 0; k < i; k++) {
			struct sum t = axis[i].v[k];

			axis[i].v[k] = axis[k].v[i];
			axis[k].v[i] = t;
		}
}

/* The matrix as it is given, or its nearest rotation above its last row. */
static const char *bare(const struct camera *c, bool inverse, struct map *r)
{
	struct axis axis[3];

	map_of_doubles(c->matrix, r);
	if (!map_is_affine(r))
		return "/camera/matrix: its last column is not 0 0 0 1; "
		       "write the rows as \"vectors\" says";
	if (!c->orthonormalize)
		return !inverse || map_inverse(c->matrix, r) ?
		    NULL :
		    "/camera/matrix: singular; it can't be inverted";
	const char *why = orthonormal(c, axis);

	if (why != NULL)
		return why;
	transpose(axis);
	stand(axis, 0, c->matrix[3], !inverse, r);
	return NULL;
}

const char *camera_map(const struct camera *c, bool right_handed, bool inverse,
    struct map *r)
{
	struct axis axis[3];

	if (c->by == CAMERA_MATRIX)
		return bare(c, inverse, r);
	const char *why = c->by == CAMERA_ORIENTATION ?
	    orient(c, axis) :
	    look(c, right_handed, axis);

	if (why != NULL)
		return why;
	stand(axis, c->roll, c->eye, inverse, r);
	return NULL;
}
