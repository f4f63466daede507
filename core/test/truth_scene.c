/* SPDX-License-Identifier: MIT */
#include "truth.h"

#include <math.h>
#include <string.h>

#define ONE real_of(1)
#define TWO real_of(2)

/* Adds the stages p' = p A and p' = p + t of an affine matrix. The elements of A's
 * nearest rotation are sums of products of a unit quaternion's elements, of size 2 at
 * most. */
static void affine(struct truth *t, const double m[4][4])
{
	struct truth_stage *s = truth_stage(t);

	for (int i = 0; i < 3; i++)
		set_reals(s->m[i], 3, m[i]);
	set_reals(truth_stage(t)->m[3], 3, m[3]);
}

/* Replaces the stages of an affine matrix by the nearest rotation
 * and the translation. */
static void nearest_rotation(struct truth *t)
{
	truth_compose(t);
	*t = (struct truth){ .irrational = true, .product = t->product };
	struct truth_stage *s = truth_stage(t), *move = truth_stage(t);

	for (int i = 0; i < 9; i++)
		s->m[i / 3][i % 3] = t->product.m[i / 3][i % 3];
	orthonormalise(s->m);
	for (int i = 0; i < 9; i++)
		s->size[i / 3][i % 3] = TWO;
	for (int k = 0; k < 3; k++) {
		move->m[3][k] = t->product.m[3][k];
		move->size[3][k] = t->product.size[3][k];
	}
}

/* Sets the columns of m to the camera's axes: z = unit(at - eye), or unit(eye - at) if
 * right-handed; x = unit(up x z); y = z x x. */
static void look_at(const struct camera *c, bool right_handed, real m[4][4])
{
	real x[3], y[3], z[3], up[3], eye[3];

	set_reals(up, 3, c->up);
	set_reals(eye, 3, c->eye);
	set_reals(z, 3, c->at);
	for (int i = 0; i < 3; i++) {
		if (c->way == CAMERA_AT)
			z[i] = sub(z[i], eye[i]);
		if (right_handed)
			z[i] = negative(z[i]);
	}
	normalise(z, 3);
	cross(up, z, x);
	normalise(x, 3);
	cross(z, x, y);
	for (int i = 0; i < 3; i++) {
		m[i][0] = x[i];
		m[i][1] = y[i];
		m[i][2] = z[i];
	}
}

/* Sets m to the rotation matrix of a quaternion, x y z w. Its columns are the camera's
 * axes. */
static void quaternion_matrix(const double orientation[4], real m[4][4])
{
	real q[4];

	set_reals(q, 4, orientation);
	normalise(q, 4);
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		m[i][i] = sub(ONE, mul(TWO, add(mul(q[j], q[j]), mul(q[k], q[k]))));
		m[j][i] = mul(TWO, add(mul(q[i], q[j]), mul(q[3], q[k])));
		m[k][i] = mul(TWO, sub(mul(q[i], q[k]), mul(q[3], q[j])));
	}
}

/* Sets the stage to the rotation of cv::Rodrigues, cos I + (1 - cos) u u' + sin [u]x,
 * about the unit vector u = axis / |axis|. It is for column
 * vectors: here transposed. */
static void rotation(const double axis[3], real c, real s, struct truth_stage *stage)
{
	real(*m)[4] = stage->m;
	real u[3];

	set_reals(u, 3, axis);
	normalise(u, 3);
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;
		real both = mul(sub(ONE, c), mul(u[i], u[j]));
		real turn = mul(s, u[k]);

		m[i][i] = add(c, mul(sub(ONE, c), mul(u[i], u[i])));
		m[j][i] = sub(both, turn);
		m[i][j] = add(both, turn);
		stage->size[i][i] = TWO;
		stage->size[i][j] = add(magnitude(both), magnitude(turn));
		stage->size[j][i] = stage->size[i][j];
	}
}

