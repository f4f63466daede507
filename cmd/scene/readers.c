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
	struct value matrix;
	bool column;
};

static const struct member printed_members[] = {
	{ .name = "matrix",
	    .read = read_value,
	    .at = offsetof(struct printed, matrix) },
	{ .name = "vectors",
	    .read = read_second,
	    .words = vector_names,
	    .at = offsetof(struct printed, column) },
	{ .name = NULL },
};

#define FORM "16 numbers or 4 rows of 4"

static const struct ways printed_ways = {
	"give \"matrix\", " FORM,
	{ "matrix vectors?" },
};

static void read_rows(const struct value *v, bool column, double m[4][4])
{
	struct value row = value_child(v);
	double e[4];

	for (int i = 0; row.item != NULL; i++, value_next(&row)) {
		value_numbers(&row, &range_any, 4, e);
		for (int j = 0; j < 4; j++)
			m[column ? j : i][column ? i : j] = e[j];
	}
}

/* A matrix for row vectors, stored row by row, and its transpose for column
 * vectors, stored column by column, are the same 16 numbers in a row: only
 * nested rows depend on which vectors it is for. */
void read_matrix(const struct value *v, const struct member *row, void *out)
{
	struct printed p = { *v, v->source->column };

	(void)row;
	if (value_is_object(v)) {
		unsigned seen = object_read(v, printed_members, 0, &p);

		object_way(v, printed_members, 0, seen, &printed_ways);
	}
	if (!value_is_array(&p.matrix))
		value_wrong(&p.matrix, "an array of " FORM);
	size_t n = value_count(&p.matrix);

	if (n == 4)
		read_rows(&p.matrix, p.column, out);
	else if (n == 16)
		value_numbers(&p.matrix, &range_any, 16, out);
	else
		value_refuse(&p.matrix, "has %zu elements; " FORM " are wanted",
		    n);
}
