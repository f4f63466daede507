/* SPDX-License-Identifier: MIT */
#include "projection.h"

#include <string.h>

/* The matrix of every projection that is made of parameters:
 *	 x   0   0   0
 *	 yx  y   0   0
 *	 zx  zy  zz  zw
 *	 tx  ty  tz  tw
 * whose columns are divided by dx, dy, dz and 1, and all of them by d. z, w and d are
 * exact but for a volume's angle, and so is det = zz tw - zw tz, as a product of
 * parameters, without cancellation. */
struct elements {
	struct sum x, yx, y, zx, zy, zz, zw, tx, ty, tz, tw, dx, dy, dz, d, det;
	/* of a volume by its angle, whose det is inexact: 1, tz and zz over that */
	struct sum by, tz_by, zz_by;
};

/* One of x and y is s / over; the other follows from the aspect w / h. */
static void by_aspect(const double aspect[2], bool given_x, struct sum s,
    struct sum over, struct elements *f)
{
	struct sum w = sum_of_double(aspect[0]), h = sum_of_double(aspect[1]);

	f->x = given_x ? s : sum_mul(s, h);
	f->dx = given_x ? over : sum_mul(over, w);
	f->y = given_x ? sum_mul(s, w) : s;
	f->dy = given_x ? sum_mul(over, h) : over;
}

/* With edges a and b at 1, the tangents of angles, all times both cosines. */
static void tangents(double a, double b, enum angle_unit unit,
    struct sum *scale, struct sum *size, struct sum *off)
{
	struct sum ca = cos_of(a, unit), cb = cos_of(b, unit);
	struct sum left = sum_mul(sin_of(a, unit), cb);
	struct sum right = sum_mul(sin_of(b, unit), ca);

	*scale = sum_mul(sum_of_double(2), sum_mul(ca, cb));
	*size = sum_sub(right, left);
	*off = sum_add(left, right);
}

/* 2 a - b c, for ndc from pixels. */
static struct sum doubled_less(double a, double b, double c)
{
	return sum_sub(sum_of_double(2 * a),
	    sum_mul(sum_of_double(b), sum_of_double(c)));
}

/* From what is u w, v w and w, with u and v from 0 to a viewport's sides, to -w to w:
 * x over the width, y, upward, over the height. */
static void pixels(const struct projection *p, bool upward, struct elements *f,
    struct sum off[2])
{
	const double(*k)[4] = p->intrinsics;
	double pw = k[2][3];

	f->dx = sum_of_double(p->width);
	f->dy = sum_of_double(p->height);
	f->x = sum_of_double(2 * k[0][0]);
	f->y = sum_of_double(2 * k[1][1]);
	f->yx = sum_negated_if(!upward, sum_of_double(2 * k[0][1]));
	off[0] = sum_neg(doubled_less(k[0][2], p->width, 1));
	off[1] = sum_negated_if(upward, doubled_less(k[1][2], p->height, 1));
	f->tx = doubled_less(k[0][3], p->width, pw);
	f->ty = sum_negated_if(!upward, doubled_less(k[1][3], p->height, pw));
	f->tw = sum_of_double(pw);
}

/* Sets x, y and by how much the centre is off; d is the distance of the plane
 * in which width, height and edges are given: near for persp, 1 otherwise. From a to
 * b a side is seen at 2 d / (b - a), and off by (a + b) / (b - a). */
static const char *cross_section(const struct projection *p, double d,
    struct elements *f, struct sum off[2])
{
	bool wide = p->aspect[0] >= p->aspect[1];
	struct sum cot = sum_of_double(0);

