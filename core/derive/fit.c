/* SPDX-License-Identifier: MIT */
#include "fit.h"

#include "frustum.h"

static bool refuse_range(struct refusals *faults)
{
	return refuse(faults, "/bounds",
	    "the scene that fit computes has numbers beyond 1e150 or sizes below "
	    "1e-150",
	    "choose another unit");
}

/* Replaces c->at by the gaze at - eye, rounded, and halved if it is out of range. */
static void gaze_from_at(struct camera *c)
{
	double largest = 0;

	for (int k = 0; k < 3; k++) {
		c->at[k] -= c->eye[k];
		largest = fmax(largest, fabs(c->at[k]));
	}
	for (int k = 0; k < 3 && largest > SCENE_MAGNITUDE_MAX; k++)
		c->at[k] /= 2;
}

/* Gives the camera the form CAMERA_GAZE, with rounded numbers. Without a camera, one at
 * the origin looks along the z axis of view space. The gaze and up of a matrix are
 * those of the nearest rotation. */
static bool make_gaze_camera(struct scene *s, struct refusals *faults)
{
	const struct convention *convention = &s->convention;
	const double along = convention_looks_back(convention) ? -1 : 1;
	const double upward = convention->view_y_down ? -1 : 1;
	struct camera *c = &s->camera;
	struct map to_world;

	if (!s->has_camera)
		*c = (struct camera){ .way = CAMERA_ORIENTATION,
			.orientation = { [3] = 1 } };
	s->has_camera = true;
	if (camera_mirrors(c, convention))
		return refuse(faults, "/camera/axes",
		    "are of the other handedness than the convention",
		    "name a convention of theirs, as no gaze and up mirror");
	struct camera turned = *c;

	if (!camera_map(c, convention, true, &to_world, faults))
		return false;
	for (int k = 0; k < 3 && !camera_has_eye(c); k++)
		c->eye[k] = map_element_nearest(&to_world, 3, k, false);
	if (camera_is_by_steps(c))
		c->roll = 0;
	turned.roll = 0;
	turned.orthonormalize = true;
	if (!camera_is_by_gaze(c) &&
	    !camera_map(&turned, convention, true, &to_world, faults))
		return false;
	for (int k = 0; k < 3 && !camera_is_by_gaze(c); k++) {
		c->at[k] = along * map_element_nearest(&to_world, 2, k, false);
		c->up[k] = upward * map_element_nearest(&to_world, 1, k, false);
	}
	if (c->way == CAMERA_AT)
		gaze_from_at(c);
	c->way = CAMERA_GAZE;
	c->has_axes = false;
	return true;
}

static void eye_after_step(const struct map *to_world, const struct sum step[3],
    double eye[3])
{
	const struct sum at[4] = { step[0], step[1], step[2], sum_of_double(1) };
	struct sum to;

	for (int k = 0; k < 3; k++) {
		map_image(to_world, k, at, &to);
		eye[k] = sum_ratio(to, to_world->divisor);
	}
}

/* Returns n / d rounded upward. d must be positive. */
static double ratio_up(struct sum n, struct sum d)
{
	double v = sum_ratio(n, d);

	return sum_compare(sum_scale(d, v), n) < 0 ? nextafter(v, HUGE_VAL) : v;
}

/* Returns n / d rounded upward or, if extents_widen has widened axis j, to nearest. */
static double extent_ratio(const struct extents *r, int j, struct sum n, struct sum d)
{
	return sum_sign(r->size[j]) > 0 ? ratio_up(n, d) : sum_ratio(n, d);
}

static struct sum extent_middle(const struct extents *r, int j)
{
	return sum_scale(sum_add(r->low[j], r->high[j]), 0.5);
}

/* Writes the least and the greatest depth of the bounds, rounded outward. The ends of a
 * widened range, rounded to nearest, could both be on one side of the bounds. */
static void depth_range(const struct extents *r, double *low, double *high)
{
	struct sum middle = extent_middle(r, 2);

	*low = 0 -
	    fmax(extent_ratio(r, 2, sum_neg(r->low[2]), sum_one),
		ratio_up(sum_neg(middle), sum_one));
	*high = fmax(extent_ratio(r, 2, r->high[2], sum_one),
	    ratio_up(middle, sum_one));
	*high = fmax(*high, nextafter(*low, HUGE_VAL));
}

