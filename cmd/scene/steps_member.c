/* SPDX-License-Identifier: MIT */
/* The steps of a world or a camera are kept here until the next document with such a
 * list is read, and struct steps of core/scene points to them; of the world also the
 * value, which is printed as it was given, until the next document is parsed. */
#include "../../core/scene/scene.h"
#include "types.h"

_Static_assert(offsetof(struct step, kind) == 0, "rows of objects begin at kind");

/* A factor for all axes, or one for each; in the struct a double[3]. */
static void read_factors(const struct value *v, const struct member *row, void *out)
{
	double *s = out;

	(void)row;
	if (value_is(v, JSON_ARRAY))
		value_numbers(v, &range_any, 3, "", s);
	else if (value_is(v, JSON_NUMBER))
		s[0] = s[1] = s[2] = value_number(v, &range_any);
	else
		value_refuse_type(v, "a number or an array of 3 numbers");
}

static const struct member_type type_factors = { "number or 3 numbers", read_factors,
	NULL, 0 };

static const struct member rotate_members[] = {
	ROW(step, "axis", type_numbers, rotation, .n = 3,
	    .about = "axis of the rotation, of any length but 0"),
	ROW(step, "angle", type_numbers, angle, .unit = "degrees",
	    .about = "angle of the rotation, as that of rotate_x about x"),
	{ .name = NULL },
};

static const struct rule rotate_rules[] = { { .ways = WAYS("axis angle") },
	{ .ways = NULL } };

static const struct member node_members[] = {
	ROW(step, "translation", type_numbers, translation, .n = 3,
	    .aliases = "position localposition",
	    .about = "vector added to the point, after the rotation"),
	ROW(step, "rotation", type_numbers, rotation, .n = 4,
	    .aliases = "quaternion localrotation orientation", .hint = " (x, y, z, w)",
	    .about = "quaternion x, y, z, w of the rotation"),
	ROW(step, "scale", type_factors, scale, .aliases = "localscale",
	    .about = "factor of all axes or of each, before the rotation"),
	{ .name = NULL },
};

/* A node has at least one member. */
static const struct rule node_rules[] = {
	{ .ways = WAYS("translation rotation? scale?", "rotation scale?", "scale") },
	{ .ways = NULL },
};

static void read_inverse(const struct value *, const struct member *, void *);

static const struct member_type type_inverse = { "steps", read_inverse, NULL, 0 };

#define ANGLE(axis)                                                       \
	ROW(step, "rotate_" axis, type_numbers, angle, .unit = "degrees", \
	    .about = "angle of a rotation about the " axis " axis")

/* The operations are in the order of the enum that is the type of step.kind. */
const struct member step_members[] = {
	ROW(step, "translate", type_numbers, translation, .n = 3,
	    .about = "vector added to the point"),
	ROW(step, "scale", type_factors, scale,
	    .about = "factor of all axes or of each, not 0"),
	ANGLE("x"),
	ANGLE("y"),
	ANGLE("z"),
	ROW(step, "rotate", type_object, kind, .members = rotate_members,
	    .rules = rotate_rules, .example = "{\"axis\": [0,0,1], \"angle\": 90}",
	    .aliases = "axisangle angleaxis",
	    .about = "\"axis\" and \"angle\" of a rotation"),
	ROW(step, "quaternion", type_numbers, rotation, .n = 4,
	    .aliases = "quat q xyzw", .hint = " (x, y, z, w)",
	    .about = "quaternion x, y, z, w of a rotation, of any length but 0"),
	ROW(step, "quaternion_wxyz", type_numbers, rotation, .n = 4,
	    .aliases = "wxyz qvec", .hint = " (w, x, y, z)",
	    .about = "quaternion w, x, y, z of a rotation, of any length but 0"),
	ROW(step, "rvec", type_numbers, rotation, .n = 3, .unit = "radians",
	    .aliases = "rotationvector rodrigues",
	    .about = "rotation vector, whose length is the angle"),
	ROW(step, "matrix", type_affine, matrix, .about = "affine matrix"),
	ROW(step, "node", type_object, kind, .members = node_members,
	    .rules = node_rules,
	    .aliases = "translation rotation trs localposition "
		       "localrotation localscale",
	    .hint = ", an object with translation, rotation x, y, z, w and scale as in "
		    "glTF; if w is first, as in nuScenes, \"quaternion_wxyz\" and then "
		    "\"translate\"",
	    .about = "\"scale\", \"rotation\" and \"translation\" of glTF"),
	ROW(step, "inverse", type_inverse, inner,
	    .about = "list of steps, inverted as a whole"),
	ROW(step, "vectors", type_flag, kind, .words = vector_names,
	    .about = "vectors that the rows of \"matrix\" are for"),
	{ .name = NULL },
};

