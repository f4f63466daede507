/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include <string.h>

/* A component of a vector below this share of the vector's length counts as a rounding
 * error of the given numbers. */
#define NEGLIGIBLE 0x1p-40

/* The map from view to clip space, in axes X, Y and D that make it upright: clip y and
 * w do not depend on X, nor w on Y. X is to the right, Y upward, and D along the gaze.
 * Clip coordinates are
 *
 *	x = xy[0][0] X + xy[0][1] Y + xy[0][2] D + xy[0][3],
 *	y = xy[1][1] Y + xy[1][2] D + xy[1][3], w = w[0] D + w[1],
 *
 * all times the map's divisor, which cancels. In a perspective w grows along D, and D
 * is 0 at the eye, so xy[0][3], xy[1][3] and w[1] are 0. */
struct upright {
	struct sum xy[2][4], w[2];
	struct sum axis[3][3]; /* X, Y and D in view space */
	bool uses_view_axes;   /* if not, find_rq_axes finds the axes */
	bool turned;           /* w grows against the convention's gaze */
	bool tilted;           /* z depends on X or Y */
};

/* Returns whether the handedness of answer_convention is not the document's. The map
 * from world to view space then mirrors. */
static bool is_mirrored(const struct scene *s)
{
	return s->convention.right_handed != answer_convention(s)->right_handed;
}

/* Sets the axes to those of view space. They are turned by 180 degrees about Y if w
 * grows against the convention's gaze, and X is negated if is_mirrored. Returns false
 * if the axes do not make the map upright. */
static bool set_view_axes(const struct lens *l, struct upright *u)
{
	const struct convention *c = answer_convention(l->scene);
	const struct sum(*g)[4] = l->clip;
	bool upright = sum_sign(g[1][0]) == 0;

	u->turned = sum_sign(g[3][2]) * (convention_looks_back(c) ? -1 : 1) < 0;
	const bool minus[3] = { u->turned != is_mirrored(l->scene),
		c->view_y_down, u->turned != convention_looks_back(c) };

	for (int i = 0; i < 9; i++)
		u->axis[i / 3][i % 3] = sum_of_double(i / 3 != i % 3 ? 0 :
			minus[i / 3]                                 ? -1 :
								       1);
	for (int i = 0; i < 4; i++)
		upright &= sum_sign(g[2 + i % 2][i / 2]) == 0;
	return upright && sum_sign(g[0][0]) != 0 && sum_sign(g[1][1]) != 0;
}

static void normalise(struct sum v[3])
{
	struct sum length = vec3_length(v);

	for (int i = 0; i < 3; i++)
		v[i] = sum_quotient(v[i], length);
}

static bool is_negligible(struct sum a, struct sum b)
{
	return sum_compare(sum_abs(a), sum_scale(sum_abs(b), NEGLIGIBLE)) <= 0;
}

/* Finds the axes by the method of Gram and Schmidt from the gradients of clip x, y, z
 * and w: an RQ decomposition. D is along the gradient of w or, if w is constant, from
 * near to far. Y is the part of the gradient of y that is perpendicular to D. The sign
 * of X gives the camera the handedness of answer_convention. */
static void find_rq_axes(const struct lens *l, struct upright *u)
{
	const struct scene *s = l->scene;
	const struct sum(*g)[4] = l->clip, *n = g[l->parallel ? 2 : 3];
	struct sum nn = vec3_dot(n, n), yn = vec3_dot(g[1], n), tilt[3];
	bool negates_x = answer_convention(s)->right_handed != is_mirrored(s);

	for (int i = 0; i < 3; i++) {
		u->axis[2][i] = sum_negated_if(l->parallel &&
			l->reversed != (sum_sign(g[3][3]) < 0),
		    n[i]);
		u->axis[1][i] = sum_minor(g[1][i], nn, n[i], yn);
	}
	normalise(u->axis[2]);
	normalise(u->axis[1]);
	vec3_cross(u->axis[1], u->axis[2], u->axis[0]);
	for (int i = 0; i < 3; i++)
		u->axis[0][i] = sum_negated_if(negates_x, u->axis[0][i]);
	vec3_cross(g[2], g[3], tilt);
	u->tilted = !is_negligible(vec3_length(tilt),
	    sum_mul(vec3_length(g[2]), vec3_length(n)));
}