	off[0] = off[1] = sum_of_double(0);
	if (p->extent <= EXTENT_VIEW_ANGLE)
		cot = cot_of(p->angle / 2, p->unit);
	switch (p->extent) {
	case EXTENT_FOVY:
		by_aspect(p->aspect, false, cot, sum_of_double(1), f);
		break;
	case EXTENT_FOVX:
		by_aspect(p->aspect, true, cot, sum_of_double(1), f);
		break;
	case EXTENT_VIEW_ANGLE:
		by_aspect(p->aspect, !wide, cot, sum_of_double(1), f);
		break;
	case EXTENT_FIELD:
		by_aspect(p->aspect, wide, sum_of_double(1),
		    sum_of_double(p->angle), f);
		break;
	case EXTENT_HEIGHT:
		by_aspect(p->aspect, false, sum_of_double(2 * d),
		    sum_of_double(p->height), f);
		break;
	case EXTENT_WIDTH:
		by_aspect(p->aspect, true, sum_of_double(2 * d),
		    sum_of_double(p->width), f);
		break;
	case EXTENT_SIZE:
		f->x = f->y = sum_of_double(2 * d);
		f->dx = sum_of_double(p->width);
		f->dy = sum_of_double(p->height);
		break;
	case EXTENT_ANGLES:
		tangents(p->left, p->right, p->unit, &f->x, &f->dx, &off[0]);
		tangents(p->bottom, p->top, p->unit, &f->y, &f->dy, &off[1]);
		break;
	case EXTENT_INTRINSICS: /* pixels() */
		break;
	case EXTENT_EDGES:
		f->x = f->y = sum_of_double(2 * d);
		f->dx = sum_diff(p->right, p->left);
		f->dy = sum_diff(p->top, p->bottom);
		off[0] = sum_diff(p->left, -p->right);
		off[1] = sum_diff(p->bottom, -p->top);
		if (sum_sign(f->dx) == 0)
			return "/projection/right: equal to left; "
			       "the edges must differ";
		if (sum_sign(f->dy) == 0)
			return "/projection/top: equal to bottom; "
			       "the edges must differ";
		break;
	}
	return NULL;
}

/* Of depth' = A + B / w sets A and B, over dz: A = f / (f - n), B = -n f / (f - n), or
 * to -1..1 A = (f + n) / (f - n), B = -2 n f / (f - n); an infinite far is the
 * limit; reversed, near and far trade places. Without planes it is 1 / w, as of a
 * reversed one with n = 1. */
static void depth_elements(const struct projection *p, bool minus_one,
    struct elements *f)
{
	double k = minus_one ? 2 : 1, n = projection_is_open(p) ? 1 : p->near;

	if (isinf(p->far)) {
		/* A = 1, reversed 1 - k; B = -k n, reversed k n */
		f->dz = sum_of_double(1);
		f->zz = sum_of_double(p->reverse_z ? 1 - k : 1);
		f->tz = sum_of_double(p->reverse_z ? k * n : -k * n);
	} else {
		double a = p->reverse_z ? p->far : n;
		double b = p->reverse_z ? n : p->far;

		f->dz = sum_diff(b, a);
		f->zz = minus_one ? sum_diff(b, -a) : sum_of_double(b);
		f->tz = sum_mul(sum_of_double(-k * a), sum_of_double(b));
	}
}

/* w = depth + tw, where intrinsics have an offset. det = -zw B. */
static const char *persp_elements(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	double at = p->edges_at > 0 ? p->edges_at : p->near;
	bool back = looks_back(c);
	struct sum off[2];
	const char *why = cross_section(p, at, f, off);

	if (why != NULL)
		return why;
	if (!(p->near < p->far))
		return "/projection/near: not less than far; for reversed "
		       "depth say \"reverse_z\": true";
	f->d = sum_of_double(1);
	if (p->extent == EXTENT_INTRINSICS)
		pixels(p, c->bottom_left, f, off);
	depth_elements(p, c->minus_one, f);
	f->det = sum_negated_if(!back, f->tz);
	f->tz = sum_add(f->tz, sum_mul(f->zz, f->tw));
	f->zx = sum_negated_if(!back, off[0]);
	f->zy = sum_negated_if(!back, off[1]);
	f->zz = sum_negated_if(back, f->zz);
	f->zw = sum_negated_if(back, sum_of_double(1));
	return NULL;
}

