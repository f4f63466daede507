/* SPDX-License-Identifier: MIT */
#include "sample.h"

#include <math.h>

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The state of the generator splitmix64. */
static uint64_t state;

/* The present sample: its seed, or 0 outside of SAMPLES, its number among those of the
 * seed, and what was sampled last. */
static unsigned seed_now;
static int sample_now;
static enum projection_type type_now;
static int way_now, camera_now, magnitude_now;

static uint64_t next_random(void)
{
	uint64_t z = state += 0x9e3779b97f4a7c15;

	z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
	z = (z ^ z >> 27) * 0x94d049bb133111eb;
	return z ^ z >> 31;
}

void sample_seed(unsigned seed)
{
	state = seed;
}

bool sample_begin(int i, int tries)
{
	const char *given = getenv("SEED");
	int k = (int)((int64_t)i * SEEDS / tries);

	seed_now = 0;
	if (i >= tries)
		return false;
	seed_now = (given != NULL ? (unsigned)atoi(given) : 1) + (unsigned)k;
	sample_now = i - (int)(((int64_t)k * tries + SEEDS - 1) / SEEDS);
	state = (uint64_t)seed_now << 32 | (unsigned)sample_now;
	state = next_random();
	return true;
}

const char *sample_name(void)
{
	static char name[200];

	*name = '\0';
	if (seed_now != 0)
		snprintf(name, sizeof name,
		    "SEED=%u, sample %d: to 1e%d, projection of type %d by "
		    "way %d, camera of kind %d",
		    seed_now, sample_now, magnitude_now, (int)type_now, way_now,
		    camera_now);
	return name;
}

unsigned sample_below(unsigned n)
{
	return (unsigned)(next_random() % n);
}

double sample_unit(void)
{
	return (double)(next_random() >> 11) * 0x1p-53;
}

double sample_between(double a, double b)
{
	return a + (b - a) * sample_unit();
}

double sample_size(int e)
{
	return pow(10, sample_between(-e, e));
}

double sample_number(int e)
{
	double a = sample_size(e);

	switch (sample_below(8)) {
	case 0:
		return 0;
	case 1:
	case 2:
	case 3:
		return -a;
	default:
		return a;
	}
}

static double whole_number(unsigned most)
{
	return (double)sample_below(2 * most + 1) - most;
}

static double ordinary_number(void)
{
	return sample_below(2) ? whole_number(5) : sample_between(-10, 10);
}

static void sample_vector(double v[3], int e)
{
	for (int i = 0; i < 3; i++)
		v[i] = e > 0 ? sample_number(e) : ordinary_number();
}

static const struct convention named_conventions[5] = {
	{ 0 },
	{ true, true, true, false, true, false },
	{ true, false, true, true, false, false },
	{ true, false, true, false, false, false },
	{ true, false, true, true, false, true },
};

void sample_convention(struct convention *c)
{
	*c = named_conventions[sample_below(5)];
	if (sample_below(4) == 0) {
		c->right_handed = sample_below(2);
		c->depth_minus_one = sample_below(2);
		c->ndc_y_down = sample_below(2);
		c->origin_bottom_left = sample_below(2);
		c->view_y_down = sample_below(2);
	}
}

/* Puts a camera up to 1e9 or 1e15 from the origin, and its target within 20 of the eye
 * along each axis. */
static void place_far(struct camera *c)
{
	double far = sample_below(2) ? 1e9 : 1e15;

	for (int i = 0; i < 3; i++) {
		c->eye[i] = far * sample_between(-1, 1);
		c->at[i] = c->eye[i] + sample_between(-20, 20);
	}
}

/* Sets up to nearly the direction of the gaze: elements differ by 1e-15 to 1e-12 of
 * their size. */
