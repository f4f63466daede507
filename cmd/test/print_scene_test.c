/* SPDX-License-Identifier: MIT */
#include "../scene/document.h"

#include "../../core/test/claims.h"
#include "read_text.h"
#include "../../core/test/arithmetic.h"

static const struct document_wants project = { WANTS };

/* Makes a random document of the kind that fit prints. */
static void sample_fitted(struct document *d)
{
	struct scene *s = &d->scene;
	struct projection *p = &s->projection;

	memset(d, 0, sizeof *d);
	sample_scene(s, sample_below(2) ? 20 : 0);
	s->has_world = sample_below(2);
	s->has_viewport = sample_below(2);
	s->has_window = sample_below(2);
	s->has_device = sample_below(2);
	s->convention.column_vectors = sample_below(2);
	s->camera.way = CAMERA_GAZE;
	s->camera.has_axes = false;
	s->has_camera = true;
	while (projection_family(p) == FAMILY_FIXED)
		p->type = 1 + sample_below(PROJECTION_TYPES - 1);
	sample_remember(p);
	bool persp = projection_family(p) == FAMILY_PERSP;
	enum section_way sampled = p->section.way;

	p->section.way = SECTION_SIZE + sample_below(4);
	if (persp && sample_below(2))
		p->section.way = sample_below(4);
	if (sampled >= SECTION_ANGLES && persp)
		p->section.way = sampled;
	if (p->section.way < SECTION_SIZE || p->section.way > SECTION_EDGES)
		p->section.edges_at = 0;
	if (p->section.way == SECTION_INTRINSICS)
		s->has_viewport = true;
	d->source.unit = s->camera.unit = p->shear.direction_unit = p->unit;
	if (p->section.way == SECTION_FIELD ||
	    !(p->section.angle < (p->unit == ANGLE_RADIANS ? PI : 180)))
		p->section.angle = 1;
	p->near = sample_size(3);
	p->far = p->near * 3;
	p->aspect[0] = 1.25;
	p->aspect[1] = projection_family(p) != FAMILY_VOLUME || sample_below(2);
	if (p->aspect[1] == 1)
		p->volume.half_width = p->volume.half_height;
	p->near_ratio = sample_below(2) ? 0.0005 : 0.25;
	s->margin = sample_below(2) ? 0 : 0.25;
	d->pick.has_at = sample_below(2);
	d->pick.at[0] = 7;
	d->pick.radius = sample_below(2);
	d->has_pick = d->pick.has_at || d->pick.radius > 0;
}

static void call_print(const void *d)
{
	document_print(d, false);
}

static void assert_same_map(const struct map *a, const struct map *b)
{
	assert_memory_equal(a->origin, b->origin, sizeof a->origin);
	for (int i = 0; i < 16; i++) {
		const struct sum *x = &a->m[i / 4][i % 4];
		const struct sum *y = &b->m[i / 4][i % 4];

		assert_int_equal(ex_compare(x->value, y->value), 0);
		assert_int_equal(x->error, y->error);
	}
}

static void assert_same_maps(const struct scene *a, const struct scene *b)
{
	struct map m, n;
	enum space to = a->has_viewport ? SPACE_DEVICE : SPACE_NDC;
	bool good = scene_map(a, SPACE_MODEL, to, &m, &faults);

	assert_int_equal(scene_map(b, SPACE_MODEL, to, &n, &faults), good);
	if (good)
		assert_same_map(&m, &n);
	if (!a->has_window || !a->has_device)
		return;
	good = scene_map(a, FLAT_WINDOW, FLAT_DEVICE, &m, &faults);
	assert_int_equal(scene_map(b, FLAT_WINDOW, FLAT_DEVICE, &n, &faults), good);
	if (good)
		assert_same_map(&m, &n);
}

/* A document that was printed and read again gives the same maps. Members that change
 * no map are equal, too. */
static void test_reads_back(void **state)
{
	(void)state;
	SAMPLES(i, 300) {
		struct document d, r;
		int status;

		sample_fitted(&d);
		r = read_as(&project, output_of(call_print, &d, &status));
		assert_int_equal(status, 0);
		assert_same_maps(&d.scene, &r.scene);
		assert_number(d.scene.has_viewport, r.scene.has_viewport);
		assert_number(d.scene.has_window, r.scene.has_window);
		assert_number(d.scene.has_device, r.scene.has_device);
		assert_true(projection_family(&r.scene.projection) != FAMILY_PERSP ||
		    d.scene.projection.near_ratio == r.scene.projection.near_ratio);
		assert_number(d.scene.margin, r.scene.margin);
		assert_number(d.pick.has_at, r.pick.has_at);
		assert_number(d.pick.radius, r.pick.radius);
		assert_true(!d.pick.has_at || r.pick.at[0] == 7);
	}
}

/* A flat document is printed without camera, world, viewport and projection. */
static void test_flat(void **state)
{
	(void)state;
	SAMPLES(i, 20) {
		struct document d, r;
		int status;

		sample_fitted(&d);
		d.flat = d.scene.has_window = true;
		r = read_as(&project, output_of(call_print, &d, &status));
		assert_int_equal(status, 0);
		assert_false(
		    r.scene.has_camera || r.scene.has_world || r.scene.has_viewport);
		assert_true(r.scene.projection.type == PROJECTION_NONE);
		assert_true(d.scene.has_device == r.scene.has_device);
		assert_true(r.scene.window.width == d.scene.window.width ||
		    r.scene.window.by_edges);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_flat),
		cmocka_unit_test(test_reads_back),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
