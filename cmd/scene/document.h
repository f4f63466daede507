/* SPDX-License-Identifier: MIT */
/* Reads JSON documents as scenes. An error is a message with its place, and exit
 * status 1. */
#ifndef DOCUMENT_H
#define DOCUMENT_H

#include <stddef.h>

#include "../../core/derive/fit.h"
#include "../json/print.h"
#include "../json/value.h"

/* The members of a scene as bits. */
enum scene_member {
	SCENE_CONVENTION = 1,
	SCENE_ANGLE_UNIT = 2,
	SCENE_WORLD = 4,
	SCENE_CAMERA = 8,
	SCENE_PROJECTION = 16,
	SCENE_VIEWPORT = 32,
	SCENE_WINDOW = 64,
	SCENE_DEVICE = 128,
	SCENE_POINTS = 256,
	SCENE_BOUNDS = 512,
	SCENE_PICK = 1024,
	SCENE_MARGIN = 2048,
	SCENE_ALL = 2 * SCENE_MARGIN - 1,
	/* members that define the maps from model space to the device */
	SCENE_SPATIAL = SCENE_WORLD | SCENE_CAMERA | SCENE_PROJECTION |
	    SCENE_VIEWPORT,
};

/* The circle on the device in which pick finds points; its radius is 0 if not given. */
struct pick {
	double at[2], radius;
	bool has_at;
};

struct document {
	struct scene scene;
	bool flat;            /* has two dimensions: see document_wants.flat */
	enum angle_unit unit; /* of all angles */
	struct pick pick;
	/* bounds, the eye of the camera, and pick are given */
	bool has_bounds, has_eye, has_pick;
	struct bounds bounds;
	struct source source; /* for messages */
	/* The name of the member that is the whole document, or NULL. Pointers in
	 * messages leave the name out. */
	const char *bare;
	/* The member points as the lines that document_points makes, in the text that
	 * was read; or NULL. */
	const char *points;
	size_t points_size;
};

/* What a command needs of a document. */
struct document_wants {
	/* The member that may be the whole document, as lookat's may be a camera; or
	 * 0. */
	enum scene_member bare;
	/* Members that must not be missing, as bits. */
	unsigned needed;
	/* Members that the command uses, as bits. In other members numbers may be out
	 * of range, and a projection may lack its aspect. */
	unsigned used;
	/* A document is flat if it has any of these members, as bits, and no
	 * projection. It has two dimensions, needs no other member, and uses none of
	 * SCENE_SPATIAL; its points have two coordinates. 0: the command takes no flat
	 * documents. */
	unsigned flat;
	/* The only type that a projection may have; its member "type" may be missing.
	 * PROJECTION_NONE: the projection may have any type, and must have "type". */
	int projection;
	/* The command is fit: members that it finds may be missing. They are the eye,
	 * near and far, width and height of a parallel projection, and all members of
	 * the window of a flat document. */
	bool fit;
	/* The convention of the answer, and of a document without one; or NULL. */
	const struct convention *convention;
	/* Lines of the file before the text, and bytes before it on the first line. */
	long line;
	size_t column;
	/* A hint for points of two numbers; or NULL. */
	const char *two;
	/* Coordinates of a point; 0: the command does not read points from the
	 * document. */
	int coordinates;
};

/* Returns as bits the members that a command reads, be the document flat or not. */
unsigned document_reads(const struct document_wants *);

/* Reads text[0..size), which it changes, into *d. name is the file's, for messages. */
void document_read(struct document *d, const char *name, char *text,
    size_t size, const struct document_wants *wants);

/* Reads text[0..size) as a point or a list of points, and returns lines that replace
 * the text. Each line is the JSON array of a point, which begins with coordinates
 * numbers or nulls, as they were written. two is as in struct document_wants. */
char *document_points(const char *name, char *text, size_t size,
    int coordinates, const char *two, size_t *points_size);

/* Prints "projcalc: FILE: WHY" and exits with 1. why is a reason that core/ returned,
 * and may begin with a pointer: "/camera/up: ...". */
_Noreturn void document_refuse(const struct document *d, const char *why);

/* Calls document_refuse if why is not NULL. */
void document_check(const struct document *d, const char *why);

/* Prints a document so that it reads back as the same scene and pick: a line for each
 * member or, if compact, one line. The camera must have a gaze, and the projection not
 * be a matrix, as in documents of fit. A flat document is printed without members of
 * SCENE_SPATIAL. */
void print_scene(const struct document *, bool compact);

/* Prints the convention and the members of SCENE_SPATIAL. */
void put_scene(struct printer *, const struct scene *);

void put_device(struct printer *, const struct device *);

#endif