static void put_up_near_gaze(struct camera *c)
{
	double near = pow(10, sample_between(-15, -12));

	for (int i = 0; i < 3; i++) {
		double gaze = c->at[i];

		if (c->way == CAMERA_AT)
			gaze -= c->eye[i];
		c->up[i] = gaze * (1 + near * sample_between(-1, 1));
	}
}

/* Samples a rotation vector. If it is hostile, the magnitudes of its elements are
 * mixed, and its length is often next to a multiple of pi / 2, where elements of the
 * matrix are 0. */
static void sample_rotation_vector(double v[3], int e)
{
	double square = 0, length = PI / 2 * (1 + sample_below(4));

	for (int i = 0; i < 3; i++) {
		v[i] = e > 0 ? sample_number(e) : sample_between(-3.6, 3.6);
		if (fabs(v[i]) > 3.6)
			v[i] = 1 / v[i];
		square += v[i] * v[i];
	}
	if (e > 0 && square > 0 && sample_below(2))
		for (int i = 0; i < 3; i++)
			v[i] *= length / sqrt(square);
}

/* Samples one of the 48 frames. */
static void sample_axes(enum camera_axis axes[3])
{
	const unsigned first = sample_below(3), second = sample_below(2);

	for (unsigned i = 0; i < 3; i++) {
		const int line = 1 + (int)((first + (second ? i : 2 * i)) % 3);

		axes[i] = sample_below(2) ? line : -line;
	}
}

void sample_camera(struct camera *c, int e)
{

	memset(c, 0, sizeof *c);
	c->way = sample_below(CAMERA_MATRIX + 1);
	camera_now = (int)c->way;
	magnitude_now = e;
	sample_vector(c->eye, e);
	sample_vector(c->at, e);
	sample_vector(c->up, e);
	if (sample_below(2))
		memcpy(c->up, (double[]){ 0, 1, 0 }, sizeof c->up);
	for (int i = 0; i < 4; i++)
		c->orientation[i] = e > 0 ? sample_number(e) : ordinary_number();
	if (c->way == CAMERA_RVEC || c->way == CAMERA_RVEC_TRANSLATION)
		sample_rotation_vector(c->rvec, e);
	sample_affine(c->steps.matrix, e);
	for (int i = 0; i < 3 && c->way >= CAMERA_ROTATION && c->way < CAMERA_POSE; i++)
		sample_vector(c->rotation[i], e);
	c->has_axes = c->way >= CAMERA_ORIENTATION && sample_below(3) == 0;
	sample_axes(c->axes);
	if (e > 0 && c->way == CAMERA_AT && sample_below(2))
		place_far(c);
	if (e > 0 && c->way < CAMERA_ORIENTATION && sample_below(2))
		put_up_near_gaze(c);
	c->unit = sample_below(4) == 0 ? ANGLE_RADIANS : ANGLE_DEGREES;
	if (sample_below(3) == 0)
		c->roll = 15 * whole_number(24);
	else if (sample_below(2))
		c->roll = e > 0 ? sample_number(150) : sample_between(-180, 180);
}

/* Samples a matrix to orthonormalize: a rotation whose elements have errors of up to
 * 1e-7 or 0.5 of their size. If it is hostile, a rotation with columns scaled by 1e-14
 * to 1. The determinant is positive, unless rounding changed its sign. */
