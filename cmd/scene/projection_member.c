/* SPDX-License-Identifier: MIT */
#include "projection_member.h"

#include <math.h>

#include "convention_member.h"
#include "types.h"

/* A range of `least` to `most` degrees; the strings `degrees` and `radians` name it. */
#define ANGLE_RANGE(label, least, most, degrees, radians, ...)              \
	static const struct value_range label = { .min = least,             \
		.max = most,                                                \
		.wanted = "an angle " degrees " degrees is wanted",         \
		.wanted_radians = "an angle " radians " radians is wanted", \
		__VA_ARGS__ }

ANGLE_RANGE(fov_range, SCENE_SIZE_MIN, 180, "above 0 and below 180",
    "above 0 and below pi", .max_excluded = true);
ANGLE_RANGE(volume_angle_range, 0, 180, "from 0 to below 180", "from 0 to below pi",
    .max_excluded = true);
ANGLE_RANGE(projector_angle_range, SCENE_SIZE_MIN, 90, "above 0 and up to 90",
    "above 0 and up to pi/2", .max_excluded = false);
ANGLE_RANGE(edge_angle_range, -90, 90, "above -90 and below 90",
    "above -pi/2 and below pi/2", .min_excluded = true, .max_excluded = true);

static const struct value_range near_ratio_range = { .min = SCENE_SIZE_MIN,
	.max = 1,
	.wanted = "a number above 0 and below 1 is wanted",
	.max_excluded = true };

static const struct value_range far_range = { SCENE_SIZE_MIN, SCENE_MAGNITUDE_MAX,
	.wanted = "a number from 1e-150 to 1e150, or \"infinity\", is wanted" };

#define TYPE(type) (PROJECTION_##type - 1)

const char *const projection_type_names[] = {
	[TYPE(PERSP)] = "persp",
	[TYPE(ORTHO)] = "ortho",
	[TYPE(OBLIQUE)] = "oblique",
	[TYPE(VOLUME)] = "volume",
	[TYPE(MATRIX)] = "matrix",
	[PROJECTION_TYPES - 1] = NULL,
};

/* The aliases of the names, as word_aliases has them. */
static const char *const projection_type_aliases[PROJECTION_TYPES] = {
	[TYPE(PERSP)] = "perspective pinhole frustum",
	[TYPE(ORTHO)] = "orthographic",
};

static const char *const oblique_kinds[] = { "cavalier", "cabinet", NULL };

/* The types as bits, for the members and ways that they have. */
enum {
	PERSP = 1 << TYPE(PERSP),
	ORTHO = 1 << TYPE(ORTHO),
	OBLIQUE = 1 << TYPE(OBLIQUE),
	VOLUME = 1 << TYPE(VOLUME),
	MATRIX = 1 << TYPE(MATRIX),
	PARALLEL = ORTHO | OBLIQUE,
	SECTIONED = PERSP | PARALLEL, /* types with a cross-section */
};

/* A default of core as JSON. */
#define TEXT_OF(number) TEXT_OF_TOKENS(number)
#define TEXT_OF_TOKENS(...) #__VA_ARGS__

#define MEMBER(types, label, value, field, ...) \
	ROW(projection, label, value, field, .variants = types, __VA_ARGS__)
#define NUMBER(types, label, field, ...) \
	MEMBER(types, label, type_numbers, field, __VA_ARGS__)
#define ANGLE(types, label, field, ...) \
	NUMBER(types, label, field, .unit = "degrees", __VA_ARGS__)
#define LENGTH(types, label, field, ...) \
	NUMBER(types, label, field, .unit = "view units", __VA_ARGS__)
#define SIZE(types, label, field, ...) \
	LENGTH(types, label, field, .range = &range_positive, __VA_ARGS__)
#define NEAR_NAMES "znear near_plane near_clip near_clip_plane clip_start"
#define FAR_NAMES "zfar far_plane far_clip far_clip_plane clip_end"