static const char *ortho_elements(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	double a = p->reverse_z ? p->far : p->near;
	double b = p->reverse_z ? p->near : p->far;
	struct sum off[2];
	const char *why = cross_section(p, 1, f, off);

	if (why != NULL)
		return why;
	f->d = sum_of_double(1);
	f->dz = sum_diff(b, a);
	if (sum_sign(f->dz) == 0)
		return "/projection/far: equal to near; "
		       "the planes must differ";
	f->zz = sum_negated_if(looks_back(c),
	    sum_of_double(c->minus_one ? 2 : 1));
	f->tz = c->minus_one ? sum_diff(-a, b) : sum_of_double(-a);
	f->tx = sum_neg(off[0]);
	f->ty = sum_neg(off[1]);
	f->tw = sum_of_double(1);
	f->det = f->zz;
	return NULL;
}

/* ortho after x' = x + cot cos(direction) (depth - plane), y' likewise. */
static const char *oblique_elements(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	const char *why = ortho_elements(p, c, f);
	struct sum cot = sum_of_double(p->kind == OBLIQUE_CABINET ? 0.5 : 1);

	if (why != NULL)
		return why;
	if (p->kind == OBLIQUE_ANGLE)
		cot = cot_of(p->projector, p->unit);
	struct sum zx = sum_mul(sum_mul(cot,
				    cos_of(p->direction, p->direction_unit)),
	    f->x);
	struct sum zy = sum_mul(sum_mul(cot,
				    sin_of(p->direction, p->direction_unit)),
	    f->y);

	f->tx = sum_sub(f->tx, sum_mul(zx, sum_of_double(p->plane)));
	f->ty = sum_sub(f->ty, sum_mul(zy, sum_of_double(p->plane)));
	f->zx = sum_negated_if(looks_back(c), zx);
	f->zy = sum_negated_if(looks_back(c), zy);
	return NULL;
}

/* With q = qn / qd the inverse of the eye's z, an / qd = 1 - zf q and bn / qd =
 * 1 - zn q are w on the far and the near plane: one sign, or the eye plane lies
 * inside. */
struct eye {
	struct sum qn, qd, an, bn;
	struct sum skew[2]; /* times qd */
};

/* Half a side of a volume, an exact quotient. */
struct half {
	struct sum n, d;
};

static void halves_of(const struct projection *p, struct half half[2])
{
	bool sized = p->aspect[1] != 0;
	bool wide = p->aspect[0] >= p->aspect[1];
	struct sum w = sum_of_double(sized && wide ? p->aspect[0] : 1);
	struct sum h = sum_of_double(sized && !wide ? p->aspect[1] : 1);

	half[0].n = sum_mul(sum_of_double(p->half_width), w);
	half[0].d = sum_of_double(sized && wide ? p->aspect[1] : 1);
	half[1].n = sum_mul(sum_of_double(p->half_height), h);
	half[1].d = sum_of_double(sized && !wide ? p->aspect[0] : 1);
}

/* cot(angle / 2) = |z| / least half side; 0 is at infinity. */
static void by_view_angle(const struct projection *p, struct sum *over,
    struct sum *under)
{
	struct half half[2];

	halves_of(p, half);
	bool high = sum_sign(sum_sub(sum_mul(half[0].n, half[1].d),
			sum_mul(half[1].n, half[0].d))) <= 0;
	struct half *least = &half[!high];
	struct sum cot = cot_of(p->angle / 2, p->unit);

	*over = sum_negated_if(p->z_near < p->z_far, least->d);
	*under = sum_mul(least->n, cot);
	if (under->error.m > 0) {
		*over = sum_quotient(*over, *under);
		*under = sum_of_double(1);
	}
}

void projection_inverse_eye_z(const struct projection *p, struct sum *over,
    struct sum *under)
{
	if (p->has_angle && p->angle > 0) {
		by_view_angle(p, over, under);
		return;
	}
	*over = sum_of_double(p->has_eye ? 1 :
		p->has_angle             ? 0 :
					   p->inverse_eye_z);
	*under = sum_of_double(p->has_eye ? p->eye[2] : 1);
}

