/* SPDX-License-Identifier: MIT */
#include "members.h"

#include <math.h>
#include <string.h>

#include "../message/escape.h"

/* The largest doubles below 180, 90 and 1: ranges include their limits. PI and
 * its half are the largest doubles below what they stand for. */
#define BELOW_180 0x1.67fffffffffffp+7
#define BELOW_90 0x1.67fffffffffffp+6
#define BELOW_1 0x1.fffffffffffffp-1

static const struct range opening[] = {
	{ SIZE_MIN, BELOW_180,
	    "an angle above 0 and below 180 degrees is wanted" },
	{ SIZE_MIN, PI, "an angle above 0 and below pi radians is wanted" },
};
static const struct range slope[] = {
	{ SIZE_MIN, 90, "an angle above 0 and up to 90 degrees is wanted" },
	{ SIZE_MIN, PI / 2,
	    "an angle above 0 and up to pi/2 radians is wanted" },
};
static const struct range acute[] = {
	{ -BELOW_90, BELOW_90,
	    "an angle between -90 and 90 degrees is wanted" },
	{ -PI / 2, PI / 2,
	    "an angle between -pi/2 and pi/2 radians is wanted" },
};
static const struct range fraction = { SIZE_MIN, BELOW_1,
	"a number above 0 and below 1 is wanted" };

const char *const projection_types[] = { "persp", "ortho", "oblique", "volume",
	"matrix", NULL };
const char *const oblique_kinds[] = { "cavalier", "cabinet", NULL };

/* Types as bits, in the order of projection_types. */
enum {
	PERSP = 1,
	ORTHO = 2,
	OBLIQUE = 4,
	VOLUME = 8,
	MATRIX = 16,
	PARALLEL = ORTHO | OBLIQUE,
	SECTIONED = PERSP | PARALLEL, /* those with a cross-section */
};

#define OF(of, label, m, within, ...)                                  \
	{                                                              \
		.name = label, .read = read_numbers,                   \
		.at = offsetof(struct projection, m), .range = within, \
		.kinds = of, __VA_ARGS__                               \
	}

#define ANGLE(of, label, m, within, ...)                                     \
	{                                                                    \
		.name = label, .read = read_angle,                           \
		.at = offsetof(struct projection, m), .range = within,       \
		.kinds = of, .type = "angle", .unit = "degrees", __VA_ARGS__ \
	}

static void read_type(const struct value *v, const struct member *row, void *to)
{
	struct projection *p = to;

	p->type = PROJECTION_PERSP + (unsigned)value_word(v, row->words);
}

static void read_kind(const struct value *v, const struct member *row, void *to)
{
	struct projection *p = to;

	p->kind = OBLIQUE_CAVALIER + (unsigned)value_word(v, row->words);
}

/* Where it is not given it is 45 degrees in any unit. */
static void read_direction(const struct value *v, const struct member *row,
    void *to)
{
	struct projection *p = to;

	read_numbers(v, row, &p->direction);
	p->direction_unit = p->unit;
}

/* A volume may have none. */
static void read_view_angle(const struct value *v, const struct member *row,
    void *to)
{
	static const struct range taper[] = {
		{ 0, BELOW_180,
		    "an angle from 0 to below 180 degrees is wanted" },
		{ 0, PI, "an angle from 0 to below pi radians is wanted" },
	};
	struct projection *p = to;
	const struct range *range = p->type == PROJECTION_VOLUME ? taper :
								   row->range;

	p->angle = value_number(v, &range[v->source->unit]);
}

/* Of the smaller side of a volume. */
static void read_size(const struct value *v, const struct member *row, void *to)
{
	struct projection *p = to;

	p->half_width = p->half_height = value_number(v, row->range) / 2;
}

#define FAR "a number or \"infinity\""

static double read_plane(const struct value *v, const struct projection *p)
{
	bool is_persp = p->type == PROJECTION_PERSP;

	return value_number(v, is_persp ? &range_positive : &range_any);
}

