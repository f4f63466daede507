/* SPDX-License-Identifier: MIT */
/* Says what core/derive/note.h guesses of a scene, each kind once a run. */
#pragma once

#include "../scene/document.h"

extern const struct note_row {
	const char *pointer, *what, *remedy;
} note_rows[NOTES];

/* Returns the notes on a document, of which `of_picture` are those on its picture. */
unsigned notes_of_document(const struct document *, unsigned of_picture);

/* Returns NOTE_CONVENTION, as a bit, if it holds for a document that maps points from
 * one space of three dimensions to the other. */
unsigned notes_of_spaces(const struct document *, enum space from, enum space to);

/* Says those notes that are new. */
void notes_say(const struct document *, unsigned notes);

/* Says the notes on those members that map from one space to the other. */
void notes_say_of_spaces(const struct document *, enum space from, enum space to);
