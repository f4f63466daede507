/* SPDX-License-Identifier: MIT */
#include "points.h"

#include <math.h>

static const struct kernels *kernels = &kernels_baseline;

bool points_choose(const char *name)
{
	const struct kernels *found = kernels_find(name);

	if (found != NULL)
		kernels = found;
	return found != NULL;
}

const struct kernels *points_kernels(void)
{
	return kernels;
}

/* Where no kernel fits: a point with four coordinates in or out, in double or,
 * rounding each operation to float, in single. It is as this precision has it: what
 * is behind the eye there, or whose w underflows to 0, has no image. */
static double plain_rounded(double a, bool single)
{
	return single ? (double)(float)a : a;
}

static void point_plain(const struct transform *t, bool single,
    const double in[4], double out[4])
{
	double p[4] = { [3] = 1 }, q[4], w = 1;

	for (int i = 0; i < 3; i++)
		p[i] = plain_rounded(in[i] - t->for_kernel.origin[i], single);
	if (t->in == 4 && !t->reciprocal)
		p[3] = plain_rounded(in[3], single);
	for (int j = 0; j < 4; j++) {
		q[j] = 0;
		for (int i = 3; i >= 0; i--) {
			double a = plain_rounded(t->for_kernel.hi[i][j],
			    single);

			q[j] = plain_rounded(q[j] +
				plain_rounded(p[i] * a, single),
			    single);
		}
	}
	if (t->divide)
		w = t->reciprocal && t->out == 4 ?
		    plain_rounded(in[3], single) :
		    q[3];
	bool image = !t->front || w > 0;

	for (int j = 0; j < t->out; j++)
		out[j] = image ? plain_rounded(q[j] / w, single) : (double)NAN;
}

static void carry_one(const struct transform *t, enum precision precision,
    const double *const in[4], double *const out[4], size_t i)
{
	double p[4], q[4];

	for (int j = 0; j < t->in; j++)
		p[j] = in[j][i];
	if (precision == PRECISION_EXACT)
		point_exact(t, p, q);
	else
		point_plain(t, precision == PRECISION_SINGLE, p, q);
	for (int j = 0; j < t->out; j++)
		out[j][i] = q[j];
}

static void carry_exact(const struct transform *t, const double *const in[4],
    double *const out[4], size_t n)
{
	exact_kernel fast = kernels->exact[t->kind];

	if (fast != NULL && fast(&t->for_kernel, in, out, n))
		return;
	for (size_t i = 0; i < n; i++)
		if (fast == NULL || isnan(out[0][i]))
			carry_one(t, PRECISION_EXACT, in, out, i);
		else if (isinf(out[0][i]))
			for (int j = 0; j < t->out; j++)
				out[j][i] = (double)NAN;
}

/* Computes exactly those of up to RUN points that a kernel has not: of which a
 * coordinate is behind the eye in its precision, or beyond its range, or whose w has
 * underflowed there. Exact says whether they have an image. Runs are short, as threads
 * may have little stack. */
enum { RUN = 256 };

static void carry_run(const struct transform *t, bool single,
    const double *const in[4], double *const out[4], size_t n)
{
	COLUMN_ALIGNED double image[3][RUN];
	double *const to[4] = { image[0], image[1], image[2] };

	carry_exact(t, in, to, n);
	for (size_t i = 0; i < n; i++) {
		if (isfinite(out[0][i]) && isfinite(out[1][i]) &&
		    (t->out == 2 || isfinite(out[2][i])))
			continue;
		for (int j = 0; j < t->out; j++)
			out[j][i] = plain_rounded(image[j][i], single);
	}
}

static void carry_plain(const struct transform *t, enum precision precision,
    const double *const in[4], double *const out[4], size_t n)
{
	plain_kernel fast = kernels->plain[precision][t->kind];
	bool done = fast != NULL && fast(&t->for_kernel, in, out, n);

	for (size_t i = 0; i < n && fast == NULL; i++)
		carry_one(t, precision, in, out, i);
	for (size_t i = 0; i < n && fast != NULL && !done; i += RUN) {
		const double *const from[4] = { in[0] + i, in[1] + i,
			in[t->in - 1] + i };
		double *const to[4] = { out[0] + i, out[1] + i,
			out[t->out - 1] + i };

		carry_run(t, precision == PRECISION_SINGLE, from, to,
		    n - i < RUN ? n - i : RUN);
	}
}

void points_map(const struct transform *t, enum precision precision,
    const double *const given[4], double *const out[4], size_t n)
{
	/* of two coordinates a kernel multiplies the third by 0 */
	const double *const in[4] = { given[0], given[1],
		given[t->in == 2 ? 1 : 2], given[3] };

	if (precision == PRECISION_EXACT)
		carry_exact(t, in, out, n);
	else
		carry_plain(t, precision, in, out, n);
}

bool points_map_floats(const struct transform *t, const char *in, char *out,
    size_t n)
{
	float_kernel fast = kernels->floats[t->kind];

	return fast != NULL && t->in == kernel_terms(t->kind) &&
	    fast(&t->for_kernel, in, out, n);
}
