/* SPDX-License-Identifier: MIT */
/* Notes: what was guessed of a scene, as it does not say it, and what looks like a
 * slip. Nothing here changes a number. The rules read the members alone, as doubles;
 * only where these leave open how the picture looks is the picture computed. Each rule
 * is chosen so that a scene that is right gets no note. */
#pragma once

#include "../scene/scene.h"

enum note {
	NOTE_MIRRORED,     /* the picture is a mirror image */
	NOTE_OTHER_HANDED, /* the projection's handedness is not the scene's */
	NOTE_LOOKS_AWAY,   /* the projection looks against the camera's gaze */
	NOTE_TRANSPOSED,   /* the projection's matrix looks transposed */
	NOTE_NEAR_BEYOND,  /* the near plane is farther than the far plane */
	NOTE_DEPTH_FALLS,  /* depth decreases along the convention's gaze */
	NOTE_RADIANS,      /* an angle in degrees may be in radians */
	NOTE_OFF_CENTER, /* the principal point is at the viewport's edge or outside */
	NOTE_CONVENTION, /* no convention is named, and the numbers depend on it */
	NOTE_ROTATION,   /* the camera's numbers are no rotation by far */
	NOTE_MATRIX_RADIANS, /* a matrix of an angle whose degrees were radians */
	NOTE_ASPECT,         /* the aspect is not that of the viewport */
	NOTE_COLMAP,         /* the intrinsics are COLMAP's f, cx, cy, k */
	NOTE_PART,           /* the viewport's part has nothing of the picture */
	NOTE_NO_PROJECTION,  /* points are not projected, as nothing says how */
	NOTES_PRINTED, /* the notes above are printed; those below tell of a picture */
	NOTE_RESIDUAL =
	    NOTES_PRINTED, /* the matrix is not quite that of the second scene */
	NOTE_FAR_RANGE,    /* the digits of the matrix leave far open */
	NOTES_WITH_SCENE,
	/* with each of the following notes there is no second scene */
	NOTE_NO_ROTATION = NOTES_WITH_SCENE, /* the camera's matrix is not a rotation */
	NOTE_TILTED,        /* near and far are not parallel to the image */
	NOTE_MINUS_W,       /* w is negative between the near and far planes */
	NOTE_NO_INTRINSICS, /* it would need intrinsics, but cannot have them */
	NOTE_OUT_OF_RANGE,  /* numbers of the second scene are out of range */
	NOTES,
};

static inline unsigned note_if(bool applies, enum note note)
{
	return (unsigned)applies << note;
}

/* What a document or the command line writes itself, so that it is no guess. */
struct written {
	bool convention, angle_unit, scale;
	bool world_rows; /* a matrix of the world is four rows of four numbers */
};

/* Returns, as bits 1 << enum note, the notes on the members of a scene, all but
 * NOTE_CONVENTION and NOTE_NO_PROJECTION, which depend on more. */
unsigned note_of_members(const struct scene *, const struct written *);

/* Returns whether the members alone show that the picture has no note from
 * NOTE_MIRRORED to NOTE_OFF_CENTER but NOTE_RADIANS, and NOTE_MIRRORED only if edges
 * that the scene gives mirror it, which it thereby says. If not, picture_notes of
 * picture.h finds out. */
bool note_is_plain(const struct scene *);

/* Returns whether the size of the picture that intrinsics are for is known: not if the
 * viewport has an offset alone. */
bool note_judges_center(const struct scene *);

/* Returns whether a coordinate of a principal point is between 1 % and 99 % of the
 * viewport's width or height. */
bool note_principal_point_is_inside(double coordinate, double viewport_size);

/* Returns whether the principal point of intrinsics, as given, is inside of the picture
 * that they are for. */
bool note_has_central_intrinsics(const struct projection_section *);

/* Returns whether R R' is the identity within a tolerance above 2^-40, and det R > 0
 * (if mirrored, < 0). R' is the transpose of R. */
bool note_is_rotation(const double r[3][3], double tolerance, bool mirrored);

/* Returns whether the camera is given by numbers, before axes and in either direction,
 * that are no rotation by far, which NOTE_ROTATION tells. */
bool note_is_no_rotation(const struct camera *);

/* Returns whether a projection's matrix looks transposed. */
bool note_seems_transposed(const double m[4][4]);
