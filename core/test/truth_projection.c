/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "truth.h"

#define ONE number(1)
#define TWO number(2)

/* From edges a and b, the scales 2n / (b - a) of x and y and how far the centre
 * is off the axis, (a + b) / (b - a). n is the near distance of a perspective,
 * else 1. */
static void edges(const struct projection *p, real n, real s[2], real off[2])
{
	real a[2], b[2];

	set(a, 2, (double[]){ p->left, p->bottom });
	set(b, 2, (double[]){ p->right, p->top });
	for (int i = 0; i < 2; i++) {
		s[i] = over(mul(TWO, n), sub(b[i], a[i]));
		off[i] = over(add(a[i], b[i]), sub(b[i], a[i]));
	}
}

static real tangent(double angle, bool radians)
{
	return over(sine(angle, radians), cosine(angle, radians));
}

/* Computes the elements from the tangents of left, right, bottom and top, which
 * are edges at 1. */
static void tangents(const struct projection *p, real s[2], real off[2])
{
	const double angle[4] = { p->left, p->right, p->bottom, p->top };

	for (int i = 0; i < 2; i++) {
		real a = tangent(angle[2 * i], p->unit);
		real b = tangent(angle[2 * i + 1], p->unit);

		s[i] = over(TWO, sub(b, a));
		off[i] = over(add(a, b), sub(b, a));
	}
}

static void by_aspect(const struct projection *p, bool x_given, real given,
    real s[2])
{
	real aspect = over(number(p->aspect[0]), number(p->aspect[1]));

	s[0] = x_given ? given : over(given, aspect);
	s[1] = x_given ? mul(given, aspect) : given;
}

static void cross_section(const struct projection *p, real n, real s[2],
    real off[2])
{
	bool wide = p->aspect[0] >= p->aspect[1];

	set(off, 2, NULL);
	switch (p->extent) {
	case EXTENT_FOVY:
		by_aspect(p, false, cotangent(p->angle, p->unit, 2), s);
		break;
	case EXTENT_FOVX:
		by_aspect(p, true, cotangent(p->angle, p->unit, 2), s);
		break;
	case EXTENT_VIEW_ANGLE:
		by_aspect(p, !wide, cotangent(p->angle, p->unit, 2), s);
		break;
	case EXTENT_FIELD:
		by_aspect(p, wide, over(ONE, number(p->angle)), s);
		break;
	case EXTENT_HEIGHT:
		by_aspect(p, false, over(mul(TWO, n), number(p->height)), s);
		break;
	case EXTENT_WIDTH:
		by_aspect(p, true, over(mul(TWO, n), number(p->width)), s);
		break;
	case EXTENT_SIZE:
		s[0] = over(mul(TWO, n), number(p->width));
		s[1] = over(mul(TWO, n), number(p->height));
		break;
	case EXTENT_EDGES:
		edges(p, n, s, off);
		break;
	case EXTENT_ANGLES:
		tangents(p, s, off);
		break;
	case EXTENT_INTRINSICS: /* pixels() */
		break;
	}
}

/* For depths 0 to 1, a = f / (f - n) and b = -n f / (f - n); for -1 to 1,
 * a = (f + n) / (f - n) and b is twice as large. An infinite far gives the
 * limits of these. With reverse_z near and far change places. */
static void depth(const struct projection *p, bool minus_one, real *a, real *b)
{
	real n = number(p->reverse_z ? p->far : p->near);
	real f = number(p->reverse_z ? p->near : p->far);
	real k = number(minus_one ? 2 : 1);

	if (p->near == 0) { /* 1 / w, in 0 to 1 */
		*a = number(minus_one ? -1 : 0);
		*b = k;
		return;
	}
	if (isinf(p->far)) {
		*a = p->reverse_z ? sub(ONE, k) : ONE;
		*b = mul(k, p->reverse_z ? f : negative(n));
		return;
	}
	*a = over(minus_one ? add(f, n) : f, sub(f, n));
	*b = negative(over(mul(k, mul(n, f)), sub(f, n)));
}

static void persp(const struct projection *p, const struct convention *c,
    real m[4][4])
{
	real s[2], off[2];

	cross_section(p, number(p->edges_at > 0 ? p->edges_at : p->near), s,
	    off);
	m[0][0] = s[0];
	m[1][1] = s[1];
	m[2][0] = negative(off[0]);
	m[2][1] = negative(off[1]);
	depth(p, c->depth_minus_one, &m[2][2], &m[3][2]);
	m[2][3] = ONE;
	m[3][3] = number(0);
	for (int j = 0; j < 4; j++)
		if (c->right_handed)
			m[2][j] = negative(m[2][j]);
}