void sample_orthonormalize(struct camera *c, int e)
{
	double q[4], norm = 0, stretch[3];
	double size = e > 0 ? sample_size(140) : 1;
	double drift = sample_below(2) ? 1e-7 : 0.5;

	memset(c, 0, sizeof *c);
	c->way = CAMERA_ROTATION + sample_below(4);
	c->orthonormalize = true;
	c->has_axes = sample_below(3) == 0;
	sample_axes(c->axes);
	for (int i = 0; i < 4; i++) {
		q[i] = sample_between(-1, 1);
		norm += q[i] * q[i];
	}
	for (int k = 0; k < 3; k++)
		stretch[k] = e > 0 ? pow(10, sample_between(-14, 0)) :
				     sample_between(0.5, 2);
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		c->steps.matrix[i][i] = norm - 2 * (q[j] * q[j] + q[k] * q[k]);
		c->steps.matrix[j][i] = 2 * (q[i] * q[j] + q[3] * q[k]);
		c->steps.matrix[k][i] = 2 * (q[i] * q[k] - q[3] * q[j]);
	}
	for (int i = 0; i < 9; i++) {
		double *m = &c->steps.matrix[i / 3][i % 3];

		*m *= size / norm *
		    (e > 0 ? stretch[i % 3] : 1 + drift * sample_between(-1, 1));
	}
	sample_vector(c->steps.matrix[3], e > 0 ? 20 : 0);
	sample_vector(c->eye, e > 0 ? 20 : 0);
	for (int i = 0; i < 9; i++)
		c->rotation[i / 3][i % 3] = c->steps.matrix[i % 3][i / 3];
	c->steps.matrix[3][3] = 1;
}

void sample_affine(double m[4][4], int e)
{
	memset(m, 0, 16 * sizeof m[0][0]);
	for (int i = 0; i < 4; i++)
		sample_vector(m[i], e);
	m[3][3] = 1;
}

static double sample_turn(void)
{
	return sample_below(3) > 0 ? 15 * (double)sample_below(49) - 360 :
				     sample_between(-400, 400);
}

/* An inverse holds some of the steps behind it. */
void sample_steps(struct step *s, int n, int e)
{
	for (int i = 0; i < n; i++, s++) {
		*s = (struct step){ .kind = sample_below(STEP_INVERSE + 1),
			.angle = sample_turn() };
		if (s->kind == STEP_INVERSE) {
			int inner = (int)sample_below((unsigned)(n - i));

			sample_steps(s + 1, inner, e);
			s->inner = inner;
			i += inner;
			s += inner;
			continue;
		}
		sample_vector(s->translation, e);
		for (int k = 0; k < 4; k++)
			s->rotation[k] = sample_between(-1, 1);
		for (int k = 0; k < 3; k++)
			s->scale[k] = sample_size(e) * (sample_below(2) ? 1 : -1);
		if (sample_below(3) == 0)
			s->scale[1] = s->scale[2] = s->scale[0];
		sample_affine(s->matrix, e);
	}
}

static double sample_angle(int e)
{
	if (e == 0)
		return sample_below(2) ? 15 * (1 + sample_below(11)) :
					 sample_between(1, 179);
	switch (sample_below(3)) {
	case 0:
		return pow(10, -e);
	case 1:
		return 180 - pow(2, sample_between(-45, 0));
	default:
		return pow(10, sample_between(-e, 2));
	}
}

static void sample_sides(struct projection_section *s, int e)
{
	s->left = e > 0 ? sample_number(e) : ordinary_number();
	s->bottom = e > 0 ? sample_number(e) : ordinary_number();
	s->right = e > 0 ? sample_number(e) : ordinary_number() + 20;
	s->top = e > 0 ? sample_number(e) : ordinary_number() + 20;
	if (sample_below(3) == 0) {
		s->right = -s->left;
		s->top = -s->bottom;
	}
}

static void sample_planes(struct projection *p, int e)
{
	const enum projection_family family = projection_family(p);

	p->near = e > 0 ? sample_size(e) : 1 + sample_below(9);
	p->far = e > 0 ? p->near + sample_size(e) : p->near * sample_between(1, 1000);
	switch (sample_below(e > 0 ? 3 : 6)) {
	case 0:
		p->far = p->near * (1 + pow(10, sample_between(-15, 0)));
		break;
	case 1:
		p->far = family == FAMILY_PERSP ? (double)INFINITY : -p->near;
		break;
	}
	if (family != FAMILY_PERSP && sample_below(2))
		p->near = -p->near / 2;
	p->shear.plane = sample_below(2) ? p->near : ordinary_number();
	p->reverse_z = sample_below(2) &&
	    (family == FAMILY_PERSP || family == FAMILY_PARALLEL);
}

