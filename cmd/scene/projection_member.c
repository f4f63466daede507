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

#define TYPE(type) (PROJECTION_##type - 1)

const char *const projection_type_names[] = {
	[TYPE(PERSP)] = "persp",
	[TYPE(ORTHO)] = "ortho",
	[TYPE(OBLIQUE)] = "oblique",
	[TYPE(VOLUME)] = "volume",
	[TYPE(MATRIX)] = "matrix",
	[PROJECTION_TYPES - 1] = NULL,
};
_Static_assert(sizeof projection_type_names / sizeof(char *) == PROJECTION_TYPES,
    "every type but PROJECTION_NONE has a name");

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
#define Z_HINT " (a z, which is below 0 where the camera looks along -z)"
#define RADIANS "glTF and NeRF with \"angle_unit\": \"radians\""

/* The rows are in the order in which members are printed. */
const struct member projection_members[] = {
	MEMBER(0, "type", type_word, type, .words = projection_type_names,
	    .word_0 = PROJECTION_PERSP,
	    .about = "type; commands persp, ortho, oblique, volume imply it"),
	MEMBER(OBLIQUE, "kind", type_word, shear.kind, .words = oblique_kinds,
	    .word_0 = OBLIQUE_CAVALIER,
	    .about =
		"cavalier keeps the length of lines along the gaze, cabinet halves it"),
	ANGLE(OBLIQUE, "angle", shear.projector_angle, .range = &projector_angle_range,
	    .aliases = "alpha",
	    .about = "angle between projectors and picture, in place of kind"),
	ANGLE(OBLIQUE, "direction", shear.direction, .range = &range_any,
	    .aliases = "phi", .fallback = "45", .shown = true,
	    .about = "direction in the picture of lines along the gaze"),
	LENGTH(OBLIQUE, "plane", shear.plane, .fallback = "0",
	    .about = "distance along the gaze of points that do not shear"),
	ANGLE(PERSP, "fovy", section.angle, .range = &fov_range,
	    .aliases = "fov yfov vfov fovv verticalfov fieldofview cameraangley",
	    .hint = " (vertical, as of Unity and three.js; Unreal's is \"fovx\"; "
		    "of " RADIANS ")",
	    .about = "angle between the bottom and the top plane"),
	ANGLE(PERSP, "fovx", section.angle, .range = &fov_range,
	    .aliases = "xfov fovh horizontalfov hfov cameraanglex anglex",
	    .hint = " (of " RADIANS ")",
	    .about = "angle between the left and the right plane"),
	ANGLE(PERSP, "view_angle", section.angle, .range = &fov_range,
	    .aliases = "angle",
	    .about = "angle across the smaller side of the picture"),
	NUMBER(PERSP, "field", section.field, .range = &range_positive,
	    .about = "half the larger side of the picture at distance 1"),
	SIZE(VOLUME, "half_width", volume.half_width,
	    .about = "half the width of the view volume at view z = 0"),
	SIZE(VOLUME, "half_height", volume.half_height,
	    .about = "half the height of the view volume at view z = 0"),
	SIZE(VOLUME, "size", volume.half_width,
	    .about = "smaller side of the view volume at view z = 0"),
	SIZE(SECTIONED, "width", section.width, .aliases = "orthoscale xmag",
	    .hint = " (ortho_scale, or twice xmag)",
	    .about = "width of the view volume; persp: at near or edges_at"),
	SIZE(SECTIONED, "height", section.height, .aliases = "orthographicsize ymag",
	    .hint = " (twice orthographicSize or ymag)",
	    .about = "height of the view volume; persp: at near or edges_at"),
	NUMBER(SECTIONED | VOLUME, "aspect", aspect, .range = &range_positive,
	    .aliases = "ratio aspectratio",
	    .about = "width over height; if absent, from the viewport"),
	LENGTH(SECTIONED, "left", section.left, .aliases = "xmin l",
	    .about = "left edge of the view volume, in place of width"),
	LENGTH(SECTIONED, "right", section.right, .aliases = "xmax r",
	    .about = "right edge of the view volume, other than left"),
	LENGTH(SECTIONED, "bottom", section.bottom, .aliases = "ymin b",
	    .about = "bottom edge of the view volume, in place of height"),
	LENGTH(SECTIONED, "top", section.top, .aliases = "ymax t",
	    .about = "top edge of the view volume, other than bottom"),
	ANGLE(PERSP, "angles", section.angles, .n = 4, .range = &edge_angle_range,
	    .aliases = "angleleft angleright angleup angledown",
	    .hint = " ([left, right, bottom, top] from the gaze; for OpenXR with "
		    "\"angle_unit\": \"radians\")",
	    .about = "angles from the gaze: left, right, bottom, top plane"),
	MEMBER(PERSP, "intrinsics", type_intrinsics, section.intrinsics,
	    .aliases = "k fx fy cx cy flx fly cameramatrix matrix "
		       "intrinsic p principalpoint skew",
	    .hint =
		" ([fx, fy, cx, cy], 3x3 K or 3x4 P, in pixels of the \"viewport\", "
		"with a \"convention\" such as \"opencv\"; a 4x4 from view to clip is "
		"\"matrix\" of type \"matrix\")",
	    .unit = "device units",
	    .about = "numbers of a camera: [fx, fy, cx, cy], matrix K or P"),
	SIZE(PERSP, "edges_at", section.edges_at, .aliases = "distance d",
	    .about = "distance from the eye where edges are; if absent, near"),
	SIZE(PERSP, "near", near,
	    .aliases = "znear n nearplane nearclipplane nearfar clipstart hither "
		       "zmin",
	    .about = "distance of the near plane from the eye"),
	LENGTH(PARALLEL, "near", near,
	    .aliases = "znear n nearplane nearclipplane clipstart hither zmin",
	    .about = "distance of the near plane from the eye"),
	MEMBER(PERSP, "far", type_far, far, .range = &range_positive,
	    .aliases = "zfar farplane farclipplane clipend yon zmax",
	    .unit = "view units", .about = "distance of the far plane from the eye"),
	LENGTH(PARALLEL, "far", far,
	    .aliases = "zfar f farplane farclipplane clipend yon zmax",
	    .about = "distance of the far plane from the eye"),
	MEMBER(SECTIONED, "reverse_z", type_flag, reverse_z,
	    .aliases = "reversed reversedz", .fallback = "false",
	    .about = "make depth greater at the near than at the far plane"),
	LENGTH(VOLUME, "z_near", volume.z_near, .aliases = "near nearplane",
	    .hint = Z_HINT, .about = "z of the near plane in view space"),
	LENGTH(VOLUME, "z_far", volume.z_far, .aliases = "far farplane", .hint = Z_HINT,
	    .about = "z of the far plane in view space"),
	LENGTH(VOLUME, "eye", volume.eye, .n = 3,
	    .about = "eye in view space, in place of inverse_eye_z"),
	ANGLE(VOLUME, "view_angle", volume.view_angle, .range = &volume_angle_range,
	    .aliases = "angle",
	    .about = "angle across the smaller side; 0: parallel projection"),
	NUMBER(VOLUME, "inverse_eye_z", volume.inverse_eye_z, .fallback = "0",
	    .about = "1/z of the eye in view space; 0: parallel projection"),
	NUMBER(VOLUME, "tan_skew", volume.tan_skew, .n = 2, .aliases = "skew",
	    .fallback = "[0, 0]",
	    .about = "x/z and y/z of the axis of the view volume"),
	MEMBER(MATRIX, "matrix", type_matrix, matrix,
	    .about = "matrix from view to clip space"),
	NUMBER(PERSP | VOLUME, "near_ratio", near_ratio, .range = &near_ratio_range,
	    .fallback = "0.0005",
	    .about = "least near that fit finds, as a fraction of far"),
	SIZE(PERSP | VOLUME, "min_near", min_near,
	    .about = "least distance of near from the eye that fit finds"),
	{ .name = NULL },
};

