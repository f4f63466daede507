/* SPDX-License-Identifier: MIT */
#include "lens.h"

const char *lens_of(const struct scene *s, struct lens *l)
{
	const char *why = volume_of(s, &l->volume);

	if (why == NULL)
		why = scene_map(s, SPACE_WORLD, SPACE_VIEW, &l->to_view);
	if (why == NULL)
		why = scene_map(s, SPACE_VIEW, SPACE_WORLD, &l->to_world);
	if (why != NULL)
		return why;
	for (int i = 0; i < 16; i++)
		l->clip[i % 4][i / 4] = sum_negated_if(i % 4 == 1 &&
			scene_answer_convention(s)->ndc_y_down,
		    l->volume.to_clip.m[i / 4][i % 4]);
	frustum_limits(s, l->half, l->scale);
	l->scene = s;
	l->mirrors = s->convention.right_handed !=
	    scene_answer_convention(s)->right_handed;
	l->parallel = vec3_is_zero(l->clip[3]);
	l->reversed = projection_is_reversed(&s->projection, &s->convention);
	return NULL;
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