static struct sum smaller(struct sum a, struct sum b)
{
	return sum_compare(a, b) < 0 ? a : b;
}

static struct sum larger(struct sum a, struct sum b)
{
	return sum_compare(a, b) > 0 ? a : b;
}

/* Widens one side if it is too short for width : height = shape[0] : shape[1]. Rounds
 * the widened side to the nearest double. */
static void widen_sides(double *width, double *height, const double shape[2])
{
	struct sum w = sum_of_double(shape[0]), h = sum_of_double(shape[1]);
	double wide = sum_ratio(sum_scale(w, *height), h);
	double high = sum_ratio(sum_scale(h, *width), w);

	if (wide > *width)
		*width = wide;
	else
		*height = fmax(*height, high);
}

/* Finds the functions of the side planes in view space, and how much each falls at a
 * fixed point while the eye moves by 1 along the gaze. */
static bool find_plane_slopes(const struct scene *s, struct map *sides,
    struct sum slope[4], struct refusals *faults)
{
	struct map ends;

	if (!frustum_planes(s, SPACE_VIEW, sides, &ends, faults))
		return false;
	for (int k = 0; k < 4; k++) {
		slope[k] = sum_negated_if(convention_looks_back(&s->convention),
		    map_element(sides, 2, k));
		if (sum_sign(slope[k]) <= 0)
			return refuse(faults, "/projection",
			    "the gaze does not run between the side planes, less the "
			    "margin",
			    "let the edges, or cx and cy, leave it room on both sides");
	}
	return true;
}

/* Finds step[1] and step[0], across the gaze; step[2] is given. After the step the
 * functions of two opposite planes have the same least value on the bounds. A step
 * lowers a least value by the dot product of the step and the plane's normal. The
 * functions of bottom and top do not depend on x, so step[1] is found first. */
static void center_between_planes(const struct map *sides, const struct sum lowest[4],
    struct sum step[3])
{
	for (int j = 1; j >= 0; j--) {
		struct sum normal[3];
		struct sum gap = sum_sub(lowest[2 * j], lowest[2 * j + 1]);

		for (int i = 2; i >= j; i--) {
			normal[i] = sum_sub(map_element(sides, i, 2 * j),
			    map_element(sides, i, 2 * j + 1));
			if (i > j)
				gap = sum_sub(gap, sum_mul(normal[i], step[i]));
		}
		step[j] = sum_quotient(gap, normal[j]);
	}
}

/* Finds the eye's step in view space, as far along the gaze as a side plane or
 * near_ratio allows. A step of t along the gaze lowers the least value of a plane's
 * function by t times the plane's slope. If center, the eye also moves across the gaze.
 * Such a move does not change the sum of the least values of two opposite planes, so
 * this sum limits t. */
static bool find_eye_step(const struct scene *s, const struct hull *h, bool center,
    struct sum step[3], struct refusals *faults)
{
	struct map model, view, ends;
	struct sum slope[4], lowest[4];
	struct extents r;

	if (!hull_extents(h, s, &r, faults) ||
	    !find_plane_slopes(s, &view, slope, faults) ||
	    !frustum_planes(s, SPACE_MODEL, &model, &ends, faults))
		return false;
	/* t is the largest step of the eye along the gaze after which near is at least
	 * ratio times far, low - t >= ratio (high - t), and min_near: low - t >= least.
	 * The bounds' depth runs from low to high. */
	const double ratio = s->projection.near_ratio;
	struct sum far = sum_scale(r.high[2], ratio);
	struct sum t = sum_quotient(sum_sub(r.low[2], far), sum_difference(1, ratio));
	struct sum least = sum_of_double(s->projection.min_near);

	t = smaller(t, sum_sub(r.low[2], least));

