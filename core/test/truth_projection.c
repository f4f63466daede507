/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "truth.h"

#define ONE real_of(1)
#define TWO real_of(2)

/* Sets s to the scales of x and y, 2n / (b - a) for edges a and b, and off to the
 * centre's distance from the axis in units of half the side, (a + b) / (b - a). n is
 * the near distance of a perspective, else 1. */
static void section_by_edges(const struct projection *p, real n, real s[2], real off[2])
{
	real a[2], b[2];

	set_reals(a, 2, (double[]){ p->section.left, p->section.bottom });
	set_reals(b, 2, (double[]){ p->section.right, p->section.top });
	for (int i = 0; i < 2; i++) {
		s[i] = divide(mul(TWO, n), sub(b[i], a[i]));
		off[i] = divide(add(a[i], b[i]), sub(b[i], a[i]));
	}
}

static real tangent(double angle, bool radians)
{
	return divide(sine(angle, radians), cosine(angle, radians));
}

/* Does what section_by_edges does, with the tangents of the four angles as edges at
 * distance 1. */
static void section_by_angles(const struct projection *p, real s[2], real off[2])
{
	const double *angle = p->section.angles;

	for (int i = 0; i < 2; i++) {
		real a = tangent(angle[2 * i], p->unit);
		real b = tangent(angle[2 * i + 1], p->unit);

		s[i] = divide(TWO, sub(b, a));
		off[i] = divide(add(a, b), sub(b, a));
	}
}

/* Sets s to the scales of x and y. One of them is given, that of x if x_given, and the
 * aspect gives the other. */
static void section_by_aspect(const struct projection *p, bool x_given, real given,
    real s[2])
{
	real aspect = divide(real_of(p->aspect[0]), real_of(p->aspect[1]));

	s[0] = x_given ? given : divide(given, aspect);
	s[1] = x_given ? mul(given, aspect) : given;
}

static void cross_section(const struct projection *p, real n, real s[2], real off[2])
{
	bool wide = p->aspect[0] >= p->aspect[1];

	set_reals(off, 2, NULL);
	switch (p->section.way) {
	case SECTION_FOVY:
		section_by_aspect(p, false, cotangent(p->section.angle, p->unit, 2), s);
		break;
	case SECTION_FOVX:
		section_by_aspect(p, true, cotangent(p->section.angle, p->unit, 2), s);
		break;
	case SECTION_VIEW_ANGLE:
		section_by_aspect(p, !wide, cotangent(p->section.angle, p->unit, 2), s);
		break;
	case SECTION_FIELD:
		section_by_aspect(p, wide, divide(ONE, real_of(p->section.field)), s);
		break;
	case SECTION_HEIGHT:
		section_by_aspect(p, false,
		    divide(mul(TWO, n), real_of(p->section.height)), s);
		break;
	case SECTION_WIDTH:
		section_by_aspect(p, true,
		    divide(mul(TWO, n), real_of(p->section.width)), s);
		break;
	case SECTION_SIZE:
		s[0] = divide(mul(TWO, n), real_of(p->section.width));
		s[1] = divide(mul(TWO, n), real_of(p->section.height));
		break;
	case SECTION_EDGES:
		section_by_edges(p, n, s, off);
		break;
	case SECTION_ANGLES:
		section_by_angles(p, s, off);
		break;
	case SECTION_INTRINSICS: /* by the function pixels */
		break;
	}
}

/* Sets a and b so that the depth is a + b / w. For depths from 0 to 1, a = f / (f - n)
 * and b = -n f / (f - n). For depths from -1 to 1, a = (f + n) / (f - n) and b = -2 n
 * f / (f - n). An infinite far plane gives the limits of a and b. With reverse_z near
 * and far change places. */
static void depth(const struct projection *p, bool minus_one, real *a, real *b)
{
	real n = real_of(p->reverse_z ? p->far : p->near);
	real f = real_of(p->reverse_z ? p->near : p->far);
	real k = real_of(minus_one ? 2 : 1);

	if (p->near == 0) { /* no planes: depth is 1 / w, from 0 to 1 */
		*a = real_of(minus_one ? -1 : 0);
		*b = k;
		return;
	}
	if (isinf(p->far)) {
		*a = p->reverse_z ? sub(ONE, k) : ONE;
		*b = mul(k, p->reverse_z ? f : negative(n));
		return;
	}
	*a = divide(minus_one ? add(f, n) : f, sub(f, n));
	*b = negative(divide(mul(k, mul(n, f)), sub(f, n)));
}

static void persp(const struct projection *p, const struct convention *c, real m[4][4])
{
	real s[2], off[2];

	cross_section(p,
	    real_of(p->section.edges_at > 0 ? p->section.edges_at : p->near), s, off);
	m[0][0] = s[0];
	m[1][1] = s[1];
	m[2][0] = negative(off[0]);
	m[2][1] = negative(off[1]);
	depth(p, c->depth_minus_one, &m[2][2], &m[3][2]);
	m[2][3] = ONE;
	m[3][3] = real_of(0);
	for (int j = 0; j < 4; j++)
		if (c->right_handed)
			m[2][j] = negative(m[2][j]);
}

