/* SPDX-License-Identifier: MIT */
/* The steps of a world or a camera are kept here until the next document with such a
 * list is read, and struct steps of core/scene points to them; of the world also the
 * value, which is printed as it was given, until the next document is parsed. */
#include <math.h>

#include "../../core/scene/scene.h"
#include "types.h"

_Static_assert(offsetof(struct step, kind) == 0, "rows of objects begin at kind");

/* A factor for all axes, or one for each; in the struct a double[3]. */
static bool read_factors(const struct value *v, const struct member *row, void *out)
{
	double *s = out;

	(void)row;
	if (value_is(v, JSON_ARRAY))
		return value_numbers(v, &range_any, 3, s);
	if (!value_is(v, JSON_NUMBER))
		return value_refuse_type(v, "a number or an array of 3 numbers");
	if (!value_number(v, &range_any, s))
		return false;
	s[1] = s[2] = s[0];
	return true;
}

static const struct member_type type_factors = { "number or 3 numbers", read_factors,
	NULL, .doubles = 3 };

/* Rows of tables, and their bits. The operations have the index of their STEP_... */
enum { ROTATE_AXIS, ROTATE_ANGLE };
enum { NODE_TRANSLATION, NODE_ROTATION, NODE_SCALE };
enum { STEP_VECTORS = STEP_INVERSE + 1, STEP_ROWS };

static const struct member rotate_members[] = {
	[ROTATE_AXIS] = ROW(step, "axis", type_numbers, rotation, .n = 3,
	    .about = "axis of the rotation, of any length but 0"),
	[ROTATE_ANGLE] = ROW(step, "angle", type_numbers, angle, .unit = "degrees",
	    .about = "angle of the rotation, as that of rotate_x about x"),
	{ .name = NULL },
};

static const struct rule rotate_rules[] = {
	{ WAYS(WAY(MEMBER_BIT(ROTATE_AXIS) | MEMBER_BIT(ROTATE_ANGLE))) },
	{ .n = 0 },
};

static const struct member node_members[] = {
	[NODE_TRANSLATION] = ROW(step, "translation", type_numbers, translation, .n = 3,
	    .about = "vector added to the point, after the rotation"),
	[NODE_ROTATION] = ROW(step, "rotation", type_numbers, rotation, .n = 4,
	    .about = "quaternion x, y, z, w of the rotation"),
	[NODE_SCALE] = ROW(step, "scale", type_factors, scale,
	    .about = "factor of all axes or of each, before the rotation"),
	{ .name = NULL },
};

/* A node has at least one member. */
static const struct rule node_rules[] = {
	{ WAYS(WAY(MEMBER_BIT(NODE_TRANSLATION),
		   .optional = MEMBER_BIT(NODE_ROTATION) | MEMBER_BIT(NODE_SCALE)),
	    WAY(MEMBER_BIT(NODE_ROTATION), .optional = MEMBER_BIT(NODE_SCALE)),
	    WAY(MEMBER_BIT(NODE_SCALE))) },
	{ .n = 0 },
};

static bool read_inverse(const struct value *, const struct member *, void *);

static const struct member_type type_inverse = { .name = "steps",
	.read = read_inverse };

#define ANGLE(axis)                                                       \
	ROW(step, "rotate_" axis, type_numbers, angle, .unit = "degrees", \
	    .about = "angle of a rotation about the " axis " axis")