#define RULE(types, ...) .ways = WAYS(__VA_ARGS__), .variants = types
#define TASK(name) (1u << TASK_##name)

/* The command fit computes the width and height of every parallel projection. Near and
 * far are needed neither with intrinsics nor for --plane, but a cross-section on the
 * near plane always needs near. fit refuses every matrix itself. */
const struct rule projection_rules[] = {
	{ RULE(PERSP, "fovy aspect|viewport", "fovx aspect|viewport",
	      "view_angle aspect|viewport", "field aspect|viewport",
	      "width height edges_at?", "width aspect|viewport edges_at?",
	      "height aspect|viewport edges_at?", "left right bottom top edges_at?",
	      "angles", "intrinsics"),
	    .field = FIELD(projection, section.way),
	    .rivals = "one way is enough: \"fovy\" and \"aspect\", \"fovx\" and "
		      "\"aspect\", or \"width\" and \"height\" at \"edges_at\"; both "
		      "angles are \"angles\", and pixels belong in \"viewport\"" },
	{ RULE(PARALLEL, "width~ height~", "width~ aspect~|viewport",
	      "height~ aspect~|viewport", "left right bottom top"),
	    .field = FIELD(projection, section.way), .way_0 = SECTION_SIZE },
	{ RULE(OBLIQUE, "kind", "angle"),
	    .hint = "give \"kind\", or \"angle\" of the projectors; lines along the "
		    "gaze have the \"direction\" in the picture" },
	{ RULE(PERSP, "near far"), .tasks = TASK(WHOLE), .with = "intrinsics!",
	    .hint = "give \"near\" and \"far\", which may be \"infinity\"" },
	{ RULE(PARALLEL, "near far"), .tasks = TASK(WHOLE) },
	{ RULE(PERSP, "near far? reverse_z?", ""), .tasks = TASK(WHOLE) | TASK(PLANE),
	    .with = "intrinsics" },
	{ RULE(PERSP, "near far? reverse_z?", ""), .tasks = TASK(PLANE),
	    .with = "fovy fovx view_angle field angles edges_at" },
	{ RULE(PERSP, "near"), .tasks = TASK(FIT) | TASK(PLANE),
	    .with = "width height left edges_at!",
	    .hint =
		"the section is on the near plane, unless \"edges_at\" says where" },
	{ RULE(VOLUME, "half_width half_height", "size aspect|viewport") },
	{ RULE(VOLUME, "inverse_eye_z? tan_skew?", "eye", "view_angle tan_skew?"),
	    .field = FIELD(projection, volume.eye_given_by) },
	{ RULE(VOLUME, "z_near~ z_far~") },
	{ RULE(MATRIX, "matrix~") },
	{ .ways = NULL },
};

