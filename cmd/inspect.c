/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "../core/derive/box.h"
#include "../core/derive/picture.h"
#include "../core/derive/textbook.h"
#include "json/print.h"
#include "table/emit.h"
#include "call/notes.h"
#include "call/options.h"
#include "call/option_row.h"
#include "message/message.h"

static const char *const taxon_names[] = {
	[TAXON_ORTHOGRAPHIC] = "orthographic",
	[TAXON_OBLIQUE] = "oblique",
	[TAXON_PERSPECTIVE] = "perspective",
	[TAXON_REVERSE] = "reverse perspective",
};
static const char *const kind_names[] = {
	[TAXON_MULTIVIEW] = "multiview",
	[TAXON_ISOMETRIC] = "isometric",
	[TAXON_DIMETRIC] = "dimetric",
	[TAXON_TRIMETRIC] = "trimetric",
	[TAXON_CAVALIER] = "cavalier",
	[TAXON_CABINET] = "cabinet",
	[TAXON_GENERAL] = "general",
	[TAXON_ONE_POINT] = "one-point",
	[TAXON_TWO_POINT] = "two-point",
	[TAXON_THREE_POINT] = "three-point",
};
static const char *const buffer_names[] = {
	[DEPTH_UNORM16] = "unorm16",
	[DEPTH_UNORM24] = "unorm24",
	[DEPTH_FLOAT32] = "float32",
};

/* Puts a member's name, and null if it does not exist. Returns whether it does. */
static bool put_existing(struct printer *p, const char *name, bool exists)
{
	put_name(p, name);
	if (!exists)
		put_literal(p, "null");
	return exists;
}

/* Puts a member: an array of rows of n numbers each, or null if is_null is true. */
static void put_known_rows(struct printer *p, const char *name, const double *v,
    int rows, int n, bool is_null)
{
	if (put_existing(p, name, !is_null))
		put_rows(p, v, rows, n);
}

static const char *const sides[] = { "left", "right", "bottom", "top", "near", "far" };

/* Puts an object with members names[0..count): numbers or, if n > 0, arrays of n. */
static void put_object(struct printer *p, const char *name, const char *const *names,
    int count, const double *v, int n)
{
	put_open(put_name(p, name), "{");
	for (int k = 0; k < count; k++)
		put_numbers(put_name(p, names[k]), v + k * (n > 0 ? n : 1), n);
	put_close(p, "}");
}

static void put_camera(struct printer *p, const struct rigid *r)
{
	if (!put_existing(p, "camera", r->exists))
		return;
	put_open(p, "{");
	put_numbers(put_name(p, "eye"), r->eye, 3);
	put_numbers(put_name(p, "orientation"), r->orientation, 4);
	put_numbers(put_name(p, "rvec"), r->rvec, 3);
	put_numbers(put_name(p, "translation"), r->translation, 3);
	put_rows(put_name(p, "rotation"), r->rotation[0], 3, 3);
	put_close(p, "}");
}

static void put_picture(struct printer *p, const struct picture *r)
{
	const struct taxonomy *t = &r->taxonomy;
	const bool no_near = projection_is_open(&r->scene.projection);

	put_string(put_name(p, "projection"), taxon_names[t->taxon]);
	put_string(put_name(p, "kind"), kind_names[t->kind]);
	put_numbers(put_name(p, "foreshortening"), t->foreshortening, 3);
	put_known_rows(p, "vanishing_points", t->vanishing_point[0], 3, 2,
	    t->taxon == TAXON_ORTHOGRAPHIC || t->taxon == TAXON_OBLIQUE);
	put_number(put_name(p, "fovx"), t->fov[0]);
	put_number(put_name(p, "fovy"), t->fov[1]);
	put_numbers(put_name(p, "eye"), t->eye, 3);
	put_numbers(put_name(p, "gaze"), t->gaze, 3);
	put_numbers(put_name(p, "up"), r->up, 3);
	put_camera(p, &r->rigid);
	put_distance(put_name(p, "near"), r->near);
	put_distance(put_name(p, "far"), r->far);
	put_number(put_name(p, "aspect"), r->aspect);
	put_name(p, "reverse_z");
	put_literal(p, no_near ? "null" : r->reverse_z ? "true" : "false");
	put_object(p, "planes", sides, 4, r->near_edge, 0);
	put_rows(put_name(p, "frustum"), t->corner[0], 8, 3);
	put_object(p, "frustum_planes", sides, 6, r->frustum_plane[0], 4);
	put_known_rows(p, "intrinsics", r->intrinsics[0], 3, 3,
	    isnan(r->intrinsics[0][0]));
}

