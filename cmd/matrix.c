/* SPDX-License-Identifier: MIT */
#include "matrix.h"

#include <math.h>

#include "../core/points/kernel/little.h"
#include "call/notes.h"
#include "call/operands.h"
#include "json/print.h"
#include "message/message.h"
#include "scene/types.h"
#include "call/option_row.h"

/* Puts a row of n elements. Binary is for row vectors: column vectors need the same
 * bytes, stored by columns. */
static void put_row(struct printer *p, const double *v, int n, struct dialect out)
{
	if (out.format == FORMAT_JSON) {
		put_numbers(p, v, n);
		return;
	}
	for (int j = 0; j < n; j++, p->at += format_of(out)->size) {
		if (format_is_binary(out.format)) {
			little_put(p->at, out.format == FORMAT_F64, v[j]);
			continue;
		}
		p->separator = NULL;
		put_number(p, v[j]);
		*p->at++ = j + 1 < n ? out.separator : '\n';
	}
}

void matrix_check_unit_w(const struct options *o, bool is_printed, enum space from,
    enum space to)
{
	if (o->unit_w && (!is_printed || from > SPACE_VIEW || to < SPACE_CLIP))
		die(EXIT_USAGE,
		    "--unit-w: is for a printed matrix from model, world or view to "
		    "clip, ndc or device, as with project -m",
		    NULL);
}

/* Divides the map by the magnitude of the element that takes z to w. */
static bool divide_by_w(const struct document *d, struct map *m)
{
	m->divisor = sum_abs(m->m[2][3]);
	return (sum_sign(m->divisor) != 0 && map_is_finite(m)) ||
	    document_refuse(d, NULL,
		"--unit-w: the element that takes z to w is 0, as in a parallel "
		"projection, or too small",
		"leave --unit-w out");
}

/* Sets *out to the element in row i and column j of the matrix of t for row vectors,
 * rounded to double or, if `floats` is true, to float. Refuses one out of range. In 2D
 * the map's row or column of z is left out. */
static bool find_element(const struct document *d, const struct transform *t, int i,
    int j, bool floats, double *out)
{
	static const int axes[2][4] = { { 0, 1, 3 }, { 0, 1, 2, 3 } };

	*out = map_element_nearest(&t->map, axes[t->in != 2][i], axes[t->out != 2][j],
	    floats);
	return !floats || isfinite((float)*out) ||
	    document_refuse(d, NULL,
		"the matrix is beyond floats, of -p single or -o f32", NULL);
}

bool matrix_print(const struct options *o, const struct document *d,
    struct transform *t)
{
	static char out[16 * (NUMBER_MAX + 2) + 64];
	const bool single = o->precision == PRECISION_SINGLE;
	const bool floats = single || o->out == FORMAT_F32;
	const bool column_vectors = scene_answer_convention(&d->scene)->column_vectors;
	const bool column = column_vectors && !format_is_binary(o->out);
	const int n[2] = { t->in == 2 ? 3 : 4, t->out == 2 ? 3 : 4 };
	struct printer p = { .at = out,
		.style = options_matrix_style(o),
		.floats = single,
		.compact = true };

	if (o->out == FORMAT_OBJ)
		die(EXIT_USAGE, "-o obj is for points",
		    "a matrix is printed as text, csv, tsv, json, f64 or f32");
	if (o->unit_w && !divide_by_w(d, &t->map))
		return false;
	if (o->out == FORMAT_JSON) {
		put_open(&p, "{");
		put_open(put_name(&p, "matrix"), "[");
	}
	for (int i = 0; i < n[column]; i++) {
		double row[4];

		for (int j = 0; j < n[!column]; j++)
			if (!find_element(d, t, column ? j : i, column ? i : j, floats,
				&row[j]))
				return false;
		put_row(&p, row, n[!column], dialect_of(o->out, o->separator));
	}
	if (o->out == FORMAT_JSON) {
		put_close(&p, "]");
		put_string(put_name(&p, "vectors"), vector_names[column]);
		put_close(&p, "}\n");
	}
	output_write(out, (size_t)(p.at - out));
	return true;
}

static const char *const flat_names[] = {
	[FLAT_WINDOW - FLAT_WINDOW] = "window",
	[FLAT_NDC - FLAT_WINDOW] = "ndc",
	[FLAT_DEVICE - FLAT_WINDOW] = "device",
};

static bool run_matrix(const struct options *o, struct document *d, struct job *j)
{
	const struct command *c = o->command;
	const struct scene *s = &d->scene;
	struct refusals *const faults = d->source.faults;
	const bool flat = c->kind == COMMAND_MATRIX_2D;
	const bool planes = o->flags || o->visible || o->lines;
	bool points = false;

	if (!o->matrix && !operands_have_points(o, d, &points))
		return false;
	const enum space from = c->from,
			 to = points && c->to == SPACE_CLIP ? SPACE_NDC : c->to;

	matrix_check_unit_w(o, !points, from, c->to);
	if (!(points ? transform_of_scene(s, from, to, false, &j->transform, faults) :
		       transform_of_matrix(s, from, to, &j->transform, faults)))
		return false;
	if (planes && !frustum_of(s, from, false, &j->frustum, faults))
		return false;
	if (!flat)
		notes_say_of_spaces(d, from, c->to);
	if (!points)
		return matrix_print(o, d, &j->transform);
	j->count_imageless = !planes;
	j->layout.from = flat ? flat_names[from - FLAT_WINDOW] : space_names[from];
	j->layout.output.space = flat ? flat_names[to - FLAT_WINDOW] : space_names[to];
	return operands_run_job(o, d, from, to, j);
}

static void judge_matrix(const struct options *o, const struct document *d)
{
	scene_check(&d->scene, o->command->from, o->command->to, d->source.faults);
}

const struct work matrix_work = { run_matrix, judge_matrix, NULL, NULL };
