#include "projection.h"

#include <string.h>

#include "trig.h"

/* The matrix of every projection that is made of parameters:
 *	 x   0   0   0
 *	 0   y   0   0
 *	 zx  zy  zz  zw
 *	 tx  ty  tz  tw
 * det = zz tw - zw tz is known as a product of parameters, without
 * cancellation. tx_size and ty_size are the sums of the magnitudes of tx's and
 * ty's terms; only oblique's have more than one term. */
struct elements {
	ex x, y, zx, zy, zz, zw, tx, ty, tz, tw, det;
	ex tx_size, ty_size;
};

static ex negated_if(bool yes, ex a)
{
	return yes ? ex_neg(a) : a;
}

/* a + b. *size is the sum of the magnitudes of a's terms, and becomes that of
 * the result's. */
static ex sum(ex a, ex b, ex *size)
{
	*size = ex_add(ex_abs(*size), ex_abs(b));
	return ex_settled(ex_add(a, b), *size);
}

/* The elements of one axis: 2 d / (b - a), and (a + b) / (b - a), by which the
 * cross-section's centre is off the axis. */
static const char *edges(double a, double b, double d, const char *equal,
    ex *scale, ex *off)
{
	ex size = ex_diff(b, a);

	if (ex_sign(size) == 0)
		return equal;
	*scale = ex_quotient(ex_of(2 * d), size);
	*off = ex_quotient(ex_diff(a, -b), size);
	return NULL;
}

/* One of x and y is s / over; the other follows from the aspect w / h. */
static void by_aspect(const double aspect[2], bool given_x, ex s, ex over,
    struct elements *f)
{
	ex w = ex_of(aspect[0]), h = ex_of(aspect[1]);
	ex given = ex_quotient(s, over);

	f->x = given_x ? given : ex_quotient(ex_mul(s, h), ex_mul(over, w));
	f->y = given_x ? ex_quotient(ex_mul(s, w), ex_mul(over, h)) : given;
}

/* Sets x, y and by how much the centre is off; d is the distance of the plane
 * in which width, height and edges are given: near for persp, 1 otherwise. */
static const char *cross_section(const struct projection *p, double d,
    struct elements *f, ex off[2])
{
	bool wide = p->aspect[0] >= p->aspect[1];
	ex cot = ex_of(0);
	const char *why;

	off[0] = off[1] = ex_of(0);
	if (p->extent <= EXTENT_VIEW_ANGLE)
		cot = cot_half_deg(p->angle);
	switch (p->extent) {
	case EXTENT_FOVY:
		by_aspect(p->aspect, false, cot, ex_of(1), f);
		break;
	case EXTENT_FOVX:
		by_aspect(p->aspect, true, cot, ex_of(1), f);
		break;
	case EXTENT_VIEW_ANGLE:
		by_aspect(p->aspect, !wide, cot, ex_of(1), f);
		break;
	case EXTENT_FIELD:
		by_aspect(p->aspect, wide, ex_of(1), ex_of(p->angle), f);
		break;
	case EXTENT_HEIGHT:
		by_aspect(p->aspect, false, ex_of(2), ex_of(p->height), f);
		break;
	case EXTENT_SIZE:
		f->x = ex_quotient(ex_of(2 * d), ex_of(p->width));
		f->y = ex_quotient(ex_of(2 * d), ex_of(p->height));
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
	bool right = c->right_handed;
	ex off[2];
	const char *why = cross_section(p, n, f, off);

	if (why != NULL)
		return why;
	if (!(n < p->far))
		return "/projection/near: not less than far; for reversed "
		       "depth say \"reverse_z\": true";
	if (isinf(p->far)) {
		/* A = 1, reversed 1 - k; B = -k n, reversed k n */
		f->zz = ex_of(p->reverse_z ? 1 - k : 1);
		f->tz = ex_of(p->reverse_z ? k * n : -k * n);
	} else {
		double a = p->reverse_z ? p->far : n;
		double b = p->reverse_z ? n : p->far;
		ex size = ex_diff(b, a);

		f->zz = ex_quotient(c->minus_one ? ex_diff(b, -a) : ex_of(b),
		    size);
		f->tz = ex_quotient(ex_scale(ex_of(-k * a), b), size);
	}
	f->zx = negated_if(!right, off[0]);
	f->zy = negated_if(!right, off[1]);
	f->zz = negated_if(right, f->zz);
	f->zw = negated_if(right, ex_of(1));
	f->det = negated_if(!right, f->tz);
	return NULL;
}

static const char *ortho(const struct projection *p, const struct convention *c,
    struct elements *f)
{
	double a = p->reverse_z ? p->far : p->near;
	double b = p->reverse_z ? p->near : p->far;
	ex size = ex_diff(b, a);
	ex off[2];
	const char *why = cross_section(p, 1, f, off);