/* Divided by the difference of two tangents the elements are so many times larger
 * as their sum of magnitudes is than that. */
static void size_tangents(const struct projection *p, struct truth_stage *s)
{
	const double angle[4] = { p->left, p->right, p->bottom, p->top };

	for (int i = 0; i < 2; i++) {
		real a = tangent(angle[2 * i], p->unit);
		real b = tangent(angle[2 * i + 1], p->unit);
		real more = over(add(magnitude(a), magnitude(b)), sub(b, a));

		s->size[i][i] = mul(magnitude(s->m[i][i]), add(ONE, more));
		s->size[2][i] = mul(more, add(ONE, more));
	}
}

static void ortho(const struct projection *p, const struct convention *c,
    real m[4][4])
{
	real n = number(p->reverse_z ? p->far : p->near);
	real f = number(p->reverse_z ? p->near : p->far);
	real s[2], off[2];

	cross_section(p, ONE, s, off);
	m[0][0] = s[0];
	m[1][1] = s[1];
	m[2][2] = over(c->depth_minus_one ? TWO : ONE, sub(f, n));
	m[3][0] = negative(off[0]);
	m[3][1] = negative(off[1]);
	m[3][2] = negative(over(c->depth_minus_one ? add(f, n) : n, sub(f, n)));
	if (c->right_handed)
		m[2][2] = negative(m[2][2]);
}

/* x' = x + cot(angle) cos(direction) (d - plane), y' likewise with sin, for d
 * along the gaze. */
static void shear(const struct projection *p, bool right_handed, real m[4][4])
{
	real cot = p->kind == OBLIQUE_CAVALIER ?
	    ONE :
	    p->kind == OBLIQUE_CABINET ?
	    number(0.5) :
	    cotangent(p->projector_angle, p->unit, 1);

	m[2][0] = mul(cot, cosine(p->direction, p->direction_unit));
	m[2][1] = mul(cot, sine(p->direction, p->direction_unit));
	for (int j = 0; j < 2; j++) {
		m[3][j] = negative(mul(m[2][j], number(p->plane)));
		if (right_handed)
			m[2][j] = negative(m[2][j]);
	}
}

/* The angle is across the smaller side, as seen from an eye before near. */
static real taper(const struct projection *p, real hw, real hh)
{
	real q = over(ONE, cotangent(p->angle, p->unit, 2));

	q = over(q, mpfr_cmp(hw, hh) < 0 ? hw : hh);
	return p->z_near > p->z_far ? q : negative(q);
}

/* Computes the sizes of the sums in the elements that have differences. */
static void size_depth(const struct projection *p, bool minus_one, real q,
    struct truth_stage *s)
{
	real zn = magnitude(number(p->z_near)),
	     zf = magnitude(number(p->z_far));
	real deep = magnitude(sub(number(p->z_near), number(p->z_far)));
	real a = mul(zf, magnitude(q)), b = mul(zn, magnitude(q));
	real one = add(ONE, a);

	s->size[0][0] = magnitude(s->m[0][0]);
	s->size[2][3] = magnitude(s->m[2][3]);
	s->size[2][2] = over(minus_one ? add(one, add(ONE, b)) : one, deep);
	s->size[3][2] = over(minus_one ?
		add(mul(zn, one), mul(zf, add(ONE, b))) :
		mul(zn, one),
	    deep);
}

static void volume(const struct projection *p, bool minus_one,
    struct truth_stage *s)
{
	real(*m)[4] = s->m;
	real zn = number(p->z_near), zf = number(p->z_far);
	real hw = number(p->half_width), hh = number(p->half_height);
	real q = number(p->inverse_eye_z);
	real tx = number(p->tan_skew[0]), ty = number(p->tan_skew[1]);

