/* SPDX-License-Identifier: MIT */
/* The extremes of a cloud of points: no point is farther along a direction, by MPFR,
 * for any order of the points, any division into pieces and any processor. */
#include "../derive/fit.h"

#include "../points/transform.h"
#include "claims.h"
#include "block.h"

enum { CLOUD = 300, ROOM = 304, PIECES = 3 };

struct cloud {
	size_t n;
	double p[CLOUD][3];
};

/* Samples points close to a plane through the first point along two other directions.
 * They are equally far along the normal of the plane but for rounding, or exactly if
 * they are on a lattice. */
static void sample_plane(struct cloud *c, const struct directions *d)
{
	double u[3], v[3];
	bool whole = sample_below(2);

	for (int i = 0; i < 3; i++) {
		const double *m = d->scaled[sample_below((unsigned)d->n)];
		int j = (i + 1) % 3, k = (i + 2) % 3;

		u[j] = m[k];
		u[k] = -m[j];
		u[i] = 0;
		v[i] = m[j] - m[k];
	}
	for (size_t n = 0; n < c->n; n++) {
		double s = sample_number(1), t = sample_number(1);

		for (int i = 0; i < 3; i++)
			c->p[n][i] = c->p[0][i] +
			    (whole ? round(s) * round(4 * u[i]) : s * u[i] + t * v[i]);
	}
}

/* Samples points far apart, or a few units in the last place from one another, or
 * equal. */
static void sample_cloud(struct cloud *c, const struct directions *d, int e)
{
	unsigned kind = sample_below(5);

	c->n = sample_below(4) == 0 ? 1 + sample_below(3) : 1 + sample_below(CLOUD);
	for (size_t n = 0; n < c->n; n++)
		for (int i = 0; i < 3; i++)
			c->p[n][i] = kind == 0 || n == 0 ? sample_number(e) :
			    kind == 1                    ? c->p[0][i] :
			    kind == 2                    ? (double)sample_below(4) :
					c->p[0][i] * (1 + sample_below(5) * 0x1p-52);
	if (kind == 3)
		sample_plane(c, d);
	for (size_t n = 1; n < c->n; n++)
		if (sample_below(20) == 0)
			c->p[n][sample_below(3)] = (double)NAN;
}

static void shuffle(struct cloud *c)
{
	for (size_t n = c->n; n > 1; n--) {
		size_t k = sample_below((unsigned)n);
		double p[3];

		memcpy(p, c->p[k], sizeof p);
		memcpy(c->p[k], c->p[n - 1], sizeof p);
		memcpy(c->p[n - 1], p, sizeof p);
	}
}

/* Adds the points in pieces, which are merged in any order. */
static void add_cloud(const struct cloud *c, const struct directions *d,
    struct extremes *all)
{
	static COLUMN_ALIGNED double in[3][ROOM];
	const double *const columns[3] = { in[0], in[1], in[2] };
	struct extremes piece[PIECES] = { 0 };

	memset(all, 0, sizeof *all);
	for (size_t n = 0, few; n < c->n; n += few) {
		few = 1 + sample_below((unsigned)(c->n - n));
		for (size_t k = 0; k < (few + 15) / 16 * 16; k++)
			for (int i = 0; i < 3; i++)
				in[i][k] = c->p[n + (k < few ? k : 0)][i];
		extremes_add(&piece[sample_below(PIECES)], d, columns, few);
	}
	for (int k = 0; k < PIECES; k++)
		extremes_merge(all, d, &piece[k]);
}

/* Returns how much farther p is than q. */
static struct sized farther_by(const struct sum exact[3], const double p[3],
    const double q[3])
{
	struct sized sum = sized_of(0);

	for (int i = 0; i < 3; i++) {
		struct sized m = { real_of_ex(exact[i].value),
			magnitude(real_of_ex(exact[i].value)) };

		sum = sized_add(sum,
		    sized_mul(m, sized_sub(sized_of(p[i]), sized_of(q[i]))));
	}
	return sum;
}

static bool has_nan(const double p[3])
{
	return isnan(p[0]) || isnan(p[1]) || isnan(p[2]);
}

static void assert_none_farther(const struct cloud *c, const struct directions *d,
    const struct extremes *e)
{
	for (int j = 0; j < d->n; j++) {
		size_t found = 0, points = 0;

		for (size_t n = 0; n < c->n; n++) {
			bool doubtful;

			if (has_nan(c->p[n]))
				continue;
			int mark = real_mark();
			int sign = truth_sign(farther_by(d->exact[j], c->p[n],
						  e->item[j].point),
			    &doubtful);

			assert_true(sign <= 0 || doubtful);
			found += memcmp(c->p[n], e->item[j].point, sizeof c->p[n]) == 0;
			points++;
			real_release(mark);
		}
		assert_true(e->item[j].known == (points > 0));
		assert_true(found > 0 || points == 0);
	}
}