static void set_elements(const struct lens *l, struct upright *u)
{
	for (int i = 0; i < 6; i++)
		u->xy[i / 3][i % 3] = vec3_dot(l->clip[i / 3], u->axis[i % 3]);
	u->w[0] = vec3_dot(l->clip[3], u->axis[2]);
}

/* Returns whether a PROJECTION_MATRIX contains a camera turned by 180 degrees: far is
 * against the gaze (if parallel), or the picture is upside down (if without_camera). */
static bool has_turned_camera(const struct lens *l, const struct upright *u)
{
	const struct projection *p = &l->scene->projection;
	int deeper = sum_sign(vec3_dot(l->clip[2], u->axis[2]));

	if (p->type != PROJECTION_MATRIX)
		return false;
	if (l->parallel && (deeper * sum_sign(u->w[1]) < 0) != l->reversed)
		return true;
	return p->without_camera && sum_sign(u->xy[0][0]) < 0 &&
	    sum_sign(u->xy[1][1]) < 0;
}

static void upright_of(const struct lens *l, struct upright *u)
{
	*u = (struct upright){ 0 };
	if (l->parallel) {
		u->xy[0][3] = l->clip[0][3];
		u->xy[1][3] = l->clip[1][3];
		u->w[1] = l->clip[3][3];
	}
	u->uses_view_axes = set_view_axes(l, u);
	set_elements(l, u);
	if (u->uses_view_axes && !has_turned_camera(l, u))
		return;
	u->uses_view_axes = false;
	find_rq_axes(l, u);
	set_elements(l, u);
	for (int i = 0; i < 2; i++)
		for (int j = i + 1; j < (l->parallel ? 3 : 2); j++)
			if (is_negligible(u->xy[i][j], u->xy[i][i]))
				u->xy[i][j] = sum_of_double(0);
}

/* Sets the aspect. If the axes are those of view space, sets near_edge from two
 * opposite corners of the near plane. */
static void set_near_edges(const struct lens *l, const struct upright *u,
    struct picture *r)
{
	const struct sum *half = l->half, *scale = l->scale;

	for (int k = 0; k < 4 && u->uses_view_axes && !isnan(r->near); k++) {
		const struct sum *h = l->volume.corner[k % 2 == 0 ? 0 : 2];

		if (k >= 2 || sum_sign(u->xy[0][1]) == 0)
			r->near_edge[k] = sum_ratio_or_nan(h[k / 2], h[3]);
	}
	struct sum wide = sum_mul(sum_mul(u->xy[1][1], half[0]), scale[1]);
	struct sum high = sum_mul(sum_mul(u->xy[0][0], half[1]), scale[0]);

	/* if high is 0, the picture is a line */
	if (sum_sign(high) != 0)
		r->aspect = sum_ratio_or_nan(sum_abs(wide), sum_abs(high));
}

static void set_frustum_planes(const struct lens *l, double plane[6][4])
{
	for (int k = 0; k < 6; k++) {
		struct sum v[4];

		for (int i = 0; i < 4; i++)
			map_image(k < 4 ? &l->volume.sides : &l->volume.ends,
			    k % 4, l->to_view.m[i], &v[i]);
		struct sum length = vec3_length(v);

		for (int i = 0; i < 4 && sum_sign(length) != 0; i++)
			plane[k][i] = sum_ratio_or_nan(v[i], length);
	}
}

/* Returns whether R R' is the identity within 2^-20, and det R > 0 (if mirrored, < 0).
 * R is the upper 3x3 of the map over the divisor, R' its transpose. */