const struct member step_members[] = {
	[STEP_TRANSLATE] = ROW(step, "translate", type_numbers, translation, .n = 3,
	    .about = "vector added to the point"),
	[STEP_SCALE] = ROW(step, "scale", type_factors, scale,
	    .about = "factor of all axes or of each, not 0"),
	[STEP_ROTATE_X] = ANGLE("x"),
	[STEP_ROTATE_Y] = ANGLE("y"),
	[STEP_ROTATE_Z] = ANGLE("z"),
	[STEP_ROTATE] = ROW(step, "rotate", type_object, kind,
	    .members = rotate_members, .rules = rotate_rules,
	    .example = "{\"axis\": [0,0,1], \"angle\": 90}",
	    .about = "\"axis\" and \"angle\" of a rotation"),
	[STEP_QUATERNION] = ROW(step, "quaternion", type_numbers, rotation, .n = 4,
	    .about = "quaternion x, y, z, w of a rotation, of any length but 0"),
	[STEP_QUATERNION_WXYZ] = ROW(step, "quaternion_wxyz", type_numbers, rotation,
	    .n = 4,
	    .about = "quaternion w, x, y, z of a rotation, of any length but 0"),
	[STEP_RVEC] = ROW(step, "rvec", type_numbers, rotation, .n = 3,
	    .unit = "radians", .about = "rotation vector, whose length is the angle"),
	[STEP_MATRIX] = ROW(step, "matrix", type_affine, matrix,
	    .about = "affine matrix"),
	[STEP_NODE] = ROW(step, "node", type_object, kind, .members = node_members,
	    .rules = node_rules,
	    .about = "\"scale\", \"rotation\" and \"translation\" of glTF"),
	[STEP_INVERSE] = ROW(step, "inverse", type_inverse, inner,
	    .about = "list of steps, inverted as a whole"),
	[STEP_VECTORS] = ROW(step, "vectors", type_flag, kind, .words = vector_names,
	    .about = "vectors that the rows of \"matrix\" are for"),
	[STEP_ROWS] = { .name = NULL },
};

const struct rule step_rules[] = {
	{ WAYS(WAY(MEMBER_BIT(STEP_TRANSLATE)), WAY(MEMBER_BIT(STEP_SCALE)),
	      WAY(MEMBER_BIT(STEP_ROTATE_X)), WAY(MEMBER_BIT(STEP_ROTATE_Y)),
	      WAY(MEMBER_BIT(STEP_ROTATE_Z)), WAY(MEMBER_BIT(STEP_ROTATE)),
	      WAY(MEMBER_BIT(STEP_QUATERNION)), WAY(MEMBER_BIT(STEP_QUATERNION_WXYZ)),
	      WAY(MEMBER_BIT(STEP_RVEC)),
	      WAY(MEMBER_BIT(STEP_MATRIX), .optional = MEMBER_BIT(STEP_VECTORS)),
	      WAY(MEMBER_BIT(STEP_NODE)), WAY(MEMBER_BIT(STEP_INVERSE))),
	    .rivals =
		"give each a step of its own: [{\"scale\": 2}, {\"rotate_z\": 90}]" },
	{ .n = 0 },
};

static const struct member step_row = { .members = step_members, .rules = step_rules };

/* The steps of the world and of the camera, and the list that is read now. */
static struct list {
	struct step step[STEPS_MAX];
	int n;
	struct value given; /* as it is in the document, to print the world's */
} lists[2], *reading;

/* Marks a step wrong of which a number is not known. An angle and a translation are
 * compared with nothing: those that are not known become 0. */
static void mark_unknown(struct step *s)
{
	double others = 0;

	if (isnan(s->angle))
		s->angle = 0;
	for (int i = 0; i < 3; i++) {
		if (isnan(s->translation[i]))
			s->translation[i] = 0;
		others += s->rotation[i] + s->scale[i];
	}
	s->is_wrong |= isnan(others + s->rotation[3]);
}

/* Reads the step v, an object with one operation, to *s. */
static void read_step(const struct value *v, struct step *s)
{
	struct found found;
	struct value m;
	object_read(v, &step_row, 0, NULL, &found);
	const uint64_t operations = found.given & ~MEMBER_BIT(STEP_VECTORS);

	s->is_wrong = operations == 0;
	/* each operation is read, though only one is allowed */
	for (uint64_t left = operations; left != 0; left &= left - 1) {
		const struct member *row = &step_members[__builtin_ctzll(left)];
		struct step other = *s;
		const int n = reading->n;

		other.kind = (unsigned)(row - step_members);
		object_member(v, row, &m);
		if (other.kind == STEP_MATRIX)
			other.is_wrong = !matrix_read_member(v, &m, row, other.matrix);
		else
			object_read_member(&m, row, &other);
		mark_unknown(&other);
		if (operations == MEMBER_BIT(other.kind))
			*s = other;
		else
			reading->n = n;
	}
	s->is_wrong |= (operations & (operations - 1)) != 0;
}

