/* SPDX-License-Identifier: MIT */
#include "notes.h"

#include <math.h>

#include "../../core/derive/picture.h"
#include "../../core/points/points.h"
#include "../message/message.h"
#include "command.h"

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
	[NOTE_UP_Z] = { "/camera/up",
	    "no convention is named, and z is up: d3d is left-handed, and "
	    "mirrors a right-handed world",
	    "say \"convention\": \"webgpu\" (\"gl\" if pixels count from the "
	    "bottom), or \"d3d\" if the world is left-handed" },
	[NOTE_BEHIND] = { "/convention",
	    "none is named, and no point has an image, but points would have "
	    "one if the camera looked along -z of view space",
	    "say \"convention\": \"webgpu\" (\"gl\" if pixels count from the "
	    "bottom), or \"d3d\"" },
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
	[NOTE_NO_PROJECTION] = { "/projection",
	    "there is none, so that points of view space are printed as ndc",
	    "add one, or say --to view or --to world" },
	[NOTE_NO_ROTATION] = { "",
	    "scene is null, as the camera's matrix is not a rotation to 2^-20: "
	    "it scales, shears or mirrors",
	    "take the scale out of it, try \"orthonormalize\": true where the "
	    "determinant is positive, or the \"convention\" that the matrix is "
	    "from where it is negative" },
	[NOTE_TILTED] = { "",
	    "near, far and scene are null, as the planes of equal depth are "
	    "tilted against the picture by more than 2^-40",
	    "give the matrix with all 17 digits, not as floats, and if it is a "
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

void notes_say(const struct document *d, unsigned notes)
{
	for (unsigned i = 0; i < NOTES_PRINTED; i++)
		if ((notes >> i & 1) != 0 && note_is_new(i))
			document_note(d, note_rows[i].pointer, note_rows[i].what,
			    note_rows[i].remedy);
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
	    notes_of_document(&used, note_is_plain(s) ? 0 : picture_notes(s)));
}

void notes_watch(const struct document *d, enum space from, enum space to,
    struct job *j)
{
	const struct scene *s = &d->scene;

	j->behind.n = 0;
	j->behind.watched = !d->written.convention && from <= SPACE_VIEW &&
	    to >= SPACE_NDC && !projection_is_none(&s->projection) &&
	    projection_family(&s->projection) != FAMILY_VOLUME &&
	    (!s->has_camera || s->camera.way == CAMERA_MATRIX);
}

void notes_say_behind(const struct document *d, enum space from, struct job *j)
{
	static struct transform t;
	static COLUMN_ALIGNED double image[3][POINTS_BLOCK];
	const struct behind *b = &j->behind;
	const double *const in[4] = { b->at[0], b->at[1], b->at[2] };
	double *const out[4] = { image[0], image[1], image[2] };
	struct map rest;
	struct sum minus = sum_of_double(-1);

	if (!b->watched || b->n == 0 ||
	    !scene_map(&d->scene, from, SPACE_VIEW, &t.map, d->source.faults) ||
	    !scene_map(&d->scene, SPACE_VIEW, SPACE_NDC, &rest, d->source.faults))
		return;
	for (int i = 0; i < 5; i++)
		t.map.m[i][2] = sum_mul(t.map.m[i][2], minus);
	map_multiply(&t.map, &rest, false);
	transform_init(&t, from, SPACE_NDC, false);
	points_map(&t, PRECISION_EXACT, in, out, b->n);
	for (size_t i = 0; i < b->n; i++)
		if (isfinite(image[0][i]) && isfinite(image[1][i])) {
			notes_say(d, 1u << NOTE_BEHIND);
			return;
		}
}