static bool is_given(const struct projection *p, uint64_t given, const char *name)
{
	return (given & member_bits(projection_members, (int)p->type - 1, name)) != 0;
}

/* Returns the type that alone has all members of v, or PROJECTION_NONE. Writes the names
 * of such types to `all` as a list, or of all types if there are none. */
static unsigned find_type(const struct value *v, char all[LIST_ROOM])
{
	unsigned last = PROJECTION_NONE;
	const char *names[PROJECTION_TYPES];
	int n = 0;

	for (int i = 0; projection_type_names[i] != NULL; i++) {
		struct value m = value_child(v);

		while (m.item != NULL &&
		    (*m.name == '_' ||
			member_named(projection_members, i, m.name, true) != NULL))
			value_next(&m);
		if (m.item == NULL) {
			names[n++] = projection_type_names[i];
			last = PROJECTION_PERSP + (unsigned)i;
		}
	}
	names[n] = NULL;
	words_join(all, n > 0 ? names : projection_type_names, " or ", "\"");
	return n == 1 ? last : PROJECTION_NONE;
}

/* Reads the type of the projection. If it is missing or wrong, the other members are
 * read as those of the type that has them. */
static void read_type(const struct value *v, const struct member *row,
    struct projection *p)
{
	unsigned implied = v->source->implied_type;
	char all[LIST_ROOM];
	struct value m;
	const bool given = value_member(v, "type", &m);

	p->type = implied;
	if (given ? value_find_word(&m, projection_type_names) < 0 :
		    implied == PROJECTION_NONE) {
		if (implied == PROJECTION_NONE)
			p->type = find_type(v, all);
		if (!given)
			value_fault(VALUE_MISSING(v, "type"),
			    "missing; add \"type\": %s", all);
		if (p->type != PROJECTION_NONE)
			return; /* object_read refuses a wrong "type" */
		object_read(v, row, ANY_VARIANT, NULL);
		if (!given)
			value_give_up(v);
	}
	if (!given)
		return;
	type_word.read(&m, projection_members, &p->type);
	if (implied != PROJECTION_NONE && p->type != implied)
		value_fault(&m, "is \"%s\", not \"%s\"; project takes any type",
		    projection_type_names[p->type - 1],
		    projection_type_names[implied - 1]);
}

