/* SPDX-License-Identifier: MIT */
#include "rotation.h"

#include <math.h>

#include "trig.h"

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
 * last error is below 2^-260 gap. Returns false if gap < 2^-400 x. */
static bool largest_root(struct sum s, struct sum d, struct sum k, struct sum *x)
{
	double step, slope, x1;

	*x = sum_of_double(sqrt(3 * sum_double(s)));
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
		if (!(slope > 0x1p-398 * x1 * x1 * x1))
			return false;
		*x = sum_sub(*x, exact_step);
		*x = sum_truncate(*x, 16);
	} while (fabs(step) > 0x1p-154 * slope / (x1 * x1));
	return true;
}

/* Computes q, the eigenvector of K for the eigenvalue x, from k = K - x I: q is the
 * largest column of the adjugate of k, which is a multiple of q q'. The error of x,
 * below 2^-260 gap (see largest_root), adds multiples of the other three eigenvectors.
 * Each is shorter than 2^-260 times the adjugate's norm, and than 2^-259 times q. */
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
		q[i] = sum_add_error(q[i], sum_scale(norm, 0x1p-257));
}

enum rotation_result rotation_nearest(const double matrix[4][4], struct sum q[4])
{
	struct sum m[4][4] = { 0 }, k[4][4], x, s = sum_of_double(0);
	double largest = 0;
	int e;

	for (int i = 0; i < 9; i++)
		largest = fmax(largest, fabs(matrix[i / 3][i % 3]));
	frexp(largest, &e);
	const struct sum unit = sum_of_power(-e);

	for (int i = 0; i < 9; i++) {
		struct sum *a = &m[i / 3][i % 3];

		*a = sum_scale(unit, matrix[i / 3][i % 3]);
		s = sum_add(s, sum_mul(*a, *a));
	}
	struct sum det = map_minor(3, m, 8, 8);

	if (sum_sign(det) <= 0)
		return ROTATION_NONE;
	horn_matrix(m, k);
	if (!largest_root(s, det, map_minor(4, k, 0, 0), &x))
		return ROTATION_MANY;
	for (int i = 0; i < 4; i++)
		k[i][i] = sum_sub(k[i][i], x);
	eigenvector(k, q);
	return ROTATION_FOUND;
}

/* Uses Rodrigues' formula I + a [v] + b [v]^2 for the vector v of length t. [v] is the
 * matrix with [v] p = v x p; a = sin t / t and b = (1 - cos t) / t^2. */
bool rotation_about(const double vector[3], struct sum r[3][3])
{
	struct sum v[3], square[3], a, b;

	for (int i = 0; i < 3; i++) {
		v[i] = sum_of_double(vector[i]);
		square[i] = sum_mul(v[i], v[i]);
	}
	if (!trig_rodrigues(vec3_dot(v, v), &a, &b))
		return false;
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;
		struct sum both = sum_mul(b, sum_mul(v[i], v[j]));
		struct sum turn = sum_mul(a, v[k]);

		r[i][i] = sum_sub(sum_of_double(1),
		    sum_mul(b, sum_add(square[j], square[k])));
		r[i][j] = sum_sub(both, turn);
		r[j][i] = sum_add(both, turn);
	}
	return true;
}