/* Returns whether the extremes are equal. 0 is equal to -0. */
static bool are_same(const struct extremes *a, const struct extremes *b, int n)
{
	bool same = true;

	for (int j = 0; j < n; j++)
		for (int i = 0; i < 3; i++)
			same &= a->item[j].point[i] == b->item[j].point[i];
	return same;
}

static void farthest_many(int n, int e)
{
	int looked_at = 0;

	SAMPLES(i, n) {
		static struct cloud c;
		struct directions d;
		struct extremes first, again;
		struct scene s;

		sample_scene(&s, e / 2);
		s.projection.near = 1;
		s.projection.near_ratio = 0.001;
		if (!fit_directions(&s, sample_below(2), &d, NULL))
			continue;
		assert_true(kernels_choose("baseline"));
		sample_cloud(&c, &d, e);
		add_cloud(&c, &d, &first);
		assert_none_farther(&c, &d, &first);
		for (int k = 0; k < COPIES; k++) {
			kernels_choose(copies[k]);
			shuffle(&c);
			add_cloud(&c, &d, &again);
			assert_true(are_same(&first, &again, d.n));
		}
		looked_at++;
	}
	print_message("to 1e%d: %d of %d\n", e, looked_at, n);
	assert_true(looked_at > n / 5);
}

static void none_is_farther(void **state)
{
	(void)state;
	farthest_many(150, 0);
	farthest_many(150, 3);
	farthest_many(100, 60);
}

/* Asserts that p is farther than q along m, or equally far with greater coordinates. */
static void assert_farther(const double m[3], const double p[3], const double q[3])
{
	const double columns[4][4] = { { m[0] }, { m[1] }, { m[2] } };
	struct map map;
	struct directions d = { 0 };

	map_of_doubles(columns, &map);
	directions_add(&d, &map, 0, false);
	for (int k = 0; k < 2; k++) {
		struct cloud c = { .n = 2 };
		struct extremes e;

		memcpy(c.p[k], p, sizeof c.p[k]);
		memcpy(c.p[!k], q, sizeof c.p[k]);
		add_cloud(&c, &d, &e);
		for (int i = 0; i < 3; i++)
			assert_number(e.item[0].point[i], p[i]);
	}
}

static void small_differences_decide(void **state)
{
	static const double cases[][3][3] = {
		/* all digits decide */
		{ { 1, 0x1p-110, 1 }, { -1, 1, 1 }, { 0, 0, 0 } },
		{ { 1, -0x1p-110, 1 }, { 0, 0, 0 }, { 1, 1, -1 } },
		/* the low part of a difference of coordinates decides */
		{ { 1, 1, 1 }, { 0x1p-60, 1, 0 }, { 1, 0, 0x1p-70 } },
		/* the low part of a sum of products decides */
		{ { 1, 1, 1 }, { 0, 0x1p-60, 1 }, { 1, 0, 0x1p-70 } },
		/* the part of 1/3 beyond a double decides */
		{ { 3, 1, 3 }, { 0, 0, 0 }, { 1, -3, -0x1p-60 } },
		{ { 3, 1, 3 }, { -1, 3, 0x1p-60 }, { 0, 0, 0 } },
		/* the low part of a product decides */
		{ { 1 + 0x1p-40, 1, 1 }, { 0, 1 + 0x1p-30 + 0x1p-40, 0 },
		    { 1 + 0x1p-30, 0, -0x1p-60 } },
		/* p is as far as q */
		{ { 3, 1, 0 }, { 1, -3, 0 }, { 0, 0, 0 } },
		{ { 3, -1, 0 }, { 1, 3, 0 }, { 0, 0, 0 } },
		{ { -3, 1, 0 }, { 1, 3, 0 }, { 0, 0, 0 } },
		{ { -3, -1, 0 }, { 1, -3, 0 }, { 0, 0, 0 } },
		{ { 7, 11, 0 }, { 11, -7, 0 }, { -22, 14, 0 } },
		{ { -7, -11, 0 }, { 11, -7, 0 }, { -22, 14, 0 } },
		{ { 0, 0, 1 }, { 1, 2, 3 }, { 1, -2, 3 } },
		{ { 0, 0, 0 }, { 1, 2, 3 }, { 1, 2, -3 } },
		/* products near the ends of the range */
		{ { 1e-300, 0, 1e8 }, { 1e150, 0, 0 }, { -1e150, 0, 0 } },
		{ { -1e-300, 0, 1e100 }, { -1, 0, 0 }, { 1, 0, 0 } },
		{ { 1e150, 1e150, 1e150 }, { 1e150, 1e150, 1e150 },
		    { -1e150, -1e150, -1e150 } },
	};

	(void)state;
	kernels_choose("baseline");
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
		assert_farther(cases[i][0], cases[i][1], cases[i][2]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(none_is_farther),
		cmocka_unit_test(small_differences_decide),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
