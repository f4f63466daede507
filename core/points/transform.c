/* SPDX-License-Identifier: MIT */
#include "transform.h"

#include <limits.h>
#include <math.h>
#include <string.h>

static void set_column(const struct transform *t, int j, struct kernel_map *k)
{
	k->slope[j] = k->noise[j] = 0;
	for (int i = 0; i < 4; i++) {
		struct sum a = map_element(&t->map, i < 3 ? i : 4, j);
		dd e = sum_dd(a);

		/* an element that underflows becomes 2^-1074 or -2^-1074 */
		if (e.hi == 0)
			e = (dd){ sum_sign(a) * 0x1p-1074, 0 };
		k->hi_is_exact[i][j] = sum_is_exact(&a) && e.lo == 0 &&
		    sum_compare(a, sum_of_double(e.hi)) == 0;
		k->hi[i][j] = e.hi;
		k->lo[i][j] = e.lo;
		k->noise[j] += 2 * sum_error(&a);
		if (i < 3)
			k->slope[j] = fmax(k->slope[j], fabs(e.hi));
	}
	k->offset[j] = fabs(k->hi[3][j]);
	k->least_noise[j] = sum_least_error(&t->map.m[4][j], &t->map.divisor);
}

/* Makes exact images those of the map m. */
static void set_relative_map(struct transform *t, const struct map *m)
{
	bool from_zero = false;

	for (int j = 0; j < 4; j++)
		from_zero |= m->m[3][j].error < m->m[4][j].error;
	for (int i = 0; i < 16; i++)
		sum_copy(&t->relative[i / 4][i % 4],
		    &m->m[i < 12 || from_zero ? i / 4 : 4][i % 4]);
	for (int i = 0; i < 3; i++)
		t->origin[i] = from_zero ? 0 : m->origin[i];
}

static void prepare_kernel(struct transform *t)
{
	struct kernel_map *k = &t->for_kernel;

	memcpy(k->origin, t->map.origin, sizeof k->origin);
	k->a = k->b = 0;
	for (int j = 0; j < 4; j++)
		set_column(t, j, k);
}

void transform_prepare(struct transform *t)
{
	t->staged = false;
	t->distance = DISTANCE_NONE;
	set_relative_map(t, &t->map);
	prepare_kernel(t);
}

/* Returns whether exact images by the map need at most EX_WORDS words. Two products
 * must be exact: a column times a point's difference from the origin, a multiple of
 * 2^-1074; and the divisor times the midpoint of two doubles. `room` is the number of
 * words that the column or the divisor may have. */
static bool map_leaves_room(const struct map *m)
{
	double most = SCENE_MAGNITUDE_MAX;
	int e;

	for (int k = 0; k < 3; k++)
		most = fmax(most, fabs(m->origin[k]));
	frexp(most, &e);
	int room = EX_WORDS - ((e + 1 + 1074) / 64 + 5);
	bool fits = m->divisor.value.n <= room;

	for (int j = 0; j < 4; j++) {
		int low = INT_MAX, high = INT_MIN;

		for (int i = 0; i < 5; i++) {
			const ex *a = &m->m[i][j].value;

			if (a->n > 0 && a->e < low)
				low = a->e;
			if (a->n > 0 && a->e + a->n > high)
				high = a->e + a->n;
		}
		fits &= low > high || high - low <= room;
	}
	return fits;
}

bool transform_check(const struct scene *s, const struct transform *t,
    struct refusals *faults)
{
	return (map_leaves_room(&t->map) && !ex_has_overflowed()) ||
	    scene_refuse_too_wide(s, t->kernel == KERNEL_FLAT, faults);
}

/* Stages the exact images of a transform if the map from view space has elements with
 * errors. The member map is still the map to view space. */
static void transform_stage(struct transform *t)
{
	bool exact = true;

	for (int i = 0; i < 16; i++)
		exact &= sum_is_exact(&t->from_view.m[i / 4][i % 4]);
	t->staged = !exact && map_leaves_room(&t->map);
	if (t->staged)
		set_relative_map(t, &t->map);
}

