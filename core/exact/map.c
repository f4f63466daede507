/* SPDX-License-Identifier: MIT */
#include "map.h"

#include <string.h>

struct sum vec3_dot(const struct sum a[3], const struct sum b[3])
{
	struct sum r;

	sum_dot(3, a, b, 1, &r);
	return r;
}

void vec3_cross(const struct sum a[3], const struct sum b[3], struct sum r[3])
{
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		r[i] = sum_minor(a[j], b[k], a[k], b[j]);
	}
}

/* Returns the length of a. By the triangle inequality its error is at most the sum of
 * the elements' errors, which can be less than the bound that sum_sqrt computes. */
struct sum vec3_length(const struct sum a[3])
{
	struct sum r = sum_sqrt(vec3_dot(a, a));

	if (sum_is_exact(&r))
		return r;
	r = sum_with_error(r, SUM_QUOTIENT_ERROR);
	for (int i = 0; i < 3; i++)
		if (!sum_is_exact(&a[i]))
			r = sum_add(r, (struct sum){ .error = a[i].error });
	return r;
}

void vec3_normalise(struct sum a[3])
{
	struct sum length = vec3_length(a);

	for (int i = 0; i < 3; i++)
		a[i] = sum_quotient(a[i], length);
}

bool vec3_is_zero(const struct sum a[3])
{
	return sum_sign(a[0]) == 0 && sum_sign(a[1]) == 0 && sum_sign(a[2]) == 0;
}

void map_identity(struct map *r)
{
	static const double one[4][4] = { { 1 }, { 0, 1 }, { 0, 0, 1 },
		{ 0, 0, 0, 1 } };

	map_of_doubles(one, r);
}

void map_copy(struct map *r, const struct map *a)
{
	memcpy(r->origin, a->origin, sizeof r->origin);
	sum_copy(&r->divisor, &a->divisor);
	for (int i = 0; i < 20; i++)
		sum_copy(&r->m[i / 4][i % 4], &a->m[i / 4][i % 4]);
}

void map_of_doubles(const double m[4][4], struct map *r)
{
	memset(r->origin, 0, sizeof r->origin);
	sum_set(&r->divisor, 1);
	for (int i = 0; i < 16; i++)
		sum_set(&r->m[i / 4][i % 4], m[i / 4][i % 4]);
	for (int j = 0; j < 4; j++)
		sum_copy(&r->m[4][j], &r->m[3][j]);
}

void map_set_origin(struct map *r, const double origin[3])
{
	struct sum p[4];

	for (int k = 0; k < 3; k++) {
		r->origin[k] = origin != NULL ? origin[k] : 0;
		sum_set(&p[k], r->origin[k]);
	}
	sum_set(&p[3], 1);
	for (int j = 0; j < 4; j++)
		sum_dot(4, p, &r->m[0][j], 4, &r->m[4][j]);
}

/* Solves for the point in doubles by Cramer's rule. Its coordinates are rounded to 24
 * bits, so that points of few digits differ from it by few digits. A map that is
 * singular in doubles, for which `size` is not finite, keeps its origin. */
void map_find_origin(struct map *r)
{
	double a[4][3], minor[3], o[3], det = 0, size = 0;
	int e;
	bool far = false;

	for (int j = 0; j < 3; j++)
		far |= r->m[4][j].value.n > 0 &&
		    ex_exponent(&r->m[4][j].value) >
			ex_exponent(&r->m[3][j].value) - 20;
	if (!far)
		return;
	for (int i = 0; i < 12; i++)
		a[i / 3][i % 3] = map_element_nearest(r, i / 3, i % 3, false);
	for (int k = 0; k < 3; k++) {
		const double *u = a[(k + 1) % 3], *v = a[(k + 2) % 3];

		for (int i = 0; i < 3; i++)
			minor[i] = u[(i + 1) % 3] * v[(i + 2) % 3] -
			    u[(i + 2) % 3] * v[(i + 1) % 3];
		o[k] = 0;
		for (int i = 0; i < 3; i++) {
			det += k == 0 ? a[0][i] * minor[i] : 0;
			o[k] -= a[3][i] * minor[i];
		}
	}
	for (int k = 0; k < 3; k++) {
		o[k] = frexp(o[k] / det, &e);
		o[k] = ldexp(rint(ldexp(o[k], 24)), e - 24);
		size += fabs(o[k]);
	}
	if (size < 0x1p498)
		map_set_origin(r, o);
}

static void divide_element(struct sum *a, const struct sum *d)
{
	if (!sum_is_exact_zero(a) && !sum_is_one(d))
		*a = sum_quotient(*a, *d);
}

/* Multiplies the divisor by |d|, and the elements by the sign of d. If the divisor
 * becomes a power of two, divides the elements by it, and sets the divisor to 1. */
