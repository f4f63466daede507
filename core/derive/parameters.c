/* SPDX-License-Identifier: MIT */
#include "parameters.h"

#include <string.h>

#include "frustum.h"
#include "../exact/vec3.h"

#define NONE ((double)NAN)

/* A map from view to clip space of which z and w depend on depth alone: of a point
 * X to the right, Y upward and D along the gaze
 *	x = x X + yx Y + zx D + tx, y = y Y + zy D + ty,
 *	z = zz D + tz, w = zw D + tw,
 * all times the map's divisor, which cancels. In a perspective the gaze is where w
 * grows; turned says that this is against the convention's. leftward: X is minus that
 * of view space, as where the gaze is turned half around Y; or, for one, where the
 * answer is of the other handedness, whose camera has its x there. */
struct upright {
	struct sum x, yx, y, zx, zy, zz, zw, tx, ty, tz, tw;
	struct sum det; /* tw zz - tz zw */
	bool turned, leftward;
};

/* Whether world to view has a mirror in it where the camera is a rotation. */
static bool is_mirrored(const struct scene *s)
{
	return s->convention.right_handed != answer_convention(s)->right_handed;
}

/* False where x, y, z or w depend on what they should not. */
static bool upright_of(const struct map *map, const struct scene *s,
    struct upright *u)
{
	const struct convention *c = answer_convention(s);
	struct sum m[4][4];
	bool turned, leftward;

	memcpy(m, map->m, sizeof m);
	turned = sum_sign(m[2][3]) * (looks_back(c) ? -1 : 1) < 0;
	leftward = turned != is_mirrored(s);
	for (int j = 0; j < 4; j++) {
		m[0][j] = sum_negated_if(leftward, m[0][j]);
		m[1][j] = sum_negated_if(c->view_y_down, m[1][j]);
		m[2][j] = sum_negated_if(turned != looks_back(c), m[2][j]);
		m[j][1] = sum_negated_if(c->ndc_y_down, m[j][1]);
	}
	*u = (struct upright){ m[0][0], m[1][0], m[1][1], m[2][0], m[2][1],
		m[2][2], m[2][3], m[3][0], m[3][1], m[3][2], m[3][3],
		.turned = turned, .leftward = leftward };
	u->det = sum_minor(u->tw, u->zz, u->tz, u->zw);
	for (int i = 0; i < 2; i++)
		for (int j = i == 0 ? 1 : 2; j < 4; j++)
			if (sum_sign(m[i][j]) != 0)
				return false;
	return sum_sign(u->x) != 0 && sum_sign(u->y) != 0;
}

/* The plane of ndc depth k: D = n / d. */
struct plane {
	struct sum n, d;
};

static struct plane plane_of(const struct upright *u, double k)
{
	return (struct plane){
		sum_sub(sum_mul(sum_of_double(k), u->tw), u->tz),
		sum_sub(u->zz, sum_mul(sum_of_double(k), u->zw)),
	};
}

/* From the eye, where w = 0, it is D + tw / zw = det / (zw d): infinite, or behind
 * the eye and none. */
static double plane_distance(const struct upright *u, const struct plane *p)
{
	struct sum d = sum_mul(u->zw, p->d);

	if (sum_sign(u->zw) == 0)
		return sum_over_or_nan(p->n, p->d);
	if (sum_sign(d) == 0)
		return HUGE_VAL;
	double at = sum_over_or_nan(u->det, d);

	return at > 0 ? at : NONE;
}

/* Where a side plane x = side w meets that one, as half / scale is the side: w there
 * is det / d. */
static double side_at(const struct upright *u, const struct plane *p, int axis,
    bool minus, struct sum half, struct sum scale)
{
	struct sum z = axis == 0 ? u->zx : u->zy, t = axis == 0 ? u->tx : u->ty;
	struct sum off = sum_add(sum_mul(z, p->n), sum_mul(t, p->d));
	struct sum n = sum_minor(sum_negated_if(minus, half), u->det, scale,
	    off);
	struct sum x = axis == 0 ? u->x : u->y;

	return sum_over_or_nan(n, sum_mul(sum_mul(scale, x), p->d));
}

static void set_planes(const struct scene *s, const struct upright *u,
    const struct plane *near, struct parameters *r)
{
	struct sum half[2], scale[2];

	viewport_limits(s->has_viewport ? &s->viewport : NULL, half, scale);
	for (int k = 0; k < 4 && !isnan(r->near); k++) {
		bool minus = k < 2 ? u->leftward :
				     answer_convention(s)->view_y_down;

		r->plane[k] = side_at(u, near, k / 2, k % 2 == 0, half[k / 2],
				  scale[k / 2]) *
			(minus ? -1 : 1) +
		    0.0;
		if (k < 2 && sum_sign(u->yx) != 0)
			r->plane[k] = NONE;
	}
	struct sum wide = sum_mul(sum_mul(u->y, half[0]), scale[1]);
	struct sum high = sum_mul(sum_mul(u->x, half[1]), scale[0]);

	r->aspect = sum_over_or_nan(sum_abs(wide), sum_abs(high));
}

