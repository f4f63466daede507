/* SPDX-License-Identifier: MIT */
/* What inspect prints of bounds: distances and the rectangle are the nearest doubles,
 * and the planes that corners are outside of are those that MPFR finds. */
#include "../derive/box.h"

#include "../derive/frustum.h"
#include "claims.h"

enum { W = 6 }; /* the index of w among the planes' functions */

/* The corners of a box: x, y and w on the device or, without one, in ndc; the functions
 * of the planes and w; and distance times the last coordinate in view space. */
struct truth_box {
	int n;
	struct sized image[8][3], plane[8][7], distance[8], last[8];
};

static struct sized scaled(struct sized a, real factor)
{
	return (struct sized){ mul(a.value, factor), mul(a.size, magnitude(factor)) };
}

static struct sized row_times(const struct sized p[4], const struct truth *t, int j)
{
	struct sized r = sized_of(0);

	for (int i = 0; i < 4; i++)
		r = sized_add(r, sized_mul(p[i], truth_element(t, i, j)));
	return r;
}

/* Sets p to corner k of the bounds. */
static void set_corner(const struct bounds *b, int dimensions, int k, struct sized p[4])
{
	for (int i = 0; i < 3; i++) {
		const bool high = k >> i & 1;
		struct sized radius = sized_of(b->radius);

		p[i] = sized_of(high ? b->max[i] : b->min[i]);
		if (b->sphere)
			p[i] = high ? sized_add(sized_of(b->center[i]), radius) :
				      sized_sub(sized_of(b->center[i]), radius);
		if (i >= dimensions)
			p[i] = sized_of(0);
	}
	p[3] = sized_of(1);
}

static void set_truth(const struct scene *s, const struct bounds *b,
    struct truth_box *t)
{
	static struct truth clip, view, device;
	real column[4];

	truth_scene(s, SPACE_MODEL, SPACE_CLIP, &clip);
	truth_scene(s, SPACE_MODEL, SPACE_VIEW, &view);
	truth_scene(s, SPACE_MODEL, s->has_viewport ? SPACE_DEVICE : SPACE_NDC,
	    &device);
	truth_distance(s, column);
	t->n = 8;
	for (int k = 0; k < t->n; k++) {
		struct sized p[4], q[4];

		set_corner(b, 3, k, p);
		t->distance[k] = sized_of(0);
		for (int j = 0; j < 4; j++) {
			q[j] = row_times(p, &clip, j);
			t->last[k] = row_times(p, &view, j);
			t->distance[k] = sized_add(t->distance[k],
			    scaled(t->last[k], column[j]));
			if (j != 2)
				t->image[k][j < 2 ? j : 2] = row_times(p, &device, j);
		}
		truth_planes(s, q, t->plane[k]);
		for (int i = 4; i < W && projection_is_open(&s->projection); i++)
			t->plane[k][i] = sized_of(1);
		t->plane[k][W] = q[3];
	}
}

static void set_flat_truth(const struct scene *s, const struct bounds *b,
    struct truth_box *t)
{
	static struct truth ndc, device;
	const struct sized one = sized_of(1);

	truth_flat(s, FLAT_WINDOW, FLAT_NDC, &ndc);
	truth_flat(s, FLAT_WINDOW, s->has_device ? FLAT_DEVICE : FLAT_NDC, &device);
	t->n = 4;
	for (int k = 0; k < t->n; k++) {
		struct sized p[4];

		set_corner(b, 2, k, p);
		for (int i = 0; i < 4; i++) {
			struct sized at = row_times(p, &ndc, i / 2);

			t->plane[k][i] = i % 2 ? sized_sub(one, at) :
						 sized_add(one, at);
		}
		for (int i = 4; i <= W; i++)
			t->plane[k][i] = one;
		for (int j = 0; j < 2; j++)
			t->image[k][j] = row_times(p, &device, j);
		t->image[k][2] = one;
	}
}

/* Returns whether rounding could change the sign of a plane's function. */
static bool is_doubtful(const struct truth_box *t)
{
	bool any = false, doubtful;

	for (int k = 0; k < 7 * t->n; k++)
		any |= truth_sign(t->plane[k / 7][k % 7], &doubtful) != 0 && doubtful;
	return any;
}

static void check_planes(const struct truth_box *t, const struct box *r)
{
	unsigned some = 0, all = ~0u;

	for (int k = 0; k < t->n; k++) {
		unsigned out = 0;

		for (int i = 0; i <= W; i++)
			if (truth_sign(t->plane[k][i], NULL) < (i == W))
				out |= 1u << i;
		some |= out;
		all &= out;
	}
	assert_int_equal(r->behind, all >> W & 1);
	assert_int_equal(r->out, (all & 63) != 0);
	assert_int_equal(r->outside, some & 63);
}

/* The least and the greatest of quotients n / d. */
struct range {
	bool known;
	struct sized n[2], d[2];
};

