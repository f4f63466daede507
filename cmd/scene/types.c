/* SPDX-License-Identifier: MIT */
#include "types.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/scene/scene.h"

const char *const angle_unit_names[] = {
	[ANGLE_DEGREES] = "degrees",
	[ANGLE_RADIANS] = "radians",
	[ANGLE_RADIANS + 1] = NULL,
};

static bool read_number_member(const struct value *v, const struct member *row,
    void *out)
{
	const struct value_range *range = row->range != NULL ? row->range : &range_any;

	return row->n == 0 ? value_number(v, range, out) :
			     value_numbers(v, range, row->n, out);
}

static bool read_far(const struct value *v, const struct member *row, void *out)
{
	static const char *const words[] = { "infinity", NULL };
	unsigned index;

	if (value_string(v) != NULL) {
		*(double *)out = HUGE_VAL;
		return value_word(v, words, NULL, &index);
	}
	if (!value_is(v, JSON_NUMBER))
		return value_refuse_type(v, "a number or \"infinity\"");
	return value_number(v, row->range, out);
}

static void print_numbers(struct printer *p, const struct member *row, const void *at)
{
	if (row->n == 0)
		put_distance(p, *(const double *)at);
	else
		put_numbers(p, at, (int)row->n);
}

const struct member_type type_numbers = { .read = read_number_member,
	.print = print_numbers,
	.number_size = sizeof(double) };
const struct member_type type_far = { .name = "size or \"infinity\"",
	.read = read_far,
	.print = print_numbers,
	.number_size = sizeof(double) };

static bool read_flag(const struct value *v, const struct member *row, void *out)
{
	unsigned index = value_is(v, JSON_TRUE);
	const bool good = row->words != NULL ?
	    value_word(v, row->words, row->word_aliases, &index) :
	    index == 1 || value_is(v, JSON_FALSE) ||
		value_refuse_type(v, "true or false");

	if (good)
		*(bool *)out = index == 1;
	return good;
}

static void print_flag(struct printer *p, const struct member *row, const void *at)
{
	const bool is = *(const bool *)at;

	if (row->words != NULL)
		put_string(p, row->words[is]);
	else
		put_literal(p, is ? "true" : "false");
}

const struct member_type type_flag = { .read = read_flag,
	.print = print_flag,
	.number_size = sizeof(bool) };

static bool read_word_member(const struct value *v, const struct member *row, void *out)
{
	unsigned index;
	const bool good = value_word(v, row->words, row->word_aliases, &index);

	if (good)
		*(unsigned *)out = row->word_0 + index;
	return good;
}

static void print_word(struct printer *p, const struct member *row, const void *at)
{
	put_string(p, row->words[*(const unsigned *)at - row->word_0]);
}

const struct member_type type_word = { .read = read_word_member,
	.print = print_word,
	.number_size = sizeof(unsigned) };

const struct member_type type_points = { .name = "a point or a list" };

const char *const vector_names[] = { "row", "column", NULL };
const char *const y_names[] = { "up", "down", NULL };

enum { MATRIX_ROW_MATRIX, MATRIX_ROW_VECTORS };

/* The object that -o json prints for a matrix. */
static const struct member matrix_members[] = {
	[MATRIX_ROW_MATRIX] = { .name = "matrix" },
	[MATRIX_ROW_VECTORS] = { .name = "vectors" },
	{ .name = NULL },
};

#define MATRIX_FORMS "16 numbers or 4 rows of 4"
#define AFFINE_FORMS "16 numbers, or 4 rows of 4 or 3, or 3 rows of 4"
#define STEP_FORMS AFFINE_FORMS " or 3"

static const struct rule matrix_rules[] = {
	{ WAYS(WAY(MEMBER_BIT(MATRIX_ROW_MATRIX),
	    .optional = MEMBER_BIT(MATRIX_ROW_VECTORS))) },
	{ .n = 0 },
};
static const struct member matrix_row = { .members = matrix_members,
	.rules = matrix_rules };

/* What a matrix is for. Each use has the forms of those before it, and more. */
enum matrix_use { ANY_MATRIX, AFFINE_MATRIX, MATRIX_OF_STEP, MATRIX_USES };

