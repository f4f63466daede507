/* SPDX-License-Identifier: MIT */
#include "types.h"

#include <math.h>
#include <string.h>

#include "../message/escape.h"

const char *const angle_units[] = { "degrees", "radians", NULL };

static void read_numbers(const struct value *v, const struct member *row,
    void *out)
{
	const struct value_range *range = row->range != NULL ? row->range :
							       &range_any;

	if (row->n == 0)
		*(double *)out = value_number(v, range);
	else
		value_numbers(v, range, row->n, out);
}

static void print_numbers(struct printer *p, const struct member *row,
    const void *at)
{
	const double *v = at;

	if (row->n == 0)
		put_number(p, *v);
	else
		put_numbers(p, v, (int)row->n);
}

const struct type type_numbers = { NULL, read_numbers, print_numbers,
	sizeof(double) };

static void read_bool(const struct value *v, const struct member *row,
    void *out)
{
	*(bool *)out = row->words != NULL ? value_word(v, row->words) == 1 :
					    value_flag(v);
}

static void print_bool(struct printer *p, const struct member *row,
    const void *at)
{
	const bool is = *(const bool *)at;

	if (row->words != NULL)
		put_string(p, row->words[is]);
	else
		put_word(p, is ? "true" : "false");
}

const struct type type_flag = { "true or false", read_bool, print_bool,
	sizeof(bool) };
const struct type type_second = { NULL, read_bool, print_bool, sizeof(bool) };

static void read_word(const struct value *v, const struct member *row,
    void *out)
{
	*(unsigned *)out = row->first + (unsigned)value_word(v, row->words);
}

static void print_word(struct printer *p, const struct member *row,
    const void *at)
{
	put_string(p, row->words[*(const unsigned *)at - row->first]);
}

const struct type type_word = { NULL, read_word, print_word, sizeof(unsigned) };

static void read_later(const struct value *v, const struct member *row,
    void *out)
{
	(void)row;
	*(struct value *)out = *v;
}

const struct type type_value = { NULL, read_later, NULL, 0 };
const struct type type_later_matrix = { "matrix", read_later, NULL, 0 };
const struct type type_points = { "a point or a list", read_later, NULL, 0 };
const struct type type_convention = { "a name or an object", read_later, NULL,
	0 };

#define FAR "a number or \"infinity\""

static void read_far(const struct value *v, const struct member *row, void *out)
{
	char shown[ESCAPED_MAX];
	const char *s = value_string(v);

	if (s != NULL && strcmp(s, "infinity") == 0)
		*(double *)out = HUGE_VAL;
	else if (s != NULL)
		value_refuse(v, "is \"%s\"; " FAR " is wanted",
		    escaped(shown, s, strlen(s)));
	else if (value_is_null(v))
		value_wrong(v, FAR);
	else
		read_numbers(v, row, out);
}

void put_distance(struct printer *p, double v)
{
	if (isinf(v))
		put_string(p, "infinity");
	else
		put_number(p, v);
}

static void print_far(struct printer *p, const struct member *row,
    const void *at)
{
	(void)row;
	put_distance(p, *(const double *)at);
}

const struct type type_far = { "size or \"infinity\"", read_far, print_far,
	sizeof(double) };

const char *const vector_names[] = { "row", "column", NULL };

/* The object that -o json prints a matrix in. */
struct printed {
	struct value matrix, vectors;
};

static const struct member printed_members[] = {
	ROW(printed, "matrix", type_value, matrix, .n = 0),
	ROW(printed, "vectors", type_value, vectors, .n = 0),
	{ .name = NULL },
};

#define ANY "16 numbers or 4 rows of 4"
#define AFFINE "16 numbers, or 4 rows of 4 or 3, or 3 rows of 4"

static const struct ways printed_ways = { .way = { "matrix vectors?" } };

/* Whether rows are for column vectors, as the object that they stand in says, or
 * their shape, or the document. */
static bool is_column(const struct printed *p, size_t rows, size_t columns)
{
	bool column = rows < columns, whole = rows == columns;

	if (p->vectors.item == NULL)
		return whole ? p->matrix.source->column : column;
	bool said = value_word(&p->vectors, vector_names) == 1;

	if (!whole && said != column)
		value_refuse(&p->vectors,
		    "is \"%s\"; %zu rows of %zu are for %s vectors",
		    vector_names[said], rows, columns, vector_names[column]);
	return said;
}

/* A matrix for row vectors, stored row by row, and its transpose for column
 * vectors, stored column by column, are the same 16 numbers in a row: only
 * nested rows depend on which vectors it is for. */