/* Reads the elements of a list. Those that are no step become wrong ones. */
static void read_list(const struct value *v)
{
	struct value e = value_child(v);

	for (; e.item != NULL && reading->n <= STEPS_MAX; value_next(&e)) {
		/* one more than there is room for, so that this is told once */
		if (reading->n++ == STEPS_MAX) {
			value_refuse(&e, "is one too many",
			    "a list has at most 64 steps, with those inside of "
			    "inverses");
			return;
		}
		struct step *s = &reading->step[reading->n - 1];

		*s = (struct step){ .rotation = { [3] = 1 }, .scale = { 1, 1, 1 } };
		if (value_is(&e, JSON_OBJECT)) {
			read_step(&e, s);
			continue;
		}
		s->is_wrong = true;
		value_refuse_type(&e,
		    "a step, an object of one operation such as {\"translate\": [0, 0, "
		    "1]},");
	}
}

static bool read_inverse(const struct value *v, const struct member *row, void *out)
{
	int n = reading->n;

	(void)row;
	if (!value_is(v, JSON_ARRAY))
		return value_refuse_type(v, "an array of steps");
	read_list(v);
	*(int *)out = reading->n - n;
	return true;
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

/* Returns the row of the operation that an object has, or NULL; not of a matrix, as
 * {"matrix": ...} is a value without a list around it. */
static const struct member *find_lone_step(const struct value *v)
{
	struct value m = value_child(v);

	for (; m.item != NULL; value_next(&m)) {
		const struct member *row = member_named(step_members, 0, m.name);

		if (row != NULL && row != &step_members[STEP_MATRIX] &&
		    row != &step_members[STEP_VECTORS])
			return row;
	}
	return NULL;
}

static bool read_steps(const struct value *v, const struct member *row, void *out)
{
	/* of the rows of steps only the world's says what a step is */
	const bool is_world = row->members == step_members;
	const struct member *lone = value_is(v, JSON_OBJECT) ? find_lone_step(v) : NULL;
	struct steps *steps = out;

	*steps = (struct steps){ .step = NULL };
	if (lone != NULL)
		return value_refuse(v, "is no list",
		    text("write a list of steps of one operation each, as they act on "
			 "the point (of an object mostly scale, rotation, "
			 "translation): [{\"%s\": ...}, ...]",
			lone->name));
	if (!value_is(v, JSON_ARRAY) || !is_list(v))
		return type_affine.read(v, row, steps->matrix);
	reading = &lists[is_world];
	reading->n = 0;
	reading->given = *v;
	read_list(v);
	*steps = (struct steps){ .step = reading->step,
		.n = reading->n,
		.unit = (enum angle_unit)v->source->unit };
	return reading->n <= STEPS_MAX;
}

static void forget_steps(void *steps)
{
	((struct steps *)steps)->is_wrong = true;
}

/* Puts a value of steps as it was given, but with the names of the rows, and without
 * members that the reader ignores. `table` has the members of the objects in it. */
static void put_step_value(struct printer *p, const struct value *v,
    const struct member *table)
{
	const bool array = value_is(v, JSON_ARRAY);
	double number;

	if (value_string(v) != NULL) {
		const int i = word_index(value_string(v), vector_names, NULL);

		put_string(p, vector_names[i]);
		return;
	}
	if (!array && !value_is(v, JSON_OBJECT)) {
		if (value_number(v, &range_any, &number))
			put_number(p, number);
		return;
	}
	put_open(p, array ? "[" : "{");
	for (struct value e = value_child(v); e.item != NULL; value_next(&e)) {
		const struct member *m = array ? NULL : member_named(table, 0, e.name);

		if (array)
			put_step_value(p, &e, table);
		else if (m != NULL)
			put_step_value(put_name(p, m->name), &e,
			    m->members != NULL ? m->members : table);
	}
	put_close(p, array ? "]" : "}");
}

/* The list is the world's, as a camera is printed by its gaze. */
static void print_steps(struct printer *p, const struct member *row, const void *at)
{
	const struct steps *steps = at;

	if (steps->step != NULL)
		put_step_value(p, &lists[true].given, step_members);
	else
		type_affine.print(p, row, steps->matrix);
}

/* A list with wrong steps is read: each step says whether it is wrong. */
const struct member_type type_steps = { "matrix or steps", read_steps, print_steps,
	.forget = forget_steps };