static void sample_volume(struct projection *p, int e)
{
	struct projection_volume *v = &p->volume;

	v->half_width = e > 0 ? sample_size(e) : 1 + sample_below(9);
	v->half_height = e > 0 ? sample_size(e) : 1 + sample_below(9);
	v->z_near = e > 0 ? sample_number(e) : ordinary_number();
	v->z_far = e > 0 ? sample_number(e) : ordinary_number();
	v->inverse_eye_z = e > 0 ? sample_number(e) : sample_between(-0.1, 0.1);
	if (sample_below(4) == 0)
		v->inverse_eye_z = 0;
	sample_vector(v->eye, e);
	memcpy(v->tan_skew, v->eye, sizeof v->tan_skew);
	v->eye[2] *= e > 0 ? 1 : 10;
	v->eye_given_by = sample_below(3);
	v->view_angle = sample_below(4) == 0 ? 0 : sample_angle(e);
	if (projection_family(p) != FAMILY_VOLUME)
		return;
	if (sample_below(2))
		p->aspect[0] = p->aspect[1] = 0;
	else
		v->half_height = v->half_width; /* size is half the smaller side */
}

/* Converts the angles to radians for one projection in four. Angles that were next to
 * 90 or 180 degrees are next to pi / 2 or pi. */
static void sample_angle_unit(struct projection *p)
{
	double *const angles[] = { &p->section.angle, &p->volume.view_angle,
		&p->shear.projector_angle, &p->shear.direction };
	const double most[] = { PI, PI, PI / 2, HUGE_VAL };

	p->unit = sample_below(4) == 0 ? ANGLE_RADIANS : ANGLE_DEGREES;
	p->shear.direction_unit = p->unit;
	for (int i = 0; i < 4 && p->unit == ANGLE_RADIANS; i++)
		*angles[i] = fmin(*angles[i] * (PI / 180), most[i]);
}

/* Samples the four angles of the edges, with left below right and bottom below top.
 * Hostile angles are next to each other, next to a right angle, or nearly 0. */
static void sample_four_angles(struct projection *p, int e)
{
	double right = p->unit == ANGLE_RADIANS ? PI / 2 : 0x1.67fffffffffffp+6;

	for (int i = 0; i < 4; i += 2) {
		double a = right * sample_between(-0.95, 0);
		double b = right * sample_between(0.01, 0.95);

		if (e == 0 && p->unit == ANGLE_DEGREES && sample_below(3) == 0)
			a = -45;
		if (e == 0 && sample_below(3) == 0)
			b = a + 0.01 + sample_unit() * (right - a - 0.02);
		switch (e > 0 ? sample_below(4) : 4) {
		case 0:
			b = nextafter(a, 1);
			break;
		case 1:
			b = right;
			break;
		case 2:
			a = -pow(10, -e);
			b = pow(10, -e);
			break;
		}
		p->section.angles[i] = a;
		p->section.angles[i + 1] = b;
	}
}

/* Sets the last rows of the 3x4 matrix P, up to all three, to random numbers. */
static void sample_p_rows(double k[3][4], int e)
{
	for (int i = (int)sample_below(3); i < 3; i++)
		for (int j = 0; j < 4; j++)
			k[i][j] = e > 0 ? sample_number(e) : ordinary_number();
}

/* Leaves near and far out of one perspective in four, unless its cross-section is on
 * the near plane. */
static void sample_open(struct projection *p)
{
	if (projection_family(p) != FAMILY_PERSP || projection_is_given_at_near(p) ||
	    sample_below(4) > 0)
		return;
	p->near = 0;
	p->far = HUGE_VAL;
	p->reverse_z = true;
}

