/* SPDX-License-Identifier: MIT */
/* Other people's libraries, and loops without one, each used as by a user who cares for
 * speed: one composed matrix, then a product and a division for each point, with points
 * in the layout in which the library is fastest. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A camera, a perspective and a viewport in Direct3D's convention: z into the
 * screen, depth from 0 to 1, y down. */
struct view {
	double eye[3], at[3], up[3];
	double fovy;      /* degrees */
	double near, far; /* far may be infinite */
	double width, height;
	/* The matrix from world to device for column vectors, in the nearest
	 * doubles, for libraries without functions for cameras. */
	double matrix[4][4];
	/* What the matrix leaves, and what that leaves: for types that are wider than
	 * double, all three are summed. */
	double matrix_rest[2][4][4];
};

/* How a block of points lies in memory: coordinate k of point i is number
 * point * i + coordinate * k. */
struct layout {
	size_t point, coordinate;
};

enum { PEER_BLOCK = 1024 };

#define TRIPLES 3, 1
#define QUADS 4, 1 /* the fourth is 1 */
#define COLUMNS 1, PEER_BLOCK

struct peer {
	const char *name, *version;
	bool single; /* points are of floats, not of doubles */
	struct layout layout;
	void (*prepare)(const struct view *);
	/* Transforms n <= PEER_BLOCK points; both arrays are aligned to 64 bytes. */
	void (*carry)(const void *in, void *out, size_t n);
	/* Transforms n points as they lie in a file, in place; NULL: no such loop. */
	void (*in_place)(void *points, size_t n);
};

/* The peers of each library, none if it is not installed; a name NULL ends them. */
extern const struct peer peers_plain[], peers_glm[], peers_cglm[], peers_eigen[],
    peers_wide[];

/* Runs a whole program around a peer, from standard input to standard output. filter is
 * stdio, standard, hand or binary. Returns false if the program failed. */
bool peer_filter(const struct peer *, const char *filter);

#ifdef __cplusplus
}
#endif
