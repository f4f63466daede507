#include <math.h>

#include "command.h"
#include "talk.h"

/* The rows and columns that a 2D matrix has. */
static const int SPATIAL[4] = { 0, 1, 2, 3 }, FLAT[3] = { 0, 1, 3 };

struct printer {
	const struct options *o;
	char *at;
};

static void put_text(struct printer *p, const char *s)
{
	while (*s != '\0')
		*p->at++ = *s++;
}

static void put_element(struct printer *p, double v)
{
	p->at = p->o->accuracy.precision == PRECISION_SINGLE ?
	    number_write_float(p->at, (float)v, p->o->style) :
	    number_write(p->at, v, p->o->style);
}

/* Rows as the convention prints them. */
static void print_rows(struct printer *p, double m[4][4], int n)
{
	bool json = p->o->out == FORMAT_JSON;
	const char *between = json || p->o->out == FORMAT_CSV ? "," : " ";

	for (int i = 0; i < n; i++) {
		if (json)
			put_text(p, i == 0 ? "[[" : ",[");
		for (int j = 0; j < n; j++) {
			if (j > 0)
				put_text(p, between);
			put_element(p, m[i][j]);
		}
		put_text(p, json ? (i < n - 1 ? "]" : "]]") : "\n");
	}
}

/* Row vectors row by row or column vectors column by column: the same. */
static void print_binary(const struct printer *p, double m[4][4], int n)
{
	for (int i = 0; i < n * n; i++) {
		double v = m[i / n][i % n];
		float narrow = (float)v;

		if (p->o->out == FORMAT_F64)
			put_all((const char *)&v, sizeof v);
		else
			put_all((const char *)&narrow, sizeof narrow);
	}
}

void print_matrix(const struct options *o, const struct document *d,
    const struct map *map, bool flat)
{
	const struct convention *c = &d->scene.convention;
	bool floats = o->accuracy.precision == PRECISION_SINGLE ||
	    o->out == FORMAT_F32;
	static char text[16 * (NUMBER_MAX + 2) + 64];
	struct printer p = { o, text };
	const int *pick = flat ? FLAT : SPATIAL;
	int n = flat ? 3 : 4;
	double m[4][4];

	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++) {
			int row = pick[i] == 3 ? AT_ZERO : pick[i];
			double v = map->m[row][pick[j]].hi;
			bool turned = c->column && !is_binary(o->out);

			if (floats && !isfinite((float)v))
				json_refuse(d,
				    "the matrix has elements beyond the range "
				    "of floats; print doubles");
			m[turned ? j : i][turned ? i : j] = v;
		}
	if (is_binary(o->out)) {
		print_binary(&p, m, n);
		return;
	}
	if (o->out == FORMAT_JSON)
		put_text(&p, "{\"matrix\":");
	print_rows(&p, m, n);
	if (o->out == FORMAT_JSON)
		put_text(&p,
		    c->column ? ",\"vectors\":\"column\"}\n" :
				",\"vectors\":\"row\"}\n");
	put_all(text, (size_t)(p.at - text));
}

int run_matrix(const struct command *c, const struct options *o)
{
	struct document d;
	struct job j = { .count_imageless = true };
	struct transform *t = &j.transform;

	read_document(c, o, c->flat ? 2 : 3, &d);

	bool points = !o->matrix && has_points(o, &d);
	int to = points ? c->points_to : c->to;
	const char *why = c->flat ?
	    flat_transform(&d.scene, (enum flat)c->from, (enum flat)to, t) :
	    scene_transform(&d.scene, (enum space)c->from, (enum space)to,
		false, t);

	if (why != NULL)
		json_refuse(&d, why);
	if (points) {
		stream_options(&j, o);
		stream_points(o, &d, &j);
		return stream_end(&j);
	}
	print_matrix(o, &d, &t->map, c->flat);
	close_output();
	return EXIT_OK;
}
