/* SPDX-License-Identifier: MIT */
#include "picture.h"

/* The relative tolerance of tests for equal, zero and parallel. */
#define ALIKE 0x1p-40

static bool alike(double a, double b)
{
	return fabs(a - b) <= ALIKE * fmax(fabs(a), fabs(b));
}

static enum kind axonometric_kind(const double f[3])
{
	double most = fmax(fmax(f[0], f[1]), f[2]);
	int same = 0;

	for (int i = 0; i < 3; i++) {
		if (f[i] <= ALIKE * most)
			return KIND_MULTIVIEW;
		same += alike(f[i], f[(i + 1) % 3]);
	}
	if (same == 3)
		return KIND_ISOMETRIC;
	return same > 0 ? KIND_DIMETRIC : KIND_TRIMETRIC;
}

/* Returns the kind of an oblique projection. cot is the cotangent of the angle between
 * projectors and projection plane. */
static enum kind oblique_kind(double cot)
{
	if (alike(cot, 1))
		return KIND_CAVALIER;
	return alike(cot, 0.5) ? KIND_CABINET : KIND_GENERAL;
}

/* Sets taxon, kind and foreshortening of a parallel projection. Projectors of direction
 * d take a vector a to a - d (n . a) / (n . d) in the plane of normal n. */
static void name_parallel(const struct lens *l, struct picture *t)
{
	const struct sum *n = l->clip[2];
	struct sum d[3], across[3], v[3];

	vec3_cross(l->clip[0], l->clip[1], d);
	struct sum nd = vec3_dot(n, d), size = sum_abs(nd);

	for (int i = 0; i < 3; i++) {
		const struct sum *a = l->view.m[i];
		struct sum na = vec3_dot(n, a);

		for (int k = 0; k < 3; k++)
			v[k] = sum_snap_zero(sum_minor(a[k], nd, d[k], na));
		t->foreshortening[i] = sum_ratio_or_nan(vec3_length(v),
		    sum_mul(size, l->view.divisor));
	}
	vec3_cross(d, n, across);
	for (int k = 0; k < 3; k++)
		across[k] = sum_snap_zero(across[k]);
	double cot = sum_ratio_or_nan(vec3_length(across), size);

	t->taxon = cot <= ALIKE ? TAXON_ORTHOGRAPHIC : TAXON_OBLIQUE;
	t->kind = cot <= ALIKE ? axonometric_kind(t->foreshortening) :
				 oblique_kind(cot);
}

/* Returns the kind by the number of vanishing points: one for each world axis that is
 * not parallel to the projection plane. */
static enum kind perspective_kind(const struct lens *l)
{
	const struct sum *g = l->clip[3];
	int n = 0;

	for (int i = 0; i < 3; i++) {
		const struct sum *a = l->view.m[i];
		struct sum dot = vec3_dot(a, g);
		struct sum most = sum_mul(vec3_dot(a, a), vec3_dot(g, g));

		n += sum_compare(sum_mul(dot, dot),
			 sum_scale(most, ALIKE * ALIKE)) > 0;
	}
	if (n < 2)
		return KIND_ONE_POINT;
	return n < 3 ? KIND_TWO_POINT : KIND_THREE_POINT;
}

/* Sets the angles between the planes one x = -limit w and one x = limit w, and likewise
 * for y. The planes have the normals limit g + one a and limit g - one a, where g is
 * the gradient of w and a that of x. The tangent of their angle is the length of the
 * normals' cross product over their dot product, negated. */
static void set_fov(const struct lens *l, double fov[2])
{
	struct sum limit[2], one[2];

	view_limits(l->scene, limit, one);
	for (int k = 0; k < 2; k++) {
		struct sum g[3], a[3], v[3];

		for (int i = 0; i < 3; i++) {
			g[i] = sum_mul(limit[k], l->clip[3][i]);
			a[i] = sum_mul(one[k], l->clip[k][i]);
		}
		vec3_cross(a, g, v);
		fov[k] = trig_atan2_degrees(sum_scale(vec3_length(v), 2),
		    sum_sub(vec3_dot(a, a), vec3_dot(g, g)));
	}
}

/* Sets kind, field of view and vanishing points of a perspective. The vanishing point
 * of an axis is the image of its direction, whose fourth coordinate is 0. */
static void name_perspective(const struct lens *l, struct picture *t)
{
	const struct scene *s = l->scene;
	struct map screen = l->volume.clip, to_device;

	if (s->has_viewport) {
		viewport_map(&s->viewport, answer_convention(s), false,
		    &to_device);
		map_multiply(&screen, &to_device, false);
	}
	t->kind = perspective_kind(l);
	set_fov(l, t->fov);
	for (int i = 0; i < 3; i++) {
		struct sum h[4];

		for (int j = 0; j < 4; j++)
			sum_dot(3, l->view.m[i], &screen.m[0][j], 4, &h[j]);
		for (int k = 0; k < 2 && sum_sign(h[3]) != 0; k++)
			t->vanishing_point[i][k] = sum_ratio_or_nan(h[k], h[3]);
	}
}

/* Writes the point in world space of a homogeneous point h in view space, or nan if the
 * point does not exist. */
static void taxonomy_point(const struct lens *l, const struct sum h[4],
    bool exists, double p[3])
{
	struct sum world[4];

	for (int j = 0; j < 4; j++)
		map_image(&l->world, j, h, &world[j]);
	for (int j = 0; j < 3; j++)
		p[j] = exists ? sum_ratio_or_nan(world[j], world[3]) :
				(double)NAN;
}

void taxonomy_of(const struct lens *l, struct picture *t)
{
	const struct volume *v = &l->volume;
	struct sum far;

	map_image(&v->ends, 1, v->eye, &far);
	int side = sum_sign(far) * sum_sign(v->eye[3]);
	bool against = side < 0; /* the gaze is against the gradient */

	taxonomy_point(l, v->eye, side != 0, t->eye);
	t->taxon = against ? TAXON_REVERSE : TAXON_PERSPECTIVE;
	if (!l->parallel) {
		name_perspective(l, t);
	} else {
		name_parallel(l, t);
		against = l->reversed != (sum_sign(l->clip[3][3]) < 0);
	}
	lens_axis(l, l->clip[l->parallel ? 2 : 3], t->gaze);
	for (int k = 0; k < 3 && against; k++)
		t->gaze[k] = 0 - t->gaze[k]; /* not -0 */
	for (int i = 0; i < 8; i++)
		taxonomy_point(l, v->corner[i], sum_sign(v->corner[i][3]) > 0,
		    t->corner[i]);
}
