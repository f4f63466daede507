/* SPDX-License-Identifier: MIT */
#include "print_matrix.h"

#include <math.h>

#include "../core/points/kernel/little.h"
#include "json/print.h"
#include "scene/types.h"
#include "message/message.h"

/* The rows and columns of a map that are printed: in 2D z is left out. */
static const int SPATIAL[4] = { 0, 1, 2, 3 }, FLAT[3] = { 0, 1, 3 };

/* In memory order, which for row vectors goes row by row and for column vectors
 * column by column: those are the same numbers, and m's. */
static void print_binary(double m[4][4], int n, bool wide)
{
	for (int i = 0; i < n * n; i++) {
		double v = m[i / n][i % n];
		char number[8];

		if (wide)
			put_little_double(number, v);
		else
			put_little_float(number, (float)v);
		put_all(number, wide ? 8 : 4);
	}
}

static void put_lines(struct printer *p, double m[4][4], int n,
    const char *separator)
{
	for (int i = 0; i < n; i++) {
		for (int j = 0; j < n; j++) {
			p->between = j == 0 ? "" : separator;
			put_number(p, m[i][j]);
		}
		put_text(p, "\n");
	}
}

static void put_json(struct printer *p, double m[4][4], int n, bool column)
{
	put_open(p, "{");
	put_name(p, "matrix");
	put_open(p, "[");
	for (int i = 0; i < n; i++)
		put_numbers(p, m[i], n);
	put_close(p, "]");
	put_name(p, "vectors");
	put_string(p, vector_names[column]);
	put_close(p, "}\n");
}

void print_matrix(const struct options *o, const struct document *d,
    const struct map *map, bool flat)
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
	const int *pick = flat ? FLAT : SPATIAL;
	int n = flat ? 3 : 4;
	double m[4][4];

	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++) {
			double v = map_nearest(map, pick[i], pick[j], floats);

			if (floats && !isfinite((float)v))
				document_refuse(d,
				    "the matrix has elements beyond the range "
				    "of floats; print doubles");
			if (column && !is_binary(o->out))
				m[j][i] = v;
			else
				m[i][j] = v;
		}
	if (is_binary(o->out)) {
		print_binary(m, n, o->out == FORMAT_F64);
		return;
	}
	if (o->out == FORMAT_JSON)
		put_json(&p, m, n, column);
	else
		put_lines(&p, m, n, between);
	put_all(text, (size_t)(p.at - text));
}
