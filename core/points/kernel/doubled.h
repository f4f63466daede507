/* SPDX-License-Identifier: MIT */
/* The second phase of PRECISION_EXACT, for points that exact.h leaves undecided. There
 * the bound of an error is in units of what a column could be anywhere in the block.
 * Near the view's axis, columns are far below that, and many points remain. Here a
 * column is a sum in double-double arithmetic, with a bound of the point's own terms.
 *
 * Let S be the sum of the magnitudes of a column's products, and u = 2^-53. The point's
 * differences from the origin are hi + lo, without error. A column's hi is the sum of
 * products of high parts; the errors of these operations are exact in its lo, at most
 * 6 u S, with the products of a high and a low part. Left out are products of two low
 * parts, and the errors of elements. These, and the roundings of lo and of lo plus its
 * bound, are together at most 55.5 u^2 S. `make prove` counts them.
 *
 * What underflows is at most 2^-1074, or 2^-1074 |d| for an element that multiplies d.
 * In S a magnitude counts as at least 1 / MODERATE if it is not 0, so that the bound is
 * far above that. A column above MODERATE is not sure. */

/* The bound of a column's error in units of S: over twice the errors above and those of
 * a quotient. */
#ifndef DOUBLED_BOUND
#define DOUBLED_BOUND 0x1p-98
#endif

/* A map, with a copy of its elements' magnitudes, other than 0 at
 * least 1 / MODERATE. */
struct doubled_map {
	struct kernel_map m;
	double size[4][4];
};

static struct doubled_map doubled_map_of(const struct kernel_map *m)
{
	struct doubled_map r = { .m = *m };

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			if (fabs(m->hi[i][j]) > 0)
				r.size[i][j] = fmax(fabs(m->hi[i][j]), 1 / MODERATE);
	return r;
}

/* A point's differences from the origin, their magnitudes as above, and the largest of
 * these or 1. */
struct doubled_point {
	vdd d[3];
	V size[3], farthest;
};

/* Returns column j at a point, with the bound of its error. *moderate becomes 0 or less
 * if the column could overflow. */
static inline vdd doubled_column(const struct doubled_map *map, int j, int terms,
    const struct doubled_point *p, V *bound, V *moderate)
{
	const struct kernel_map *m = &map->m;
	V hi = ALL(m->hi[3][j]), lo = ALL(m->lo[3][j]);
	V sum = ALL(map->size[3][j]);

	for (int k = 0; k < terms; k++) {
		V a = p->d[k].hi, element = ALL(m->hi[k][j]), high = a * element;
		vdd s = v_two_sum(hi, high);

		hi = s.hi;
		lo = lo + (s.lo + FMA(a, element, -high));
		lo = MADD(p->d[k].lo, element, lo);
		lo = MADD(a, ALL(m->lo[k][j]), lo);
		sum = MADD(p->size[k], ALL(map->size[k][j]), sum);
	}
	*bound = MADD(p->farthest, ALL(m->noise[j]), sum * ALL(DOUBLED_BOUND));
	*moderate = MIN(ALL(MODERATE) - sum, *moderate);
	return (vdd){ hi, lo };
}

/* Writes the image q of a point as image_of does. */
static inline void doubled_image(const struct doubled_map *m, const V in[3], V q[],
    enum kernel_kind kind)
{
	const int terms = kernel_inputs(kind);
	const bool divide = kernel_divides(kind);
	V r = ALL(1), sure = r, w_bound = ALL(0), w_sum = r, moderate = r;
	vdd w = { r, ALL(0) };
	struct doubled_point p = { .farthest = r };

	for (int k = 0; k < terms; k++) {
		p.d[k] = v_two_sum(in[k], ALL(-m->m.origin[k]));
		V size = ABS(p.d[k].hi);

		p.farthest = MAX(size, p.farthest);
		p.size[k] = IF_POSITIVE(size, MAX(size, ALL(1 / MODERATE)), ALL(0));
	}
	if (divide) {
		w = doubled_column(m, 3, terms, &p, &w_bound, &moderate);
		w_sum = w.hi + w.lo;
		r = ALL(1) / w_sum;
	}
	V behind = IF_POSITIVE(-(w_sum + w_bound), moderate, ALL(0));

	for (int j = 0; j < kernel_outputs(kind); j++) {
		V bound;
		vdd s = doubled_column(m, j, terms, &p, &bound, &moderate);

		q[j] = divide ? quotient(s, w, r, bound, w_bound, &sure) :
				round_surely(s.hi, s.lo, bound, &sure);
	}
	if (divide)
		sure = MIN(w_sum - w_bound, sure);
	q[0] = mark(q[0], MIN(moderate, sure), behind);
}

/* Writes the images of those of n points whose first coordinate is nan, as exact_images
 * does. Returns true if all first coordinates are then finite. */
static inline __attribute__((always_inline)) int
doubled_images(const struct kernel_map *m, const double *const in[3],
    double *const out[], size_t n, enum kernel_kind kind)
{
	const int terms = kernel_inputs(kind);
	const struct doubled_map map = doubled_map_of(m);
	int done = 1;

	for (size_t i = 0; i < n; i += WIDTH) {
		V p[3], q[4], x = LOAD(out[0] + i);
		V is_set = IF_EQUAL(x, x, ALL(1)), size = ALL(0);

		for (int k = 0; k < terms; k++) {
			p[k] = LOAD(in[k] + i);
			size = size + ABS(p[k]);
		}
		/* 1, or 0 if a coordinate of the point is nan */
		V whole = IF_EQUAL(size, size, ALL(1));

		if (!ALL_POSITIVE(ALL(1) - whole + is_set)) {
			doubled_image(&map, p, q, kind);
			for (int j = kernel_outputs(kind) - 1; j >= 0; j--)
				STORE(out[j] + i,
				    IF_POSITIVE(is_set, LOAD(out[j] + i), q[j]));
		}
		done &= ALL_POSITIVE(ALL(HUGE_VAL) - ABS(LOAD(out[0] + i)));
	}
	return done;
}

LOOP(KERNEL_FLAT, doubled_flat, doubled_images)
LOOP(KERNEL_AFFINE, doubled_affine, doubled_images)
LOOP(KERNEL_XYZW, doubled_xyzw, doubled_images)
LOOP(KERNEL_PROJECTIVE, doubled_projective, doubled_images)
#undef LOOP
