/* SPDX-License-Identifier: MIT */
#include "block.h"

#include <math.h>
#include <stdio.h>

void map_block(const struct transform *t, enum precision precision, struct block *b,
    size_t n)
{
	const double *const in[4] = { b->in[0], b->in[1], b->in[2], b->in[3] };
	double *const out[4] = { b->out[0], b->out[1], b->out[2], b->out[3] };

	points_map(t, precision, in, out, n);
}

void map_block_exactly(const struct transform *t, struct block *b, size_t n)
{
	map_block(t, PRECISION_EXACT, b, n);
}

void block_point(const struct block *b, size_t i, double p[4])
{
	for (int j = 0; j < 4; j++)
		p[j] = b->in[j][i];
}

static double sample_coordinate(const struct scene *s, enum space from, int j)
{
	double d = sample_number(sample_below(4) == 0 ? 6 : 1);

	if (from >= SPACE_NDC)
		d = sample_between(-1, 2);
	if (sample_below(6) == 0)
		d = rint(d);
	if (j < 3 && from <= SPACE_WORLD && s->has_camera && camera_has_eye(&s->camera))
		d += s->camera.eye[j];
	return d;
}

void sample_points(const struct scene *s, enum space from, struct block *b, size_t n)
{
	for (size_t i = 0; i < n; i++)
		for (int j = 0; j < 4; j++)
			b->in[j][i] = sample_coordinate(s, from, j);
}

void sample_round_points(struct block *b, size_t n)
{
	for (size_t i = 0; i < n; i++)
		for (int j = 0; j < 4; j++) {
			int e = 300 * ((int)sample_below(3) - 1);

			b->in[j][i] = ldexp((double)sample_below(5) - 2, e);
		}
}

static bool sample_flat_transform(struct scene *s, struct transform *t,
    struct truth *truth)
{
	enum space from = FLAT_WINDOW + sample_below(3),
		   to = FLAT_WINDOW + sample_below(3);

	if (!transform_of_scene(s, from, to, false, t, NULL))
		return false;
	truth_flat(s, from, to, truth);
	return true;
}

bool sample_transform(int e, struct scene *s, enum space *from, struct transform *t,
    struct truth *truth)
{
	enum space to = sample_below(6);
	bool homogeneous = sample_below(4) == 0;

	*from = sample_below(6);
	if (e < 0)
		sample_round_scene(s);
	else
		sample_scene(s, e);
	sample_answer(s);
	if (sample_below(8) == 0)
		return sample_flat_transform(s, t, truth);
	if (!transform_of_scene(s, *from, to, homogeneous, t, NULL))
		return false;
	truth_scene(s, *from, to, truth);
	return true;
}

/* A device point's fourth number is 1/w. In a flat space z is 0 and w is 1. */
void image_of(const struct truth *truth, const struct transform *t, const double p[4],
    struct image *r)
{
	bool given = t->in == 4 && !t->reciprocal;
	double at[4] = { p[0], p[1], t->in > 2 ? p[2] : 0, given ? p[3] : 1 };
	bool whole = true;

	*r = (struct image){ .d = sized_of(1) };
	for (int i = 0; i < t->in; i++)
		whole &= !isnan(p[i]);
	if (!whole)
		return;
	for (int j = 0; j < t->out; j++)
		r->n[j] = truth_column(truth, j, at);
	if (t->divide)
		r->d = t->reciprocal && t->out == 4 ? sized_of(p[3]) :
						      truth_column(truth, 3, at);
	int sign = truth_sign(r->d, &r->doubtful);

	r->doubtful &= truth->irrational;
	r->exists = t->front ? sign > 0 : sign != 0;
}

void judge_image(const struct image *image, int coordinates, const double *got,
    bool single, struct tally *tally)
{
	bool none = true;

	for (int j = 0; j < coordinates; j++)
		none &= isnan(got[j]);
	for (int j = 0; j < coordinates; j++)
		if (image->exists && !(image->doubtful && none))
			tally
			    ->n[truth_verdict(got[j], image->n[j], image->d, single)]++;
		else
			tally->n[none           ? NEAREST :
				image->doubtful ? WITHIN_TOLERANCE :
						  WRONG]++;
}

static double true_coordinate(const struct image *image, int j, bool single)
{
	real v = divide(image->n[j].value, image->d.value);

	return single ? (double)mpfr_get_flt(v, MPFR_RNDN) : mpfr_get_d(v, MPFR_RNDN);
}

static void judge_point(const struct truth *truth, const struct transform *t,
    const double p[4], const double got[4], bool single, struct tally *tally)
{
	struct tally here = { 0 };
	struct image image;

	image_of(truth, t, p, &image);
	judge_image(&image, t->out, got, single, &here);
	/* In a rational scene TRUTH_TOLERANCE excuses nothing, as sums of the numbers
	 * in the document are exact. */
	if (here.n[WRONG] > 0 || (here.n[WITHIN_TOLERANCE] > 0 && !truth->irrational)) {
		fprintf(stderr, "point %a %a %a %a, kernel %d:\n", p[0], p[1], p[2],
		    p[3], (int)t->kernel);
		for (int j = 0; j < t->out; j++)
			fprintf(stderr, "  expected %a, came %a\n",
			    image.exists ? true_coordinate(&image, j, single) :
					   (double)NAN,
			    got[j]);
		here.n[WRONG] += here.n[WITHIN_TOLERANCE];
		here.n[WITHIN_TOLERANCE] = 0;
	}
	for (int v = 0; v < VERDICTS; v++)
		tally->n[v] += here.n[v];
}

void judge_block(const struct truth *truth, const struct transform *t,
    const struct block *b, size_t n, bool single, struct tally *tally)
{
	for (size_t i = 0; i < n; i++) {
		int mark = real_mark();
		double p[4], got[4] = { 0 };

		block_point(b, i, p);
		for (int j = 0; j < t->out; j++) {
			got[j] = b->out[j][i];
			if (single && !isnan(got[j]))
				got[j] = (double)point_exact_float(t, p, j, got[j]);
		}
		judge_point(truth, t, p, got, single, tally);
		real_release(mark);
	}
}