static void rodrigues(const double rvec[3], struct truth_stage *stage)
{
	real u[3], angle, c = real_of(0), s = real_of(0);

	set_reals(u, 3, rvec);
	angle = root(dot(u, u, 3));
	mpfr_sin_cos(s, c, angle, MPFR_RNDN);
	if (!mpfr_zero_p(angle))
		rotation(rvec, c, s, stage);
}

static void invert_stages(struct truth *);

static void add_stages(struct truth *t, const struct truth *r)
{
	t->irrational |= r->irrational;
	for (int i = 0; i < r->n; i++)
		t->stage[t->n++] = r->stage[i];
}

static void scaling(const double s[3], struct truth_stage *stage)
{
	for (int k = 0; k < 3; k++)
		stage->m[k][k] = real_of(s[k]);
}

/* Sets the stage to the rotation that turns the axes to those of the quaternion. */
static void turn(const double q[4], struct truth_stage *stage)
{
	real m[4][4];

	set_identity(m);
	quaternion_matrix(q, m);
	for (int i = 0; i < 9; i++)
		stage->m[i / 3][i % 3] = m[i % 3][i / 3];
}

/* Adds the stages of a step that has no steps inside. */
static void step(struct truth *t, const struct step *s, bool radians)
{
	const double *q = s->rotation, wxyz[4] = { q[1], q[2], q[3], q[0] };
	double axis[3] = { 0 };
	real c = cosine(s->angle, radians), sn = sine(s->angle, radians);

	switch (s->kind) {
	case STEP_NODE:
		scaling(s->scale, truth_stage(t));
		turn(q, truth_stage(t));
		set_reals(truth_stage(t)->m[3], 3, s->translation);
		return;
	case STEP_TRANSLATE:
		set_reals(truth_stage(t)->m[3], 3, s->translation);
		return;
	case STEP_SCALE:
		scaling(s->scale, truth_stage(t));
		return;
	case STEP_QUATERNION:
	case STEP_QUATERNION_WXYZ:
		turn(s->kind == STEP_QUATERNION ? q : wxyz, truth_stage(t));
		return;
	case STEP_MATRIX:
		affine(t, s->matrix);
		return;
	case STEP_RVEC:
		rodrigues(q, truth_stage(t));
		break;
	case STEP_ROTATE:
		rotation(q, c, sn, truth_stage(t));
		break;
	default:
		axis[s->kind - STEP_ROTATE_X] = 1;
		rotation(axis, c, sn, truth_stage(t));
	}
	t->irrational = true;
}

/* Adds the stages of the steps from s to `end`. */
static void steps(struct truth *t, const struct step *s, const struct step *end,
    bool radians)
{
	for (; s < end; s += 1 + s->inner) {
		struct truth r = { 0 };

		if (s->kind == STEP_INVERSE) {
			steps(&r, s + 1, s + 1 + s->inner, radians);
			invert_stages(&r);
		} else {
			step(&r, s, radians);
		}
		add_stages(t, &r);
	}
}

/* Adds the stages of a matrix or the steps that replace it. */
static void affine_or_steps(struct truth *t, const struct steps *s)
{
	if (s->step == NULL)
		affine(t, s->matrix);
	else
		steps(t, s->step, s->step + s->n, s->unit == ANGLE_RADIANS);
}

/* Adds the stages of a camera that is given by its matrix or pose. */
static void camera_by_matrix(struct truth *t, const struct camera *c)
{
	struct truth r = { 0 };

	affine_or_steps(&r, &c->steps);
	if (c->orthonormalize)
		nearest_rotation(&r);
	if (c->way == CAMERA_POSE)
		invert_stages(&r);
	add_stages(t, &r);
}

/* Adds the stage from the camera's own frame to view space: of the vectors right, up
 * and forward, the rows are their coordinates in the frame, and the columns those in
 * view. */