/* The forms of a matrix: an array of rows, or a list of all numbers. */
static const struct form {
	size_t rows, columns;
	/* the vectors that the rows are for, always or if "vectors" does not say */
	enum { LISTED, BY_DOCUMENT, FOR_ROWS, FOR_COLUMNS, MOSTLY_FOR_COLUMNS } vectors;
	enum matrix_use first; /* of the uses that have the form */
} forms[] = {
	{ 4, 3, FOR_ROWS, AFFINE_MATRIX },
	{ 4, 4, BY_DOCUMENT, ANY_MATRIX },
	{ 3, 3, MOSTLY_FOR_COLUMNS, MATRIX_OF_STEP },
	{ 3, 4, FOR_COLUMNS, AFFINE_MATRIX },
	{ 4, 4, LISTED, ANY_MATRIX },
};

/* The forms of the uses, for messages. */
static const char *const form_names[MATRIX_USES] = {
	[ANY_MATRIX] = MATRIX_FORMS,
	[AFFINE_MATRIX] = AFFINE_FORMS,
	[MATRIX_OF_STEP] = STEP_FORMS,
};

/* Returns the form of the array v, or NULL after a refusal. */
static const struct form *find_form(const struct value *v, enum matrix_use use)
{
	const struct value first = value_child(v);
	const size_t n = value_count(v), columns = value_count(&first);

	for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
		const struct form *f = &forms[i];

		if (use >= f->first && n == (f->vectors == LISTED ? 16 : f->rows) &&
		    (f->columns != 3 || columns == 3))
			return f;
	}
	value_refuse_count(v, n,
	    text("%s are wanted%s", form_names[use],
		use != ANY_MATRIX ? "" :
				    "; K and P are \"intrinsics\" of type \"persp\""));
	return NULL;
}

/* Sets *columns to whether the rows of a matrix of the form are for column vectors: by
 * the member "vectors" of v, else by the form or by the document. Sets *unknown if they
 * are those of a convention that was refused or that the camera needs and lacks, which
 * is what is told. */
static bool read_vectors(const struct value *v, const struct form *f, bool *columns,
    bool *unknown)
{
	const struct json_source *s = v->source;
	const bool by_document = f->vectors == BY_DOCUMENT;
	struct value given;
	unsigned index;

	*columns = by_document ? s->column_vectors : f->vectors != FOR_ROWS;
	*unknown = by_document &&
	    (s->is_convention_wrong || (s->is_camera && !s->has_convention));
	if (!value_is(v, JSON_OBJECT) ||
	    !object_member(v, &matrix_members[MATRIX_ROW_VECTORS], &given))
		return true;
	*unknown = false;
	if (!value_word(&given, vector_names, NULL, &index))
		return false;
	if ((f->vectors == FOR_ROWS || f->vectors == FOR_COLUMNS) &&
	    (index == 1) != *columns)
		return value_refuse(&given, text("is \"%s\"", vector_names[index]),
		    text("%zu rows of %zu are for %s vectors", f->rows, f->columns,
			vector_names[*columns]));
	*columns = index == 1;
	return true;
}

/* `columns` says which vectors the rows of the matrix were read for. */
static bool check_transposed(const struct value *v, const double m[4][4], bool columns)
{
	if (m[3][0] != 0 || m[3][1] != 0 || m[3][2] != 0 || m[3][3] != 1 ||
	    (m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0))
		return true;
	return columns ?
	    value_refuse(v, "its rows are for row vectors",
		"write it as {\"matrix\": [...], \"vectors\": \"row\"}") :
	    value_refuse(v, "its rows are for column vectors",
		"write it as {\"matrix\": [...], \"vectors\": \"column\"}, or name the "
		"\"convention\" that it is from, such as \"opencv\" or \"webgpu\"");
}

/* Reads an array of rows of numbers, or an array of the numbers row after row. */
static bool read_rows(const struct value *v, size_t rows, size_t columns, double *out)
{
	bool good = true;

	if (value_count(v) != rows)
		return value_numbers(v, &range_any, rows * columns, out);
	for (struct value row = value_child(v); row.item != NULL;
	     value_next(&row), out += columns)
		good &= value_numbers(&row, &range_any, columns, out);
	return good;
}

/* Sets m from the elements e of a matrix of the form. Rows for column vectors are
 * transposed. A list of 16 numbers is not: it lists rows for row vectors, but columns
 * for column vectors. */