static bool is_rotation(const struct map *m, bool mirrored)
{
	struct sum one = sum_mul(m->divisor, m->divisor);
	struct sum most = sum_scale(one, 0x1p-20);

	for (int i = 0; i < 9; i++) {
		struct sum off = vec3_dot(m->m[i / 3], m->m[i % 3]);

		if (i / 3 == i % 3)
			off = sum_sub(off, one);
		if (sum_compare(sum_abs(off), most) > 0)
			return false;
	}
	return sum_sign(map_minor(3, m->m, 8, 8)) == (mirrored ? -1 : 1);
}

/* Sets the camera. The eye of a perspective is the point where its projectors meet. */
static void set_camera(const struct lens *l, const struct upright *u,
    struct picture *r)
{
	struct camera *c = &r->scene.camera;

	*c = (struct camera){ .kind = CAMERA_GAZE };
	r->scene.has_camera = true;
	for (int k = 0; k < 3; k++)
		c->eye[k] = l->parallel ?
		    map_nearest(&l->to_world, 3, k, false) :
		    r->eye[k];
	lens_axis(l, u->axis[2], c->at);
	lens_axis(l, u->axis[1], c->up);
}

/* Computes K of struct picture from half and scale (the margin is 0 here). In pixels
 * from the viewport's corner, clip x becomes half + scale x / w to the right, and clip
 * y half + scale y / w upward or, if pixels count from the top, half - scale y / w
 * downward. The axes of K are X of *u, or -X if is_mirrored, Y of *u, or -Y if pixels
 * count from the top, and the gaze. */
static void set_intrinsics(const struct lens *l, const struct upright *u,
    double k[3][3])
{
	const struct scene *s = l->scene;
	bool down = !answer_convention(s)->origin_bottom_left;
	const bool minus[3] = { is_mirrored(s), down, false };

	for (int i = 0; i < 6; i++) {
		int row = i / 3, j = i % 3;
		struct sum n = sum_mul(u->xy[row][j], l->scale[row]);

		n = sum_negated_if(minus[j] != (row == 1 && down), n);
		if (j == 2)
			n = sum_add(n, sum_mul(u->w[0], l->half[row]));
		k[row][j] = sum_ratio_or_nan(n, u->w[0]);
	}
	k[2][0] = k[2][1] = 0;
	k[2][2] = 1;
}

/* Sets left, right, bottom and top: X or Y where the side plane x = -w, x = w, y = -w
 * or y = w meets a plane of constant D. In a perspective it is near or, if `far` is
 * set, far; in a parallel projection, the plane that the shear does not move. */
static void set_edges(const struct upright *u, const struct depth *z, bool far,
    struct projection *p)
{
	double *const edges[4] = { &p->left, &p->right, &p->bottom, &p->top };
	struct sum n = sum_of_double(p->plane), d = sum_of_double(1);

	p->section = SECTION_EDGES;
	if (p->type == PROJECTION_PERSP)
		depth_quotient(z, far, &n, &d);
	for (int k = 0; k < 4; k++) {
		const struct sum *x = u->xy[k / 2];
		bool low = k % 2 == 0;
		struct sum slope = sum_sub(sum_negated_if(low, u->w[0]), x[2]);
		struct sum offset = sum_sub(sum_negated_if(low, u->w[1]), x[3]);

		*edges[k] = sum_ratio_or_nan(sum_add(sum_mul(slope, n),
						 sum_mul(offset, d)),
		    sum_mul(x[k / 2], d));
	}
}

/* Makes the projection oblique, with cot(projector) cos(direction) = xy[0][2] /
 * xy[0][0] and cot(projector) sin(direction) = xy[1][2] / xy[1][1]. */
