/* SPDX-License-Identifier: MIT */
#include "taxonomy.h"

#include <string.h>

#include "frustum.h"
#include "../exact/trig.h"

/* What is equal, zero or parallel, relative to what it is compared with. */
#define ALIKE 0x1p-40

/* The maps of a scene, and the gradients of clip x, y, z and w in view space:
 * the projectors run across those of x and y; the projection plane is across
 * that of w or, where w is constant, of z. */
struct lens {
	struct sum gradient[4][3], divisor; /* of all four */
	int w;                              /* its sign, where it is constant */
	bool parallel;
	struct sum axis[3][3];  /* the world's, in view space */
	struct sum depth[2][3]; /* clip z and w along them */
	struct sum image[3]
			[3]; /* x, y and w on the device of their directions */
	struct sum eye[4];   /* in the world, homogeneous */
};

static bool alike(double a, double b)
{
	return fabs(a - b) <= ALIKE * fmax(fabs(a), fabs(b));
}

static const char *lens_of(const struct scene *s, struct lens *l)
{
	enum space screen = s->has_viewport ? SPACE_DEVICE : SPACE_NDC;
	static const int columns[3] = { 0, 1, 3 };
	struct map m;
	const char *why;

	if ((why = scene_map(s, SPACE_VIEW, SPACE_CLIP, &m)) != NULL)
		return why;
	for (int i = 0; i < 12; i++)
		l->gradient[i % 4][i / 4] = m.m[i / 4][i % 4];
	l->divisor = m.divisor;
	l->parallel = vec3_is_zero(l->gradient[3]);
	l->w = sum_sign(m.m[3][3]);
	if ((why = scene_map(s, SPACE_WORLD, SPACE_VIEW, &m)) != NULL)
		return why;
	for (int i = 0; i < 9; i++)
		l->axis[i / 3][i % 3] = map_element(&m, i / 3, i % 3);
	if ((why = scene_map(s, SPACE_WORLD, SPACE_CLIP, &m)) != NULL)
		return why;
	for (int i = 0; i < 6; i++)
		l->depth[i % 2][i / 2] = map_element(&m, i / 2, 2 + i % 2);
	if ((why = scene_map(s, SPACE_CLIP, SPACE_WORLD, &m)) != NULL)
		return why;
	memcpy(l->eye, m.m[2], sizeof l->eye);
	if ((why = scene_map(s, SPACE_WORLD, screen, &m)) != NULL)
		return why;
	for (int i = 0; i < 9; i++)
		l->image[i / 3][i % 3] = m.m[i / 3][columns[i % 3]];
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

/* From the cotangent of the angle between projectors and plane. */
static enum kind oblique_kind(double cot)
{
	if (alike(cot, 1))
		return KIND_CAVALIER;
	return alike(cot, 0.5) ? KIND_CABINET : KIND_GENERAL;
}

/* The image of an axis a along the projectors d in the plane with normal n is a
 * - d (n a) / (n d). */
static void name_parallel(const struct lens *l, struct taxonomy *t)
{
	const struct sum *n = l->gradient[2];
	struct sum d[3], across[3], v[3];

	vec3_cross(l->gradient[0], l->gradient[1], d);
	struct sum nd = sum_abs(vec3_dot(n, d));

	for (int i = 0; i < 3; i++) {
		const struct sum *a = l->axis[i];
		struct sum na = vec3_dot(n, a);

		if (sum_sign(vec3_dot(n, d)) < 0)
			na = sum_neg(na);
		for (int k = 0; k < 3; k++)
			v[k] = sum_settled(
			    sum_sub(sum_mul(a[k], nd), sum_mul(d[k], na)));
		t->foreshortening[i] = sum_over_or_nan(vec3_length(v), nd);
	}
	vec3_cross(d, n, across);
	for (int k = 0; k < 3; k++)
		across[k] = sum_settled(across[k]);
	double cot = sum_over_or_nan(vec3_length(across), nd);

	t->taxon = cot <= ALIKE ? TAXON_ORTHOGRAPHIC : TAXON_OBLIQUE;
	t->kind = cot <= ALIKE ? axonometric_kind(t->foreshortening) :
				 oblique_kind(cot);
}

/* As many points as axes meet the projection plane: at least one. */
static enum kind perspective_kind(const struct lens *l)
{
	struct sum gradient = vec3_length(l->gradient[3]);
	int n = 0;

	for (int i = 0; i < 3; i++) {
		struct sum most = sum_mul(vec3_length(l->axis[i]), gradient);

		n += sum_over_or_nan(sum_mul(sum_abs(l->depth[1][i]),
					 l->divisor),
			 most) > ALIKE;
	}
	if (n < 2)
		return KIND_ONE_POINT;
	return n < 3 ? KIND_TWO_POINT : KIND_THREE_POINT;
}

/* Between the planes one x = -limit w and one x = limit w, of gradients limit g + one a
 * and limit g - one a: their cross product over their scalar one, negated. */
static void set_fov(const struct lens *l, const struct scene *s, double fov[2])
{
	const struct sum *g = l->gradient[3], two = sum_of_double(2);
	struct sum half[2], scale[2];

	viewport_limits(s->has_viewport ? &s->viewport : NULL, half, scale);
	for (int k = 0; k < 2; k++) {
		const struct sum *a = l->gradient[k];
		struct sum limit = half[k], one = scale[k], v[3];

		vec3_cross(a, g, v);
		struct sum y = sum_mul(sum_mul(limit, one), vec3_length(v));
		struct sum aa = sum_mul(sum_mul(one, one), vec3_dot(a, a));
		struct sum gg = sum_mul(sum_mul(limit, limit), vec3_dot(g, g));

		fov[k] = degrees_of(sum_mul(y, two), sum_sub(aa, gg));
	}
}

/* An axis's direction has no origin: it is w = 0. */
static void set_vanishing_points(const struct lens *l, double point[3][2])
{
	for (int i = 0; i < 3; i++)
		for (int k = 0; k < 2; k++)
			if (sum_sign(l->image[i][2]) != 0)
				point[i][k] = sum_over_or_nan(l->image[i][k],
				    l->image[i][2]);
}

/* A perspective is reversed where w shrinks from near to far: the eye lies beyond
 * far. */
static void name_perspective(const struct lens *l, const struct scene *s,
    struct taxonomy *t)
{
	bool falls = sum_sign(l->eye[3]) > 0;

	t->taxon = falls == t->reversed ? TAXON_PERSPECTIVE : TAXON_REVERSE;
	t->kind = perspective_kind(l);
	set_fov(l, s, t->fov);
	set_vanishing_points(l, t->vanishing_point);
}

/* From near to far: with depth, unless that is reversed, or with or against
 * w. */
static void set_gaze(const struct lens *l, const struct taxonomy *t,
    double gaze[3])
{
	bool against = l->parallel ? (l->w < 0) != t->reversed :
				     t->taxon == TAXON_REVERSE;
	struct sum n[3];

	for (int i = 0; i < 3; i++) {
		n[i] = l->depth[l->parallel ? 0 : 1][i];
		if (against)
			n[i] = sum_neg(n[i]);
	}
	for (int i = 0; i < 3; i++)
		gaze[i] = sum_over_or_nan(n[i], vec3_length(n));
}

/* A point from its homogeneous coordinates; nan where w is not positive. */
static void taxonomy_point(const struct sum h[4], double p[3])
{
	for (int j = 0; j < 3; j++)
		p[j] = sum_sign(h[3]) > 0 ? sum_over_or_nan(h[j], h[3]) :
					    (double)NAN;
}

/* Where clip x, y and w are 0. */
static void set_eye(const struct lens *l, double eye[3])
{
	struct sum h[4];

	for (int j = 0; j < 4; j++)
		h[j] = sum_sign(l->eye[3]) < 0 ? sum_neg(l->eye[j]) : l->eye[j];
	taxonomy_point(h, eye);
}

static const char *taxonomy_corners(const struct scene *s, struct taxonomy *t)
{
	struct map from_view;
	const char *why = scene_map(s, SPACE_VIEW, SPACE_WORLD, &from_view);

	for (int i = 0; i < 8 && why == NULL; i++) {
		struct sum h[4], over;

		why = view_corner(s, &from_view, i, h, &over);
		if (why == NULL)
			taxonomy_point(h, t->corner[i]);
	}
	return why;
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
	if (l.parallel)
		name_parallel(&l, t);
	else
		name_perspective(&l, s, t);
	set_gaze(&l, t, t->gaze);
	set_eye(&l, t->eye);
	return taxonomy_corners(s, t);
}