/* Samples fx, fy, cx and cy, or a matrix K or P. */
static void sample_intrinsics(struct projection *p, int e)
{
	double(*k)[4] = p->section.intrinsics;
	bool whole = sample_below(3) == 0;

	for (int i = 0; i < 2; i++)
		for (int j = 0; j < 4; j++)
			k[i][j] = e > 0 ? sample_number(e) :
			    whole       ? (double)sample_below(800) :
					  sample_between(0, 800);
	k[0][0] = e > 0 ? sample_size(e) : 100 + sample_between(0, 900);
	k[1][1] = sample_below(2) ? k[0][0] : k[0][0] * 1.01;
	k[1][0] = k[2][0] = k[2][1] = 0;
	k[2][2] = 1;
	k[2][3] = e > 0 ? sample_number(e) : sample_between(-0.01, 0.01);
	if (sample_below(2))
		k[0][1] = 0;
	if (sample_below(2))
		k[0][3] = k[1][3] = k[2][3] = 0;
	if (sample_below(3) == 0)
		sample_p_rows(k, e);
	if (k[2][0] == 0 && k[2][1] == 0 && k[2][2] == 0)
		k[2][2] = 1;
}

void sample_remember(const struct projection *p)
{
	type_now = p->type;
	way_now = projection_family(p) == FAMILY_VOLUME ? (int)p->volume.eye_given_by :
							  (int)p->section.way;
}

void sample_projection(struct projection *p, int e)
{
	struct projection_section *s = &p->section;

	memset(p, 0, sizeof *p);
	p->type = 1 + sample_below(PROJECTION_TYPES - 1);
	s->way = sample_below(SECTION_WAYS);
	if (projection_family(p) != FAMILY_PERSP &&
	    (s->way < SECTION_SIZE || s->way > SECTION_EDGES))
		s->way = SECTION_EDGES;
	s->angle = sample_angle(e);
	s->field = sample_size(e > 0 ? e : 1);
	p->aspect[0] = e > 0 ? sample_size(e) : 640;
	p->aspect[1] = e > 0 ? sample_size(e) : 480;
	s->width = e > 0 ? sample_size(e) : 1 + sample_below(20);
	s->height = e > 0 ? sample_size(e) : 1 + sample_below(20);
	sample_sides(s, e);
	sample_planes(p, e);
	sample_volume(p, e);
	p->shear.kind = sample_below(3);
	p->shear.projector_angle = sample_angle(e) / 2;
	p->shear.direction = 15 * whole_number(24);
	sample_angle_unit(p);
	sample_four_angles(p, e);
	if (s->way == SECTION_INTRINSICS)
		sample_intrinsics(p, e);
	if (projection_family(p) == FAMILY_PERSP && sample_below(3) == 0)
		s->edges_at = e > 0 ? sample_size(e) : 1 + sample_below(9);
	sample_open(p);
	for (int i = 0; i < 4; i++) {
		sample_vector(p->matrix[i], e);
		p->matrix[i][3] = sample_below(2) ? i == 3 : ordinary_number();
	}
	magnitude_now = e;
	sample_remember(p);
}

void sample_viewport(struct viewport *v, int e)
{

	v->x = e > 0 ? sample_number(e) : whole_number(100);
	v->y = e > 0 ? sample_number(e) : whole_number(100);
	v->width = e > 0 ? sample_size(e) : 1 + sample_below(4000);
	v->height = e > 0 ? sample_size(e) : 1 + sample_below(4000);
	v->min_z = sample_below(2) ? 0 : sample_unit();
	v->max_z = sample_below(2) ? 1 : sample_unit();
	v->scale = sample_below(3);
	v->has_full = sample_below(3) == 0 && v->scale == SCALE_FILL;
	v->has_offset = sample_below(3) == 0 && v->scale == SCALE_FILL;
	for (int k = 0; k < 2; k++) {
		const double side = k == 0 ? v->width : v->height;

		v->full[k] = e > 0 ? side * sample_between(0.1, 10) :
				     1 + sample_below(4000);
		v->offset[k] = e > 0 ? side * sample_between(-2, 2) :
				       whole_number(400) / 8;
	}
	v->scales[0] = e > 0 ? sample_size(e) : 1 + sample_below(4000);
	v->scales[1] = e > 0 ? sample_size(e) : 1 + sample_below(4000);
}

