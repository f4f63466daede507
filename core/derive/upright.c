/* SPDX-License-Identifier: MIT */
#include "upright.h"

/* Sets the axes to those of view space. They are turned by 180 degrees about Y if w
 * grows against the convention's gaze, and X is negated if l->mirrors. Returns false
 * if the axes do not make the map upright. */
static bool set_view_axes(const struct lens *l, struct upright *u)
{
	const struct convention *c = scene_answer_convention(&l->scene);
	const struct sum(*g)[4] = l->clip;
	bool upright = sum_sign(g[1][0]) == 0;

	u->turned = sum_sign(g[3][2]) * (convention_looks_back(c) ? -1 : 1) < 0;
	const bool minus[3] = { u->turned != l->mirrors, c->view_y_down,
		u->turned != convention_looks_back(c) };

	for (int i = 0; i < 9; i++)
		u->axis[i / 3][i % 3] = sum_of_double(i / 3 != i % 3 ? 0 :
			minus[i / 3]                                 ? -1 :
								       1);
	for (int i = 0; i < 4; i++)
		upright &= sum_sign(g[2 + i % 2][i / 2]) == 0;
	return upright && sum_sign(g[0][0]) != 0 && sum_sign(g[1][1]) != 0;
}

/* Returns whether element j of a gradient in the picture's axes is a rounding error: at
 * most l->tolerance of the greatest element. It then adds to u->residual. */
static bool neglect(const struct lens *l, const struct sum gradient[3], int j,
    struct upright *u)
{
	struct sum most = sum_abs(gradient[0]);

	for (int i = 1; i < 3; i++)
		if (sum_compare(sum_abs(gradient[i]), most) > 0)
			most = sum_abs(gradient[i]);
	if (sum_compare(sum_abs(gradient[j]), sum_scale(most, l->tolerance)) > 0)
		return false;
	if (sum_sign(gradient[j]) != 0)
		u->residual = fmax(u->residual,
		    sum_ratio_or_nan(sum_abs(gradient[j]), most));
	return true;
}

/* Finds the axes by the method of Gram and Schmidt from the gradients of clip x, y, z
 * and w: an RQ decomposition. D is along the gradient of w or, if w is constant, from
 * near to far. Y is the part of the gradient of y that is perpendicular to D. The sign
 * of X gives the camera the handedness of scene_answer_convention. */
static void find_rq_axes(const struct lens *l, struct upright *u)
{
	const struct scene *s = &l->scene;
	const struct sum(*g)[4] = l->clip, *n = g[l->parallel ? 2 : 3];
	struct sum nn = vec3_dot(n, n), yn = vec3_dot(g[1], n);
	bool negates_x = scene_answer_convention(s)->right_handed != l->mirrors;

	for (int i = 0; i < 3; i++) {
		u->axis[2][i] = sum_negated_if(l->parallel &&
			l->reversed != (sum_sign(g[3][3]) < 0),
		    n[i]);
		u->axis[1][i] = sum_minor(g[1][i], nn, n[i], yn);
	}
	vec3_normalise(u->axis[2]);
	vec3_normalise(u->axis[1]);
	vec3_cross(u->axis[1], u->axis[2], u->axis[0]);
	for (int i = 0; i < 3; i++)
		u->axis[0][i] = sum_negated_if(negates_x, u->axis[0][i]);
}

/* Sets tilted, and clears what is negligible of clip x and y. In a parallel projection
 * D is along the gradient of z. */
static void clear_negligible(const struct lens *l, struct upright *u)
{
	struct sum z[3];

	for (int j = 0; j < 3 && !l->parallel; j++)
		z[j] = vec3_dot(l->clip[2], u->axis[j]);
	for (int j = 0; j < 2 && !l->parallel; j++)
		u->tilted |= !neglect(l, z, j, u);
	for (int i = 0; i < 2; i++)
		for (int j = i + 1; j < (l->parallel ? 3 : 2); j++)
			if (neglect(l, u->clip_xy[i], j, u))
				sum_set(&u->clip_xy[i][j], 0);
}

static void set_elements(const struct lens *l, struct upright *u)
{
	for (int i = 0; i < 6; i++)
		u->clip_xy[i / 3][i % 3] = vec3_dot(l->clip[i / 3], u->axis[i % 3]);
	u->clip_w[0] = vec3_dot(l->clip[3], u->axis[2]);
}

/* Returns whether a given matrix contains a camera turned by 180 degrees: far is
 * against the gaze (if parallel), or the picture is upside down (if without_camera). */
static bool has_turned_camera(const struct lens *l, const struct upright *u)
{
	const struct projection *p = &l->scene.projection;
	int deeper = sum_sign(vec3_dot(l->clip[2], u->axis[2]));

	if (!projection_is_given_matrix(p))
		return false;
	if (l->parallel && (deeper * sum_sign(u->clip_w[1]) < 0) != l->reversed)
		return true;
	return p->without_camera && sum_sign(u->clip_xy[0][0]) < 0 &&
	    sum_sign(u->clip_xy[1][1]) < 0;
}

void upright_of(const struct lens *l, struct upright *u)
{
	const struct sum zero = sum_of_double(0);

	u->clip_xy[0][3] = l->parallel ? l->clip[0][3] : zero;
	u->clip_xy[1][3] = l->parallel ? l->clip[1][3] : zero;
	u->clip_w[1] = l->parallel ? l->clip[3][3] : zero;
	u->tilted = false;
	u->residual = 0;
	u->uses_view_axes = set_view_axes(l, u);
	set_elements(l, u);
	if (u->uses_view_axes && has_turned_camera(l, u))
		u->uses_view_axes = false;
	if (!u->uses_view_axes) {
		find_rq_axes(l, u);
		set_elements(l, u);
		/* Y is perpendicular to X by construction */
		sum_set(&u->clip_xy[1][0], 0);
	}
	/* in view axes only the elements of a given matrix may be rounding errors */
	if (!u->uses_view_axes || projection_is_given_matrix(&l->scene.projection))
		clear_negligible(l, u);
}