static const char *eye_of(const struct projection *p, struct eye *e)
{
	if (p->has_eye && p->eye[2] == 0)
		return "/projection/eye: its z is 0, in the rectangle's "
		       "plane; move the eye off it";
	projection_inverse_eye_z(p, &e->qn, &e->qd);
	e->an = sum_sub(e->qd, sum_mul(e->qn, sum_of_double(p->z_far)));
	e->bn = sum_sub(e->qd, sum_mul(e->qn, sum_of_double(p->z_near)));
	for (int k = 0; k < 2; k++)
		e->skew[k] = p->has_eye ?
		    sum_of_double(p->eye[k]) :
		    sum_mul(sum_of_double(p->tan_skew[k]), e->qd);
	if (sum_sign(e->an) * sum_sign(e->bn) > 0)
		return NULL;
	if (p->has_angle)
		return "/projection/view_angle: the eye plane crosses the "
		       "volume; choose a smaller one, or move z_near";
	return p->has_eye ? "/projection/eye: its plane crosses the volume; "
			    "move it before z_near or beyond z_far" :
			    "/projection/inverse_eye_z: the eye plane crosses "
			    "the volume; it must lie before z_near or "
			    "beyond z_far";
}

/* What an and bn have in common with det cancels. */
static void divide_by_det(const struct projection *p, const struct eye *e,
    bool minus_one, struct elements *f)
{
	struct sum half = sum_of_double(minus_one ? 0.5 : 1);
	struct sum a = sum_quotient(half, e->an);
	struct sum b = sum_quotient(half, e->bn);

	f->by = sum_neg(sum_quotient(a, e->bn));
	f->tz_by = sum_neg(sum_mul(b, sum_of_double(p->z_near)));
	f->zz_by = b;
	if (minus_one) {
		f->tz_by = sum_sub(f->tz_by,
		    sum_mul(a, sum_of_double(p->z_far)));
		f->zz_by = sum_add(a, b);
	}
}

static void negate_matrix(struct elements *f)
{
	struct sum *const all[] = { &f->x, &f->yx, &f->y, &f->zx, &f->zy,
		&f->zz, &f->zw, &f->tx, &f->ty, &f->tz, &f->tw };

	for (size_t i = 0; i < sizeof all / sizeof *all; i++)
		*all[i] = sum_neg(*all[i]);
}

/* All is over q's denominator, so that a parallel projection, q = 0, is no special
 * case. */
static const char *volume_elements(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	struct eye e;
	struct half half[2];

	halves_of(p, half);
	f->dx = half[0].n;
	f->dy = half[1].n;
	f->dz = sum_diff(p->z_near, p->z_far);
	if (sum_sign(f->dz) == 0)
		return "/projection/z_far: equal to z_near; "
		       "the planes must differ";
	const char *why = eye_of(p, &e);

	if (why != NULL)
		return why;
	f->d = f->tw = e.qd;
	f->x = sum_mul(e.qd, half[0].d);
	f->y = sum_mul(e.qd, half[1].d);
	f->zx = sum_neg(sum_mul(e.skew[0], half[0].d));
	f->zy = sum_neg(sum_mul(e.skew[1], half[1].d));
	f->zz = sum_neg(e.an);
	f->zw = sum_neg(e.qn);
	f->tz = sum_mul(e.an, sum_of_double(p->z_near));
	f->det = sum_neg(sum_mul(e.an, e.bn));
	if (c->minus_one) {
		f->zz = sum_sub(f->zz, e.bn);
		f->tz = sum_add(f->tz, sum_mul(e.bn, sum_of_double(p->z_far)));
		f->det = sum_mul(f->det, sum_of_double(2));
	}
	if (f->det.error.m > 0)
		divide_by_det(p, &e, c->minus_one, f);
	if (sum_sign(e.an) == sum_sign(e.qd))
		return NULL;
	negate_matrix(f);
	f->tz_by = sum_neg(f->tz_by);
	f->zz_by = sum_neg(f->zz_by);
	return NULL;
}

static void map_of_elements(const struct elements *f, struct map *r)
{
	const struct sum z = sum_of_double(0);
	const struct sum m[4][4] = {
		{ f->x, z, z, z },
		{ f->yx, f->y, z, z },
		{ f->zx, f->zy, f->zz, f->zw },
		{ f->tx, f->ty, f->tz, f->tw },
	};

	memset(r, 0, sizeof *r);
	memcpy(r->m, m, sizeof m);
	r->divisor = sum_of_double(1);
	map_over(r, f->d);
	map_column_over(r, 0, f->dx);
	map_column_over(r, 1, f->dy);
	map_column_over(r, 2, f->dz);
}