	for (int k = 0; k < 4; k++)
		lowest[k] = hull_lowest(h, &model, k, false);
	for (int k = 0; k < 4; k += center ? 2 : 1) {
		struct sum gap = lowest[k], fall = slope[k];

		if (center) {
			gap = sum_add(gap, lowest[k + 1]);
			fall = sum_add(fall, slope[k + 1]);
		}
		t = smaller(t, sum_quotient(gap, fall));
	}
	step[0] = step[1] = sum_of_double(0);
	step[2] = sum_negated_if(convention_looks_back(&s->convention), t);
	if (center)
		center_between_planes(&view, lowest, step);
	return fabs(sum_double(t)) <= SCENE_MAGNITUDE_MAX || refuse_range(faults);
}

/* Scales sizes on the near plane from old_near to p->near, so that the side planes do
 * not move. Rounds the sizes away from 0, so that the volume does not shrink. */
static void keep_side_planes(struct projection *p, double old_near)
{
	struct projection_section *s = &p->section;
	double *const sizes[] = { &s->width, &s->height, &s->left, &s->right,
		&s->bottom, &s->top };

	for (int i = 0; i < 6 && projection_is_given_at_near(p); i++)
		*sizes[i] = copysign(ratio_up(sum_scale(sum_of_double(p->near),
						  fabs(*sizes[i])),
					 sum_of_double(old_near)),
		    *sizes[i]);
}

/* Sets near and far around the bounds. Returns whether the bounds are then inside the
 * volume, and near is at least near_ratio times far, and min_near. */
static bool enclose_persp(struct scene *s, const struct hull *h)
{
	struct projection *p = &s->projection;
	double old_near = p->near;
	struct extents r;

	if (!hull_extents(h, s, &r, NULL) || sum_sign(r.low[2]) <= 0)
		return false;
	depth_range(&r, &p->near, &p->far);
	keep_side_planes(p, old_near);
	unsigned out = hull_outside(h, s);

	/* an end of the range is inside the bounds by less than the error of r */
	if ((out & (OUT_NEAR | OUT_FAR)) != 0) {
		old_near = p->near;
		p->near = nextafter(p->near, out & OUT_NEAR ? 0 : p->near);
		p->far = nextafter(p->far, out & OUT_FAR ? HUGE_VAL : p->far);
		keep_side_planes(p, old_near);
		out = hull_outside(h, s);
	}
	struct sum least = sum_scale(sum_of_double(p->near_ratio), p->far);

	return out == 0 && p->near >= p->min_near &&
	    sum_compare(sum_of_double(p->near), least) >= 0;
}

/* Moves the eye by the step of find_eye_step. If a part of the bounds is then outside,
 * as the eye is rounded, the eye moves back by 2^-53 of its largest coordinate, then
 * twice. */
static bool fit_persp(struct scene *s, bool center, const struct hull *h,
    struct refusals *faults)
{
	const struct projection given = s->projection;
	double outward = convention_looks_back(&s->convention) ? 1 : -1;
	const double *eye = s->camera.eye;
	double retreat = 0;
	struct sum step[3];
	struct map to_world;

	if (!find_eye_step(s, h, center, step, faults) ||
	    !scene_map(s, SPACE_VIEW, SPACE_WORLD, &to_world, faults))
		return false;
	const struct sum first = step[2];

	for (int tries = 0; tries < 100; tries++) {
		step[2] = sum_add(first, sum_of_double(outward * retreat));
		s->projection = given;
		eye_after_step(&to_world, step, s->camera.eye);
		if (enclose_persp(s, h))
			return true;
		for (int k = 0; k < 3 && tries == 0; k++)
			retreat = fmax(retreat, 0x1p-54 * fabs(eye[k]));
		retreat = retreat > 0 ? 2 * retreat : 0x1p-53 * fabs(sum_double(first));
	}
	return refuse_range(faults);
}

/* Moves the eye so that the bounds are in the middle of the picture and, unless
 * has_eye, as far from it as they extend along the gaze. A step along the gaze of an
 * oblique projection shifts the image; a step across the gaze undoes the shift. */
static bool center_picture(struct scene *s, bool has_eye, const struct hull *h,
    struct refusals *faults)
{
	const struct convention *c = &s->convention;
	struct sum step[3] = { 0 };
	struct map to_world, clip;
	struct extents r;