static void read_near(const struct value *v, const struct member *row, void *to)
{
	struct projection *p = to;

	(void)row;
	p->near = read_plane(v, p);
}

static void read_far(const struct value *v, const struct member *row, void *to)
{
	struct projection *p = to;
	char word[NAME_ROOM], shown[ESCAPED_MAX];
	const char *s = value_string(v, word);

	(void)row;
	if (p->type != PROJECTION_PERSP)
		p->far = read_plane(v, p);
	else if (s != NULL && strcmp(s, "infinity") == 0)
		p->far = HUGE_VAL;
	else if (s != NULL)
		value_refuse(v, "is \"%s\"; " FAR " is wanted",
		    escaped(shown, s, strlen(s)));
	else if (value_is_null(v))
		value_wrong(v, FAR);
	else
		p->far = read_plane(v, p);
}

/* left, right, bottom and top. */
static void read_angles(const struct value *v, const struct member *row,
    void *to)
{
	struct projection *p = to;
	double a[4];

	value_numbers(v, &row->range[v->source->unit], 4, a);
	struct value e = value_child(v);

	for (int i = 0; i < 4; i++, value_next(&e))
		if (i % 2 && !(a[i - 1] < a[i]))
			value_refuse(&e,
			    "not greater than the one before it; the "
			    "order is left, right, bottom, top");
	p->left = a[0];
	p->right = a[1];
	p->bottom = a[2];
	p->top = a[3];
}

