/* SPDX-License-Identifier: MIT */
/* Reading JSON documents as scenes. What is wrong is refused in one line with
 * its place, and exit status 1. */
#ifndef DOCUMENT_H
#define DOCUMENT_H

#include <stddef.h>

#include "../../core/derive/fit_bounds.h"
#include "../json/print.h"
#include "../json/value.h"

/* The members of a scene, as bits, to say which of them a command uses. */
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
	/* what leads from model space to the device */
	SCENE_SPATIAL = SCENE_WORLD | SCENE_CAMERA | SCENE_PROJECTION |
	    SCENE_VIEWPORT,
};

/* Where on the device to pick, and how far around: 0 if that isn't given. */
struct pick {
	double at[2], radius;
	bool has_at;
};

struct document {
	struct scene scene;
	bool flat;            /* of two dimensions, as its wants have it */
	enum angle_unit unit; /* of all its angles */
	struct pick pick;
	/* for fit: whether bounds are given, and whether the camera's eye is */
	bool has_bounds, has_eye, has_pick;
	struct bounds bounds;
	struct source source; /* for messages */
	/* The member as which an object with none of a scene's members was
	 * read, or NULL. Messages leave it out of their pointers. */
	const char *bare;
	/* The member points as document_points would give it, or NULL. They
	 * stand in the text that was read. */
	const char *points;
	size_t points_size;
};

/* What a command wants of a document. */
struct document_wants {
	/* The member as which an object with none of a scene's members is
	 * read: the camera for lookat, ...; 0 where it stays a scene. */
	enum scene_member bare;
	/* Members that must be there, as bits. */
	unsigned needed;
	/* Members that the command uses, as bits. The others' numbers may be
	 * of any size, and a projection among them may lack its aspect. */
	unsigned used;
	/* Members of which one makes a document without a projection one of two
	 * dimensions: nothing else is needed then, nothing of three dimensions
	 * used, and points and bounds have two coordinates. 0 where the command
	 * doesn't take such documents. */
	unsigned flat;
	/* The type that a projection has without a member "type", and may have
	 * alone; PROJECTION_NONE where it must say its type. */
	int projection;
	/* For fit: what it finds may be missing, that is the camera's eye,
	 * near, far, the sizes of a parallel projection, and of a flat
	 * document's window anything. */
	bool fit;
	/* The convention of the answer, and of a document that has none; or
	 * NULL. */
	const struct convention *convention;
	/* Lines of the file before the text, and bytes before it on its first line. */
	long line;
	size_t column;
	/* What a message says of points of two numbers, beside how many are wanted;
	 * or NULL. */
	const char *two;
	/* How many each point has; 0 if the command doesn't read them from the
	 * document. */
	int coordinates;
};

/* The members of which a command reads any, as bits, those of documents that are flat
 * among them. The unit of angles matters where there are some. */
unsigned document_reads(const struct document_wants *);

/* Reads text[0..size), which it changes, into *d. name is for messages. */
void document_read(struct document *d, const char *name, char *text,
    size_t size, const struct document_wants *wants);

/* Reads text[0..size), which becomes what is left of it, as a point or a list
 * of points. Returns them as lines in the text, a JSON array each, which begins
 * with as many numbers or nulls as coordinates says. The text of each element
 * stays as it is. two is as in struct document_wants. */
char *document_points(const char *name, char *text, size_t size,
    int coordinates, const char *two, size_t *points_size);

/* Prints "projcalc: FILE: WHY" and exits with 1. why is a refusal of core/,
 * which begins with a pointer: "/camera/up: ...". */
_Noreturn void document_refuse(const struct document *d, const char *why);

/* The same where why is not NULL. */
void document_check(const struct document *d, const char *why);

/* Prints a document that reads back as the same scene and pick: a member a line, or
 * on_line all, without what has its default. The camera must be given by its gaze, and
 * the projection must not be a matrix: so fit leaves them. Of a flat document it leaves
 * out what is of three dimensions. */
void print_scene(const struct document *, bool on_line);

/* Puts what leads from model space to the device, in one line. */
void put_scene(struct printer *, const struct scene *);

void put_device(struct printer *, const struct device *);

#endif
