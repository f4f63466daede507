#include "transform.h"

#include <math.h>

/* Kernels take three coordinates to three. A sum that cancels below 2^-45 of
 * what it could be is left to point_exact: its error may show in the result. */
static void set_kernel_map(struct transform *t)
{
	struct kernel_map *k = &t->for_kernel;
	const struct map *m = &t->map;
	double largest = 0;

	for (int i = 0; i < 3; i++)
		k->origin[i] = m->origin[i];
	for (int j = 0; j < 4; j++) {
		double most = 0;

		for (int i = 0; i < 4; i++) {
			largest = fmax(largest, m->sum[i][j]);
			k->hi[i][j] = m->m[i][j].hi;
			k->lo[i][j] = m->m[i][j].lo;
			if (i < 3)
				most = fmax(most, m->sum[i][j]);
		}
		k->image |= k->hi[3][j] != 0 && (j < t->out || t->divide);
		k->most[j] = most;
		k->sum_image[j] = m->sum[AT_ORIGIN][j];
		k->doubt[j] = 0x1p-45 * most;
		k->doubt_image[j] = 0x1p-45 * m->sum[AT_ORIGIN][j];
	}
	frexp(largest, &t->exponent);
}

struct transform transform_of(const struct map *map, enum space from,
    enum space to, bool homogeneous)
{
	struct transform t = { .map = *map, .in = 3, .out = 3 };
	bool onto_screen = to == SPACE_NDC || to == SPACE_DEVICE;

	t.reciprocal = homogeneous && from == SPACE_DEVICE;
	if (from == SPACE_CLIP || t.reciprocal)
		t.in = 4;
	if (to == SPACE_CLIP || (homogeneous && !t.reciprocal))
		t.out = 4;
	if (from == SPACE_CLIP)
		map_about_zero(&t.map);
	t.divide = t.reciprocal ||
	    (t.out == 3 && (from == SPACE_CLIP || !map_is_affine(map)));
	t.front = !t.reciprocal && (from != SPACE_CLIP || onto_screen);
	t.on_screen = onto_screen && t.out == 3;
	t.kind = t.in != 3 || t.out != 3 ? KERNEL_NONE :
	    t.divide                     ? KERNEL_PROJECTIVE :
					   KERNEL_AFFINE;
	set_kernel_map(&t);
	return t;
}

/* Where view z alone determines w and depth, depth = a + b / w. */
static void find_depth(const struct map *projection, struct transform *t)
{
	const struct map *p = projection;
	struct kernel_map *k = &t->for_kernel;

	for (int i = 0; i < 4; i++)
		if (i != 2 &&
		    (p->m[i][3].hi != 0 || (i != 3 && p->m[i][2].hi != 0)))
			return;
	dd a = ex_div(ex_dd(p->m[2][2]), ex_dd(p->m[2][3]));

	k->a_hi = a.hi;
	k->a_lo = a.lo;
	k->b_hi = p->m[3][2].hi;
	k->b_lo = p->m[3][2].lo;
	k->doubt_depth = 0x1p-45;
	k->doubt_a = 0x1p-45 * fabs(a.hi);
	t->kind = KERNEL_DEPTH;
	k->image = k->hi[3][0] != 0 || k->hi[3][1] != 0 || k->hi[3][3] != 0;
}

const char *scene_transform(const struct scene *s, enum space from,
    enum space to, bool homogeneous, struct transform *t)
{
	struct map map, projection;
	const char *why = scene_map(s, from, to, &map);

	if (why != NULL)
		return why;
	*t = transform_of(&map, from, to, homogeneous);
	if (t->kind == KERNEL_PROJECTIVE && from <= SPACE_VIEW &&
	    (why = scene_map(s, SPACE_VIEW, to, &projection)) == NULL)
		find_depth(&projection, t);
	return why;
}

const char *flat_transform(const struct scene *s, enum flat from, enum flat to,
    struct transform *t)
{
	*t = (struct transform){ .in = 2, .out = 2, .kind = KERNEL_FLAT };
	const char *why = scene_flat_map(s, from, to, &t->map);

	if (why == NULL)
		set_kernel_map(t);
	return why;
}
