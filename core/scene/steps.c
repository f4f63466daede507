/* SPDX-License-Identifier: MIT */
#include "steps.h"

#include <string.h>

#include "../exact/rotation.h"

/* Appends to r the matrix with element f[i * down + j * across] in row i and column j,
 * over d. Without a fourth row it has no translation. */
static void append(struct map *r, int rows, const struct sum *f, int down, int across,
    struct sum d)
{
	struct sum image[3];

	for (int i = 0; i < 4; i++) {
		for (int j = 0; j < 3; j++)
			sum_dot(i < 3 ? 3 : rows, r->m[i], &f[j * across], down,
			    &image[j]);
		for (int j = 0; j < 3; j++)
			sum_copy(&r->m[i][j], &image[j]);
	}
	r->m[3][3] = sum_mul(r->m[3][3], d);
	map_divide(r, d);
}

static void translate(const double t[3], bool inverse, struct map *r)
{
	for (int k = 0; k < 3; k++)
		r->m[3][k] = sum_add(r->m[3][k],
		    sum_scale(r->m[3][3], inverse ? -t[k] : t[k]));
}

static const char *scale(const double s[3], bool inverse, struct map *r)
{
	if (s[0] == 0 || s[1] == 0 || s[2] == 0)
		return "its scale has a factor 0, which flattens all points";
	if (inverse && s[0] == s[1] && s[0] == s[2]) {
		r->m[3][3] = sum_scale(r->m[3][3], s[0]);
		map_divide(r, sum_of_double(s[0]));
		return NULL;
	}
	for (int k = 0; k < 3; k++)
		if (inverse)
			map_divide_column(r, k, sum_of_double(s[k]));
		else
			for (int i = 0; i < 4; i++)
				r->m[i][k] = sum_scale(r->m[i][k], s[k]);
	return NULL;
}

/* If `regular`, also refuses a singular matrix that is not inverted. The columns of the
 * inverse are cross products of the rows, over the determinant. */
static const char *multiply(const double m[4][4], bool inverse, bool regular,
    struct map *r)
{
	struct sum row[4][3], cross[3][3];

	if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1)
		return MAP_NOT_AFFINE;
	for (int i = 0; i < 12; i++)
		sum_set(&row[i / 3][i % 3], m[i / 3][i % 3]);
	for (int i = 0; i < 3 && (inverse || regular); i++)
		vec3_cross(row[(i + 1) % 3], row[(i + 2) % 3], cross[i]);
	if (inverse || regular) {
		struct sum det = vec3_dot(row[0], cross[0]);

		if (sum_sign(det) == 0)
			return "singular; it can't be inverted";
		if (inverse) {
			translate(m[3], true, r);
			append(r, 3, cross[0], 1, 3, det);
			return NULL;
		}
	}
	append(r, 4, row[0], 3, 1, sum_of_double(1));
	return NULL;
}

/* Computes the rotation about axis i, from axis i + 1 toward axis i + 2. */
static void rotate_about(int i, double angle, enum angle_unit unit, struct sum v[3][3])
{
	int j = (i + 1) % 3, k = (i + 2) % 3;

	for (int n = 0; n < 3; n++) {
		sum_set(&v[i][n], n == i);
		sum_set(&v[n][i], n == i);
	}
	trig_sin_cos(angle, unit, &v[k][j], &v[j][j]);
	sum_copy(&v[k][k], &v[j][j]);
	v[j][k] = sum_neg(v[k][j]);
}

/* Computes the rotation of a step, as the matrix v / d for column vectors. */
static const char *rotation_of(const struct step *s, enum angle_unit unit,
    struct sum v[3][3], struct sum *d)
{
	const bool w_first = s->kind == STEP_QUATERNION_WXYZ;
	struct sum q[4];

	sum_set(d, 1);
	if (s->kind == STEP_ROTATE)
		return rotation_by_angle(s->rotation, s->angle, unit, v, d) ?
		    NULL :
		    "its axis is 0, which has no direction";
	if (s->kind == STEP_RVEC)
		return rotation_about(s->rotation, v) ?
		    NULL :
		    "its rvec is longer than 2 pi; the length is the angle in radians";
	if (s->kind <= STEP_ROTATE_Z) {
		rotate_about((int)s->kind - STEP_ROTATE_X, s->angle, unit, v);
		return NULL;
	}
	for (int i = 0; i < 4; i++)
		sum_set(&q[i], s->rotation[w_first ? (i + 1) % 4 : i]);
	rotation_of_quaternion(q, v, d);
	return sum_is_exact_zero(d) ? "its quaternion is 0, which is no rotation" :
				      NULL;
}

