#include "point.h"

#include <math.h>

/* Kernels take three coordinates to three; a sum below 2^-45 of what it could
 * be is left to point_exact, as its error is not small any more. */
static void set_kernel_map(struct transform *t)
{
	struct kernel_map *l = &t->for_kernel;
	const struct map *m = &t->map;
	double largest = 0;

	for (int i = 0; i < 3; i++)
		l->origin[i] = m->origin[i];
	for (int j = 0; j < 4; j++) {
		double most = 0;

		for (int i = 0; i < 4; i++) {
			largest = fmax(largest, m->sum[i][j]);
			l->hi[i][j] = m->m[i][j].hi;
			l->lo[i][j] = m->m[i][j].lo;
			if (i < 3)
				most = fmax(most, m->sum[i][j]);
		}
		l->image |= l->hi[3][j] != 0 && (j < t->out || t->divide);
		l->most[j] = most;
		l->sum_image[j] = m->sum[AT_ORIGIN][j];
		l->doubt[j] = 0x1p-45 * most;
		l->doubt_image[j] = 0x1p-45 * m->sum[AT_ORIGIN][j];
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

/* Where view's z alone makes w and depth, depth = a + b / w. */
static void find_depth(const struct map *projection, struct transform *t)
{
	const struct map *p = projection;
	struct kernel_map *l = &t->for_kernel;

	for (int i = 0; i < 4; i++)
		if (i != 2 &&
		    (p->m[i][3].hi != 0 || (i != 3 && p->m[i][2].hi != 0)))
			return;
	dd a = ex_div(ex_dd(p->m[2][2]), ex_dd(p->m[2][3]));

	l->a_hi = a.hi;
	l->a_lo = a.lo;
	l->b_hi = p->m[3][2].hi;
	l->b_lo = p->m[3][2].lo;
	l->doubt_depth = 0x1p-45;
	l->doubt_a = 0x1p-45 * fabs(a.hi);
	t->kind = KERNEL_DEPTH;
	l->image = l->hi[3][0] != 0 || l->hi[3][1] != 0 || l->hi[3][3] != 0;
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

struct sum map_column(const struct map *m, int j, const dd p[4])
{
	struct sum s = { { 0, 0 }, 0 };

	for (int i = 0; i < 4; i++) {
		s.value = dd_add(s.value, dd_mul(p[i], m->m[i][j]));
		s.size += fabs(p[i].hi) * m->sum[i][j];
	}
	if (fabs(s.value.hi) <= (MAP_BOUND + 13) * 0x1p-106 * s.size)
		s.value = (dd){ 0, 0 };
	return s;
}

/* What cancellation costs; a value less than least counts as that. */
static double kappa_of(struct sum s, double least)
{
	double value = fmax(fabs(s.value.hi), least);

	return value == 0 ? 1 : s.size / value;
}

/* Relative to the map's origin, and scaled down so far that no product overflows
 * whose quotient does not, but no farther: what is small must not vanish.
 * Returns the scale. */
static double relative(const struct transform *t, const double in[4], dd p[4])
{
	double largest = 1;
	int e = 0;

	for (int i = 0; i < 3; i++) {
		p[i] = i < t->in ? two_sum(in[i], -t->map.origin[i]) :
				   (dd){ 0, 0 };
		largest = fmax(largest, fabs(p[i].hi));
	}
	p[3] = (dd){ t->in == 4 && !t->reciprocal ? in[3] : 1, 0 };
	largest = fmax(largest, fabs(p[3].hi));
	frexp(largest, &e);
	e += t->exponent - 1000;
	if (e <= 0)
		return 1;
	for (int i = 0; i < 4; i++)
		p[i] = dd_scale(p[i], ldexp(1, -e));
	return ldexp(1, e);
}

static bool has_nan(const struct transform *t, const double in[4])
{
	for (int i = 0; i < t->in; i++)
		if (isnan(in[i]))
			return true;
	return false;
}

static void point_image(const struct transform *t, const double in[4],
    dd out[4], double *kappa)
{
	dd p[4];
	double scale = relative(t, in, p);
	struct sum w = { { 1 / scale, 0 }, 1 / scale };
	bool image = !has_nan(t, in);

	if (t->divide) {
		w = t->reciprocal && t->out == 4 ?
		    (struct sum){ { in[3] / scale, 0 }, fabs(in[3]) / scale } :
		    map_column(&t->map, 3, p);
		image &= t->front ? w.value.hi > 0 : w.value.hi != 0;
	}
	*kappa = 1;
	for (int j = 0; j < t->out; j++) {
		struct sum s = map_column(&t->map, j, p);
		dd q = t->divide ? dd_div(s.value, w.value) :
				   dd_scale(s.value, scale);

		out[j] = image && isfinite(q.hi) ? q : (dd){ (double)NAN, 0 };
		if (image)
			*kappa = fmax(*kappa,
			    kappa_of(w, 0) *
				kappa_of(s,
				    t->on_screen ? fabs(w.value.hi) : 0));
	}
}

void point_exact(const struct transform *t, const double in[4], double out[4],
    double *kappa)
{
	dd image[4];

	point_image(t, in, image, kappa);
	for (int j = 0; j < t->out; j++)
		out[j] = image[j].hi;
}

/* Differences, elements and products are rounded, then three sums: 6 u of size,
 * less than a 32nd of 2^-45 of it, while nothing overflows or underflows. */
bool point_estimate(const struct transform *t, const double in[3], int n,
    double value[4], double size[4])
{
	const struct kernel_map *l = &t->for_kernel;
	double x = in[0] - l->origin[0], y = in[1] - l->origin[1];
	double z = in[2] - l->origin[2], all = fabs(x) + fabs(y) + fabs(z);
	bool sure = t->in == 3;

	for (int j = 0; j < n; j++) {
		value[j] = x * l->hi[0][j] + y * l->hi[1][j] + z * l->hi[2][j] +
		    l->hi[3][j];
		size[j] = l->most[j] * all + l->sum_image[j];
		sure &= fabs(value[j]) > 0x1p-45 * size[j] &&
		    size[j] > 0x1p-900 && size[j] < 0x1p1000;
	}
	return sure;
}

bool point_is_ill(const struct transform *t, const double in[4])
{
	double value[4], size[4], image[4], kappa = 0;

	if (point_estimate(t, in, 4, value, size)) {
		double w = t->divide ? fabs(value[3]) : 1;

		for (int j = 0; j < t->out; j++)
			kappa = fmax(kappa,
			    size[j] /
				fmax(fabs(value[j]), t->on_screen ? w : 0));
		if (t->divide)
			kappa *= size[3] / w;
		if (kappa < POINTS_ILL / 2)
			return false;
	}
	point_exact(t, in, image, &kappa);
	return kappa > POINTS_ILL;
}

/* Only where the double lies midway between two floats, does rounding it again
 * not give the nearest float; what it was rounded from says which is. */
float point_single(const struct transform *t, const double in[4], int j,
    double image)
{
	float a = (float)image;
	float b = nextafterf(a, (double)a < image ? INFINITY : -INFINITY);
	dd exact[4];
	double kappa;

	if ((double)a / 2 + (double)b / 2 != image)
		return a;
	point_image(t, in, exact, &kappa);
	return exact[j].lo == 0 ?
	    a :
	    (float)nextafter(image, exact[j].lo > 0 ? HUGE_VAL : -HUGE_VAL);
}