static void own_axes(struct truth *t, const struct camera *c,
    const struct convention *convention)
{
	struct truth_stage *s = truth_stage(t);
	const double view[3] = { 1, convention->view_y_down ? -1 : 1,
		truth_gaze_sign(convention) };

	for (int i = 0; i < 3 && c->has_axes; i++)
		for (int k = 0; k < 3; k++)
			s->m[i][k] = real_of(c->axes[i] == k + 1 ? view[k] :
				c->axes[i] == -k - 1             ? -view[k] :
								   0);
}

/* Adds the stages of R of [R|t]. */
static void camera_by_rotation(struct truth *t, const struct camera *c)
{
	struct truth r = { 0 };
	double m[4][4] = { 0 };

	for (int i = 0; i < 9; i++)
		m[i % 3][i / 3] = c->rotation[i / 3][i % 3];
	affine(&r, m);
	if (c->orthonormalize)
		nearest_rotation(&r);
	add_stages(t, &r);
}

/* Adds the stages from world to view space. The roll turns the image while y is up. */
static void camera(struct truth *t, const struct camera *c,
    const struct convention *convention)
{
	if (c->way >= CAMERA_POSE) {
		camera_by_matrix(t, c);
		own_axes(t, c, convention);
		return;
	}
	bool down = convention->view_y_down, by_axes = c->way > CAMERA_GAZE;
	bool by_eye = camera_has_eye(c);
	bool by_rvec = c->way == CAMERA_RVEC || c->way == CAMERA_RVEC_TRANSLATION;
	struct truth_stage *eye = truth_stage(t);

	if (!by_axes || by_rvec || c->roll != 0)
		t->irrational = true;
	if (c->way >= CAMERA_ROTATION)
		camera_by_rotation(t, c);
	else if (by_rvec)
		rodrigues(c->rvec, truth_stage(t));
	else if (by_axes)
		quaternion_matrix(c->orientation, truth_stage(t)->m);
	else
		look_at(c, convention->right_handed, truth_stage(t)->m);
	struct truth_stage *origin = truth_stage(t);

	for (int i = 0; i < 3; i++)
		(by_eye ? eye : origin)->m[3][i] = real_of(
		    by_eye ? -c->eye[i] : c->eye[i]);
	own_axes(t, c, convention);
	if (down && by_axes)
		truth_half_turn(t);
	struct truth_stage *roll = truth_stage(t);

	/* for row vectors: [cos sin; -sin cos] */
	roll->m[0][0] = roll->m[1][1] = cosine(c->roll, c->unit);
	roll->m[0][1] = sine(c->roll, c->unit);
	roll->m[1][0] = negative(sine(c->roll, c->unit));
	if (down)
		truth_half_turn(t);
}

double truth_gaze_sign(const struct convention *c)
{
	return c->right_handed == c->view_y_down ? 1 : -1;
}

/* Sets axis i of a stage to x' = x + side / 2 + scale X. */
static void to_device(struct truth_stage *s, int i, double x, double side, real scale)
{
	s->m[i][i] = scale;
	s->m[3][i] = add(real_of(x), divide(real_of(side), TWO));
}

static void viewport(struct truth *t, const struct viewport *v,
    const struct convention *c)
{
	struct truth_stage *s = truth_stage(t);
	real sx = divide(real_of(v->width), TWO);
	real sy = divide(real_of(v->height), TWO);
	real min = real_of(v->min_z), max = real_of(v->max_z);

	if (v->scale == SCALE_UNIFORM)
		sx = sy = v->width > v->height ? sx : sy;
	if (v->scale == SCALE_GIVEN) {
		sx = real_of(v->scales[0]);
		sy = real_of(v->scales[1]);
	}
	to_device(s, 0, v->x, v->width, sx);
	to_device(s, 1, v->y, v->height,
	    c->ndc_y_down == c->origin_bottom_left ? negative(sy) : sy);
	/* from Z = 0 to 1; if Z is from -1 to 1, (Z + 1) / 2 takes its place */
	s->m[2][2] = sub(max, min);
	s->m[3][2] = min;
	if (c->depth_minus_one) {
		s->m[2][2] = divide(sub(max, min), TWO);
		s->m[3][2] = divide(add(max, min), TWO);
	}
}