/* Block by block: 1/x and 1/y; the inverse of zz zw, tz tw; and what makes the
 * lower left one cancel. What columns were divided by, rows are multiplied by. Where y
 * goes into x, the first column is over x y. */
static struct elements inverse_elements(const struct elements *f)
{
	struct sum by = f->d, tz = f->tz, zz = f->zz, det = f->det;

	if (det.error.m > 0) {
		by = sum_mul(by, f->by);
		tz = f->tz_by;
		zz = f->zz_by;
		det = sum_of_double(1);
	}
	struct sum zx = sum_minor(f->tw, f->zx, f->zw, f->tx),
		   y = sum_of_double(1);
	struct sum zy = sum_minor(f->tw, f->zy, f->zw, f->ty);
	struct sum tx = sum_minor(tz, f->zx, zz, f->tx);
	struct sum ty = sum_minor(tz, f->zy, zz, f->ty);
	struct sum z = sum_mul(by, f->dz), minus_z = sum_neg(z);
	struct sum x = sum_mul(f->d, det);

	if (sum_sign(f->yx) != 0) {
		y = f->y;
		zx = sum_minor(zx, y, f->yx, zy);
		tx = sum_minor(tx, y, f->yx, ty);
	}
	return (struct elements){
		.x = sum_mul(f->dx, sum_mul(y, x)),
		.yx = sum_neg(sum_mul(f->dy, sum_mul(f->yx, x))),
		.y = sum_mul(f->dy, x),
		.zx = sum_mul(minus_z, zx),
		.zy = sum_mul(minus_z, zy),
		.zz = sum_mul(z, f->tw),
		.zw = sum_mul(minus_z, f->zw),
		.tx = sum_mul(f->d, tx),
		.ty = sum_mul(f->d, ty),
		.tz = sum_neg(sum_mul(f->d, tz)),
		.tw = sum_mul(f->d, zz),
		.dx = sum_mul(f->x, y),
		.dy = f->y,
		.dz = sum_of_double(1),
		.d = det,
	};
}

/* Whether the last row, or else the last column, has nothing but w = z or -z. */
static bool is_w_of_z(const double m[4][4], bool row)
{
	bool is = true;

	for (int i = 0; i < 4; i++) {
		double a = fabs(row ? m[3][i] : m[i][3]);

		is &= a == (i == 2);
	}
	return is;
}

/* What a perspective's transpose would be. */
static bool is_transposed(const double m[4][4])
{
	bool is_affine = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 &&
	    m[3][3] == 1;

	return is_w_of_z(m, true) && !is_w_of_z(m, false) && !is_affine;
}

static const char *projection_bare(const struct projection *p, bool inverse,
    struct map *r)
{
	map_of_doubles(p->matrix, r);
	if (is_transposed(p->matrix))
		return "/projection/matrix: is transposed; in memory order w "
		       "is made by numbers 4, 8, 12 and 16, and rows stand as "
		       "\"vectors\" says";
	if (inverse && !map_inverse(p->matrix, r))
		return "/projection/matrix: singular; it can't be inverted";
	memset(r->origin, 0, sizeof r->origin);
	return NULL;
}

/* Whether P is no K with an offset, or K is singular. */
static bool is_any_p(const struct projection *p)
{
	const double(*k)[4] = p->intrinsics;

	return projection_is_tilted(p) ||
	    (projection_is_by_p(p) &&
		(k[1][0] != 0 || k[0][0] == 0 || k[1][1] == 0));
}

/* Of a tilted P, view space to a space in which P is K = 1 0 0, 0 1 0, 0 0 1. X, Y and
 * Z are view x, y and z but for their signs, on both sides. */
static void projection_level(const struct projection *p,
    const struct convention *c, double level[4][4])
{
	const double sign[4] = { 1, c->bottom_left == c->view_y_down ? -1 : 1,
		looks_back(c) ? -1 : 1, 1 };

	for (int i = 0; i < 4; i++) {
		for (int j = 0; j < 3; j++)
			level[i][j] = sign[i] * sign[j] * p->intrinsics[j][i];
		level[i][3] = i == 3;
	}
}