/* The rows of the table. A member has several if its types differ. */
enum {
	ROW_TYPE,
	ROW_KIND,
	ROW_ANGLE,
	ROW_DIRECTION,
	ROW_PLANE,
	ROW_FOVY,
	ROW_FOVX,
	ROW_VIEW_ANGLE,
	ROW_FIELD,
	ROW_HALF_WIDTH,
	ROW_HALF_HEIGHT,
	ROW_SIZE,
	ROW_WIDTH,
	ROW_HEIGHT,
	ROW_ASPECT,
	ROW_LEFT,
	ROW_RIGHT,
	ROW_BOTTOM,
	ROW_TOP,
	ROW_ANGLES,
	ROW_INTRINSICS,
	ROW_INTRINSICS_SIZE,
	ROW_EDGES_AT,
	ROW_NEAR,
	ROW_PARALLEL_NEAR,
	ROW_FAR,
	ROW_PARALLEL_FAR,
	ROW_REVERSE_Z,
	ROW_Z_NEAR,
	ROW_Z_FAR,
	ROW_EYE,
	ROW_VOLUME_VIEW_ANGLE,
	ROW_INVERSE_EYE_Z,
	ROW_TAN_SKEW,
	ROW_MATRIX,
	ROW_NEAR_RATIO,
	ROW_MIN_NEAR,
	PROJECTION_ROWS,
};

_Static_assert(PROJECTION_ROWS <= 64, "each row has a bit");

#define HAS(row) MEMBER_BIT(ROW_##row)

