/* SPDX-License-Identifier: MIT */
/* The command draw: reads geometry, clips it to a picture, and prints that. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../../core/derive/clip.h"
#include "../../core/points/points.h"
#include "../call/input.h"
#include "../call/notes.h"
#include "../call/operands.h"
#include "../call/option_row.h"
#include "../stream/runs.h"
#include "braille.h"
#include "hidden.h"
#include "obj.h"
#include "svg.h"

/* A document's drawing. `position` and `outside` belong to the vertices of the mesh. */
struct drawing {
	bool lines, flat;
	enum space from, to;
	struct mesh mesh;
	double (*position)[3]; /* in the picture, with z the distance */
	double (*view)[3];     /* in view space */
	unsigned char *outside;
	struct frame frame;
	struct picture picture;
	struct clipper clipper;
	struct clip_vertex end[2], cut[2];
	struct clip_ring ring;
	struct run_reader reader;
};

static void set_background(const char *name)
{
	struct refusal r;

	if (!input_check(name))
		die(EXIT_USAGE, text("--background: there is no file %s", name), NULL);
	struct input_text t = input_of_file(name);

	if (!svg_set_background((struct span){ t.s, t.s + t.size }, &r))
		die_at(EXIT_INPUT, &(struct place){ .file = name }, r.what, r.remedy);
	input_free(&t);
}

static void check_draw(const struct options *o)
{
	if (o->has_from && o->from > SPACE_VIEW)
		die(EXIT_USAGE, "draw: --from is model, world or view", NULL);
	if (o->background != NULL && o->text)
		die(EXIT_USAGE, "draw: --text excludes --background",
		    "a picture is behind an SVG alone");
	if (o->background != NULL)
		set_background(o->background);
}

/* Adds a point of a run, and returns its vertex. */
static unsigned add_point(struct drawing *w, const struct run *run, size_t i)
{
	const struct run_point *p = &run->point[i];
	const double at[3] = { p->in[0], p->in[1], w->flat ? 0 : p->in[2] };
	const unsigned vertex = mesh_vertex(&w->mesh, at);
	unsigned size = p->name_size;
	const char *name = size > 0 ? run->names + p->name : "";

	if (size > 1 && *name == '"' &&
	    memchr(name + 1, '"', size - 1) == name + size - 1) {
		name++;
		size -= 2;
	}
	if (!w->lines || run->n == 1 || size > 0)
		mesh_add_dot(&w->mesh, vertex, name, size);
	return vertex;
}

static void take_run(void *data, const struct run *run)
{
	struct drawing *w = data;
	unsigned *vertex = xrealloc(NULL, run->n * sizeof *vertex);

	for (size_t i = 0; i < run->n; i++) {
		vertex[i] = add_point(w, run, i);
		if (w->lines && i > 0)
			mesh_add_segment(&w->mesh, vertex[i - 1], vertex[i],
			    STROKE_LINE);
	}
	if (w->lines && run->n > 3 && vertex[0] == vertex[run->n - 1])
		mesh_add_ring(&w->mesh, vertex, run->n - 1);
	free(vertex);
}

static bool take_obj(const struct job *j, struct span text, struct refusal *r)
{
	struct drawing *w = ((const struct run_reader *)j->data)->data;

	return obj_read(text, w->flat, &w->mesh, r);
}

/* Makes a position of an image on the device, whose z may be a distance. */
static void place_image(const struct drawing *w, const double image[3], double at[3])
{
	const struct frame *f = &w->frame;
	const double size = frame_size(f);

	at[0] = (image[0] - f->x) / size;
	at[1] = (f->from_bottom ? f->y + f->height - image[1] : image[1] - f->y) / size;
	at[2] = w->flat ? 0 : image[2];
}

/* Finds the positions of all vertices and the planes that they are outside of; if
 * `view` is not NULL, also where they are in view space. */
