/* SPDX-License-Identifier: MIT */
#include "cases.h"

#include <math.h>
#include <string.h>

#include "../test/sample.h"
#include "../test/truth.h"

/* A camera near the origin in the convention gl, with a viewport of 640 x 480. */
static const struct scene ordinary = {
	.convention = { true, true, true, false, true, false },
	.has_camera = true,
	.has_viewport = true,
	.camera = {
		.eye = { 0.3, -0.2, 0.7 },
		.at = { 6.4, 2.1, -2.5 },
		.up = { 0, 1, 0 },
	},
	.projection = {
		.type = PROJECTION_PERSP,
		.section.way = SECTION_FOVY,
		.section.angle = 50,
		.aspect = { 640, 480 },
		.near = 1,
		.far = 100,
	},
	.viewport = { .width = 640, .height = 480, .max_z = 1 },
};

/* Moves the eye and the point at which it looks far from the origin. */
static void far_from_origin(struct scene *s, double distance)
{
	static const double direction[3] = { 0.6, -0.5, 0.625 };

	for (int i = 0; i < 3; i++) {
		double gaze = s->camera.at[i] - s->camera.eye[i];

		s->camera.eye[i] += distance * direction[i];
		s->camera.at[i] = s->camera.eye[i] + gaze;
	}
}

/* Moves the model far from the origin of the world, and the camera with it. */
static void far_in_the_world(struct scene *s, double distance)
{
	s->has_world = true;
	for (int i = 0; i < 4; i++)
		s->world.matrix[i][i] = 1;
	far_from_origin(s, distance);
	for (int i = 0; i < 3; i++)
		s->world.matrix[3][i] = s->camera.at[i];
}

static void look_ahead(struct scene *s)
{
	memset(s->camera.eye, 0, sizeof s->camera.eye);
	memcpy(s->camera.at, (double[]){ 0, 0, -1 }, sizeof s->camera.at);
}

/* The picture is a small rectangle off the axis, as of one screen in a wall of screens.
 */
static void tile(struct scene *s, double size)
{
	struct projection *p = &s->projection;

	look_ahead(s);
	p->section.way = SECTION_EDGES;
	p->section.left = 0.3;
	p->section.right = p->section.left + size;
	p->section.bottom = -0.2;
	p->section.top = p->section.bottom + 0.75 * size;
}

/* World x is x + shear y. The points in sight are those where x and shear y cancel. */
static void cancelling(struct scene *s, double shear)
{
	look_ahead(s);
	s->has_world = true;
	for (int i = 0; i < 4; i++)
		s->world.matrix[i][i] = 1;
	s->world.matrix[1][0] = shear;
}

/* The device has the size 1e-150, and shows a view volume of half width size. */
static void underflowing(struct scene *s, double size)
{
	s->has_camera = false;
	s->projection = (struct projection){
		.type = PROJECTION_VOLUME,
		.volume.half_width = size,
		.volume.half_height = size,
		.volume.z_far = -1,
	};
	s->viewport = (struct viewport){ .x = -0.5e-150,
		.y = -0.5e-150,
		.width = 1e-150,
		.height = 1e-150,
		.max_z = 1 };
}

/* The near plane has ndc depth 1, and points at infinity have -1. */
static void reversed_matrix(struct scene *s, double near)
{
	const double m[4][4] = { { 1.6 }, { 0, 2.1 }, { 0, 0, 1, -1 },
		{ 0, 0, 2 * near, 0 } };

	s->projection = (struct projection){ .type = PROJECTION_MATRIX, .near = near };
	memcpy(s->projection.matrix, m, sizeof m);
	s->viewport.max_z = 0x1p24 - 1;
}

/* Up differs from the gaze in the smallest coordinate only, as that has the smallest
 * steps. The gaze has no rounding error, so that up is exactly parallel to it if the
 * angle is 0. */
static void up_near_gaze(struct scene *s, double angle)
{
	double gaze[3];

	memcpy(s->camera.eye, (double[]){ 0.25, -0.125, 0.75 }, sizeof s->camera.eye);
	memcpy(s->camera.at, (double[]){ 6.375, 2.125, -2.5 }, sizeof s->camera.at);
	for (int i = 0; i < 3; i++)
		gaze[i] = s->camera.at[i] - s->camera.eye[i];
	memcpy(s->camera.up, gaze, sizeof gaze);
	s->camera.up[1] += 8 * angle;
}

static void eye_near_at(struct scene *s, double distance)
{
	static const double direction[3] = { 0.6, -0.5, 0.625 };

	for (int i = 0; i < 3; i++) {
		s->camera.eye[i] = 0;
		s->camera.at[i] = distance * direction[i];
	}
}

/* The near plane is at world z = 0, so that doubles are dense between near and far.
 * Device z is in steps of a depth buffer of 24 bits. */
