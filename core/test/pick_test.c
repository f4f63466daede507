/* SPDX-License-Identifier: MIT */
/* The points within a radius, their distances and their order, against MPFR. */
#include "../derive/pick.h"

#include "claims.h"
#include "block.h"

/* The distance of model points from the near plane along the gaze, in the convention
 * of the document: the difference of a column of view and near, divided by divisor. */
struct distance {
	struct truth view;
	int column; /* 2, or the column of clip w if the gaze is not along z */
	struct sized near, divisor;
	bool upward;
};

/* Sets the distance for a scene without a matrix: the near plane of a matrix is not a
 * member of the document. */
static void distance_of(const struct scene *s, struct distance *d)
{
	const struct projection *p = &s->projection;
	double gaze = truth_gaze_sign(&s->convention);

	struct scene own = *s;

	own.answer = NULL;
	truth_scene(&own, SPACE_MODEL, SPACE_VIEW, &d->view);
	d->column = 2;
	d->divisor = sized_of(1);
	if (projection_is_tilted(p)) {
		truth_scene(&own, SPACE_MODEL, SPACE_CLIP, &d->view);
		d->column = 3;
		d->near = sized_of(p->near);
		d->upward = p->far > p->near;
		d->divisor = truth_w_gradient(p);
		return;
	}
	/* the constant term of w, of intrinsics */
	double w = projection_has_intrinsics(p) ? p->section.intrinsics[2][3] : 0;

	switch (projection_family(p)) {
	case FAMILY_PERSP:
	case FAMILY_PARALLEL:
	case FAMILY_FIXED:
		d->near = sized_sub(sized_of(gaze * p->near), sized_of(gaze * w));
		d->upward = (p->far > p->near) == (gaze > 0);
		break;
	case FAMILY_VOLUME:
		d->near = sized_of(p->volume.z_near);
		d->upward = p->volume.z_far > p->volume.z_near;
		break;
	}
}

static struct sized distance_at(const struct distance *d, const double p[4])
{
	struct sized z = truth_column(&d->view, d->column, p);

	return d->upward ? sized_sub(z, d->near) : sized_sub(d->near, z);
}

static bool sample_picker(int e, struct scene *s, struct transform *t, struct picker *k)
{
	sample_scene(s, e);
	sample_answer(s);
	if (s->projection.type == PROJECTION_MATRIX ||
	    !transform_of_scene(s, SPACE_MODEL, SPACE_DEVICE, false, t, NULL) ||
	    !picker_of(s, t, k, NULL))
		return false;
	return true;
}

static void check_distances(const struct picker *k, const struct distance *d,
    const struct block *b, int verdicts[VERDICTS])
{
	for (size_t i = 0; i < POINTS; i++) {
		double p[4] = { b->in[0][i], b->in[1][i], b->in[2][i], 1 };
		double q[4] = { b->in[0][0], b->in[1][0], b->in[2][0], 1 };
		int mark = real_mark();
		struct sized at = distance_at(d, p);
		bool doubtful;
		int order;

		verdicts[truth_verdict(pick_distance(k, p), at, d->divisor, false)]++;
		order = truth_sign(sized_sub(at, distance_at(d, q)), &doubtful);
		if (order == 0 || !doubtful)
			assert_int_equal(pick_compare(k, p, q), order);
		real_release(mark);
	}
}

/* Returns whether the image, n / d, is within the radius of at, the picked position. */
static bool is_within(const struct picker *k, const struct image *image, bool *doubtful)
{
	struct sized d = sized_mul(sized_of(k->radius), image->d);

	d = sized_mul(d, sized_sub(sized_of(0), d));
	for (int j = 0; j < 2; j++) {
		struct sized off = sized_sub(image->n[j],
		    sized_mul(sized_of(k->at[j]), image->d));

		d = sized_add(d, sized_mul(off, off));
	}
	return truth_sign(d, doubtful) <= 0;
}

/* Checks points around a point on the edge of the circle. */
static void check_radius(struct picker *k, const struct truth *truth, struct block *b,
    size_t n[2])
{
	map_block_exactly(k->to_device, b, POINTS);
	k->at[0] = b->out[0][0];
	k->at[1] = b->out[1][0];
	k->radius = hypot(b->out[0][1] - k->at[0], b->out[1][1] - k->at[1]);
	if (sample_below(2))
		k->radius = nextafter(k->radius, 0);
	if (sample_below(4) == 0)
		k->radius = 0;
	if (!(k->radius <= SCENE_MAGNITUDE_MAX) || !isfinite(k->at[0]))
		return;
	for (size_t i = 0; i < POINTS; i++) {
		int mark = real_mark();
		struct image image;
		double p[4], device[2] = { b->out[0][i], b->out[1][i] };
		bool doubtful;

		block_point(b, i, p);
		image_of(truth, k->to_device, p, &image);
		if (image.exists && !isnan(device[0])) {
			bool within = is_within(k, &image, &doubtful);

			n[within]++;
			if (!doubtful)
				assert_int_equal(pick_is_within(k, p, device), within);
		}
		real_release(mark);
	}
}

