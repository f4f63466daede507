/* SPDX-License-Identifier: MIT */
/* The member "intrinsics": what a calibrated camera makes of a point in view space,
 * in pixels. */
#include "members.h"

#define FORMS                                                         \
	"[fx, fy, cx, cy], K as 3 rows of 3 or 9 numbers, or P as 3 " \
	"rows of 4 or 12 numbers"

/* Of K: fx and fy are sizes; below the diagonal there is 0, and in the last row 1 on
 * it. */
static void check_k(const struct value *e, int i, size_t j, double a)
{
	if (i == 2 && a != (j == 2))
		value_refuse(e,
		    "the last row of K is 0, 0, 1; is it a camera's K, and "
		    "not transposed?");
	if (j < (size_t)i && a != 0)
		value_refuse(e,
		    "under the diagonal of K there is 0; is it "
		    "transposed?");
	if (i < 2 && j == (size_t)i)
		value_number(e, &range_positive);
}

/* Row i, whose first element is *e, which goes on to the next row's. */
static void read_row(struct value *e, int i, size_t n, double k[4])
{
	for (size_t j = 0; j < n; j++, value_next(e)) {
		k[j] = value_number(e, &range_any);
		if (n == 3 && !e->unused)
			check_k(e, i, j, k[j]);
	}
}

/* K where n is 3, P where it is 4: rows, or one row after the other. */
static void read_rows(const struct value *v, size_t n, bool nested,
    double k[3][4])
{
	struct value e = value_child(v);

	for (int i = 0; i < 3; i++) {
		struct value row = e;

		if (!nested) {
			read_row(&e, i, n, k[i]);
			continue;
		}
		value_numbers(&row, &range_any, n, k[i]);
		struct value first = value_child(&row);

		read_row(&first, i, n, k[i]);
		value_next(&e);
	}
	if (n == 4 && k[2][0] == 0 && k[2][1] == 0 && k[2][2] == 0 &&
	    !v->unused)
		value_refuse(v,
		    "the last row of P begins 0, 0, 0; a perspective divides "
		    "by more than one number");
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
	size_t n = value_count(v);
	bool nested = value_is_array(&first);

	if (nested ? n == 3 : n == 9 || n == 12) {
		size_t columns = nested ? value_count(&first) : n / 3;

		read_rows(v, columns == 4 ? 4 : 3, nested, k);
		return;
	}
	if (n != 4 || nested)
		value_refuse(v, "is none of " FORMS);
	value_numbers(v, &range_any, 4, four);
	for (int i = 0; i < 2; i++, value_next(&first)) {
		value_number(&first, &range_positive);
		k[i][i] = four[i];
		k[i][2] = four[2 + i];
	}
	k[2][2] = 1;
}