const struct rule step_rules[] = {
	{ .ways = WAYS("translate", "scale", "rotate_x", "rotate_y", "rotate_z",
	      "rotate", "quaternion", "quaternion_wxyz", "rvec", "matrix vectors?",
	      "node", "inverse"),
	    .rivals =
		"give each a step of its own: [{\"scale\": 2}, {\"rotate_z\": 90}]" },
	{ .ways = NULL },
};

static const struct member step_row = { .members = step_members, .rules = step_rules };

/* The steps of the world and of the camera, and the list that is read now. */
static struct list {
	struct step step[STEPS_MAX];
	int n;
} lists[2], *reading;

static struct value given_world;

/* Reads the step v, an object with one operation, to the step at `out`. */
static void read_step(const struct value *v, const struct member *row, void *out)
{
	struct step *s = out;
	struct value m;
	const struct found found = object_read(v, row, 0, NULL);

	if (found.given == 0)
		value_give_up(v);
	s->kind = (unsigned)__builtin_ctzll(found.given);
	const struct member *operation = &step_members[s->kind];

	if (s->kind == STEP_MATRIX) {
		type_affine.read(v, operation, s->matrix);
		return;
	}
	value_member(v, operation->name, &m);
	object_read_member(&m, operation, s);
}

static void read_list(const struct value *v)
{
	struct value e = value_child(v);

	for (; e.item != NULL; value_next(&e)) {
		if (!value_is(&e, JSON_OBJECT))
			value_refuse_type(&e,
			    "a step, an object of one operation such as "
			    "{\"translate\": [0, 0, 1]},");
		if (reading->n++ == STEPS_MAX)
			value_fault(&e,
			    "is one too many; a list has at most 64 steps, with those "
			    "inside of inverses");
		if (reading->n > STEPS_MAX)
			value_give_up(&e);
		struct step *s = &reading->step[reading->n - 1];

		*s = (struct step){ .rotation = { [3] = 1 }, .scale = { 1, 1, 1 } };
		object_attempt(read_step, &e, &step_row, s);
	}
}

static void read_inverse(const struct value *v, const struct member *row, void *out)
{
	int n = reading->n;

	(void)row;
	if (!value_is(v, JSON_ARRAY))
		value_refuse_type(v, "an array of steps");
	read_list(v);
	*(int *)out = reading->n - n;
}

/* Returns whether an array is a list of steps: it is empty, or an element is an object
 * or, where a list is wrongly in a list, an array that begins with one. */
static bool is_list(const struct value *v)
{
	struct value e = value_child(v);
	bool is = e.item == NULL;

	for (; e.item != NULL && !is; value_next(&e)) {
		const struct value first = value_count(&e) > 0 ? value_child(&e) : e;

		is = value_is(&first, JSON_OBJECT);
	}
	return is;
}

/* Refuses an object that is a step: only the list of it is a value. */
static void check_lone_step(const struct value *v)
{
	struct value m = value_child(v);

	for (; m.item != NULL; value_next(&m)) {
		const struct member *row = member_named(step_members, 0, m.name, true);

		if (row != NULL && row->offset != offsetof(struct step, matrix) &&
		    row->type != &type_flag)
			value_refuse(v,
			    "is no list; write a list of steps of one operation each, "
			    "as they act on the point (of an object mostly scale, "
			    "rotation, translation): [{\"%s\": ...}, ...]%s",
			    row->name, row->hint != NULL ? row->hint : "");
	}
}

static void read_steps(const struct value *v, const struct member *row, void *out)
{
	const bool is_world = row->offset != offsetof(struct camera, steps);
	struct steps *steps = out;

	steps->step = NULL;
	if (value_is(v, JSON_OBJECT))
		check_lone_step(v);
	if (!value_is(v, JSON_ARRAY) || !is_list(v)) {
		type_affine.read(v, row, steps->matrix);
		return;
	}
	if (is_world)
		given_world = *v;
	reading = &lists[is_world];
	reading->n = 0;
	read_list(v);
	*steps = (struct steps){ .step = reading->step,
		.n = reading->n,
		.unit = (enum angle_unit)v->source->unit };
}

/* Puts a value as it was given, but no members that the reader ignores. */
static void put_step_value(struct printer *p, const struct value *v)
{
	struct value e;
	bool array = value_is(v, JSON_ARRAY);

	if (value_is(v, JSON_NUMBER)) {
		put_number(p, value_number(v, &range_any));
	} else if (array || value_is(v, JSON_OBJECT)) {
		put_open(p, array ? "[" : "{");
		for (e = value_child(v); e.item != NULL; value_next(&e))
			if (array || (*e.name != '_' && *e.name != '$'))
				put_step_value(array ? p : put_name(p, e.name), &e);
		put_close(p, array ? "]" : "}");
	} else {
		put_string(p, value_string(v));
	}
}

static void print_steps(struct printer *p, const struct member *row, const void *at)
{
	const struct steps *steps = at;

	if (steps->step != NULL)
		put_step_value(p, &given_world);
	else
		type_affine.print(p, row, steps->matrix);
}

const struct member_type type_steps = { "matrix or steps", read_steps, print_steps, 0 };