static void range_add(struct range *r, struct sized n, struct sized d)
{
	for (int k = 0; k < 2; k++) {
		real v = divide(n.value, d.value);

		if (r->known &&
		    mpfr_cmp(v, divide(r->n[k].value, r->d[k].value)) * (2 * k - 1) <=
			0)
			continue;
		r->n[k] = n;
		r->d[k] = d;
	}
	r->known = true;
}

static void judge_range(const struct range *r, double low, double high,
    int verdicts[VERDICTS])
{
	for (int k = 0; k < 2; k++) {
		const double got = k ? high : low;

		if (r->known)
			verdicts[truth_verdict(got, r->n[k], r->d[k], false)]++;
		else
			verdicts[isnan(got) ? NEAREST : WRONG]++;
	}
}

/* Finds the rectangle of the corners beyond the near plane, and of the points where the
 * edges meet it: at the share a / (a - b) of the edge, if a and b are the functions. */
static void judge_rectangle(const struct truth_box *t, const struct box *r,
    int verdicts[VERDICTS])
{
	struct range side[2] = { 0 };
	bool reaches_eye = false;

	for (int i = 0; i < t->n * 4; i++) {
		const int a = i / 4, bit = (1 << i % 4) / 2, b = a | bit;
		struct sized near = t->plane[a][4], off = t->plane[b][4], at[3];
		real share = real_of(0);

		if (b >= t->n ||
		    (bit == 0 ? truth_sign(near, NULL) < 0 :
				truth_sign(near, NULL) * truth_sign(off, NULL) >= 0))
			continue;
		if (bit != 0)
			share = divide(near.value, sub(near.value, off.value));
		for (int j = 0; j < 3; j++)
			at[j] = sized_add(scaled(t->image[a][j],
					      sub(real_of(1), share)),
			    scaled(t->image[b][j], share));
		if (truth_sign(at[2], NULL) <= 0)
			reaches_eye = true;
		for (int j = 0; j < 2 && !reaches_eye; j++)
			range_add(&side[j], at[j], at[2]);
	}
	for (int j = 0; j < 2; j++) {
		side[j].known &= !reaches_eye;
		judge_range(&side[j], r->min[j], r->max[j], verdicts);
	}
}

/* Samples bounds of the size of what the scene shows, also about the eye. */
static void sample_bounds(const struct scene *s, struct bounds *b)
{
	const int e = sample_below(3) == 0 ? 2 : 1;

	*b = (struct bounds){ .sphere = sample_below(3) == 0,
		.radius = sample_size(e) };
	for (int i = 0; i < 3; i++) {
		b->center[i] = sample_number(e) +
		    (s->has_camera && camera_has_eye(&s->camera) ? s->camera.eye[i] :
								   0);
		b->min[i] = b->center[i];
		b->max[i] = b->min[i] + (sample_below(5) > 0 ? sample_size(e) : 0);
	}
}

static void boxes_are_true(void **state)
{
	int verdicts[VERDICTS] = { 0 }, boxes[2] = { 0 }, cut = 0;
	static struct truth_box t;
	struct bounds b;
	struct scene s;
	struct box r;

	(void)state;
	SAMPLES(k, 800) {
		const bool flat = k % 4 == 0;
		const int mark = real_mark();

		if (k % 4 == 1)
			sample_round_scene(&s);
		else
			sample_scene(&s, 0);
		sample_answer(&s);
		sample_bounds(&s, &b);
		if (k % 8 == 3) { /* the near plane has a face of the box */
			s.has_world = s.has_camera = false;
			b.sphere = false;
			b.min[2] = truth_gaze_sign(truth_answer(&s)) *
			    s.projection.near;
			b.max[2] = b.min[2] + sample_size(1);
		}
		if (!box_of(&s, &b, flat, &r, NULL))
			continue;
		if (flat)
			set_flat_truth(&s, &b, &t);
		else
			set_truth(&s, &b, &t);
		if (is_doubtful(&t))
			continue;
		check_planes(&t, &r);
		judge_rectangle(&t, &r, verdicts);
		struct range range = { 0 };

		for (int i = 0; i < t.n && !flat; i++)
			range_add(&range, t.distance[i], t.last[i]);
		if (!flat)
			judge_range(&range, r.distance[0], r.distance[1], verdicts);
		if (verdicts[WRONG] > 0)
			fail_msg(
			    "came %.17g to %.17g, %.17g to %.17g; distance %.17g to "
			    "%.17g",
			    r.min[0], r.max[0], r.min[1], r.max[1], r.distance[0],
			    r.distance[1]);
		boxes[flat]++;
		cut += !isnan(r.min[0]) && (r.outside & OUT_NEAR) != 0;
		real_release(mark);
	}
	print_message(
	    "%d boxes, %d in 2D, %d cut: %d numbers, %d within the tolerance\n",
	    boxes[0], boxes[1], cut, verdicts[NEAREST], verdicts[WITHIN_TOLERANCE]);
	assert_true(boxes[0] > 300 && boxes[1] > 100 && cut > 50);
	assert_true(verdicts[WITHIN_TOLERANCE] <= verdicts[NEAREST] / 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(boxes_are_true),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
