/* SPDX-License-Identifier: MIT */
#include "points.h"

#include <math.h>

#include "point.h"

static double rounded(double a, bool single)
{
	return single ? (double)(float)a : a;
}

/* Computes the image of a point in double or, if `single`, in single precision. Serves
 * maps that have no kernel, such as maps from or to x, y, z and w. If t->front is set,
 * a point whose computed w is not positive has no image. */
static void point_approx(const struct transform *t, bool single, const double in[4],
    double out[4])
{
	double p[4] = { [3] = 1 }, q[4], w = 1;

	for (int i = 0; i < 3; i++)
		p[i] = rounded(in[i] - t->for_kernel.origin[i], single);
	if (t->in == 4 && !t->reciprocal)
		p[3] = rounded(in[3], single);
	for (int j = 0; j < 4; j++) {
		q[j] = 0;
		for (int i = 3; i >= 0; i--) {
			double a = rounded(t->for_kernel.hi[i][j], single);

			q[j] = rounded(q[j] + rounded(p[i] * a, single), single);
		}
	}
	if (t->divide)
		w = t->reciprocal && t->out == 4 ? rounded(in[3], single) : q[3];
	bool has_image = !t->front || w > 0;

	for (int j = 0; j < t->out; j++)
		out[j] = has_image ? rounded(q[j] / w, single) : (double)NAN;
}

static void map_one(const struct transform *t, enum precision precision,
    const double *const in[4], double *const out[4], size_t i)
{
	double p[4], q[4];

	for (int j = 0; j < t->in; j++)
		p[j] = in[j][i];
	const bool single = precision == PRECISION_SINGLE;

	if (precision == PRECISION_EXACT || t->distance != DISTANCE_NONE)
		point_exact(t, p, q);
	else
		point_approx(t, single, p, q);
	for (int j = 0; j < t->out; j++)
		out[j][i] = rounded(q[j], single);
}

/* Returns whether all coordinates of image i are finite. */
static bool is_finite(const struct transform *t, double *const out[4], size_t i)
{
	return isfinite(out[0][i]) && isfinite(out[1][i]) &&
	    (t->out < 3 || isfinite(out[2][i])) && (t->out < 4 || isfinite(out[3][i]));
}

/* Computes the images one by one. Returns true if all coordinates are finite. */
static bool map_each(const struct transform *t, enum precision precision,
    const double *const in[4], double *const out[4], size_t n)
{
	bool finite = true;

	for (size_t i = 0; i < n; i++) {
		map_one(t, precision, in, out, i);
		finite &= is_finite(t, out, i);
	}
	return finite;
}

/* Computes exact images: what one loop leaves undecided is left to the next. Returns
 * true if all coordinates are finite. */
static bool map_exact(const struct transform *t, const double *const in[4],
    double *const out[4], size_t n)
{
	const struct kernels *k = kernels_chosen();
	bool finite = true;

	if (k->exact[t->kernel] == NULL)
		return map_each(t, PRECISION_EXACT, in, out, n);
	if (k->exact[t->kernel](&t->for_kernel, in, out, n) ||
	    k->doubled[t->kernel](&t->for_kernel, in, out, n))
		return true;
	for (size_t i = 0; i < n; i++) {
		if (isfinite(out[0][i]))
			continue;
		if (isnan(out[0][i]))
			map_one(t, PRECISION_EXACT, in, out, i);
		else
			for (int j = 0; j < t->out; j++)
				out[j][i] = (double)NAN;
		finite &= is_finite(t, out, i);
	}
	return finite;
}

/* Replaces images that are not finite by rounded exact images: those of points behind
 * the eye, with values out of range, or whose w underflows. */
static bool map_nonfinite(const struct transform *t, bool single,
    const double *const in[4], double *const out[4], size_t n)
{
	COLUMN_ALIGNED double image[3][POINTS_BLOCK];
	double *const to[4] = { image[0], image[1], image[2] };
	bool finite = true;

	map_exact(t, in, to, n);
	for (size_t i = 0; i < n; i++) {
		if (is_finite(t, out, i))
			continue;
		for (int j = 0; j < t->out; j++)
			out[j][i] = rounded(image[j][i], single);
		finite &= is_finite(t, out, i);
	}
	return finite;
}

bool points_map(const struct transform *t, enum precision precision,
    const double *const in[4], double *const out[4], size_t n)
{
	approx_kernel kernel = kernels_chosen()->approx[precision][t->kernel];

	if (precision == PRECISION_EXACT)
		return map_exact(t, in, out, n);
	if (kernel == NULL)
		return map_each(t, precision, in, out, n);
	return kernel(&t->for_kernel, in, out, n) ||
	    map_nonfinite(t, precision == PRECISION_SINGLE, in, out, n);
}

bool points_map_floats(const struct transform *t, const char *in, char *out, size_t n)
{
	float_rows_kernel kernel = kernels_chosen()->float_rows[t->kernel];

	return kernel != NULL && t->in == kernel_inputs(t->kernel) &&
	    kernel(&t->for_kernel, in, out, n);
}