static void read_elements(const struct value *v, bool affine, double m[4][4])
{
	struct printed p = { .matrix = *v };

	if (value_is_object(v)) {
		uint64_t seen = object_read(v, printed_members, 0, &p);

		object_way(v, printed_members, 0, seen, &printed_ways);
	}
	if (!value_is_array(&p.matrix))
		value_wrong(&p.matrix,
		    affine ? "an array of " AFFINE : "an array of " ANY);
	struct value row = value_child(&p.matrix);
	size_t n = value_count(&p.matrix), rows = affine && n == 3 ? 3 : 4;
	size_t columns = affine && n == 4 && value_is_array(&row) &&
		value_count(&row) == 3 ?
	    3 :
	    4;
	bool column = is_column(&p, rows, columns);
	double e[4];

	if (n != rows && n != 16)
		value_refuse(&p.matrix, "has %zu element%s; %s are wanted", n,
		    n == 1 ? "" : "s", affine ? AFFINE : ANY);
	if (n == 16)
		value_numbers(&p.matrix, &range_any, 16, m[0]);
	for (size_t i = 0; i < 4 && n != 16; i++) {
		for (size_t j = 0; j < 4; j++)
			e[j] = i == j;
		if (i < rows)
			value_numbers(&row, &range_any, columns, e);
		for (size_t j = 0; j < 4; j++)
			m[column ? j : i][column ? i : j] = e[j];
		if (i < rows)
			value_next(&row);
	}
}

static void read_matrix(const struct value *v, const struct member *row,
    void *out)
{
	(void)row;
	read_elements(v, false, out);
}

void read_affine(const struct value *v, const struct member *row, void *out)
{
	(void)row;
	read_elements(v, true, out);
}

const struct type type_matrix = { "matrix", read_matrix, NULL, 0 };
const struct type type_affine = { "matrix", read_affine, NULL, 0 };

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
static void read_k_row(struct value *e, int i, size_t n, double k[4])
{
	for (size_t j = 0; j < n; j++, value_next(e)) {
		k[j] = value_number(e, &range_any);
		if (n == 3 && !e->unused)
			check_k(e, i, j, k[j]);
	}
}

/* K where n is 3, P where it is 4: rows, or one row after the other. */
static void read_k_or_p(const struct value *v, size_t n, bool nested,
    double k[3][4])
{
	struct value e = value_child(v);

	for (int i = 0; i < 3; i++) {
		struct value row = e;

		if (!nested) {
			read_k_row(&e, i, n, k[i]);
			continue;
		}
		value_numbers(&row, &range_any, n, k[i]);
		struct value first = value_child(&row);

		read_k_row(&first, i, n, k[i]);
		value_next(&e);
	}
	if (n == 4 && k[2][0] == 0 && k[2][1] == 0 && k[2][2] == 0 &&
	    !v->unused)
		value_refuse(v,
		    "the last row of P begins 0, 0, 0; a perspective divides "
		    "by more than one number");
}

static void read_intrinsics(const struct value *v, const struct member *row,
    void *out)
{
	double(*k)[4] = out, four[4];
	struct value first;

	(void)row;
	if (!value_is_array(v))
		value_wrong(v, FORMS ",");
	first = value_child(v);
	size_t n = value_count(v);
	bool nested = value_is_array(&first);

	if (nested ? n == 3 : n == 9 || n == 12) {
		size_t columns = nested ? value_count(&first) : n / 3;

		read_k_or_p(v, columns == 4 ? 4 : 3, nested, k);
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

/* As P, or where the rest is that of K as K, or without skew as four numbers. */
static void print_intrinsics(struct printer *p, const struct member *row,
    const void *at)
{
	const double(*k)[4] = at;
	const double four[4] = { k[0][0], k[1][1], k[0][2], k[1][2] };
	bool is_p = k[0][3] != 0 || k[1][3] != 0 || k[2][3] != 0 ||
	    k[1][0] != 0 || k[2][0] != 0 || k[2][1] != 0 || k[2][2] != 1 ||
	    !(k[0][0] > 0 && k[1][1] > 0);

	(void)row;
	if (!is_p && k[0][1] == 0) {
		put_numbers(p, four, 4);
		return;
	}
	put_open(p, "[");
	for (int i = 0; i < 3; i++)
		put_numbers(p, k[i], is_p ? 4 : 3);
	put_close(p, "]");
}

const struct type type_intrinsics = { "4 numbers, K or P", read_intrinsics,
	print_intrinsics, 0 };
