/* SPDX-License-Identifier: MIT */
#include "types.h"

#include <math.h>
#include <string.h>

#include "../../core/scene/scene.h"

const char *const angle_unit_names[] = { "degrees", "radians", NULL };

static void read_numbers(const struct value *v, const struct member *row, void *out)
{
	static const char *const words[] = { "infinity", NULL };
	const struct value_range *range = row->range != NULL ? row->range : &range_any;
	const bool is_far = row->type == &type_far;

	if (is_far && value_is(v, JSON_NULL))
		value_refuse_type(v, "a number or \"infinity\"");
	if (is_far && value_string(v) != NULL && value_word(v, words) == 0)
		*(double *)out = HUGE_VAL;
	else if (row->n == 0)
		*(double *)out = value_number(v, range);
	else
		value_numbers(v, range, row->n, row->hint != NULL ? row->hint : "",
		    out);
}

static void print_numbers(struct printer *p, const struct member *row, const void *at)
{
	if (row->n == 0)
		put_distance(p, *(const double *)at);
	else
		put_numbers(p, at, (int)row->n);
}

const struct member_type type_numbers = { NULL, read_numbers, print_numbers,
	sizeof(double) };
const struct member_type type_far = { "size or \"infinity\"", read_numbers,
	print_numbers, sizeof(double) };

static void read_flag(const struct value *v, const struct member *row, void *out)
{
	const bool flag = value_is(v, JSON_TRUE);

	if (row->words == NULL && !flag && !value_is(v, JSON_FALSE))
		value_refuse_type(v, "true or false");
	*(bool *)out = row->words != NULL ? value_word(v, row->words) == 1 : flag;
}

static void print_flag(struct printer *p, const struct member *row, const void *at)
{
	const bool is = *(const bool *)at;

	if (row->words != NULL)
		put_string(p, row->words[is]);
	else
		put_literal(p, is ? "true" : "false");
}

const struct member_type type_flag = { NULL, read_flag, print_flag, sizeof(bool) };

static void read_word(const struct value *v, const struct member *row, void *out)
{
	*(unsigned *)out = row->word_0 + (unsigned)value_word(v, row->words);
}

static void print_word(struct printer *p, const struct member *row, const void *at)
{
	put_string(p, row->words[*(const unsigned *)at - row->word_0]);
}

const struct member_type type_word = { NULL, read_word, print_word, sizeof(unsigned) };

const struct member_type type_points = { "a point or a list", NULL, NULL, 0 };

const char *const vector_names[] = { "row", "column", NULL };

/* The object that -o json prints for a matrix. */
static const struct member matrix_members[] = { { .name = "matrix" },
	{ .name = "vectors" }, { .name = NULL } };

#define MATRIX_FORMS "16 numbers or 4 rows of 4"
#define AFFINE_FORMS "16 numbers, or 4 rows of 4 or 3, or 3 rows of 4"

static const struct rule matrix_rules[] = {
	{ .ways = WAYS("matrix vectors?") },
	{ .ways = NULL },
};
static const struct member matrix_row = { .members = matrix_members,
	.rules = matrix_rules };

/* Returns whether rows of a matrix are for column vectors: by the member "vectors" of
 * v, else by the shape or, if it is square, by the document. */
static bool is_for_columns(const struct value *v, size_t rows, size_t columns)
{
	bool column = rows < columns, square = rows == columns;
	struct value vectors;

	if (!value_is(v, JSON_OBJECT) || !value_member(v, "vectors", &vectors))
		return square ? v->source->column_vectors : column;
	bool given = value_word(&vectors, vector_names) == 1;

	if (!square && given != column)
		value_refuse(&vectors, "is \"%s\"; %zu rows of %zu are for %s vectors",
		    vector_names[given], rows, columns, vector_names[column]);
	return given;
}

/* `column` says which vectors the rows of the matrix were read for. */
static void check_transposed(const struct value *v, const double m[4][4], bool column)
{
	/* with faults the convention may be the wrong one */
	if (json_faults.n == 0 && m[3][0] == 0 && m[3][1] == 0 && m[3][2] == 0 &&
	    m[3][3] == 1 && (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0))
		value_refuse(v,
		    column ?
			"its rows are for row vectors; write it as {\"matrix\": [...], "
			"\"vectors\": \"row\"}" :
			"its rows are for column vectors; write it as {\"matrix\": "
			"[...], \"vectors\": \"column\"}, or name the \"convention\" "
			"that it is from, such as \"opencv\" or \"webgpu\"");
}

/* Reads an array of rows of numbers, or an array of the numbers row after row. */
static void read_rows(const struct value *v, size_t rows, size_t columns, double *out)
{
	struct value row = value_child(v);

	if (value_count(v) != rows)
		value_numbers(v, &range_any, rows * columns, "", out);
	else
		for (; row.item != NULL; value_next(&row), out += columns)
			value_numbers(&row, &range_any, columns, "", out);
}

/* Rows for column vectors are transposed. A list of 16 numbers is not: it lists rows
 * for row vectors, but columns for column vectors. */
