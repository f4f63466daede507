/* SPDX-License-Identifier: MIT */
/* Copies rows of points to columns and back, and maps floats from rows to rows, in
 * every copy of the kernels. */
#include "block.h"
#include "claims.h"

enum { ROWS = 53 };

static COLUMN_ALIGNED double columns[4][POINTS_BLOCK];

/* Rows begin at an odd address, which is not aligned for a double. */
static char rows[8 * 4 * ROWS + 1], back[8 * 4 * ROWS + 1];

static void put_row_number(bool wide, size_t i, double v)
{
	float narrow = (float)v;

	if (wide)
		memcpy(rows + 1 + 8 * i, &v, 8);
	else
		memcpy(rows + 1 + 4 * i, &narrow, 4);
}

static double number_back(bool wide, size_t i)
{
	double v;
	float narrow;

	memcpy(&v, back + 1 + (wide ? 8 : 4) * i, wide ? 8 : 4);
	memcpy(&narrow, back + 1 + 4 * i, 4);
	return wide ? v : (double)narrow;
}

static bool rows_to_columns(bool wide, int numbers, size_t n)
{
	return kernels_chosen()->to_columns[wide][numbers](rows + 1, columns, n,
	    SCENE_MAGNITUDE_MAX);
}

static bool columns_to_rows(bool wide, int numbers, size_t n)
{
	return kernels_chosen()->to_rows[wide][numbers](columns, back + 1, n);
}

/* Copies n points to columns and back. Asserts that each number comes to its place, -0
 * as 0, and that no other byte changes. */
static void check_places(bool wide, int numbers, size_t n)
{
	size_t all = n * (size_t)numbers, size = all * (wide ? 8 : 4);

	for (size_t i = 0; i < all; i++)
		put_row_number(wide, i, i % 7 == 0 ? -0.0 : (double)i - 9.25);
	memset(columns, 1, sizeof columns);
	memset(back, 1, sizeof back);
	assert_true(rows_to_columns(wide, numbers, n));
	assert_true(columns_to_rows(wide, numbers, n));
	for (size_t i = 0; i < all; i++) {
		double v = i % 7 == 0 ? 0 : (double)i - 9.25;

		assert_true(columns[i % (size_t)numbers][i / (size_t)numbers] == v);
		assert_true(number_back(wide, i) == v &&
		    !signbit(number_back(wide, i)) == (v >= 0));
	}
	for (int k = 0; k < numbers; k++)
		assert_int_equal(*(char *)&columns[k][n], 1);
	assert_int_equal(back[0], 1);
	for (size_t i = size + 1; i < sizeof back; i++)
		assert_int_equal(back[i], 1);
}

static void numbers_keep_their_places(void **state)
{
	(void)state;
	for (int c = 0; c < COPIES; c++)
		for (int numbers = 2; numbers <= 4 && kernels_choose(copies[c]);
		     numbers++)
			for (size_t n = 0; n <= ROWS; n++) {
				check_places(false, numbers, n);
				check_places(true, numbers, n);
			}
}

/* Copies rows to columns with v at each place among ones. Asserts whether the kernel
 * reports that all magnitudes are within SCENE_MAGNITUDE_MAX. */
static void check_range_of_rows(bool wide, double v, bool within)
{
	for (int numbers = 2; numbers <= 4; numbers++)
		for (size_t i = 0; i < ROWS * (size_t)numbers; i++) {
			for (size_t k = 0; k < ROWS * (size_t)numbers; k++)
				put_row_number(wide, k, k == i ? v : 1);
			assert_int_equal(rows_to_columns(wide, numbers, ROWS), within);
		}
}

static void check_rounding_to_rows(bool wide, double v, bool sure)
{
	for (int numbers = 2; numbers <= 4; numbers++)
		for (size_t i = 0; i < ROWS * (size_t)numbers; i++) {
			for (size_t k = 0; k < ROWS * (size_t)numbers; k++)
				columns[k % (size_t)numbers][k / (size_t)numbers] = k ==
					i ?
				    v :
				    1;
			assert_int_equal(columns_to_rows(wide, numbers, ROWS), sure);
		}
}

static void numbers_to_reject_are_reported(void **state)
{
	const double nan = (double)NAN, infinite = HUGE_VAL;
	const double past = nextafter(1e150, infinite);

	(void)state;
	for (int c = 0; c < COPIES; c++) {
		if (!kernels_choose(copies[c]))
			continue;
		check_range_of_rows(true, 1e150, true);
		check_range_of_rows(true, -past, false);
		check_range_of_rows(true, -infinite, false);
		check_range_of_rows(true, nan, true);
		check_range_of_rows(false, 0x1.fffffep127, true);
		check_range_of_rows(false, infinite, false);
		check_range_of_rows(false, nan, true);
		check_rounding_to_rows(true, 0x1.fffffffffffffp1023, true);
		check_rounding_to_rows(true, -infinite, false);
		check_rounding_to_rows(true, nan, false);
		check_rounding_to_rows(false, -0x1.fffffep127, true);
		check_rounding_to_rows(false, 0x1.fffffefffffffp127, false);
		check_rounding_to_rows(false, 0x1.ffffffp127, false);
		check_rounding_to_rows(false, nan, false);
		check_rounding_to_rows(false, 0, true);
		/* a midpoint of two floats, and numbers near it */
		check_rounding_to_rows(false, 0x1.000001p0, false);
		check_rounding_to_rows(false, -0x1.fffffdp-126, false);
		check_rounding_to_rows(false, 0x1.0000010000001p0, true);
		check_rounding_to_rows(false, 0x1.0000008p0, true);
		/* at the least normal float and below it */
		check_rounding_to_rows(false, 0x1p-126, true);
		check_rounding_to_rows(false, -0x1.fffffffffffffp-127, false);
		check_rounding_to_rows(false, 0x1p-1074, false);
	}
}

/* points_map_floats gives the bits of points_map with PRECISION_SINGLE on columns of
 * doubles, also where the origin of the map is not a float. */
static void floats_as_by_doubles(void **state)
{
	static struct block b;
	static struct transform t;
	struct truth truth = { 0 };
	struct scene s;
	enum space from;
	size_t mapped = 0;

	(void)state;
	SAMPLES(k, 6000) {
		size_t n = 1 + sample_below(POINTS);
		int mark = real_mark();

		kernels_choose(copies[k % COPIES]);
		truth.n = 0;
		if (!sample_transform(k % 3 * 4, &s, &from, &t, &truth)) {
			real_release(mark);
			continue;
		}
		real_release(mark);
		sample_points(&s, from, &b, n);
		for (size_t i = 0; i < n * (size_t)t.in; i++)
			put_row_number(false, i,
			    b.in[i % (size_t)t.in][i / (size_t)t.in]);
		if (!points_map_floats(&t, rows + 1, back + 1, n))
			continue;
		assert_true(kernels_chosen()->to_columns[false][t.in](rows + 1, b.in, n,
		    SCENE_MAGNITUDE_MAX));
		map_block(&t, PRECISION_SINGLE, &b, n);
		for (size_t i = 0; i < n * (size_t)t.out; i++)
			assert_true(number_back(false, i) ==
			    b.out[i % (size_t)t.out][i / (size_t)t.out]);
		mapped++;
	}
	print_message("%zu blocks of floats were carried\n", mapped);
	assert_true(mapped > 200);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(numbers_keep_their_places),
		cmocka_unit_test(numbers_to_reject_are_reported),
		cmocka_unit_test(floats_as_by_doubles),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