void sample_flat(struct window *w, struct device *d, int e)
{

	memset(w, 0, sizeof *w);
	w->by_edges = sample_below(2);
	for (int i = 0; i < 2; i++) {
		w->center[i] = e > 0 ? sample_number(e) : ordinary_number();
		w->pan[i] = e > 0 ? sample_number(e) : ordinary_number();
		w->about[i] = e > 0 ? sample_number(e) : ordinary_number();
	}
	w->width = e > 0 ? sample_size(e) : 1 + sample_below(20);
	w->height = e > 0 ? sample_size(e) : 1 + sample_below(20);
	w->left = w->center[0];
	w->right = w->left + (sample_below(3) ? w->width : -w->width);
	w->bottom = w->center[1];
	w->top = w->bottom + (sample_below(3) ? w->height : -w->height);
	w->y_down = sample_below(3) == 0;
	memset(w->has_edge, true, sizeof w->has_edge);
	w->zoom = sample_below(2) ? 1 :
	    e > 0                 ? sample_size(e) :
				    sample_between(0.1, 10);
	w->has_about = sample_below(2);
	w->adapt = sample_below(3);
	d->x = e > 0 ? sample_number(e) : whole_number(100);
	d->y = e > 0 ? sample_number(e) : whole_number(100);
	d->width = e > 0 ? sample_size(e) : 1 + sample_below(4000);
	d->height = e > 0 ? sample_size(e) : 1 + sample_below(4000);
	d->top_left = sample_below(2);
}

void sample_scene(struct scene *s, int e)
{
	struct projection_section *section = &s->projection.section;
	double full[2];

	memset(s, 0, sizeof *s);
	sample_convention(&s->convention);
	s->has_world = sample_below(2);
	s->has_camera = s->has_viewport = true;
	s->has_window = s->has_device = true;
	sample_affine(s->world.matrix, e);
	if (e > 0 && sample_below(2))
		for (int j = 0; j < 3; j++)
			s->world.matrix[3][j] *= 1e12;
	sample_camera(&s->camera, e);
	sample_projection(&s->projection, e);
	sample_viewport(&s->viewport, e);
	if (s->projection.section.way == SECTION_INTRINSICS) {
		s->viewport.scale = SCALE_FILL;
		viewport_full(&s->viewport, full);
		section->is_sized = sample_below(4) == 0;
		for (int k = 0; k < 2 && section->is_sized; k++)
			full[k] *= sample_between(0.1, 4);
		memcpy(section->intrinsics_size, full, sizeof full);
		section->width = full[0];
		section->height = full[1];
	}
	sample_flat(&s->window, &s->device, e);
}

void sample_answer(struct scene *s)
{
	s->answer = sample_below(2) ? &named_conventions[sample_below(5)] : NULL;
}

static void round_matrix(double m[4][4], int columns)
{
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < columns; j++)
			m[i][j] = whole_number(2);
}

void sample_round_scene(struct scene *s)
{
	struct projection *p = &s->projection;

	do
		sample_scene(s, 0);
	while (projection_family(p) == FAMILY_PARALLEL && p->type != PROJECTION_ORTHO);
	round_matrix(s->world.matrix, 3);
	s->has_camera = sample_below(2);
	s->camera.way = CAMERA_MATRIX;
	s->camera.orthonormalize = false;
	round_matrix(s->camera.steps.matrix, 3);
	round_matrix(p->matrix, 4);
	if (p->section.way < SECTION_SIZE)
		p->section.way = SECTION_SIZE;
}
