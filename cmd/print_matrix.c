/* SPDX-License-Identifier: MIT */
#include "print_matrix.h"

#include <math.h>

#include "../core/points/kernel/little.h"
#include "json/print.h"
#include "scene/types.h"
#include "message/message.h"

/* The rows and columns of a map that are printed, of 3 or 4: in 2D z is left out. */
static const int PICKED[2][4] = { { 0, 1, 3 }, { 0, 1, 2, 3 } };

/* As they are printed for row vectors. */
struct elements {
	int rows, columns;
	double at[4][4];
};

static void refuse_wide(const struct document *d, const struct elements *m)
{
	for (int i = 0; i < m->rows * m->columns; i++)
		if (!isfinite((float)m->at[i / m->columns][i % m->columns]))
			document_refuse(d,
			    "the matrix has elements beyond the range of "
			    "floats; print doubles");
}

/* In memory order, which for row vectors goes row by row and for column vectors
 * column by column: those are the same numbers. */
static void print_binary(const struct elements *m, bool wide)
{
	for (int i = 0; i < m->rows * m->columns; i++) {
		double v = m->at[i / m->columns][i % m->columns];
		char number[8];

		if (wide)
			put_little_double(number, v);
		else
			put_little_float(number, (float)v);
		put_all(number, wide ? 8 : 4);
	}
}

static void put_lines(struct printer *p, const struct elements *m,
    const char *separator)
{
	for (int i = 0; i < m->rows; i++) {
		for (int j = 0; j < m->columns; j++) {
			p->between = j == 0 ? "" : separator;
			put_number(p, m->at[i][j]);
		}
		put_text(p, "\n");
	}
}

static void put_json(struct printer *p, const struct elements *m, bool column)
{
	put_open(p, "{");
	put_name(p, "matrix");
	put_open(p, "[");
	for (int i = 0; i < m->rows; i++)
		put_numbers(p, m->at[i], m->columns);
	put_close(p, "]");
	put_name(p, "vectors");
	put_string(p, vector_names[column]);
	put_close(p, "}\n");
}

static struct elements transposed(const struct elements *m)
{
	struct elements r = { .rows = m->columns, .columns = m->rows };

	for (int i = 0; i < r.rows; i++)
		for (int j = 0; j < r.columns; j++)
			r.at[i][j] = m->at[j][i];
	return r;
}

static struct elements elements_of(const struct transform *t, bool floats)
{
	struct elements m = { .rows = t->in == 2 ? 3 : 4,
		.columns = t->out == 2 ? 3 : 4 };

	for (int i = 0; i < m.rows; i++)
		for (int j = 0; j < m.columns; j++)
			m.at[i][j] = map_nearest(&t->map, PICKED[m.rows - 3][i],
			    PICKED[m.columns - 3][j], floats);
	return m;
}

void print_matrix(const struct options *o, const struct document *d,
    const struct transform *t)
{
	static char text[16 * (NUMBER_MAX + 2) + 64];
	bool single = o->precision == PRECISION_SINGLE;
	bool floats = single || o->out == FORMAT_F32;
	bool column = answer_convention(&d->scene)->column;
	struct printer p = { .at = text,
		.style = one_style(o, "a matrix"),
		.single = single,
		.compact = true,
		.between = "" };
	const char between[] = { dialect_of(o->out, o->separator).separator,
		'\0' };
	struct elements m = elements_of(t, floats);

	if (floats)
		refuse_wide(d, &m);
	if (is_binary(o->out)) {
		print_binary(&m, o->out == FORMAT_F64);
		return;
	}
	if (column)
		m = transposed(&m);
	if (o->out == FORMAT_JSON)
		put_json(&p, &m, column);
	else
		put_lines(&p, &m, between);
	put_all(text, (size_t)(p.at - text));
}