const struct member projection_members[] = {
	{ .name = "type",
	    .read = read_type,
	    .words = projection_types,
	    .about = "implied by the commands of these names" },
	{ .name = "near",
	    .read = read_near,
	    .kinds = SECTIONED,
	    .aliases = "znear nearplane",
	    .type = "number",
	    .unit = "view units",
	    .about = "distance of the near plane; in persp a size" },
	{ .name = "far",
	    .read = read_far,
	    .kinds = SECTIONED,
	    .aliases = "zfar farplane",
	    .type = "number",
	    .unit = "view units",
	    .about = "of the far plane; in persp a size or \"infinity\"" },
	{ .name = "reverse_z",
	    .read = read_flag,
	    .kinds = SECTIONED,
	    .at = offsetof(struct projection, reverse_z),
	    .aliases = "reversed",
	    .type = "true or false",
	    .otherwise = "false",
	    .about = "near at the greater depth" },
	ANGLE(PERSP, "fovy", angle, opening,
	    .aliases = "fov yfov verticalfov fieldofview cameraangley",
	    .about = "between the bottom and the top plane"),
	ANGLE(PERSP, "fovx", angle, opening,
	    .aliases = "xfov horizontalfov hfov cameraanglex",
	    .about = "between the left and the right plane"),
	{ .name = "view_angle",
	    .read = read_view_angle,
	    .range = opening,
	    .kinds = PERSP | VOLUME,
	    .aliases = "angle",
	    .type = "angle",
	    .unit = "degrees",
	    .about = "across the smaller side" },
	OF(PERSP, "field", angle, &range_positive,
	    .about = "half the larger side at unit distance"),
	OF(SECTIONED | VOLUME, "aspect", aspect, &range_positive,
	    .aliases = "ratio aspectratio",
	    .about = "width over height, else the viewport's"),
	OF(SECTIONED, "width", width, &range_positive, .unit = "view units",
	    .about = "of the near plane; else of the view volume"),
	OF(SECTIONED, "height", height, &range_positive, .unit = "view units",
	    .about = "of the same"),
	OF(SECTIONED, "left", left, NULL, .unit = "view units",
	    .about = "the four edges, instead of width and height"),
	OF(SECTIONED, "right", right, NULL, .unit = "view units",
	    .about = "other than left"),
	OF(SECTIONED, "bottom", bottom, NULL, .unit = "view units",
	    .about = "an edge"),
	OF(SECTIONED, "top", top, NULL, .unit = "view units",
	    .about = "other than bottom"),
	OF(PERSP, "edges_at", edges_at, &range_positive, .aliases = "distance",
	    .unit = "view units",
	    .about = "where those are measured, else near"),
	{ .name = "angles",
	    .read = read_angles,
	    .range = acute,
	    .kinds = PERSP,
	    .aliases = "angleleft angleright angleup angledown",
	    .note = "[left, right, bottom, top] from the gaze",
	    .type = "4 angles",
	    .unit = "degrees",
	    .about = "left, right, bottom, top from the gaze" },
	{ .name = "intrinsics",
	    .read = read_intrinsics,
	    .kinds = PERSP,
	    .aliases = "k fx fy cx cy flx fly focal focallength "
		       "cameramatrix projectionmatrix intrinsic p "
		       "principalpoint skew",
	    .note = "[fx, fy, cx, cy], K or P, in pixels",
	    .type = "4 numbers, K or P",
	    .unit = "device units",
	    .about = "[fx, fy, cx, cy], 3 rows of 3, or 3 rows of 4" },
	OF(PERSP | VOLUME, "near_ratio", near_ratio, &fraction,
	    .otherwise = "0.0005", .about = "of far, that fit leaves near"),
	{ .name = "kind",
	    .read = read_kind,
	    .words = oblique_kinds,
	    .kinds = OBLIQUE,
	    .about = "receding lines keep their length, or half of it" },
	ANGLE(OBLIQUE, "angle", projector, slope,
	    .about = "between projectors and picture, instead of kind"),
	{ .name = "direction",
	    .read = read_direction,
	    .kinds = OBLIQUE,
	    .type = "angle",
	    .unit = "degrees",
	    .otherwise = "45",
	    .about = "in which receding lines run" },
	OF(OBLIQUE, "plane", plane, NULL, .unit = "view units",
	    .otherwise = "0", .about = "the depth that stays where it is"),
	OF(VOLUME, "half_width", half_width, &range_positive,
	    .unit = "view units", .about = "of the rectangle at z = 0"),
	OF(VOLUME, "half_height", half_height, &range_positive,
	    .unit = "view units", .about = "of the same"),
	{ .name = "size",
	    .read = read_size,
	    .range = &range_positive,
	    .kinds = VOLUME,
	    .unit = "view units",
	    .about = "its smaller side, instead" },
	OF(VOLUME, "z_near", z_near, NULL, .aliases = "near znear nearplane",
	    .unit = "view units", .about = "z of the near plane"),
	OF(VOLUME, "z_far", z_far, NULL, .aliases = "far zfar farplane",
	    .unit = "view units", .about = "z of the far plane"),
	OF(VOLUME, "inverse_eye_z", inverse_eye_z, NULL, .otherwise = "0",
	    .about = "1/z of the eye; 0 is parallel"),
	OF(VOLUME, "tan_skew", tan_skew, NULL, .n = 2, .aliases = "skew",
	    .otherwise = "[0, 0]", .about = "x/z and y/z of the axis"),
	OF(VOLUME, "eye", eye, NULL, .n = 3, .unit = "view units",
	    .about = "the eye, instead of these two"),
	{ .name = "matrix",
	    .read = read_matrix,
	    .kinds = MATRIX,
	    .at = offsetof(struct projection, matrix),
	    .type = "matrix",
	    .about = "any from view to clip" },
	{ .name = NULL },
};

_Static_assert(sizeof projection_members / sizeof *projection_members <= 33,
    "members are bits of an unsigned");

#define SECTION_HINT                                         \
	"\"width\" and \"height\", or \"left\", \"right\", " \
	"\"bottom\" and \"top\""

static const struct ways persp_ways = {
	"give one of \"fovy\", \"fovx\", \"view_angle\" and \"field\", "
	"or " SECTION_HINT ", or \"angles\" or \"intrinsics\"",
	{ "fovy aspect?", "fovx aspect?", "view_angle aspect?", "field aspect?",
	    "width height edges_at?", "left right bottom top edges_at?",
	    "angles", "intrinsics" },
};

