/* SPDX-License-Identifier: MIT */
/* Reads JSON documents as scenes, and prints scenes. A wrong document is refused with a
 * message that says where it is wrong, and exit status 1. */
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
	/* members of a 3D scene, which map model space to the device */
	SCENE_SPATIAL = SCENE_WORLD | SCENE_CAMERA | SCENE_PROJECTION |
	    SCENE_VIEWPORT,
};

/* The circle on the device in which the command pick finds points. */
struct pick {
	double at[2], radius; /* the radius is 0 if it is not given */
	bool has_at;
};

struct document {
	struct scene scene;
	bool flat; /* the scene is 2D: see document_wants.flat_members */
	enum angle_unit unit; /* of all angles */
	struct pick pick;
	/* whether bounds, the camera's eye, and pick are given */
	bool has_bounds, has_eye, has_pick;
	struct bounds bounds;
	struct source source; /* the text, for messages */
	/* The name of the member, such as camera, that is the whole document; or NULL.
	 * Pointers in messages leave the name out. */
	const char *lone_member;
	/* The member points, rewritten in the text of the document as lines like those
	 * of document_points; or NULL. */
	const char *points;
	size_t points_size;
};

/* What a command needs of a document. */
struct document_wants {
	/* The member that may be the whole document, such as the camera for the
	 * command lookat; or 0. */
	enum scene_member lone_member;
	/* The members that a document must have, as bits. */
	unsigned needed;
	/* The members that the command uses, as bits. In a member that is not used,
	 * numbers may be out of range, and a projection may lack its aspect. */
	unsigned used;
	/* A document is flat, of two dimensions, if it has any of these members, as
	 * bits, and no projection. The command then needs no other member, uses none
	 * of SCENE_SPATIAL, and reads points of two coordinates. 0: the command takes
	 * no flat documents. */
	unsigned flat_members;
	/* The document's source, of which the caller sets the place of the text,
	 * two_numbers_hint, and the following. implied_type: a projection has only this
	 * type, and may lack "type". for_fit: may be missing: the eye, near, far, a
	 * parallel projection's width and height, and all of a flat document's window.
	 * for_plane: far may be missing, and near if no size is given at near. */
	struct source source;
	/* The convention that the option -c names, or NULL. The answer has it, and a
	 * document that names no convention has it, too. */
	const struct convention *convention;
	/* How many coordinates a point has; 0: the member points is not read. */
	int coordinates;
};

/* Returns, as bits, the members that a command reads of any document, flat or not. */
unsigned document_used_members(const struct document_wants *);

/* Reads the document text[0..size) into *d; changes `text`. Messages show `name`. */
void document_read(struct document *d, const char *name, char *text,
    size_t size, const struct document_wants *wants);

/* Replaces text[0..size), a point or a list of points in JSON, by lines, and returns
 * the lines; sets *points_size to their size. Each line is a point's array without
 * blanks. An array must begin with as many numbers or nulls as `coordinates` says. */
char *document_points(const char *name, char *text, size_t size,
    int coordinates, const char *two_numbers_hint, size_t *points_size);

/* Prints "projcalc: FILE: REASON" and exits with status 1. The reason comes from a
 * function of core/, and may begin with a JSON pointer: "/camera/up: ...". */
_Noreturn void document_refuse(const struct document *d, const char *reason);

/* Calls document_refuse if the reason is not NULL. */
void document_refuse_if(const struct document *d, const char *reason);

/* Prints a document of the command fit, whose camera has a gaze and whose projection is
 * no matrix, with a line for each member or, if compact, in one line. The output reads
 * back as the same scene and pick. Of a flat document, leaves out SCENE_SPATIAL. */
void print_scene(const struct document *, bool compact);

/* Print: a scene's convention and SCENE_SPATIAL, as members; a device, as an object. */
void put_scene(struct printer *, const struct scene *);
void put_device(struct printer *, const struct device *);

#endif