static void depth_range(struct scene *s, double extent)
{
	memcpy(s->camera.eye, (double[]){ 0, 0, 0.7 }, sizeof s->camera.eye);
	memset(s->camera.at, 0, sizeof s->camera.at);
	s->projection.near = 0.7;
	s->projection.far = 0.7 * (1 + extent);
	s->viewport.max_z = 0x1p24 - 1;
}

/* Points are at distance 1, and near is a fraction of 1. Device z is scaled so that, at
 * distance 1, it grows by 1 per unit of distance, wherever near is. */
static void normal_depth(struct scene *s, double distance_over_near)
{
	s->convention.depth_minus_one = false;
	s->projection.near = 1 / distance_over_near;
	s->projection.far = HUGE_VAL;
	s->viewport = (struct viewport){ .width = 1,
		.height = 0.75,
		.max_z = distance_over_near };
}

static void reversed_depth(struct scene *s, double distance_over_near)
{
	normal_depth(s, distance_over_near);
	s->projection.reverse_z = true;
}

static void narrow(struct scene *s, double angle)
{
	s->projection.section.angle = angle;
}

static void wide(struct scene *s, double less_than_180)
{
	look_ahead(s);
	s->projection.section.angle = 180 - less_than_180;
}

static void nearly_parallel(struct scene *s, double inverse_eye_z)
{
	s->has_camera = false;
	s->projection = (struct projection){
		.type = PROJECTION_VOLUME,
		.volume.half_width = 400,
		.volume.half_height = 300,
		.volume.z_far = -20000,
		.volume.inverse_eye_z = inverse_eye_z,
	};
}

/* Sets near, which is also the depth of the points. */
static void eye_plane(struct scene *s, double depth)
{
	s->projection.near = depth;
}

static void whole_scene(struct scene *s, double size)
{
	struct projection *p = &s->projection;

	for (int i = 0; i < 3; i++) {
		s->camera.eye[i] *= size;
		s->camera.at[i] *= size;
	}
	p->near *= size;
	p->far = 8 * p->near;
}

/* A window that zooms about a point other than its centre. */
static void zoomed(struct scene *s, double extent)
{
	s->has_camera = s->has_viewport = false;
	s->projection.type = PROJECTION_NONE;
	s->has_window = s->has_device = true;
	s->window = (struct window){
		.center = { 1e9, 1.1e9 },
		.width = 1e9,
		.height = 0.75e9,
		.zoom = 1 / extent,
		.has_about = true,
		.about = { 1234567891.2, 987654321.3 },
	};
	s->device = (struct device){ .width = 640, .height = 480 };
}

static void deep(struct scene *s, double ratio)
{
	s->projection.far = 1000;
	s->projection.near = 1000 / ratio;
}

static void turned(struct scene *s, double turns)
{
	s->camera.roll = TURN * turns;
}

static void turned_and_squared(struct scene *s, double turns)
{
	turned(s, turns);
	s->camera.orthonormalize = true;
}

/* Places a point on the screen that has this z in view space. */
static void on_screen(const struct map *clip, double z, double p[3])
{
	double w = z * element(clip, 2, 3) + element(clip, 3, 3);

	for (int i = 0; i < 2; i++)
		p[i] = sample_between(-1, 1) * w / element(clip, i, i);
	p[2] = z;
}

static void in_frustum(const struct projection *v, const struct map *clip, double p[3])
{
	double n = v->near, f = fmin(v->far, 1e6 * n);
	double t = sample_unit();

	on_screen(clip, -(f > 4 * n ? n * pow(f / n, t) : n + (f - n) * t), p);
}

/* Places a point between the planes of a volume. A 2D window has no planes, so z is 0.
 */
static void in_volume(const struct projection *v, const struct map *clip, double p[3])
{
	on_screen(clip, sample_between(v->volume.z_far, v->volume.z_near), p);
}

static void in_last_decade(const struct projection *v, const struct map *clip,
    double p[3])
{
	on_screen(clip, -v->far * sample_between(0.1, 1), p);
}

/* Places a point in a picture that is given by edges, and is off the axis. */
static void on_tile(const struct projection *v, const struct map *clip, double p[3])
{
	double z = -sample_between(1, 4) * v->near, w = -z;

	for (int i = 0; i < 2; i++)
		p[i] = (sample_between(-1, 1) * w - z * element(clip, 2, i)) /
		    element(clip, i, i);
	p[2] = z;
}

/* Places a point whose x and y range from 1e-15 to 1 in magnitude. */
static void tiny(const struct projection *v, const struct map *clip, double p[3])
{
	(void)v;
	(void)clip;
	for (int i = 0; i < 3; i++)
		p[i] = sample_number(15) * 1e-8;
	p[2] = -sample_unit();
}

static void beyond_near(const struct projection *v, const struct map *clip, double p[3])
{
	on_screen(clip, -v->near * pow(1e9, sample_unit()), p);
}

