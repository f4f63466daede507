/* SPDX-License-Identifier: MIT */
#include "rotation.h"

/* Computes the symmetric matrix K with q' K q = trace(Q' M), where Q is the rotation of
 * the unit quaternion q, and ' transposes. The quaternion of the rotation nearest to M
 * is the eigenvector of the largest eigenvalue of K (Horn, "Closed-form solution of
 * absolute orientation using unit quaternions", 1987). */
static void horn_matrix(const struct sum m[4][4], struct sum k[4][4])
{
	struct sum trace = sum_add(sum_add(m[0][0], m[1][1]), m[2][2]);

	k[3][3] = trace;
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, l = (i + 2) % 3;

		k[i][i] = sum_sub(sum_add(m[i][i], m[i][i]), trace);
		k[i][j] = k[j][i] = sum_add(m[i][j], m[j][i]);
		k[i][3] = k[3][i] = sum_sub(m[l][j], m[j][l]);
	}
}

/* Computes the largest eigenvalue x of K, the largest root of x^4 - 2 s x^2 - 8 d x +
 * k, where s = trace(M' M), d = det M and k = det K. Newton's iteration descends to x
 * from sqrt(3 s). Let gap be the distance from x to the second largest root. A step
 * halves the error until it is below gap, and then squares error / gap. The slope, the
 * product of the distances to the other roots, is gap * 4 x^2 within a factor of 3. The
 * last error is below 2^-260 gap. Returns false if gap < least x / 4; least is at least
 * 2^-398. */
static bool largest_root(struct sum s, struct sum d, struct sum k, double least,
    struct sum *x)
{
	double step, slope, x1;

	sum_set(x, sqrt(3 * sum_double(s)));
	do {
		struct sum x2 = sum_mul(*x, *x);
		struct sum p = sum_mul(sum_sub(x2, sum_scale(s, 2)), *x);
		struct sum q = sum_mul(sum_sub(x2, s), *x);

		p = sum_add(sum_mul(sum_sub(p, sum_scale(d, 8)), *x), k);
		q = sum_scale(sum_sub(q, sum_scale(d, 2)), 4);
		slope = sum_double(q);
		struct sum exact_step = sum_quotient(p, q);

		step = sum_double(exact_step);
		x1 = sum_double(*x);
		if (!(slope > least * x1 * x1 * x1))
			return false;
		*x = sum_sub(*x, exact_step);
		*x = sum_truncate(*x, 16);
	} while (fabs(step) > 0x1p-154 * slope / (x1 * x1));
	return true;
}

/* Computes q, the eigenvector of K for the eigenvalue x, from k = K - x I: q is the
 * largest column of the adjugate of k, which is a multiple of q q'. The error of x,
 * below 2^-260 gap (see largest_root), adds multiples of the other three eigenvectors.
 * Each is shorter than 2^-260 times the adjugate's norm, and than 2^-259 times q. The
 * errors of the elements, for which see rotation_nearest, add 2^-256. */
static void eigenvector(const struct sum k[4][4], struct sum q[4])
{
	struct sum norm = sum_of_double(0);
	double most = 0;
	int best = 0;

	for (int i = 0; i < 4; i++) {
		struct sum c = map_minor(3, k, 1u << i, 1u << i);
		double d = fabs(sum_double(c));

		if (d > most) {
			most = d;
			best = i;
		}
	}
	for (int i = 0; i < 4; i++) {
		struct sum c = sum_negated_if((best + i) % 2,
		    map_minor(3, k, 1u << best, 1u << i));

		q[i] = sum_truncate(c, 8);
		norm = sum_add(norm, sum_abs(q[i]));
	}
	for (int i = 0; i < 4; i++)
		q[i] = sum_add_error(q[i], sum_scale(norm, 0x1p-255));
}

/* The words below the point that an element keeps, if the largest is from 1/2 to 1. A
 * double of a scene needs no more; a product of many matrices can have more. */
enum { ELEMENT_WORDS = 25 };

/* Let the elements have errors up to e. Then the determinant of their values must
 * exceed its error, and the quaternion is that of the values. K is off by less than 9
 * e, and so the quaternion turns by less than 9 e / gap: see `least` for gap. */
enum rotation_result rotation_nearest(const struct sum matrix[4][4], struct sum q[4])
{
	struct sum cut = sum_of_power(-64 * ELEMENT_WORDS);
	struct sum m[4][4] = { 0 }, k[4][4], x, s = sum_of_double(0);
	int top = -EX_RANGE, error = 0;

	for (int i = 0; i < 9; i++) {
		int e = ex_exponent(&matrix[i / 3][i % 3].value);

		top = e > top ? e : top;
	}
	const struct sum unit = sum_of_power(-top);

	for (int i = 0; i < 9; i++) {
		struct sum *a = &m[i / 3][i % 3];

		*a = sum_mul(unit, matrix[i / 3][i % 3]);
		int kept = a->value.n + a->value.e + ELEMENT_WORDS;

		if (kept < a->value.n) {
			cut.error = a->error;
			*a = sum_add_error(sum_truncate(*a, kept > 0 ? kept : 0), cut);
		}
		error = a->error > error ? a->error : error;
	}
	struct sum det = map_minor(3, m, 8, 8);

