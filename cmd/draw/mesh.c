/* SPDX-License-Identifier: MIT */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>

#include "../message/grow.h"
#include "triangulate.h"

/* Mixes the bits of a key (the finalizer of MurmurHash3, by Austin Appleby). */
static uint64_t mix(uint64_t h)
{
	h = (h ^ h >> 33) * 0xff51afd7ed558ccd;
	h = (h ^ h >> 33) * 0xc4ceb9fe1a85ec53;
	return h ^ h >> 33;
}

static uint64_t point_hash(const double at[3])
{
	uint64_t bits[3];

	memcpy(bits, at, sizeof bits);
	return mix(bits[0] + mix(bits[1] + mix(bits[2])));
}

static uint64_t ends_hash(const unsigned end[2])
{
	const unsigned low = end[0] < end[1] ? end[0] : end[1];

	return mix((uint64_t)low << 32 | (end[0] ^ end[1] ^ low));
}

static uint64_t hash_of(const struct mesh *m, const struct index_table *t, size_t i)
{
	return t == &m->by_point ? point_hash(m->point[i]) :
				   ends_hash(m->segment[i].end);
}

/* Doubles the room of a table that is half full, and finds new places. */
static void table_grow(const struct mesh *m, struct index_table *t)
{
	if (2 * t->n < t->room)
		return;
	t->room = t->room > 0 ? 2 * t->room : 1024;
	free(t->place);
	t->place = memset(xrealloc(NULL, t->room * sizeof *t->place), 0,
	    t->room * sizeof *t->place);
	for (size_t i = 0; i < t->n; i++) {
		size_t at = hash_of(m, t, i) & (t->room - 1);

		while (t->place[at] != 0)
			at = (at + 1) & (t->room - 1);
		t->place[at] = (unsigned)i + 1;
	}
}

unsigned mesh_vertex(struct mesh *m, const double given[3])
{
	/* + 0 makes 0 of -0 */
	const double at[3] = { given[0] + 0, given[1] + 0, given[2] + 0 };
	struct index_table *t = &m->by_point;

	table_grow(m, t);
	size_t place = point_hash(at) & (t->room - 1);

	for (; t->place[place] != 0; place = (place + 1) & (t->room - 1))
		if (memcmp(m->point[t->place[place] - 1], at, sizeof at) == 0)
			return t->place[place] - 1;
	if (m->points == UINT32_MAX - 1)
		die(EXIT_INPUT, "draw: more than 4294967294 points", NULL);
	GROW(m->point, m->points, 1);
	memcpy(m->point[m->points++], at, sizeof at);
	t->place[place] = (unsigned)m->points;
	t->n++;
	return (unsigned)m->points - 1;
}

void mesh_add_dot(struct mesh *m, unsigned vertex, const char *name, unsigned n)
{
	GROW(m->dot, m->dots, 1);
	m->dot[m->dots++] = (struct mesh_dot){ vertex, n, m->name_bytes };
	if (n == 0)
		return;
	GROW(m->names, m->name_bytes, n);
	memcpy(m->names + m->name_bytes, name, n);
	m->name_bytes += n;
}

void mesh_add_segment(struct mesh *m, unsigned from, unsigned to, enum stroke stroke)
{
	const unsigned end[2] = { from, to };
	struct index_table *t = &m->by_ends;

	if (from == to)
		return;
	table_grow(m, t);
	size_t place = ends_hash(end) & (t->room - 1);

	for (; t->place[place] != 0; place = (place + 1) & (t->room - 1)) {
		struct mesh_segment *s = &m->segment[t->place[place] - 1];

		if ((s->end[0] == from && s->end[1] == to) ||
		    (s->end[0] == to && s->end[1] == from)) {
			s->stroke = s->stroke == STROKE_LINE ? STROKE_LINE : stroke;
			return;
		}
	}
	GROW(m->segment, m->segments, 1);
	m->segment[m->segments++] = (struct mesh_segment){ { from, to }, stroke };
	t->place[place] = (unsigned)m->segments;
	t->n++;
}

void mesh_add_face(struct mesh *m, const unsigned *corner, size_t n)
{
	for (size_t i = 0; i < n; i++)
		mesh_add_segment(m, corner[i], corner[i + 1 < n ? i + 1 : 0],
		    STROKE_EDGE);
	GROW(m->triangle, m->triangles, n - 2);
	m->triangles += triangulate((const double(*)[3])m->point, corner, n,
	    m->triangle + m->triangles);
}

void mesh_add_ring(struct mesh *m, const unsigned *vertex, size_t n)
{
	GROW(m->ring, m->ring_size, n + 1);
	m->ring[m->ring_size] = (unsigned)n;
	memcpy(m->ring + m->ring_size + 1, vertex, n * sizeof *vertex);
	m->ring_size += n + 1;
}

void mesh_free(struct mesh *m)
{
	free(m->point);
	free(m->dot);
	free(m->segment);
	free(m->triangle);
	free(m->ring);
	free(m->names);
	free(m->by_point.place);
	free(m->by_ends.place);
	*m = (struct mesh){ 0 };
}
