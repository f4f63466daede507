/* Composition and inversion of bare matrices, against MPFR. */
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

/* Where all of them are in the range of doubles. */
static void compare(const struct truth *t, const struct map *m, struct worst *w)
{
	if (map_is_finite(m))
		truth_compare(t, m, w);
}

static void inverse_of(int e, struct worst *w)
{
	struct scene s = { .has_world = true };
	struct map m;
	struct truth t;
	int mark = real_mark();

	any_matrix(&s.projection, false, e);
	if (map_inverse(s.projection.matrix, &m)) {
		truth_scene(&s, SPACE_CLIP, SPACE_VIEW, &t);
		compare(&t, &m, w);
	}
	sample_affine(s.world, e);
	if (map_inverse(s.world, &m)) {
		truth_scene(&s, SPACE_WORLD, SPACE_MODEL, &t);
		compare(&t, &m, w);
		for (int j = 0; j < 3; j++)
			assert_true(m.origin[j] == s.world[3][j]);
	}
	real_release(mark);
}

static void inverses(void **state)
{
	struct worst w = { 0 };

	(void)state;
	sample_seed(1);
	for (int i = 0; i < 4 * TRIES; i++)
		inverse_of(magnitudes[i % 4], &w);
	claim_maps("inverse", &w, EX_BOUND);
}

static void singular(void **state)
{
	struct map m;

	(void)state;
	sample_seed(2);
	for (int i = 0; i < TRIES; i++) {
		double a[4][4];
		int row = (int)sample_below(3);

		sample_affine(a, 0);
		/* the sums must be exact */
		for (int k = 0; k < 16; k++)
			a[k / 4][k % 4] = rint(a[k / 4][k % 4] * 4096);
		for (int j = 0; j < 4; j++)
			a[row][j] = 3 * a[(row + 1) % 4][j] -
			    a[(row + 2) % 4][j];
		assert_false(map_inverse(a, &m));
	}
}

static void products(void **state)
{
	static const struct convention d3d;
	struct worst w = { 0 };

	(void)state;
	sample_seed(3);
	for (int i = 0; i < 3 * TRIES; i++) {
		struct projection p;
		struct map m = map_identity, next;
		struct truth t = { 0 };
		int mark = real_mark();

		for (int k = 0; k < 3; k++) {
			any_matrix(&p, sample_below(2), magnitudes[i % 3]);
			next = map_of_doubles(p.matrix);
			m = map_then(&m, &next);
			truth_projection(&t, &p, &d3d);
		}
		map_settle(&m);
		compare(&t, &m, &w);
		real_release(mark);
	}
	claim_maps("product of three", &w, 4 * EX_BOUND);
}

/* There and back again, zeros are zeros. */
static void round_trips(void **state)
{
	(void)state;
	sample_seed(4);
	for (int i = 0; i < TRIES; i++) {
		struct projection p;
		struct map m, back;

		any_matrix(&p, sample_below(2), magnitudes[i % 2]);
		m = map_of_doubles(p.matrix);
		if (!map_inverse(p.matrix, &back))
			continue;
		m = map_then(&m, &back);
		map_settle(&m);
		for (int k = 0; k < 20; k++) {
			int row = k / 4, j = k % 4;
			bool one = (row == AT_ZERO ? 3 : row) == j;

			assert_true(m.m[row][j].hi == one);
		}
	}
}

static void identity(void **state)
{
	struct scene s;
	struct map a, b;

	(void)state;
	sample_seed(5);
	sample_scene(&s, 2);
	assert_null(scene_map(&s, SPACE_WORLD, SPACE_VIEW, &a));
	b = map_then(&map_identity, &a);
	assert_memory_equal(b.origin, a.origin, sizeof a.origin);
	assert_memory_equal(b.m, a.m, sizeof a.m);
	b = map_then(&a, &map_identity);
	assert_memory_equal(b.origin, a.origin, sizeof a.origin);
	assert_memory_equal(b.m, a.m, sizeof a.m);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(inverses),
		cmocka_unit_test(singular),
		cmocka_unit_test(products),
		cmocka_unit_test(round_trips),
		cmocka_unit_test(identity),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