static void map_vertices(struct drawing *w, const struct job *j,
    const struct transform *view)
{
	static COLUMN_ALIGNED double in[3][POINTS_BLOCK], out[4][POINTS_BLOCK];
	const double *const from[4] = { in[0], in[1], in[2] };
	double *const to[4] = { out[0], out[1], out[2], out[3] };
	const struct mesh *m = &w->mesh;

	w->position = xrealloc(NULL, (m->points + 1) * sizeof *w->position);
	w->outside = xrealloc(NULL, m->points + 1);
	if (view != NULL)
		w->view = xrealloc(NULL, (m->points + 1) * sizeof *w->view);
	for (size_t i = 0; i < m->points; i += POINTS_BLOCK) {
		const size_t left = m->points - i;
		const size_t n = left < POINTS_BLOCK ? left : POINTS_BLOCK;

		for (size_t k = 0; k < 3 * n; k++)
			in[k % 3][k / 3] = m->point[i + k / 3][k % 3];
		points_map(&j->transform, PRECISION_EXACT, from, to, n);
		frustum_outside_all(&j->frustum, from, w->outside + i, n);
		for (size_t k = 0; k < n; k++)
			place_image(w, (double[]){ out[0][k], out[1][k], out[2][k] },
			    w->position[i + k]);
		if (view == NULL)
			continue;
		points_map(view, PRECISION_EXACT, from, to, n);
		for (size_t k = 0; k < 3 * n; k++)
			w->view[i + k / 3][k % 3] = out[k % 3][k / 3];
	}
}

/* Writes the position of a vertex that a cut has made. Returns false if it has none, as
 * the eye. */
static bool place_cut(struct drawing *w, struct clip_vertex *v, double at[3])
{
	double image[4] = { 0 };

	clip_image(&w->clipper, v, false, image);
	place_image(w, image, at);
	return isfinite(at[0]) && isfinite(at[1]) && isfinite(at[2]);
}

/* Adds a segment between its vertices, as far as it is in the view volume. */
static void add_segment(struct drawing *w, struct segment s)
{
	unsigned outside[2];

	for (int i = 0; i < 2; i++) {
		outside[i] = w->outside[s.vertex[i]];
		memcpy(s.end[i], w->position[s.vertex[i]], sizeof s.end[i]);
	}
	if ((outside[0] & outside[1]) != 0)
		return;
	if ((outside[0] | outside[1]) != 0) {
		for (int i = 0; i < 2; i++)
			clip_vertex_set(&w->end[i], &w->clipper,
			    w->mesh.point[s.vertex[i]], s.vertex[i], outside[i]);
		if (!clip_segment(&w->clipper, &w->end[0], &w->end[1], w->cut))
			return;
		for (int i = 0; i < 2; i++)
			if (w->cut[i].cut && !place_cut(w, &w->cut[i], s.end[i]))
				return;
	}
	picture_add_segment(&w->picture, &s);
}

/* A polygon that is being cut. */
struct cut_polygon {
	struct drawing *drawing;
	enum stroke stroke;
	size_t first;               /* of its corners in the picture */
	unsigned first_on, last_on; /* the planes that they are on */
};

/* Adds the side of a polygon where a plane has cut it. */
static void add_cut_side(const struct cut_polygon *c, const double from[3],
    const double to[3])
{
	struct segment s = { .vertex = { NO_VERTEX, NO_VERTEX }, .stroke = c->stroke };

	memcpy(s.end[0], from, sizeof s.end[0]);
	memcpy(s.end[1], to, sizeof s.end[1]);
	picture_add_segment(&c->drawing->picture, &s);
}

/* Takes a corner of what is left of a polygon. */
static void take_corner(void *data, struct clip_vertex *v)
{
	struct cut_polygon *c = data;
	struct drawing *w = c->drawing;
	struct picture *p = &w->picture;
	double at[3];

	if (!v->cut)
		memcpy(at, w->position[v->index], sizeof at);
	else if (!place_cut(w, v, at))
		return;
	const unsigned on = v->cut ? v->on : 0;

	if (p->corners == c->first)
		c->first_on = on;
	else if ((c->last_on & on) != 0)
		add_cut_side(c, p->corner[p->corners - 1], at);
	picture_add_corner(p, at);
	c->last_on = on;
}

/* Adds the corners of what is left of a polygon, and the sides where it is cut. Returns
 * whether there is a part of it. */
static bool add_polygon(struct drawing *w, const unsigned *vertex, size_t n,
    enum stroke stroke)
{
	struct picture *p = &w->picture;
	struct cut_polygon c = { w, stroke, p->corners, 0, 0 };
	unsigned some = 0, all = ~0u;

