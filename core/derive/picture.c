/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include <string.h>

#include "error_bound.h"
#include "upright.h"

/* Sets the aspect. If the axes are those of view space, sets near_edge from two
 * opposite corners of the near plane. */
static void set_near_edges(const struct lens *l, const struct upright *u,
    struct picture *r)
{
	const struct sum *half = l->half, *scale = l->scale;

	for (int k = 0; k < 4 && u->uses_view_axes && !isnan(r->near); k++) {
		const struct sum *h = l->corner[k % 2 == 0 ? 0 : 2];

		if (k >= 2 || sum_sign(u->clip_xy[0][1]) == 0)
			r->near_edge[k] = sum_ratio_or_nan(h[k / 2], h[3]);
	}
	struct sum wide = sum_mul(sum_mul(u->clip_xy[1][1], half[0]), scale[1]);
	struct sum high = sum_mul(sum_mul(u->clip_xy[0][0], half[1]), scale[0]);

	/* if high is 0, the picture is a line */
	if (sum_sign(high) != 0)
		r->aspect = sum_ratio_or_nan(sum_abs(wide), sum_abs(high));
}

/* The length of a normal is that in view space if the camera is a rotation. */
static void set_frustum_planes(const struct lens *l, double plane[6][4])
{
	const bool rotates = !camera_gives_3x3(&l->scene.camera);

	for (int k = 0; k < 6; k++) {
		const struct map *m = k < 4 ? &l->sides : &l->ends;
		const struct sum n[3] = { m->m[0][k % 4], m->m[1][k % 4],
			m->m[2][k % 4] };
		struct sum v[4];

		for (int i = 0; i < 4; i++)
			map_image(m, k % 4, l->to_view.m[i], &v[i]);
		struct sum length = rotates ?
		    sum_mul(vec3_length(n), l->to_view.divisor) :
		    vec3_length(v);

		for (int i = 0; i < 4 && sum_sign(length) != 0; i++)
			plane[k][i] = sum_ratio_or_nan(v[i], length);
	}
}

/* Returns whether the 3x3 part is a rotation (if mirrored, the mirror image of one) but
 * for errors, which are below 2^-50 in doubles. Only a matrix or a pose need not be. */
static bool is_rotation(const struct map *m, bool mirrored)
{
	double r[3][3];

	for (int i = 0; i < 9; i++)
		r[i / 3][i % 3] = map_element_nearest(m, i / 3, i % 3, false);
	return note_is_rotation(r, 0x1p-20, mirrored);
}

/* Sets the camera. The eye of a perspective is the point where its projectors meet. */
static void set_camera(const struct lens *l, const struct upright *u, struct picture *r)
{
	struct camera *c = &r->scene.camera;

	*c = (struct camera){ .way = CAMERA_GAZE };
	r->scene.has_camera = true;
	for (int k = 0; k < 3; k++)
		c->eye[k] = l->parallel ?
		    map_element_nearest(&l->to_world, 3, k, false) :
		    r->taxonomy.eye[k];
	lens_world_axis(l, u->axis[2], c->at);
	memcpy(c->up, r->up, sizeof c->up);
}

/* Computes K of struct picture from half and scale (the margin is 0 here). In pixels
 * from the viewport's corner, clip x becomes half + scale x / w to the right, and clip
 * y half + scale y / w upward or, if pixels count from the top, half - scale y / w
 * downward. The axes of K are X of *u, or -X if l->mirrors, Y of *u, or -Y if pixels
 * count from the top, and the gaze. */
static void set_intrinsics(const struct lens *l, const struct upright *u,
    double k[3][3])
{
	const struct scene *s = &l->scene;
	bool down = !scene_answer_convention(s)->origin_bottom_left;
	const bool minus[3] = { l->mirrors, down, false };

	for (int i = 0; i < 6; i++) {
		int row = i / 3, j = i % 3;
		struct sum n = sum_mul(u->clip_xy[row][j], l->scale[row]);

		n = sum_negated_if(minus[j] != (row == 1 && down), n);
		if (j == 2)
			n = sum_add(n, sum_mul(u->clip_w[0], l->half[row]));
		k[row][j] = sum_ratio_or_nan(n, u->clip_w[0]);
	}
	k[2][0] = k[2][1] = 0;
	k[2][2] = 1;
}

