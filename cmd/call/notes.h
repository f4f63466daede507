/* SPDX-License-Identifier: MIT */
/* Says what core/derive/note.h guesses of a scene, each kind once a run. */
#pragma once

#include "../scene/document.h"
#include "../stream/job.h"

extern const struct note_row {
	const char *pointer, *what, *remedy;
} note_rows[NOTES];

/* Returns the notes on a document, of which `of_picture` are those on its picture. */
unsigned notes_of_document(const struct document *, unsigned of_picture);

/* Says those notes that are new. */
void notes_say(const struct document *, unsigned notes);

/* Says the notes on those members that map from one space to the other. */
void notes_say_of_spaces(const struct document *, enum space from, enum space to);

/* Makes the job remember points that have no image, if NOTE_BEHIND may be due.
 * notes_say_behind, after the points, says the note if it is due. */
void notes_watch(const struct document *, enum space from, enum space to, struct job *);
void notes_say_behind(const struct document *, enum space from, struct job *);
