/* SPDX-License-Identifier: MIT */
/* Reads what can be drawn of a Wavefront OBJ file: v, p, l and f. */
#pragma once

#include "../../core/refusal/refusal.h"
#include "../message/utf8.h"
#include "mesh.h"

/* The shapes of a file: dots, segments or a face between points. */
struct obj_shape {
	char letter;     /* p, l or f */
	size_t first, n; /* of its indices */
};

struct obj {
	double (*point)[3]; /* z is 0 in lines of two numbers */
	unsigned *index;
	struct obj_shape *shape;
	size_t points, indices, shapes, point_room, index_room, shape_room;
	long long flat_line; /* the first line of a point of two numbers; 0: none */
};

/* Reads a text. Returns false, and what is wrong in which line, if it is refused. */
bool obj_read(struct span file, struct obj *, struct refusal *);

/* Adds what the file has to a mesh. */
void obj_add(const struct obj *, struct mesh *);

void obj_free(struct obj *);
