/* SPDX-License-Identifier: MIT */
#include "readers.h"

void read_value(const struct value *v, const struct member *row, void *out)
{
	(void)row;
	*(struct value *)out = *v;
}

void read_numbers(const struct value *v, const struct member *row, void *out)
{
	const struct range *range = row->range != NULL ? row->range :
							 &range_any;

	if (row->n == 0)
		*(double *)out = value_number(v, range);
	else
		value_numbers(v, range, row->n, out);
}

const char *const angle_units[] = { "degrees", "radians", NULL };

void read_angle(const struct value *v, const struct member *row, void *out)
{
	*(double *)out = value_number(v, &row->range[v->source->unit]);
}

void read_flag(const struct value *v, const struct member *row, void *out)
{
	(void)row;
	*(bool *)out = value_flag(v);
}

void read_word(const struct value *v, const struct member *row, void *out)
{
	*(unsigned *)out = (unsigned)value_word(v, row->words);
}

void read_second(const struct value *v, const struct member *row, void *out)
{
	*(bool *)out = value_word(v, row->words) == 1;
}

const char *const vector_names[] = { "row", "column", NULL };

/* The object that -o json prints a matrix in. */
struct printed {
	struct value matrix, vectors;
};

static const struct member printed_members[] = {
	{ .name = "matrix",
	    .read = read_value,
	    .at = offsetof(struct printed, matrix) },
	{ .name = "vectors",
	    .read = read_value,
	    .at = offsetof(struct printed, vectors) },
	{ .name = NULL },
};

#define ANY "16 numbers or 4 rows of 4"
#define AFFINE "16 numbers, or 4 rows of 4 or 3, or 3 rows of 4"

static const struct ways any_ways = {
	"give \"matrix\", " ANY,
	{ "matrix vectors?" },
};

static const struct ways affine_ways = {
	"give \"matrix\", " AFFINE,
	{ "matrix vectors?" },
};

/* The rows that there are, to a unit matrix or its transpose. */
static void read_rows(const struct value *v, size_t columns, bool column,
    double m[4][4])
{
	struct value row = value_child(v);
	double e[4];

	for (int i = 0; row.s != NULL; i++, value_next(&row)) {
		value_numbers(&row, &range_any, columns, e);
		for (size_t j = 0; j < columns; j++)
			m[column ? j : (size_t)i][column ? (size_t)i : j] =
			    e[j];
	}
}

/* Whether rows are for column vectors, as the object that they stand in says, or
 * their shape, or the document. */
static bool is_column(const struct printed *p, size_t rows, size_t columns)
{
	bool column = rows < columns, whole = rows == columns;

	if (p->vectors.s == NULL)
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
static void read(const struct value *v, bool affine, double m[4][4])
{
	struct printed p = { .matrix = *v };
	const char *wanted = affine ? AFFINE : ANY;

	if (value_is_object(v)) {
		unsigned seen = object_read(v, printed_members, 0, &p);

		object_way(v, printed_members, 0, seen,
		    affine ? &affine_ways : &any_ways);
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
	double all[16];

	for (int i = 0; i < 16; i++)
		m[i / 4][i % 4] = i / 4 == i % 4;
	if (n == rows)
		read_rows(&p.matrix, columns, column, m);
	else if (n == 16)
		value_numbers(&p.matrix, &range_any, 16, all);
	else
		value_refuse(&p.matrix, "has %zu element%s; %s are wanted", n,
		    n == 1 ? "" : "s", wanted);
	for (int i = 0; i < 16 && n == 16; i++)
		m[i / 4][i % 4] = all[i];
}

void read_matrix(const struct value *v, const struct member *row, void *out)
{
	(void)row;
	read(v, false, out);
}

void read_affine(const struct value *v, const struct member *row, void *out)
{
	(void)row;
	read(v, true, out);
}
