/* SPDX-License-Identifier: MIT */
/* The member "intrinsics": what a calibrated camera makes of a point in view space,
 * in pixels. */
#include "members.h"

#define FORMS "[fx, fy, cx, cy], 3 rows of 3, K, or 3 rows of 4, P"

/* fx and fy are sizes; below the diagonal there is 0, and in the last row 1 on it. */
static void check(const struct value *e, int i, size_t j, double a)
{
	if (i == 2 && j < 3 && a != (j == 2))
		value_refuse(e,
		    "its last row begins 0, 0, 1; is it a camera's "
		    "K or P, and not transposed?");
	if (j < (size_t)i && a != 0)
		value_refuse(e,
		    "under the diagonal of K there is 0; is it "
		    "transposed?");
	if (i < 2 && j == (size_t)i)
		value_number(e, &range_positive);
}

static void read_row(const struct value *row, int i, size_t n, double k[4])
{
	value_numbers(row, &range_any, n, k);
	struct value e = value_child(row);

	for (size_t j = 0; j < n; j++, value_next(&e))
		if (!row->unused)
			check(&e, i, j, k[j]);
}

void read_intrinsics(const struct value *v, const struct member *row, void *to)
{
	struct projection *p = to;
	double(*k)[4] = p->intrinsics, four[4];
	struct value first;

	(void)row;
	if (!value_is_array(v))
		value_wrong(v, FORMS ",");
	first = value_child(v);
	if (value_count(v) == 3 && value_is_array(&first)) {
		size_t n = value_count(&first) == 4 ? 4 : 3;

		for (int i = 0; i < 3; i++, value_next(&first))
			read_row(&first, i, n, k[i]);
		return;
	}
	if (value_count(v) != 4 || value_is_array(&first))
		value_refuse(v, "is none of " FORMS);
	value_numbers(v, &range_any, 4, four);
	for (int i = 0; i < 2; i++, value_next(&first)) {
		value_number(&first, &range_positive);
		k[i][i] = four[i];
		k[i][2] = four[2 + i];
	}
	k[2][2] = 1;
}