static void at_unit_distance(const struct projection *v, const struct map *clip,
    double p[3])
{
	(void)v;
	on_screen(clip, -sample_between(1, 2), p);
}

static void beside_eye(const struct projection *v, const struct map *clip, double p[3])
{
	on_screen(clip, -v->near * sample_between(1, 2), p);
	for (int i = 0; i < 2; i++)
		p[i] /= v->near;
}

#define ALL ((1 << OUR_SINGLE) - 1)

const struct regime regimes[REGIMES] = {
	{ "distance", "Far from the origin", "distance", { 0, 15, 1, 0 },
	    far_from_origin, in_frustum, false,
	    1 << SINGLE | 1 << COMPOSED | 1 << STAGED, 10 },
	{ "up", "Up close to the gaze", "angle between, radians", { 0, -15, -1, -400 },
	    up_near_gaze, in_frustum, false, ALL, 1 },
	{ "wide", "Wide field of view", "180 - degrees", { 0, -10, -1, 0 }, wide,
	    in_frustum, false, ALL, 1e-3 },
	{ "narrow", "Narrow field of view", "degrees", { -1, -9, -1, 0 }, narrow,
	    in_frustum, false, ALL, 1e-3 },
	{ "depth", "Near and far close: depth", "far/near - 1", { 15, -15, -2, 400 },
	    depth_range, in_frustum, false, ALL, 1 },
	{ "unproject", "From the screen to the world", "far/near", { 2, 12, 1, 0 },
	    deep, in_last_decade, true, ALL, 1e-3 },
	{ "plane", "Points close to the eye plane", "depth of the points",
	    { 0, -17, -1, 0 }, eye_plane, beside_eye, false, ALL, 1 },
	{ "zoom", "Deep zoom in 2D", "part of the window in sight", { 0, -15, -1, 0 },
	    zoomed, in_volume, false, ALL, 1 },
	{ "volume", "Almost parallel projection", "1 / eye z", { -3, -15, -1, -300 },
	    nearly_parallel, in_volume, false, ALL, 1e-3 },
	{ "turns", "Turned by small rotations", "number of turns", { 0, 6, 1, 0 },
	    turned, in_frustum, false, ALL, 1e-9 },
	{ "squared", "Turned, then orthonormalized", "number of turns", { 0, 6, 1, 0 },
	    turned_and_squared, in_frustum, false,
	    1 << SINGLE | 1 << COMPOSED | 1 << STAGED, 1e-9 },
	{ "at", "Eye close to what it looks at", "distance", { 0, -150, -10, 0 },
	    eye_near_at, in_frustum, false, 1 << SINGLE, 1 },
	{ "size", "Size of the whole scene", "unit of length", { -150, 149, 13, 0 },
	    whole_scene, in_frustum, false, 1 << SINGLE, 1 },
	{ "world", "A model far from the origin", "distance", { 0, 15, 1, 0 },
	    far_in_the_world, in_frustum, false,
	    1 << SINGLE | 1 << COMPOSED | 1 << STAGED, 10 },
	{ "tiles", "Off-axis tiles of a wall", "size of a tile", { 0, -15, -1, 0 },
	    tile, on_tile, false, ALL, 1 },
	{ "cancel", "Total cancellation", "shear", { 0, 40, 2, 0 }, cancelling,
	    in_frustum, false, ALL, 1 },
	{ "underflow", "Underflow on the way", "size of the volume", { 0, 150, 10, 0 },
	    underflowing, tiny, false, 1 << SINGLE, 0 },
	{ "reversed", "Reversed depth from a matrix", "near", { 0, -15, -1, 0 },
	    reversed_matrix, beyond_near, false, 1 << SINGLE, 1e-3 },
	{ "back", "There and back, far from the origin", "distance", { 0, 15, 1, 0 },
	    far_from_origin, in_frustum, true, 1 << SINGLE | 1 << COMPOSED, 10 },
	{ "normal depth", "Depth at a distance", "distance over near", { 0, 15, 1, 0 },
	    normal_depth, at_unit_distance, false, 1 << SINGLE, 0.5 },
	{ "reversed depth", "Reversed depth at a distance", "distance over near",
	    { 0, 15, 1, 0 }, reversed_depth, at_unit_distance, false, 0, 0 },
};

void regime_scene(const struct regime *r, double severity, struct scene *s)
{
	*s = ordinary;
	r->scene(s, severity);
}

int regime_sweep(const struct regime *r, double severity[ROWS])
{
	const struct sweep *s = &r->sweep;
	int n = 0, last = s->last * s->step;

	for (int e = s->first; e * s->step <= last; e += s->step)
		severity[n++] = pow(10, e);
	if (s->beyond != 0)
		severity[n++] = pow(10, s->beyond);
	return n;
}
