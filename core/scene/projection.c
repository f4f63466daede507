/* SPDX-License-Identifier: MIT */
#include "projection.h"

#include <string.h>

/* The matrix of a projection that is given by parameters:
 *	 x   0   0   0
 *	 0   y   0   0
 *	 zx  zy  zz  zw
 *	 tx  ty  tz  tw
 * Its columns are divided by dx, dy, dz and 1, and the whole matrix by d. Columns z and
 * w, and d, are exact unless the projection is a volume with a view angle. */
struct scaled_matrix {
	struct sum x, y, zx, zy, zz, zw, tx, ty, tz, tw, dx, dy, dz, d;
};

/* Sets one quotient, x / dx if sets_x, else y / dy, to scale / divisor. Sets the other
 * quotient so that y / dy is aspect[0] / aspect[1] times x / dx. */
static void set_scales(const double aspect[2], bool sets_x, struct sum scale,
    double divisor, struct scaled_matrix *f)
{
	struct sum w = sum_of_double(aspect[0]), h = sum_of_double(aspect[1]);

	sum_set(&f->dx, divisor);
	sum_set(&f->dy, divisor);
	f->x = f->y = scale;
	if (sets_x) {
		f->y = sum_mul(scale, w);
		f->dy = sum_mul(f->dy, h);
	} else {
		f->x = sum_mul(scale, h);
		f->dx = sum_mul(f->dx, w);
	}
}

/* Computes scale = 2, size = r - l and edge_sum = l + r, each times cos a cos b, for
 * the edges l = tan a and r = tan b at distance 1. */
static void tangents(double a, double b, enum angle_unit unit, struct sum *scale,
    struct sum *size, struct sum *edge_sum)
{
	struct sum sa, ca, sb, cb;

	trig_sin_cos(a, unit, &sa, &ca);
	trig_sin_cos(b, unit, &sb, &cb);
	struct sum left = sum_mul(sa, cb), right = sum_mul(sb, ca);

	*scale = sum_mul(sum_of_double(2), sum_mul(ca, cb));
	*size = sum_sub(right, left);
	*edge_sum = sum_add(left, right);
}

/* Sets x / dx = 2 d / (r - l) and sums[0] / dx = (l + r) / (r - l), where l and r are
 * the left and right edge at distance d. Sets y, dy and sums[1] likewise. */
static const char *cross_section(const struct projection *p, double d,
    struct scaled_matrix *f, struct sum sums[2])
{
	const struct projection_section *s = &p->section;
	bool wide = p->aspect[0] >= p->aspect[1], sets_x = false;

