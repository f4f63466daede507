#include "mat.h"

#include <string.h>

#define ONE { 1, 0 }

const struct map map_identity = {
	.m = { [0][0] = ONE, [1][1] = ONE, [2][2] = ONE, [3][3] = ONE,
	    [4][3] = ONE },
	.sum = { [0][0] = 1, [1][1] = 1, [2][2] = 1, [3][3] = 1, [4][3] = 1 },
};

struct map map_of(dd m[4][4])
{
	struct map r = { 0 };

	for (int i = 0; i < 5; i++)
		for (int j = 0; j < 4; j++) {
			r.m[i][j] = m[i < 4 ? i : 3][j];
			r.sum[i][j] = fabs(r.m[i][j].hi);
		}
	return r;
}

struct map map_of_doubles(double m[4][4])
{
	dd d[4][4];

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			d[i][j] = (dd){ m[i][j], 0 };
	return map_of(d);
}

bool map_is_affine(const struct map *a)
{
	for (int i = 0; i < 4; i++)
		if (a->m[i][3].hi != (i == 3) || a->m[i][3].lo != 0)
			return false;
	return true;
}

bool map_is_finite(const struct map *a)
{
	for (int i = 0; i < 5; i++)
		for (int j = 0; j < 4; j++)
			if (!isfinite(a->m[i][j].hi))
				return false;
	return true;
}

/* Sets element i, j to row . column j of b, with the given last row of b. */
static void product(struct map *r, int i, int j, const dd row[4],
    const double sum[4], const struct map *b, int last)
{
	ex s = { 0 };

	r->sum[i][j] = 0;
	for (int k = 0; k < 4; k++) {
		int l = k < 3 ? k : last;

		if (row[k].hi == 0 || b->m[l][j].hi == 0)
			continue;
		s = ex_add(s, ex_mul(ex_dd(row[k]), ex_dd(b->m[l][j])));
		r->sum[i][j] += sum[k] * b->sum[l][j];
	}
	r->m[i][j] = ex_round(s);
	if (fabs(r->m[i][j].hi) <= MAP_BOUND * 0x1p-106 * r->sum[i][j])
		r->m[i][j] = (dd){ 0, 0 };
}

/* The image under a of its origin or of zero, as b wants it: relative to b's
 * origin, which is exact, where a is affine. */
static void image(struct map *r, int i, const struct map *a, const struct map *b)
{
	dd row[4];
	double sum[4];
	bool zero = true, affine = map_is_affine(a);

	for (int k = 0; k < 3; k++)
		zero &= a->m[i][k].hi == 0;
	for (int k = 0; k < 4; k++) {
		row[k] = a->m[i][k];
		sum[k] = a->sum[i][k];
		if (k < 3 && affine && !zero && b->origin[k] != 0) {
			row[k] = ex_round(ex_sub(ex_dd(row[k]),
			    ex_of(b->origin[k])));
			sum[k] = fabs(row[k].hi);
		}
	}
	for (int j = 0; j < 4; j++)
		product(r, i, j, row, sum, b,
		    affine && !zero ? AT_ORIGIN : AT_ZERO);
}

void map_about(struct map *a, const double origin[3])
{
	dd row[4] = { [3] = ONE };
	double sum[4] = { [3] = 1 };

	for (int k = 0; k < 3; k++) {
		a->origin[k] = origin[k];
		row[k] = (dd){ -origin[k], 0 };
		sum[k] = fabs(origin[k]);
	}
	for (int j = 0; j < 4; j++)
		product(a, AT_ZERO, j, row, sum, a, AT_ORIGIN);
}

void map_add(struct map *a, const double offset[3])
{
	for (int k = 0; k < 3; k++)
		for (int i = AT_ORIGIN; i <= AT_ZERO; i++) {
			a->m[i][k] = (dd){ offset[k], 0 };
			a->sum[i][k] = fabs(offset[k]);
		}
}

static bool is_identity(const struct map *a)
{
	return memcmp(a, &map_identity, sizeof *a) == 0;
}

struct map map_then(const struct map *a, const struct map *b)
{
	struct map r = { 0 };

	if (is_identity(a))
		return *b;
	if (is_identity(b))
		return *a;
	memcpy(r.origin, a->origin, sizeof r.origin);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 4; j++)
			product(&r, i, j, a->m[i], a->sum[i], b, AT_ZERO);
	image(&r, AT_ORIGIN, a, b);
	image(&r, AT_ZERO, a, b);
	return r;
}

ex ex_minor(int n, ex m[4][4], unsigned rows, unsigned columns)
{
	ex s = { 0 };
	int i = 0, sign = 1;

	if (n == 0)
		return ex_of(1);
	while (rows >> i & 1)
		i++;
	for (int j = 0; j < 4; j++) {
		if (columns >> j & 1)
			continue;
		if (m[i][j].n > 0) {
			ex p = ex_mul(m[i][j], ex_minor(n - 1, m, rows | 1u << i,
			    columns | 1u << j));

			s = sign > 0 ? ex_add(s, p) : ex_sub(s, p);
		}
		sign = -sign;
	}
	return s;
}

/* The power of two that brings the largest element near 2^100: products of
 * four stay below 2^500. */
static double scale_of(double m[4][4], int n)
{
	double largest = 0;
	int e = 0;

	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++)
			largest = fmax(largest, fabs(m[i][j]));
	frexp(largest, &e);
	return ldexp(1, 100 - e);
}

bool map_inverse(double m[4][4], struct map *inverse)
{
	struct map a = map_of_doubles(m);
	bool affine = map_is_affine(&a);
	int n = affine ? 3 : 4;
	double scale = scale_of(m, n);
	dd r[4][4] = { [3][3] = ONE };
	ex s[4][4];

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			s[i][j] = ex_of(m[i][j] * scale);
	unsigned out = affine ? 8 : 0;
	ex det = ex_minor(n, s, out, out);

	if (det.n == 0)
		return false;
	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++) {
			ex c = ex_minor(n - 1, s, out | 1u << j, out | 1u << i);

			r[i][j] = dd_scale(ex_div(c, det),
			    (i + j) % 2 ? -scale : scale);
		}
	*inverse = map_of(r);
	if (!affine)
		return true;
	map_about(inverse, m[3]);
	return true;
}
