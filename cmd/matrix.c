#include "operands.h"
#include "print_matrix.h"

void run_matrix(const struct command *c, const struct options *o)
{
	struct document d;
	static struct job j = { .count_imageless = true };
	struct transform *t = &j.transform;

	read_document(c, o, c->flat ? 2 : 3, &d);

	bool points = !o->matrix && has_points(o, &d);
	int to = points ? c->points_to : c->to;

	document_check(&d,
	    c->flat ?
		flat_transform(&d.scene, (enum flat)c->from, (enum flat)to, t) :
		scene_transform(&d.scene, (enum space)c->from, (enum space)to,
		    false, t));
	if (points) {
		prepare_job(&j, o);
		do_points(o, &d, &j);
		return;
	}
	print_matrix(o, &d, &t->map, c->flat);
}
