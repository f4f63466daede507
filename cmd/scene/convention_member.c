/* SPDX-License-Identifier: MIT */
#include "types.h"

#include <string.h>

/* in the order of the enum */
const char *const convention_names[] = { "d3d", "gl", "vulkan", "webgpu",
	"opencv", NULL };

const struct convention conventions[] = {
	{ 0 },
	{ .right_handed = true,
	    .minus_one = true,
	    .column = true,
	    .bottom_left = true },
	{ .right_handed = true, .column = true, .ndc_y_down = true },
	{ .right_handed = true, .column = true },
	{ .right_handed = true,
	    .view_y_down = true,
	    .column = true,
	    .ndc_y_down = true },
};

static const char *const hands[] = { "left", "right", NULL };
static const char *const depths[] = { "zero_to_one", "minus_one_to_one", NULL };
static const char *const ys[] = { "up", "down", NULL };
static const char *const origins[] = { "top-left", "bottom-left", NULL };

#define CHOICE(label, list, field, first, alias, what)          \
	ROW(convention, label, type_flag, field, .words = list, \
	    .fallback = "\"" first "\"", .aliases = alias, .about = what)

const struct member convention_members[] = {
	CHOICE("handedness", hands, right_handed, "left", "hand handed hands",
	    "handedness of view space"),
	CHOICE("view_y", ys, view_y_down, "up", "view y",
	    "direction of y in view space"),
	CHOICE("depth", depths, minus_one, "zero_to_one",
	    "clipz ndcz depthrange zrange",
	    "range of z in ndc, from near to far"),
	CHOICE("vectors", vector_names, column, "row",
	    "vector major order transpose columnmajor rowmajor",
	    "vectors of matrices, printed or read as nested rows"),
	CHOICE("ndc_y", ys, ndc_y_down, "up", "ndc clip clipy",
	    "direction of y in clip space and ndc"),
	CHOICE("origin", origins, bottom_left, "top-left", NULL,
	    "corner of the viewport where x and y are least"),
	{ .name = NULL },
};

static void read_convention_member(const struct value *v,
    const struct member *row, void *out)
{
	if (value_is(v, JSON_OBJECT))
		object_read(v, row, 0, out);
	else
		*(struct convention *)out =
		    conventions[value_word(v, row->words)];
}

/* Prints the name, or an object of the members that differ from d3d. */
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

const struct type type_convention = { "a name or an object",
	read_convention_member, print_convention_member, 0 };

void check_axes(const struct value *in, const char *name)
{
	if (!in->unused && !in->source->has_axes)
		value_refuse(VALUE_MISSING(in, name),
		    "needs a \"convention\"; of x, y and z in view space, "
		    "opencv is right, down, forward and webgpu right, up, "
		    "backward");
}
