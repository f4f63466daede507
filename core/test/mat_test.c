/* SPDX-License-Identifier: MIT */
/* Products and inverses of matrices, by core/exact/map.c, against MPFR. */
#include "claims.h"

enum { TRIES = 100 };

static const int magnitudes[] = { 0, 2, 20, 150 };

static void any_matrix(struct projection *p, bool affine, int e)
{
	memset(p, 0, sizeof *p);
	p->type = PROJECTION_MATRIX;
	sample_affine(p->matrix, e);
	for (int i = 0; i < 4 && !affine; i++)
		p->matrix[i][3] = sample_number(e);
}

/* Compares a map with the truth if its elements are in the range of doubles. */
static void compare_if_finite(const struct truth *t, const struct map *m,
    struct worst *w)
{
	if (map_is_finite(m))
		truth_compare(t, m, w);
}

static void check_inverses(int e, struct worst *w)
{
	struct scene s = { .has_world = true };
	struct map m;
	struct truth t;
	int mark = real_mark();

	any_matrix(&s.projection, false, e);
	map_of_doubles(s.projection.matrix, &m);
	if (map_invert(&m)) {
		truth_scene(&s, SPACE_CLIP, SPACE_VIEW, &t);
		compare_if_finite(&t, &m, w);
	}
	sample_affine(s.world.matrix, e);
	map_of_doubles(s.world.matrix, &m);
	if (map_invert(&m)) {
		truth_scene(&s, SPACE_WORLD, SPACE_MODEL, &t);
		compare_if_finite(&t, &m, w);
	}
	real_release(mark);
}

static void inverses(void **state)
{
	struct worst w = { 0 };

	(void)state;
	SAMPLES(i, 4 * TRIES)
		check_inverses(magnitudes[i % 4], &w);
	assert_maps("inverse", &w);
}

static void singular_matrices_are_refused(void **state)
{
	struct map m;

	(void)state;
	SAMPLES(i, TRIES) {
		double a[4][4];
		int row = (int)sample_below(3);

		sample_affine(a, 0);
		/* so that sums of multiples of rows are exact */
		for (int k = 0; k < 16; k++)
			a[k / 4][k % 4] = rint(a[k / 4][k % 4] * 4096);
		for (int j = 0; j < 4; j++)
			a[row][j] = 3 * a[(row + 1) % 4][j] - a[(row + 2) % 4][j];
		map_of_doubles(a, &m);
		assert_false(map_invert(&m));
	}
}

static void products(void **state)
{
	static const struct convention d3d;
	struct worst w = { 0 };

	(void)state;
	SAMPLES(i, 3 * TRIES) {
		struct projection p;
		struct map before, m, next;
		struct truth t = { 0 };
		int mark = real_mark();

		map_identity(&m);
		for (int k = 0; k < 3; k++) {
			any_matrix(&p, sample_below(2), magnitudes[i % 3]);
			map_of_doubles(p.matrix, &next);
			before = m;
			m = before;
			map_multiply(&m, &next, false);
			truth_projection(&t, &p, &d3d);
		}
		truth_compose(&t);
		compare_if_finite(&t, &m, &w);
		real_release(mark);
	}
	assert_maps("product of three", &w);
}

/* A matrix times its inverse is exactly the identity. */
static void products_with_inverses(void **state)
{
	(void)state;
	SAMPLES(i, TRIES) {
		struct projection p;
		struct map m, there, back;

		any_matrix(&p, sample_below(2), magnitudes[i % 2]);
		map_of_doubles(p.matrix, &there);
		back = there;
		if (!map_invert(&back))
			continue;
		m = there;
		map_multiply(&m, &back, false);
		for (int k = 0; k < 16; k++)
			assert_true(element(&m, k / 4, k % 4) == (k / 4 == k % 4));
	}
}

static void assert_same_map(const struct map *a, const struct map *b)
{
	assert_memory_equal(a->origin, b->origin, sizeof a->origin);
	for (int k = 0; k < 16; k++)
		assert_true(element(a, k / 4, k % 4) == element(b, k / 4, k % 4));
}

static void products_with_identity(void **state)
{
	struct scene s;
	struct map one, a, b;

	(void)state;
	sample_seed(5);
	sample_scene(&s, 2);
	map_identity(&one);
	assert_true(scene_map(&s, SPACE_WORLD, SPACE_VIEW, &a, NULL));
	b = one;
	map_multiply(&b, &a, false);
	assert_same_map(&a, &b);
	b = a;
	map_multiply(&b, &one, false);
	assert_same_map(&a, &b);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(inverses),
		cmocka_unit_test(singular_matrices_are_refused),
		cmocka_unit_test(products),
		cmocka_unit_test(products_with_inverses),
		cmocka_unit_test(products_with_identity),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