/* Adds the stage from clip space of the full picture to that of the part: by way of
 * units of the device from the corner of the origin, of the whole and of the part. */
static void part(struct truth *t, const struct viewport *v, const struct convention *c)
{
	const double size[2] = { v->width, v->height };
	const double *whole = v->has_full ? v->full : size;

	if (!v->has_full && !v->has_offset)
		return;
	for (int k = 0; k < 2; k++) {
		const bool up = c->origin_bottom_left != c->ndc_y_down;
		const double sign = k == 1 && !up ? -1 : 1;
		real half = divide(real_of(whole[k]), TWO);
		real side = divide(real_of(size[k]), TWO);
		struct truth_stage *to = truth_stage(t), *move = truth_stage(t),
				   *back = truth_stage(t);

		to->m[k][k] = mul(half, real_of(sign));
		to->m[3][k] = half;
		move->m[3][k] = real_of(v->has_offset ? -v->offset[k] : 0);
		back->m[k][k] = divide(real_of(sign), side);
		back->m[3][k] = real_of(-sign);
	}
}

static void device(struct truth *t, const struct device *d)
{
	struct truth_stage *s = truth_stage(t);
	real sx = divide(real_of(d->width), TWO);
	real sy = divide(real_of(d->height), TWO);

	to_device(s, 0, d->x, d->width, sx);
	to_device(s, 1, d->y, d->height, d->top_left ? negative(sy) : sy);
}

/* Sets one side of the window so that it has the shape of the device. */
static void adapt(const struct window *w, const struct device *d, real size[2])
{
	real shape = divide(real_of(d->width), real_of(d->height));
	bool wider = mpfr_cmp(shape, divide(size[0], size[1])) > 0;

	if (w->adapt == ADAPT_STRETCH)
		return;
	if (wider == (w->adapt == ADAPT_GROW))
		size[0] = mul(size[1], shape);
	else
		size[1] = divide(size[0], shape);
}

/* Adds the stage from window to ndc: a translation by the negative centre, and the
 * scales 2 / width and 2 / height. */
static void window(struct truth *t, const struct window *w, const struct device *d)
{
	struct truth_stage *s = truth_stage(t);
	real c[2], size[2], from[2], to[2], about[2], zoom = real_of(w->zoom);
	double sign[2] = { 1, w->y_down && !w->by_edges ? -1 : 1 };

	set_reals(c, 2, w->center);
	set_reals(size, 2, (double[]){ w->width, w->height });
	set_reals(from, 2, (double[]){ w->left, w->bottom });
	set_reals(to, 2, (double[]){ w->right, w->top });
	set_reals(about, 2, w->about);
	for (int i = 0; i < 2; i++) {
		if (w->by_edges) {
			c[i] = divide(add(from[i], to[i]), TWO);
			size[i] = sub(to[i], from[i]);
			sign[i] = mpfr_sgn(size[i]);
			size[i] = magnitude(size[i]);
		}
		c[i] = add(c[i], real_of(w->pan[i]));
		if (w->has_about)
			c[i] = add(about[i], divide(sub(c[i], about[i]), zoom));
		size[i] = divide(size[i], zoom);
	}
	adapt(w, d, size);
	for (int i = 0; i < 2; i++) {
		s->m[i][i] = divide(real_of(2 * sign[i]), size[i]);
		s->m[3][i] = negative(mul(c[i], s->m[i][i]));
	}
}

/* Sets the sizes of the inverse r of a stage s to |r| (sizes of s) |r| + |r|, as an
 * error E of s changes r by r E r. */
static void size_inverse(const struct truth_stage *s, struct truth_stage *r)
{
	for (int i = 0; i < 16; i++) {
		real size = real_of(0);

		for (int k = 0; k < 16; k++)
			if (s->size[k / 4][k % 4] != NULL)
				size = add(size,
				    mul(magnitude(r->m[i / 4][k / 4]),
					mul(s->size[k / 4][k % 4],
					    magnitude(r->m[k % 4][i % 4]))));
		r->size[i / 4][i % 4] = add(size, magnitude(r->m[i / 4][i % 4]));
	}
}