static void set_matrix(const struct form *f, bool columns, const double e[16],
    double m[4][4])
{
	const bool swap = columns && f->vectors != LISTED;

	for (size_t i = 0; i < 4; i++)
		for (size_t j = 0; j < 4; j++)
			m[swap ? j : i][swap ? i : j] = i < f->rows && j < f->columns ?
			    e[i * f->columns + j] :
			    i == j;
}

bool matrix_read_member(const struct value *object, const struct value *v,
    const struct member *row, double m[4][4])
{
	/* of the rows of type_affine all are steps; type_steps reads by it, too */
	const enum matrix_use use = row->type == &type_matrix ? ANY_MATRIX :
	    row->type == &type_affine                         ? MATRIX_OF_STEP :
								AFFINE_MATRIX;
	const bool affine = use != ANY_MATRIX;
	const struct value first = value_child(v);
	double e[16] = { 0 };
	bool columns, unknown;

	if (!value_is(v, JSON_ARRAY))
		return value_refuse_type(v, text("an array of %s", form_names[use]));
	if (use == AFFINE_MATRIX && value_count(v) == 3 && value_count(&first) == 3)
		return value_refuse(v, "is 3x3",
		    "append t to its rows: [R|t]; R alone is \"rotation\" of "
		    "a camera, with \"eye\" or \"translation\"");
	const struct form *f = find_form(v, use);

	if (f == NULL)
		return false;
	const bool good = read_vectors(object, f, &columns, &unknown);

	if (!read_rows(v, f->rows, f->columns, e) || !good)
		return false;
	set_matrix(f, columns, e, m);
	/* an inverse computed in doubles may end in 1 - 2^-53 instead of 1 */
	if (affine && fabs(m[3][3] - 1) <= 0x1p-40)
		m[3][3] = 1;
	if (!affine || f->vectors == LISTED)
		return true;
	return !unknown && check_transposed(object, m, columns);
}

static bool read_matrix(const struct value *v, const struct member *row, void *out)
{
	struct value m = *v;

	if (value_is(v, JSON_OBJECT)) {
		object_read(v, &matrix_row, 0, NULL, NULL);
		if (!object_member(v, &matrix_members[MATRIX_ROW_MATRIX], &m))
			return false;
	}
	return matrix_read_member(v, &m, row, out);
}

static void print_affine(struct printer *p, const struct member *row, const void *at)
{
	const double(*m)[4] = at;
	double e[16];

	(void)row;
	for (int i = 0; i < 16; i++)
		e[i] = p->column_vectors ? m[i % 4][i / 4] : m[i / 4][i % 4];
	put_rows(p, e, 4, 4);
}

static bool read_rotation(const struct value *v, const struct member *row, void *out)
{
	const struct value first = value_child(v);

	(void)row;
	if (!value_is(v, JSON_ARRAY))
		return value_refuse_type(v, "an array of 3 rows of 3 numbers");
	if (value_count(v) == 4 && !value_is(&first, JSON_ARRAY))
		return value_refuse_count(v, 4,
		    "3 rows of 3 numbers are wanted; x, y, z, w of view to world are "
		    "\"orientation\"");
	if (value_count(v) != 3 || !value_is(&first, JSON_ARRAY))
		return value_refuse_count(v, value_count(v),
		    "3 rows of 3 numbers are wanted");
	if (value_count(&first) == 4)
		return value_refuse(v, "is 3x4", "[R|t] is \"matrix\"");
	return read_rows(v, 3, 3, out);
}

/* The letters of the directions from AXIS_BACK on; 0 is none. */
static const char axis_letters[] = "bdl ruf";

/* Reads one of the 48 words that have a letter each of rl, ud and fb. */
static bool read_axes(const struct value *v, const struct member *row, void *out)
{
	const char *s = value_string(v);
	enum camera_axis *axes = out;
	char word[4] = "";

	(void)row;
	if (s == NULL)
		return value_refuse_type(v, "a word such as \"flu\"");
	for (int k = 0; k < 7 * 7 * 7; k++) {
		unsigned lines = 0;

		for (int i = 0, n = k; i < 3; i++, n /= 7) {
			axes[i] = (enum camera_axis)(AXIS_BACK + n % 7);
			word[i] = axis_letters[n % 7];
			lines |= 1u << abs(axes[i]);
		}
		if (lines == (1u << 1 | 1u << 2 | 1u << 3) && word_equals(s, word))
			return true;
	}
	return value_refuse(v, text("is \"%.*s\"", (int)utf8_fit(s, 60), s),
	    "write where x, y and z point, one each of r or l, u or d, f or b: "
	    "\"flu\" of ROS and Waymo, \"rub\" of GL, \"rdf\" of OpenCV");
}

