/* SPDX-License-Identifier: MIT */
#include "projection.h"

#include <string.h>

/* The matrix of a projection that is given by parameters:
 *	 s0  0   0   0
 *	 0   s1  0   0
 *	 z0  z1  z2  z3
 *	 t0  t1  t2  t3
 * Its columns are divided by d0, d1, d2 and 1, and the whole matrix by `divisor`. Columns
 * 2 and 3, and the divisor, are exact unless the projection is a volume with a view angle. */
struct scaled_matrix {
	struct sum s[2], z[4], t[4], d[3], divisor;
};

/* Sets s[k] / d[k] to scale / divisor, and the other such quotient so that s[1] / d[1]
 * is aspect[0] / aspect[1] times s[0] / d[0]. */
static void set_scales(const double aspect[2], int k, struct sum scale, double divisor,
    struct scaled_matrix *f)
{
	sum_copy(&f->s[k], &scale);
	sum_set(&f->d[k], divisor);
	f->s[!k] = sum_scale(scale, aspect[k]);
	f->d[!k] = sum_scale(f->d[k], aspect[!k]);
}

/* Computes scale = 2, size = r - l and edge_sum = l + r, each times cos a cos b, for
 * the edges l = tan a and r = tan b at distance 1 of the two angles a and b. */
static void tangents(const double angle[2], enum angle_unit unit, struct sum *scale,
    struct sum *size, struct sum *edge_sum)
{
	struct sum sa, ca, sb, cb;

	trig_sin_cos(angle[0], unit, &sa, &ca);
	trig_sin_cos(angle[1], unit, &sb, &cb);
	struct sum left = sum_mul(sa, cb), right = sum_mul(sb, ca);

	*scale = sum_scale(sum_mul(ca, cb), 2);
	*size = sum_sub(right, left);
	*edge_sum = sum_add(left, right);
}

/* Sets s[0] / d[0] = 2 d / (r - l) and sums[0] / d[0] = (l + r) / (r - l), where l and r
 * are the left and right edge at distance d. Sets s[1], d[1] and sums[1] likewise. */
static const char *cross_section(const struct projection *p, double d,
    struct scaled_matrix *f, struct sum sums[2])
{
	const struct projection_section *s = &p->section;
	const double size[2] = { s->width, s->height };
	const bool wide = p->aspect[0] >= p->aspect[1];

	for (int k = 0; k < 2; k++) {
		sum_set(&sums[k], 0);
		sum_set(&f->s[k], 2 * d);
		sum_set(&f->d[k], size[k]);
		if (s->way == SECTION_ANGLES)
			tangents(s->angles + 2 * k, p->unit, &f->s[k], &f->d[k],
			    &sums[k]);
		if (s->way == SECTION_INTRINSICS) /* edges from 0 to the size */
			sum_copy(&sums[k], &f->d[k]);
		if (s->way != SECTION_EDGES)
			continue;
		f->d[k] = sum_difference(s->edges[2 * k + 1], s->edges[2 * k]);
		sums[k] = sum_difference(s->edges[2 * k], -s->edges[2 * k + 1]);
		if (sum_sign(f->d[k]) == 0)
			return k == 0 ?
			    "/projection/right: equal to left; the edges must differ" :
			    "/projection/top: equal to bottom; the edges must differ";
	}
	_Static_assert(SECTION_WAYS == 10, "each way is read here");
	if (s->way <= SECTION_VIEW_ANGLE)
		set_scales(p->aspect,
		    s->way == SECTION_FOVY || (s->way == SECTION_VIEW_ANGLE && wide),
		    trig_cot(s->angle / 2, p->unit), 1, f);
	if (s->way == SECTION_FIELD)
		set_scales(p->aspect, !wide, sum_one, s->field, f);
	if (s->way == SECTION_WIDTH || s->way == SECTION_HEIGHT)
		set_scales(p->aspect, s->way == SECTION_HEIGHT, f->s[0],
		    size[s->way == SECTION_HEIGHT], f);
	return NULL;
}

/* Sets z[2] / d[2] = f/(f-n) and t[2] / d[2] = -nf/(f-n) for near n and far f, or their
 * limits for an infinite f. reverse_z exchanges n and f. An open projection has depth
 * 1/w. */
