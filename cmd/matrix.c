/* SPDX-License-Identifier: MIT */
#include "call/operands.h"
#include "print_matrix.h"
#include "message/message.h"

/* In the order of enum flat. */
static const char *const flat_names[] = { "window", "ndc", "device" };

static void matrix_transform(const struct command *c, const struct options *o,
    const struct document *d, int to, struct job *j)
{
	const struct scene *s = &d->scene;
	bool planes = o->flags || o->visible;

	document_check(d,
	    c->kind == PLANAR ? flat_transform(s, (enum flat)c->from,
				    (enum flat)to, &j->transform) :
				scene_transform(s, (enum space)c->from,
				    (enum space)to, false, &j->transform));
	if (planes)
		document_check(d,
		    flat_frustum_of(s, (enum flat)c->from, &j->frustum));
	j->count_imageless = !planes;
}

void run_matrix(const struct command *c, const struct options *o)
{
	struct document d;
	static struct job j;

	read_document(c, o, &d);

	bool points = !o->matrix && has_points(o, &d);

	if (!points && !o->matrix && (o->flags || o->visible || o->append))
		die(EXIT_USAGE,
		    "%s: --%s is about points, and there are none; add them, "
		    "or - for standard input",
		    c->name,
		    o->flags      ? "flags" :
			o->append ? "append" :
				    "visible");
	matrix_transform(c, o, &d, points ? c->points_to : c->to, &j);
	if (!points) {
		print_matrix(o, &d, &j.transform);
		return;
	}
	j.space = c->kind == PLANAR ? flat_names[c->points_to] :
				      space_names[c->points_to];
	prepare_job(&j, o);
	do_points(o, &d, &j);
}
