#include "projection.h"

#include <string.h>

/* The matrix of every projection that is made of parameters:
 *	 x   0   0   0
 *	 0   y   0   0
 *	 zx  zy  zz  zw
 *	 tx  ty  tz  tw
 * det = zz tw - zw tz is known as a product of parameters, without
 * cancellation. */
struct elements {
	struct sum x, y, zx, zy, zz, zw, tx, ty, tz, tw, det;
};

static struct sum number(double a)
{
	return sum_of_double(a);
}

static struct sum negated_if(bool yes, struct sum a)
{
	return yes ? sum_neg(a) : a;
}

static struct sum difference(double a, double b)
{
	return sum_of(ex_diff(a, b));
}

/* The elements of one axis: 2 d / (b - a), and (a + b) / (b - a), by which the
 * cross-section's centre is off the axis. */
static const char *edges(double a, double b, double d, const char *equal,
    struct sum *scale, struct sum *off)
{
	struct sum size = difference(b, a);

	if (sum_sign(size) == 0)
		return equal;
	*scale = sum_quotient(number(2 * d), size);
	*off = sum_quotient(difference(a, -b), size);
	return NULL;
}

/* One of x and y is s / over; the other follows from the aspect w / h. */
static void by_aspect(const double aspect[2], bool given_x, struct sum s,
    struct sum over, struct elements *f)
{
	struct sum w = number(aspect[0]), h = number(aspect[1]);
	struct sum given = sum_quotient(s, over);

	f->x = given_x ? given : sum_quotient(sum_mul(s, h), sum_mul(over, w));
	f->y = given_x ? sum_quotient(sum_mul(s, w), sum_mul(over, h)) : given;
}

/* Sets x, y and by how much the centre is off; d is the distance of the plane
 * in which width, height and edges are given: near for persp, 1 otherwise. */
static const char *cross_section(const struct projection *p, double d,
    struct elements *f, struct sum off[2])
{
	bool wide = p->aspect[0] >= p->aspect[1];
	struct sum cot = number(0);
	const char *why;

	off[0] = off[1] = number(0);
	if (p->extent <= EXTENT_VIEW_ANGLE)
		cot = cot_half_of(p->angle, p->unit);
	switch (p->extent) {
	case EXTENT_FOVY:
		by_aspect(p->aspect, false, cot, number(1), f);
		break;
	case EXTENT_FOVX:
		by_aspect(p->aspect, true, cot, number(1), f);
		break;
	case EXTENT_VIEW_ANGLE:
		by_aspect(p->aspect, !wide, cot, number(1), f);
		break;
	case EXTENT_FIELD:
		by_aspect(p->aspect, wide, number(1), number(p->angle), f);
		break;
	case EXTENT_HEIGHT:
		by_aspect(p->aspect, false, number(2), number(p->height), f);
		break;
	case EXTENT_SIZE:
		f->x = sum_quotient(number(2 * d), number(p->width));
		f->y = sum_quotient(number(2 * d), number(p->height));
		break;
	case EXTENT_EDGES:
		why = edges(p->left, p->right, d,
		    "/projection/right: equal to left; "
		    "the edges must differ",
		    &f->x, &off[0]);
		if (why != NULL)
			return why;
		return edges(p->bottom, p->top, d,
		    "/projection/top: equal to bottom; "
		    "the edges must differ",
		    &f->y, &off[1]);
	}
	return NULL;
}

/* w = depth: depth' = A + B / w with A = f / (f - n), B = -n f / (f - n), or
 * to -1..1 A = (f + n) / (f - n), B = -2 n f / (f - n); an infinite far is the
 * limit; reversed, near and far trade places. det = -zw tz. */
static const char *persp(const struct projection *p, const struct convention *c,
    struct elements *f)
{
	double k = c->minus_one ? 2 : 1, n = p->near;
	bool back = looks_back(c);
	struct sum off[2];
	const char *why = cross_section(p, n, f, off);

	if (why != NULL)
		return why;
	if (!(n < p->far))
		return "/projection/near: not less than far; for reversed "
		       "depth say \"reverse_z\": true";
	if (isinf(p->far)) {
		/* A = 1, reversed 1 - k; B = -k n, reversed k n */
		f->zz = number(p->reverse_z ? 1 - k : 1);
		f->tz = number(p->reverse_z ? k * n : -k * n);
	} else {
		double a = p->reverse_z ? p->far : n;
		double b = p->reverse_z ? n : p->far;
		struct sum size = difference(b, a);

		f->zz = sum_quotient(c->minus_one ? difference(b, -a) :
						    number(b),
		    size);
		f->tz = sum_quotient(sum_mul(number(-k * a), number(b)), size);
	}
	f->zx = negated_if(!back, off[0]);
	f->zy = negated_if(!back, off[1]);
	f->zz = negated_if(back, f->zz);
	f->zw = negated_if(back, number(1));
	f->det = negated_if(!back, f->tz);
	return NULL;
}

