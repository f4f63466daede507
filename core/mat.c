#include "mat.h"

#include <string.h>

#define ONE          \
	{            \
		1, 0 \
	}

const struct map map_identity = {
	.m = { [0][0] = ONE,
	    [1][1] = ONE,
	    [2][2] = ONE,
	    [3][3] = ONE,
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
	struct map r;
	dd d[4][4];

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			d[i][j] = (dd){ m[i][j], 0 };
	r = map_of(d);
	r.exact = map_is_affine(&r);
	return r;
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
			if (!isfinite(a->m[i][j].hi) || !isfinite(a->sum[i][j]))
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
}

/* The image under a of its origin or of zero, taken to b: where it is known
 * exactly, by its difference from b's origin, which is exact too. */
static void image(struct map *r, int i, const struct map *a,
    const struct map *b)
{
	dd row[4];
	double sum[4];

	for (int k = 0; k < 4; k++) {
		row[k] = a->m[i][k];
		sum[k] = a->sum[i][k];
		if (k < 3 && a->exact) {
			row[k] = two_sum(row[k].hi, -b->origin[k]);
			sum[k] = fabs(row[k].hi);
		}
	}
	for (int j = 0; j < 4; j++)
		product(r, i, j, row, sum, b, a->exact ? AT_ORIGIN : AT_ZERO);
}

void map_about(struct map *a, const double origin[3])
{
	for (int k = 0; k < 3; k++) {
		a->origin[k] = origin[k];
		a->m[AT_ORIGIN][k] = (dd){ 0, 0 };
		a->sum[AT_ORIGIN][k] = 0;
	}
}

void map_about_zero(struct map *a)
{
	for (int j = 0; j < 4; j++) {
		a->m[AT_ORIGIN][j] = a->m[AT_ZERO][j];
		a->sum[AT_ORIGIN][j] = a->sum[AT_ZERO][j];
	}
	for (int k = 0; k < 3; k++)
		a->origin[k] = 0;
}

void map_settle(struct map *a)
{
	for (int i = 0; i < 5; i++)
		for (int j = 0; j < 4; j++)
			if (fabs(a->m[i][j].hi) <=
			    MAP_BOUND / 2 * 0x1p-106 * a->sum[i][j])
				a->m[i][j] = (dd){ 0, 0 };
}

struct sum map_column(const struct map *m, int j, const dd p[4])
{
	struct sum s = { { 0, 0 }, 0 };

	for (int i = 0; i < 4; i++) {
		s.value = dd_add(s.value, dd_mul(p[i], m->m[i][j]));
		s.size += fabs(p[i].hi) * m->sum[i][j];
	}
	if (fabs(s.value.hi) <= (MAP_BOUND + 13) * 0x1p-106 * s.size)
		s.value = (dd){ 0, 0 };
	return s;
}

static bool is_identity(const struct map *a)
{
	for (int i = 0; i < 5; i++)
		for (int j = 0; j < 4; j++)
			if (a->m[i][j].hi != map_identity.m[i][j].hi ||
			    a->m[i][j].lo != 0)
				return false;
	return true;
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
		if (ex_sign(m[i][j]) != 0) {
			ex p = ex_minor(n - 1, m, rows | 1u << i,
			    columns | 1u << j);

			p = ex_mul(m[i][j], p);
			s = sign > 0 ? ex_add(s, p) : ex_sub(s, p);
		}
		sign = -sign;
	}
	return s;
}

bool map_inverse(double m[4][4], struct map *inverse)
{
	struct map a = map_of_doubles(m);
	dd r[4][4];
	ex s[4][4];

	for (int i = 0; i < 16; i++)
		s[i / 4][i % 4] = ex_of(m[i / 4][i % 4]);
	ex det = ex_minor(4, s, 0, 0);

	if (ex_sign(det) == 0)
		return false;
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++) {
			ex c = ex_minor(3, s, 1u << j, 1u << i);
			dd q = ex_div(c, det);

			r[i][j] = (i + j) % 2 ? dd_neg(q) : q;
		}
	*inverse = map_of(r);
	if (a.exact)
		map_about(inverse, m[3]);
	return true;
}