/* Sets left, right, bottom and top: X or Y where the side plane x = -w, x = w, y = -w
 * or y = w meets a plane of constant D. In a perspective it is near or, if `far` is
 * set, far, or D = 1 without these; in a parallel projection, the plane that the shear
 * does not move. */
static void set_edges(const struct upright *u, const struct depth *z, bool far,
    struct projection *p)
{
	struct sum n = sum_of_double(p->shear.plane), d = sum_of_double(1);

	p->section.way = SECTION_EDGES;
	p->section.edges_at = projection_is_open(p);
	if (projection_is_open(p))
		sum_copy(&n, &d);
	else if (projection_family(p) == FAMILY_PERSP)
		depth_quotient(z, far, &n, &d);
	for (int k = 0; k < 4; k++) {
		const struct sum *x = u->clip_xy[k / 2];
		bool low = k % 2 == 0;
		struct sum slope = sum_sub(sum_negated_if(low, u->clip_w[0]), x[2]);
		struct sum offset = sum_sub(sum_negated_if(low, u->clip_w[1]), x[3]);

		p->section.edges[k] = sum_ratio_or_nan(sum_add(sum_mul(slope, n),
							   sum_mul(offset, d)),
		    sum_mul(x[k / 2], d));
	}
}

/* Returns the direction of x y, from minus to plus a half turn. */
static double direction_of(struct sum x, struct sum y, enum angle_unit unit)
{
	double direction = trig_atan2(sum_abs(y), x, unit);

	return sum_sign(y) < 0 ? -direction : direction;
}

/* Sets the shear of an oblique projection: cot(projector) cos(direction) =
 * clip_xy[0][2] / clip_xy[0][0] and cot(projector) sin(direction) = clip_xy[1][2] /
 * clip_xy[1][1]. An angle that was given in this unit is found again, as the error of
 * the elements is far below a bit of it. But a direction in radians beyond a half turn
 * is kept as it was given, as it can't be reduced without rounding. */
static void set_shear(const struct upright *u, const struct scene *s,
    struct projection *p)
{
	const struct projection *given = &s->projection;
	const struct projection_shear *was = &given->shear;
	const enum angle_unit unit = s->has_world ? s->world.unit :
	    projection_is_sheared(given)          ? given->unit :
						    ANGLE_DEGREES;
	bool minus = sum_sign(u->clip_xy[0][0]) * sum_sign(u->clip_xy[1][1]) < 0;
	struct sum x = sum_negated_if(minus,
	    sum_mul(u->clip_xy[0][2], u->clip_xy[1][1]));
	struct sum y = sum_negated_if(minus,
	    sum_mul(u->clip_xy[1][2], u->clip_xy[0][0]));
	struct sum both[3] = { x, y, sum_of_double(0) };

	p->unit = p->shear.direction_unit = unit;
	if (projection_family(given) == FAMILY_PARALLEL)
		p->shear.plane = was->plane;
	if (projection_is_sheared(given))
		p->shear.kind = was->kind;
	p->shear.projector_angle = trig_atan2(sum_abs(sum_mul(u->clip_xy[0][0],
						  u->clip_xy[1][1])),
	    vec3_length(both), unit);
	p->shear.direction = direction_of(x, y, unit);
	if (projection_is_sheared(given) && unit == ANGLE_RADIANS &&
	    was->direction_unit == unit && fabs(was->direction) > PI) {
		trig_sin_cos(was->direction, unit, &y, &x);
		if (direction_of(x, y, unit) == p->shear.direction)
			p->shear.direction = was->direction;
	}
}

/* Returns whether intrinsics can say what the picture is: of a perspective that does
 * not mirror and fills the viewport. */
static bool may_have_intrinsics(const struct lens *l, const struct upright *u)
{
	const struct scene *s = &l->scene;

	return !l->parallel && s->has_viewport && s->viewport.scale == SCALE_FILL &&
	    sum_sign(u->clip_xy[0][0]) > 0;
}

/* Sets the projection p. In a perspective p->near becomes the plane nearer to the eye,
 * even if r->near is the other plane. */