/* Sets the sizes of the elements that are quotients by b - a, the difference of two
 * tangents. Their relative errors are (|a| + |b|) / (b - a) times those of the
 * tangents. */
static void size_tangents(const struct projection *p, struct truth_stage *s)
{
	const double *angle = p->section.angles;

	for (int i = 0; i < 2; i++) {
		real a = tangent(angle[2 * i], p->unit);
		real b = tangent(angle[2 * i + 1], p->unit);
		real more = divide(add(magnitude(a), magnitude(b)), sub(b, a));

		s->size[i][i] = mul(magnitude(s->m[i][i]), add(ONE, more));
		s->size[2][i] = mul(more, add(ONE, more));
	}
}

/* Sets also the size of (f + n) / (f - n), which cancels if n is nearly -f. */
static void ortho(const struct projection *p, const struct convention *c,
    struct truth_stage *stage)
{
	real(*m)[4] = stage->m;
	real n = real_of(p->reverse_z ? p->far : p->near);
	real f = real_of(p->reverse_z ? p->near : p->far);
	real s[2], off[2];

	cross_section(p, ONE, s, off);
	m[0][0] = s[0];
	m[1][1] = s[1];
	m[2][2] = divide(c->depth_minus_one ? TWO : ONE, sub(f, n));
	m[3][0] = negative(off[0]);
	m[3][1] = negative(off[1]);
	m[3][2] = negative(divide(c->depth_minus_one ? add(f, n) : n, sub(f, n)));
	stage->size[0][0] = magnitude(m[0][0]);
	stage->size[3][2] = magnitude(
	    divide(add(magnitude(f), magnitude(n)), sub(f, n)));
	if (c->right_handed)
		m[2][2] = negative(m[2][2]);
}

/* Sets m to x' = x + cot(angle) cos(direction) (d - plane), and y' likewise with sin,
 * where d is the distance along the gaze. */
static void shear(const struct projection *p, bool right_handed, real m[4][4])
{
	real cot = p->shear.kind == OBLIQUE_CAVALIER ?
	    ONE :
	    p->shear.kind == OBLIQUE_CABINET ?
	    real_of(0.5) :
	    cotangent(p->shear.projector_angle, p->unit, 1);

	m[2][0] = mul(cot, cosine(p->shear.direction, p->shear.direction_unit));
	m[2][1] = mul(cot, sine(p->shear.direction, p->shear.direction_unit));
	for (int j = 0; j < 2; j++) {
		m[3][j] = negative(mul(m[2][j], real_of(p->shear.plane)));
		if (right_handed)
			m[2][j] = negative(m[2][j]);
	}
}

/* Returns 1 / z of the eye that sees the smaller side of the volume's section at z = 0
 * under the angle, from before near. */
static real inverse_eye_z(const struct projection *p, real hw, real hh)
{
	real q = divide(ONE, cotangent(p->volume.view_angle, p->unit, 2));

	q = divide(q, mpfr_cmp(hw, hh) < 0 ? hw : hh);
	return p->volume.z_near > p->volume.z_far ? q : negative(q);
}

/* Sets the sizes of the elements of a volume by angle, in which sums occur. */
static void size_depth(const struct projection *p, bool minus_one, real q,
    struct truth_stage *s)
{
	real zn = magnitude(real_of(p->volume.z_near)),
	     zf = magnitude(real_of(p->volume.z_far));
	real deep = magnitude(sub(real_of(p->volume.z_near), real_of(p->volume.z_far)));
	real a = mul(zf, magnitude(q)), b = mul(zn, magnitude(q));
	real one = add(ONE, a);

	s->size[0][0] = magnitude(s->m[0][0]);
	s->size[2][3] = magnitude(s->m[2][3]);
	s->size[2][2] = divide(minus_one ? add(one, add(ONE, b)) : one, deep);
	s->size[3][2] = divide(minus_one ? add(mul(zn, one), mul(zf, add(ONE, b))) :
					   mul(zn, one),
	    deep);
}

