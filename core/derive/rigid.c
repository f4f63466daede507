/* SPDX-License-Identifier: MIT */
#include "rigid.h"

#include "../exact/rotation.h"
#include "note.h"

/* Rows of the rotation from world to view space, and where it is. */
struct placement {
	struct sum row[3][3], eye[3], translation[3];
};

/* Sets c to -(a v), of rows or, if `transposed`, of columns. */
static void set_opposite(const struct sum a[3][3], const struct sum v[3],
    bool transposed, struct sum c[3])
{
	for (int k = 0; k < 3; k++) {
		const struct sum column[3] = { a[0][k], a[1][k], a[2][k] };

		c[k] = sum_neg(vec3_dot(transposed ? column : a[k], v));
	}
}

/* Finds the camera that a projection's matrix contains. The axes of view space are X, Y
 * and D of *u, or the opposite of Y and D. The eye of a parallel projection is the
 * origin of view space. */
static void find_split_placement(const struct lens *l, const struct upright *u,
    struct placement *f)
{
	const struct convention *c = scene_answer_convention(&l->scene);
	const bool minus[3] = { false, c->view_y_down, convention_looks_back(c) };

	for (int k = 0; k < 3; k++) {
		for (int i = 0; i < 3; i++)
			f->row[k][i] = sum_snap_zero(sum_negated_if(minus[k],
			    vec3_dot(l->to_view.m[i], u->axis[k])));
		vec3_normalise(f->row[k]);
		f->eye[k] = l->parallel ?
		    map_element(&l->to_world, 3, k) :
		    sum_quotient(l->world_eye[k], l->world_eye[3]);
	}
	set_opposite(f->row, f->eye, false, f->translation);
}

/* Finds the rotation nearest to the camera's 3x3 part. A pose is a map from view to
 * world space, and keeps its eye; others keep their translation. */
static bool find_nearest_placement(const struct lens *l, struct placement *f)
{
	struct scene s = l->scene;
	const bool is_pose = s.camera.way == CAMERA_POSE;
	struct map m;

	s.camera.orthonormalize = true;
	s.known[SPACE_WORLD][false] = s.known[SPACE_WORLD][true] = NULL;
	if (!scene_map_factor(&s, is_pose ? SPACE_VIEW : SPACE_WORLD,
		is_pose ? SPACE_WORLD : SPACE_VIEW, &m, NULL))
		return false;
	for (int k = 0; k < 3; k++) {
		for (int i = 0; i < 3; i++)
			f->row[k][i] = map_element(&m, is_pose ? k : i,
			    is_pose ? i : k);
		(is_pose ? f->eye : f->translation)[k] = map_element(&m, 3, k);
	}
	if (is_pose)
		set_opposite(f->row, f->eye, false, f->translation);
	else
		set_opposite(f->row, f->translation, true, f->eye);
	for (int k = 0; k < 3 && camera_has_eye(&s.camera); k++)
		sum_set(&f->eye[k], s.camera.eye[k]);
	return true;
}

/* Finds the scene's camera. X is negated if the answer has the other handedness.
 * Returns false if no rotation is the nearest. */
static bool find_placement(const struct lens *l, struct placement *f)
{
	const struct scene *s = &l->scene;

	if (s->has_camera && camera_gives_3x3(&s->camera)) {
		if (!find_nearest_placement(l, f))
			return false;
	} else {
		for (int i = 0; i < 9; i++)
			f->row[i / 3][i % 3] = map_element(&l->to_view, i % 3, i / 3);
		for (int k = 0; k < 3; k++) {
			f->translation[k] = map_element(&l->to_view, 3, k);
			f->eye[k] = map_element(&l->to_world, 3, k);
		}
	}
	for (int i = 0; i < 3; i++)
		f->row[0][i] = sum_negated_if(l->mirrors, f->row[0][i]);
	f->translation[0] = sum_negated_if(l->mirrors, f->translation[0]);
	return true;
}

/* Sets the rotation vector of R, whose inverse has the unit quaternion q. Its angle is
 * 2 atan2(|v|, w), where v has x, y and z. At pi both signs are R. */
static void set_rvec(const struct sum q[4], double rvec[3])
{
	const struct sum length = vec3_length(q);
	const bool half_turn = sum_sign(q[3]) == 0;

	if (sum_sign(length) == 0) {
		rvec[0] = rvec[1] = rvec[2] = 0;
		return;
	}
	const struct sum angle = sum_scale(trig_angle(length, q[3], ANGLE_RADIANS), 2);

	for (int k = 0; k < 3; k++)
		rvec[k] = sum_ratio_or_nan(sum_mul(sum_negated_if(!half_turn, q[k]),
					       angle),
		    length);
}

void rigid_of(const struct lens *l, const struct upright *u, struct rigid *r)
{
	const struct scene *s = &l->scene;
	const bool split = !s->has_camera &&
	    (projection_is_given_matrix(&s->projection) ||
		projection_has_intrinsics(&s->projection));
	struct sum to_world[3][3], q[4];
	struct placement f;

	r->exists = !(s->has_camera && note_is_no_rotation(&s->camera));
	if (r->exists && split)
		find_split_placement(l, u, &f);
	else if (r->exists)
		r->exists = find_placement(l, &f);
	if (!r->exists)
		return;
	for (int k = 0; k < 3; k++) {
		for (int i = 0; i < 3; i++) {
			r->rotation[k][i] = sum_double(f.row[k][i]);
			sum_copy(&to_world[i][k], &f.row[k][i]);
		}
		r->eye[k] = sum_ratio_or_nan(f.eye[k], sum_one);
		r->translation[k] = sum_ratio_or_nan(f.translation[k], sum_one);
	}
	rotation_quaternion(to_world, q);
	for (int k = 0; k < 4; k++)
		r->orientation[k] = sum_double(q[k]);
	set_rvec(q, r->rvec);
}
