#include "mat.h"

#include <string.h>

#include "vec3.h"

void map_identity(struct map *r)
{
	memset(r, 0, sizeof *r);
	for (int i = 0; i < 4; i++)
		r->m[i][i] = sum_of_double(1);
}

void map_of_doubles(const double m[4][4], struct map *r)
{
	memset(r, 0, sizeof *r);
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			r->m[i][j] = sum_of_double(m[i][j]);
}

static bool is_one(const struct sum *a)
{
	return ex_compare(a->value, ex_of(1)) == 0;
}

bool map_is_affine(const struct map *a)
{
	for (int i = 0; i < 3; i++)
		if (sum_sign(a->m[i][3]) != 0)
			return false;
	return is_one(&a->m[3][3]);
}

const char *map_not_affine(const struct map *a, const char *transposed,
    const char *other)
{
	const struct sum *last = a->m[3];

	if (map_is_affine(a))
		return NULL;
	return vec3_is_zero(last) && is_one(&last[3]) ? transposed : other;
}

static bool is_identity(const struct map *a)
{
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			if (i == j ? !is_one(&a->m[i][j]) :
				     a->m[i][j].value.sign != 0)
				return false;
	return true;
}

bool map_is_finite(const struct map *a)
{
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			if (!isfinite(ex_double(a->m[i][j].value)))
				return false;
	return true;
}

static void set_element(struct map *r, int i, int j, const struct map *a,
    const struct map *b)
{
	const struct sum *x[4], *y[4];

	for (int k = 0; k < 4; k++) {
		x[k] = &a->m[i][k];
		y[k] = &b->m[k][j];
	}
	sum_dot(4, x, y, &r->m[i][j]);
}

void map_then(const struct map *a, const struct map *b, struct map *r)
{
	if (is_identity(a) || is_identity(b)) {
		*r = is_identity(a) ? *b : *a;
		return;
	}
	memcpy(r->origin, a->origin, sizeof r->origin);
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			set_element(r, i, j, a, b);
}

void map_column(const struct map *m, int j, const struct sum p[4],
    struct sum *r)
{
	const struct sum *const x[4] = { &p[0], &p[1], &p[2], &p[3] };
	const struct sum *const y[4] = { &m->m[0][j], &m->m[1][j], &m->m[2][j],
		&m->m[3][j] };

	sum_dot(4, x, y, r);
}

struct sum map_minor(int n, const struct sum m[4][4], unsigned rows,
    unsigned columns)
{
	struct sum s = sum_of_double(n == 0);
	int i = 0;
	bool minus = false;

	while (rows >> i & 1)
		i++;
	for (int j = 0; j < 4 && n > 0; j++) {
		if (columns >> j & 1)
			continue;
		if (m[i][j].value.sign != 0) {
			struct sum p = sum_mul(m[i][j],
			    map_minor(n - 1, m, rows | 1u << i,
				columns | 1u << j));

			s = sum_add(s, minus ? sum_neg(p) : p);
		}
		minus = !minus;
	}
	return s;
}

bool map_inverse(const double m[4][4], struct map *inverse)
{
	struct map a;

	map_of_doubles(m, &a);
	struct sum det = map_minor(4, a.m, 0, 0);

	if (sum_sign(det) == 0)
		return false;
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++) {
			struct sum c = map_minor(3, a.m, 1u << j, 1u << i);

			c = (i + j) % 2 ? sum_neg(c) : c;
			inverse->m[i][j] = sum_quotient(c, det);
		}
	for (int k = 0; k < 3; k++)
		inverse->origin[k] = map_is_affine(&a) ? m[3][k] : 0;
	return true;
}