static const struct ways parallel_ways = {
	"give \"height\" and \"aspect\", " SECTION_HINT,
	{ "width height", "height aspect?", "left right bottom top" },
};

/* fit finds width and height; if an aspect is given, they keep to it. */
static const struct ways fit_parallel_ways = {
	"give \"aspect\" with \"height\" or without, " SECTION_HINT ", or "
	"nothing",
	{ "width? height?", "height? aspect?", "left right bottom top" },
};

static const struct ways depth_ways = {
	"give \"near\" and \"far\"",
	{ "near far" },
};

/* In the order of their way: both, or neither. */
static const struct ways open_ways = {
	"give \"near\", with \"far\" or without, or neither; \"far\" and "
	"\"reverse_z\" need it",
	{ "near far? reverse_z?", "" },
};

static const struct ways near_ways = {
	"give it: width and height, or the edges, are on the near plane, "
	"unless "
	"\"edges_at\" says where",
	{ "near far?" },
};

static const struct ways shear_ways = {
	"give \"kind\" (\"cavalier\" or \"cabinet\") or \"angle\"",
	{ "kind", "angle" },
};

static const struct ways volume_ways = {
	"give \"half_width\" and \"half_height\", or \"size\" and \"aspect\"",
	{ "half_width half_height", "size aspect?" },
};

static const struct ways volume_depth_ways = {
	"give \"z_near\" and \"z_far\"",
	{ "z_near z_far" },
};

static const struct ways eye_ways = {
	"give \"eye\", or \"inverse_eye_z\" or \"view_angle\" and "
	"\"tan_skew\"",
	{ "inverse_eye_z? tan_skew?", "eye", "view_angle tan_skew?" },
};

static const struct ways matrix_ways = { "give \"matrix\"", { "matrix" } };

/* Checks which members there are; returns how the cross-section is given. */
static enum extent section(const struct value *v, int type, unsigned seen)
{
	static const enum extent persp[] = { EXTENT_FOVY, EXTENT_FOVX,
		EXTENT_VIEW_ANGLE, EXTENT_FIELD, EXTENT_SIZE, EXTENT_EDGES,
		EXTENT_ANGLES, EXTENT_INTRINSICS };
	static const enum extent parallel[] = { EXTENT_SIZE, EXTENT_HEIGHT,
		EXTENT_EDGES };
	bool is_persp = type == PROJECTION_PERSP;
	bool fit = v->source->fit;
	const struct ways *ways = fit ? &fit_parallel_ways : &parallel_ways;
	int way = object_way(v, projection_members, type - 1, seen,
	    is_persp ? &persp_ways : ways);

	if (type == PROJECTION_OBLIQUE)
		object_way(v, projection_members, type - 1, seen, &shear_ways);
	return is_persp ? persp[way] : parallel[way];
}

/* fit finds near and far, unless the section is measured on the near plane.
 * Intrinsics may do without, or without far. */
static void find_planes(const struct value *v, unsigned seen,
    struct projection *p)
{
	const struct member *table = projection_members;
	int kind = (int)p->type - 1;

	if (v->source->fit) {
		if (projection_is_by_near(p))
			object_way(v, table, kind, seen, &near_ways);
	} else if (p->extent != EXTENT_INTRINSICS) {
		object_way(v, table, kind, seen, &depth_ways);
	} else if (object_way(v, table, kind, seen, &open_ways) == 1) {
		p->reverse_z = true;
		p->far = HUGE_VAL;
	} else if ((seen & member_bit(table, kind, "far")) == 0) {
		p->far = HUGE_VAL;
	}
}

/* Intrinsics are in units of the viewport, whose sides they need. */
static void find_sides(const struct value *v, const struct viewport *viewport,
    struct projection *p)
{
	struct value m = value_missing(v, "intrinsics");

	if (v->unused)
		return;
	if (viewport == NULL) {
		value_refuse(&m,
		    "needs a \"viewport\", in whose units it is; "
		    "write {\"projection\": {...}, \"viewport\": "
		    "{\"width\": 640, \"height\": 480}}");
	} else if (viewport->scale != SCALE_FILL) {
		value_refuse(&m,
		    "not together with the viewport's \"scale\"; "
		    "leave that out");
	} else {
		p->width = viewport->width;
		p->height = viewport->height;
	}
}