	for (size_t i = 0; i < n; i++) {
		some |= w->outside[vertex[i]];
		all &= w->outside[vertex[i]];
	}
	if (all != 0)
		return false;
	for (size_t i = 0; i < n && some == 0; i++)
		picture_add_corner(p, w->position[vertex[i]]);
	if (some == 0)
		return true;
	clip_ring_begin(&w->ring, &w->clipper, take_corner, &c);
	for (size_t i = 0; i < n; i++)
		clip_ring_add(&w->ring, w->mesh.point[vertex[i]], vertex[i],
		    w->outside[vertex[i]]);
	clip_ring_end(&w->ring);
	if (p->corners > c.first + 1 && (c.first_on & c.last_on) != 0)
		add_cut_side(&c, p->corner[p->corners - 1], p->corner[c.first]);
	return p->corners > c.first + 2;
}

/* Writes the normal of a triangle in view space, up to its length. */
static void view_normal(const struct drawing *w, const unsigned corner[3], double n[3])
{
	const double *a, *b, *c;

	n[0] = n[1] = n[2] = 0;
	if (w->view == NULL)
		return;
	a = w->view[corner[0]];
	b = w->view[corner[1]];
	c = w->view[corner[2]];
	for (int k = 0; k < 3; k++) {
		const int i = (k + 1) % 3, j = (k + 2) % 3;

		n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
	}
}

static void add_triangle(struct drawing *w, const struct mesh_triangle *t)
{
	const size_t first = w->picture.corners;
	double normal[3];

	if (add_polygon(w, t->corner, 3, STROKE_EDGE)) {
		view_normal(w, t->corner, normal);
		picture_add_face(&w->picture, first, t->corner, normal);
	} else {
		w->picture.corners = first;
	}
}

/* Makes the picture of the mesh. */
static void clip_mesh(struct drawing *w, const struct document *d)
{
	const struct mesh *m = &w->mesh;
	const struct convention *c = &d->scene.convention;
	const double ahead = convention_looks_back(c) ? -1 : 1;
	const double gaze[3] = { 0, 0, ahead };
	/* from the upper left, and from the eye's side; its length is 1 */
	const double lamp[3] = { -0.48, c->view_y_down ? -0.64 : 0.64, -0.6 * ahead };
	struct picture *p = &w->picture;

	for (size_t i = 0; i < m->triangles; i++)
		add_triangle(w, &m->triangle[i]);
	for (size_t i = 0; i < m->ring_size; i += m->ring[i] + 1) {
		const size_t corners = p->corners;

		/* the sides are segments, but for those that cuts make */
		add_polygon(w, &m->ring[i + 1], m->ring[i], STROKE_LINE);
		p->corners = corners;
	}
	for (size_t i = 0; i < m->segments; i++) {
		const struct mesh_segment *s = &m->segment[i];

		if (w->view == NULL || s->stroke == STROKE_LINE)
			add_segment(w,
			    (struct segment){ .vertex = { s->end[0], s->end[1] },
				.stroke = s->stroke });
	}
	for (size_t i = 0; i < m->dots; i++) {
		const struct mesh_dot *dot = &m->dot[i];
		const char *name = m->names + dot->name;
		struct segment s = { .vertex = { dot->vertex, dot->vertex },
			.stroke = STROKE_DOT };

		if (dot->name_size > 0)
			s.name = (struct span){ name, name + dot->name_size };
		add_segment(w, s);
	}
	picture_complete(p, lamp, gaze);
}

/* Returns whether a volume's far plane is nearer to the eye than its near plane. */
static bool looks_to_eye(const struct projection *p, const struct distance *d)
{
	return projection_family(p) == FAMILY_VOLUME && !d->parallel &&
	    sum_sign(d->column[2]) * (p->volume.z_far > p->volume.z_near ? 1 : -1) < 0;
}

static struct frame frame_of(const struct scene *s, bool flat)
{
	if (flat)
		return (struct frame){ s->device.x, s->device.y, s->device.width,
			s->device.height, !s->device.top_left };
	return (struct frame){ s->viewport.x, s->viewport.y, s->viewport.width,
		s->viewport.height, s->convention.origin_bottom_left };
}

