/* SPDX-License-Identifier: MIT */
#include "notes.h"

#include "../../core/derive/picture.h"
#include "../message/message.h"

/* A note's member, what is guessed or wrong, and what to try. */
const struct note_row note_rows[NOTES] = {
	[NOTE_MIRRORED] = { "/projection",
	    "mirrored: the picture is a mirror image, as the determinant says",
	    "negate x or y in the matrix, or try another \"convention\"" },
	[NOTE_OTHER_HANDED] = { "/projection",
	    "the projection is of the other handedness: it looks against the "
	    "convention's gaze, and mirrors",
	    "try the \"convention\" that it is from, or negate the third row, "
	    "of column vectors the third column" },
	[NOTE_LOOKS_AWAY] = { "/projection",
	    "the projection looks away: w grows against the convention's gaze, "
	    "and the picture is of what is behind the camera",
	    "turn the camera, or negate the first and third rows, of column "
	    "vectors the first and third columns" },
	[NOTE_TRANSPOSED] = { "/projection",
	    "the projection's matrix is transposed in all likelihood, as its "
	    "last row and its last column have changed places",
	    "transpose it, or try another \"vectors\" in \"convention\"" },
	[NOTE_NEAR_BEYOND] = { "/projection",
	    "near is beyond far: the eye or the gaze is on the other side",
	    "swap them, leave out minus signs, or for reversed depth say "
	    "\"reverse_z\": true" },
	[NOTE_DEPTH_FALLS] = { "/projection",
	    "depth falls along the convention's gaze: it is reversed, or the "
	    "projection is of the other handedness",
	    "if reversed depth is not meant, try another \"convention\"" },
	[NOTE_RADIANS] = { "",
	    "an angle may be in radians, as it is a part of pi or an angle of "
	    "view below 3.2",
	    "say \"angle_unit\": \"radians\", or \"degrees\"" },
	[NOTE_OFF_CENTER] = { "/projection/intrinsics",
	    "the principal point is at the edge of the viewport or outside",
	    "intrinsics are fx, fy, cx and cy, in pixels of the viewport" },
	[NOTE_CONVENTION] = { "",
	    "no convention is named: d3d (left-handed, row vectors) is assumed", NULL },
	[NOTE_ROTATION] = { "/camera",
	    "the camera's 3x3 part R is no rotation: an element of R times its "
	    "transpose is off by more than 1e-2, or the determinant is negative",
	    "look for a slip, or say \"orthonormalize\": true where the "
	    "determinant is positive" },
	[NOTE_MATRIX_RADIANS] = { "/projection/matrix",
	    "the matrix is that of an angle of view whose degrees were taken "
	    "for radians",
	    "make it of angle * pi / 180" },
	[NOTE_ASPECT] = { "/projection/aspect",
	    "the aspect differs from the viewport's width / height by more "
	    "than 1 %, which stretches the picture",
	    "leave \"aspect\" or a sensor's \"height\" out, or give the "
	    "viewport a \"scale\"" },
	[NOTE_COLMAP] = { "/projection/intrinsics",
	    "the intrinsics look like f, cx, cy, k of COLMAP",
	    "fx, fy, cx, cy are wanted: give f twice, and undistort points "
	    "first" },
	[NOTE_PART] = { "/viewport/offset", "the part is outside of the picture",
	    "\"full\" is the picture's size, which without it is the viewport's" },
	[NOTE_NO_PROJECTION] = { "/projection",
	    "there is none, so that points of view space are printed as ndc",
	    "add one, or say --to view or --to world" },
	[NOTE_RESIDUAL] = { "",
	    "scene is the nearest one, as the matrix has rounding errors",
	    "give it with all 17 digits, not as floats" },
	[NOTE_FAR_RANGE] = { "", "the digits of the matrix leave far open",
	    "give it with all 17 digits, not as floats" },
	[NOTE_NO_ROTATION] = { "",
	    "scene is null, as the camera's matrix is not a rotation to 2^-20: "
	    "it scales, shears or mirrors",
	    "take the scale out of it, try \"orthonormalize\": true where the "
	    "determinant is positive, or the \"convention\" that the matrix is "
	    "from where it is negative" },
	[NOTE_TILTED] = { "",
	    "near, far and scene are null, as the near plane is oblique: it is tilted "
	    "against the picture",
	    "see frustum_planes; if no oblique plane is meant and the matrix is a "
	    "product, check that its factors stand in the order for its "
	    "\"vectors\"" },
	[NOTE_MINUS_W] = { "", "scene is null, as w is negative between near and far",
	    "negate every element of the matrix" },
	[NOTE_NO_INTRINSICS] = { "",
	    "scene is null, as x depends on y: only \"intrinsics\" can say that, "
	    "of a perspective that does not mirror and fills the viewport",
	    "add a viewport, or give the matrix with all 17 digits" },
	[NOTE_OUT_OF_RANGE] = { "",
	    "scene is null, as a plane lies behind the eye or a number is out "
	    "of range",
	    "look at near, far and eye" },
};

unsigned notes_of_document(const struct document *d, unsigned of_picture)
{
	unsigned notes = of_picture | note_of_members(&d->scene, &d->written);

	if (d->written.angle_unit)
		notes &= ~(1u << NOTE_RADIANS);
	/* the principal point of COLMAP's numbers is no principal point */
	if (notes >> NOTE_COLMAP & 1)
		notes &= ~(1u << NOTE_OFF_CENTER);
	return notes;
}

/* Returns the pointer to the member that a note is about. */
static const char *note_pointer(const struct document *d, enum note note)
{
	return note == NOTE_ROTATION ? camera_3x3_pointer(&d->scene.camera) :
				       note_rows[note].pointer;
}

void notes_say(const struct document *d, unsigned notes)
{
	for (unsigned i = 0; i < NOTES_PRINTED; i++)
		if ((notes >> i & 1) != 0 && note_is_new(i))
			document_note(d, note_pointer(d, i), note_rows[i].what,
			    note_rows[i].remedy);
}

unsigned notes_of_spaces(const struct document *d, enum space from, enum space to)
{
	const bool depends = from >= SPACE_VIEW || to >= SPACE_VIEW ||
	    (d->scene.has_world && d->written.world_rows);

	return (unsigned)(depends && !d->written.convention) << NOTE_CONVENTION;
}

void notes_say_of_spaces(const struct document *d, enum space from, enum space to)
{
	const enum space least = from < to ? from : to;
	const enum space most = from < to ? to : from;
	struct document used = *d;
	struct scene *s = &used.scene;

	s->has_world = s->has_world && least == SPACE_MODEL && most > SPACE_MODEL;
	if (least > SPACE_WORLD || most <= SPACE_WORLD)
		s->has_camera = false;
	if (least > SPACE_VIEW || most <= SPACE_VIEW)
		s->projection.type = PROJECTION_NONE;
	if (most < SPACE_DEVICE)
		s->has_viewport = false;
	notes_say(&used,
	    notes_of_document(&used, note_is_plain(s) ? 0 : picture_notes(s)) |
		notes_of_spaces(&used, from, to));
}