static void depth_column(const struct projection *p, struct scaled_matrix *f)
{
	double n = projection_is_open(p) ? 1 : p->near;

	if (isinf(p->far)) {
		sum_set(&f->d[2], 1);
		sum_set(&f->z[2], p->reverse_z ? 0 : 1);
		sum_set(&f->t[2], p->reverse_z ? n : -n);
	} else {
		double a = p->reverse_z ? p->far : n;
		double b = p->reverse_z ? n : p->far;

		f->d[2] = sum_difference(b, a);
		sum_set(&f->z[2], b);
		f->t[2] = sum_scale(sum_of_double(-a), b);
	}
}

/* Computes the rows (s0 0 0 0), (0 s1 0 0), (z0 z1 z2 1), (0 0 t2 0). With intrinsics,
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
	depth_column(p, f);
	f->z[0] = sum_neg(sums[0]);
	f->z[1] = sum_negated_if(!down, sums[1]);
	sum_set(&f->z[3], 1);
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
	f->d[2] = sum_difference(b, a);
	if (sum_sign(f->d[2]) == 0)
		return "/projection/far: equal to near; the planes must differ";
	sum_set(&f->z[2], 1);
	sum_set(&f->t[2], -a);
	for (int k = 0; k < 2; k++)
		f->t[k] = sum_neg(sums[k]);
	sum_set(&f->t[3], 1);
	return NULL;
}

/* Computes ortho's matrix after the shear x' = x + c cos(direction) (depth - plane),
 * y' = y + c sin(direction) (depth - plane). c is cot(projector angle). */
static const char *oblique_matrix(const struct projection *p, struct scaled_matrix *f)
{
	const struct projection_shear *s = &p->shear;
	const char *why = ortho_matrix(p, f);
	struct sum cot = sum_of_double(s->kind == OBLIQUE_CABINET ? 0.5 : 1), turn[2];

	if (why != NULL)
		return why;
	if (s->kind == OBLIQUE_ANGLE)
		cot = trig_cot(s->projector_angle, p->unit);
	trig_sin_cos(s->direction, s->direction_unit, &turn[1], &turn[0]);
	for (int k = 0; k < 2; k++) {
		f->z[k] = sum_mul(sum_mul(cot, turn[k]), f->s[k]);
		f->t[k] = sum_sub(f->t[k], sum_scale(f->z[k], s->plane));
	}
	return NULL;
}

static void volume_section(const struct projection *p, struct scaled_matrix *f)
{
	for (int k = 0; k < 2; k++)
		sum_set(&f->s[k], 1);
	sum_set(&f->d[0], p->volume.half_width);
	sum_set(&f->d[1], p->volume.half_height);
	if (p->aspect[1] != 0)
		set_scales(p->aspect, p->aspect[0] >= p->aspect[1], sum_one,
		    p->volume.half_width, f);
}

/* Computes 1/z of the eye from the view angle: tan(angle/2) over the smaller of half
 * width and half height, with the sign of z_near - z_far. */
static void inverse_eye_z_of_angle(const struct projection *p, struct sum *numerator,
    struct sum *denominator)
{
	struct scaled_matrix f;

	volume_section(p, &f);
	const bool wide = sum_sign(sum_minor(f.d[0], f.s[1], f.d[1], f.s[0])) > 0;
	struct sum cot = trig_cot(p->volume.view_angle / 2, p->unit);