/* Completes the aspect, a quotient: that which is given, over 1, else the
 * viewport's width over its height. aspect[1] stays 0 if fit may choose one. */
static void find_aspect(const struct value *v, const struct viewport *viewport,
    struct projection *p)
{
	struct value missing = value_missing(v, "aspect");
	bool widens = v->source->fit &&
	    (p->type == PROJECTION_ORTHO || p->type == PROJECTION_OBLIQUE);

	if (v->unused)
		return;
	if (!widens && p->extent >= EXTENT_SIZE && p->extent != EXTENT_HEIGHT)
		return;
	if (widens && viewport == NULL && p->aspect[0] == 0)
		return;
	p->aspect[1] = 1;
	if (p->aspect[0] > 0)
		return;
	if (viewport == NULL) {
		value_refuse(&missing, "missing; give it, or a \"viewport\"");
	} else if (viewport->scale == SCALE_UNIFORM) {
		p->aspect[0] = 1;
	} else {
		p->aspect[0] = viewport->width;
		p->aspect[1] = viewport->height;
	}
}

static _Noreturn void refuse_type(const struct value *v, const char *is,
    const char *command)
{
	/* no command is called matrix */
	const char *other = strcmp(is, "matrix") == 0 ? "project" : is;

	value_refuse(v,
	    "\"%s\", but the command is %s; use the command %s, or "
	    "\"type\": \"%s\"",
	    is, command, other, command);
}

/* The type decides which members there are, so it is looked for first. */
static void find_type(const struct value *v, int implied, struct projection *p)
{
	struct value m, missing = value_missing(v, "type");
	char all[LISTED];

	if (value_member(v, "type", &m))
		read_type(&m, projection_members, p);
	else if (implied != PROJECTION_NONE)
		p->type = (unsigned)implied;
	else
		value_refuse(&missing, "missing; it is %s",
		    list_words(all, projection_types, " or ", "\""));
	if (implied != PROJECTION_NONE && p->type != (unsigned)implied)
		refuse_type(&m, projection_types[p->type - 1],
		    projection_types[implied - 1]);
}

/* The seven numbers of a volume, or what they are made of. fit finds its planes. */
static void read_seven(const struct value *v, unsigned seen,
    const struct viewport *viewport, struct projection *p)
{
	int kind = (int)p->type - 1;
	int section = object_way(v, projection_members, kind, seen,
	    &volume_ways);
	int eye = object_way(v, projection_members, kind, seen, &eye_ways);

	if (section == 1)
		find_aspect(v, viewport, p);
	if (!v->source->fit)
		object_way(v, projection_members, kind, seen,
		    &volume_depth_ways);
	p->has_eye = eye == 1;
	p->has_angle = eye == 2;
}

void read_projection(const struct value *v, int implied,
    const struct viewport *viewport, struct projection *p)
{
	*p = (struct projection){ .near_ratio = 0.0005,
		.direction = 45,
		.unit = (enum angle_unit)v->source->unit };
	value_want_object(v);
	find_type(v, implied, p);
	int kind = (int)p->type - 1; /* as in projection_types */
	unsigned seen = object_read(v, projection_members, kind, p);

	/* fit refuses a matrix, whatever it has */
	if (v->source->fit && p->type == PROJECTION_MATRIX)
		return;
	if (p->type == PROJECTION_VOLUME) {
		read_seven(v, seen, viewport, p);
	} else if (p->type == PROJECTION_MATRIX) {
		object_way(v, projection_members, kind, seen, &matrix_ways);
	} else {
		p->extent = section(v, (int)p->type, seen);
		find_planes(v, seen, p);
		if (p->extent == EXTENT_INTRINSICS)
			find_sides(v, viewport, p);
		else
			find_aspect(v, viewport, p);
	}
}