	if (!hull_extents(h, s, &r, faults) ||
	    !scene_map(s, SPACE_VIEW, SPACE_CLIP, &clip, faults) ||
	    !scene_map(s, SPACE_VIEW, SPACE_WORLD, &to_world, faults))
		return false;
	for (int j = 0; j < 3; j++)
		step[j] = extent_middle(&r, j);
	step[2] = sum_add(step[2], sum_sub(r.low[2], r.high[2]));
	step[2] = has_eye ? sum_of_double(0) :
			    sum_negated_if(convention_looks_back(c), step[2]);
	for (int j = 0; j < 2; j++) {
		struct sum sheared = sum_mul(step[2], map_element(&clip, 2, j));

		step[j] = sum_sub(step[j],
		    sum_negated_if(j == 1 && c->ndc_y_down, sheared));
	}
	step[1] = sum_negated_if(c->view_y_down, step[1]);
	eye_after_step(&to_world, step, s->camera.eye);
	return true;
}

static bool enclose_parallel(struct scene *s, const struct hull *h,
    struct refusals *faults)
{
	struct projection *p = &s->projection;
	double *const size[2] = { &p->section.width, &p->section.height };
	struct sum half[2], scale[2];
	struct extents r;

	if (!hull_extents(h, s, &r, faults))
		return false;
	depth_range(&r, &p->near, &p->far);
	frustum_limits(s, half, scale);
	for (int j = 0; j < 2; j++) {
		struct sum most = larger(sum_neg(r.low[j]), r.high[j]);

		*size[j] = 2 * extent_ratio(&r, j, sum_mul(most, scale[j]), half[j]);
		if (!(*size[j] > 0))
			return refuse(faults, "/camera/eye",
			    "too far from the bounds to tell their size",
			    "leave it out, or move it nearer");
	}
	if (p->aspect[1] != 0)
		widen_sides(&p->section.width, &p->section.height, p->aspect);
	return true;
}

/* Fits ortho and oblique. If the projection was given by edges, sets edges in place of
 * width and height. They mirror the image if the given edges did. */
static bool fit_parallel(struct scene *s, bool has_eye,
    const struct projection_section *given, const struct hull *h,
    struct refusals *faults)
{
	struct projection_section *p = &s->projection.section;

	if (!center_picture(s, has_eye, h, faults) || !enclose_parallel(s, h, faults))
		return false;
	if (given->way != SECTION_EDGES)
		return true;
	p->way = SECTION_EDGES;
	for (int k = 0; k < 4; k++) {
		const double half = (k < 2 ? p->width : p->height) / 2;
		const bool mirrors = given->edges[k & 2] > given->edges[k | 1];

		p->edges[k] = mirrors == (k % 2 == 0) ? half : -half;
	}
	return true;
}

/* Moves the plane of a volume that is nearer to the eye until its distance from the
 * eye is at least min_near and, if it is the near plane, near_ratio times far's. The
 * eye has z under / over, and so the signed distance (under - over z) / over from a
 * plane z. */
static bool keep_off_eye(struct projection *p, struct refusals *faults)
{
	struct projection_volume *v = &p->volume;
	struct sum over, under;

	projection_inverse_eye_z(p, &over, &under);
	double eye = sum_ratio(under, over);
	bool reverse = v->z_near > v->z_far ? eye <= v->z_far : eye >= v->z_far;
	double *nearer = reverse ? &v->z_far : &v->z_near;
	double other = reverse ? v->z_near : v->z_far;

	if (!isfinite(eye))
		return true;
	struct sum far = sum_sub(under, sum_scale(over, other));
	struct sum least = larger(sum_abs(sum_scale(over, p->min_near)),
	    sum_abs(sum_scale(far, reverse ? 0 : p->near_ratio)));

	least = sum_negated_if(sum_sign(far) < 0, least);
	double z = sum_ratio(sum_sub(under, least), over);
	struct sum near = sum_sub(under, sum_scale(over, z));

	if (sum_compare(near, least) * sum_sign(far) < 0)
		z = nextafter(z, other);
	if (*nearer < other ? z >= other : z <= other)
		return refuse(faults, "/projection/min_near",
		    "all of the bounds are nearer to the eye",
		    "a smaller one is wanted, or another eye");
	if (*nearer < other ? z > *nearer : z < *nearer)
		*nearer = z;
	return true;
}