static const char *ortho(const struct projection *p, const struct convention *c,
    struct elements *f)
{
	double a = p->reverse_z ? p->far : p->near;
	double b = p->reverse_z ? p->near : p->far;
	struct sum size = difference(b, a);
	struct sum off[2];
	const char *why = cross_section(p, 1, f, off);

	if (why != NULL)
		return why;
	if (sum_sign(size) == 0)
		return "/projection/far: equal to near; "
		       "the planes must differ";
	f->zz = sum_quotient(number(c->minus_one ? 2 : 1), size);
	f->tz = sum_quotient(c->minus_one ? difference(-a, b) : number(-a),
	    size);
	f->zz = negated_if(looks_back(c), f->zz);
	f->tx = sum_neg(off[0]);
	f->ty = sum_neg(off[1]);
	f->tw = number(1);
	f->det = f->zz;
	return NULL;
}

/* ortho after x' = x + cot cos(direction) (depth - plane), y' likewise. */
static const char *oblique(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	const char *why = ortho(p, c, f);
	struct sum cot = number(p->kind == OBLIQUE_CABINET ? 0.5 : 1);

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

	f->tx = sum_sub(f->tx, sum_mul(zx, number(p->plane)));
	f->ty = sum_sub(f->ty, sum_mul(zy, number(p->plane)));
	f->zx = negated_if(looks_back(c), zx);
	f->zy = negated_if(looks_back(c), zy);
	return NULL;
}

/* With q = qn / qd the inverse of the eye's z, an / qd = 1 - zf q and bn / qd =
 * 1 - zn q are w on the far and the near plane: one sign, or the eye plane lies
 * inside. */
struct eye {
	struct sum qn, qd, an, bn;
	double skew[2];
};

static const char *eye_of(const struct projection *p, struct eye *e)
{
	if (p->has_eye && p->eye[2] == 0)
		return "/projection/eye: its z is 0, in the rectangle's "
		       "plane; move the eye off it";
	e->qn = number(p->has_eye ? 1 : p->inverse_eye_z);
	e->qd = number(p->has_eye ? p->eye[2] : 1);
	e->an = sum_sub(e->qd, sum_mul(e->qn, number(p->z_far)));
	e->bn = sum_sub(e->qd, sum_mul(e->qn, number(p->z_near)));
	memcpy(e->skew, p->has_eye ? p->eye : p->tan_skew, sizeof e->skew);
	if (sum_sign(e->an) * sum_sign(e->bn) > 0)
		return NULL;
	return p->has_eye ? "/projection/eye: its plane crosses the volume; "
			    "move it before z_near or beyond z_far" :
			    "/projection/inverse_eye_z: the eye plane crosses "
			    "the volume; it must lie before z_near or "
			    "beyond z_far";
}

/* Each element is a quotient of exact polynomials, so that a parallel projection,
 * q = 0, is no special case. */
static const char *volume(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	struct sum size = difference(p->z_near, p->z_far);
	struct sum width = number(p->half_width);
	struct sum height = number(p->half_height);
	struct eye e;

	if (sum_sign(size) == 0)
		return "/projection/z_far: equal to z_near; "
		       "the planes must differ";
	const char *why = eye_of(p, &e);

	if (why != NULL)
		return why;
	struct sum depth = e.an, offset = sum_mul(e.an, number(p->z_near));
	struct sum over = sum_mul(e.qd, size), det = sum_mul(e.an, e.bn);

	if (c->minus_one) {
		depth = sum_add(depth, e.bn);
		offset = sum_add(offset, sum_mul(e.bn, number(p->z_far)));
		det = sum_mul(det, number(2));
	}
	f->x = sum_quotient(number(1), width);
	f->y = sum_quotient(number(1), height);
	f->zx = sum_quotient(number(-e.skew[0]), sum_mul(e.qd, width));
	f->zy = sum_quotient(number(-e.skew[1]), sum_mul(e.qd, height));
	f->zz = sum_neg(sum_quotient(depth, over));
	f->zw = sum_neg(sum_quotient(e.qn, e.qd));
	f->tz = sum_quotient(offset, over);
	f->tw = number(1);
	f->det = sum_neg(sum_quotient(det, sum_mul(over, e.qd)));
	if (sum_sign(e.an) == sum_sign(e.qd))
		return NULL;
	for (struct sum *m = &f->x; m <= &f->tw; m++)
		*m = sum_neg(*m);
	return NULL;
}

static void map_of_elements(const struct elements *f, struct map *r)
{
	const struct sum z = number(0);
	const struct sum m[4][4] = {
		{ f->x, z, z, z },
		{ z, f->y, z, z },
		{ f->zx, f->zy, f->zz, f->zw },
		{ f->tx, f->ty, f->tz, f->tw },
	};

	memset(r, 0, sizeof *r);
	memcpy(r->m, m, sizeof m);
}