	if (why != NULL)
		return why;
	if (ex_sign(size) == 0)
		return "/projection/far: equal to near; "
		       "the planes must differ";
	f->zz = ex_quotient(ex_of(c->minus_one ? 2 : 1), size);
	f->tz = ex_quotient(c->minus_one ? ex_diff(-a, b) : ex_of(-a), size);
	f->zz = negated_if(c->right_handed, f->zz);
	f->tx = f->tx_size = ex_neg(off[0]);
	f->ty = f->ty_size = ex_neg(off[1]);
	f->tw = ex_of(1);
	f->det = f->zz;
	return NULL;
}

/* ortho after x' = x + cot cos(direction) (depth - plane), y' likewise. */
static const char *oblique(const struct projection *p,
    const struct convention *c, struct elements *f)
{
	const char *why = ortho(p, c, f);
	ex cot = ex_of(p->kind == OBLIQUE_CABINET ? 0.5 : 1);

	if (why != NULL)
		return why;
	if (p->kind == OBLIQUE_ANGLE)
		cot = cot_deg(p->projector);
	ex zx = ex_mul(ex_mul(cot, cos_deg(p->direction)), f->x);
	ex zy = ex_mul(ex_mul(cot, sin_deg(p->direction)), f->y);

	f->tx = sum(f->tx, ex_scale(zx, -p->plane), &f->tx_size);
	f->ty = sum(f->ty, ex_scale(zy, -p->plane), &f->ty_size);
	f->zx = negated_if(c->right_handed, zx);
	f->zy = negated_if(c->right_handed, zy);
	return NULL;
}

/* With q = qn / qd the inverse of the eye's z, an / qd = 1 - zf q and bn / qd =
 * 1 - zn q are w on the far and the near plane: one sign, or the eye plane lies
 * inside. */
struct eye {
	ex qn, qd, an, bn;
	double skew[2];
};

static const char *eye_of(const struct projection *p, struct eye *e)
{
	if (p->has_eye && p->eye[2] == 0)
		return "/projection/eye: its z is 0, in the rectangle's "
		       "plane; move the eye off it";
	e->qn = ex_of(p->has_eye ? 1 : p->inverse_eye_z);
	e->qd = ex_of(p->has_eye ? p->eye[2] : 1);
	e->an = ex_sub(e->qd, ex_scale(e->qn, p->z_far));
	e->bn = ex_sub(e->qd, ex_scale(e->qn, p->z_near));
	memcpy(e->skew, p->has_eye ? p->eye : p->tan_skew, sizeof e->skew);
	if (ex_sign(e->an) * ex_sign(e->bn) > 0)
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
	ex size = ex_diff(p->z_near, p->z_far), one = ex_of(1);
	struct eye e;

	if (ex_sign(size) == 0)
		return "/projection/z_far: equal to z_near; "
		       "the planes must differ";
	const char *why = eye_of(p, &e);

	if (why != NULL)
		return why;
	ex depth = e.an, offset = ex_scale(e.an, p->z_near);

	if (c->minus_one) {
		depth = ex_add(depth, e.bn);
		offset = ex_add(offset, ex_scale(e.bn, p->z_far));
	}
	ex over = ex_mul(e.qd, size);

	f->x = ex_quotient(one, ex_of(p->half_width));
	f->y = ex_quotient(one, ex_of(p->half_height));
	f->zx = ex_quotient(ex_of(-e.skew[0]), ex_scale(e.qd, p->half_width));
	f->zy = ex_quotient(ex_of(-e.skew[1]), ex_scale(e.qd, p->half_height));
	f->zz = ex_neg(ex_quotient(depth, over));
	f->zw = ex_neg(ex_quotient(e.qn, e.qd));
	f->tz = ex_quotient(offset, over);
	f->tw = one;
	f->det = ex_quotient(ex_mul(e.an, ex_shift(e.bn, c->minus_one)),
	    ex_neg(ex_mul(over, e.qd)));
	if (ex_sign(e.an) == ex_sign(e.qd))
		return NULL;
	for (ex *m = &f->x; m <= &f->tw; m++)
		*m = ex_neg(*m);
	return NULL;
}

static struct map map_of_elements(const struct elements *f)
{
	dd m[4][4] = {
		{ ex_round(f->x) },
		{ [1] = ex_round(f->y) },
		{ ex_round(f->zx), ex_round(f->zy), ex_round(f->zz),
		    ex_round(f->zw) },
		{ ex_round(f->tx), ex_round(f->ty), ex_round(f->tz),
		    ex_round(f->tw) },
	};
	struct map r = map_of(m);