static bool fit_volume(struct scene *s, const struct hull *h, struct refusals *faults)
{
	struct projection_volume *v = &s->projection.volume;
	double sign = convention_looks_back(&s->convention) ? -1 : 1;
	struct extents r;
	struct map clip;

	if (!hull_extents(h, s, &r, faults))
		return false;
	depth_range(&r, &v->z_near, &v->z_far);
	v->z_near *= sign;
	v->z_far *= sign;
	return keep_off_eye(&s->projection, faults) &&
	    scene_map(s, SPACE_VIEW, SPACE_CLIP, &clip, faults);
}

/* Gives valid numbers to those members of a projection that fit is going to find. */
static bool prepare_projection(struct projection *p, struct refusals *faults)
{
	if (projection_is_tilted(p))
		return refuse(faults, "/projection/intrinsics",
		    "the last row of P does not begin 0, 0, 1",
		    "what is fitted is K, or K [R|t] as intrinsics K and a camera "
		    "[R|t]");
	switch (projection_family(p)) {
	case FAMILY_PERSP:
		if (!projection_is_given_at_near(p))
			p->near = 1;
		p->far = 2 * p->near;
		break;
	case FAMILY_PARALLEL:
		p->section.way = SECTION_SIZE;
		p->section.width = p->section.height = 2;
		p->near = 0;
		p->far = 1;
		break;
	case FAMILY_VOLUME:
		break;
	case FAMILY_FIXED:
		return refuse(faults, "/projection/type",
		    "has nothing that can be fitted",
		    "\"persp\", \"ortho\", \"oblique\" or \"volume\" is wanted");
	}
	return true;
}

void fit_check(const struct scene *given, const struct bounds *b,
    struct refusals *faults)
{
	struct scene s = *given;
	struct projection *const p = &s.projection;
	struct hull h;

	if (b != NULL)
		hull_of(b, 3, &h, faults);
	scene_check(&s, SPACE_MODEL, SPACE_WORLD, faults);
	if (s.has_camera)
		camera_check(&s.camera, &s.convention, true, faults);
	if (projection_is_none(p) || !prepare_projection(p, faults))
		return;
	if (projection_family(p) == FAMILY_VOLUME)
		p->volume.z_near = p->volume.z_far = (double)NAN; /* they are found */
	projection_check(p, false, faults);
}

/* Puts the eye at the middle of the bounds' extents along the world axes. */
static bool eye_to_middle(struct scene *s, const struct hull *h,
    struct refusals *faults)
{
	struct map world;
	struct extents r;

	if (!scene_map(s, SPACE_MODEL, SPACE_WORLD, &world, faults))
		return false;
	for (int k = 0; k < 3; k++) {
		extents_set(&r, k, h, &world);
		s->camera.eye[k] = sum_double(extent_middle(&r, k));
	}
	return true;
}

/* Makes the viewport that of the full picture, which is fitted. */
static void show_all(struct viewport *v)
{
	double full[2];

	viewport_full(v, full);
	v->width = full[0];
	v->height = full[1];
	v->has_full = v->has_offset = false;
}

bool fit_scene(struct scene *s, bool has_eye, const struct bounds *b,
    struct refusals *faults)
{
	const struct projection_section given = s->projection.section;
	const struct viewport part = s->viewport;
	bool fits = false;
	struct hull h;

	show_all(&s->viewport);
	if (!hull_of(b, 3, &h, faults) || !prepare_projection(&s->projection, faults) ||
	    !make_gaze_camera(s, faults) || (!has_eye && !eye_to_middle(s, &h, faults)))
		return false;
	switch (projection_family(&s->projection)) {
	case FAMILY_PERSP:
		fits = fit_persp(s, !has_eye && b->n > 0, &h, faults);
		break;
	case FAMILY_PARALLEL:
		fits = fit_parallel(s, has_eye, &given, &h, faults);
		break;
	case FAMILY_VOLUME:
		fits = fit_volume(s, &h, faults);
		break;
	case FAMILY_FIXED: /* prepare_projection has refused it */
		break;
	}
	if (!fits)
		return false;
	if (ex_has_overflowed())
		return scene_refuse_too_wide(s, false, faults);
	s->viewport = part;
	return scene_is_valid(s) || refuse_range(faults);
}

