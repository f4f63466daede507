#include "point.h"

#include <math.h>

struct sum point_column(const struct transform *t, int j, const double in[4])
{
	double z = t->in > 2 ? in[2] : 0;

	return map_column(&t->map, j, (const double[3]){ in[0], in[1], z },
	    t->in == 4 && !t->reciprocal ? in[3] : 1);
}

static bool has_nan(const struct transform *t, const double in[4])
{
	for (int i = 0; i < t->in; i++)
		if (isnan(in[i]))
			return true;
	return false;
}

/* What the image is divided by. False where there is no image. */
static bool find_w(const struct transform *t, const double in[4], struct sum *w)
{
	*w = sum_of_double(1);
	if (has_nan(t, in))
		return false;
	if (!t->divide)
		return true;
	*w = t->reciprocal && t->out == 4 ? sum_of_double(in[3]) :
					    point_column(t, 3, in);
	return t->front ? sum_sign(*w) > 0 : sum_sign(*w) != 0;
}

void point_exact(const struct transform *t, const double in[4], double out[4])
{
	struct sum w;
	bool image = find_w(t, in, &w);

	for (int j = 0; j < t->out; j++) {
		out[j] = (double)NAN;
		if (!image)
			continue;
		struct sum q = point_column(t, j, in);
		double v = t->divide ? sum_over(q, w) : sum_double(q);

		out[j] = isfinite(v) ? v : (double)NAN;
	}
}

/* Only where the double lies midway between two floats does rounding it again not
 * give the nearest float. */
float point_single(const struct transform *t, const double in[4], int j,
    double image)
{
	float a = (float)image;
	float b = nextafterf(a, (double)a < image ? INFINITY : -INFINITY);
	struct sum w;

	if ((double)a / 2 + (double)b / 2 != image || !find_w(t, in, &w))
		return a;
	struct sum q = point_column(t, j, in);

	return t->divide ? sum_over_float(q, w) : sum_float(q);
}

/* Differences, elements and products are rounded, then three sums: 6 u of their
 * size, less than a 32nd of 2^-45 of it, while nothing overflows or underflows. */
bool point_estimate(const struct transform *t, const double in[3], int n,
    double value[4])
{
	const struct kernel_map *k = &t->for_kernel;
	double x = in[0] - k->origin[0], y = in[1] - k->origin[1];
	double z = in[2] - k->origin[2], all = fabs(x) + fabs(y) + fabs(z);
	bool sure = t->in == 3;

	for (int j = 0; j < n; j++) {
		double size = k->most[j] * all + k->image[j];

		value[j] = x * k->hi[0][j] + y * k->hi[1][j] + z * k->hi[2][j] +
		    k->hi[3][j];
		sure &= fabs(value[j]) > 0x1p-45 * size && size > 0x1p-900 &&
		    size < 0x1p1000;
	}
	return sure;
}
