#include "points.h"

#include <math.h>
#include <string.h>

/* Kernels take three coordinates to three; a sum below 2^-45 of what it could
 * be is left to point_exact, as its error is not small any more. */
static void set_lanes(struct transform *t)
{
	struct lanes *l = &t->lanes;
	const struct map *m = &t->map;

	for (int i = 0; i < 3; i++)
		l->origin[i] = m->origin[i];
	for (int j = 0; j < 4; j++) {
		double most = 0;

		for (int i = 0; i < 4; i++) {
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
	t.divide = t.reciprocal || (t.out == 3 &&
	    (from == SPACE_CLIP || !map_is_affine(map)));
	t.front = !t.reciprocal && (from != SPACE_CLIP || onto_screen);
	t.on_screen = onto_screen && t.out == 3;
	t.body = t.in != 3 || t.out != 3 ? BODY_CAREFUL :
	    t.divide ? BODY_PROJECTIVE : BODY_AFFINE;
	set_lanes(&t);
	return t;
}

/* Where view's z alone makes w and depth, depth = a + b / w. */
static void find_depth(const struct map *projection, struct transform *t)
{
	const struct map *p = projection;
	struct lanes *l = &t->lanes;

	for (int i = 0; i < 4; i++)
		if (i != 2 && (p->m[i][3].hi != 0 ||
		    (i != 3 && p->m[i][2].hi != 0)))
			return;
	dd a = ex_div(ex_dd(p->m[2][2]), ex_dd(p->m[2][3]));

	l->a_hi = a.hi;
	l->a_lo = a.lo;
	l->b_hi = p->m[3][2].hi;
	l->b_lo = p->m[3][2].lo;
	l->doubt_depth = 0x1p-45;
	l->doubt_a = 0x1p-45 * fabs(a.hi);
	t->body = BODY_DEPTH;
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
	if (t->body == BODY_PROJECTIVE && from <= SPACE_VIEW &&
	    (why = scene_map(s, SPACE_VIEW, to, &projection)) == NULL)
		find_depth(&projection, t);
	return why;
}

const char *flat_transform(const struct scene *s, enum flat from,
    enum flat to, struct transform *t)
{
	*t = (struct transform){ .in = 2, .out = 2, .body = BODY_FLAT };
	const char *why = scene_flat_map(s, from, to, &t->map);

	if (why == NULL)
		set_lanes(t);
	return why;
}

/* A coordinate before the division, and the sum of its products' sizes. */
struct sum {
	dd value;
	double size;
};

/* Four products and sums in double-double, 13 u^2 of size; what is not larger
 * than its error bound is 0. */
static struct sum column(const struct map *m, int j, const dd p[4])
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

/* Relative to the map's origin, and scaled down where it is large, so that no
 * product overflows whose quotient does not. Returns the scale. */
static double relative(const struct transform *t, const double in[4],
    dd p[4])
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
	if (largest > 0x1p400)
		frexp(largest, &e);
	for (int i = 0; i < 4 && e > 0; i++)
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

void point_exact(const struct transform *t, const double in[4], double out[4],
    double *kappa)
{
	dd p[4];
	double scale = relative(t, in, p);
	struct sum w = { { 1 / scale, 0 }, 1 / scale };
	bool image = !has_nan(t, in);

	if (t->divide) {
		w = t->reciprocal && t->out == 4 ?
		    (struct sum){ { in[3] / scale, 0 }, fabs(in[3]) / scale } :
		    column(&t->map, 3, p);
		image &= t->front ? w.value.hi > 0 : w.value.hi != 0;
	}
	*kappa = 1;
	for (int j = 0; j < t->out; j++) {
		struct sum s = column(&t->map, j, p);
		double q = s.value.hi;

		if (t->divide)
			q = dd_div(s.value, w.value).hi;
		else
			q *= scale;
		out[j] = image && isfinite(q) ? q : (double)NAN;
		if (image)
			*kappa = fmax(*kappa, kappa_of(w, 0) * kappa_of(s,
			    t->on_screen ? fabs(w.value.hi) : 0));
	}
}

static const struct kernels *kernels = &kernels_baseline;

bool points_choose(const char *name)
{
	const struct kernels *found = kernels_find(name);

	if (found != NULL)
		kernels = found;
	return found != NULL;
}

static void carry_exact(const struct transform *t, const double *const in[4],
    double *const out[4], size_t n)
{
	exact_kernel *fast = kernels->exact[t->body];

	if (fast != NULL && fast(&t->lanes, in, out, n))
		return;
	for (size_t i = 0; i < n; i++) {
		double p[4], q[4], kappa;

		if (fast != NULL && !isnan(out[0][i]))
			continue;
		for (int j = 0; j < t->in; j++)
			p[j] = in[j][i];
		point_exact(t, p, q, &kappa);
		for (int j = 0; j < t->out; j++)
			out[j][i] = q[j];
	}
}

/* Where no kernel fits: a point with four coordinates in or out, in double or,
 * rounding each operation to float, in single. */
static double rounded(double a, bool single)
{
	return single ? (double)(float)a : a;
}

static void point_plain(const struct transform *t, bool single,
    const double in[4], double out[4])
{
	double p[4] = { 0, 0, 0, 1 }, q[4], w = 1;

	for (int i = 0; i < t->in && i < 3; i++)
		p[i] = rounded(in[i] - t->map.origin[i], single);
	if (t->in == 4 && !t->reciprocal)
		p[3] = rounded(in[3], single);
	for (int j = 0; j < 4; j++) {
		q[j] = 0;
		for (int i = 3; i >= 0; i--) {
			double a = rounded(t->map.m[i][j].hi, single);

			q[j] = rounded(q[j] + rounded(p[i] * a, single),
			    single);
		}
	}
	if (t->divide)
		w = t->reciprocal && t->out == 4 ? rounded(in[3], single) :
						   q[3];
	bool image = t->front ? w > 0 : w != 0;

	for (int j = 0; j < t->out; j++)
		out[j] = image ? rounded(q[j] / w, single) : (double)NAN;
}

static void carry_plain(const struct transform *t, enum precision precision,
    const double *const in[4], double *const out[4], size_t n)
{
	plain_kernel *fast = kernels->plain[precision][t->body];

	if (fast != NULL) {
		fast(&t->lanes, in, out, n, 0);
		return;
	}
	for (size_t i = 0; i < n; i++) {
		double p[4], q[4];

		for (int j = 0; j < t->in; j++)
			p[j] = in[j][i];
		point_plain(t, precision == PRECISION_SINGLE, p, q);
		for (int j = 0; j < t->out; j++)
			out[j][i] = q[j];
	}
}

/* Points that a precision could not be trusted with, gathered for the next. */
struct rest {
	size_t n, which[POINTS_BLOCK];
	double in[3][POINTS_BLOCK], out[3][POINTS_BLOCK];
};

static void gather(const struct transform *t, const double *const in[4],
    double *const out[4], size_t n, struct rest *r)
{
	r->n = 0;
	for (size_t i = 0; i < n; i++) {
		if (!isnan(out[0][i]))
			continue;
		r->which[r->n] = i;
		for (int j = 0; j < t->in; j++)
			r->in[j][r->n] = in[j][i];
		r->n++;
	}
}

static void carry_within(const struct transform *t, double tolerance,
    enum precision precision, const double *const in[4],
    double *const out[4], bool *single, size_t n)
{
	plain_kernel *fast = kernels->plain[precision][t->body];
	struct rest r;

	if (fast == NULL || precision == PRECISION_EXACT) {
		carry_exact(t, in, out, n);
		memset(single, 0, n);
		return;
	}
	fast(&t->lanes, in, out, n, tolerance);
	memset(single, precision == PRECISION_SINGLE, n);
	gather(t, in, out, n, &r);
	if (r.n == 0)
		return;
	const double *const in2[4] = { r.in[0], r.in[1], r.in[2] };
	double *const out2[4] = { r.out[0], r.out[1], r.out[2] };
	bool single2[POINTS_BLOCK];

	carry_within(t, tolerance, precision - 1, in2, out2, single2, r.n);
	for (size_t k = 0; k < r.n; k++) {
		for (int j = 0; j < t->out; j++)
			out[j][r.which[k]] = r.out[j][k];
		single[r.which[k]] = single2[k];
	}
}

void points_carry(const struct transform *t, const struct effort *e,
    const double *const in[4], double *const out[4], bool *single, size_t n)
{
	if (e->tolerance > 0) {
		carry_within(t, e->tolerance, PRECISION_SINGLE, in, out,
		    single, n);
		return;
	}
	memset(single, e->precision == PRECISION_SINGLE, n);
	if (e->precision == PRECISION_EXACT)
		carry_exact(t, in, out, n);
	else
		carry_plain(t, e->precision, in, out, n);
}
