/* SPDX-License-Identifier: MIT */
#include "convention_member.h"

#include <string.h>

#include "types.h"

const char *const convention_names[] = {
	[CONVENTION_D3D] = "d3d",
	[CONVENTION_GL] = "gl",
	[CONVENTION_VULKAN] = "vulkan",
	[CONVENTION_WEBGPU] = "webgpu",
	[CONVENTION_OPENCV] = "opencv",
	[CONVENTIONS] = NULL,
};

const char *const convention_aliases[] = {
	[CONVENTION_D3D] = "directx direct3d dx",
	[CONVENTION_GL] = "opengl",
	[CONVENTION_VULKAN] = "vk",
	[CONVENTION_WEBGPU] = "wgpu",
	[CONVENTION_OPENCV] = "cv",
};

const struct convention conventions[] = {
	[CONVENTION_D3D] = { 0 },
	[CONVENTION_GL] = { .right_handed = true,
	    .depth_minus_one = true,
	    .column_vectors = true,
	    .origin_bottom_left = true },
	[CONVENTION_VULKAN] = { .right_handed = true,
	    .column_vectors = true,
	    .ndc_y_down = true },
	[CONVENTION_WEBGPU] = { .right_handed = true, .column_vectors = true },
	[CONVENTION_OPENCV] = { .right_handed = true,
	    .view_y_down = true,
	    .column_vectors = true,
	    .ndc_y_down = true },
};

static const char *const hand_names[] = { "left", "right", NULL };
static const char *const depths[] = { "zero_to_one", "minus_one_to_one", NULL };
static const char *const origin_names[] = { "top-left", "bottom-left", NULL };

#define CHOICE(label, list, field, first, text)                 \
	ROW(convention, label, type_flag, field, .words = list, \
	    .fallback = "\"" first "\"", .about = text)

const struct member convention_members[] = {
	CHOICE("handedness", hand_names, right_handed, "left",
	    "handedness of view space"),
	CHOICE("view_y", y_names, view_y_down, "up", "direction of y in view space"),
	CHOICE("depth", depths, depth_minus_one, "zero_to_one",
	    "range of z in normalised device coordinates (ndc)"),
	CHOICE("vectors", vector_names, column_vectors, "row",
	    "form of matrices as nested rows: row for p M, column for M p"),
	CHOICE("ndc_y", y_names, ndc_y_down, "up",
	    "direction of y in clip space and ndc"),
	CHOICE("origin", origin_names, origin_bottom_left, "top-left",
	    "corner of the viewport where x and y are least"),
	{ .name = NULL },
};

static bool read_convention_member(const struct value *v, const struct member *row,
    void *out)
{
	unsigned i;

	if (value_is(v, JSON_OBJECT))
		return object_read(v, row, 0, out, NULL);
	if (!value_word(v, row->words, row->word_aliases, &i))
		return false;
	*(struct convention *)out = conventions[i];
	return true;
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

const struct member_type type_convention = { .name = "a name or an object",
	.read = read_convention_member,
	.print = print_convention_member };

void convention_require(const struct value *object, const char *name,
    const char *or_else)
{
	if (!object->unused && !object->source->has_convention)
		value_refuse(VALUE_NAMED(object, name), "needs a \"convention\"",
		    text("that of its numbers: opencv has x right, y down, z forward, "
			 "webgpu right, up, backward%s",
			or_else));
}