	sum_set(&sums[0], 0);
	sum_set(&sums[1], 0);
	sum_set(&f->x, 2 * d);
	sum_set(&f->y, 2 * d);
	sum_set(&f->dx, s->width);
	sum_set(&f->dy, s->height);
	switch (s->way) {
	case SECTION_FOVY:
	case SECTION_FOVX:
	case SECTION_VIEW_ANGLE:
		sets_x = s->way == SECTION_FOVX ||
		    (s->way == SECTION_VIEW_ANGLE && !wide);
		set_scales(p->aspect, sets_x, trig_cot(s->angle / 2, p->unit), 1, f);
		break;
	case SECTION_FIELD:
		set_scales(p->aspect, wide, sum_of_double(1), s->field, f);
		break;
	case SECTION_WIDTH:
		set_scales(p->aspect, true, f->x, s->width, f);
		break;
	case SECTION_HEIGHT:
		set_scales(p->aspect, false, f->y, s->height, f);
		break;
	case SECTION_SIZE:
		break;
	case SECTION_ANGLES:
		tangents(s->angles[0], s->angles[1], p->unit, &f->x, &f->dx, &sums[0]);
		tangents(s->angles[2], s->angles[3], p->unit, &f->y, &f->dy, &sums[1]);
		break;
	case SECTION_INTRINSICS: /* edges from 0 to the viewport's size */
		sums[0] = f->dx;
		sums[1] = f->dy;
		break;
	case SECTION_EDGES:
		f->dx = sum_difference(s->right, s->left);
		f->dy = sum_difference(s->top, s->bottom);
		sums[0] = sum_difference(s->left, -s->right);
		sums[1] = sum_difference(s->bottom, -s->top);
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

/* Sets zz / dz = f/(f-n) and tz / dz = -nf/(f-n) for near n and far f, or their limits
 * for an infinite f. reverse_z exchanges n and f. An open projection has depth 1/w. */
static void depth_column(const struct projection *p, struct scaled_matrix *f)
{
	double n = projection_is_open(p) ? 1 : p->near;

	if (isinf(p->far)) {
		sum_set(&f->dz, 1);
		sum_set(&f->zz, p->reverse_z ? 0 : 1);
		sum_set(&f->tz, p->reverse_z ? n : -n);
	} else {
		double a = p->reverse_z ? p->far : n;
		double b = p->reverse_z ? n : p->far;

		f->dz = sum_difference(b, a);
		sum_set(&f->zz, b);
		f->tz = sum_scale(sum_of_double(-a), b);
	}
}

/* Computes the rows (x 0 0 0), (0 y 0 0), (zx zy zz 1), (0 0 tz 0). With intrinsics,
 * the rows map the canonical space of prepend_intrinsics to clip space. */
static const char *persp_matrix(const struct projection *p, const struct convention *c,
    struct scaled_matrix *f)
{
	double distance = projection_has_intrinsics(p) ? 1 :
	    p->section.edges_at > 0                    ? p->section.edges_at :
							 p->near;
	bool down = projection_has_intrinsics(p) && !c->origin_bottom_left;
	struct sum sums[2];
	const char *why = cross_section(p, distance, f, sums);

	if (why != NULL)
		return why;
	if (!(p->near < p->far))
		return "/projection/near: not less than far; near is the plane "
		       "nearer to the eye, also with \"reverse_z\": true";
	sum_set(&f->d, 1);
	depth_column(p, f);
	f->zx = sum_neg(sums[0]);
	f->zy = sum_negated_if(!down, sums[1]);
	sum_set(&f->zw, 1);
	return NULL;
}

static const char *ortho_matrix(const struct projection *p, struct scaled_matrix *f)
{
	double a = p->reverse_z ? p->far : p->near;
	double b = p->reverse_z ? p->near : p->far;
	struct sum sums[2];
	const char *why = cross_section(p, 1, f, sums);

	if (why != NULL)
		return why;
	sum_set(&f->d, 1);
	f->dz = sum_difference(b, a);
	if (sum_sign(f->dz) == 0)
		return "/projection/far: equal to near; the planes must differ";
	sum_set(&f->zz, 1);
	sum_set(&f->tz, -a);
	f->tx = sum_neg(sums[0]);
	f->ty = sum_neg(sums[1]);
	sum_set(&f->tw, 1);
	return NULL;
}

/* Computes ortho's matrix after the shear x' = x + c cos(direction) (depth - plane),
 * y' = y + c sin(direction) (depth - plane). c is cot(projector angle). */
static const char *oblique_matrix(const struct projection *p, struct scaled_matrix *f)
{
	const struct projection_shear *s = &p->shear;
	const char *why = ortho_matrix(p, f);
	struct sum cot = sum_of_double(s->kind == OBLIQUE_CABINET ? 0.5 : 1), sine,
		   cosine;

	if (why != NULL)
		return why;
	if (s->kind == OBLIQUE_ANGLE)
		cot = trig_cot(s->projector_angle, p->unit);
	trig_sin_cos(s->direction, s->direction_unit, &sine, &cosine);
	f->zx = sum_mul(sum_mul(cot, cosine), f->x);
	f->zy = sum_mul(sum_mul(cot, sine), f->y);
	f->tx = sum_sub(f->tx, sum_scale(f->zx, s->plane));
	f->ty = sum_sub(f->ty, sum_scale(f->zy, s->plane));
	return NULL;
}

static void volume_section(const struct projection *p, struct scaled_matrix *f)
{
	bool wide = p->aspect[0] >= p->aspect[1];

	f->x = f->y = sum_of_double(1);
	sum_set(&f->dx, p->volume.half_width);
	sum_set(&f->dy, p->volume.half_height);
	if (p->aspect[1] != 0)
		set_scales(p->aspect, !wide, f->x, p->volume.half_width, f);
}

/* Computes 1/z of the eye from the view angle: tan(angle/2) over the smaller of half
 * width and half height, with the sign of z_near - z_far. */
static void inverse_eye_z_of_angle(const struct projection *p, struct sum *numerator,
    struct sum *denominator)
{
	struct scaled_matrix f;

	volume_section(p, &f);
	bool tall = sum_sign(sum_minor(f.dx, f.y, f.dy, f.x)) <= 0;
	struct sum cot = trig_cot(p->volume.view_angle / 2, p->unit);

	*numerator = sum_negated_if(p->volume.z_near < p->volume.z_far,
	    tall ? f.x : f.y);
	*denominator = sum_mul(tall ? f.dx : f.dy, cot);
	if (!sum_is_exact(denominator)) {
		*numerator = sum_quotient(*numerator, *denominator);
		sum_set(denominator, 1);
	}
}

void projection_inverse_eye_z(const struct projection *p, struct sum *numerator,
    struct sum *denominator)
{
	const struct projection_volume *v = &p->volume;

	sum_set(denominator, 1);
	switch (v->eye_given_by) {
	case EYE_BY_INVERSE_Z:
		sum_set(numerator, v->inverse_eye_z);
		break;
	case EYE_BY_POINT:
		sum_set(numerator, 1);
		sum_set(denominator, v->eye[2]);
		break;
	case EYE_BY_ANGLE:
		sum_set(numerator, 0);
		if (v->view_angle > 0)
			inverse_eye_z_of_angle(p, numerator, denominator);
		break;
	}
}

static const char *const eye_plane_refusals[] = {
	[EYE_BY_INVERSE_Z] = "/projection/inverse_eye_z: the eye plane crosses "
			     "the volume; it must lie before z_near or beyond z_far",
	[EYE_BY_POINT] = "/projection/eye: its plane crosses the volume; "
			 "move it before z_near or beyond z_far",
	[EYE_BY_ANGLE] = "/projection/view_angle: the eye plane crosses the "
			 "volume; choose a smaller one, or move z_near",
};

/* Computes the rows (x 0 0 0), (0 y 0 0), (-sx x, -sy y, -wf, -qn), (0, 0, wf zn, qd).
 * x and y are those of volume_section times qd. sx and sy are x/z and y/z of the
 * volume's axis. q = qn / qd is 1/z of the eye. Up to a sign, w is wf / qd = 1 - zf q
 * at z_far, and wn / qd = 1 - zn q at z_near: their signs tell where the eye is. */
static const char *volume_matrix(const struct projection *p, struct scaled_matrix *f)
{
	const struct projection_volume *v = &p->volume;
	struct sum zn = sum_of_double(v->z_near), zf = sum_of_double(v->z_far);
	struct sum qn, qd, skew[2];

	volume_section(p, f);
	f->dz = sum_sub(zn, zf);
	if (sum_sign(f->dz) == 0)
		return "/projection/z_far: equal to z_near; the planes must differ";
	if (v->eye_given_by == EYE_BY_POINT && v->eye[2] == 0)
		return "/projection/eye: its z is 0, in the rectangle's "
		       "plane; move the eye off it";
	projection_inverse_eye_z(p, &qn, &qd);
	struct sum wf = sum_sub(qd, sum_mul(qn, zf));
	struct sum wn = sum_sub(qd, sum_mul(qn, zn));

	if (sum_sign(wf) * sum_sign(wn) <= 0)
		return eye_plane_refusals[v->eye_given_by];
	for (int k = 0; k < 2; k++)
		skew[k] = v->eye_given_by == EYE_BY_POINT ?
		    sum_of_double(v->eye[k]) :
		    sum_scale(qd, v->tan_skew[k]);
	f->zx = sum_neg(sum_mul(skew[0], f->x));
	f->zy = sum_neg(sum_mul(skew[1], f->y));
	f->x = sum_mul(qd, f->x);
	f->y = sum_mul(qd, f->y);
	f->tw = qd;
	f->d = sum_negated_if(sum_sign(wf) != sum_sign(qd), qd);
	f->zz = sum_neg(wf);
	f->zw = sum_neg(qn);
	f->tz = sum_mul(wf, zn);
	return NULL;
}

static void map_of_scaled(const struct scaled_matrix *f, struct map *r)
{
	const struct sum *z[] = { &f->zx, &f->zy, &f->zz, &f->zw },
			 *t[] = { &f->tx, &f->ty, &f->tz, &f->tw };

	map_identity(r);
	sum_copy(&r->m[0][0], &f->x);
	sum_copy(&r->m[1][1], &f->y);
	for (int k = 0; k < 4; k++) {
		sum_copy(&r->m[2][k], z[k]);
		sum_copy(&r->m[3][k], t[k]);
		sum_copy(&r->m[4][k], t[k]);
	}
	map_divide(r, f->d);
	map_divide_column(r, 0, f->dx);
	map_divide_column(r, 1, f->dy);
	map_divide_column(r, 2, f->dz);
}

/* Makes the plane of an oblique projection, or z_near of a volume, the origin's z if
 * the matrix f has errors. Row 4 of r has then none where an error of f multiplies the
 * difference from this z, which is 0 in the row. */
static void set_plane_origin(const struct projection *p, const struct scaled_matrix *f,
    struct map *r)
{
	const bool oblique = p->type == PROJECTION_OBLIQUE;
	const double z = oblique ? p->shear.plane : p->volume.z_near;
	struct scaled_matrix at = *f;
	struct map image;

	if (z == 0 ||
	    (sum_is_exact(&f->zx) && sum_is_exact(&f->zy) && sum_is_exact(&f->zz)))
		return;
	if (oblique) { /* there is no shear in the plane */
		ortho_matrix(p, &at);
		at.tz = sum_add(at.tz, sum_of_double(z));
	} else {
		at.tx = sum_scale(f->zx, z);
		at.ty = sum_scale(f->zy, z);
		sum_set(&at.tz, 0);
		at.tw = sum_add(f->tw, sum_scale(f->zw, z));
	}
	map_of_scaled(&at, &image);
	memcpy(r->m[4], image.m[3], sizeof r->m[4]);
	r->origin[2] = z;
}

/* Returns the inverse (A', 0; -B' C A', B') of the matrix of 2x2 blocks (A, 0; C, B),
 * where A = (x 0; 0 y), B = (zz zw; tz tw) and C = (zx zy; tx ty). A' and B' are the
 * inverses of A and B, and det is the determinant of B. The divisors of columns become
 * factors of the inverse's rows. */
static struct scaled_matrix scaled_inverse(const struct scaled_matrix *f)
{
	struct sum det = sum_minor(f->zz, f->tw, f->zw, f->tz);
	struct sum one = sum_of_double(1), d = f->d;

	if (!sum_is_exact(&det)) {
		d = sum_quotient(d, det);
		det = one;
	}
	struct sum x = sum_mul(f->d, det), z = sum_mul(d, f->dz);
	struct sum minus_z = sum_neg(z);

	return (struct scaled_matrix){
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

/* Returns whether a matrix that is not affine has the last row, but not the last
 * column, 0 0 1 0 or 0 0 -1 0, as transposed perspective matrices have. */
static bool is_transposed(const double m[4][4])
{
	bool row = true, column = true, affine = true;

	for (int i = 0; i < 4; i++) {
		row &= fabs(m[3][i]) == (i == 2);
		column &= fabs(m[i][3]) == (i == 2);
		affine &= m[i][3] == (i == 3);
	}
	return row && !column && !affine;
}

static const char *projection_matrix_map(const struct projection *p, bool inverse,
    struct map *r)
{
	map_of_doubles(p->matrix, r);
	if (is_transposed(p->matrix))
		return "/projection/matrix: is transposed; of 16 numbers w is "
		       "made by 4, 8, 12 and 16; of rows, by the last column "
		       "in d3d and by the last row in other conventions";
	return !inverse || map_invert(r) ?
	    NULL :
	    "/projection/matrix: singular; it can't be inverted";
}

/* Puts the affine map of P before r or, if inverse, its inverse after r. The map leads
 * from view space (d3d) to the canonical space of u w, v w, w (projection.h). In both,
 * y is upward: if device y points down, y is -Y in view space and -v w in the other. */
static const char *prepend_intrinsics(const struct projection *p,
    const struct convention *c, bool inverse, struct map *r)
{
	const double sign[4] = { 1, c->origin_bottom_left ? 1 : -1, 1, 1 };
	double m[4][4];
	struct map canonical;

	for (int i = 0; i < 4; i++) {
		for (int j = 0; j < 3; j++)
			m[i][j] = sign[i] * sign[j] * p->section.intrinsics[j][i];
		m[i][3] = i == 3;
	}
	map_of_doubles(m, &canonical);
	if (inverse && !map_invert(&canonical))
		return "/projection/intrinsics: the left three columns of P "
		       "are singular; it can't be inverted";
	map_multiply(r, &canonical, !inverse);
	map_set_origin(r, NULL);
	return NULL;
}

const char *projection_map(const struct projection *p, const struct convention *c,
    bool inverse, struct map *r)
{
	/* f is d3d, except a volume: its view space is that of c, clip y is view y */
	bool volume = p->type == PROJECTION_VOLUME;
	const struct convention given = {
		.right_handed = volume && c->right_handed,
		.view_y_down = volume && c->view_y_down,
		.ndc_y_down = volume && c->view_y_down,
	};
	struct scaled_matrix f;
	struct sum *const often_0[] = { &f.zx, &f.zy, &f.zw, &f.tx, &f.ty, &f.tw };
	const char *why = NULL;

	for (int i = 0; i < 6; i++)
		sum_set(often_0[i], 0);
	switch (p->type) {
	case PROJECTION_NONE:
		map_identity(r);
		return NULL;
	case PROJECTION_PERSP:
		why = persp_matrix(p, c, &f);
		break;
	case PROJECTION_ORTHO:
		why = ortho_matrix(p, &f);
		break;
	case PROJECTION_OBLIQUE:
		why = oblique_matrix(p, &f);
		break;
	case PROJECTION_VOLUME:
		why = volume_matrix(p, &f);
		break;
	case PROJECTION_MATRIX:
		return projection_matrix_map(p, inverse, r);
	}
	if (why != NULL)
		return why;
	if (inverse)
		f = scaled_inverse(&f);
	map_of_scaled(&f, r);
	if (!inverse && (p->type == PROJECTION_OBLIQUE || p->type == PROJECTION_VOLUME))
		set_plane_origin(p, &f, r);
	if (projection_has_intrinsics(p))
		why = prepend_intrinsics(p, c, inverse, r);
	convention_change(&given, c, false, !inverse, r);
	convention_change(&given, c, true, inverse, r);
	return why;
}

/* Returns whether a parallel projection's matrix contains a turned camera. It does if
 * depth depends on x or y, or if y depends on x. In a scene without a camera, it also
 * does if just one of x and y is mirrored, as by half a turn. */
static bool contains_camera(const struct projection *p, const struct convention *c)
{
	const double(*m)[4] = p->matrix;
	bool down = c->ndc_y_down != c->view_y_down;
	bool mirrors = ((m[0][0] < 0) != (m[1][1] < 0)) != down;

	return m[0][1] != 0 || m[0][2] != 0 || m[1][2] != 0 ||
	    (p->without_camera && mirrors);
}

/* On the z axis of ndc, 1/w is z m[2][3] + m[3][3], where m is the inverse matrix. 1/w
 * is larger at the near plane than at the far plane. */
bool projection_is_reversed(const struct projection *p, const struct convention *c)
{
	struct map back;

	if (p->type == PROJECTION_NONE)
		return convention_looks_back(c);
	if (p->type != PROJECTION_MATRIX)
		return p->reverse_z;
	map_of_doubles(p->matrix, &back);
	if (!map_invert(&back))
		return p->reverse_z;
	int grows = sum_sign(back.m[2][3]);
	int along_z = sum_sign(back.m[2][2]) * sum_sign(back.m[3][3]);

	if (grows == 0 && contains_camera(p, c))
		return false;
	return grows != 0 ? grows > 0 : along_z == (convention_looks_back(c) ? 1 : -1);
}