static void set_projection(const struct lens *l, const struct upright *u,
    struct picture *r)
{
	const struct scene *s = &l->scene;
	struct projection *p = &r->scene.projection;
	const struct projection *given = &s->projection;
	bool open = projection_is_open(given);
	bool swap = !l->parallel && r->near > r->far;
	bool sheared = l->parallel &&
	    (sum_sign(u->clip_xy[0][2]) != 0 || sum_sign(u->clip_xy[1][2]) != 0);

	projection_set_defaults(p,
	    projection_type_of(l->parallel ? FAMILY_PARALLEL : FAMILY_PERSP, sheared));
	p->section.way = SECTION_INTRINSICS;
	p->section.width = s->viewport.width;
	p->section.height = s->viewport.height;
	p->near = open ? 0 : swap ? r->far : r->near;
	p->far = open ? HUGE_VAL : swap ? r->near : r->far;
	p->reverse_z = r->reverse_z != swap;
	if (sheared)
		set_shear(u, s, p);
	for (int i = 0; i < 9; i++)
		p->section.intrinsics[i / 3][i % 3] = r->intrinsics[i / 3][i % 3];
	/* if l->mirrors, X of K and x of r->scene's view space are opposite */
	p->section.intrinsics[0][0] = fabs(p->section.intrinsics[0][0]);
	if (sum_sign(u->clip_xy[0][1]) == 0 && !(open && may_have_intrinsics(l, u)))
		set_edges(u, &r->depth, swap, p);
}

/* Returns whether the principal point is at the edge of the full picture or outside.
 * With another origin both sides change places. A command that prints no device has
 * taken the viewport away; then the members tell, but not those of a tilted P. */
static bool is_off_center(const struct scene *s, const struct picture *r)
{
	const struct viewport *v = &s->viewport;
	const bool other = s->convention.origin_bottom_left !=
	    scene_answer_convention(s)->origin_bottom_left;
	double full[2];

	if (!note_judges_center(s))
		return false;
	if (!s->has_viewport)
		return !projection_is_tilted(&s->projection) &&
		    !note_has_central_intrinsics(&s->projection.section);
	viewport_full(v, full);
	for (int k = 0; k < 2; k++) {
		const double offset = v->has_offset ? v->offset[k] : 0;
		const double side = k == 0 ? v->width : v->height;
		const double before = k == 1 && other ? full[k] - offset - side :
							offset;

		if (!note_principal_point_is_inside(r->intrinsics[k][2] + before,
			full[k]))
			return true;
	}
	return false;
}

/* A document gives a volume an eye beyond far only on purpose, and without a camera its
 * z are those of a text of either handedness. */
static bool is_reverse_volume(const struct lens *l, const struct picture *r)
{
	return projection_family(&l->scene.projection) == FAMILY_VOLUME &&
	    r->taxonomy.taxon == TAXON_REVERSE;
}

static bool is_free_volume(const struct scene *s)
{
	return projection_family(&s->projection) == FAMILY_VOLUME && !s->has_camera;
}

/* Returns the note, if any, on which way the picture is seen: the first that explains
 * it. A perspective matrix that is negated as a whole seems to mirror. */
static unsigned note_of_sides(const struct lens *l, const struct upright *u,
    const struct picture *r)
{
	const int sides = sum_sign(u->clip_xy[0][0]) * sum_sign(u->clip_xy[1][1]);
	const bool mirrored = (sides < 0) != l->mirrors;
	const bool looks_away = u->uses_view_axes && u->turned &&
	    (mirrored || l->scene.has_camera);
	bool behind = !projection_is_open(&l->scene.projection);

	/* a corner is nan if it is at infinity or behind the eye, or without planes */
	for (int i = 0; i < 8; i++)
		behind &= isnan(r->taxonomy.corner[i][0]);
	if (is_reverse_volume(l, r))
		return 0;
	if (mirrored && behind && !l->parallel)
		return 1u << NOTE_MINUS_W;
	if (mirrored && looks_away)
		return note_if(!is_free_volume(&l->scene), NOTE_OTHER_HANDED);
	return note_if(mirrored, NOTE_MIRRORED) | note_if(looks_away, NOTE_LOOKS_AWAY);
}

