#include "projection.h"

#include <string.h>

#include "trig.h"

#define ONE ((dd){ 1, 0 })

/* Every projection made of parameters has this form:
 *
 *	 x   0   0   0
 *	 0   y   0   0
 *	 zx  zy  zz  zw
 *	 tx  ty  tz  tw
 *
 * det = zz tw - zw tz comes from the parameters too, as a product. */
struct form {
	dd x, y, zx, zy, zz, zw, tx, ty, tz, tw, det;
};

static dd ratio(ex a, ex b)
{
	return ex_div(a, b);
}

static dd negated_if(bool yes, dd a)
{
	return yes ? dd_neg(a) : a;
}

/* The elements of one axis: 2 d / (b - a), and (a + b) / (b - a), which says
 * how far the section's centre is off. */
static const char *edges(double a, double b, double d, const char *equal,
    dd *scale, dd *off)
{
	ex size = ex_diff(b, a);

	if (size.n == 0)
		return equal;
	*scale = ratio(ex_of(2 * d), size);
	*off = ratio(ex_diff(a, -b), size);
	return NULL;
}

/* x = s w / (h scale), given y = s; the other way round for the larger side.
 * s is a quotient, so that each element is divided once. */
static void by_aspect(const double aspect[2], bool given_x, ex s, ex over,
    struct form *f)
{
	dd given = ratio(s, over);

	if (given_x) {
		f->x = given;
		f->y = ratio(ex_scale(s, aspect[0]), ex_scale(over, aspect[1]));
	} else {
		f->y = given;
		f->x = ratio(ex_scale(s, aspect[1]), ex_scale(over, aspect[0]));
	}
}

/* Sets x, y and how far off the centre is; d is the near distance for persp
 * and 1 for the parallel ones. */
static const char *cross_section(const struct projection *p, double d,
    struct form *f, dd off[2])
{
	bool wide = p->aspect[0] >= p->aspect[1];
	ex cot = { 0 };
	const char *why;

	off[0] = off[1] = (dd){ 0, 0 };
	if (p->extent <= EXTENT_VIEW_ANGLE)
		cot = ex_dd(cot_half_deg(p->angle));
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
		f->x = ratio(ex_of(2 * d), ex_of(p->width));
		f->y = ratio(ex_of(2 * d), ex_of(p->height));
		break;
	case EXTENT_EDGES:
		why = edges(p->left, p->right, d,
		    "/projection/right: equal to left; "
		    "the edges must differ", &f->x, &off[0]);
		if (why != NULL)
			return why;
		return edges(p->bottom, p->top, d,
		    "/projection/top: equal to bottom; "
		    "the edges must differ", &f->y, &off[1]);
	}
	return NULL;
}

/* w = depth: depth' = A + B / w with A = f / (f - n), B = -n f / (f - n), or
 * to -1..1 A = (f + n) / (f - n), B = -2 n f / (f - n); an infinite far is the
 * limit; reversed, near and far trade places. det = -zw tz. */
static const char *persp(const struct projection *p,
    const struct convention *c, struct form *f)
{
	double k = c->minus_one ? 2 : 1, n = p->near;
	bool right = c->right_handed;
	dd off[2];
	const char *why = cross_section(p, n, f, off);

	if (why != NULL)
		return why;
	if (!(n < p->far))
		return "/projection/near: not less than far; for reversed "
		       "depth say \"reverse_z\": true";
	if (isinf(p->far)) {
		/* A = 1, reversed 1 - k; B = -k n, reversed k n */
		f->zz = (dd){ p->reverse_z ? 1 - k : 1, 0 };
		f->tz = (dd){ p->reverse_z ? k * n : -k * n, 0 };
	} else {
		double a = p->reverse_z ? p->far : n;
		double b = p->reverse_z ? n : p->far;
		ex size = ex_diff(b, a);

		f->zz = ratio(c->minus_one ? ex_diff(b, -a) : ex_of(b), size);
		f->tz = dd_neg(ratio(ex_scale(ex_of(k * a), b), size));
	}
	f->zx = negated_if(!right, off[0]);
	f->zy = negated_if(!right, off[1]);
	f->zz = negated_if(right, f->zz);
	f->zw = negated_if(right, ONE);
	f->det = negated_if(!right, f->tz);
	return NULL;
}