/* A camera is printed by its gaze: not with a rotation, nor with axes. */
const struct member_type type_axes = { .name = "a word as flu", .read = read_axes };
const struct member_type type_rotation = { "3 rows of 3 numbers", read_rotation, NULL,
	.doubles = 9 };
const struct member_type type_matrix = { "matrix", read_matrix, NULL, .doubles = 16 };
const struct member_type type_affine = { "matrix", read_matrix, print_affine,
	.doubles = 16 };

#define INTRINSICS_FORMS                                              \
	"[fx, fy, cx, cy], K as 3 rows of 3 or 9 numbers, or P as 3 " \
	"rows of 4 or 12 numbers"

/* The remedy for negative focal lengths. */
#define AS_P "write P, 3 rows of 4 that end in 0, in which they may be negative"

static bool check_k(const struct value *v, const double k[3][4])
{
	const bool shaped = k[1][0] == 0 && k[2][0] == 0 && k[2][1] == 0 &&
	    k[2][2] == 1;

	if (shaped && (k[0][0] < 0 || k[1][1] < 0))
		return value_refuse(v, "has a negative focal length", AS_P);
	if (shaped && scene_is_size(k[0][0]) && scene_is_size(k[1][1]))
		return true;
	return value_refuse(v,
	    "is not [[fx, skew, cx], [0, fy, cy], [0, 0, 1]], fx and fy positive",
	    "is it a camera's K, and not transposed?");
}

/* `e` has the elements of P, row by row, which may have been given by columns. */
static bool check_p(const struct value *v, bool listed, const double e[12])
{
	if (listed && e[0] > 0 && e[1] == 0 && e[2] == 0 && e[4] > 0 && e[5] == 0 &&
	    e[8] == 1)
		return value_refuse(v, "looks like a P by columns",
		    "write 3 rows of 4");
	if (e[8] == 0 && e[9] == 0 && e[10] == 0)
		return value_refuse(v, "the last row of P begins 0, 0, 0",
		    "a perspective divides by more than one number");
	return true;
}

/* Reads fx, fy, cx, cy. */
static bool read_four(const struct value *v, double k[3][4])
{
	struct value element = value_child(v);
	double e[4];
	bool good = value_numbers(v, &range_any, 4, e);

	for (int i = 0; i < 2; i++, value_next(&element)) {
		double size;

		if (!value_is(&element, JSON_NUMBER) || v->unused)
			continue;
		if (e[i] < 0)
			good = value_refuse(&element, "is a negative focal length",
			    AS_P);
		else if (e[i] <= SCENE_MAGNITUDE_MAX)
			good &= value_number(&element, &range_positive, &size);
		k[i][i] = e[i];
		k[i][2] = e[2 + i];
	}
	k[2][2] = 1;
	return good;
}

static bool read_intrinsics(const struct value *v, const struct member *row, void *out)
{
	double(*k)[4] = out, e[12];

	(void)row;
	if (!value_is(v, JSON_ARRAY))
		return value_refuse_type(v, INTRINSICS_FORMS ",");
	const struct value first = value_child(v);
	const bool nested = value_is(&first, JSON_ARRAY);
	const size_t n = value_count(v);
	const size_t columns = !nested ? n / 3 : value_count(&first) == 4 ? 4 : 3;

	if (n == 4 && !nested)
		return read_four(v, k);
	if (nested ? n != 3 : n != 9 && n != 12)
		return value_refuse(v, "is none of " INTRINSICS_FORMS,
		    n == 16 || nested || n < 5 ?
			"a last row 0 0 0 1 is left out; a 4x4 from view to clip is of "
			"type \"matrix\"" :
			"what follows fx, fy, cx, cy bends a lens: 'Points through a "
			"lens' in 'man projcalc-recipes'");
	if (!read_rows(v, 3, columns, e))
		return false;
	for (size_t i = 0; i < 3; i++)
		memcpy(k[i], e + i * columns, columns * sizeof *e);
	return v->unused || (columns == 3 ? check_k(v, k) : check_p(v, !nested, e));
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
	print_intrinsics, .doubles = 12 };