/* The rows are in the order in which members are printed. */
const struct member projection_members[] = {
	[ROW_TYPE] = MEMBER(0, "type", type_word, type, .words = projection_type_names,
	    .word_aliases = projection_type_aliases, .word_0 = PROJECTION_PERSP,
	    .about = "type; commands persp, ortho, oblique, volume imply it"),
	[ROW_KIND] = MEMBER(OBLIQUE, "kind", type_word, shear.kind,
	    .words = oblique_kinds, .word_0 = OBLIQUE_CAVALIER,
	    .about =
		"cavalier keeps the length of lines along the gaze, cabinet halves it"),
	[ROW_ANGLE] = ANGLE(OBLIQUE, "angle", shear.projector_angle,
	    .range = &projector_angle_range,
	    .about = "angle between projectors and picture, in place of kind"),
	[ROW_DIRECTION] = ANGLE(OBLIQUE, "direction", shear.direction,
	    .range = &range_any, .fallback = TEXT_OF(PROJECTION_DIRECTION),
	    .shown = true, .about = "direction in the picture of lines along the gaze"),
	[ROW_PLANE] = LENGTH(OBLIQUE, "plane", shear.plane, .fallback = "0",
	    .about = "distance along the gaze of points that do not shear"),
	[ROW_FOVY] = ANGLE(PERSP, "fovy", section.angle, .range = &fov_range,
	    .about = "angle between the bottom and the top plane"),
	[ROW_FOVX] = ANGLE(PERSP, "fovx", section.angle, .range = &fov_range,
	    .about = "angle between the left and the right plane"),
	[ROW_VIEW_ANGLE] = ANGLE(PERSP, "view_angle", section.angle,
	    .range = &fov_range,
	    .about = "angle across the smaller side of the picture"),
	[ROW_FIELD] = NUMBER(PERSP, "field", section.field, .range = &range_positive,
	    .about = "half the larger side of the picture at distance 1"),
	[ROW_HALF_WIDTH] = SIZE(VOLUME, "half_width", volume.half_width,
	    .about = "half the width of the view volume at view z = 0"),
	[ROW_HALF_HEIGHT] = SIZE(VOLUME, "half_height", volume.half_height,
	    .about = "half the height of the view volume at view z = 0"),
	[ROW_SIZE] = SIZE(VOLUME, "size", volume.half_width,
	    .about = "smaller side of the view volume at view z = 0"),
	[ROW_WIDTH] = SIZE(SECTIONED, "width", section.width,
	    .about = "width of the view volume; persp: at near or edges_at"),
	[ROW_HEIGHT] = SIZE(SECTIONED, "height", section.height,
	    .about = "height of the view volume; persp: at near or edges_at"),
	[ROW_ASPECT] = NUMBER(SECTIONED | VOLUME, "aspect", aspect,
	    .range = &range_positive, .aliases = "aspect_ratio",
	    .about = "width over height; if absent, from the viewport"),
	[ROW_LEFT] = LENGTH(SECTIONED, "left", section.left, .aliases = "l",
	    .about = "left edge of the view volume, in place of width"),
	[ROW_RIGHT] = LENGTH(SECTIONED, "right", section.right, .aliases = "r",
	    .about = "right edge of the view volume, other than left"),
	[ROW_BOTTOM] = LENGTH(SECTIONED, "bottom", section.bottom, .aliases = "b",
	    .about = "bottom edge of the view volume, in place of height"),
	[ROW_TOP] = LENGTH(SECTIONED, "top", section.top, .aliases = "t",
	    .about = "top edge of the view volume, other than bottom"),
	[ROW_ANGLES] = ANGLE(PERSP, "angles", section.angles, .n = 4,
	    .range = &edge_angle_range,
	    .about = "angles from the gaze: left, right, bottom, top plane"),
	[ROW_INTRINSICS] = MEMBER(PERSP, "intrinsics", type_intrinsics,
	    section.intrinsics, .unit = "device units",
	    .about = "numbers of a camera: [fx, fy, cx, cy], matrix K or P"),
	[ROW_INTRINSICS_SIZE] = NUMBER(PERSP, "intrinsics_size",
	    section.intrinsics_size, .n = 2, .range = &range_positive,
	    .flag = FIELD(projection, section.is_sized), .unit = "device units",
	    .about = "size of the picture that intrinsics are for"),
	[ROW_EDGES_AT] = SIZE(PERSP, "edges_at", section.edges_at,
	    .about = "distance from the eye where edges are; if absent, near"),
	[ROW_NEAR] = SIZE(PERSP, "near", near, .aliases = NEAR_NAMES,
	    .about = "distance of the near plane from the eye"),
	[ROW_PARALLEL_NEAR] = LENGTH(PARALLEL, "near", near, .aliases = NEAR_NAMES,
	    .about = "distance of the near plane from the eye"),
	[ROW_FAR] = MEMBER(PERSP, "far", type_far, far, .range = &far_range,
	    .unit = "view units", .aliases = FAR_NAMES,
	    .about = "distance of the far plane from the eye"),
	[ROW_PARALLEL_FAR] = LENGTH(PARALLEL, "far", far, .aliases = FAR_NAMES,
	    .about = "distance of the far plane from the eye"),
	[ROW_REVERSE_Z] = MEMBER(SECTIONED, "reverse_z", type_flag, reverse_z,
	    .fallback = "false",
	    .about = "make depth greater at the near than at the far plane"),
	[ROW_Z_NEAR] = LENGTH(VOLUME, "z_near", volume.z_near,
	    .about = "z of the near plane in view space"),
	[ROW_Z_FAR] = LENGTH(VOLUME, "z_far", volume.z_far,
	    .about = "z of the far plane in view space"),
	[ROW_EYE] = LENGTH(VOLUME, "eye", volume.eye, .n = 3,
	    .about = "eye in view space, in place of inverse_eye_z"),
	[ROW_VOLUME_VIEW_ANGLE] = ANGLE(VOLUME, "view_angle", volume.view_angle,
	    .range = &volume_angle_range,
	    .about = "angle across the smaller side; 0: parallel projection"),
	[ROW_INVERSE_EYE_Z] = NUMBER(VOLUME, "inverse_eye_z", volume.inverse_eye_z,
	    .fallback = "0",
	    .about = "1/z of the eye in view space; 0: parallel projection"),
	[ROW_TAN_SKEW] = NUMBER(VOLUME, "tan_skew", volume.tan_skew, .n = 2,
	    .fallback = "[0, 0]",
	    .about = "x/z and y/z of the axis of the view volume"),
	[ROW_MATRIX] = MEMBER(MATRIX, "matrix", type_matrix, matrix,
	    .about = "matrix from view to clip space"),
	[ROW_NEAR_RATIO] = NUMBER(PERSP | VOLUME, "near_ratio", near_ratio,
	    .range = &near_ratio_range, .fallback = TEXT_OF(PROJECTION_NEAR_RATIO),
	    .about = "least near that fit finds, as a fraction of far"),
	[ROW_MIN_NEAR] = SIZE(PERSP | VOLUME, "min_near", min_near,
	    .about = "least distance of near from the eye that fit finds"),
	[PROJECTION_ROWS] = { .name = NULL },
};

#define RULE(types, ...) WAYS(__VA_ARGS__), .variants = types
#define TASK(name) (1u << TASK_##name)
#define WITH_ASPECT(member, way) \
	WAY(HAS(member) | HAS(ASPECT), .by_viewport = HAS(ASPECT), .value = way)
#define EDGES (HAS(LEFT) | HAS(RIGHT) | HAS(BOTTOM) | HAS(TOP))

