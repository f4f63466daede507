#include "camera.h"

#include <string.h>

#include "trig.h"
#include "vec3.h"

/* An axis is v / length. The two are kept apart, as v is an exact polynomial of
 * the parameters, in sums of which terms cancel exactly. */
struct axis {
	ex v[3];
	ex length;
};

/* x = up x z and y = z x x before either is normalised: exact polynomials of
 * lengths |up x z| and |z| |up x z|. */
static const char *look(const struct camera *c, bool right_handed,
    struct axis axis[3])
{
	ex up[3];
	struct axis *x = &axis[0], *y = &axis[1], *z = &axis[2];
	bool at = c->by == CAMERA_AT;

	for (int i = 0; i < 3; i++) {
		z->v[i] = at ? ex_diff(c->at[i], c->eye[i]) : ex_of(c->at[i]);
		if (right_handed)
			z->v[i] = ex_neg(z->v[i]);
		up[i] = ex_of(c->up[i]);
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
	ex xx = vec3_dot(x->v, x->v), zz = vec3_dot(z->v, z->v);
	/* |sin| of the angle between up and gaze is below 2^-50 */
	ex bound = ex_shift(ex_mul(vec3_dot(up, up), zz), -100);

	if (ex_sign(ex_sub(xx, bound)) < 0)
		return "/camera/up: parallel to the gaze; "
		       "choose another up vector";
	x->length = ex_sqrt(xx);
	z->length = ex_sqrt(zz);
	y->length = ex_mul(x->length, z->length);
	return NULL;
}

/* The columns of the rotation matrix of a quaternion, times its norm. */
static void turn(ex q[4], struct axis axis[3])
{
	ex p[4][4];

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			p[i][j] = ex_mul(q[i], q[j]);
	ex norm = ex_add(ex_add(p[0][0], p[1][1]), ex_add(p[2][2], p[3][3]));

	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;
		ex along = ex_add(p[3][3], p[i][i]);

		axis[i].length = norm;
		axis[i].v[i] = ex_sub(along, ex_add(p[j][j], p[k][k]));
		axis[i].v[j] = ex_shift(ex_add(p[i][j], p[k][3]), 1);
		axis[i].v[k] = ex_shift(ex_sub(p[i][k], p[j][3]), 1);
	}
}

static const char *orient(const struct camera *c, struct axis axis[3])
{
	ex q[4];

	for (int i = 0; i < 4; i++)
		q[i] = ex_of(c->orientation[i]);
	if (vec3_is_zero(q) && ex_sign(q[3]) == 0)
		return "/camera/orientation: is zero; "
		       "no turn is [0, 0, 0, 1]";
	turn(q, axis);
	return NULL;
}

/* The symmetric matrix K with q K q = trace(Q' M) for the rotation Q of the
 * unit quaternion q: the nearest rotation to M belongs to the eigenvector of
 * its largest eigenvalue (Horn, "Closed-form solution of absolute orientation
 * using unit quaternions", 1987). */
static void horn(ex m[3][3], ex k[4][4])
{
	ex trace = ex_add(ex_add(m[0][0], m[1][1]), m[2][2]);

	k[3][3] = trace;
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, l = (i + 2) % 3;

		k[i][i] = ex_sub(ex_shift(m[i][i], 1), trace);
		k[i][j] = k[j][i] = ex_add(m[i][j], m[j][i]);
		k[i][3] = k[3][i] = ex_sub(m[l][j], m[j][l]);
	}
}

/* The largest root of x^4 - 2 s x^2 - 8 d x + k, the characteristic polynomial
 * of K with s = |M|^2, d = det M, k = det K. From above, at sqrt(3 s), Newton's
 * steps descend to it, halving the distance until that is less than the gap to
 * the next root, then squaring it. The slope is the product of the distances to
 * the other roots, gap * 4 x^2 within a factor of 3; the last step leaves an
 * error below 2^-200 gap. False where the gap is below 2^-400 x. */
static bool largest_root(ex s, ex d, ex k, ex *x)
{
	double step, slope, x1;

	*x = ex_of(sqrt(3 * ex_round(s).hi));
	do {
		ex x2 = ex_mul(*x, *x);
		ex p = ex_mul(ex_sub(x2, ex_shift(s, 1)), *x);
		ex q = ex_mul(ex_sub(x2, s), *x);

		p = ex_add(ex_mul(ex_sub(p, ex_shift(d, 3)), *x), k);
		q = ex_shift(ex_sub(q, ex_shift(d, 1)), 2);
		slope = ex_round(q).hi;
		step = ex_div(p, q).hi;
		x1 = ex_round(*x).hi;
		if (!(slope > 0x1p-398 * x1 * x1 * x1))
			return false;
		*x = ex_first(ex_sub(*x, ex_of(step)), 12);
	} while (fabs(step) > 0x1p-154 * slope / (x1 * x1));
	return true;
}

/* The largest column of the adjugate of K - x, which is a multiple of q q'. */
static void eigenvector(ex k[4][4], ex q[4])
{
	double most = 0;
	int best = 0;

	for (int i = 0; i < 4; i++) {
		double d = fabs(ex_round(ex_minor(3, k, 1u << i, 1u << i)).hi);

		if (d > most) {
			most = d;
			best = i;
		}
	}
	for (int i = 0; i < 4; i++) {
		ex c = ex_minor(3, k, 1u << best, 1u << i);

		q[i] = ex_first((best + i) % 2 ? ex_neg(c) : c, 6);
	}
}

