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

/* The computation of a product. */
struct product {
	const struct steps *list;
	const char *pointer; /* to the member that has the steps */
	bool regular;
	const struct step *at; /* the step that is appended; NULL: the one matrix */
	struct map *r;
	struct refusals *faults;
};

/* Refuses the step that is appended. Its pointer is such as /camera/pose/4/inverse/0;
 * without room for it, the pointer ends at a list around the step. */
static bool refuse_step(const struct product *p, const char *what, const char *remedy)
{
	char where[sizeof(((struct refusal *)0)->where)];
	size_t n = strlen(p->pointer), most = strlen("/63/inverse");
	const struct step *s = p->list->step;

	memcpy(where, p->pointer, n);
	while (p->at != NULL && n + most < sizeof where) {
		int i = 0;

		for (; p->at > s + s->inner; s += 1 + s->inner)
			i++;
		where[n++] = '/';
		if (i > 9)
			where[n++] = (char)('0' + i / 10);
		where[n++] = (char)('0' + i % 10);
		if (p->at == s++)
			break;
		memcpy(where + n, "/inverse", strlen("/inverse"));
		n += strlen("/inverse");
	}
	where[n] = '\0';
	return refuse(p->faults, where, what, remedy);
}

static bool append_scale(struct product *p, const double s[3], bool inverse)
{
	struct map *r = p->r;

	if (s[0] == 0 || s[1] == 0 || s[2] == 0)
		return refuse_step(p,
		    "its scale has a factor 0, which flattens all points", NULL);
	if (inverse && s[0] == s[1] && s[0] == s[2]) {
		r->m[3][3] = sum_scale(r->m[3][3], s[0]);
		map_divide(r, sum_of_double(s[0]));
		return true;
	}
	for (int k = 0; k < 3; k++)
		if (inverse)
			map_divide_column(r, k, sum_of_double(s[k]));
		else
			for (int i = 0; i < 4; i++)
				r->m[i][k] = sum_scale(r->m[i][k], s[k]);
	return true;
}

/* If p->regular, also refuses a singular matrix that is not inverted. The columns of
 * the inverse are cross products of the rows, over the determinant. */
static bool append_matrix(struct product *p, const double m[4][4], bool inverse)
{
	struct sum row[4][3], cross[3][3], det = sum_one;

	if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1)
		return refuse_step(p, STEPS_NOT_AFFINE, STEPS_NOT_AFFINE_REMEDY);
	for (int i = 0; i < 12; i++)
		sum_set(&row[i / 3][i % 3], m[i / 3][i % 3]);
	for (int i = 0; i < 3 && (inverse || p->regular); i++)
		vec3_cross(row[(i + 1) % 3], row[(i + 2) % 3], cross[i]);
	if (inverse || p->regular)
		det = vec3_dot(row[0], cross[0]);
	if (sum_sign(det) == 0)
		return refuse_step(p, "singular", "it can't be inverted");
	if (inverse) {
		translate(m[3], true, p->r);
		append(p->r, 3, cross[0], 1, 3, det);
	} else {
		append(p->r, 4, row[0], 3, 1, sum_one);
	}
	return true;
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
static bool rotation_of_step(const struct product *p, const struct step *s,
    struct sum v[3][3], struct sum *d)
{
	const bool w_first = s->kind == STEP_QUATERNION_WXYZ;
	const enum angle_unit unit = p->list->unit;
	struct sum q[4];

	sum_set(d, 1);
	if (s->kind == STEP_ROTATE)
		return rotation_by_angle(s->rotation, s->angle, unit, v, d) ||
		    refuse_step(p, "its axis is 0, which has no direction", NULL);
	if (s->kind == STEP_RVEC)
		return rotation_about(s->rotation, v) ||
		    refuse_step(p, "its rvec is longer than 2 pi",
			"the length is the angle in radians");
	if (step_is_about_axis(s)) {
		rotate_about((int)s->kind - STEP_ROTATE_X, s->angle, unit, v);
		return true;
	}
	for (int i = 0; i < 4; i++)
		sum_set(&q[i], s->rotation[w_first ? (i + 1) % 4 : i]);
	rotation_of_quaternion(q, v, d);
	return !sum_is_exact_zero(d) ||
	    refuse_step(p, "its quaternion is 0, which is no rotation", NULL);
}

/* Appends to the product a step that has no steps inside, or its inverse. */
static bool append_step(struct product *p, const struct step *s, bool inverse)
{
	struct sum v[3][3], d;

	switch (s->kind) {
	case STEP_TRANSLATE:
		translate(s->translation, inverse, p->r);
		return true;
	case STEP_SCALE:
		return append_scale(p, s->scale, inverse);
	case STEP_MATRIX:
		return append_matrix(p, s->matrix, inverse);
	default:
		break;
	}
	if (!rotation_of_step(p, s, v, &d))
		return false;
	append(p->r, 3, v[0], inverse ? 3 : 1, inverse ? 1 : 3, d);
	return true;
}

/* Appends a step or, of a node, its three parts in their order. */
static bool append_parts(struct product *p, const struct step *s, bool inverse)
{
	struct step part = *s;
	bool is_right = true;

	p->at = s;
	if (s->is_wrong)
		return false;
	if (s->kind != STEP_NODE)
		return append_step(p, s, inverse);
	for (int i = 0; i < 3; i++) {
		part.kind = (inverse ? 2 - i : i) == 0 ? STEP_SCALE :
		    i == 1                             ? STEP_QUATERNION :
							 STEP_TRANSLATE;
		if (!append_step(p, &part, inverse))
			is_right = false;
	}
	return is_right;
}

/* Appends the steps from s to `end` or, if inverse, the inverse of each from the last
 * to the first. In an inverse no matrix is singular, also if it is inverted twice. */
static bool append_all(struct product *p, const struct step *s, const struct step *end,
    bool inverse)
{
	if (s == end)
		return true;
	const struct step *next = s + 1 + s->inner;
	const bool regular = p->regular;
	bool is_right = !inverse || append_all(p, next, end, inverse);

	p->regular |= s->kind == STEP_INVERSE;
	is_right &= s->kind == STEP_INVERSE ? append_all(p, s + 1, next, !inverse) :
					      append_parts(p, s, inverse);
	p->regular = regular;
	return (inverse || append_all(p, next, end, inverse)) && is_right;
}

bool steps_map(const struct steps *s, const char *pointer, bool inverse, bool regular,
    struct map *r, struct refusals *faults)
{
	struct product p = { s, pointer, regular, NULL, r, faults };

	if (s->is_wrong)
		return false;
	if (s->step == NULL && !inverse && !regular) {
		map_of_doubles(s->matrix, r);
		return map_is_affine(r) ||
		    refuse_step(&p, STEPS_NOT_AFFINE, STEPS_NOT_AFFINE_REMEDY);
	}
	map_identity(r);
	if (!(s->step == NULL ? append_matrix(&p, s->matrix, inverse) :
				append_all(&p, s->step, s->step + s->n, inverse)))
		return false;
	if (s->step != NULL && ex_has_overflowed())
		return refuse(faults, pointer, STEPS_TOO_WIDE, STEPS_TOO_WIDE_REMEDY);
	map_set_origin(r, s->step == NULL && inverse ? s->matrix[3] : NULL);
	return true;
}
