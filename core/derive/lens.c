/* SPDX-License-Identifier: MIT */
#include "lens.h"

/* Writes the matrix that takes a plane to the point where it meets the line of columns
 * a and b of m. Its elements are the line's Pluecker coordinates. */
static void line_of_planes(const struct map *m, int a, int b, struct sum line[4][4])
{
	/* the even permutations that begin with two rising numbers */
	static const int order[6][4] = { { 0, 1, 2, 3 }, { 0, 2, 3, 1 }, { 0, 3, 1, 2 },
		{ 1, 2, 0, 3 }, { 1, 3, 2, 0 }, { 2, 3, 0, 1 } };

	for (int n = 0; n < 6; n++) {
		const int *o = order[n];
		const struct sum *k = m->m[o[2]], *l = m->m[o[3]];

		line[o[0]][o[1]] = sum_minor(k[a], l[b], k[b], l[a]);
		line[o[1]][o[0]] = sum_neg(line[o[0]][o[1]]);
	}
	for (int i = 0; i < 4; i++)
		sum_set(&line[i][i], 0);
}

/* Writes the homogeneous point h, with w >= 0, where a line meets column c of `planes`;
 * or 0 0 0 0 if they meet in more than a point. Writes its image in
 * world space, too. */
static void set_meeting_point(const struct lens *l, const struct sum line[4][4],
    const struct map *planes, int c, struct sum h[4], struct sum world[4])
{
	struct sum w;

	for (int i = 0; i < 4; i++)
		sum_dot(4, line[i], &planes->m[0][c], 4, &h[i]);
	map_image(&l->ends, 2, h, &w);
	for (int i = 0; i < 4 && sum_sign(w) < 0; i++)
		h[i].value.sign *= -1;
	for (int i = 0; i < 4; i++)
		map_image(&l->to_world, i, h, &world[i]);
}

/* The left, right and bottom planes meet in the eye, where clip x, y and w are 0, as
 * the functions of these planes are sums of multiples of x, y and w. */
static void set_points(struct lens *l)
{
	struct sum line[4][4];

	for (int i = 0; i < 4; i++) {
		line_of_planes(&l->sides, i == 1 || i == 2, 2 + (i > 1), line);
		for (int k = i; k < 8; k += 4)
			set_meeting_point(l, line, &l->ends, k > 3, l->corner[k],
			    l->world_corner[k]);
		if (i == 0)
			set_meeting_point(l, line, &l->sides, 1, l->eye, l->world_eye);
	}
}

/* Sets to_world. A camera with an eye is a rotation, whose inverse is its transpose. */
static bool set_to_world(struct lens *l, struct refusals *faults)
{
	const struct scene *s = &l->scene;
	struct map *r = &l->to_world;

	if (!s->has_camera || !camera_has_eye(&s->camera) ||
	    camera_gives_3x3(&s->camera))
		return scene_map(s, SPACE_VIEW, SPACE_WORLD, r, faults);
	map_copy(r, &l->to_view);
	for (int i = 0; i < 9; i++)
		sum_copy(&r->m[i / 3][i % 3], &l->to_view.m[i % 3][i / 3]);
	for (int k = 0; k < 3; k++)
		r->m[3][k] = sum_scale(r->divisor, s->camera.eye[k]);
	map_set_origin(r, NULL);
	return scene_map_refuse_range(s, false, r, faults);
}

bool lens_of(const struct scene *s, struct lens *l, struct refusals *faults)
{
	const struct convention *c = scene_answer_convention(s);

	l->scene = *s;
	if (!frustum_refuse_singular(s, faults) ||
	    !scene_map(s, SPACE_VIEW, SPACE_CLIP, &l->to_clip, faults) ||
	    !scene_map(s, SPACE_WORLD, SPACE_VIEW, &l->to_view, faults) ||
	    !set_to_world(l, faults))
		return false;
	l->scene.known[SPACE_WORLD][false] = &l->to_view;
	l->scene.known[SPACE_WORLD][true] = &l->to_world;
	l->scene.known[SPACE_VIEW][false] = &l->to_clip;
	if (!frustum_planes(&l->scene, SPACE_VIEW, &l->sides, &l->ends, faults))
		return false;
	for (int i = 0; i < 16; i++)
		l->clip[i % 4][i / 4] = sum_negated_if(i % 4 == 1 && c->ndc_y_down,
		    l->to_clip.m[i / 4][i % 4]);
	frustum_limits(s, l->half, l->scale);
	l->tolerance = projection_tolerance(&s->projection);
	l->mirrors = (s->convention.right_handed != c->right_handed) !=
	    (s->has_camera && camera_mirrors(&s->camera, &s->convention));
	l->parallel = vec3_is_zero(l->clip[3]);
	l->reversed = projection_is_reversed(&s->projection, &s->convention);
	set_points(l);
	return true;
}

void lens_world_axis(const struct lens *l, const struct sum axis[3], double unit[3])
{
	struct sum a[3];

	for (int k = 0; k < 3; k++)
		a[k] = sum_snap_zero(vec3_dot(l->to_view.m[k], axis));
	struct sum length = vec3_length(a);

	for (int k = 0; k < 3; k++)
		unit[k] = sum_ratio_or_nan(a[k], length);
}