static void read_matrix(const struct value *v, const struct member *row, void *out)
{
	const bool affine = row->type != &type_matrix;
	double(*m)[4] = out;
	struct value all = *v;

	if (value_is(v, JSON_OBJECT)) {
		object_read(v, &matrix_row, 0, NULL);
		if (!value_member(v, "matrix", &all))
			value_give_up(v);
	}
	if (!value_is(&all, JSON_ARRAY))
		value_refuse_type(&all,
		    affine ? "an array of " AFFINE_FORMS : "an array of " MATRIX_FORMS);
	const struct value first = value_child(&all);
	size_t n = value_count(&all), rows = affine && n == 3 ? 3 : 4;
	bool narrow = affine && n == rows && value_count(&first) == 3;
	size_t columns = narrow ? 3 : 4;
	bool column = is_for_columns(v, rows, columns), swap = column && n == rows;
	double e[16];

	if (narrow && n == 3)
		value_refuse(&all,
		    "is 3x3; append t to its rows: [R|t]; t is -R C of an eye C");
	if (n != rows && n != 16)
		value_refuse(&all, "has %zu element%s; %s are wanted%s", n,
		    n == 1 ? "" : "s", affine ? AFFINE_FORMS : MATRIX_FORMS,
		    affine ? "" : "; K and P are \"intrinsics\" of type \"persp\"");
	read_rows(&all, rows, columns, e);
	for (size_t i = 0; i < 4; i++)
		for (size_t j = 0; j < 4; j++)
			m[swap ? j : i][swap ? i : j] = i < rows && j < columns ?
			    e[i * columns + j] :
			    i == j;
	/* an inverse computed in doubles may end in 1 - 2^-53 instead of 1 */
	if (affine && fabs(m[3][3] - 1) <= 0x1p-40)
		m[3][3] = 1;
	if (affine && n == rows)
		check_transposed(v, m, column);
}

static void print_affine(struct printer *p, const struct member *row, const void *at)
{
	const double(*m)[4] = at;

	(void)row;
	put_open(p, "[");
	for (int i = 0; i < 4; i++) {
		double e[4];

		for (int j = 0; j < 4; j++)
			e[j] = p->column_vectors ? m[j][i] : m[i][j];
		put_numbers(p, e, 4);
	}
	put_close(p, "]");
}

const struct member_type type_matrix = { "matrix", read_matrix, NULL, 0 };
const struct member_type type_affine = { "matrix", read_matrix, print_affine, 0 };

#define INTRINSICS_FORMS                                              \
	"[fx, fy, cx, cy], K as 3 rows of 3 or 9 numbers, or P as 3 " \
	"rows of 4 or 12 numbers"

static void check_k(const struct value *v, const double k[3][4])
{
	if (k[1][0] != 0 || k[2][0] != 0 || k[2][1] != 0 || k[2][2] != 1 ||
	    !scene_is_size(k[0][0]) || !scene_is_size(k[1][1]))
		value_refuse(v,
		    "is not [[fx, skew, cx], [0, fy, cy], [0, 0, 1]], fx and fy "
		    "positive; is it a camera's K, and not transposed?");
}

static void read_intrinsics(const struct value *v, const struct member *row, void *out)
{
	double(*k)[4] = out, e[12];
	struct value first = value_child(v);
	bool nested = value_is(&first, JSON_ARRAY);

	(void)row;
	if (!value_is(v, JSON_ARRAY))
		value_refuse_type(v, INTRINSICS_FORMS ",");
	size_t n = value_count(v), columns = n / 3;

	if (nested)
		columns = value_count(&first) == 4 ? 4 : 3;
	if (n == 4 && !nested) {
		value_numbers(v, &range_any, 4, "", e);
		for (int i = 0; i < 2; i++, value_next(&first)) {
			value_number(&first, &range_positive);
			k[i][i] = e[i];
			k[i][2] = e[2 + i];
		}
		k[2][2] = 1;
		return;
	}
	if (nested ? n != 3 : n != 9 && n != 12)
		value_refuse(v, "is none of " INTRINSICS_FORMS "; %s",
		    n == 16 || nested || n < 5 ?
			"a 4x4 from view to clip is of type \"matrix\"" :
			"what follows fx, fy, cx, cy bends a lens: 'Points through a "
			"lens' in 'man projcalc-scene'");
	read_rows(v, 3, columns, e);
	if (n == 12 && e[0] > 0 && e[1] == 0 && e[2] == 0 && e[4] > 0 && e[5] == 0 &&
	    e[8] == 1 && !v->unused)
		value_refuse(v, "looks like a P by columns; write 3 rows of 4");
	for (size_t i = 0; i < 3; i++)
		memcpy(k[i], e + i * columns, columns * sizeof *e);
	if (columns == 3 && !v->unused)
		check_k(v, k);
	if (columns == 4 && k[2][0] == 0 && k[2][1] == 0 && k[2][2] == 0 && !v->unused)
		value_refuse(v,
		    "the last row of P begins 0, 0, 0; a perspective divides by more "
		    "than one number");
}

/* Prints the 3x4 matrix P by the fewest numbers: as fx, fy, cx, cy, as K, or as P. */
static void print_intrinsics(struct printer *p, const struct member *row,
    const void *at)
{
	const double(*k)[4] = at;
	const double four[4] = { k[0][0], k[1][1], k[0][2], k[1][2] };
	bool is_p = k[0][3] != 0 || k[1][3] != 0 || k[2][3] != 0 || k[1][0] != 0 ||
	    k[2][0] != 0 || k[2][1] != 0 || k[2][2] != 1 ||
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

const struct member_type type_intrinsics = { "4 numbers, K or P", read_intrinsics,
	print_intrinsics, 0 };