/* Block by block: 1/x and 1/y; the inverse of zz zw, tz tw; and what makes the
 * lower left one cancel, in which the term zw tx is 0 for every projection. */
static struct elements inverse_elements(const struct elements *f)
{
	struct sum one = number(1);
	struct sum dx = sum_mul(f->det, f->x), dy = sum_mul(f->det, f->y);
	struct sum tx = sum_sub(sum_mul(f->tz, f->zx), sum_mul(f->zz, f->tx));
	struct sum ty = sum_sub(sum_mul(f->tz, f->zy), sum_mul(f->zz, f->ty));

	return (struct elements){
		.x = sum_quotient(one, f->x),
		.y = sum_quotient(one, f->y),
		.zx = sum_neg(sum_quotient(sum_mul(f->tw, f->zx), dx)),
		.zy = sum_neg(sum_quotient(sum_mul(f->tw, f->zy), dy)),
		.zz = sum_quotient(f->tw, f->det),
		.zw = sum_neg(sum_quotient(f->zw, f->det)),
		.tx = sum_quotient(tx, dx),
		.ty = sum_quotient(ty, dy),
		.tz = sum_neg(sum_quotient(f->tz, f->det)),
		.tw = sum_quotient(f->zz, f->det),
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

static const char *bare(const struct projection *p, bool inverse, struct map *r)
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

static const char *find_upright(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	switch (p->type) {
	case PROJECTION_PERSP:
		return persp(p, c, f);
	case PROJECTION_ORTHO:
		return ortho(p, c, f);
	case PROJECTION_OBLIQUE:
		return oblique(p, c, f);
	default:
		return volume(p, c, f);
	}
}

/* Where y is down in view space, a volume is skewed that way too. */
static const char *find_elements(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	const char *why = find_upright(p, c, f);

	f->y = negated_if(c->view_y_down, f->y);
	f->zy = negated_if(c->view_y_down && p->type == PROJECTION_VOLUME,
	    f->zy);
	return why;
}

static bool has_elements(const struct projection *p)
{
	return p->type != PROJECTION_NONE && p->type != PROJECTION_MATRIX;
}

const char *projection_map(const struct projection *p,
    const struct convention *c, bool inverse, struct map *r)
{
	struct elements f = { 0 };

	if (p->type == PROJECTION_NONE)
		map_identity(r);
	if (p->type == PROJECTION_MATRIX)
		return bare(p, inverse, r);
	if (!has_elements(p))
		return NULL;
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

/* As ndc has it, through the inverse. */
static const char *bare_corner(const struct projection *p,
    const struct convention *c, const struct sum side[2], bool far,
    struct sum v[4])
{
	bool one = far != projection_is_reversed(p, c);
	struct sum clip[4] = { side[0],
		c->ndc_y_down ? sum_neg(side[1]) : side[1],
		number(one           ? 1 :
			c->minus_one ? -1 :
				       0),
		number(1) };
	struct map back;
	const char *why = projection_map(p, c, true, &back);

	for (int j = 0; j < 4 && why == NULL; j++) {
		v[j] = number(0);
		for (int i = 0; i < 4; i++)
			v[j] = sum_add(v[j], sum_mul(clip[i], back.m[i][j]));
	}
	return why;
}

/* With view z and clip w of the plane: x from side w = x X + zx z + tx. Over w,
 * as an infinite far plane has no other place. */
const char *projection_corner(const struct projection *p,
    const struct convention *c, const struct sum side[2], bool far,
    struct sum v[4])
{
	struct elements f = { 0 };
	double z = far ? p->far : p->near;

	if (!has_elements(p))
		return bare_corner(p, c, side, far, v);
	const char *why = find_elements(p, c, &f);

	if (why != NULL)
		return why;
	if (p->type == PROJECTION_VOLUME)
		z = far ? p->z_far : p->z_near;
	else if (looks_back(c))
		z = -z;
	if (isinf(z)) {
		v[2] = sum_quotient(number(1), f.zw);
		v[3] = number(0);
	} else {
		struct sum w = sum_add(sum_mul(f.zw, number(z)), f.tw);

		v[2] = sum_quotient(number(z), w);
		v[3] = sum_quotient(number(1), w);
	}
	v[0] = sum_sub(side[0],
	    sum_add(sum_mul(f.zx, v[2]), sum_mul(f.tx, v[3])));
	v[1] = sum_sub(side[1],
	    sum_add(sum_mul(f.zy, v[2]), sum_mul(f.ty, v[3])));
	v[0] = sum_quotient(v[0], f.x);
	v[1] = sum_quotient(v[1], f.y);
	return NULL;
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

	return grows != 0 ? grows > 0 : along_z == (looks_back(c) ? 1 : -1);
}
