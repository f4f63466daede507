/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "../core/derive/depth.h"
#include "../core/derive/error_bound.h"
#include "../core/derive/parameters.h"
#include "json/print.h"
#include "call/operands.h"
#include "scene/print_scene.h"
#include "scene/types.h"
#include "message/message.h"

/* In the order of enum taxon, kind and buffer. */
static const char *const taxa[] = { "orthographic", "oblique", "perspective",
	"reverse perspective" };
static const char *const kinds[] = { "multiview", "isometric", "dimetric",
	"trimetric", "cavalier", "cabinet", "general", "one-point", "two-point",
	"three-point" };
static const char *const buffers[] = { "unorm16", "unorm24", "float32" };

/* A vector. Where there is none, its first element is nan: prints null. */
static void put_vector(struct printer *p, const double *v, int n)
{
	if (isnan(v[0]))
		put_number(p, v[0]);
	else
		put_numbers(p, v, n);
}

static void put_taxonomy(struct printer *p, const struct taxonomy *t)
{
	put_name_on_new_line(p, "projection");
	put_string(p, taxa[t->taxon]);
	put_name_on_new_line(p, "kind");
	put_string(p, kinds[t->kind]);
	put_name_on_new_line(p, "foreshortening");
	put_vector(p, t->foreshortening, 3);
	put_name_on_new_line(p, "vanishing_points");
	if (t->taxon <= TAXON_OBLIQUE) {
		put_number(p, (double)NAN);
	} else {
		put_open(p, "[");
		for (int i = 0; i < 3; i++)
			put_vector(p, t->vanishing_point[i], 2);
		put_close(p, "]");
	}
	put_name_on_new_line(p, "fovx");
	put_number(p, t->fov[0]);
	put_name_on_new_line(p, "fovy");
	put_number(p, t->fov[1]);
	put_name_on_new_line(p, "eye");
	put_vector(p, t->eye, 3);
	put_name_on_new_line(p, "gaze");
	put_vector(p, t->gaze, 3);
}

static void put_sides(struct printer *p, const char *name, const double at[4])
{
	static const char *const sides[4] = { "left", "right", "bottom",
		"top" };

	put_name_on_new_line(p, name);
	put_open(p, "{");
	for (int k = 0; k < 4; k++) {
		put_name(p, sides[k]);
		put_number(p, at[k]);
	}
	put_close(p, "}");
}

static void put_planes(struct printer *p, const struct taxonomy *t,
    const struct parameters *r)
{
	put_name_on_new_line(p, "near");
	put_distance(p, r->near);
	put_name_on_new_line(p, "far");
	put_distance(p, r->far);
	put_name_on_new_line(p, "aspect");
	put_number(p, r->aspect);
	put_name_on_new_line(p, "reverse_z");
	if (projection_is_open(&r->scene.projection))
		put_number(p, (double)NAN); /* no plane is near */
	else
		put_flag(p, r->reverse_z);
	put_sides(p, "planes", r->plane);
	put_name_on_new_line(p, "frustum");
	put_open(p, "[");
	for (int i = 0; i < 8; i++)
		put_vector(p, t->corner[i], 3);
	put_close(p, "]");
	put_name_on_new_line(p, "frustum_planes");
	put_open(p, "[");
	for (int k = 0; k < 6; k++)
		put_vector(p, r->frustum_plane[k], 4);
	put_close(p, "]");
}

static void put_depth_steps(struct printer *p, double step[BUFFERS][2])
{
	put_name_on_new_line(p, "depth_step");
	put_open(p, "{");
	for (int b = 0; b < BUFFERS; b++) {
		put_name(p, buffers[b]);
		put_open(p, "[");
		put_number(p, step[b][0]);
		put_number(p, step[b][1]);
		put_close(p, "]");
	}
	put_close(p, "}");
}

/* The error bounds, the cheapest precision's first; then the name of the
 * cheapest precision whose bound is within tolerance. */
static void put_bounds(struct printer *p, const double bound[3],
    double tolerance)
{
	int precision = PRECISION_SINGLE;

	put_name_on_new_line(p, "error_bound");
	put_open(p, "{");
	for (int i = PRECISION_SINGLE; i >= PRECISION_EXACT; i--) {
		put_name(p, precision_names[i]);
		put_number(p, bound[i]);
	}
	put_close(p, "}");
	while (precision > PRECISION_EXACT && !(bound[precision] <= tolerance))
		precision--;
	put_name_on_new_line(p, "precision");
	put_string(p, precision_names[precision]);
}

/* Of a document without a projection, the window. */
static void put_plane(struct printer *p, const struct document *d)
{
	const struct scene *s = &d->scene;
	struct shown w;

	document_check(d, scene_shown(s, &w));
	put_sides(p, "window", w.edge);
	if (s->has_device) {
		put_device(p, &s->device);
	} else {
		put_name_on_new_line(p, "device");
		put_number(p, (double)NAN);
	}
	put_name_on_new_line(p, "scale");
	put_numbers(p, w.scale, 2);
}

/* Of all others. */
static void put_spatial(struct printer *p, const struct document *d,
    double tolerance)
{
	struct taxonomy t;
	static struct parameters r;
	double step[BUFFERS][2], bound[3];

	document_check(d, taxonomy_of(&d->scene, &t));
	document_check(d, parameters_of(&d->scene, &t, &r));
	document_check(d, error_bounds(&d->scene, bound));
	depth_steps(&d->scene, t.reversed, step);
	put_taxonomy(p, &t);
	put_planes(p, &t, &r);
	put_depth_steps(p, step);
	put_bounds(p, bound, tolerance);
	put_name_on_new_line(p, "scene");
	if (r.has_scene)
		put_scene(p, &r.scene);
	else
		put_number(p, (double)NAN);
}

void run_inspect(const struct command *c, const struct options *o)
{
	static char text[160 * NUMBER_MAX + 4096];
	struct printer p = { .at = text,
		.style = one_style(o, "what inspect prints"),
		.on_line = o->out == FORMAT_JSON,
		.compact = o->out == FORMAT_JSON,
		.between = "" };
	struct document d;

	read_document(c, o, &d);
	if (d.flat && o->tolerance > 0)
		document_refuse(&d,
		    "/projection: missing; -t is about its error bounds, of "
		    "which a window has none");
	put_open(&p, "{");
	if (d.flat)
		put_plane(&p, &d);
	else
		put_spatial(&p, &d, o->tolerance > 0 ? o->tolerance : 0.5);
	put_text(&p, p.on_line ? "}\n" : "\n}\n");
	put_all(text, (size_t)(p.at - text));
}
