/* JSON documents to scenes. What is wrong is printed in one line, with its
 * place, and ends in exit status 1. */
#ifndef DOCUMENT_H
#define DOCUMENT_H

#include <stddef.h>

#include "../../core/fit_bounds.h"

/* A member of a scene, as a bit, to say what a command uses. */
enum scene_member {
	SCENE_CONVENTION = 1,
	SCENE_WORLD = 2,
	SCENE_CAMERA = 4,
	SCENE_PROJECTION = 8,
	SCENE_VIEWPORT = 16,
	SCENE_WINDOW = 32,
	SCENE_DEVICE = 64,
	SCENE_POINTS = 128,
	SCENE_BOUNDS = 256,
	SCENE_PICK = 512,
	/* what leads from model space to the device */
	SCENE_SPATIAL = SCENE_WORLD | SCENE_CAMERA | SCENE_PROJECTION |
	    SCENE_VIEWPORT,
};

/* Where on the device, and how far around: 0 where that isn't said. */
struct pick {
	bool has_at;
	double at[2], radius;
};

struct document {
	struct scene scene;
	struct pick pick;
	/* for fit: whether there are bounds, and the camera's eye is given */
	bool has_bounds, has_eye;
	struct bounds bounds;
	const char *name; /* for messages: the file, "-" or "PARAMS" */
	/* The member as which an object with none of a scene's members was
	 * read, or NULL. Messages leave it out of their pointers. */
	const char *bare;
	/* The member points as document_points gives it, or NULL. */
	char *points;
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
	/* The type that a projection has without a member "type", and may have
	 * alone; PROJECTION_NONE where it must say its type. */
	int projection;
	/* What fit finds need not be there: the camera's eye, near, far, and
	 * the sizes of a parallel projection. */
	bool fit;
	/* Read instead of the document's, if not NULL. */
	const struct convention *convention;
	/* Of each point; 0 where the command reads none of the document. */
	int coordinates;
};

/* Reads text[0..size), which it may change, into *d. */
void document_read(struct document *d, const char *name, char *text,
    size_t size, const struct document_wants *wants);

/* One point or a list of points, as lines: one JSON array a line, each with
 * as many numbers or nulls as coordinates says before anything else; the
 * text of each element is as it was. To be freed. */
void document_points(const char *name, char *text, size_t size, int coordinates,
    char **points, size_t *points_size);

/* Prints "projcalc: FILE: /pointer: reason" for a refusal of core/, whose
 * reason begins with its pointer, and exits with 1. */
_Noreturn void document_refuse(const struct document *d, const char *why);

/* The same where why is not NULL. */
void document_check(const struct document *d, const char *why);

#endif