/* The computation of a product. */
struct product {
	const struct steps *list;
	bool regular;
	const struct step *fault; /* the step that is refused */
	struct map *r;
};

/* Appends to the product a step that has no steps inside, or its inverse. */
static const char *append_step(struct product *p, const struct step *s, bool inverse)
{
	struct sum v[3][3], d;

	switch (s->kind) {
	case STEP_TRANSLATE:
		translate(s->translation, inverse, p->r);
		return NULL;
	case STEP_SCALE:
		return scale(s->scale, inverse, p->r);
	case STEP_MATRIX:
		return multiply(s->matrix, inverse, p->regular, p->r);
	default:
		break;
	}
	const char *why = rotation_of(s, p->list->unit, v, &d);

	if (why == NULL)
		append(p->r, 3, v[0], inverse ? 3 : 1, inverse ? 1 : 3, d);
	return why;
}

/* Appends a step or, of a node, its three parts in their order. */
static const char *append_parts(struct product *p, const struct step *s, bool inverse)
{
	struct step part = *s;
	const char *why = NULL;

	if (s->kind != STEP_NODE)
		why = append_step(p, s, inverse);
	for (int i = 0; i < 3 && s->kind == STEP_NODE && why == NULL; i++) {
		part.kind = (inverse ? 2 - i : i) == 0 ? STEP_SCALE :
		    i == 1                             ? STEP_QUATERNION :
							 STEP_TRANSLATE;
		why = append_step(p, &part, inverse);
	}
	if (why != NULL)
		p->fault = s;
	return why;
}

/* Appends the steps from s to `end` or, if inverse, the inverse of each from the last
 * to the first. In an inverse no matrix is singular, also if it is inverted twice. */
static const char *append_all(struct product *p, const struct step *s,
    const struct step *end, bool inverse)
{
	const char *why = NULL;

	if (s == end)
		return NULL;
	const struct step *next = s + 1 + s->inner;
	const bool regular = p->regular;

	if (inverse)
		why = append_all(p, next, end, inverse);
	p->regular |= s->kind == STEP_INVERSE;
	if (why == NULL)
		why = s->kind == STEP_INVERSE ? append_all(p, s + 1, next, !inverse) :
						append_parts(p, s, inverse);
	p->regular = regular;
	if (why == NULL && !inverse)
		why = append_all(p, next, end, inverse);
	return why;
}

static char *put(char *at, const char *s)
{
	const size_t n = strlen(s);

	memcpy(at, s, n + 1);
	return at + n;
}

/* Returns the text "POINTER/4/inverse/0: WHY", which says where `fault` stands among
 * the steps from s on, or "POINTER: WHY" without a fault. */
static const char *refusal(const char *pointer, const struct step *s,
    const struct step *fault, const char *why)
{
	static _Thread_local char text[16 * STEPS_MAX + 400];
	char *at = put(text, pointer);

	while (fault != NULL) {
		int i = 0;

		for (; fault > s + s->inner; s += 1 + s->inner)
			i++;
		*at++ = '/';
		if (i > 9)
			*at++ = (char)('0' + i / 10);
		*at++ = (char)('0' + i % 10);
		if (fault == s++)
			fault = NULL;
		else
			at = put(at, "/inverse");
	}
	put(put(at, ": "), why);
	return text;
}

const char *steps_map(const struct steps *s, const char *pointer, bool inverse,
    bool regular, struct map *r)
{
	struct product p = { s, regular, NULL, r };
	const char *why;

	if (s->step == NULL && !inverse && !regular) {
		map_of_doubles(s->matrix, r);
		return map_is_affine(r) ? NULL :
					  refusal(pointer, NULL, NULL, MAP_NOT_AFFINE);
	}
	map_identity(r);
	why = s->step == NULL ? multiply(s->matrix, inverse, regular, r) :
				append_all(&p, s->step, s->step + s->n, inverse);
	if (why == NULL && s->step != NULL && ex_has_overflowed())
		why = STEPS_TOO_WIDE;
	if (why != NULL)
		return refusal(pointer, s->step, p.fault, why);
	map_set_origin(r, s->step == NULL && inverse ? s->matrix[3] : NULL);
	return NULL;
}
