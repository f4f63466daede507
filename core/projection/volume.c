/* SPDX-License-Identifier: MIT */
#include "volume.h"

#include "projection.h"

static void volume_section(const struct projection *p, struct scaled_matrix *f)
{
	for (int k = 0; k < 2; k++)
		sum_set(&f->s[k], 1);
	sum_set(&f->d[0], p->volume.half_width);
	sum_set(&f->d[1], p->volume.half_height);
	if (p->aspect[1] != 0)
		scaled_set_sizes(p->aspect, p->aspect[0] >= p->aspect[1], sum_one,
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

/* Says that the plane through the eye of constant z is between z_near and z_far. */
static bool refuse_eye_plane(const struct projection *p, struct refusals *faults)
{
	static const struct {
		const char *where, *what, *remedy;
	} by[] = {
		[EYE_BY_INVERSE_Z] = { "/projection/inverse_eye_z",
		    "the eye plane crosses the volume",
		    "it must lie before z_near or beyond z_far" },
		[EYE_BY_POINT] = { "/projection/eye", "its plane crosses the volume",
		    "move it before z_near or beyond z_far" },
		[EYE_BY_ANGLE] = { "/projection/view_angle",
		    "the eye plane crosses the volume",
		    "choose a smaller one, or move z_near" },
	};
	const unsigned k = p->volume.eye_given_by;

	return refuse(faults, by[k].where, by[k].what, by[k].remedy);
}

/* Returns whether the numbers that say where the eye is are known. */
static bool knows_eye(const struct projection *p)
{
	const struct projection_volume *v = &p->volume;
	double all = v->z_near + v->z_far;

	if (v->eye_given_by == EYE_BY_INVERSE_Z)
		all += v->inverse_eye_z;
	if (v->eye_given_by == EYE_BY_POINT)
		all += v->eye[2];
	if (v->eye_given_by == EYE_BY_ANGLE)
		all += v->view_angle + v->half_width + v->half_height + p->aspect[0] +
		    p->aspect[1];
	return !isnan(all);
}

static bool volume_check(const struct projection *p, struct refusals *faults)
{
	const struct projection_volume *v = &p->volume;
	bool is_right = true;

	if (v->z_near == v->z_far)
		is_right = refuse(faults, "/projection/z_far", "equal to z_near",
		    "the planes must differ");
	if (v->eye_given_by == EYE_BY_POINT && v->eye[2] == 0)
		return refuse(faults, "/projection/eye",
		    "its z is 0, in the rectangle's plane", "move the eye off it");
	return is_right;
}

/* If the matrix has errors, lets images of the plane z_near have none of those that
 * multiply the difference from z_near, as that of depth does. */
static void set_near_plane(double z_near, struct scaled_matrix *f)
{
	if (z_near == 0 || scaled_is_exact(f))
		return;
	f->plane = z_near;
	for (int k = 0; k < 2; k++)
		f->in_plane[k] = sum_scale(f->z[k], z_near);
	sum_set(&f->in_plane[2], 0);
	f->in_plane[3] = sum_add(f->t[3], sum_scale(f->z[3], z_near));
}

/* Computes the matrix
 *	 x      0      0      0
 *	 0      y      0      0
 *	 -sx x  -sy y  -wf    -qn
 *	 0      0      wf zn  qd
 * x and y are s of volume_section times qd. sx and sy are x/z and y/z of the volume's
 * axis. q = qn / qd is 1/z of the eye. Up to a sign, w is wf / qd = 1 - zf q at z_far,
 * and wn / qd = 1 - zn q at z_near: their signs tell where the eye is. */
static bool volume_matrix(const struct projection *p, struct scaled_matrix *f,
    struct refusals *faults)
{
	const struct projection_volume *v = &p->volume;
	struct sum zn = sum_of_double(v->z_near), zf = sum_of_double(v->z_far);
	struct sum qn, qd;

	scaled_clear(f);
	volume_section(p, f);
	f->d[2] = sum_sub(zn, zf);
	projection_inverse_eye_z(p, &qn, &qd);
	struct sum wf = sum_sub(qd, sum_mul(qn, zf));
	struct sum wn = sum_sub(qd, sum_mul(qn, zn));

	if (sum_sign(wf) * sum_sign(wn) <= 0)
		return refuse_eye_plane(p, faults);
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
	set_near_plane(v->z_near, f);
	return true;
}

static bool volume_map(const struct projection *p, const struct convention *c,
    bool inverse, struct map *r, struct refusals *faults)
{
	struct scaled_matrix f;

	(void)c;
	if (!volume_matrix(p, &f, faults))
		return false;
	scaled_map(&f, inverse, r);
	return true;
}

static bool volume_check_map(const struct projection *p, bool inverse,
    struct refusals *faults)
{
	struct scaled_matrix f;
	struct projection known = *p;

	(void)inverse;
	if (p->volume.eye_given_by != EYE_BY_ANGLE) {
		known.volume.half_width = known.volume.half_height = 1;
		known.aspect[0] = known.aspect[1] = 1;
	}
	known.volume.tan_skew[0] = known.volume.tan_skew[1] = 0;
	known.volume.eye[0] = known.volume.eye[1] = 0;
	return !knows_eye(p) || volume_matrix(&known, &f, faults);
}

const struct projection_row projection_row_volume = { .family = FAMILY_VOLUME,
	.map = volume_map,
	.check = volume_check,
	.check_map = volume_check_map,
	.frame = FRAME_VIEW };
