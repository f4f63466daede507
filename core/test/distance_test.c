/* SPDX-License-Identifier: MIT */
/* Images on a device whose z is a distance, and images of its points, are nearest. */
#include "../points/distance.h"

#include "block.h"
#include "claims.h"

/* The true maps, and the distance as a function on view space. */
struct maps {
	enum space from, to;
	struct truth image, from_to_view, view_to_device, view_to_to;
	real distance[4];
	bool parallel;
};

static void set_maps(const struct scene *s, enum space from, enum space to,
    struct maps *m)
{
	m->from = from;
	m->to = to;
	truth_scene(s, from, to, &m->image);
	truth_scene(s, from, SPACE_VIEW, &m->from_to_view);
	truth_scene(s, SPACE_VIEW, SPACE_DEVICE, &m->view_to_device);
	truth_scene(s, SPACE_VIEW, to, &m->view_to_to);
	m->parallel = truth_distance(s, m->distance);
}

static struct sized scaled(struct sized a, real factor)
{
	return (struct sized){ mul(a.value, factor), mul(a.size, magnitude(factor)) };
}

/* Replaces z of the device image of p by p's distance, times d. In a perspective the
 * image exists only if the distance is positive. */
static void put_distance(const struct maps *m, const double p[4], struct image *image)
{
	struct sized n = sized_of(0), view;

	for (int i = 0; i < 4; i++) {
		view = truth_column(&m->from_to_view, i, p);
		n = sized_add(n, scaled(view, m->distance[i]));
	}
	image->n[2] = scaled(n, divide(image->d.value, view.value));
	image->exists &= m->parallel ||
	    truth_sign(image->n[2], NULL) * truth_sign(image->d, NULL) > 0;
}

/* Finds the image of a device point p. Its view coordinates solve X - x w = 0, Y - y w
 * = 0 and distance = z, with the columns X, Y and w of the map to the device. */
static void find_image(const struct maps *m, const double p[4], struct image *image)
{
	real a[4][4], back[4][4];

	set_identity(a);
	for (int i = 0; i < 4; i++) {
		const real *row = m->view_to_device.product.m[i];

		for (int j = 0; j < 2; j++)
			a[i][j] = sub(row[j], mul(real_of(p[j]), row[3]));
		a[i][2] = m->distance[i];
	}
	set_inverse(back, a);
	const bool seen = m->to >= SPACE_CLIP ||
	    mpfr_sgn(m->view_to_device.product.m[3][3]) > 0;

	*image = (struct image){ .d = sized_of(1),
		.exists = m->parallel ? seen : p[2] > 0 };
	for (int j = 0; j < 4; j++)
		image->n[j] = sized_of(0);
	for (int i = 0; i < 16; i++) {
		real view = add(mul(real_of(p[2]), back[2][i / 4]), back[3][i / 4]);
		struct sized *n = &image->n[i % 4];

		*n = sized_add(*n,
		    scaled(truth_element(&m->view_to_to, i / 4, i % 4), view));
	}
	/* w of clip space is that of ndc, 1, if it is constant */
	if (m->to == SPACE_NDC || (m->to == SPACE_CLIP && m->parallel))
		image->d = image->n[3];
}

static void judge_distances(const struct maps *m, const struct transform *t,
    const struct block *b, struct tally *tally)
{
	for (size_t i = 0; i < POINTS; i++) {
		const int mark = real_mark();
		const size_t wrong = tally->n[WRONG];
		double p[4] = { b->in[0][i], b->in[1][i], b->in[2][i],
			t->in == 4 ? b->in[3][i] : 1 };
		const double got[4] = { b->out[0][i], b->out[1][i], b->out[2][i],
			b->out[3][i] };
		struct image image;

		if (m->from == SPACE_DEVICE) {
			find_image(m, p, &image);
		} else {
			image_of(&m->image, t, p, &image);
			put_distance(m, p, &image);
		}
		judge_image(&image, t->out, got, false, tally);
		if (tally->n[WRONG] > wrong)
			fail_msg("from %d to %d, point %zu, %a %a %a %a: came %a %a %a",
			    (int)m->from, (int)m->to, i, p[0], p[1], p[2], p[3], got[0],
			    got[1], got[2]);
		real_release(mark);
	}
}

static void distances_are_nearest(void **state)
{
	static struct block b;
	static struct transform t;
	static struct maps maps;
	struct tally tally = { 0 };
	int directions[2] = { 0 };
	struct scene s;

	(void)state;
	SAMPLES(k, 400) {
		const enum space other = sample_below(5);
		const bool back = k % 2;
		const int mark = real_mark();

		if (k % 3 == 0)
			sample_round_scene(&s);
		else
			sample_scene(&s, k % 3 == 1 ? 0 : 3);
		sample_answer(&s);
		s.has_viewport = s.viewport.distance = true;
		const enum space from = back ? SPACE_DEVICE : other;
		const enum space to = back ? other : SPACE_DEVICE;

		if (!distance_transform(&s, from, to, &t, NULL))
			continue;
		sample_points(&s, from, &b, POINTS);
		map_block_exactly(&t, &b, POINTS);
		set_maps(&s, from, to, &maps);
		judge_distances(&maps, &t, &b, &tally);
		directions[back]++;
		real_release(mark);
	}
	print_message("%d scenes to the device, %d back: %zu numbers, %zu within the "
		      "tolerance\n",
	    directions[0], directions[1], tally.n[NEAREST], tally.n[WITHIN_TOLERANCE]);
	assert_true(directions[0] > 100 && directions[1] > 100);
	assert_true(tally.n[WITHIN_TOLERANCE] <= tally.n[NEAREST] / 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(distances_are_nearest),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
