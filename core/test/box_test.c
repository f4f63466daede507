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
		b.sphere &= flat;
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

/* A sphere: functions at its centre and their slopes times its radius. */
struct truth_ball {
	struct sized image[3], plane[7], distance, last;
	struct sized image_slope[3][3], plane_slope[3][7], distance_slope[3];
};

/* Sets the functions of point or, if i < 3, of the step i. */
static void set_ball_truth(const struct scene *s, const struct bounds *b,
    struct truth_ball *t)
{
	static struct truth clip, view, device;
	const real radius = real_of(b->radius);
	real column[4];

	truth_scene(s, SPACE_MODEL, SPACE_CLIP, &clip);
	truth_scene(s, SPACE_MODEL, SPACE_VIEW, &view);
	truth_scene(s, SPACE_MODEL, s->has_viewport ? SPACE_DEVICE : SPACE_NDC,
	    &device);
	truth_distance(s, column);
	for (int i = 0; i < 4; i++) {
		const bool step = i < 3;
		struct sized p[4], q[4], plane[7], distance = sized_of(0);

		for (int k = 0; k < 4; k++)
			p[k] = step ? scaled(sized_of(k == i), radius) :
				      sized_of(k < 3 ? b->center[k] : 1);
		for (int j = 0; j < 4; j++) {
			q[j] = row_times(p, &clip, j);
			t->last = row_times(p, &view, j);
			distance = sized_add(distance, scaled(t->last, column[j]));
			if (j != 2)
				(step ? t->image_slope[i] :
					t->image)[j < 2 ? j : 2] = row_times(p, &device,
				    j);
		}
		truth_planes(s, q, plane);
		for (int k = 4; k < W && projection_is_open(&s->projection); k++)
			plane[k] = sized_of(!step);
		plane[W] = q[3];
		memcpy(step ? t->plane_slope[i] : t->plane, plane, sizeof plane);
		*(step ? &t->distance_slope[i] : &t->distance) = distance;
	}
}

/* Returns v plus, if i is 1, or minus, the length of three slopes. */
static struct sized reach(struct sized v, const struct sized slope[3], int i)
{
	return i ? sized_add(v, sized_length(slope)) :
		   sized_sub(v, sized_length(slope));
}

/* Checks flags; returns whether one is doubtful. Sets *beyond to whether the sphere is
 * beyond near and in front of the eye. */
static bool check_ball_planes(const struct truth_ball *t, const struct box *r,
    bool *beyond)
{
	unsigned bits[2] = { 0 };
	bool any = false, doubtful;

	for (int k = 0; k <= W; k++) {
		const struct sized slope[3] = { t->plane_slope[0][k],
			t->plane_slope[1][k], t->plane_slope[2][k] };

		for (int i = 0; i < 2; i++) {
			struct sized v = reach(t->plane[k], slope, i);

			const int sign = truth_sign(v, &doubtful);

			bits[i] |= (unsigned)(sign < (k == W)) << k;
			any |= sign != 0 && doubtful;
		}
	}
	*beyond = (bits[0] & (OUT_NEAR | OUT_BEHIND)) == 0;
	if (any)
		return true;
	assert_int_equal(r->behind, bits[1] >> W & 1);
	assert_int_equal(r->out, (bits[1] & 63) != 0);
	assert_int_equal(r->outside, bits[0] & 63);
	return false;
}

/* The dual conic as in a textbook: C = r^2 M D M' - M c c' M', with D the identity of
 * directions. */
static void judge_ball_rectangle(const struct truth_ball *t, const struct box *r,
    int verdicts[VERDICTS])
{
	for (int j = 0; j < 2; j++) {
		const int at[3][2] = { { j, j }, { j, 2 }, { 2, 2 } };
		real c[3];

		for (int k = 0; k < 3; k++) {
			const int a = at[k][0], b = at[k][1];

			c[k] = negative(mul(t->image[a].value, t->image[b].value));
			for (int i = 0; i < 3; i++)
				c[k] = add(c[k],
				    mul(t->image_slope[i][a].value,
					t->image_slope[i][b].value));
		}
		const real off = root(sub(mul(c[1], c[1]), mul(c[0], c[2])));

		for (int i = 0; i < 2; i++) {
			/* C33 is negative */
			const real n = i ? sub(c[1], off) : add(c[1], off);
			const struct sized size = { n,
				add(magnitude(c[1]), magnitude(off)) };

			verdicts[truth_verdict(i ? r->max[j] : r->min[j], size,
			    (struct sized){ c[2], magnitude(c[2]) }, false)]++;
		}
	}
}

static void spheres_are_true(void **state)
{
	int verdicts[VERDICTS] = { 0 }, balls = 0, whole = 0;
	static struct truth_ball t;
	struct bounds b;
	struct scene s;
	struct box r;

	(void)state;
	SAMPLES(k, 1200) {
		const int mark = real_mark();
		bool beyond;

		if (k % 4 == 1)
			sample_round_scene(&s);
		else
			sample_scene(&s, 0);
		sample_answer(&s);
		sample_bounds(&s, &b);
		b.sphere = 1;
		if (k % 3 == 0)
			b.radius *= k % 2 ? 1e-12 : 1e-3;
		if (!box_of(&s, &b, false, &r, NULL))
			continue;
		set_ball_truth(&s, &b, &t);
		if (check_ball_planes(&t, &r, &beyond)) {
			real_release(mark);
			continue;
		}
		for (int i = 0; i < 2; i++)
			verdicts[truth_verdict(r.distance[i],
			    reach(t.distance, t.distance_slope, i), t.last, false)]++;
		if (beyond)
			judge_ball_rectangle(&t, &r, verdicts);
		if (verdicts[WRONG] > 0)
			fail_msg("came %.17g to %.17g, %.17g to %.17g", r.min[0],
			    r.max[0], r.min[1], r.max[1]);
		balls++;
		whole += beyond;
		real_release(mark);
	}
	print_message("%d spheres, %d beyond near: %d numbers, %d within the "
		      "tolerance\n",
	    balls, whole, verdicts[NEAREST], verdicts[WITHIN_TOLERANCE]);
	assert_true(balls > 400 && whole > 100);
	assert_true(verdicts[WITHIN_TOLERANCE] <= verdicts[NEAREST] / 100);
}

/* A sphere of gl beside the gaze, by hand: its outline's tangents. */
static void sphere_beside_the_gaze(void **state)
{
	struct scene s = { .has_viewport = true,
		.convention = { .right_handed = true, .depth_minus_one = true },
		.viewport = { .width = 800, .height = 600, .max_z = 1 },
		.projection = { .type = PROJECTION_PERSP,
		    .near = 0.1,
		    .far = 100,
		    .aspect = { 4, 3 } } };
	const struct bounds b = { .sphere = 1, .center = { 3, 0, -5 }, .radius = 1 };
	struct box r;

	(void)state;
	s.projection.section.angle = 60;
	assert_true(box_of(&s, &b, false, &r, NULL));
	/* (15 -+ sqrt(33)) / 24 is the tangent of the angle of a tangent in the
	 * plane */
	for (int i = 0; i < 2; i++)
		assert_true(
		    fabs((i ? r.max[0] : r.min[0]) -
			(400 + 300 * sqrt(3) * (15 + (i ? 1 : -1) * sqrt(33)) / 24)) <
		    1e-10);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(boxes_are_true),
		cmocka_unit_test(spheres_are_true),
		cmocka_unit_test(sphere_beside_the_gaze),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