static void random_scenes(void **state)
{
	static struct block b;
	static struct transform t;
	static struct picker k;
	struct scene s;
	int verdicts[VERDICTS] = { 0 };
	size_t n[2] = { 0, 0 };

	(void)state;
	kernels_choose(NULL);
	SAMPLES(i, 500) {
		struct distance d = { 0 };
		struct truth truth = { 0 };
		int mark = real_mark();

		if (!sample_picker(i % 3 * 4, &s, &t, &k))
			continue;
		distance_of(&s, &d);
		truth_scene(&s, SPACE_MODEL, SPACE_DEVICE, &truth);
		sample_points(&s, SPACE_MODEL, &b, POINTS);
		check_distances(&k, &d, &b, verdicts);
		check_radius(&k, &truth, &b, n);
		real_release(mark);
	}
	print_message("%d distances, %d within the tolerance; %zu points within, "
		      "%zu not\n",
	    verdicts[NEAREST] + verdicts[WITHIN_TOLERANCE], verdicts[WITHIN_TOLERANCE],
	    n[1], n[0]);
	assert_int_equal(verdicts[WRONG], 0);
	assert_true(verdicts[NEAREST] > 5000 && verdicts[WITHIN_TOLERANCE] < 10);
	assert_true(n[0] > 1000 && n[1] > 300);
}

/* Device x and y are equal to model x and y. The circle goes through points with whole
 * coordinates. */
static void tiny_distances_are_exact(void **state)
{
	struct scene s = { .has_viewport = true,
		.convention = { .origin_bottom_left = true },
		.viewport = { .x = -1, .y = -1, .width = 2, .height = 2, .max_z = 1 } };
	struct transform t;
	struct picker k;

	(void)state;
	assert_true(transform_of_scene(&s, SPACE_MODEL, SPACE_DEVICE, false, &t, NULL));
	assert_true(picker_of(&s, &t, &k, NULL));
	k.at[0] = k.at[1] = 0;
	for (int e = 1; e < 1000; e++) {
		double tiny = ldexp(1, -e), over = 1 + tiny, y = tiny;
		double p[4] = { 1, 0, 0, 1 }, device[2] = { 1, 0 };

		k.radius = 1;
		assert_true(pick_is_within(&k, p, device));
		p[1] = device[1] = y;
		assert_false(pick_is_within(&k, p, device));
		p[0] = device[0] = over;
		p[1] = device[1] = 0;
		assert_int_equal(pick_is_within(&k, p, device), over == 1);
	}
	k.radius = 5 * 0x1p40;
	assert_true(pick_is_within(&k, (double[]){ 3 * 0x1p40, 4 * 0x1p40, 0, 1 },
	    (double[]){ 3 * 0x1p40, 4 * 0x1p40 }));
	k.radius = nextafter(k.radius, 0);
	assert_false(pick_is_within(&k, (double[]){ 3 * 0x1p40, 4 * 0x1p40, 0, 1 },
	    (double[]){ 3 * 0x1p40, 4 * 0x1p40 }));
}

/* 1 + 2^-60 on the device is not within 1 of 0, though its nearest double is. */
static void what_rounds_onto_the_edge_is_outside(void **state)
{
	struct scene s = { .has_viewport = true,
		.has_world = true,
		.convention = { .origin_bottom_left = true },
		.world.matrix = { { 1 }, { 0x1p-60, 1 }, { 0, 0, 1 }, { 0, 0, 0, 1 } },
		.viewport = { .x = -1, .y = -1, .width = 2, .height = 2, .max_z = 1 } };
	struct transform t;
	struct picker k;
	const double p[4] = { 1, 1, 0, 1 };
	double device[4];

	(void)state;
	assert_true(transform_of_scene(&s, SPACE_MODEL, SPACE_DEVICE, false, &t, NULL));
	assert_true(picker_of(&s, &t, &k, NULL));
	point_exact(&t, p, device);
	assert_number(device[0], 1);
	assert_number(device[1], 1);
	k.at[0] = 0;
	k.at[1] = 1;
	k.radius = 1;
	assert_false(pick_is_within(&k, p, device));
	k.radius = nextafter(1, 2);
	assert_true(pick_is_within(&k, p, device));
	k.at[0] = 1;
	k.radius = 0;
	assert_false(pick_is_within(&k, p, device));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(random_scenes),
		cmocka_unit_test(tiny_distances_are_exact),
		cmocka_unit_test(what_rounds_onto_the_edge_is_outside),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
