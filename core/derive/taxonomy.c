/* SPDX-License-Identifier: MIT */
#include "taxonomy.h"

/* Foreshortenings that differ by less are equal: 35.264 degrees are meant for the angle
 * of an isometric projection. The tolerance of directions is that of the lens. */
#define FORESHORTENING_TOLERANCE 0x1p-10

static bool nearly_equal(double a, double b)
{
	return fabs(a - b) <= FORESHORTENING_TOLERANCE * fmax(fabs(a), fabs(b));
}

static enum taxon_kind axonometric_kind(const double f[3], double tolerance)
{
	double most = fmax(fmax(f[0], f[1]), f[2]);
	int same = 0;

	for (int i = 0; i < 3; i++) {
		if (f[i] <= tolerance * most)
			return TAXON_MULTIVIEW;
		same += nearly_equal(f[i], f[(i + 1) % 3]);
	}
	if (same == 3)
		return TAXON_ISOMETRIC;
	return same > 0 ? TAXON_DIMETRIC : TAXON_TRIMETRIC;
}

/* Sets taxon, kind and foreshortening of a parallel projection. The projection of a
 * vector a along d onto the plane with the normal n is a - d (n . a) / (n . d). */
static void classify_parallel(const struct lens *l, struct taxonomy *t)
{
	const struct sum *n = l->clip[2];
	struct sum d[3], across[3], v[3];

	vec3_cross(l->clip[0], l->clip[1], d);
	struct sum nd = vec3_dot(n, d), size = sum_abs(nd);

	for (int i = 0; i < 3; i++) {
		const struct sum *a = l->to_view.m[i];
		struct sum na = vec3_dot(n, a);

		for (int k = 0; k < 3; k++)
			v[k] = sum_snap_zero(sum_minor(a[k], nd, d[k], na));
		t->foreshortening[i] = sum_ratio_or_nan(vec3_length(v),
		    sum_mul(size, l->to_view.divisor));
	}
	vec3_cross(d, n, across);
	for (int k = 0; k < 3; k++)
		across[k] = sum_snap_zero(across[k]);
	/* the cotangent of the angle between projectors and projection plane */
	double cot = sum_ratio_or_nan(vec3_length(across), size);

	t->taxon = cot <= l->tolerance ? TAXON_ORTHOGRAPHIC : TAXON_OBLIQUE;
	t->kind = cot <= l->tolerance ?
	    axonometric_kind(t->foreshortening, l->tolerance) :
	    nearly_equal(cot, 1)   ? TAXON_CAVALIER :
	    nearly_equal(cot, 0.5) ? TAXON_CABINET :
				     TAXON_GENERAL;
}

/* Returns the kind by the number of vanishing points: one for each world axis that is
 * not parallel to the projection plane. */
static enum taxon_kind perspective_kind(const struct lens *l)
{
	const struct sum *g = l->clip[3];
	int n = 0;

	for (int i = 0; i < 3; i++) {
		const struct sum *a = l->to_view.m[i];
		struct sum dot = vec3_dot(a, g);
		struct sum most = sum_mul(vec3_dot(a, a), vec3_dot(g, g));

		n += sum_compare(sum_mul(dot, dot),
			 sum_scale(most, l->tolerance * l->tolerance)) > 0;
	}
	return n < 2 ? TAXON_ONE_POINT : n < 3 ? TAXON_TWO_POINT : TAXON_THREE_POINT;
}

/* Sets fov[0], the angle between the planes scale x = -half w and scale x = half w, and
 * fov[1], the same angle for y. The normals of the planes are half g + scale a and half
 * g - scale a, where g and a are the gradients of w and x. The tangent of the angle is
 * the length of the normals' cross product over their negated dot product. */
static void set_fov(const struct lens *l, double fov[2])
{
	for (int k = 0; k < 2; k++) {
		struct sum g[3], a[3], v[3];

		for (int i = 0; i < 3; i++) {
			g[i] = sum_mul(l->half[k], l->clip[3][i]);
			a[i] = sum_mul(l->scale[k], l->clip[k][i]);
		}
		vec3_cross(a, g, v);
		fov[k] = trig_atan2(sum_scale(vec3_length(v), 2),
		    sum_sub(vec3_dot(a, a), vec3_dot(g, g)), ANGLE_DEGREES);
	}
}

/* Sets kind, field of view and vanishing points of a perspective. The vanishing point
 * of a world axis is the image of the axis's direction, the point x y z 0. */
static void classify_perspective(const struct lens *l, struct taxonomy *t)
{
	const struct scene *s = &l->scene;
	struct map screen;

	scene_map_factor(s, SPACE_VIEW, s->has_viewport ? SPACE_DEVICE : SPACE_NDC,
	    &screen, NULL);
	t->kind = perspective_kind(l);
	set_fov(l, t->fov);
	for (int i = 0; i < 3; i++) {
		struct sum h[4];

		for (int j = 0; j < 4; j++)
			sum_dot(3, l->to_view.m[i], &screen.m[0][j], 4, &h[j]);
		for (int k = 0; k < 2 && sum_sign(h[3]) != 0; k++)
			t->vanishing_point[i][k] = sum_ratio_or_nan(h[k], h[3]);
	}
}

static void world_point(const struct sum world[4], double p[3])
{
	for (int j = 0; j < 3; j++)
		p[j] = sum_ratio_or_nan(world[j], world[3]);
}

void taxonomy_of(const struct lens *l, struct taxonomy *t)
{
	struct sum far;

	map_image(&l->ends, 1, l->eye, &far);
	int side = sum_sign(far) * sum_sign(l->eye[3]);
	bool against = side < 0; /* the gradient of w is opposite to the gaze */

	if (side != 0)
		world_point(l->world_eye, t->eye);
	t->taxon = against ? TAXON_REVERSE : TAXON_PERSPECTIVE;
	if (!l->parallel) {
		classify_perspective(l, t);
	} else {
		classify_parallel(l, t);
		against = l->reversed != (sum_sign(l->clip[3][3]) < 0);
	}
	lens_world_axis(l, l->clip[l->parallel ? 2 : 3], t->gaze);
	for (int k = 0; k < 3 && against; k++)
		t->gaze[k] = 0 - t->gaze[k]; /* 0 does not become -0 */
	for (int i = 0; i < 8; i++)
		if (sum_sign(l->corner[i][3]) > 0)
			world_point(l->world_corner[i], t->corner[i]);
}