/* The nearest rotation to the upper 3x3. q is within 2^-200, and what is not
 * larger than that makes of an element is 0. */
static const char *orthonormal(const struct camera *c, struct axis axis[3])
{
	ex m[3][3], k[4][4], s = ex_of(0), q[4], x;
	double largest = 0;
	int e;

	for (int i = 0; i < 9; i++)
		largest = fmax(largest, fabs(c->matrix[i / 3][i % 3]));
	frexp(largest, &e);
	for (int i = 0; i < 9; i++) {
		ex a = ex_shift(ex_of(c->matrix[i / 3][i % 3]), -e);

		m[i / 3][i % 3] = k[i / 3][i % 3] = a;
		s = ex_add(s, ex_mul(a, a));
	}
	ex det = ex_minor(3, k, 8, 8);

	if (ex_sign(det) <= 0)
		return "/camera/matrix: its determinant is not positive; "
		       "a rotation's is 1";
	horn(m, k);
	if (!largest_root(s, det, ex_minor(4, k, 0, 0), &x))
		return "/camera/matrix: two directions have all but vanished; "
		       "no rotation is the nearest";
	for (int i = 0; i < 4; i++)
		k[i][i] = ex_sub(k[i][i], x);
	eigenvector(k, q);
	turn(q, axis);
	for (int i = 0; i < 9; i++) {
		struct axis *a = &axis[i / 3];

		if (fabs(ex_div(a->v[i % 3], a->length).hi) < 0x1p-190)
			a->v[i % 3] = ex_of(0);
	}
	return NULL;
}

/* The matrix without roll: the axes as columns, and as its fourth row minus
 * their products with the eye, at: an exact polynomial, divided once. So for an
 * eye (1,2,3) that looks at the origin x . eye is 0, where rounded axes would
 * give -4.9e-32. */
static void elements(struct axis axis[3], const double at[3], ex e[4][3])
{
	ex p[3] = { ex_of(-at[0]), ex_of(-at[1]), ex_of(-at[2]) };

	for (int i = 0; i < 3; i++) {
		ex image = vec3_dot(axis[i].v, p);

		for (int k = 0; k < 4; k++)
			e[k][i] = ex_quotient(k < 3 ? axis[i].v[k] : image,
			    axis[i].length);
	}
}

/* Times [cos sin; -sin cos]; size gets the sums of |products|. */
static void turn_image(double roll, ex e[4][3], ex size[4][3])
{
	ex s = sin_deg(roll), c = cos_deg(roll);

	for (int k = 0; k < 4; k++) {
		ex xc = ex_mul(e[k][0], c), yc = ex_mul(e[k][1], c);
		ex xs = ex_mul(e[k][0], s), ys = ex_mul(e[k][1], s);

		size[k][0] = ex_add(ex_abs(xc), ex_abs(ys));
		size[k][1] = ex_add(ex_abs(yc), ex_abs(xs));
		size[k][2] = ex_abs(e[k][2]);
		e[k][0] = ex_settled(ex_sub(xc, ys), size[k][0]);
		e[k][1] = ex_settled(ex_add(yc, xs), size[k][1]);
	}
}

static void put(struct map *r, int i, int j, ex e, ex size)
{
	r->m[i][j] = ex_round(e);
	r->sum[i][j] = ex_round(size).hi;
}

/* Where a camera stands: to view (p - at) axes, or back p axes' + at. */
static struct map stand(struct axis axis[3], double roll, const double at[3],
    bool inverse)
{
	struct map r = map_identity;
	ex e[4][3], size[4][3];

	elements(axis, at, e);
	turn_image(roll, e, size);
	for (int i = 0; i < 3; i++)
		for (int k = 0; k < 3; k++)
			put(&r, inverse ? i : k, inverse ? k : i, e[k][i],
			    size[k][i]);
	for (int i = 0; i < 3; i++)
		if (inverse) {
			put(&r, AT_ORIGIN, i, ex_of(at[i]), ex_of(fabs(at[i])));
			put(&r, AT_ZERO, i, ex_of(at[i]), ex_of(fabs(at[i])));
		} else {
			put(&r, AT_ZERO, i, e[3][i], size[3][i]);
		}
	r.exact = inverse;
	if (!inverse)
		map_about(&r, at);
	return r;
}

static void transpose(struct axis axis[3])
{
	for (int i = 0; i < 3; i++)
		for (int k = 0; k < i; k++) {
			ex t = axis[i].v[k];

			axis[i].v[k] = axis[k].v[i];
			axis[k].v[i] = t;
		}
}

/* The matrix as it is given, or its nearest rotation above its last row. */
static const char *bare(const struct camera *c, bool inverse, struct map *r)
{
	double m[4][4];
	struct axis axis[3];

	memcpy(m, c->matrix, sizeof m);
	*r = map_of_doubles(m);
	if (!map_is_affine(r))
		return "/camera/matrix: its last column is not 0 0 0 1; "
		       "write the rows as \"vectors\" says";
	if (!c->orthonormalize)
		return !inverse || map_inverse(m, r) ?
		    NULL :
		    "/camera/matrix: singular; it can't be inverted";
	const char *why = orthonormal(c, axis);

	if (why != NULL)
		return why;
	transpose(axis);
	*r = stand(axis, 0, c->matrix[3], !inverse);
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
	*r = stand(axis, c->roll, c->eye, inverse);
	return NULL;
}
