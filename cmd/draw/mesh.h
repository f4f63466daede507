/* SPDX-License-Identifier: MIT */
/* What is drawn, in the space of its points: vertices, and dots, segments and triangles
 * between them. Points of the same coordinates are one vertex, so that neighbours know
 * that they meet. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Kinds of segments, in the order in which they are drawn. An edge of a face that is
 * also a line of its own is a line. In a picture a dot is a segment between one point
 * and itself. */
enum stroke { STROKE_EDGE, STROKE_LINE, STROKE_DOT, STROKES };

struct mesh_dot {
	unsigned vertex, name_size;
	size_t
	    name; /* what stands beside it: name_size bytes from here on in `names` */
};

struct mesh_segment {
	unsigned end[2];
	enum stroke stroke;
};

struct mesh_triangle {
	unsigned corner[3];
};

/* A table of the places of elements in an array, found by what the elements are. */
struct index_table {
	unsigned *place; /* of an element, plus 1; 0: free */
	size_t room, n;  /* room is a power of two */
};

struct mesh {
	double (*point)[3];
	struct mesh_dot *dot;
	struct mesh_segment *segment;
	struct mesh_triangle *triangle;
	unsigned *ring; /* of each closed run: how many vertices, and these */
	char *names;
	size_t points, dots, segments, triangles, ring_size, name_bytes;
	struct index_table by_point, by_ends;
};

/* Returns the index of the vertex at a point, which is added if it is new. */
unsigned mesh_vertex(struct mesh *, const double at[3]);

/* Adds a dot, with a name of n bytes. */
void mesh_add_dot(struct mesh *, unsigned vertex, const char *name, unsigned n);

/* Adds a segment, once, unless its ends are one vertex. */
void mesh_add_segment(struct mesh *, unsigned from, unsigned to, enum stroke);

/* Adds the edges and triangles of a face of n corners, n > 2, which may be concave. */
void mesh_add_face(struct mesh *, const unsigned *corner, size_t n);

/* Notes that the segments between n vertices are the sides of a polygon. */
void mesh_add_ring(struct mesh *, const unsigned *vertex, size_t n);

void mesh_free(struct mesh *);
