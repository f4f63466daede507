/* SPDX-License-Identifier: MIT */
#include "taxonomy.h"

#include "frustum.h"
#include "../exact/trig.h"

/* Relative tolerance of equal, zero and parallel. */
#define ALIKE 0x1p-40

/* The gradients of clip x, y, z and w in view space. Parallel projectors are
 * perpendicular to the gradients of x and y. The projection plane is perpendicular to
 * the gradient of w or, if w is constant, of z. */
struct lens {
	struct sum gradient[4][3];
	bool parallel;
	struct map to_view;   /* from the world; rows are the world's axes */
	struct map to_screen; /* from the world */
	struct volume volume; /* in the world */
};

static bool alike(double a, double b)
{
	return fabs(a - b) <= ALIKE * fmax(fabs(a), fabs(b));
}

static const char *lens_of(const struct scene *s, struct lens *l)
{
	enum space screen = s->has_viewport ? SPACE_DEVICE : SPACE_NDC;
	struct map clip;
	const char *why = scene_map(s, SPACE_VIEW, SPACE_CLIP, &clip);

	if (why == NULL)
		why = scene_map(s, SPACE_WORLD, SPACE_VIEW, &l->to_view);
	if (why == NULL)
		why = volume_of(s, SPACE_WORLD, &l->volume);
	if (why == NULL)
		why = scene_map(s, SPACE_WORLD, screen, &l->to_screen);
	if (why != NULL)
		return why;
	for (int i = 0; i < 12; i++)
		l->gradient[i % 4][i / 4] = clip.m[i / 4][i % 4];
	l->parallel = vec3_is_zero(l->gradient[3]);
	return NULL;
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

/* Returns the kind by the cotangent of the angle between projectors and plane. */
static enum kind oblique_kind(double cot)
{
	if (alike(cot, 1))
		return KIND_CAVALIER;
	return alike(cot, 0.5) ? KIND_CABINET : KIND_GENERAL;
}

/* Sets taxon, kind and foreshortening of a parallel projection. Projectors of direction d
 * take an axis a to a - d (n a) / (n d) in the plane of normal n. */
static void name_parallel(const struct lens *l, struct taxonomy *t)
{
	const struct sum *n = l->gradient[2];
	struct sum d[3], across[3], v[3];

	vec3_cross(l->gradient[0], l->gradient[1], d);
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
	double cot = sum_ratio_or_nan(vec3_length(across), size);

	t->taxon = cot <= ALIKE ? TAXON_ORTHOGRAPHIC : TAXON_OBLIQUE;
	t->kind = cot <= ALIKE ? axonometric_kind(t->foreshortening) :
				 oblique_kind(cot);
}

/* Counts the vanishing points: one for each world axis that meets the projection
 * plane. */
static enum kind perspective_kind(const struct lens *l)
{
	const struct sum *g = l->gradient[3];
	struct sum gradient = vec3_length(g);
	int n = 0;

	for (int i = 0; i < 3; i++)
		n += sum_ratio_or_nan(sum_abs(vec3_dot(l->to_view.m[i], g)),
			 sum_mul(vec3_length(l->to_view.m[i]), gradient)) >
		    ALIKE;
	if (n < 2)
		return KIND_ONE_POINT;
	return n < 3 ? KIND_TWO_POINT : KIND_THREE_POINT;
}

/* Sets the angle between the planes one x = -limit w and one x = limit w. Their normals
 * are limit g + one a and limit g - one a, with the gradients g of w and a of x. Its
 * tangent is the length of their cross product over their dot product, negated. */
static void set_fov(const struct lens *l, const struct scene *s, double fov[2])
{
	struct sum limit[2], one[2];

	viewport_limits(s->has_viewport ? &s->viewport : NULL, limit, one);
	for (int k = 0; k < 2; k++) {
		struct sum g[3], a[3], v[3];

		for (int i = 0; i < 3; i++) {
			g[i] = sum_mul(limit[k], l->gradient[3][i]);
			a[i] = sum_mul(one[k], l->gradient[k][i]);
		}
		vec3_cross(a, g, v);
		fov[k] = trig_degrees(sum_scale(vec3_length(v), 2),
		    sum_sub(vec3_dot(a, a), vec3_dot(g, g)));
	}
}

/* Sets taxon, kind, field of view and vanishing points of a perspective. The vanishing
 * point of an axis is the image of its direction, whose fourth coordinate is 0. */
static void name_perspective(const struct lens *l, const struct scene *s,
    bool beyond_far, struct taxonomy *t)
{
	t->taxon = beyond_far ? TAXON_REVERSE : TAXON_PERSPECTIVE;
	t->kind = perspective_kind(l);
	set_fov(l, s, t->fov);
	for (int i = 0; i < 3; i++) {
		const struct sum *m = l->to_screen.m[i];

		for (int k = 0; k < 2 && sum_sign(m[3]) != 0; k++)
			t->vanishing_point[i][k] = sum_ratio_or_nan(m[k], m[3]);
	}
}

/* Writes the unit normal of the projection plane, along the gradient of w or z or, if
 * against, opposite to it. */
static void set_gaze(const struct lens *l, bool against, double gaze[3])
{
	struct sum n[3];

	for (int i = 0; i < 3; i++)
		n[i] = sum_negated_if(against,
		    vec3_dot(l->to_view.m[i],
			l->gradient[l->parallel ? 2 : 3]));
	for (int i = 0; i < 3; i++)
		gaze[i] = sum_ratio_or_nan(n[i], vec3_length(n));
}

/* Writes the point of homogeneous coordinates h, or nan if the point does not exist. */
static void taxonomy_point(const struct sum h[4], bool exists, double p[3])
{
	for (int j = 0; j < 3; j++)
		p[j] = exists ? sum_ratio_or_nan(h[j], h[3]) : (double)NAN;
}

const char *taxonomy_of(const struct scene *s, struct taxonomy *t)
{
	struct lens l;
	const char *why = lens_of(s, &l);
	const double none = (double)NAN;

	if (why != NULL)
		return why;
	*t = (struct taxonomy){
		.reversed = projection_is_reversed(&s->projection,
		    &s->convention),
		.foreshortening = { none, none, none },
		.vanishing_point = { { none, none }, { none, none },
		    { none, none } },
		.fov = { none, none },
	};
	struct sum h[4];
	int side = volume_eye(&l.volume, h);

	taxonomy_point(h, side != 0, t->eye);
	if (l.parallel)
		name_parallel(&l, t);
	else
		name_perspective(&l, s, side < 0, t);
	bool behind = sum_sign(l.volume.ends.m[3][2]) < 0;

	set_gaze(&l,
	    l.parallel ? behind != t->reversed : t->taxon == TAXON_REVERSE,
	    t->gaze);
	for (int i = 0; i < 8; i++) {
		volume_corner(&l.volume, i, h);
		taxonomy_point(h, sum_sign(h[3]) > 0, t->corner[i]);
	}
	return NULL;
}