static void set_shear(const struct upright *u, const struct projection *given,
    struct projection *p)
{
	bool minus = sum_sign(u->xy[0][0]) * sum_sign(u->xy[1][1]) < 0;
	struct sum x = sum_negated_if(minus, sum_mul(u->xy[0][2], u->xy[1][1]));
	struct sum y = sum_negated_if(minus, sum_mul(u->xy[1][2], u->xy[0][0]));
	struct sum both[3] = { x, y, sum_of_double(0) };

	p->type = PROJECTION_OBLIQUE;
	if (given->type == PROJECTION_OBLIQUE) {
		p->plane = given->plane;
		p->kind = given->kind;
	}
	p->projector_angle = trig_atan2_degrees(sum_abs(sum_mul(u->xy[0][0],
						    u->xy[1][1])),
	    vec3_length(both));
	p->direction = trig_atan2_degrees(sum_abs(y), x);
	if (sum_sign(y) < 0)
		p->direction = -p->direction;
}

/* Sets the projection p. In a perspective p->near becomes the plane nearer to the eye,
 * even if r->near is the other plane. */
static void set_projection(const struct lens *l, const struct upright *u,
    struct picture *r)
{
	const struct scene *s = l->scene;
	struct projection *p = &r->scene.projection;
	const struct projection *given = &s->projection;
	bool open = projection_is_open(given);
	bool swap = !l->parallel && r->near > r->far;

	*p = (struct projection){ .type = PROJECTION_ORTHO,
		.section = SECTION_INTRINSICS,
		.width = s->viewport.width,
		.height = s->viewport.height,
		.near_ratio = 0.0005,
		.near = swap ? r->far : r->near,
		.far = swap ? r->near : r->far,
		.reverse_z = r->reverse_z != swap,
		.direction = 45 };
	if (!l->parallel)
		p->type = PROJECTION_PERSP;
	else if (sum_sign(u->xy[0][2]) != 0 || sum_sign(u->xy[1][2]) != 0)
		set_shear(u, given, p);
	if (open) {
		p->near = 0;
		p->far = HUGE_VAL;
	}
	for (int i = 0; i < 9; i++)
		p->intrinsics[i / 3][i % 3] = r->intrinsics[i / 3][i % 3];
	/* if is_mirrored, X of K and x of r->scene's view space are opposite */
	p->intrinsics[0][0] = fabs(p->intrinsics[0][0]);
	if (!open && sum_sign(u->xy[0][1]) == 0)
		set_edges(u, &r->depth, swap, p);
}

/* Returns whether the matrix looks transposed. A transposed perspective matrix has the
 * gaze, a unit vector, in its last row and the image of the origin in its last column.
 * A transposed parallel projection has the last row 0 0 0 1. */
static bool seems_transposed(const double m[4][4])
{
	double row = 0, column = 0; /* squares of lengths */

	for (int i = 0; i < 3; i++) {
		row += m[3][i] * m[3][i];
		column += m[i][3] * m[i][3];
	}
	bool unit = fabs(row - 1) < 0x1p-20 && fabs(column - 1) > 0x1p-20;

	return column > 0 && (unit || (row == 0 && m[3][3] == 1));
}

/* Returns whether c is between 1 % and 99 % of size. */
static bool is_central(double c, double size)
{
	return 0.01 * size < c && c < 0.99 * size;
}