static const char *set_frustum_planes(const struct scene *s, double plane[6][4])
{
	struct frustum f;
	const char *why = frustum_of(s, SPACE_WORLD, false, &f);

	for (int k = 0; k < 6 && why == NULL; k++) {
		const struct map *m = k < 4 ? &f.sides.map : &f.ends.map;
		struct sum v[4];

		for (int i = 0; i < 4; i++)
			v[i] = m->m[i][k % 4];
		struct sum length = vec3_length(v);

		for (int i = 0; i < 4; i++)
			plane[k][i] = sum_sign(length) != 0 ?
			    sum_over_or_nan(v[i], length) :
			    NONE;
	}
	return why;
}

/* Whether the upper 3x3, over the divisor, times its transpose is the identity to
 * 2^-20, and it is no mirror image, or is one. */
static bool is_rotation(const struct map *m, bool mirrored)
{
	struct sum one = sum_mul(m->divisor, m->divisor);
	struct sum most = sum_mul(one, sum_of_double(0x1p-20));

	for (int i = 0; i < 9; i++) {
		struct sum a[3], b[3];

		for (int k = 0; k < 3; k++) {
			a[k] = m->m[k][i / 3];
			b[k] = m->m[k][i % 3];
		}
		struct sum off = vec3_dot(a, b);

		if (i / 3 == i % 3)
			off = sum_sub(off, one);
		if (sum_sign(sum_sub(sum_abs(off), most)) > 0)
			return false;
	}
	return sum_sign(map_minor(3, m->m, 8, 8)) == (mirrored ? -1 : 1);
}

static void set_camera_axis(const struct map *m, int j, bool minus, double v[3])
{
	struct sum a[3];

	for (int k = 0; k < 3; k++)
		a[k] = sum_negated_if(minus, m->m[k][j]);
	for (int k = 0; k < 3; k++)
		v[k] = sum_over_or_nan(a[k], vec3_length(a));
}

/* A perspective's eye is where its projectors meet. No reason can come: taxonomy_of
 * has composed both maps. */
static void set_camera(const struct scene *s, const struct upright *u,
    const struct taxonomy *t, struct parameters *r)
{
	struct camera *c = &r->scene.camera;
	const struct convention *convention = answer_convention(s);
	struct map view, back;

	scene_map(s, SPACE_WORLD, SPACE_VIEW, &view);
	scene_map(s, SPACE_VIEW, SPACE_WORLD, &back);
	*c = (struct camera){ .by = CAMERA_GAZE };
	r->scene.has_camera = true;
	r->has_scene &= is_rotation(&view, is_mirrored(s));
	for (int k = 0; k < 3; k++)
		c->eye[k] = sum_sign(u->zw) != 0 ?
		    t->eye[k] :
		    map_nearest(&back, 3, k, false);
	set_camera_axis(&view, 2, u->turned != looks_back(convention), c->at);
	set_camera_axis(&view, 1, convention->view_y_down, c->up);
}

/* As seen from the eye at distance det / (zw d): (side zw - zx) det / (zw d x). */
static double edge(const struct upright *u, const struct plane *near, int axis,
    int side)
{
	struct sum w = sum_mul(sum_of_double(side), u->zw);
	struct sum x = sum_mul(axis == 0 ? u->x : u->y,
	    sum_mul(u->zw, near->d));

	return sum_over_or_nan(sum_mul(sum_sub(w, axis == 0 ? u->zx : u->zy),
				   u->det),
	    x);
}

/* At the depth that is not sheared: (side tw - t - z plane) / x. */
static double parallel_edge(const struct upright *u, double plane, int axis,
    int side)
{
	struct sum z = axis == 0 ? u->zx : u->zy, t = axis == 0 ? u->tx : u->ty;
	struct sum off = sum_add(t, sum_mul(z, sum_of_double(plane)));

	return sum_over_or_nan(sum_sub(sum_mul(sum_of_double(side), u->tw),
				   off),
	    axis == 0 ? u->x : u->y);
}

/* x = x X + yx Y + zx D and w = zw D from the eye, x from -1 to 1 over the width; y
 * of pixels runs downward where they count from the top. */
