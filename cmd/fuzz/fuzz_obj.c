/* SPDX-License-Identifier: MIT */
/* Reads any bytes as an OBJ file, for libFuzzer, and draws it as if its points were of
 * a picture: triangles have corners of their face, and no visible part of a segment is
 * outside of the picture. The functions here replace those of message.c. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../draw/braille.h"
#include "../draw/hidden.h"
#include "../draw/obj.h"
#include "../draw/svg.h"
#include "../message/message.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { COLUMNS = 20 };

static void want(bool so)
{
	if (!so)
		abort();
}

void *xrealloc(void *old, size_t size)
{
	void *s = realloc(old, size);

	want(s != NULL || size == 0);
	return s;
}

void die(int status, const char *what, const char *remedy)
{
	(void)status, (void)what, (void)remedy;
	abort();
}

void output_write(const char *s, size_t size)
{
	want(size == 0 || s[size - 1] == '\n' || s[size - 1] == '"');
}

static void check_mesh(const struct mesh *m)
{
	for (size_t i = 0; i < m->triangles; i++) {
		const unsigned *c = m->triangle[i].corner;

		want(c[0] < m->points && c[1] < m->points && c[2] < m->points);
		want(c[0] != c[1] && c[1] != c[2] && c[2] != c[0]);
	}
	for (size_t i = 0; i < m->segments; i++)
		want(m->segment[i].end[0] != m->segment[i].end[1]);
}

/* Takes x and y as they are, and z for a distance. */
static void place(const struct mesh *m, unsigned vertex, double at[3])
{
	memcpy(at, m->point[vertex], 3 * sizeof *at);
	at[2] = fmax(fabs(at[2]), 1e-150);
}

static bool is_inside(const double at[3])
{
	return at[0] >= 0 && at[0] <= 1 && at[1] >= 0 && at[1] <= 1;
}

static void add_segment(const struct mesh *m, struct picture *p, unsigned from,
    unsigned to, enum stroke stroke)
{
	struct segment s = { .vertex = { from, to }, .stroke = stroke };

	for (int k = 0; k < 2; k++)
		place(m, s.vertex[k], s.end[k]);
	if (is_inside(s.end[0]) && is_inside(s.end[1]))
		picture_add_segment(p, &s);
}

static void make_picture(const struct mesh *m, struct picture *p)
{
	const double axis[3] = { 0, 0, 1 };

	for (size_t i = 0; i < m->triangles; i++) {
		const size_t first = p->corners;
		bool inside = true;

		for (int k = 0; k < 3; k++) {
			double at[3];

			place(m, m->triangle[i].corner[k], at);
			picture_add_corner(p, at);
			inside &= is_inside(at);
		}
		if (inside)
			picture_add_face(p, first, m->triangle[i].corner, axis);
		else
			p->corners = first;
	}
	for (size_t i = 0; i < m->segments; i++)
		add_segment(m, p, m->segment[i].end[0], m->segment[i].end[1],
		    m->segment[i].stroke);
	for (size_t i = 0; i < m->dots; i++)
		add_segment(m, p, m->dot[i].vertex, m->dot[i].vertex, STROKE_DOT);
	picture_complete(p, axis, axis);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	const struct frame frame = { 0, 0, 1, 1, false };
	struct mesh m = { 0 };
	struct refusal r;

	if (obj_read((struct span){ (const char *)data, (const char *)data + size },
		size % 2 == 0, &m, &r)) {
		struct picture p = { .width = 1,
			.height = 1,
			.parallel = m.points % 2 == 0 };

		check_mesh(&m);
		make_picture(&m, &p);
		braille_print(&p, COLUMNS);
		hidden_remove(&p);
		for (size_t i = 0; i < p.segments; i++)
			for (int k = 0; k < 2; k++)
				want(p.segment[i].end[k][0] >= -1e-9 &&
				    p.segment[i].end[k][1] <= 1 + 1e-9);
		svg_add(&p, &frame);
		svg_print();
		picture_free(&p);
	} else {
		want(*r.what != '\0');
	}
	mesh_free(&m);
	return 0;
}
