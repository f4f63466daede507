/* SPDX-License-Identifier: MIT */
/* Reads JSON documents as scenes, and prints scenes. A wrong document is refused with a
 * message that says where it is wrong, and exit status 1. */
#pragma once

#include <stddef.h>

#include "../../core/derive/fit.h"
#include "../../core/derive/note.h"
#include "../json/print.h"
#include "../json/value.h"
#include "members.h"

/* The circle on the device in which the command pick finds points. */
struct pick {
	double at[2], radius; /* the radius is 0 if it is not given */
	bool has_at;
};

struct document {
	struct scene scene;
	bool flat; /* the scene is 2D: see document_wants.flat_members */
	struct written written;
	struct pick pick;
	/* whether bounds, the camera's eye, and pick are given */
	bool has_bounds, has_eye, has_pick;
	struct bounds bounds;
	/* The text, for messages. Its `row` is that of a scene or, if the whole document
	 * is one member of a scene, such as a camera, the row of this member, whose name
	 * JSON pointers in messages leave out. */
	struct json_source source;
	/* The member points, rewritten in the document's text as lines, as those of
	 * document_read_points; or NULL. */
	const char *points;
	size_t points_size;
};

/* What a command needs of a document. */
struct document_wants {
	enum scene_member lone_member; /* may be the whole document; or 0 */
	unsigned needed;               /* members that a document must have, as bits */
	/* The members that the command uses, as bits. In a member that is not used,
	 * numbers may be out of range, and a projection may lack its aspect. */
	unsigned used;
	/* A document is flat, of two dimensions, if it has one of these members, as
	 * bits, and no projection. The command then needs no other member, uses none
	 * of SCENE_SPATIAL, and reads 2D points. 0: no document is flat. */
	unsigned flat_members;
	/* The caller sets lines_before, bytes_before, two_numbers_hint, and:
	 * - implied_type: projections have only this type, and may lack "type".
	 * - task: members that the rules leave to it (struct rule) may be missing. */
	struct json_source source;
	/* The convention that the option -c names, or NULL. It is the convention of the
	 * output, and of a document that names none. */
	const struct convention *convention;
	/* How many coordinates a point has; 0: the document's points are not read. */
	int coordinates;
};

/* Returns all members that the command may use, in a flat document or not, as bits. */
unsigned document_used_members(const struct document_wants *);

/* Reads the document text[0..size) into *d; changes `text`. Messages show `name`. */
void document_read(struct document *d, const char *name, char *text, size_t size,
    const struct document_wants *wants);

/* Replaces text[0..size), a point or a list of points in JSON, by lines, and returns
 * the lines; sets *points_size to their size. Each line is a point's array without
 * blanks. The first `coordinates` elements of an array must be numbers or null. */
char *document_read_points(const char *name, char *text, size_t size, int coordinates,
    const char *two_numbers_hint, size_t *points_size);

/* Prints "projcalc: FILE: REASON" and ends as value_refuse does. The reason, from a
 * function of core/, may begin with a JSON pointer: "/camera/up: ...". */
_Noreturn void document_refuse(const struct document *d, const char *reason);

void document_refuse_if(const struct document *d, const char *reason); /* or NULL */

/* Says a note on the member to which a JSON pointer leads. */
void document_note(const struct document *, const char *pointer, const char *text);

/* Prints a document of the command fit, with a line for each member or, if compact, in
 * one line. Leaves SCENE_SPATIAL out of a flat document. If the camera has a gaze and
 * the projection is no matrix, the output reads back as the same scene and pick. */
void document_print(const struct document *, bool compact);

/* put_scene prints an object with the convention and the members SCENE_SPATIAL of a
 * scene. put_device prints a device as an object. */
void put_scene(struct printer *, const struct scene *);
void put_device(struct printer *, const struct device *);