static const char *ortho(const struct projection *p,
    const struct convention *c, struct form *f)
{
	double a = p->reverse_z ? p->far : p->near;
	double b = p->reverse_z ? p->near : p->far;
	ex size = ex_diff(b, a);
	dd off[2];
	const char *why = cross_section(p, 1, f, off);

	if (why != NULL)
		return why;
	if (size.n == 0)
		return "/projection/far: equal to near; "
		       "the planes must differ";
	f->zz = ratio(ex_of(c->minus_one ? 2 : 1), size);
	f->tz = dd_neg(ratio(c->minus_one ? ex_diff(b, -a) : ex_of(a), size));
	f->zz = negated_if(c->right_handed, f->zz);
	f->tx = dd_neg(off[0]);
	f->ty = dd_neg(off[1]);
	f->tw = ONE;
	f->det = f->zz;
	return NULL;
}

/* a - b c, rounded once. */
static dd minus_product(dd a, dd b, double c)
{
	return ex_round(ex_sub(ex_dd(a), ex_scale(ex_dd(b), c)));
}

/* ortho after x' = x + cot cos(direction) (depth - plane), y' likewise. */
static const char *oblique(const struct projection *p,
    const struct convention *c, struct form *f)
{
	const char *why = ortho(p, c, f);
	dd cot = { p->kind == OBLIQUE_CABINET ? 0.5 : 1, 0 };

	if (why != NULL)
		return why;
	if (p->kind == OBLIQUE_ANGLE)
		cot = cot_deg(p->projector);
	ex toward_x = ex_mul(ex_dd(cot), ex_dd(cos_deg(p->direction)));
	ex toward_y = ex_mul(ex_dd(cot), ex_dd(sin_deg(p->direction)));
	dd zx = ex_round(ex_mul(toward_x, ex_dd(f->x)));
	dd zy = ex_round(ex_mul(toward_y, ex_dd(f->y)));

	f->tx = minus_product(f->tx, zx, p->plane);
	f->ty = minus_product(f->ty, zy, p->plane);
	f->zx = negated_if(c->right_handed, zx);
	f->zy = negated_if(c->right_handed, zy);
	return NULL;
}

/* With q = qn / qd the inverse of the eye's z, a = 1 - zf q and b = 1 - zn q
 * are w on the far and the near plane: one sign, or the eye plane lies inside.
 * Each element is a quotient of exact polynomials, so nothing happens as q
 * passes 0. */
static const char *volume(const struct projection *p,
    const struct convention *c, struct form *f)
{
	double zn = p->z_near, zf = p->z_far;
	double qn = p->has_eye ? 1 : p->inverse_eye_z;
	double qd = p->has_eye ? p->eye[2] : 1;
	const double *skew = p->has_eye ? p->eye : p->tan_skew;
	ex size = ex_diff(zn, zf);

	if (size.n == 0)
		return "/projection/z_far: equal to z_near; "
		       "the planes must differ";
	if (qd == 0)
		return "/projection/eye: its z is 0, in the rectangle's "
		       "plane; move the eye off it";
	ex an = ex_sub(ex_of(qd), ex_scale(ex_of(zf), qn));
	ex bn = ex_sub(ex_of(qd), ex_scale(ex_of(zn), qn));
	dd a = ratio(an, ex_of(qd)), b = ratio(bn, ex_of(qd));

	if (!(a.hi > 0 && b.hi > 0) && !(a.hi < 0 && b.hi < 0))
		return p->has_eye ?
		    "/projection/eye: its plane crosses the volume; "
		    "move it before z_near or beyond z_far" :
		    "/projection/inverse_eye_z: the eye plane crosses the "
		    "volume; it must lie before z_near or beyond z_far";
	ex over = ex_scale(size, qd);
	ex zzn = an, tzn = ex_scale(an, zn);

	if (c->minus_one) {
		zzn = ex_add(an, bn);
		tzn = ex_add(tzn, ex_scale(bn, zf));
	}
	f->x = ratio(ex_of(1), ex_of(p->half_width));
	f->y = ratio(ex_of(1), ex_of(p->half_height));
	f->zx = dd_neg(ratio(ex_of(skew[0]), p->has_eye ?
	    ex_scale(ex_of(qd), p->half_width) : ex_of(p->half_width)));
	f->zy = dd_neg(ratio(ex_of(skew[1]), p->has_eye ?
	    ex_scale(ex_of(qd), p->half_height) : ex_of(p->half_height)));
	f->zz = dd_neg(ratio(zzn, over));
	f->zw = dd_neg(ratio(ex_of(qn), ex_of(qd)));
	f->tz = ratio(tzn, over);
	f->tw = ONE;
	f->det = dd_neg(ratio(ex_scale(ex_mul(ex_dd(a), ex_dd(b)),
	    c->minus_one ? 2 : 1), size));
	if (a.hi > 0)
		return NULL;
	for (dd *e = &f->x; e < &f->det; e++)
		*e = dd_neg(*e);
	return NULL;
}