	if (sum_sign(det) <= 0)
		return ROTATION_NONE;
	for (int i = 0; i < 9; i++) {
		m[i / 3][i % 3].error = 0;
		s = sum_add(s, sum_mul(m[i / 3][i % 3], m[i / 3][i % 3]));
	}
	det = map_minor(3, m, 8, 8);
	/* gap > least x / 24 then makes 9 e / gap less than 2^-256 */
	double least = fmax(0x1p-398, ldexp(1, error - EX_RANGE + 265));

	horn_matrix(m, k);
	if (!largest_root(s, det, map_minor(4, k, 0, 0), least, &x))
		return ROTATION_MANY;
	for (int i = 0; i < 4; i++)
		k[i][i] = sum_sub(k[i][i], x);
	eigenvector(k, q);
	return ROTATION_FOUND;
}

/* Computes d times the rotation of Rodrigues' formula I + sine [v] + versine [v]^2 for
 * a vector v. [v] is the matrix with [v] p = v x p. */
static void rodrigues(const struct sum v[3], struct sum sine, struct sum versine,
    struct sum d, struct sum r[3][3])
{
	struct sum square[3];

	for (int i = 0; i < 3; i++)
		square[i] = sum_mul(v[i], v[i]);
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;
		struct sum both = sum_mul(versine, sum_mul(v[i], v[j]));
		struct sum turn = sum_mul(sine, v[k]);

		r[i][i] = sum_sub(d, sum_mul(versine, sum_add(square[j], square[k])));
		r[i][j] = sum_sub(both, turn);
		r[j][i] = sum_add(both, turn);
	}
}

/* For a vector of length t, sine is sin t / t, and versine is (1 - cos t) / t^2. */
bool rotation_about(const double vector[3], struct sum r[3][3])
{
	struct sum v[3], sine, versine;

	for (int i = 0; i < 3; i++)
		sum_set(&v[i], vector[i]);
	if (!trig_rodrigues(vec3_dot(v, v), &sine, &versine))
		return false;
	rodrigues(v, sine, versine, sum_of_double(1), r);
	return true;
}

/* For an angle t, d times sine is |v| sin t, and d times versine is 1 - cos t. */
bool rotation_by_angle(const double axis[3], double angle, enum angle_unit unit,
    struct sum r[3][3], struct sum *d)
{
	struct sum v[3], sine, cosine;

	trig_sin_cos(angle, unit, &sine, &cosine);
	for (int i = 0; i < 3; i++)
		sum_set(&v[i], axis[i]);
	*d = vec3_dot(v, v);
	rodrigues(v, sum_mul(sine, sum_sqrt(*d)), sum_sub(sum_one, cosine), *d, r);
	return !vec3_is_zero(v);
}

void rotation_of_quaternion(const struct sum q[4], struct sum r[3][3], struct sum *d)
{
	struct sum p[4][4];

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			p[i][j] = sum_mul(q[i], q[j]);
	*d = sum_add(sum_add(p[0][0], p[1][1]), sum_add(p[2][2], p[3][3]));
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;
		struct sum along = sum_add(p[3][3], p[i][i]);

		r[i][i] = sum_sub(along, sum_add(p[j][j], p[k][k]));
		r[j][i] = sum_scale(sum_add(p[i][j], p[k][3]), 2);
		r[k][i] = sum_scale(sum_sub(p[i][k], p[j][3]), 2);
	}
}

/* Four times the products of q's numbers are sums of elements: 4 q[k] q[k] has the
 * trace, and 4 q[k] q[n] two elements off the diagonal. The largest q[k] is at least
 * 1/2, so that its root and the quotients by it have the errors of the elements, no
 * larger. */
void rotation_quaternion(const struct sum r[3][3], struct sum q[4])
{
	struct sum p[4][4];
	int best = 3;

	for (int i = 0; i < 4; i++) {
		const int j = (i + 1) % 3, k = (i + 2) % 3;

		p[i][i] = sum_one;
		for (int n = 0; n < 3; n++)
			p[i][i] = sum_add(p[i][i],
			    sum_negated_if(i < 3 && n != i, r[n][n]));
		for (int n = i + 1; n < 3; n++)
			p[i][n] = p[n][i] = sum_add(r[i][n], r[n][i]);
		if (i < 3)
			p[i][3] = p[3][i] = sum_sub(r[k][j], r[j][k]);
	}
	for (int i = 0; i < 3; i++)
		if (sum_compare(p[i][i], p[best][best]) > 0)
			best = i;
	const struct sum twice = sum_scale(sum_sqrt(p[best][best]), 2);
	int first = 3;

	for (int i = 0; i < 4; i++)
		q[i] = sum_snap_zero(sum_quotient(p[best][i], twice));
	for (int i = 2; i >= 0 && sum_sign(q[3]) == 0; i--)
		if (sum_sign(q[i]) != 0)
			first = i;
	const bool minus = sum_sign(q[first]) < 0;

	for (int i = 0; i < 4; i++)
		q[i] = sum_negated_if(minus, q[i]);
}
