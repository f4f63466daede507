#include "taxonomy.h"

#include "frustum.h"
#include "trig.h"
#include "vec3.h"

/* What is equal, zero or parallel, relative to what it is compared with. */
#define ALIKE 0x1p-40

#define DEGREE 57.29577951308232

/* The maps of a scene, and the gradients of clip x, y, z and w in view space:
 * the projectors run across those of x and y; the projection plane is across
 * that of w or, where w is constant, of z. */
struct lens {
	struct map view, clip, device; /* from the world */
	struct map back;               /* from clip to world */
	ex gradient[4][3];
	double w; /* where it is constant */
	bool parallel;
};

static bool alike(double a, double b)
{
	return fabs(a - b) <= ALIKE * fmax(fabs(a), fabs(b));
}

static double or_nan(double a)
{
	return isfinite(a) ? a : (double)NAN;
}

static const char *lens_of(const struct scene *s, struct lens *l)
{
	const struct {
		enum space from, to;
		struct map *map;
	} wanted[] = {
		{ SPACE_WORLD, SPACE_VIEW, &l->view },
		{ SPACE_WORLD, SPACE_CLIP, &l->clip },
		{ SPACE_CLIP, SPACE_WORLD, &l->back },
		{ SPACE_WORLD, s->has_viewport ? SPACE_DEVICE : SPACE_NDC,
		    &l->device },
	};
	struct map clip;
	const char *why = scene_map(s, SPACE_VIEW, SPACE_CLIP, &clip);

	for (int i = 0; i < 4 && why == NULL; i++)
		why = scene_map(s, wanted[i].from, wanted[i].to, wanted[i].map);
	if (why != NULL)
		return why;
	l->parallel = true;
	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 4; j++)
			l->gradient[j][i] = ex_dd(clip.m[i][j]);
		l->parallel &= clip.m[i][3].hi == 0;
	}
	l->w = clip.m[AT_ZERO][3].hi;
	return NULL;
}

static void axis_of(const struct lens *l, int i, ex axis[3])
{
	for (int k = 0; k < 3; k++)
		axis[k] = ex_dd(l->view.m[i][k]);
}

static enum kind axonometric(const double f[3])
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
static enum kind oblique(double cot)
{
	if (alike(cot, 1))
		return KIND_CAVALIER;
	return alike(cot, 0.5) ? KIND_CABINET : KIND_GENERAL;
}

/* The image of an axis a along the projectors d in the plane with normal n is a
 * - d (n a) / (n d). Its error is below 2^-96 |a| |d| |n| / |n d|: the elements
 * are within MAP_BOUND u^2. */
static void name_parallel(const struct lens *l, struct taxonomy *t)
{
	const ex *n = l->gradient[2];
	ex d[3], across[3], a[3], v[3];

	vec3_cross(l->gradient[0], l->gradient[1], d);
	ex nd = vec3_dot(n, d), least = ex_mul(vec3_length(n), vec3_length(d));

	least = ex_shift(least, -96);
	for (int i = 0; i < 3; i++) {
		axis_of(l, i, a);
		ex na = vec3_dot(n, a);

		for (int k = 0; k < 3; k++)
			v[k] = ex_sub(ex_mul(a[k], nd), ex_mul(d[k], na));
		ex size = vec3_length(v), lost = ex_mul(least, vec3_length(a));

		if (ex_sign(ex_sub(size, lost)) <= 0)
			size = (ex){ 0 };
		t->foreshortening[i] = or_nan(ex_div(size, ex_abs(nd)).hi);
	}
	vec3_cross(d, n, across);
	double cot = ex_div(vec3_length(across), ex_abs(nd)).hi;

	t->taxon = cot <= ALIKE ? TAXON_ORTHOGRAPHIC : TAXON_OBLIQUE;
	t->kind = cot <= ALIKE ? axonometric(t->foreshortening) : oblique(cot);
}

/* As many points as axes meet the projection plane: at least one. */
static enum kind points(const struct lens *l)
{
	int n = 0;

	for (int i = 0; i < 3; i++) {
		ex a[3], most;

		axis_of(l, i, a);
		most = ex_mul(vec3_length(a), vec3_length(l->gradient[3]));
		n += ex_div(ex_abs(ex_dd(l->clip.m[i][3])), most).hi > ALIKE;
	}
	if (n < 2)
		return KIND_ONE_POINT;
	return n < 3 ? KIND_TWO_POINT : KIND_THREE_POINT;
}

/* The angle whose tangent is y / x, for y > 0. Corrected by the rest, the
 * tangent of less than 2^-50 of it. */