/* A cross-section by one of these is on the near plane, unless edges_at is given. */
#define AT_NEAR (HAS(WIDTH) | HAS(HEIGHT) | EDGES)

/* The command fit computes the width and height of every parallel projection. A
 * perspective needs neither near nor far, but a cross-section on the near plane always
 * needs near, and for --plane only this. fit refuses every matrix itself. */
const struct rule projection_rules[] = {
	{ RULE(PERSP, WITH_ASPECT(FOVY, SECTION_FOVY), WITH_ASPECT(FOVX, SECTION_FOVX),
	      WITH_ASPECT(VIEW_ANGLE, SECTION_VIEW_ANGLE),
	      WITH_ASPECT(FIELD, SECTION_FIELD),
	      WAY(HAS(WIDTH) | HAS(HEIGHT), .optional = HAS(EDGES_AT),
		  .value = SECTION_SIZE),
	      WAY(HAS(WIDTH) | HAS(ASPECT), .optional = HAS(EDGES_AT),
		  .by_viewport = HAS(ASPECT), .value = SECTION_WIDTH),
	      WAY(HAS(HEIGHT) | HAS(ASPECT), .optional = HAS(EDGES_AT),
		  .by_viewport = HAS(ASPECT), .value = SECTION_HEIGHT),
	      WAY(EDGES, .optional = HAS(EDGES_AT), .value = SECTION_EDGES),
	      WAY(HAS(ANGLES), .value = SECTION_ANGLES),
	      WAY(HAS(INTRINSICS), .optional = HAS(INTRINSICS_SIZE),
		  .value = SECTION_INTRINSICS)),
	    .field = FIELD(projection, section.way),
	    .rivals = "one way is enough: \"fovy\" and \"aspect\", \"fovx\" and "
		      "\"aspect\", or \"width\" and \"height\" at \"edges_at\"; both "
		      "angles are \"angles\", and pixels belong in \"viewport\"" },
	{ RULE(PARALLEL,
	      WAY(HAS(WIDTH) | HAS(HEIGHT), .fitted = HAS(WIDTH) | HAS(HEIGHT),
		  .value = SECTION_SIZE),
	      WAY(HAS(WIDTH) | HAS(ASPECT), .fitted = HAS(WIDTH) | HAS(ASPECT),
		  .by_viewport = HAS(ASPECT), .value = SECTION_WIDTH),
	      WAY(HAS(HEIGHT) | HAS(ASPECT), .fitted = HAS(HEIGHT) | HAS(ASPECT),
		  .by_viewport = HAS(ASPECT), .value = SECTION_HEIGHT),
	      WAY(EDGES, .value = SECTION_EDGES)),
	    .field = FIELD(projection, section.way) },
	{ RULE(OBLIQUE, WAY(HAS(KIND)), WAY(HAS(ANGLE))),
	    .hint = "give \"kind\", or \"angle\" of the projectors; lines along the "
		    "gaze have the \"direction\" in the picture" },
	{ RULE(PERSP, WAY(HAS(NEAR) | HAS(FAR))), .tasks = TASK(WHOLE), .with = AT_NEAR,
	    .without = HAS(EDGES_AT),
	    .hint = "give \"near\" and \"far\", which may be \"infinity\"; with "
		    "\"edges_at\", where the edges are, both may be absent" },
	{ RULE(PARALLEL, WAY(HAS(PARALLEL_NEAR) | HAS(PARALLEL_FAR))),
	    .tasks = TASK(WHOLE) },
	{ RULE(PERSP, WAY(HAS(NEAR), .optional = HAS(FAR) | HAS(REVERSE_Z)), WAY(0)),
	    .tasks = TASK(WHOLE) | TASK(PLANE),
	    .with = HAS(FOVY) | HAS(FOVX) | HAS(VIEW_ANGLE) | HAS(FIELD) | HAS(ANGLES) |
		HAS(INTRINSICS) | HAS(EDGES_AT) },
	{ RULE(PERSP, WAY(HAS(NEAR))), .tasks = TASK(FIT) | TASK(PLANE),
	    .with = AT_NEAR, .without = HAS(EDGES_AT),
	    .hint =
		"the section is on the near plane, unless \"edges_at\" says where" },
	{ RULE(VOLUME, WAY(HAS(HALF_WIDTH) | HAS(HALF_HEIGHT)),
	    WAY(HAS(SIZE) | HAS(ASPECT), .by_viewport = HAS(ASPECT))) },
	{ RULE(VOLUME,
	      WAY(0, .optional = HAS(INVERSE_EYE_Z) | HAS(TAN_SKEW),
		  .value = EYE_BY_INVERSE_Z),
	      WAY(HAS(EYE), .value = EYE_BY_POINT),
	      WAY(HAS(VOLUME_VIEW_ANGLE), .optional = HAS(TAN_SKEW),
		  .value = EYE_BY_ANGLE)),
	    .field = FIELD(projection, volume.eye_given_by) },
	{ RULE(VOLUME,
	    WAY(HAS(Z_NEAR) | HAS(Z_FAR), .fitted = HAS(Z_NEAR) | HAS(Z_FAR))) },
	{ RULE(MATRIX, WAY(HAS(MATRIX), .fitted = HAS(MATRIX))) },
	{ .n = 0 },
};