/* Replaces the stages by their inverses, in reverse order. The sizes of a rotation are
 * also those of its inverse. */
static void invert_stages(struct truth *t)
{
	struct truth r = { .n = t->n, .irrational = t->irrational };

	for (int i = 0; i < t->n; i++) {
		struct truth_stage *s = &t->stage[t->n - 1 - i];
		bool rotation = s->size[0][1] != NULL;

		set_inverse(r.stage[i].m, s->m);
		if (rotation)
			memcpy(r.stage[i].size, s->size, sizeof s->size);
		else if (s->size[0][0] != NULL)
			size_inverse(s, &r.stage[i]);
	}
	*t = r;
}

void truth_limits(const struct scene *s, real limit[2])
{
	const struct viewport *v = &s->viewport;
	const double side[2] = { v->width, v->height };

	for (int k = 0; k < 2; k++) {
		double scale = v->scale == SCALE_FILL ? side[k] / 2 :
		    v->scale == SCALE_GIVEN           ? v->scales[k] :
							fmax(side[0], side[1]) / 2;

		limit[k] = s->has_viewport ?
		    divide(real_of(side[k] / 2), real_of(scale)) :
		    ONE;
		limit[k] = mul(limit[k], sub(ONE, real_of(2 * s->margin)));
	}
}

static bool crosses(enum space a, enum space b, enum space below)
{
	return (a <= below) != (b <= below);
}

const struct convention *truth_answer(const struct scene *s)
{
	return s->answer != NULL ? s->answer : &s->convention;
}

/* Adds the stage from the view space of the scene to that of the answer, in which y and
 * z may point the other way. */
static void convert_view(struct truth *t, const struct scene *s)
{
	const struct convention *a = truth_answer(s);

	if (s->answer == NULL)
		return;
	struct truth_stage *turn = truth_stage(t);

	if (a->view_y_down != s->convention.view_y_down)
		turn->m[1][1] = real_of(-1);
	turn->m[2][2] = real_of(truth_gaze_sign(a) * truth_gaze_sign(&s->convention));
}

/* Adds the stage from the clip space of the scene to that of the answer. Z from 0 to 1
 * becomes 2 Z - 1, from -1 to 1. */
static void convert_clip(struct truth *t, const struct scene *s)
{
	const struct convention *a = truth_answer(s), *c = &s->convention;

	if (s->answer == NULL)
		return;
	struct truth_stage *turn = truth_stage(t);

	if (a->ndc_y_down != c->ndc_y_down)
		turn->m[1][1] = real_of(-1);
	if (a->depth_minus_one && !c->depth_minus_one) {
		turn->m[2][2] = TWO;
		turn->m[3][2] = real_of(-1);
	}
	if (c->depth_minus_one && !a->depth_minus_one)
		turn->m[2][2] = turn->m[3][2] = divide(ONE, TWO);
}

void truth_scene(const struct scene *s, enum space from, enum space to, struct truth *t)
{
	const struct convention *c = &s->convention;

	t->n = 0;
	t->irrational = false;
	if (s->has_world && crosses(from, to, SPACE_MODEL))
		affine_or_steps(t, &s->world);
	if (s->has_camera && crosses(from, to, SPACE_WORLD))
		camera(t, &s->camera, c);
	if (crosses(from, to, SPACE_WORLD))
		convert_view(t, s);
	if (crosses(from, to, SPACE_VIEW)) {
		convert_view(t, s);
		truth_projection(t, &s->projection, c);
		if (s->has_viewport)
			part(t, &s->viewport, c);
		convert_clip(t, s);
	}
	if (crosses(from, to, SPACE_NDC))
		viewport(t, &s->viewport, truth_answer(s));
	if (from > to)
		invert_stages(t);
	truth_compose(t);
}