/* Returns the notes on anything else. */
static unsigned note_of_numbers(const struct lens *l, const struct upright *u,
    const struct picture *r)
{
	const struct scene *s = &l->scene;
	const struct projection *p = &s->projection;
	const bool by_angle = section_is_by_angle(p->section.way) ||
	    p->section.way == SECTION_ANGLES;

	return note_if(r->near > r->far && !is_reverse_volume(l, r) &&
		       !is_free_volume(s),
		   NOTE_NEAR_BEYOND) |
	    note_if(projection_is_given_matrix(p) && u->uses_view_axes && l->parallel &&
		    r->reverse_z,
		NOTE_DEPTH_FALLS) |
	    note_if(l->parallel && sum_sign(u->clip_w[1]) < 0, NOTE_MINUS_W) |
	    note_if(u->tilted, NOTE_TILTED) |
	    note_if(projection_family(p) == FAMILY_PERSP && by_angle &&
		    p->unit == ANGLE_DEGREES &&
		    fmin(r->taxonomy.fov[0], r->taxonomy.fov[1]) < 3.2,
		NOTE_RADIANS) |
	    note_if(projection_has_intrinsics(p) && is_off_center(s, r),
		NOTE_OFF_CENTER) |
	    note_if(sum_sign(u->clip_xy[0][1]) != 0 && !may_have_intrinsics(l, u),
		NOTE_NO_INTRINSICS) |
	    note_if(s->has_camera && camera_gives_3x3(&s->camera) &&
		    !is_rotation(&l->to_view, l->mirrors),
		NOTE_NO_ROTATION);
}

/* Returns half a unit of the last digit of an element of a matrix: of a float, of a
 * decimal with as many digits as any element, five at least, or of a double. 0, 1 and
 * -1 are exact. */
static double half_unit(double x, const struct projection *p)
{
	const int digits = p->matrix_digits > 5 ? p->matrix_digits : 5;
	const double size = fabs(x);
	double unit = 1; /* of the first digit, then of the last one */
	int e;

	if (size == 0 || size == 1)
		return 0;
	frexp(size, &e);
	if (p->matrix_of_floats || p->matrix_digits == 0 || digits > 15)
		return ldexp(1, e - (p->matrix_of_floats ? 25 : 54));
	while (unit <= size / 10)
		unit *= 10;
	while (unit > size)
		unit /= 10;
	for (int i = 1; i < digits; i++)
		unit /= 10;
	return unit / 2;
}

/* Sets the range of far that the digits of a perspective's matrix leave open. With the
 * gradients z' and w' along D and z at the eye, far is z / (k w' - z') for the depth k
 * of the far plane. Each element is off by up to half_unit; what this adds to numerator
 * and denominator is of the document's convention, in which k is 1, 0 or -1. */
static void set_far_range(const struct lens *l, const struct upright *u,
    struct picture *r)
{
	const struct scene *s = &l->scene;
	const struct projection *p = &s->projection;
	const bool low = s->convention.depth_minus_one,
		   answer_low = scene_answer_convention(s)->depth_minus_one;
	const double k = !l->reversed ? 1 : answer_low ? -1 : 0;
	const double w_share = !l->reversed || low ? 1 : 0;
	struct sum z, slope[2];
	double num, den, off[2] = { half_unit(p->matrix[3][2], p), 0 };

	map_image(&l->to_clip, 2, l->eye, &z);
	for (int i = 0; i < 2; i++)
		slope[i] = vec3_dot(l->clip[2 + i], u->axis[2]);
	num = fabs(sum_ratio_or_nan(z, sum_mul(l->eye[3], l->to_clip.divisor)));
	den = fabs(sum_ratio_or_nan(sum_sub(sum_scale(slope[1], k), slope[0]),
	    l->to_clip.divisor));
	for (int i = 0; i < 3; i++) {
		const double *m = p->matrix[i];
		const double off_z = half_unit(m[2], p);
		const double axis = fabs(sum_double(u->axis[2][i]));

		off[0] += off_z * fabs(sum_ratio_or_nan(l->eye[i], l->eye[3]));
		off[1] += axis * (off_z + w_share * half_unit(m[3], p));
	}
	for (int i = 0; i < 2; i++) /* of depths of the answer's range */
		off[i] *= low == answer_low ? 1 : low ? 0.5 : 2;
	r->far_range[0] = (num - off[0]) / (den + off[1]);
	r->far_range[1] = den > off[1] ? (num + off[0]) / (den - off[1]) : HUGE_VAL;
}