/* Finds the type of a projection, by which its other members are read: sets p->type, or
 * refuses the projection if it has none. A type that differs from the implied one is
 * refused, too. */
static bool read_type(const struct value *v, struct projection *p)
{
	const struct member *row = &projection_members[ROW_TYPE];
	const unsigned implied = v->source->implied_type;
	char all[LIST_ROOM];
	struct value m;
	const bool given = object_member(v, row, &m);
	const char *s = given ? value_string(&m) : NULL;
	const int i = s != NULL ? word_index(s, row->words, row->word_aliases) : -1;

	p->type = PROJECTION_NONE;
	if (!given && implied == PROJECTION_NONE)
		return value_refuse(VALUE_NAMED(v, "type"), "missing",
		    text("add \"type\": %s",
			words_join(all, projection_type_names, " or ", "\"")));
	/* object_read refuses what is no type */
	if (i < 0 && implied == PROJECTION_NONE)
		return false;
	p->type = i < 0 ? implied : PROJECTION_PERSP + (unsigned)i;
	if (implied == PROJECTION_NONE || p->type == implied)
		return true;
	return value_refuse(&m,
	    text("is \"%s\", not \"%s\"", projection_type_names[p->type - 1],
		projection_type_names[implied - 1]),
	    "project takes any type");
}

/* Completes what was read: `given` are the members of the projection. */
static void complete_members(struct projection *p, uint64_t given, enum task task)
{
	const enum projection_family family = projection_family(p);
	const bool near = (given & (HAS(NEAR) | HAS(PARALLEL_NEAR))) != 0;
	const bool far = (given & (HAS(FAR) | HAS(PARALLEL_FAR))) != 0;

	/* the default direction is in degrees in every document */
	if ((given & HAS(DIRECTION)) != 0)
		p->shear.direction_unit = p->unit;
	if (family == FAMILY_PERSP && task != TASK_FIT) {
		p->reverse_z |= !near;
		if (!far)
			p->far = HUGE_VAL;
	} else if (task == TASK_PLANE && p->far == p->near && !(near && far)) {
		p->far = 1; /* both were 0 */
	}
	if ((given & HAS(SIZE)) != 0) {
		p->volume.half_width /= 2;
		p->volume.half_height = p->volume.half_width;
	}
}

/* Returns the digits of the shortest decimal that reads back as v; of a float at most
 * 9, which tell it from other floats. */
static int digits_of(double v)
{
	const struct number_style shortest = { .kind = NUMBER_SHORTEST };
	char s[NUMBER_MAX];
	const char *const end = number_write(s, v, shortest);
	int n = 0, zeros = 0;

	for (const char *at = s; at < end && *at != 'e'; at++) {
		if (*at < '0' || *at > '9' || (n == 0 && *at == '0'))
			continue;
		n++;
		zeros = *at == '0' ? zeros + 1 : 0;
	}
	return n - zeros > 9 && (double)(float)v == v ? 9 : n - zeros;
}

/* Returns whether v is a float, or what a float is read as that was printed by %.9g. */
static bool is_of_float(double v)
{
	const struct number_style nine = { .kind = NUMBER_DIGITS, .n = 9 };
	const double nearest = (double)(float)v;
	char s[NUMBER_MAX];
	double printed = nearest;

	if (v != nearest && isfinite(nearest))
		number_read(s, number_write(s, nearest, nine), &printed);
	return v == nearest || v == printed;
}