static struct map matrix_of(const struct form *f)
{
	dd m[4][4] = {
		{ f->x },
		{ [1] = f->y },
		{ f->zx, f->zy, f->zz, f->zw },
		{ f->tx, f->ty, f->tz, f->tw },
	};

	return map_of(m);
}

/* (a b - c d) / (e f), and in sum the products' sizes. */
static dd minor_over(dd a, dd b, dd c, dd d, dd e, dd f, double *sum)
{
	ex p = ex_mul(ex_dd(a), ex_dd(b)), q = ex_mul(ex_dd(c), ex_dd(d));
	ex over = ex_mul(ex_dd(e), ex_dd(f));

	*sum = (fabs(ex_round(p).hi) + fabs(ex_round(q).hi)) /
	    fabs(ex_round(over).hi);
	return ratio(ex_sub(p, q), over);
}

/* With Z the lower right block of two: diag(1/x, 1/y), inv(Z) and
 * -inv(Z) (lower left block) diag(1/x, 1/y). */
static struct map inverse_of(const struct form *f)
{
	ex det = ex_dd(f->det);
	dd m[4][4] = {
		{ ratio(ex_of(1), ex_dd(f->x)) },
		{ [1] = ratio(ex_of(1), ex_dd(f->y)) },
		{ [2] = ratio(ex_dd(f->tw), det),
		    [3] = dd_neg(ratio(ex_dd(f->zw), det)) },
		{ [2] = dd_neg(ratio(ex_dd(f->tz), det)),
		    [3] = ratio(ex_dd(f->zz), det) },
	};
	double sum[2][2];

	m[2][0] = minor_over(f->zw, f->tx, f->tw, f->zx, f->det, f->x,
	    &sum[0][0]);
	m[2][1] = minor_over(f->zw, f->ty, f->tw, f->zy, f->det, f->y,
	    &sum[0][1]);
	m[3][0] = minor_over(f->tz, f->zx, f->zz, f->tx, f->det, f->x,
	    &sum[1][0]);
	m[3][1] = minor_over(f->tz, f->zy, f->zz, f->ty, f->det, f->y,
	    &sum[1][1]);
	struct map r = map_of(m);

	for (int i = 2; i <= AT_ZERO; i++)
		memcpy(r.sum[i], sum[i == 2 ? 0 : 1], sizeof sum[0]);
	return r;
}

static const char *bare(const struct projection *p, bool inverse,
    struct map *r)
{
	double m[4][4];

	memcpy(m, p->matrix, sizeof m);
	*r = map_of_doubles(m);
	if (inverse && !map_inverse(m, r))
		return "/projection/matrix: singular; it can't be inverted";
	return NULL;
}

const char *projection_map(const struct projection *p,
    const struct convention *c, bool inverse, struct map *r)
{
	struct form f = { 0 };
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
		f.y = dd_neg(f.y);
		f.zy = dd_neg(f.zy);
		f.ty = dd_neg(f.ty);
	}
	*r = inverse ? inverse_of(&f) : matrix_of(&f);
	return map_is_finite(r) ? NULL :
	    "/projection: its matrix has elements beyond the range of "
	    "doubles; bring the sizes and distances nearer to one another";
}
