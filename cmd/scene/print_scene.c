/* SPDX-License-Identifier: MIT */
#include "print_scene.h"

#include "../json/print.h"
#include "convention_member.h"
#include "members.h"
#include "../message/message.h"

/* By name, or by what differs from d3d. */
static void put_convention(struct printer *p, const struct convention *c)
{
	put_name_on_new_line(p, "convention");
	for (int i = 0; i < CONVENTIONS; i++)
		if (same_convention(c, &conventions[i])) {
			put_string(p, convention_names[i]);
			return;
		}
	object_print(p, convention_members, 0, ~UINT64_C(0), c);
}

static void put_world(struct printer *p, const double m[4][4], bool column)
{
	put_name_on_new_line(p, "world");
	put_open(p, "[");
	for (int i = 0; i < 4; i++) {
		double row[4];

		for (int j = 0; j < 4; j++)
			row[j] = column ? m[j][i] : m[i][j];
		put_numbers(p, row, 4);
	}
	put_close(p, "]");
}

static void put_window(struct printer *p, const struct window *w)
{
	uint64_t bits = object_shown(window_members, 0, window_ways,
	    w->by_edges);

	if (!w->has_about)
		bits &= ~member_bit(window_members, 0, "about");
	put_name_on_new_line(p, "window");
	object_print(p, window_members, 0, bits, w);
}

void put_device(struct printer *p, const struct device *d)
{
	put_name_on_new_line(p, "device");
	object_print(p, device_members, 0, ~UINT64_C(0), d);
}

static void put_pick(struct printer *p, const struct pick *k)
{
	uint64_t bits = ~UINT64_C(0);

	if (!k->has_at)
		bits &= ~member_bit(pick_members, 0, "at");
	if (k->radius == 0)
		bits &= ~member_bit(pick_members, 0, "radius");
	put_name_on_new_line(p, "pick");
	object_print(p, pick_members, 0, bits, k);
}

/* What leads from model space to the device. */
static void put_stages(struct printer *p, const struct scene *s)
{
	if (s->has_world)
		put_world(p, s->world, s->convention.column);
	put_name_on_new_line(p, "camera");
	object_print(p, camera_members, 0,
	    object_shown(camera_members, 0, camera_ways, CAMERA_GAZE),
	    &s->camera);
	put_name_on_new_line(p, "projection");
	print_projection(p, &s->projection,
	    s->has_viewport ? &s->viewport : NULL);
	if (!s->has_viewport)
		return;
	put_name_on_new_line(p, "viewport");
	object_print(p, viewport_members, 0, ~UINT64_C(0), &s->viewport);
}

void put_scene(struct printer *p, const struct scene *s)
{
	const bool on_line = p->on_line;

	put_open(p, "{");
	p->on_line = true;
	put_convention(p, &s->convention);
	put_stages(p, s);
	p->on_line = on_line;
	put_close(p, "}");
}

void print_scene(const struct document *d, bool on_line)
{
	static char text[1 << 16];
	struct printer p = { .at = text,
		.on_line = on_line,
		.compact = on_line,
		.between = "" };
	const struct scene *s = &d->scene;

	put_open(&p, "{");
	put_convention(&p, &s->convention);
	if (d->unit == RADIANS) {
		put_name_on_new_line(&p, "angle_unit");
		put_string(&p, angle_units[RADIANS]);
	}
	if (!d->flat)
		put_stages(&p, s);
	if (s->has_window)
		put_window(&p, &s->window);
	if (s->has_device)
		put_device(&p, &s->device);
	if (d->pick.has_at || d->pick.radius > 0)
		put_pick(&p, &d->pick);
	if (s->margin > 0) {
		put_name_on_new_line(&p, "margin");
		put_number(&p, s->margin);
	}
	put_text(&p, on_line ? "}\n" : "\n}\n");
	put_all(text, (size_t)(p.at - text));
}