/* Returns the notes on a second scene that is only nearly that of the matrix. */
static unsigned note_of_digits(const struct lens *l, const struct upright *u,
    struct picture *r)
{
	const bool matrix = projection_is_given_matrix(&l->scene.projection);
	unsigned notes = 0;

	r->residual = u->residual;
	notes |= note_if(matrix && u->residual > 0x1p-40, NOTE_RESIDUAL);
	if (matrix && !l->parallel) {
		const double *range = r->far_range;

		set_far_range(l, u, r);
		notes |= note_if(range[0] < range[1] &&
			(isinf(range[1]) || range[1] - range[0] > 0.01 * r->far),
		    NOTE_FAR_RANGE);
	}
	return notes;
}

static void set_parameters(const struct scene *s, const struct lens *l,
    const struct upright *u, struct picture *r)
{
	set_frustum_planes(l, r->frustum_plane);
	lens_world_axis(l, u->axis[1], r->up);
	depth_of(l, &r->depth);
	r->reverse_z = l->reversed;
	if (!u->tilted) {
		r->near = depth_distance(&r->depth, false);
		r->far = depth_distance(&r->depth, true);
	}
	set_near_edges(l, u, r);
	if (s->has_viewport && !l->parallel)
		set_intrinsics(l, u, r->intrinsics);
	const unsigned numbers = note_of_numbers(l, u, r);

	r->notes = numbers | note_of_sides(l, u, r);
	r->scene = *s;
	r->scene.answer = NULL;
	r->scene.viewport.has_full = r->scene.viewport.has_offset = false;
	r->scene.convention = *scene_answer_convention(s);
	r->has_scene = r->notes >> NOTES_WITH_SCENE == 0;
	if (r->has_scene) {
		set_projection(l, u, r);
		set_camera(l, u, r);
		r->has_scene = scene_is_valid(&r->scene);
		r->notes |= r->has_scene ? note_of_digits(l, u, r) :
					   1u << NOTE_OUT_OF_RANGE;
	}
	/* the matrix, as it was read, makes no second scene and looks transposed: that
	 * explains which way the picture is seen */
	if (!r->has_scene && projection_is_given_matrix(&s->projection) &&
	    note_seems_transposed(s->projection.matrix)) {
		const unsigned null = numbers >> NOTES_WITH_SCENE != 0 ? 0 : r->notes;

		r->notes = numbers | 1u << NOTE_TRANSPOSED |
		    null >> NOTES_WITH_SCENE << NOTES_WITH_SCENE;
	}
}

/* static: too large for a stack of 256 KB. Only one thread describes pictures. */
static struct lens lens;
static struct upright upright;

/* Sets all members of the picture but rigid and error_bound. */
static bool describe(const struct scene *s, struct picture *p, struct refusals *faults)
{
	if (!lens_of(s, &lens, faults))
		return false;
	upright_of(&lens, &upright);
	/* a double whose bits are all 1 is nan */
	memset(p, 0xff, offsetof(struct picture, notes));
	taxonomy_of(&lens, &p->taxonomy);
	set_parameters(s, &lens, &upright, p);
	return true;
}

unsigned picture_notes(const struct scene *s)
{
	struct picture p;
	const bool described = describe(s, &p, NULL);
	const bool wide = ex_has_overflowed(); /* by a product that no image needs */

	return described && !wide ?
	    p.notes & ~(1u << NOTE_RADIANS) & ((1u << NOTES_PRINTED) - 1) :
	    0;
}

void picture_axes(const struct scene *s, double gaze[3], double up[3])
{
	static struct picture p;
	const bool described = describe(s, &p, NULL) && !ex_has_overflowed();

	for (int k = 0; k < 3; k++) {
		gaze[k] = described ? p.taxonomy.gaze[k] : (double)NAN;
		up[k] = described ? p.up[k] : (double)NAN;
	}
}

bool picture_of(const struct scene *s, struct picture *p, struct refusals *faults)
{
	if (!describe(s, p, faults))
		return false;
	rigid_of(&lens, &upright, &p->rigid);
	return error_bound_of(&lens, p->error_bound, faults);
}
