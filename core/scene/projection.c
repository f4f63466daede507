/* SPDX-License-Identifier: MIT */
#include "projection.h"

#include <string.h>

/* The matrix of every projection that is made of parameters:
 *	 x   0   0   0
 *	 0   y   0   0
 *	 zx  zy  zz  zw
 *	 tx  ty  tz  tw
 * whose columns are divided by dx, dy, dz and 1, and all of them by d. z, w and d are
 * exact but for a volume's angle, and so is det = zz tw - zw tz, as a product of
 * parameters, without cancellation. */
struct elements {
	struct sum x, y, zx, zy, zz, zw, tx, ty, tz, tw, dx, dy, dz, d, det;
};

/* Sets x / dx and y / dy: one of them to s / over, the other by the aspect w / h. */
static void by_aspect(const double aspect[2], bool given_x, struct sum s,
    double over, struct elements *f)
{
	struct sum w = sum_of_double(aspect[0]), h = sum_of_double(aspect[1]);

	f->dx = f->dy = sum_of_double(over);
	f->x = f->y = s;
	if (given_x) {
		f->y = sum_mul(s, w);
		f->dy = sum_mul(f->dy, h);
	} else {
		f->x = sum_mul(s, h);
		f->dx = sum_mul(f->dx, w);
	}
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

/* Sets x, y and by how much the centre is off. From a to b at the distance d a side
 * is seen at 2 d / (b - a), and off by (a + b) / (b - a). */
static const char *cross_section(const struct projection *p, double d,
    struct elements *f, struct sum off[2])
{
	bool wide = p->aspect[0] >= p->aspect[1], given_x = false;

	off[0] = off[1] = sum_of_double(0);
	f->x = f->y = sum_of_double(2 * d);
	f->dx = sum_of_double(p->width);
	f->dy = sum_of_double(p->height);
	switch (p->extent) {
	case EXTENT_FOVY:
	case EXTENT_FOVX:
	case EXTENT_VIEW_ANGLE:
		given_x = p->extent == EXTENT_FOVX ||
		    (p->extent == EXTENT_VIEW_ANGLE && !wide);
		by_aspect(p->aspect, given_x, cot_of(p->angle / 2, p->unit), 1,
		    f);
		break;
	case EXTENT_FIELD:
		by_aspect(p->aspect, wide, sum_of_double(1), p->angle, f);
		break;
	case EXTENT_WIDTH:
		by_aspect(p->aspect, true, f->x, p->width, f);
		break;
	case EXTENT_HEIGHT:
		by_aspect(p->aspect, false, f->y, p->height, f);
		break;
	case EXTENT_SIZE:
		break;
	case EXTENT_ANGLES:
		tangents(p->left, p->right, p->unit, &f->x, &f->dx, &off[0]);
		tangents(p->bottom, p->top, p->unit, &f->y, &f->dy, &off[1]);
		break;
	case EXTENT_INTRINSICS: /* pixels count from a corner */
		off[0] = f->dx;
		off[1] = f->dy;
		break;
	case EXTENT_EDGES:
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

/* det = -zw B. Intrinsics go on from the level space, see projection_level. */
static const char *persp_elements(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	double at = projection_is_by_p(p) ? 1 :
	    p->edges_at > 0               ? p->edges_at :
					    p->near;
	bool back = looks_back(c);
	bool down = projection_is_by_p(p) && !c->bottom_left;
	struct sum off[2];
	const char *why = cross_section(p, at, f, off);

	if (why != NULL)
		return why;
	if (!(p->near < p->far))
		return "/projection/near: not less than far; for reversed "
		       "depth say \"reverse_z\": true";
	f->d = sum_of_double(1);
	depth_elements(p, c->minus_one, f);
	f->det = sum_negated_if(!back, f->tz);
	f->zx = sum_negated_if(!back, off[0]);
	f->zy = sum_negated_if(back == down, off[1]);
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

/* Half a side of a volume is dx / x, or dy / y. */
static void halves(const struct projection *p, struct elements *f)
{
	bool wide = p->aspect[0] >= p->aspect[1];

	f->x = f->y = sum_of_double(1);
	f->dx = sum_of_double(p->half_width);
	f->dy = sum_of_double(p->half_height);
	if (p->aspect[1] != 0)
		by_aspect(p->aspect, !wide, f->x, p->half_width, f);
}

/* cot(angle / 2) = |z| / least half side; 0 is at infinity. */
static void by_view_angle(const struct projection *p, struct sum *over,
    struct sum *under)
{
	struct elements f;

	halves(p, &f);
	bool high = sum_sign(sum_minor(f.dx, f.y, f.dy, f.x)) <= 0;
	struct sum cot = cot_of(p->angle / 2, p->unit);

	*over = sum_negated_if(p->z_near < p->z_far, high ? f.x : f.y);
	*under = sum_mul(high ? f.dx : f.dy, cot);
	if (under->error.m > 0) {
		*over = sum_quotient(*over, *under);
		*under = sum_of_double(1);
	}
}

void projection_inverse_eye_z(const struct projection *p, struct sum *over,
    struct sum *under)
{
	if (p->eye_by == EYE_BY_ANGLE && p->angle > 0) {
		by_view_angle(p, over, under);
		return;
	}
	*over = sum_of_double(p->eye_by == EYE_GIVEN ? 1 :
		p->eye_by == EYE_BY_ANGLE            ? 0 :
						       p->inverse_eye_z);
	*under = sum_of_double(p->eye_by == EYE_GIVEN ? p->eye[2] : 1);
}

static const char *eye_plane_crosses(const struct projection *p)
{
	if (p->eye_by == EYE_BY_ANGLE)
		return "/projection/view_angle: the eye plane crosses the "
		       "volume; choose a smaller one, or move z_near";
	return p->eye_by == EYE_GIVEN ?
	    "/projection/eye: its plane crosses the volume; "
	    "move it before z_near or beyond z_far" :
	    "/projection/inverse_eye_z: the eye plane crosses "
	    "the volume; it must lie before z_near or "
	    "beyond z_far";
}

/* With q = qn / qd the inverse of the eye's z, an / qd = 1 - zf q and bn / qd =
 * 1 - zn q are w on the far and the near plane: one sign, or the eye plane lies
 * inside. All is over qd, so that a parallel projection, q = 0, is no special case. */
static const char *volume_elements(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	struct sum zn = sum_of_double(p->z_near), zf = sum_of_double(p->z_far);
	struct sum qn, qd, skew[2];

	halves(p, f);
	f->dz = sum_sub(zn, zf);
	if (sum_sign(f->dz) == 0)
		return "/projection/z_far: equal to z_near; "
		       "the planes must differ";
	if (p->eye_by == EYE_GIVEN && p->eye[2] == 0)
		return "/projection/eye: its z is 0, in the rectangle's "
		       "plane; move the eye off it";
	projection_inverse_eye_z(p, &qn, &qd);
	struct sum an = sum_sub(qd, sum_mul(qn, zf));
	struct sum bn = sum_sub(qd, sum_mul(qn, zn));

	if (sum_sign(an) * sum_sign(bn) <= 0)
		return eye_plane_crosses(p);
	for (int k = 0; k < 2; k++)
		skew[k] = p->eye_by == EYE_GIVEN ?
		    sum_of_double(p->eye[k]) :
		    sum_mul(sum_of_double(p->tan_skew[k]), qd);
	f->zx = sum_neg(sum_mul(skew[0], f->x));
	f->zy = sum_neg(sum_mul(skew[1], f->y));
	f->x = sum_mul(qd, f->x);
	f->y = sum_mul(qd, f->y);
	f->tw = qd;
	f->d = sum_negated_if(sum_sign(an) != sum_sign(qd), qd);
	f->zz = sum_neg(an);
	f->zw = sum_neg(qn);
	f->tz = sum_mul(an, zn);
	f->det = sum_neg(sum_mul(an, bn));
	if (c->minus_one) {
		f->zz = sum_sub(f->zz, bn);
		f->tz = sum_add(f->tz, sum_mul(bn, zf));
		f->det = sum_mul(f->det, sum_of_double(2));
	}
	return NULL;
}

static void map_of_elements(const struct elements *f, struct map *r)
{
	const struct sum z = sum_of_double(0);
	const struct sum m[4][4] = {
		{ f->x, z, z, z },
		{ z, f->y, z, z },
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
 * lower left one cancel. What columns were divided by, rows are multiplied by. */
static struct elements inverse_elements(const struct elements *f)
{
	struct sum one = sum_of_double(1), det = f->det, d = f->d;

	if (det.error.m > 0) {
		d = sum_quotient(d, det);
		det = one;
	}
	struct sum x = sum_mul(f->d, det), z = sum_mul(d, f->dz);
	struct sum minus_z = sum_neg(z);

	return (struct elements){
		.x = sum_mul(f->dx, x),
		.y = sum_mul(f->dy, x),
		.zx = sum_mul(minus_z, sum_minor(f->tw, f->zx, f->zw, f->tx)),
		.zy = sum_mul(minus_z, sum_minor(f->tw, f->zy, f->zw, f->ty)),
		.zz = sum_mul(z, f->tw),
		.zw = sum_mul(minus_z, f->zw),
		.tx = sum_mul(d, sum_minor(f->tz, f->zx, f->zz, f->tx)),
		.ty = sum_mul(d, sum_minor(f->tz, f->zy, f->zz, f->ty)),
		.tz = sum_neg(sum_mul(d, f->tz)),
		.tw = sum_mul(d, f->zz),
		.dx = f->x,
		.dy = f->y,
		.dz = one,
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

/* Takes the map of the level space to clip space, or back, to that of view space. */
static const char *from_level(const struct projection *p,
    const struct convention *c, bool inverse, struct map *r)
{
	double m[4][4];
	struct map level, stage = *r;

	projection_level(p, c, m);
	map_of_doubles(m, &level);
	if (inverse && !map_inverse(m, &level))
		return "/projection/intrinsics: the left three columns of P "
		       "are singular; it can't be inverted";
	map_then(inverse ? &stage : &level, inverse ? &level : &stage, r);
	memset(r->origin, 0, sizeof r->origin);
	return NULL;
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
	f->zy = sum_negated_if(c->view_y_down && p->type == PROJECTION_VOLUME,
	    f->zy);
	if (c->ndc_y_down) {
		f->y = sum_neg(f->y);
		f->zy = sum_neg(f->zy);
		f->ty = sum_neg(f->ty);
	}
	return why;
}

const char *projection_map(const struct projection *p,
    const struct convention *c, bool inverse, struct map *r)
{
	struct elements f = { 0 };

	if (p->type == PROJECTION_NONE) {
		map_identity(r);
		return NULL;
	}
	if (p->type == PROJECTION_MATRIX)
		return projection_bare(p, inverse, r);
	const char *why = find_elements(p, c, &f);

	if (why != NULL)
		return why;
	if (inverse)
		f = inverse_elements(&f);
	map_of_elements(&f, r);
	return projection_is_by_p(p) ? from_level(p, c, inverse, r) : NULL;
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