static void volume(const struct projection *p, bool minus_one, struct truth_stage *s)
{
	real(*m)[4] = s->m;
	real zn = real_of(p->volume.z_near), zf = real_of(p->volume.z_far);
	real hw = real_of(p->volume.half_width), hh = real_of(p->volume.half_height);
	real q = real_of(p->volume.inverse_eye_z);
	real tx = real_of(p->volume.tan_skew[0]), ty = real_of(p->volume.tan_skew[1]);

	if (p->aspect[1] != 0) {
		real aspect = divide(real_of(p->aspect[0]), real_of(p->aspect[1]));

		if (mpfr_cmp(aspect, ONE) >= 0)
			hw = mul(hw, aspect);
		else
			hh = divide(hh, aspect);
	}
	if (p->volume.eye_given_by == EYE_BY_ANGLE)
		q = p->volume.view_angle > 0 ? inverse_eye_z(p, hw, hh) : real_of(0);
	if (p->volume.eye_given_by == EYE_BY_POINT) {
		q = divide(ONE, real_of(p->volume.eye[2]));
		tx = mul(real_of(p->volume.eye[0]), q);
		ty = mul(real_of(p->volume.eye[1]), q);
	}
	m[0][0] = divide(ONE, hw);
	m[1][1] = divide(ONE, hh);
	m[2][0] = negative(divide(tx, hw));
	m[2][1] = negative(divide(ty, hh));
	m[2][2] = minus_one ? sub(mul(add(zn, zf), q), TWO) : sub(mul(zf, q), ONE);
	m[3][2] = minus_one ? sub(add(zn, zf), mul(TWO, mul(zn, mul(zf, q)))) :
			      mul(zn, sub(ONE, mul(zf, q)));
	m[2][2] = divide(m[2][2], sub(zn, zf));
	m[3][2] = divide(m[3][2], sub(zn, zf));
	m[2][3] = negative(q);
	bool behind = mpfr_cmp(mul(zn, q), ONE) > 0;

	for (int i = 0; i < 16 && behind; i++)
		m[i / 4][i % 4] = negative(m[i / 4][i % 4]);
	if (p->volume.eye_given_by == EYE_BY_ANGLE)
		size_depth(p, minus_one, q, s);
}

/* Adds two stages. The first leads from view space, with x right, y up and z along the
 * gaze, to u w, v w, depth and w, where u and v are in pixels. The second leads to clip
 * space, in which a viewport of p's width and height is 2 by 2, with y up. */
static void pixels(struct truth *t, const struct projection *p,
    const struct convention *c)
{
	struct truth_stage *s = truth_stage(t);
	double up = c->origin_bottom_left ? 1 : -1;
	static const int column[3] = { 0, 1, 3 };
	real a, b;

	for (int j = 0; j < 3; j++)
		for (int i = 0; i < 4; i++)
			s->m[i][column[j]] = real_of(
			    p->section.intrinsics[j][i] * (i == 1 ? up : 1));
	depth(p, c->depth_minus_one, &a, &b);
	for (int i = 0; i < 4; i++)
		s->m[i][2] = mul(a, s->m[i][3]);
	s->m[3][2] = add(s->m[3][2], b);
	s = truth_stage(t);
	s->m[0][0] = divide(TWO, real_of(p->section.width));
	s->m[1][1] = divide(real_of(2 * up), real_of(p->section.height));
	s->m[3][0] = real_of(-1);
	s->m[3][1] = real_of(-up);
}

void truth_half_turn(struct truth *t)
{
	struct truth_stage *s = truth_stage(t);

	s->m[1][1] = s->m[2][2] = real_of(-1);
}

/* Adds half a turn to the view space of formulas, in which y points up. Returns the
 * stage that follows. */
static struct truth_stage *upright(struct truth *t, const struct projection *p,
    const struct convention *c)
{
	const enum section_way way = p->section.way;

	t->irrational |= way <= SECTION_VIEW_ANGLE || way == SECTION_ANGLES;
	if (c->view_y_down)
		truth_half_turn(t);
	return truth_stage(t);
}

static void perspective(struct truth *t, const struct projection *p,
    const struct convention *c)
{
	struct truth_stage *s = upright(t, p, c);

	if (p->section.way == SECTION_INTRINSICS) {
		s->m[2][2] = real_of(c->right_handed ? -1 : 1);
		pixels(t, p, c);
		truth_stage(t);
		return;
	}
	persp(p, c, s->m);
	if (p->section.way == SECTION_ANGLES)
		size_tangents(p, s);
}

void truth_projection(struct truth *t, const struct projection *p,
    const struct convention *c)
{
	bool down = c->ndc_y_down;
	struct truth_stage *s;

	switch (p->type) {
	case PROJECTION_NONE:
		return;
	case PROJECTION_MATRIX:
		s = truth_stage(t);
		for (int i = 0; i < 4; i++)
			set_reals(s->m[i], 4, p->matrix[i]);
		return;
	case PROJECTION_PERSP:
		perspective(t, p, c);
		break;
	case PROJECTION_OBLIQUE:
		shear(p, c->right_handed, upright(t, p, c)->m);
		t->irrational = true;
		ortho(p, c, truth_stage(t));
		break;
	case PROJECTION_ORTHO:
		ortho(p, c, upright(t, p, c));
		break;
	case PROJECTION_VOLUME:
		volume(p, c->depth_minus_one, truth_stage(t));
		t->irrational |= p->volume.eye_given_by == EYE_BY_ANGLE;
		down = c->ndc_y_down != c->view_y_down;
		break;
	}
	for (int i = 0; i < 4 && down; i++) {
		real *y = &t->stage[t->n - 1].m[i][1];

		*y = negative(*y);
	}
}

struct sized truth_w_gradient(const struct projection *p)
{
	struct sized w[3];

	for (int j = 0; j < 3; j++)
		w[j] = sized_of(p->section.intrinsics[2][j]);
	return sized_length(w);
}
