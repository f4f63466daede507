/* SPDX-License-Identifier: MIT */
#include "frustum.h"

#include <string.h>

#include "../points/distance.h"
#include "../points/point.h"

void frustum_limits(const struct scene *s, struct sum half[2], struct sum scale[2])
{
	double h[2] = { 1, 1 }, pixels[2] = { 1, 1 };

	if (s->has_viewport)
		viewport_limits(&s->viewport, h, pixels);
	for (int k = 0; k < 2; k++) {
		half[k] = sum_scale(sum_difference(1, 2 * s->margin), h[k]);
		sum_set(&scale[k], pixels[k]);
	}
}

/* Sets column j of r to a x + b w, if minus to -a x + b w, of columns k and 3 of m. */
static void combine_columns(struct map *r, int j, const struct map *m, bool minus,
    int k, const struct sum *a, const struct sum *b)
{
	const struct sum factor[2] = { sum_negated_if(minus, *a), *b };

	for (int i = 0; i < 5; i++)
		sum_dot(2, factor, &m->m[i][k], 3 - k, &r->m[i][j]);
}

/* Makes the planes from the map m to clip space. With half and scale of frustum_limits,
 * left is half w + scale x, and right is half w - scale x; bottom and top are the same
 * in y. Bottom and top are exchanged if ndc y points down, near and far if depth is
 * reversed. The functions of planes that do not exist are 1. */
static void planes_of_clip(const struct scene *s, const struct map *m,
    struct map *sides, struct map *ends)
{
	const struct convention *c = scene_answer_convention(s);
	bool reversed = projection_is_reversed(&s->projection, &s->convention);
	struct sum half[2], scale[2];
	struct sum low = sum_of_double(c->depth_minus_one);

	map_copy(sides, m);
	map_copy(ends, m);
	frustum_limits(s, half, scale);
	for (int k = 0; k < 4; k++) {
		bool high = (k & 1) ^ (k >= 2 && c->ndc_y_down);

		combine_columns(sides, k, m, high, k / 2, &scale[k / 2], &half[k / 2]);
	}
	combine_columns(ends, reversed, m, false, 2, &sum_one, &low);
	combine_columns(ends, !reversed, m, true, 2, &sum_one, &sum_one);
	for (int i = 0; i < 5 && projection_is_open(&s->projection); i++)
		ends->m[i][0] = ends->m[i][1] = sum_of_double(i >= 3);
	for (int i = 0; i < 5; i++)
		ends->m[i][2] = m->m[i][3];
}

bool frustum_planes(const struct scene *s, enum space from, struct map *sides,
    struct map *ends, struct refusals *faults)
{
	const bool flat = space_is_flat(from);
	struct map m;

	if (!scene_map(s, from, flat ? FLAT_NDC : SPACE_CLIP, &m, faults))
		return false;
	if (flat) {
		map_copy(sides, &m);
		for (int k = 0; k < 4; k++)
			combine_columns(sides, k, &m, k & 1, k / 2, &sum_one, &sum_one);
		return true;
	}
	planes_of_clip(s, &m, sides, ends);
	/* w is 1 in ndc and device; w of the map to view space is < 0 behind the eye */
	if (from == SPACE_NDC || from == SPACE_DEVICE) {
		if (!scene_map(s, from, SPACE_VIEW, &m, faults))
			return false;
		for (int i = 0; i < 5; i++)
			ends->m[i][2] = m.m[i][3];
	}
	return true;
}

/* From view space or a space before it, the planes are staged by way of view space. */
bool frustum_of(const struct scene *s, enum space from, bool homogeneous,
    struct frustum *f, struct refusals *faults)
{
	const bool flat = space_is_flat(from), staged = from <= SPACE_VIEW;
	const bool by_distance = from == SPACE_DEVICE && s->viewport.distance;
	struct transform *const t[] = { &f->sides, &f->ends };
	bool good = true;

	if (staged) {
		if (!scene_map_factor(s, from, SPACE_VIEW, &f->sides.map, faults) ||
		    !frustum_planes(s, SPACE_VIEW, &f->sides.from_view,
			&f->ends.from_view, faults))
			return false;
		map_copy(&f->ends.map, &f->sides.map);
	} else if (!frustum_planes(s, by_distance ? SPACE_VIEW : from, &f->sides.map,
		       &f->ends.map, faults)) {
		return false;
	}
	for (int i = 0; i < (flat ? 1 : 2) && good; i++)
		if (staged)
			good = transform_by_view(s, from, SPACE_CLIP, homogeneous, t[i],
			    faults);
		else if (by_distance)
			good = distance_by_view(s, from, SPACE_CLIP, t[i], faults);
		else
			transform_init(t[i], from, SPACE_CLIP, homogeneous);
	return good && (!ex_has_overflowed() || scene_refuse_too_wide(s, flat, faults));
}

