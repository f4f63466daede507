#include <math.h>

#include "../core/depth.h"
#include "../core/error_bound.h"
#include "../core/taxonomy.h"
#include "command.h"
#include "json/print.h"
#include "talk.h"

/* In the order of enum taxon, kind, buffer and precision. */
static const char *const taxa[] = { "orthographic", "oblique", "perspective",
	"reverse perspective" };
static const char *const kinds[] = { "multiview", "isometric", "dimetric",
	"trimetric", "cavalier", "cabinet", "general", "one-point", "two-point",
	"three-point" };
static const char *const buffers[] = { "unorm16", "unorm24", "float32" };
static const char *const precisions[] = { "exact", "double", "single" };

/* Numbers that are there together or not at all. */
static void put_vector(struct printer *p, const double *v, int n)
{
	if (isnan(v[0]))
		put_number(p, v[0]);
	else
		put_numbers(p, v, n);
}

static void put_taxonomy(struct printer *p, const struct taxonomy *t)
{
	member(p, "projection");
	put_word(p, taxa[t->taxon]);
	member(p, "kind");
	put_word(p, kinds[t->kind]);
	member(p, "foreshortening");
	put_vector(p, t->foreshortening, 3);
	member(p, "vanishing_points");
	if (t->taxon <= TAXON_OBLIQUE) {
		put_number(p, (double)NAN);
	} else {
		enter(p, "[");
		for (int i = 0; i < 3; i++)
			put_vector(p, t->vanishing_point[i], 2);
		leave(p, "]");
	}
	member(p, "fovx");
	put_number(p, t->fov[0]);
	member(p, "fovy");
	put_number(p, t->fov[1]);
	member(p, "eye");
	put_vector(p, t->eye, 3);
	member(p, "gaze");
	put_vector(p, t->gaze, 3);
	member(p, "frustum");
	enter(p, "[");
	for (int i = 0; i < 8; i++)
		put_vector(p, t->corner[i], 3);
	leave(p, "]");
}

static void put_depth_steps(struct printer *p, double step[BUFFERS][2])
{
	member(p, "depth_step");
	enter(p, "{");
	for (int b = 0; b < BUFFERS; b++) {
		put_name(p, buffers[b]);
		enter(p, "[");
		put_number(p, step[b][0]);
		put_number(p, step[b][1]);
		leave(p, "]");
	}
	leave(p, "}");
}

/* The cheapest first. */
static void put_bounds(struct printer *p, const double bound[3],
    double tolerance)
{
	int precision = PRECISION_SINGLE;

	member(p, "error_bound");
	enter(p, "{");
	for (int i = PRECISION_SINGLE; i >= PRECISION_EXACT; i--) {
		put_name(p, precisions[i]);
		put_number(p, bound[i]);
	}
	leave(p, "}");
	while (precision > PRECISION_EXACT && !(bound[precision] <= tolerance))
		precision--;
	member(p, "precision");
	put_word(p, precisions[precision]);
}

int run_inspect(const struct command *c, const struct options *o)
{
	static char text[64 * NUMBER_MAX + 1024];
	struct printer p = { text, o->style, "" };
	struct document d;
	struct taxonomy t;
	double step[BUFFERS][2], bound[3];

	if (o->n_points > 0)
		die(EXIT_USAGE, "inspect reads no points; leave them out");
	read_document(c, o, 0, &d);
	const char *why = taxonomy_of(&d.scene, &t);

	if (why == NULL)
		why = error_bounds(&d.scene, bound);
	if (why != NULL)
		json_refuse(&d, why);
	depth_steps(&d.scene, t.reversed, step);
	enter(&p, "{");
	put_taxonomy(&p, &t);
	put_depth_steps(&p, step);
	put_bounds(&p, bound,
	    o->accuracy.tolerance > 0 ? o->accuracy.tolerance : 0.5);
	put_text(&p, "\n}\n");
	put_all(text, (size_t)(p.at - text));
	close_output();
	return EXIT_OK;
}
