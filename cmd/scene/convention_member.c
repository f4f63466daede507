/* SPDX-License-Identifier: MIT */
#include "convention_member.h"

#include <string.h>

#include "types.h"

/* in the order of the enum that begins with CONVENTION_D3D */
const char *const convention_names[] = { "d3d", "gl", "vulkan", "webgpu", "opencv",
	NULL };

const struct convention conventions[] = {
	{ 0 },
	{ .right_handed = true,
	    .depth_minus_one = true,
	    .column_vectors = true,
	    .origin_bottom_left = true },
	{ .right_handed = true, .column_vectors = true, .ndc_y_down = true },
	{ .right_handed = true, .column_vectors = true },
	{ .right_handed = true,
	    .view_y_down = true,
	    .column_vectors = true,
	    .ndc_y_down = true },
};

static const char *const hand_names[] = { "left", "right", NULL };
static const char *const depths[] = { "zero_to_one", "minus_one_to_one", NULL };
static const char *const y_names[] = { "up", "down", NULL };
static const char *const origin_names[] = { "top-left", "bottom-left", NULL };

#define CHOICE(label, list, field, first, alias, text)          \
	ROW(convention, label, type_flag, field, .words = list, \
	    .fallback = "\"" first "\"", .aliases = alias, .about = text)

const struct member convention_members[] = {
	CHOICE("handedness", hand_names, right_handed, "left", "hand handed hands",
	    "handedness of view space"),
	CHOICE("view_y", y_names, view_y_down, "up", "view y",
	    "direction of y in view space"),
	CHOICE("depth", depths, depth_minus_one, "zero_to_one",
	    "clipz ndcz depthrange zrange",
	    "range of z in normalised device coordinates (ndc)"),
	CHOICE("vectors", vector_names, column_vectors, "row",
	    "vector matrix major order transpose columnmajor rowmajor",
	    "form of matrices as nested rows: row for p M, column for M p"),
	CHOICE("ndc_y", y_names, ndc_y_down, "up", "ndc clip clipy",
	    "direction of y in clip space and ndc"),
	CHOICE("origin", origin_names, origin_bottom_left, "top-left", NULL,
	    "corner of the viewport where x and y are least"),
	{ .name = NULL },
};

static void read_convention_member(const struct value *v, const struct member *row,
    void *out)
{
	if (value_is(v, JSON_OBJECT))
		object_read(v, row, 0, out);
	else
		*(struct convention *)out = conventions[value_word(v, row->words)];
}

/* Prints a convention's name or, if it has none, the members that differ from d3d's. */
static void print_convention_member(struct printer *p, const struct member *row,
    const void *at)
{
	for (int i = 0; i < CONVENTIONS; i++)
		if (memcmp(at, &conventions[i], sizeof *conventions) == 0) {
			put_string(p, convention_names[i]);
			return;
		}
	object_print(p, row, 0, ALL_MEMBERS, at);
}

const struct member_type type_convention = { "a name or an object",
	read_convention_member, print_convention_member, 0 };

void convention_require(const struct value *object, const char *name)
{
	if (!object->unused && !object->source->has_axes)
		value_fault(VALUE_MISSING(object, name),
		    "needs a \"convention\"; opencv has x right, y down, z forward, "
		    "webgpu right, up, backward");
}