static void set_intrinsics(const struct upright *u, const struct viewport *v,
    bool upward, struct projection *p)
{
	struct sum two = sum_add(u->zw, u->zw);
	struct sum w = sum_of_double(v->width), h = sum_of_double(v->height);
	double(*k)[4] = p->intrinsics;

	p->extent = EXTENT_INTRINSICS;
	p->width = v->width;
	p->height = v->height;
	k[0][0] = sum_over_or_nan(sum_mul(u->x, w), two);
	k[0][1] = sum_over_or_nan(sum_mul(sum_negated_if(!upward, u->yx), w),
	    two);
	k[0][2] = sum_over_or_nan(sum_mul(sum_add(u->zw, u->zx), w), two);
	k[1][1] = sum_over_or_nan(sum_mul(u->y, h), two);
	k[1][2] = sum_over_or_nan(
	    sum_mul(sum_add(u->zw, sum_negated_if(!upward, u->zy)), h), two);
	k[2][2] = 1;
}

static void set_edges(const struct upright *u, const struct plane *near,
    struct projection *p)
{
	double *const edges[4] = { &p->left, &p->right, &p->bottom, &p->top };

	p->extent = EXTENT_EDGES;
	for (int k = 0; k < 4; k++) {
		int side = k % 2 ? 1 : -1;

		*edges[k] = p->type == PROJECTION_PERSP ?
		    edge(u, near, k / 2, side) :
		    parallel_edge(u, p->plane, k / 2, side);
	}
}

/* cot cos(direction) and cot sin(direction) are zx / x and zy / y. */
static void set_shear(const struct upright *u, const struct projection *given,
    struct projection *p)
{
	bool minus = sum_sign(u->x) * sum_sign(u->y) < 0;
	struct sum x = sum_negated_if(minus, sum_mul(u->zx, u->y));
	struct sum y = sum_negated_if(minus, sum_mul(u->zy, u->x));
	struct sum both[3] = { x, y, sum_of_double(0) };

	p->type = PROJECTION_OBLIQUE;
	p->plane = 0;
	p->kind = OBLIQUE_ANGLE;
	if (given->type == PROJECTION_OBLIQUE) {
		p->plane = given->plane;
		p->kind = given->kind;
	}
	p->projector = degrees_of(sum_abs(sum_mul(u->x, u->y)),
	    vec3_length(both));
	p->direction = degrees_of(sum_abs(y), x);
	if (sum_sign(y) < 0)
		p->direction = -p->direction;
}

/* Of a perspective's two planes the nearer one is near, also where the eye lies
 * beyond far. */
static void set_projection(const struct scene *s, const struct upright *u,
    const struct plane plane[2], struct parameters *r)
{
	struct projection *p = &r->scene.projection;
	const struct projection *given = &s->projection;
	bool open = projection_is_open(given), swap = r->near > r->far;

	*p = (struct projection){ .type = PROJECTION_ORTHO,
		.near_ratio = 0.0005,
		.near = r->near,
		.far = r->far,
		.reverse_z = r->reverse_z,
		.direction = 45 };
	if (sum_sign(u->zw) != 0)
		p->type = PROJECTION_PERSP;
	else if (sum_sign(u->zx) != 0 || sum_sign(u->zy) != 0)
		set_shear(u, given, p);
	if (p->type == PROJECTION_PERSP && swap) {
		p->near = r->far;
		p->far = r->near;
		p->reverse_z = !r->reverse_z;
	}
	if (open) {
		p->near = 0;
		p->far = HUGE_VAL;
	}
	if (open || sum_sign(u->yx) != 0)
		set_intrinsics(u, &s->viewport,
		    answer_convention(s)->bottom_left, p);
	else
		set_edges(u, &plane[p->type == PROJECTION_PERSP && swap], p);
}

const char *parameters_of(const struct scene *s, const struct taxonomy *t,
    struct parameters *r)
{
	const struct convention *c = answer_convention(s);
	struct upright u;
	struct map clip;

	*r = (struct parameters){ .near = NONE,
		.far = NONE,
		.aspect = NONE,
		.reverse_z = t->reversed,
		.plane = { NONE, NONE, NONE, NONE } };
	const char *why = set_frustum_planes(s, r->frustum_plane);

	if (why == NULL)
		why = scene_map(s, SPACE_VIEW, SPACE_CLIP, &clip);
	if (why != NULL || !upright_of(&clip, s, &u))
		return why;
	double first = c->minus_one ? -1 : 0;
	struct plane plane[2] = { plane_of(&u, t->reversed ? 1 : first),
		plane_of(&u, t->reversed ? first : 1) };

	if (!projection_is_open(&s->projection)) {
		r->near = plane_distance(&u, &plane[0]);
		r->far = plane_distance(&u, &plane[1]);
	}
	set_planes(s, &u, &plane[0], r);
	r->scene = *s;
	r->scene.answer = NULL;
	r->scene.convention = *c;
	set_projection(s, &u, plane, r);
	r->has_scene = sum_sign(u.zw) != 0 || sum_sign(u.tw) > 0;
	set_camera(s, &u, t, r);
	r->has_scene &= scene_is_valid(&r->scene);
	return NULL;
}