void truth_matrix(const struct scene *s, enum space from, enum space to, real m[4][4])
{
	struct truth t;

	truth_scene(s, from, to, &t);
	memcpy(m, t.product.m, sizeof t.product.m);
}

void truth_flat(const struct scene *s, enum space from, enum space to, struct truth *t)
{
	t->n = 0;
	t->irrational = false;
	if ((from == FLAT_WINDOW) != (to == FLAT_WINDOW))
		window(t, &s->window, &s->device);
	if ((from == FLAT_DEVICE) != (to == FLAT_DEVICE))
		device(t, &s->device);
	if (from > to)
		invert_stages(t);
	truth_compose(t);
}

static struct sized sized_limit(real limit)
{
	return (struct sized){ limit, magnitude(limit) };
}

/* Returns whether depth is reversed. The near plane of a matrix, as the manual says,
 * has the smaller positive w or, if w is constant, comes first along the gaze or, if
 * the matrix contains a camera, has the smaller depth. Depth is linear in 1/w. */
static bool is_reversed(const struct scene *s)
{
	struct truth back = { 0 };
	const double near[4] = { 0, 0, truth_answer(s)->depth_minus_one ? -1 : 0, 1 };
	const double far[4] = { 0, 0, 1, 1 };

	if (s->projection.type != PROJECTION_MATRIX)
		return s->projection.reverse_z;
	truth_scene(s, SPACE_CLIP, SPACE_VIEW, &back);
	struct sized w = sized_sub(truth_column(&back, 3, near),
	    truth_column(&back, 3, far));

	if (truth_sign(w, NULL) != 0)
		return truth_sign(w, NULL) < 0;
	/* w is constant, of either sign */
	struct sized z = sized_sub(truth_column(&back, 2, far),
	    truth_column(&back, 2, near));
	const double(*m)[4] = s->projection.matrix;

	/* such a matrix contains a camera: its depth is not reversed */
	if (m[0][1] != 0 || m[0][2] != 0 || m[1][2] != 0)
		return false;
	int along = truth_sign(sized_mul(z, truth_column(&back, 3, near)), NULL);

	return along == -truth_gaze_sign(truth_answer(s));
}

void truth_planes(const struct scene *s, const struct sized q[4], struct sized plane[6])
{
	bool reversed = is_reversed(s);
	real limits[2];

	truth_limits(s, limits);
	for (int k = 0; k < 6; k++) {
		bool high = k & 1;
		struct sized limit = k < 4 ? sized_limit(limits[k / 2]) : sized_of(1);

		if ((k == 2 || k == 3) && truth_answer(s)->ndc_y_down)
			high = !high;
		if (k >= 4 && reversed)
			high = !high;
		if (k >= 4 && !high && !truth_answer(s)->depth_minus_one)
			limit = sized_of(0);
		limit = sized_mul(limit, q[3]);
		plane[k] = high ? sized_sub(limit, q[k / 2]) :
				  sized_add(limit, q[k / 2]);
	}
}

bool truth_distance(const struct scene *s, real column[4])
{
	const bool matrix = s->projection.type == PROJECTION_MATRIX;
	struct truth t;
	bool parallel = true;

	truth_scene(s, SPACE_VIEW, SPACE_CLIP, &t);
	for (int i = 0; i < 3; i++)
		parallel &= truth_sign(truth_element(&t, i, 3), NULL) == 0;
	const bool falls = is_reversed(s) != (mpfr_sgn(t.product.m[3][3]) < 0);

	set_reals(column, 4, NULL);
	column[2] = real_of(truth_gaze_sign(truth_answer(s)));
	for (int i = 0; i < 3 && parallel && matrix; i++)
		column[i] = mul(real_of(falls ? -1 : 1), t.product.m[i][2]);
	for (int i = 0; i < 4 && !parallel; i++)
		column[i] = t.product.m[i][3];
	real length = root(dot(column, column, 3));

	for (int i = 0; i < 4; i++)
		column[i] = divide(column[i], length);
	return parallel;
}