static void read_projection(const struct value *v, const struct member *row, void *out)
{
	struct projection *p = out;

	if (value_is(v, JSON_ARRAY))
		value_refuse_type(v, "{\"type\": \"matrix\", \"matrix\": [...]}");
	if (!value_is(v, JSON_OBJECT))
		value_refuse_type(v, "an object");
	read_type(v, row, p);
	/* an index in projection_type_names, which has no PROJECTION_NONE */
	int variant = (int)p->type - 1;
	const struct found found = object_read(v, row, variant, p);
	const enum task task = v->source->task;
	const enum projection_family family = projection_family(p);

	p->unit = (enum angle_unit)v->source->unit;
	/* the default direction, 45, is in degrees in every document */
	if (is_given(p, found.given, "direction"))
		p->shear.direction_unit = p->unit;
	if (family == FAMILY_PERSP && task != TASK_FIT) {
		p->reverse_z |= !is_given(p, found.given, "near");
		if (!is_given(p, found.given, "far"))
			p->far = HUGE_VAL;
	} else if (task == TASK_PLANE && p->far == p->near &&
	    !(is_given(p, found.given, "near") && is_given(p, found.given, "far"))) {
		p->far = 1; /* both were 0 */
	}
	if (!found.faulty && p->section.way == SECTION_ANGLES &&
	    !(p->section.angles[0] < p->section.angles[1] &&
		p->section.angles[2] < p->section.angles[3]))
		value_refuse(VALUE_MISSING(v, "angles"),
		    "not in order: left below right, bottom below top");
	p->aspect[1] = p->aspect[0] > 0 || found.left != 0;
	if (is_given(p, found.given, "size")) {
		p->volume.half_width /= 2;
		p->volume.half_height = p->volume.half_width;
	}
}

/* Sets the image size of intrinsics to the viewport's, whose scale must be fill. */
static void set_image_size(const struct value *v, const struct viewport *viewport,
    struct projection *p)
{
	const struct value *given = VALUE_MISSING(v, "intrinsics");

	if (viewport == NULL)
		value_fault(given,
		    "needs a \"viewport\", in whose units it is; write "
		    "{\"projection\": {...}, \"viewport\": {...}}");
	else if (viewport->scale != SCALE_FILL)
		value_fault(given, "excludes the viewport's \"scale\"; omit that");
	convention_require(v, "intrinsics");
	p->section.width = viewport != NULL ? viewport->width : 0;
	p->section.height = viewport != NULL ? viewport->height : 0;
}

void projection_complete(const struct value *v, const struct viewport *viewport,
    struct projection *p)
{
	/* fit widens a parallel projection to the viewport's aspect */
	const bool widened = v->source->task == TASK_FIT && viewport != NULL &&
	    projection_family(p) == FAMILY_PARALLEL;

	if (v->unused || p->type == PROJECTION_NONE)
		return;
	if (projection_has_intrinsics(p))
		set_image_size(v, viewport, p);
	if (p->aspect[0] > 0 || (p->aspect[1] == 0 && !widened))
		return;
	if (viewport == NULL)
		value_fault(VALUE_MISSING(v, "aspect"),
		    "missing; give it, or a \"viewport\"");
	p->aspect[0] = p->aspect[1] = 1;
	if (viewport != NULL && viewport->scale != SCALE_UNIFORM) {
		p->aspect[0] = viewport->width;
		p->aspect[1] = viewport->height;
	}
}

static void print_projection(struct printer *printer, const struct member *row,
    const void *at)
{
	struct projection p = *(const struct projection *)at;
	int variant = (int)p.type - 1;
	bool sized = p.aspect[1] != 0;
	uint64_t bits = ALL_MEMBERS;
	/* members that are not printed: an aspect from the viewport, the default
	 * direction, and members that the document cannot have given */
	const struct {
		bool is_hidden;
		const char *names;
	} groups[] = {
		{ p.aspect[1] != 1, "aspect" },
		{ p.shear.direction == 45 && p.shear.direction_unit == ANGLE_DEGREES,
		    "direction" },
		{ projection_is_open(&p), "near far reverse_z" },
		{ true, p.shear.kind == OBLIQUE_ANGLE ? "kind" : "angle" },
		{ true, sized ? "half_width half_height" : "size" },
	};

	for (size_t i = 0; i < sizeof groups / sizeof *groups; i++)
		if (groups[i].is_hidden)
			bits &= ~member_bits(row->members, variant, groups[i].names);
	if (sized)
		p.volume.half_width *= 2; /* "size" is twice half_width */
	object_print(printer, row, variant, bits, &p);
}

const struct member_type type_projection = { NULL, read_projection, print_projection,
	0 };
