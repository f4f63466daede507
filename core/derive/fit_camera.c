/* SPDX-License-Identifier: MIT */
#include "fit_camera.h"

#include <math.h>

/* The rows of view to world are the axes and the eye. Of a matrix or pose the eye
 * is its own, the axes are those of the rotation nearest to it. */
static const char *from_axes(struct camera *c,
    const struct convention *convention)
{
	double along = looks_back(convention) ? -1 : 1;
	double upward = convention->view_y_down ? -1 : 1;
	struct camera turned = *c;
	struct map back;
	const char *why = camera_map(c, convention, true, &back);

	if (why == NULL && c->by >= CAMERA_TRANSLATION)
		for (int k = 0; k < 3; k++)
			c->eye[k] = map_nearest(&back, 3, k, false);
	turned.roll = 0;
	turned.orthonormalize = true;
	if (why == NULL)
		why = camera_map(&turned, convention, true, &back);
	for (int k = 0; k < 3 && why == NULL; k++) {
		c->at[k] = along * map_nearest(&back, 2, k, false);
		c->up[k] = upward * map_nearest(&back, 1, k, false);
	}
	if (c->by >= CAMERA_POSE)
		c->roll = 0;
	return why;
}

/* at - eye, rounded; a direction may be halved, so that what a document must
 * not say it does not say. */
static void from_at(struct camera *c)
{
	double largest = 0;

	for (int k = 0; k < 3; k++) {
		c->at[k] -= c->eye[k];
		largest = fmax(largest, fabs(c->at[k]));
	}
	for (int k = 0; k < 3 && largest > MAGNITUDE_MAX; k++)
		c->at[k] /= 2;
}

const char *gaze_of(struct scene *s)
{
	struct camera *c = &s->camera;
	const struct convention *convention = &s->convention;
	struct map view;

	if (!s->has_camera)
		*c = (struct camera){ .by = CAMERA_GAZE,
			.at = { 0, 0, looks_back(convention) ? -1 : 1 },
			.up = { 0, convention->view_y_down ? -1 : 1, 0 } };
	s->has_camera = true;
	const char *why = camera_map(c, convention, false, &view);

	if (why == NULL && c->by >= CAMERA_ORIENTATION)
		why = from_axes(c, convention);
	else if (c->by == CAMERA_AT)
		from_at(c);
	c->by = CAMERA_GAZE;
	return why;
}

void eye_move(const struct map *back, const struct sum step[3], double eye[3])
{
	for (int k = 0; k < 3; k++) {
		struct sum sum = back->m[3][k];

		for (int i = 0; i < 3; i++)
			sum = sum_add(sum, sum_mul(step[i], back->m[i][k]));
		eye[k] = sum_over(sum, back->divisor);
	}
}
