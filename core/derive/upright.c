/* SPDX-License-Identifier: MIT */
#include "upright.h"

/* A component below this share of its vector's length counts as a rounding error. */
#define NEGLIGIBLE 0x1p-40

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

static void normalise(struct sum v[3])
{
	struct sum length = vec3_length(v);

	for (int i = 0; i < 3; i++)
		v[i] = sum_quotient(v[i], length);
}

static bool is_negligible(struct sum a, struct sum b)
{
	return sum_compare(sum_abs(a), sum_scale(sum_abs(b), NEGLIGIBLE)) <= 0;
}

/* Finds the axes by the method of Gram and Schmidt from the gradients of clip x, y, z
 * and w: an RQ decomposition. D is along the gradient of w or, if w is constant, from
 * near to far. Y is the part of the gradient of y that is perpendicular to D. The sign
 * of X gives the camera the handedness of scene_answer_convention. */
static void find_rq_axes(const struct lens *l, struct upright *u)
{
	const struct scene *s = &l->scene;
	const struct sum(*g)[4] = l->clip, *n = g[l->parallel ? 2 : 3];
	struct sum nn = vec3_dot(n, n), yn = vec3_dot(g[1], n), tilt[3];
	bool negates_x = scene_answer_convention(s)->right_handed != l->mirrors;

	for (int i = 0; i < 3; i++) {
		u->axis[2][i] = sum_negated_if(l->parallel &&
			l->reversed != (sum_sign(g[3][3]) < 0),
		    n[i]);
		u->axis[1][i] = sum_minor(g[1][i], nn, n[i], yn);
	}
	normalise(u->axis[2]);
	normalise(u->axis[1]);
	vec3_cross(u->axis[1], u->axis[2], u->axis[0]);
	for (int i = 0; i < 3; i++)
		u->axis[0][i] = sum_negated_if(negates_x, u->axis[0][i]);
	vec3_cross(g[2], g[3], tilt);
	u->tilted = !is_negligible(vec3_length(tilt),
	    sum_mul(vec3_length(g[2]), vec3_length(n)));
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
	u->uses_view_axes = set_view_axes(l, u);
	set_elements(l, u);
	if (u->uses_view_axes && !has_turned_camera(l, u))
		return;
	u->uses_view_axes = false;
	find_rq_axes(l, u);
	set_elements(l, u);
	for (int i = 0; i < 2; i++)
		for (int j = i + 1; j < (l->parallel ? 3 : 2); j++)
			if (is_negligible(u->clip_xy[i][j], u->clip_xy[i][i]))
				sum_set(&u->clip_xy[i][j], 0);
}
