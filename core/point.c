#include "point.h"

#include <math.h>

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