	for (int i = AT_ORIGIN; i <= AT_ZERO; i++) {
		r.sum[i][0] = fabs(ex_round(f->tx_size).hi);
		r.sum[i][1] = fabs(ex_round(f->ty_size).hi);
	}
	return r;
}

/* Block by block: 1/x and 1/y; the inverse of zz zw, tz tw; and what makes the
 * lower left one cancel, in which the term zw tx is 0 for every projection. */
static struct elements inverse_elements(const struct elements *f)
{
	ex one = ex_of(1), dx = ex_mul(f->det, f->x), dy = ex_mul(f->det, f->y);
	ex tx_size = ex_mul(f->zz, f->tx_size);
	ex ty_size = ex_mul(f->zz, f->ty_size);
	ex tx = sum(ex_neg(ex_mul(f->zz, f->tx)), ex_mul(f->tz, f->zx),
	    &tx_size);
	ex ty = sum(ex_neg(ex_mul(f->zz, f->ty)), ex_mul(f->tz, f->zy),
	    &ty_size);

	return (struct elements){
		.x = ex_quotient(one, f->x),
		.y = ex_quotient(one, f->y),
		.zx = ex_neg(ex_quotient(ex_mul(f->tw, f->zx), dx)),
		.zy = ex_neg(ex_quotient(ex_mul(f->tw, f->zy), dy)),
		.zz = ex_quotient(f->tw, f->det),
		.zw = ex_neg(ex_quotient(f->zw, f->det)),
		.tx = ex_quotient(tx, dx),
		.ty = ex_quotient(ty, dy),
		.tz = ex_neg(ex_quotient(f->tz, f->det)),
		.tw = ex_quotient(f->zz, f->det),
		.tx_size = ex_quotient(tx_size, dx),
		.ty_size = ex_quotient(ty_size, dy),
	};
}

static const char *bare(const struct projection *p, bool inverse, struct map *r)
{
	double m[4][4];

	memcpy(m, p->matrix, sizeof m);
	*r = map_of_doubles(m);
	if (inverse && !map_inverse(m, r))
		return "/projection/matrix: singular; it can't be inverted";
	map_about_zero(r);
	return NULL;
}

const char *projection_map(const struct projection *p,
    const struct convention *c, bool inverse, struct map *r)
{
	struct elements f = { 0 };
	const char *why = NULL;

	switch (p->type) {
	case PROJECTION_NONE:
		*r = map_identity;
		return NULL;
	case PROJECTION_MATRIX:
		return bare(p, inverse, r);
	case PROJECTION_PERSP:
		why = persp(p, c, &f);
		break;
	case PROJECTION_ORTHO:
		why = ortho(p, c, &f);
		break;
	case PROJECTION_OBLIQUE:
		why = oblique(p, c, &f);
		break;
	case PROJECTION_VOLUME:
		why = volume(p, c, &f);
		break;
	}
	if (why != NULL)
		return why;
	if (c->ndc_y_down) {
		f.y = ex_neg(f.y);
		f.zy = ex_neg(f.zy);
		f.ty = ex_neg(f.ty);
	}
	if (inverse)
		f = inverse_elements(&f);
	*r = map_of_elements(&f);
	return map_is_finite(r) ?
	    NULL :
	    "/projection: its matrix has elements beyond the range of "
	    "doubles; bring the sizes and distances nearer to one another";
}