/* Level, and on by 1 0 0, 0 1 0, 0 0 1 in the place of P. */
static struct projection leveled(const struct projection *p)
{
	struct projection own = *p;

	for (int i = 0; i < 12; i++)
		own.intrinsics[i / 4][i % 4] = i / 4 == i % 4;
	return own;
}

static const char *any_p(const struct projection *p, const struct convention *c,
    bool inverse, struct map *r)
{
	struct projection on = leveled(p);
	double m[4][4];
	struct map level, stage;

	projection_level(p, c, m);
	map_of_doubles(m, &level);
	if (inverse && !map_inverse(m, &level))
		return "/projection/intrinsics: the left three columns of P "
		       "are singular; it can't be inverted";
	const char *why = projection_map(&on, c, inverse, &stage);

	if (why != NULL)
		return why;
	map_then(inverse ? &stage : &level, inverse ? &level : &stage, r);
	memset(r->origin, 0, sizeof r->origin);
	return NULL;
}

static bool has_elements(const struct projection *p)
{
	return p->type != PROJECTION_NONE && p->type != PROJECTION_MATRIX;
}

/* Where y is down in view space, a volume is skewed that way too. */
static const char *find_elements(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	const char *why = NULL;

	switch (p->type) {
	case PROJECTION_PERSP:
		why = persp_elements(p, c, f);
		break;
	case PROJECTION_ORTHO:
		why = ortho_elements(p, c, f);
		break;
	case PROJECTION_OBLIQUE:
		why = oblique_elements(p, c, f);
		break;
	case PROJECTION_VOLUME:
		why = volume_elements(p, c, f);
		break;
	case PROJECTION_NONE:
	case PROJECTION_MATRIX:
		break;
	}
	f->y = sum_negated_if(c->view_y_down, f->y);
	f->yx = sum_negated_if(c->view_y_down, f->yx);
	f->zy = sum_negated_if(c->view_y_down && p->type == PROJECTION_VOLUME,
	    f->zy);
	return why;
}

const char *projection_map(const struct projection *p,
    const struct convention *c, bool inverse, struct map *r)
{
	struct elements f = { 0 };

	if (p->type == PROJECTION_NONE)
		map_identity(r);
	if (p->type == PROJECTION_MATRIX)
		return projection_bare(p, inverse, r);
	if (!has_elements(p))
		return NULL;
	if (is_any_p(p))
		return any_p(p, c, inverse, r);
	const char *why = find_elements(p, c, &f);

	if (why != NULL)
		return why;
	if (c->ndc_y_down) {
		f.y = sum_neg(f.y);
		f.zy = sum_neg(f.zy);
		f.ty = sum_neg(f.ty);
	}
	if (inverse)
		f = inverse_elements(&f);
	map_of_elements(&f, r);
	return NULL;
}

/* Whether a parallel projection has a camera in it, as what only a turn makes of it
 * says: x or y goes into depth, x into y; or half a turn mirrors x or y. */
static bool has_camera(const struct projection *p, const struct convention *c)
{
	const double(*m)[4] = p->matrix;
	bool down = c->ndc_y_down != c->view_y_down;
	bool mirrors = ((m[0][0] < 0) != (m[1][1] < 0)) != down;

	return m[0][1] != 0 || m[0][2] != 0 || m[1][2] != 0 ||
	    (p->alone && mirrors);
}

/* 1/w = z m[2][3] + m[3][3] on the axis, for m the inverse: it is larger nearby. */
bool projection_is_reversed(const struct projection *p,
    const struct convention *c)
{
	struct map back;

	if (p->type == PROJECTION_NONE)
		return looks_back(c);
	if (p->type != PROJECTION_MATRIX || !map_inverse(p->matrix, &back))
		return p->reverse_z;
	int grows = sum_sign(back.m[2][3]);
	int along_z = sum_sign(back.m[2][2]) * sum_sign(back.m[3][3]);

	if (grows == 0 && has_camera(p, c))
		return false;
	return grows != 0 ? grows > 0 : along_z == (looks_back(c) ? 1 : -1);
}