static unsigned notes_of(const struct lens *l, const struct upright *u,
    const struct picture *r)
{
	const struct scene *s = l->scene;
	const struct projection *p = &s->projection;
	bool parallel = l->parallel, behind = true;
	bool by_intrinsics = sum_sign(u->xy[0][1]) != 0 ||
	    projection_is_open(p);
	bool mirrored = (sum_sign(u->xy[0][0]) * sum_sign(u->xy[1][1]) < 0) !=
	    is_mirrored(s);
	bool fills = s->has_viewport && s->viewport.scale == SCALE_FILL;
	bool transposed = p->type == PROJECTION_MATRIX &&
	    seems_transposed(p->matrix);
	/* a document gives a volume an eye beyond far only on purpose */
	bool reverse = p->type == PROJECTION_VOLUME &&
	    r->taxon == TAXON_REVERSE;

	/* a corner is nan if it is at infinity or behind the eye */
	for (int i = 0; i < 8; i++)
		behind &= isnan(r->corner[i][0]);
	/* a perspective matrix that is negated as a whole seems to mirror */
	bool negated = !parallel && !transposed && mirrored && behind;
	bool known = transposed || reverse || negated;
	bool looks_away = u->uses_view_axes && u->turned &&
	    (mirrored || s->has_camera);
	const bool applies[NOTES] = {
		[NOTE_MIRRORED] = !known && mirrored && !looks_away,
		[NOTE_OTHER_HANDED] = !known && mirrored && looks_away,
		[NOTE_LOOKS_AWAY] = !known && !mirrored && looks_away,
		[NOTE_TRANSPOSED] = transposed,
		[NOTE_NEAR_BEYOND] = r->near > r->far && !reverse,
		[NOTE_DEPTH_FALLS] = p->type == PROJECTION_MATRIX &&
		    u->uses_view_axes && parallel && r->reverse_z,
		[NOTE_RADIANS] = p->type == PROJECTION_PERSP &&
		    p->unit == DEGREES && fmin(r->fov[0], r->fov[1]) < 3.2 &&
		    (p->section <= SECTION_VIEW_ANGLE ||
			p->section == SECTION_ANGLES),
		[NOTE_OFF_CENTER] = projection_has_intrinsics(p) &&
		    !(is_central(r->intrinsics[0][2], p->width) &&
			is_central(r->intrinsics[1][2], p->height)),
		[NOTE_NO_ROTATION] = !is_rotation(&l->to_view, is_mirrored(s)),
		[NOTE_TILTED] = u->tilted,
		[NOTE_MINUS_W] = negated || (parallel && sum_sign(u->w[1]) < 0),
		[NOTE_NO_INTRINSICS] = by_intrinsics &&
		    (parallel || !fills || sum_sign(u->xy[0][0]) < 0),
	};
	unsigned notes = 0;

	for (int i = 0; i < NOTES; i++)
		notes |= (unsigned)applies[i] << i;
	return notes;
}

static void set_parameters(const struct lens *l, struct picture *r)
{
	const struct scene *s = l->scene;
	struct upright u;

	set_frustum_planes(l, r->frustum_plane);
	upright_of(l, &u);
	depth_of(l, &r->depth);
	r->reverse_z = l->reversed;
	if (!u.tilted) {
		r->near = depth_distance(&r->depth, false);
		r->far = depth_distance(&r->depth, true);
	}
	set_near_edges(l, &u, r);
	if (s->has_viewport && !l->parallel)
		set_intrinsics(l, &u, r->intrinsics);
	r->notes = notes_of(l, &u, r);
	r->scene = *s;
	r->scene.answer = NULL;
	r->scene.convention = *answer_convention(s);
	r->has_scene = r->notes >> NOTE_NO_ROTATION == 0;
	if (!r->has_scene)
		return;
	set_projection(l, &u, r);
	set_camera(l, &u, r);
	r->has_scene = scene_is_valid(&r->scene);
	r->notes |= r->has_scene ? 0 : 1u << NOTE_OUT_OF_RANGE;
}

const char *picture_of(const struct scene *s, struct picture *p)
{
	struct lens l;
	struct scene known = *s;
	const char *why = lens_of(s, &l);

	if (why != NULL)
		return why;
	/* a double whose bits are all 1 is nan */
	memset(p, 0xff, offsetof(struct picture, notes));
	taxonomy_of(&l, p);
	set_parameters(&l, p);
	known.known[SPACE_WORLD][false] = &l.to_view;
	known.known[SPACE_WORLD][true] = &l.to_world;
	known.known[SPACE_VIEW][false] = &l.volume.to_clip;
	return error_bounds(&known, &l.volume, p->error_bound);
}