/* Refuses a distance of --distances that is not between near and far. */
static bool check_distances(const struct document *d, const struct options *o,
    const struct depth *z)
{
	double near = depth_distance(z, false), far = depth_distance(z, true);

	if (isnan(far)) /* the far plane is behind the eye: no limit */
		far = HUGE_VAL;
	for (int i = 0; i < o->distances.n && !z->open; i++) {
		double at = o->distances.v[i];

		if ((at >= near && at <= far) || (at >= far && at <= near))
			continue;
		return document_refuse(d, "/projection",
		    text("--distances: %.16g is not from near, %.16g, to far, %.16g",
			at, near, far),
		    NULL);
	}
	return true;
}

/* Puts the depth steps at the near plane, at the far plane and at o->distances. */
static void put_depth_steps(struct printer *p, const struct options *o,
    const struct depth *z)
{
	if (o->distances.n > 0)
		put_numbers(put_name(p, "distances"), o->distances.v, o->distances.n);
	put_open(put_name(p, "depth_step"), "{");
	for (enum depth_buffer b = 0; b < DEPTH_BUFFERS; b++) {
		put_open(put_name(p, buffer_names[b]), "[");
		put_number(p, depth_step(z, b, false));
		put_number(p, depth_step(z, b, true));
		for (int i = 0; i < o->distances.n; i++)
			put_number(p, depth_step_at(z, b, o->distances.v[i]));
		put_close(p, "]");
	}
	put_close(p, "}");
}

/* Puts the error bounds, the cheapest precision's first, and the name of the cheapest
 * precision whose bound is within tolerance. */
static void put_error_bounds(struct printer *p, const double bound[3], double tolerance)
{
	int precision = PRECISION_SINGLE;

	put_open(put_name(p, "error_bound"), "{");
	for (int i = PRECISION_SINGLE; i >= PRECISION_EXACT; i--)
		put_number(put_name(p, precision_names[i]), bound[i]);
	put_close(p, "}");
	while (precision > PRECISION_EXACT && !(bound[precision] <= tolerance))
		precision--;
	put_string(put_name(p, "precision"), precision_names[precision]);
}

/* Puts the member bounds, if the document has bounds. */
static bool put_bounds(struct printer *p, const struct document *d)
{
	static struct flag_words words;
	static struct box r;
	const struct scene *s = &d->scene;

	if (!d->has_bounds)
		return true;
	if (!box_of(s, &d->bounds, d->flat, &r, d->source.faults))
		return false;
	put_open(put_name(p, "bounds"), "{");
	if (!d->flat)
		put_numbers(put_name(p, "distance"), r.distance, 2);
	const bool device = d->flat ? s->has_device : s->has_viewport;

	if (put_existing(p, device ? "device" : "ndc", !isnan(r.min[0]))) {
		put_open(p, "{");
		put_numbers(put_name(p, "min"), r.min, 2);
		put_numbers(put_name(p, "max"), r.max, 2);
		put_close(p, "}");
	}
	put_string(put_name(p, "flags"),
	    r.behind  ? "behind" :
		r.out ? "out" :
			flags_word(&words, r.outside)->s);
	put_close(p, "}");
	return true;
}

static bool put_window(struct printer *p, const struct document *d)
{
	const struct scene *s = &d->scene;
	struct window_extent w;

	if (!scene_window_extent(s, &w, d->source.faults))
		return false;
	put_object(p, "window", sides, 4, w.edge, 0);
	if (put_existing(p, "device", s->has_device))
		object_print(p, &scene_members[SCENE_ROW_DEVICE], 0, ALL_MEMBERS,
		    &s->device);
	put_numbers(put_name(p, "scale"), w.scale, 2);
	return put_bounds(p, d);
}