unsigned frustum_outside(const struct frustum *f, const double in[4])
{
	bool flat = f->sides.in == 2;
	unsigned out = 0;

	for (int i = 0; i < f->sides.in; i++)
		if (isnan(in[i]))
			return OUT_NAN;
	if (!flat &&
	    (sum_sign(point_column(&f->ends, 2, in)) <= 0 ||
		(f->sides.reciprocal && !(in[3] > 0))))
		return OUT_BEHIND;
	for (int k = 0; k < (flat ? 4 : 6); k++)
		if (sum_sign(point_column(k < 4 ? &f->sides : &f->ends, k % 4, in)) < 0)
			out |= 1u << k;
	return out;
}

/* Makes the estimate (kernel.h) of the signs of a transform's columns. The error of a
 * column is at most a sum of three: ESTIMATE_BOUND times the sum of its products'
 * magnitudes, its noise (struct kernel_map), and 2^-1074 times each coordinate whose
 * element underflows. `low` excludes sums of magnitudes below 2^-899, whose products
 * could underflow; `high` excludes sums that could overflow. */
static struct estimate estimate_of(const struct transform *t, int columns)
{
	const struct kernel_map *k = &t->for_kernel;
	struct estimate e = { .low = 0, .high = (double)INFINITY };

	for (int i = 0; i < 3; i++)
		e.origin[i] = k->origin[i];
	for (int j = 0; j < columns; j++) {
		double underflow = 2 * (k->noise[j] + 0x1p-1020);

		for (int i = 0; i < 4; i++)
			e.m[i][j] = k->hi[i][j];
		e.slope = fmax(e.slope, ESTIMATE_BOUND * k->slope[j] + underflow);
		e.floor = fmax(e.floor, ESTIMATE_BOUND * k->offset[j] + underflow);
		if (!(k->offset[j] > 0x1p-899))
			e.low = fmax(e.low, 0x1p-899 / k->slope[j]);
		e.high = fmin(e.high, (0x1p999 - k->offset[j]) / k->slope[j]);
	}
	return e;
}

/* The number of points per call of the kernel; the stack holds their signs. */
enum { SIGNS_BLOCK = 256 };

void frustum_outside_all(const struct frustum *f, const double *const in[4],
    unsigned char *out, size_t n)
{
	bool flat = f->sides.in == 2, four = f->sides.in == 4;
	const bool exactly = four || f->sides.distance != DISTANCE_NONE;
	/* in 2D any column serves as z, as the map multiplies it by 0 */
	const double *z = in[flat ? 0 : 2];
	struct estimate sides = estimate_of(&f->sides, 4), ends = { 0 };
	double word[SIGNS_BLOCK];

	if (!flat)
		ends = estimate_of(&f->ends, 3);
	for (size_t i = 0; i < n; i += SIGNS_BLOCK) {
		const double *const at[4] = { in[0] + i, in[1] + i, z + i };
		size_t count = n - i < SIGNS_BLOCK ? n - i : SIGNS_BLOCK;

		memset(word, 0, count * sizeof *word);
		if (!exactly)
			kernels_chosen()->signs(&sides, 4, OUT_LEFT, at, word, count);
		if (!exactly && !flat)
			kernels_chosen()->signs(&ends, 3, OUT_NEAR, at, word, count);
		for (size_t k = 0; k < count; k++) {
			unsigned planes = (unsigned)word[k];
			const double p[4] = { at[0][k], at[1][k], at[2][k],
				four ? in[3][i + k] : 1 };

			if (exactly || planes >= SIGNS_UNSURE)
				planes = frustum_outside(f, p);
			out[i + k] = planes & OUT_BEHIND ? OUT_BEHIND :
							   (unsigned char)planes;
		}
	}
}

/* The map of a projection that is given by lengths and angles always has an inverse. */
bool frustum_refuse_singular(const struct scene *s, struct refusals *faults)
{
	const struct projection *p = &s->projection;
	struct map m;

	return (projection_family(p) != FAMILY_FIXED &&
		   !projection_has_intrinsics(p)) ||
	    scene_map(s, SPACE_CLIP, SPACE_VIEW, &m, faults);
}