	if (p->aspect[1] != 0) {
		real aspect = over(number(p->aspect[0]), number(p->aspect[1]));

		if (mpfr_cmp(aspect, ONE) >= 0)
			hw = mul(hw, aspect);
		else
			hh = over(hh, aspect);
	}
	if (p->eye_given_by == EYE_BY_ANGLE)
		q = p->angle > 0 ? taper(p, hw, hh) : number(0);
	if (p->eye_given_by == EYE_BY_POINT) {
		q = over(ONE, number(p->eye[2]));
		tx = mul(number(p->eye[0]), q);
		ty = mul(number(p->eye[1]), q);
	}
	m[0][0] = over(ONE, hw);
	m[1][1] = over(ONE, hh);
	m[2][0] = negative(over(tx, hw));
	m[2][1] = negative(over(ty, hh));
	m[2][2] = minus_one ? sub(mul(add(zn, zf), q), TWO) :
			      sub(mul(zf, q), ONE);
	m[3][2] = minus_one ? sub(add(zn, zf), mul(TWO, mul(zn, mul(zf, q)))) :
			      mul(zn, sub(ONE, mul(zf, q)));
	m[2][2] = over(m[2][2], sub(zn, zf));
	m[3][2] = over(m[3][2], sub(zn, zf));
	m[2][3] = negative(q);
	bool behind = mpfr_cmp(mul(zn, q), ONE) > 0;

	for (int i = 0; i < 16 && behind; i++)
		m[i / 4][i % 4] = negative(m[i / 4][i % 4]);
	if (p->eye_given_by == EYE_BY_ANGLE)
		size_depth(p, minus_one, q, s);
}

/* From view space with x right, y up and z along the gaze to pixels u w and v w, with
 * depth and w, and on to clip space, in which a viewport of such a size is 2 by 2, y
 * up. */
static void pixels(struct truth *t, const struct projection *p,
    const struct convention *c)
{
	struct truth_stage *s = truth_stage(t);
	double up = c->origin_bottom_left ? 1 : -1;
	static const int column[3] = { 0, 1, 3 };
	real a, b;

	for (int j = 0; j < 3; j++)
		for (int i = 0; i < 4; i++)
			s->m[i][column[j]] = number(
			    p->intrinsics[j][i] * (i == 1 ? up : 1));
	depth(p, c->depth_minus_one, &a, &b);
	for (int i = 0; i < 4; i++)
		s->m[i][2] = mul(a, s->m[i][3]);
	s->m[3][2] = add(s->m[3][2], b);
	s = truth_stage(t);
	s->m[0][0] = over(TWO, number(p->width));
	s->m[1][1] = over(number(2 * up), number(p->height));
	s->m[3][0] = number(-1);
	s->m[3][1] = number(-up);
}

void truth_half_turn(struct truth *t)
{
	struct truth_stage *s = truth_stage(t);

	s->m[1][1] = s->m[2][2] = number(-1);
}

void truth_projection(struct truth *t, const struct projection *p,
    const struct convention *c)
{
	bool sized = p->type == PROJECTION_PERSP || p->type == PROJECTION_ORTHO;
	bool upright = sized || p->type == PROJECTION_OBLIQUE;

	bool by_pixels = p->type == PROJECTION_PERSP &&
	    p->extent == EXTENT_INTRINSICS;

	if (p->type == PROJECTION_OBLIQUE ||
	    (p->type == PROJECTION_VOLUME && p->eye_given_by == EYE_BY_ANGLE) ||
	    (sized &&
		(p->extent <= EXTENT_VIEW_ANGLE || p->extent == EXTENT_ANGLES)))
		t->irrational = true;
	if (upright && c->view_y_down)
		truth_half_turn(t);
	if (by_pixels) {
		truth_stage(t)->m[2][2] = number(c->right_handed ? -1 : 1);
		pixels(t, p, c);
	}
	if (p->type == PROJECTION_OBLIQUE)
		shear(p, c->right_handed, truth_stage(t)->m);
	struct truth_stage *s = truth_stage(t);

	if (p->type == PROJECTION_MATRIX)
		for (int i = 0; i < 4; i++)
			set(s->m[i], 4, p->matrix[i]);
	if (p->type == PROJECTION_PERSP && !by_pixels)
		persp(p, c, s->m);
	if (p->type == PROJECTION_PERSP && p->extent == EXTENT_ANGLES)
		size_tangents(p, s);
	if (p->type == PROJECTION_ORTHO || p->type == PROJECTION_OBLIQUE)
		ortho(p, c, s->m);
	if (p->type == PROJECTION_VOLUME)
		volume(p, c->depth_minus_one, s);
	bool down = c->ndc_y_down;

	if (p->type == PROJECTION_VOLUME)
		down = c->ndc_y_down != c->view_y_down;
	for (int i = 0; i < 4 && down; i++)
		if (p->type != PROJECTION_MATRIX && p->type != PROJECTION_NONE)
			s->m[i][1] = negative(s->m[i][1]);
}

struct form truth_slope(const struct projection *p)
{
	struct form w[3];

	for (int j = 0; j < 3; j++)
		w[j] = form_of(p->intrinsics[2][j]);
	return form_length(w);
}
