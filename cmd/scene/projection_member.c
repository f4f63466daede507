#include "members.h"

#include <math.h>
#include <string.h>

#include "../escape.h"

/* The largest doubles below 180 and below 1: ranges include their limits. PI and
 * its half are the largest doubles below what they stand for. */
#define BELOW_180 0x1.67fffffffffffp+7
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

#define OF(of, label, m, count, within, other)                    \
	{                                                         \
		.name = label, .read = read_numbers,              \
		.at = offsetof(struct projection, m), .n = count, \
		.range = within, .kinds = of, .aliases = other    \
	}

#define ANGLE(of, label, m, within, other)                             \
	{                                                              \
		.name = label, .read = read_angle,                     \
		.at = offsetof(struct projection, m), .range = within, \
		.kinds = of, .aliases = other                          \
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

#define FAR "a number or \"infinity\""

static void read_far(const struct value *v, const struct member *row, void *to)
{
	const char *s = value_string(v);
	char shown[ESCAPED_MAX];

	if (s != NULL && strcmp(s, "infinity") == 0)
		*(double *)to = HUGE_VAL;
	else if (s != NULL)
		value_refuse(v, "is \"%s\"; " FAR " is wanted",
		    escaped(shown, s, strlen(s)));
	else if (value_is_null(v))
		value_wrong(v, FAR);
	else
		read_numbers(v, row, to);
}

const struct member projection_members[] = {
	{ .name = "type", .read = read_type, .words = projection_types },
	OF(PERSP, "near", near, 0, &range_positive, "znear nearplane"),
	OF(PARALLEL, "near", near, 0, NULL, "znear nearplane"),
	{ .name = "far",
	    .read = read_far,
	    .at = offsetof(struct projection, far),
	    .range = &range_positive,
	    .kinds = PERSP,
	    .aliases = "zfar farplane" },
	OF(PARALLEL, "far", far, 0, NULL, "zfar farplane"),
	{ .name = "reverse_z",
	    .read = read_flag,
	    .kinds = SECTIONED,
	    .at = offsetof(struct projection, reverse_z),
	    .aliases = "reversed" },
	ANGLE(PERSP, "fovy", angle, opening,
	    "fov yfov verticalfov fieldofview cameraangley"),
	ANGLE(PERSP, "fovx", angle, opening,
	    "xfov horizontalfov hfov cameraanglex"),
	ANGLE(PERSP, "view_angle", angle, opening, "angle"),
	OF(PERSP, "field", angle, 0, &range_positive, NULL),
	OF(SECTIONED, "aspect", aspect, 0, &range_positive,
	    "ratio aspectratio"),
	OF(SECTIONED, "width", width, 0, &range_positive, NULL),
	OF(SECTIONED, "height", height, 0, &range_positive, NULL),
	OF(SECTIONED, "left", left, 0, NULL, NULL),
	OF(SECTIONED, "right", right, 0, NULL, NULL),
	OF(SECTIONED, "bottom", bottom, 0, NULL, NULL),
	OF(SECTIONED, "top", top, 0, NULL, NULL),
	OF(PERSP, "near_ratio", near_ratio, 0, &fraction, NULL),
	{ .name = "kind",
	    .read = read_kind,
	    .words = oblique_kinds,
	    .kinds = OBLIQUE },
	ANGLE(OBLIQUE, "angle", projector, slope, NULL),
	{ .name = "direction", .read = read_direction, .kinds = OBLIQUE },
	OF(OBLIQUE, "plane", plane, 0, NULL, NULL),
	OF(VOLUME, "half_width", half_width, 0, &range_positive, NULL),
	OF(VOLUME, "half_height", half_height, 0, &range_positive, NULL),
	OF(VOLUME, "z_near", z_near, 0, NULL, "near znear nearplane"),
	OF(VOLUME, "z_far", z_far, 0, NULL, "far zfar farplane"),
	OF(VOLUME, "inverse_eye_z", inverse_eye_z, 0, NULL, NULL),
	OF(VOLUME, "tan_skew", tan_skew, 2, NULL, "skew"),
	OF(VOLUME, "eye", eye, 3, NULL, NULL),
	{ .name = "matrix",
	    .read = read_matrix,
	    .kinds = MATRIX,
	    .at = offsetof(struct projection, matrix) },
	{ .name = NULL },
};

_Static_assert(sizeof projection_members / sizeof *projection_members <= 33,
    "members are bits of an unsigned");

#define SECTION_HINT                                         \
	"\"width\" and \"height\", or \"left\", \"right\", " \
	"\"bottom\" and \"top\""

static const struct ways persp_ways = {
	"give one of \"fovy\", \"fovx\", \"view_angle\" and \"field\", "
	"or " SECTION_HINT,
	{ "fovy aspect?", "fovx aspect?", "view_angle aspect?", "field aspect?",
	    "width height", "left right bottom top" },
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

static const struct ways near_ways = {
	"give it: width and height, or the edges, are on the near plane",
	{ "near far?" },
};

static const struct ways shear_ways = {
	"give \"kind\" (\"cavalier\" or \"cabinet\") or \"angle\"",
	{ "kind", "angle" },
};

static const struct ways volume_ways = {
	"give \"half_width\", \"half_height\", \"z_near\" and \"z_far\"",
	{ "half_width half_height z_near z_far" },
};

static const struct ways eye_ways = {
	"give \"eye\", or \"inverse_eye_z\" and \"tan_skew\"",
	{ "inverse_eye_z? tan_skew?", "eye" },
};

static const struct ways matrix_ways = { "give \"matrix\"", { "matrix" } };

/* Checks which members there are; returns how the cross-section is given. */
static enum extent section(const struct value *v, int type, unsigned seen)
{
	static const enum extent persp[] = { EXTENT_FOVY, EXTENT_FOVX,
		EXTENT_VIEW_ANGLE, EXTENT_FIELD, EXTENT_SIZE, EXTENT_EDGES };
	static const enum extent parallel[] = { EXTENT_SIZE, EXTENT_HEIGHT,
		EXTENT_EDGES };
	bool is_persp = type == PROJECTION_PERSP;
	bool fit = v->source->fit;
	const struct ways *ways = fit ? &fit_parallel_ways : &parallel_ways;
	int way = object_way(v, projection_members, type - 1, seen,
	    is_persp ? &persp_ways : ways);

	/* fit finds near and far, unless width, height or edges are measured
	 * on the near plane */
	if (!fit)
		object_way(v, projection_members, type - 1, seen, &depth_ways);
	else if (is_persp && persp[way] >= EXTENT_SIZE)
		object_way(v, projection_members, type - 1, seen, &near_ways);
	if (type == PROJECTION_OBLIQUE)
		object_way(v, projection_members, type - 1, seen, &shear_ways);
	return is_persp ? persp[way] : parallel[way];
}

/* Completes the aspect, a quotient: that which is given, over 1, else the
 * viewport's width over its height. aspect[1] stays 0 if fit may choose one. */
static void find_aspect(const struct value *v, const struct viewport *viewport,
    struct projection *p)
{
	struct value missing = value_missing(v, "aspect");
	bool widens = v->source->fit && p->type != PROJECTION_PERSP;

	if (v->unused)
		return;
	if (!widens && (p->extent == EXTENT_SIZE || p->extent == EXTENT_EDGES))
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
	struct value m = value_child(v), missing = value_missing(v, "type");
	char all[LISTED];

	while (m.item != NULL && strcmp(m.name, "type") != 0)
		value_next(&m);
	if (m.item != NULL)
		read_type(&m, projection_members, p);
	else if (implied != PROJECTION_NONE)
		p->type = (unsigned)implied;
	else
		value_refuse(&missing, "missing; it is %s",
		    list_words(all, projection_types, " or "));
	if (implied != PROJECTION_NONE && p->type != (unsigned)implied)
		refuse_type(&m, projection_types[p->type - 1],
		    projection_types[implied - 1]);
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

	/* fit refuses volume and matrix, whatever they have */
	if (v->source->fit && p->type > PROJECTION_OBLIQUE)
		return;
	if (p->type == PROJECTION_VOLUME) {
		object_way(v, projection_members, kind, seen, &volume_ways);
		p->has_eye = object_way(v, projection_members, kind, seen,
				 &eye_ways) == 1;
	} else if (p->type == PROJECTION_MATRIX) {
		object_way(v, projection_members, kind, seen, &matrix_ways);
	} else {
		p->extent = section(v, (int)p->type, seen);
		find_aspect(v, viewport, p);
	}
}