void map_divide(struct map *r, struct sum d)
{
	struct sum factor = sum_of_double(d.value.sign);

	r->divisor = sum_mul(r->divisor, sum_abs(d));
	if (sum_is_power_of_two(&r->divisor)) {
		factor = sum_quotient(factor, r->divisor);
		sum_set(&r->divisor, 1);
	}
	for (int i = 0; i < 20 && !sum_is_one(&factor); i++)
		sum_dot(1, &r->m[i / 4][i % 4], &factor, 1, &r->m[i / 4][i % 4]);
}

void map_divide_column(struct map *r, int j, struct sum d)
{
	if (!sum_is_exact(&d) || sum_is_power_of_two(&d)) {
		for (int i = 0; i < 5; i++)
			divide_element(&r->m[i][j], &d);
		return;
	}
	for (int i = 0; i < 5; i++)
		for (int k = 0; k < 4; k++)
			if (k != j && !sum_is_exact_zero(&r->m[i][k]))
				sum_dot(1, &r->m[i][k], &d, 1, &r->m[i][k]);
	map_divide(r, d);
}

bool map_is_affine(const struct map *a)
{
	for (int i = 0; i < 3; i++)
		if (sum_sign(a->m[i][3]) != 0)
			return false;
	return sum_compare(a->m[3][3], a->divisor) == 0;
}

static bool is_identity(const struct map *a)
{
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			if (i == j ? !sum_is_one(&a->m[i][j]) :
				     !sum_is_exact_zero(&a->m[i][j]))
				return false;
	return sum_is_one(&a->divisor);
}

/* Rounds only elements / divisor that can be 2^960 or more; the others are finite. */
bool map_is_finite(const struct map *a)
{
	int most = a->divisor.value.e + a->divisor.value.n + 14;

	for (int i = 0; i < 16; i++) {
		const ex *m = &a->m[i / 4][i % 4].value;

		if (m->e + m->n > most &&
		    !isfinite(map_element_nearest(a, i / 4, i % 4, false)))
			return false;
	}
	return true;
}

void map_image(const struct map *m, int j, const struct sum p[4], struct sum *r)
{
	if (m->m[3][j].error <= m->m[4][j].error) {
		sum_dot(4, p, &m->m[0][j], 4, r);
		return;
	}
	struct sum q[5] = { [4] = p[3] }; /* factors of rows 0 to 4 */

	for (int k = 0; k < 3; k++)
		q[k] = sum_minor(p[k], sum_one, p[3], sum_of_double(m->origin[k]));
	sum_dot(5, q, &m->m[0][j], 4, r);
}

void map_multiply(struct map *r, const struct map *factor, bool before)
{
	if (is_identity(factor))
		return;
	if (is_identity(r)) {
		map_copy(r, factor);
		return;
	}
	struct map old;

	map_copy(&old, r);
	const struct map *a = before ? factor : &old, *b = before ? &old : factor;

	memcpy(r->origin, a->origin, sizeof r->origin);
	r->divisor = sum_mul(a->divisor, b->divisor);
	for (int i = 0; i < 5; i++)
		for (int j = 0; j < 4; j++)
			map_image(b, j, a->m[i], &r->m[i][j]);
}

struct sum map_element(const struct map *a, int i, int j)
{
	struct sum e;

	sum_copy(&e, &a->m[i][j]);
	divide_element(&e, &a->divisor);
	return e;
}

double map_element_nearest(const struct map *a, int i, int j, bool single)
{
	return sum_ratio_nearest(&a->m[i][j], &a->divisor, single);
}

static void find_minor(int n, const struct sum m[4][4], unsigned skipped_rows,
    unsigned skipped_columns, struct sum *r)
{
	struct sum minor[4];
	int i = 0, sign = 1;

	if (n == 0) {
		sum_set(r, 1);
		return;
	}
	while (skipped_rows >> i & 1)
		i++;
	for (int j = 0; j < 4; j++) {
		sum_set(&minor[j], 0);
		if (skipped_columns >> j & 1)
			continue;
		if (!sum_is_exact_zero(&m[i][j]))
			find_minor(n - 1, m, skipped_rows | 1u << i,
			    skipped_columns | 1u << j, &minor[j]);
		minor[j].value.sign *= sign;
		sign = -sign;
	}
	sum_dot(4, m[i], minor, 1, r);
}

struct sum map_minor(int n, const struct sum m[4][4], unsigned skipped_rows,
    unsigned skipped_columns)
{
	struct sum r;

	find_minor(n, m, skipped_rows, skipped_columns, &r);
	return r;
}

bool map_invert(struct map *r)
{
	struct sum det = map_minor(4, r->m, 0, 0);
	struct map a;

	if (sum_sign(det) == 0)
		return false;
	map_copy(&a, r);
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			r->m[i][j] = sum_negated_if((i + j) % 2,
			    map_minor(3, a.m, 1u << j, 1u << i));
	sum_set(&r->divisor, 1);
	map_divide(r, det);
	for (int i = 0; i < 16 && !sum_is_one(&a.divisor); i++)
		r->m[i / 4][i % 4] = sum_mul(r->m[i / 4][i % 4], a.divisor);
	map_set_origin(r, NULL);
	return true;
}