static double degrees(ex y, ex x)
{
	ex most = ex_sign(ex_sub(y, ex_abs(x))) > 0 ? y : ex_abs(x);
	dd s = ex_div(y, most), c = ex_div(x, most);
	double a = atan2(s.hi, c.hi) * DEGREE;
	ex sa = sin_deg(a), ca = cos_deg(a);
	ex over = ex_sub(ex_mul(ex_dd(s), ca), ex_mul(ex_dd(c), sa));
	ex under = ex_add(ex_mul(ex_dd(c), ca), ex_mul(ex_dd(s), sa));

	return a + ex_div(over, under).hi * DEGREE;
}

/* Between the planes x = -limit w and x = limit w, of gradients limit g + a and
 * limit g - a: their cross product over their scalar one, negated. */
static void set_fov(const struct lens *l, const struct scene *s, double fov[2])
{
	const ex *g = l->gradient[3];
	dd limit[2] = { { 1, 0 }, { 1, 0 } };

	if (s->has_viewport)
		viewport_limits(&s->viewport, limit);
	for (int k = 0; k < 2; k++) {
		const ex *a = l->gradient[k];
		ex v[3], lim = ex_dd(limit[k]);

		vec3_cross(a, g, v);
		ex y = ex_scale(ex_mul(lim, vec3_length(v)), 2);
		ex gg = ex_mul(ex_mul(lim, lim), vec3_dot(g, g));

		fov[k] = degrees(y, ex_sub(vec3_dot(a, a), gg));
	}
}

/* An axis's direction has no origin: it is w = 0. */
static void set_vanishing_points(const struct lens *l, double point[3][2])
{
	for (int i = 0; i < 3; i++)
		for (int k = 0; k < 2; k++) {
			dd x = l->device.m[i][k], w = l->device.m[i][3];

			if (w.hi != 0)
				point[i][k] = or_nan(
				    ex_div(ex_dd(x), ex_dd(w)).hi);
		}
}

/* Depth grows with w where clip z is negative at the eye. A matrix doesn't say
 * whether its depth is reversed: it is taken to be where w grows along the
 * convention's gaze and depth falls. */
static void name_perspective(const struct lens *l, const struct scene *s,
    struct taxonomy *t)
{
	bool grows = l->back.m[2][3].hi <= 0;
	int w_along_z = ex_sign(l->gradient[3][2]);

	if (s->projection.type == PROJECTION_MATRIX)
		t->reversed = !grows &&
		    w_along_z == (s->convention.right_handed ? -1 : 1);
	t->taxon = grows == t->reversed ? TAXON_REVERSE : TAXON_PERSPECTIVE;
	t->kind = points(l);
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
	ex n[3];

	for (int i = 0; i < 3; i++)
		n[i] = ex_dd(l->clip.m[i][l->parallel ? 2 : 3]);
	for (int i = 0; i < 3; i++)
		gaze[i] =
		    ex_div(against ? ex_neg(n[i]) : n[i], vec3_length(n)).hi;
}

/* A point from its homogeneous coordinates; nan where w is not positive. */
static void set_point(const struct ex_sum h[4], double p[3])
{
	double bound = MAP_BOUND * 0x1p-106;

	for (int j = 0; j < 3; j++) {
		p[j] = (double)NAN;
		if (!(ex_round(h[3].value).hi > bound * h[3].size))
			continue;
		p[j] = or_nan(ex_div(h[j].value, h[3].value).hi);
		if (fabs(ex_round(h[j].value).hi) <= bound * h[j].size)
			p[j] = 0;
	}
}

/* Where clip x, y and w are 0. */
static void set_eye(const struct lens *l, double eye[3])
{
	const dd *m = l->back.m[2];
	struct ex_sum h[4];

	for (int j = 0; j < 4; j++)
		h[j] = (struct ex_sum){
			ex_dd(m[3].hi < 0 ? dd_neg(m[j]) : m[j]),
			l->back.sum[2][j],
		};
	set_point(h, eye);
}

const char *taxonomy_of(const struct scene *s, struct taxonomy *t)
{
	struct lens l;
	const char *why = lens_of(s, &l);
	const double none = (double)NAN;

	if (why != NULL)
		return why;
	*t = (struct taxonomy){
		.reversed = s->projection.reverse_z,
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
	for (int i = 0; i < 8; i++) {
		struct ex_sum h[4];

		view_corner(s, &l.back, t->reversed, i, h);
		set_point(h, t->corner[i]);
	}
	return NULL;
}