/* fit_scene measures along fit_maps, in persp along the normals of the side planes, and
 * in a volume along the world's axes (eye_to_middle). A move of the eye does not change
 * the normals; keep_side_planes rounds sizes outward, so the margin may shrink. */
bool fit_directions(const struct scene *given, bool has_eye, struct directions *all,
    struct refusals *faults)
{
	struct scene s = *given;
	const enum projection_family family = projection_family(&s.projection);
	bool persp = family == FAMILY_PERSP;
	bool to_middle = !has_eye && family == FAMILY_VOLUME;
	struct map xy, depth, sides, ends, world;

	show_all(&s.viewport);
	if (!prepare_projection(&s.projection, faults) || !make_gaze_camera(&s, faults))
		return false;
	for (int k = 0; k < 3 && !has_eye; k++)
		s.camera.eye[k] = 0;
	if (!fit_maps(&s, &xy, &depth, faults) ||
	    (persp && !frustum_planes(&s, SPACE_MODEL, &sides, &ends, faults)) ||
	    (to_middle && !scene_map(&s, SPACE_MODEL, SPACE_WORLD, &world, faults)))
		return false;
	all->n = 0;
	for (int k = 0; k < 6; k++)
		directions_add(all, k < 4 ? &xy : &depth, k / 2, k & 1);
	for (int k = 0; k < 4 && persp; k++)
		directions_add(all, &sides, k, true);
	for (int k = 0; k < 6 && to_middle; k++)
		directions_add(all, &world, k / 2, k & 1);
	return true;
}

/* Sets the center to the rounded middle of extent j, and the side to twice the distance
 * from the center to the farther end, enlarged by the margin. */
static void enclose_axis(const struct extents *r, int j, double margin, double *center,
    double *side)
{
	*center = sum_double(extent_middle(r, j));
	struct sum c = sum_of_double(*center);
	struct sum most = larger(sum_sub(c, r->low[j]), sum_sub(r->high[j], c));

	*side = ratio_up(sum_scale(most, 2), sum_difference(1, 2 * margin));
}

bool fit_check_window(const struct scene *s, const struct bounds *b, struct hull *h,
    struct refusals *faults)
{
	const struct window *w = &s->window;
	const bool *has = w->has_edge;
	bool is_right = true;

	if (w->by_edges && has[0] && has[1] && w->right < w->left)
		is_right = refuse(faults, "/window/right", "less than left",
		    "fit does not mirror x; swap them");
	return (b == NULL || hull_of(b, 2, h, faults)) && is_right;
}

bool fit_window(struct scene *s, const struct bounds *b, struct refusals *faults)
{
	struct window *w = &s->window;
	const bool down = window_has_y_down(w);
	struct map identity;
	struct extents r;
	struct hull h;

	if (!fit_check_window(s, b, &h, faults))
		return false;
	map_identity(&identity);
	for (int k = 0; k < 2; k++)
		extents_set(&r, k, &h, &identity);
	if (!extents_widen(&r, 2, faults))
		return false;
	*w = (struct window){ .zoom = 1, .y_down = down };
	enclose_axis(&r, 0, s->margin, &w->center[0], &w->width);
	enclose_axis(&r, 1, s->margin, &w->center[1], &w->height);
	if (s->has_device)
		widen_sides(&w->width, &w->height,
		    (const double[]){ s->device.width, s->device.height });
	s->has_window = true;
	return (scene_is_size(w->width) && scene_is_size(w->height)) ||
	    refuse_range(faults);
}

void fit_window_directions(struct directions *all)
{
	struct map identity;

	map_identity(&identity);
	all->n = 0;
	for (int k = 0; k < 4; k++)
		directions_add(all, &identity, k / 2, k & 1);
}