/* Sets what the scene alone decides. Returns false if it is refused. */
static bool prepare(struct drawing *w, struct document *d, struct job *j,
    struct transform *view)
{
	struct scene *s = &d->scene;
	struct refusals *const faults = d->source.faults;
	struct picture *p = &w->picture;
	struct distance distance = { .parallel = true };

	/* the picture is the same in each convention, and needs true distances */
	s->answer = NULL;
	s->viewport.distance = !w->flat;
	w->frame = frame_of(s, w->flat);
	if (!w->flat &&
	    (!distance_of(s, &distance, faults) ||
		!transform_of_scene(s, w->from, SPACE_VIEW, false, view, faults)))
		return false;
	p->width = w->frame.width / frame_size(&w->frame);
	p->height = w->frame.height / frame_size(&w->frame);
	p->parallel = distance.parallel;
	p->reverse = !w->flat && looks_to_eye(&s->projection, &distance);
	return distance_transform(s, w->from, w->to, &j->transform, faults) &&
	    frustum_of(s, w->from, false, &j->frustum, faults) &&
	    clipper_of(s, w->from, w->to, &j->transform, &j->frustum, &w->clipper,
		faults);
}

static bool refuse_what_cannot_be(const struct options *o, struct document *d)
{
	if (!d->flat)
		return true;
	if (!d->scene.has_device || !d->scene.has_window)
		return document_refuse(d, d->scene.has_device ? "/window" : "/device",
		    "missing",
		    "a picture of two dimensions needs \"window\" and \"device\"");
	d->is_usage = o->has_from;
	return !o->has_from ||
	    document_refuse(d, NULL, "--from is for scenes of three dimensions",
		"leave it out");
}

/* Notes that there is nothing to see, but points. */
static void note_empty(const struct drawing *w, const struct document *d)
{
	const struct picture *p = &w->picture;

	if (!message_state.quiet && w->mesh.points > 0 && p->segments + p->faces == 0)
		document_note(d, "", "nothing is in the picture",
		    "'trace' says which planes points are outside of");
}

static void print_picture(struct drawing *w, bool text)
{
	static bool printed;

	if (text) {
		if (printed)
			output_write("\n", 1);
		printed = true;
		braille_print(&w->picture, braille_columns());
	} else {
		hidden_remove(&w->picture);
		svg_add(&w->picture, &w->frame);
	}
}

static void judge_draw(const struct options *o, const struct document *d)
{
	scene_check(&d->scene, d->flat ? FLAT_WINDOW : o->from,
	    d->flat ? FLAT_DEVICE : SPACE_DEVICE, d->source.faults);
}

static bool run_draw(const struct options *o, struct document *d, struct job *j)
{
	static struct drawing w;
	static struct transform view;
	const bool text = o->text || isatty(STDOUT_FILENO);

	w.lines = o->lines;
	w.flat = d->flat;
	w.from = w.flat ? FLAT_WINDOW : o->from;
	w.to = w.flat ? FLAT_DEVICE : SPACE_DEVICE;
	w.reader.names = o->names;
	w.reader.take = take_run;
	w.reader.data = &w;
	if (!refuse_what_cannot_be(o, d) || !prepare(&w, d, j, &view))
		return false;
	runs_prepare(&w.reader, j);
	j->take_obj = take_obj;
	j->layout.from = w.flat ? NULL : space_names[w.from];
	if (!w.flat)
		notes_say_of_spaces(d, w.from, w.to);
	bool good = operands_run_job(o, d, w.from, w.to, j);

	if (good) {
		map_vertices(&w, j, text && !w.flat ? &view : NULL);
		clip_mesh(&w, d);
		good = !ex_has_overflowed() ||
		    document_refuse(d, NULL, SCENE_TOO_WIDE, SCENE_TOO_WIDE_REMEDY);
	}
	if (good) {
		note_empty(&w, d);
		print_picture(&w, text);
	}
	picture_free(&w.picture);
	mesh_free(&w.mesh);
	free(w.position);
	free(w.view);
	free(w.outside);
	w.position = w.view = NULL;
	w.outside = NULL;
	return good;
}

static void finish_draw(void)
{
	svg_print();
}

const struct work draw_work = { run_draw, judge_draw, check_draw, finish_draw };