	*numerator = sum_negated_if(p->volume.z_near < p->volume.z_far, f.s[wide]);
	*denominator = sum_mul(f.d[wide], cot);
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
 * x and y are s of volume_section times qd. sx and sy are x/z and y/z of the
 * volume's axis. q = qn / qd is 1/z of the eye. Up to a sign, w is wf / qd = 1 - zf q
 * at z_far, and wn / qd = 1 - zn q at z_near: their signs tell where the eye is. */
static const char *volume_matrix(const struct projection *p, struct scaled_matrix *f)
{
	const struct projection_volume *v = &p->volume;
	struct sum zn = sum_of_double(v->z_near), zf = sum_of_double(v->z_far);
	struct sum qn, qd;

	volume_section(p, f);
	f->d[2] = sum_sub(zn, zf);
	if (sum_sign(f->d[2]) == 0)
		return "/projection/z_far: equal to z_near; the planes must differ";
	if (v->eye_given_by == EYE_BY_POINT && v->eye[2] == 0)
		return "/projection/eye: its z is 0, in the rectangle's "
		       "plane; move the eye off it";
	projection_inverse_eye_z(p, &qn, &qd);
	struct sum wf = sum_sub(qd, sum_mul(qn, zf));
	struct sum wn = sum_sub(qd, sum_mul(qn, zn));

	if (sum_sign(wf) * sum_sign(wn) <= 0)
		return eye_plane_refusals[v->eye_given_by];
	for (int k = 0; k < 2; k++) {
		struct sum skew = v->eye_given_by == EYE_BY_POINT ?
		    sum_of_double(v->eye[k]) :
		    sum_scale(qd, v->tan_skew[k]);

		f->z[k] = sum_neg(sum_mul(skew, f->s[k]));
		f->s[k] = sum_mul(qd, f->s[k]);
	}
	f->divisor = sum_negated_if(sum_sign(wf) != sum_sign(qd), qd);
	f->z[2] = sum_neg(wf);
	f->z[3] = sum_neg(qn);
	f->t[2] = sum_mul(wf, zn);
	sum_copy(&f->t[3], &qd);
	return NULL;
}

static void map_of_scaled(const struct scaled_matrix *f, struct map *r)
{
	map_identity(r);
	for (int k = 0; k < 2; k++)
		sum_copy(&r->m[k][k], &f->s[k]);
	for (int k = 0; k < 4; k++) {
		sum_copy(&r->m[2][k], &f->z[k]);
		sum_copy(&r->m[3][k], &f->t[k]);
		sum_copy(&r->m[4][k], &f->t[k]);
	}
	map_divide(r, f->divisor);
	for (int k = 0; k < 3; k++)
		map_divide_column(r, k, f->d[k]);
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
	    (sum_is_exact(&f->z[0]) && sum_is_exact(&f->z[1]) &&
		sum_is_exact(&f->z[2])))
		return;
	if (oblique) { /* there is no shear in the plane */
		ortho_matrix(p, &at);
		at.t[2] = sum_add(at.t[2], sum_of_double(z));
	} else {
		for (int k = 0; k < 2; k++)
			at.t[k] = sum_scale(f->z[k], z);
		sum_set(&at.t[2], 0);
		at.t[3] = sum_add(f->t[3], sum_scale(f->z[3], z));
	}
	map_of_scaled(&at, &image);
	memcpy(r->m[4], image.m[3], sizeof r->m[4]);
	r->origin[2] = z;
}

/* Writes the inverse (A', 0; -B' C A', B') of the matrix of 2x2 blocks (A, 0; C, B),
 * where A = (s0 0; 0 s1), B = (z2 z3; t2 t3) and C = (z0 z1; t0 t1). A' and B' are the
 * inverses of A and B, and det is the determinant of B. The divisors of columns become
 * factors of the inverse's rows. */
static void scaled_inverse(const struct scaled_matrix *f, struct scaled_matrix *r)
{
	const struct sum *z = f->z, *t = f->t;
	struct sum det = sum_minor(z[2], t[3], z[3], t[2]), d = f->divisor;

	if (!sum_is_exact(&det)) {
		d = sum_quotient(d, det);
		sum_set(&det, 1);
	}
	struct sum s = sum_mul(f->divisor, det), dz = sum_mul(d, f->d[2]);

	for (int k = 0; k < 2; k++) {
		r->s[k] = sum_mul(f->d[k], s);
		r->z[k] = sum_mul(dz, sum_minor(z[3], t[k], t[3], z[k]));
		r->t[k] = sum_mul(d, sum_minor(t[2], z[k], z[2], t[k]));
		sum_copy(&r->d[k], &f->s[k]);
	}
	r->z[2] = sum_mul(dz, t[3]);
	r->z[3] = sum_neg(sum_mul(dz, z[3]));
	r->t[2] = sum_neg(sum_mul(d, t[2]));
	r->t[3] = sum_mul(d, z[2]);
	sum_set(&r->d[2], 1);
	sum_copy(&r->divisor, &det);
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
	struct scaled_matrix f, back;
	const char *why = NULL;

	for (int k = 0; k < 4; k++) {
		sum_set(&f.z[k], 0);
		sum_set(&f.t[k], 0);
	}
	sum_set(&f.divisor, 1);
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
		scaled_inverse(&f, &back);
	map_of_scaled(inverse ? &back : &f, r);
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