static void set_kind(struct transform *t, enum space from, enum space to,
    bool homogeneous)
{
	const bool flat = space_is_flat(from);

	t->reciprocal = homogeneous && from == SPACE_DEVICE;
	t->in = flat ? 2 : from == SPACE_CLIP || t->reciprocal ? 4 : 3;
	t->out = flat ? 2 : to == SPACE_CLIP || (homogeneous && !t->reciprocal) ? 4 : 3;
	if (from == SPACE_CLIP) /* origin 0, as w may differ from 1 */
		map_set_origin(&t->map, NULL);
	t->divide = t->reciprocal ||
	    (t->out == 3 && (from == SPACE_CLIP || !map_is_affine(&t->map)));
	t->front = !t->reciprocal &&
	    (from != SPACE_CLIP || to == SPACE_NDC || to == SPACE_DEVICE);
	t->kernel = flat ? KERNEL_FLAT :
	    t->in != 3   ? KERNEL_NONE :
	    t->divide    ? KERNEL_PROJECTIVE :
	    t->out == 4  ? KERNEL_XYZW :
			   KERNEL_AFFINE;
}

void transform_init(struct transform *t, enum space from, enum space to,
    bool homogeneous)
{
	set_kind(t, from, to, homogeneous);
	transform_prepare(t);
}

/* Chooses KERNEL_DEPTH if w and depth depend on z of view space only, so that depth is
 * a + b / w. `projection` is the map from view space to the space of the images. */
static void choose_depth_kernel(const struct map *projection, struct transform *t)
{
	const struct sum(*m)[4] = projection->m;
	struct kernel_map *k = &t->for_kernel;

	for (int i = 0; i < 4; i++)
		if (i != 2 &&
		    (sum_sign(m[i][3]) != 0 || (i != 3 && sum_sign(m[i][2]) != 0)))
			return;
	k->a = sum_dd(sum_quotient(m[2][2], m[2][3])).hi;
	k->b = sum_dd(map_element(projection, 3, 2)).hi;
	t->kernel = KERNEL_DEPTH;
}

bool transform_by_view(const struct scene *s, enum space from, enum space to,
    bool homogeneous, struct transform *t, struct refusals *faults)
{
	map_find_origin(&t->map);
	transform_stage(t);
	map_multiply(&t->map, &t->from_view, false);
	if (!scene_map_refuse_range(s, false, &t->map, faults))
		return false;
	t->distance = DISTANCE_NONE;
	set_kind(t, from, to, homogeneous);
	if (!t->staged)
		set_relative_map(t, &t->map);
	prepare_kernel(t);
	return true;
}

/* Computes the member map, or the factors map and from_view of a map by view space. */
static bool set_maps(const struct scene *s, enum space from, enum space to,
    bool by_view, struct transform *t, struct refusals *faults)
{
	if (!by_view)
		return scene_map(s, from, to, &t->map, faults);
	return scene_map_factor(s, from, SPACE_VIEW, &t->map, faults) &&
	    scene_map_factor(s, SPACE_VIEW, to, &t->from_view, faults);
}

bool transform_of_matrix(const struct scene *s, enum space from, enum space to,
    struct transform *t, struct refusals *faults)
{
	const bool flat = space_is_flat(from);
	const bool by_view = from <= SPACE_VIEW && to > SPACE_VIEW;

	if (!set_maps(s, from, to, by_view, t, faults))
		return false;
	t->in = t->out = flat ? 2 : 3;
	t->kernel = flat ? KERNEL_FLAT : KERNEL_NONE;
	if (by_view) {
		map_multiply(&t->map, &t->from_view, false);
		if (!scene_map_refuse_range(s, flat, &t->map, faults))
			return false;
	}
	return transform_check(s, t, faults);
}

bool transform_of_scene(const struct scene *s, enum space from, enum space to,
    bool homogeneous, struct transform *t, struct refusals *faults)
{
	bool by_view = from <= SPACE_VIEW && to > SPACE_VIEW;

	if (!set_maps(s, from, to, by_view, t, faults) ||
	    (by_view && !transform_by_view(s, from, to, homogeneous, t, faults)))
		return false;
	if (from <= SPACE_VIEW && to <= SPACE_VIEW)
		map_find_origin(&t->map);
	if (!by_view)
		transform_init(t, from, to, homogeneous);
	else if (t->kernel == KERNEL_PROJECTIVE && map_is_finite(&t->from_view))
		choose_depth_kernel(&t->from_view, t);
	return transform_check(s, t, faults);
}

bool transform_of_directions(const struct scene *s, enum space from, enum space to,
    struct transform *t, struct refusals *faults)
{
	struct map *m = &t->map;

	if (!scene_map_factor(s, from, to, m, faults))
		return false;
	for (int j = 0; j < 3; j++)
		sum_set(&m->m[3][j], 0);
	map_set_origin(m, NULL);
	if (!scene_map_refuse_range(s, false, m, faults))
		return false;
	transform_init(t, from, to, false);
	return transform_check(s, t, faults);
}
