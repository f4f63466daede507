/* SPDX-License-Identifier: MIT */
/* Reads JSON documents as scenes, and prints scenes. */
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
	/* Of refusals: they are about the call, too, so that the exit status is
	 * EXIT_USAGE; no scene can follow, as the text is no JSON, or typed points are
	 * wrong. */
	bool is_usage, ends_run;
	struct written written;
	struct pick pick;
	/* whether bounds, the camera's eye, and pick are given */
	bool has_bounds, has_eye, has_pick;
	/* The members, also wrong ones, and those that unknown ones may mean, as
	 * bits. */
	unsigned present;
	struct bounds bounds;
	/* The text, for messages. Its `row` is that of a scene or, if the whole
	 * document is one member of a scene, such as a camera, the row of this member,
	 * whose name JSON pointers in messages leave out. */
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
	/* The caller sets faults, lines_before, bytes_before, two_numbers_hint, and:
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

/* Reads the document text[0..size) into *d; changes `text`. Messages show `name`.
 * Returns false after refusals, which are in wants->source.faults, as all that follow
 * are. */
bool document_read(struct document *d, const char *name, char *text, size_t size,
    const struct document_wants *wants);

/* Replaces text[0..size), a point or a list of points in JSON, by lines, and sets
 * *points to them. Each line is a point's array without blanks. The first `coordinates`
 * elements of an array must be numbers or null. The source has a name and faults. */
bool document_read_points(struct json_source *, char *text, size_t size,
    int coordinates, struct span *points);

/* Refuses a document: the parts are those of struct refusal. Returns false. */
bool document_refuse(const struct document *, const char *where, const char *what,
    const char *remedy);

/* Prints the refusals of a document, with this exit status. */
void document_tell(const struct json_source *, int status);

/* Says a note on the member to which a JSON pointer leads. */
void document_note(const struct document *, const char *pointer, const char *what,
    const char *remedy);

/* Prints a document of the command fit, with a line for each member or, if compact, in
 * one line. Leaves SCENE_SPATIAL out of a flat document. If the camera has a gaze and
 * the projection is no matrix, the output reads back as the same scene and pick. */
void document_print(const struct document *, bool compact);

/* Prints an object with the convention and the members SCENE_SPATIAL of a scene. */
void put_scene(struct printer *, const struct scene *);