static void count_digits(struct projection *p)
{
	p->matrix_of_floats = true;
	for (int i = 0; i < 16; i++) {
		const double v = p->matrix[i / 4][i % 4];
		const int n = digits_of(v);

		p->matrix_digits = n > p->matrix_digits ? n : p->matrix_digits;
		p->matrix_of_floats = p->matrix_of_floats && is_of_float(v);
	}
}

static bool read_projection(const struct value *v, const struct member *row, void *out)
{
	struct projection *p = out;
	struct found found;

	if (!value_is(v, JSON_OBJECT))
		return value_refuse_type(v,
		    value_is(v, JSON_ARRAY) ?
			"{\"type\": \"matrix\", \"matrix\": [...]}" :
			"an object");
	bool is_right = read_type(v, p);

	if (p->type == PROJECTION_NONE) {
		struct projection any; /* of which nothing is known */

		object_read(v, row, ANY_VARIANT, &any, NULL);
		return false;
	}
	/* an index in projection_type_names, which has no PROJECTION_NONE */
	is_right = object_read(v, row, (int)p->type - 1, p, &found) && is_right;
	p->unit = (enum angle_unit)v->source->unit;
	complete_members(p, found.given, v->source->task);
	if (projection_is_given_matrix(p))
		count_digits(p);
	p->aspect[1] = p->aspect[0] > 0 || found.left != 0;
	return is_right;
}

/* Sets the image size of intrinsics to that of the viewport's full picture. Its scale
 * must be fill. */
static void set_image_size(const struct value *v, const struct viewport *viewport,
    struct projection *p)
{
	const struct value *given = VALUE_NAMED(v, "intrinsics");
	double full[2] = { 0 };
	/* a picture of another size that fills the same is enlarged to the full one */
	const double *size = p->section.is_sized ? p->section.intrinsics_size : full;

	if (viewport != NULL)
		viewport_full(viewport, full);
	if (viewport == NULL)
		value_refuse(given, "needs a \"viewport\", in whose units it is",
		    "write {\"projection\": {...}, \"viewport\": {...}}");
	else if (viewport->scale != SCALE_FILL)
		value_refuse(given, "excludes the viewport's \"scale\"", "omit that");
	p->section.width = size[0];
	p->section.height = size[1];
	convention_require(v, "intrinsics", "");
}

void projection_complete(const struct value *v, const struct viewport *viewport,
    struct projection *p)
{
	/* fit widens a parallel projection to the viewport's aspect */
	const bool widened = v->source->task == TASK_FIT && viewport != NULL &&
	    projection_family(p) == FAMILY_PARALLEL;

	if (v->unused || projection_is_none(p))
		return;
	if (projection_has_intrinsics(p))
		set_image_size(v, viewport, p);
	if (p->aspect[0] != 0 || (p->aspect[1] == 0 && !widened))
		return;
	if (viewport == NULL)
		value_refuse(VALUE_NAMED(v, "aspect"), "missing",
		    "give it, or a \"viewport\"");
	p->aspect[0] = p->aspect[1] = 1;
	if (viewport != NULL && viewport->scale != SCALE_UNIFORM)
		viewport_full(viewport, p->aspect);
}

static void print_projection(struct printer *printer, const struct member *row,
    const void *at)
{
	struct projection p = *(const struct projection *)at;
	const bool sized = p.aspect[1] != 0;
	/* members that are not printed, as the document cannot have given them */
	uint64_t hidden = HAS(ANGLE) | HAS(SIZE);

	if (p.shear.kind == OBLIQUE_ANGLE)
		hidden ^= HAS(ANGLE) | HAS(KIND);
	if (sized)
		hidden ^= HAS(SIZE) | HAS(HALF_WIDTH) | HAS(HALF_HEIGHT);
	/* an aspect from the viewport */
	if (p.aspect[1] != 1)
		hidden |= HAS(ASPECT);
	/* the default direction */
	if (p.shear.direction == PROJECTION_DIRECTION &&
	    p.shear.direction_unit == ANGLE_DEGREES)
		hidden |= HAS(DIRECTION);
	if (projection_is_open(&p))
		hidden |= HAS(NEAR) | HAS(FAR) | HAS(REVERSE_Z);
	if (sized)
		p.volume.half_width *= 2; /* "size" is twice half_width */
	object_print(printer, row, (int)p.type - 1, ~hidden, &p);
}

const struct member_type type_projection = { .read = read_projection,
	.print = print_projection };