/* Returns what a note says, with the numbers of the picture that it is about. */
static const char *note_text(enum note note, const struct picture *r)
{
	const struct note_row *row = &note_rows[note];

	if (row->remedy == NULL)
		return row->what;
	if (note == NOTE_RESIDUAL)
		return text(
		    "%s of up to %.2g of a clip coordinate's greatest number; %s",
		    row->what, r->residual, row->remedy);
	if (note == NOTE_FAR_RANGE)
		return text("%s from %.5g to %s; %s", row->what, r->far_range[0],
		    isinf(r->far_range[1]) ? "infinity" : text("%.5g", r->far_range[1]),
		    row->remedy);
	return text("%s; %s", row->what, row->remedy);
}

static void put_notes(struct printer *p, unsigned notes, const struct picture *r,
    bool needs_planes)
{
	put_open(put_name(p, "notes"), "[");
	for (unsigned i = 0; i < NOTES; i++)
		if (notes >> i & 1)
			put_string(p, note_text(i, r));
	if (needs_planes)
		put_string(p,
		    "depth_step and textbook_error need \"near\" and \"far\"");
	put_close(p, "]");
}

/* Puts what inspect prints of a document with a projection. */
static bool put_projection(struct printer *p, const struct document *d,
    const struct options *o)
{
	static const char *const types[] = { "float", "double" };
	static struct picture r;
	double error[2];

	if (!picture_of(&d->scene, &r, d->source.faults) ||
	    !check_distances(d, o, &r.depth))
		return false;
	put_picture(p, &r);
	put_depth_steps(p, o, &r.depth);
	put_error_bounds(p, r.error_bound, o->tolerance.n > 0 ? *o->tolerance.v : 0.5);
	if (o->textbook) {
		if (!textbook_errors(&d->scene, error, d->source.faults))
			return false;
		put_object(p, "textbook_error", types, 2, error, 0);
	}
	if (!put_bounds(p, d))
		return false;
	if (put_existing(p, "scene", r.has_scene))
		put_scene(p, &r.scene);
	put_notes(p,
	    notes_of_document(d, r.notes) |
		(o->quiet ? 0 : notes_of_spaces(d, SPACE_MODEL, SPACE_DEVICE)),
	    &r,
	    (o->textbook || o->distances.n > 0) &&
		projection_is_open(&d->scene.projection));
	return true;
}

static bool run_inspect(const struct options *o, struct document *d, struct job *j)
{
	static char out[(360 + 16 * STEPS_MAX) * NUMBER_MAX + (1 << 14)];
	struct printer p = { .at = out,
		.style = options_matrix_style(o),
		.compact = o->out == FORMAT_JSON };

	(void)j;
	if (d->flat && (o->tolerance.n > 0 || o->distances.n > 0 || o->textbook))
		return document_refuse(d, "/projection", "missing",
		    "-t, --distances and --textbook are about the errors and the depth "
		    "of a projection, not of a window");
	put_open(&p, "{");
	if (!(d->flat ? put_window(&p, d) : put_projection(&p, d, o)))
		return false;
	put_close(&p, "}\n");
	if (ex_has_overflowed())
		return document_refuse(d, NULL, SCENE_TOO_WIDE, SCENE_TOO_WIDE_REMEDY);
	output_write(out, (size_t)(p.at - out));
	return true;
}

static void judge_inspect(const struct options *o, const struct document *d)
{
	struct refusals *const faults = d->source.faults;
	struct hull h;

	(void)o;
	if (d->flat)
		scene_check(&d->scene, FLAT_WINDOW, FLAT_NDC, faults);
	else
		scene_check(&d->scene, SPACE_MODEL, SPACE_DEVICE, faults);
	if (d->has_bounds)
		hull_of(&d->bounds, d->flat ? 2 : 3, &h, faults);
}

const struct work inspect_work = { run_inspect, judge_inspect, NULL, NULL };
