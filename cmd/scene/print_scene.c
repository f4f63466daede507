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

static void put_object(struct printer *p, const char *name,
    const struct member *table, uint64_t bits, const void *base)
{
	put_name_on_new_line(p, name);
	object_print(p, table, 0, bits, base);
}

/* Those bits but for a member's, unless that is there. */
static uint64_t less(uint64_t bits, const struct member *table,
    const char *name, bool there)
{
	return there ? bits : bits & ~member_bit(table, 0, name);
}

void put_device(struct printer *p, const struct device *d)
{
	put_object(p, "device", device_members, ALL_MEMBERS, d);
}

/* What leads from model space to the device. */
static void put_stages(struct printer *p, const struct scene *s)
{
	if (s->has_world)
		put_world(p, s->world, s->convention.column);
	put_object(p, "camera", camera_members,
	    object_shown(camera_members, 0, camera_ways, CAMERA_GAZE),
	    &s->camera);
	put_name_on_new_line(p, "projection");
	print_projection(p, &s->projection,
	    s->has_viewport ? &s->viewport : NULL);
	if (s->has_viewport)
		put_object(p, "viewport", viewport_members, ALL_MEMBERS,
		    &s->viewport);
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
	const struct pick *k = &d->pick;

	put_open(&p, "{");
	put_convention(&p, &s->convention);
	if (d->unit == RADIANS) {
		put_name_on_new_line(&p, "angle_unit");
		put_string(&p, angle_units[RADIANS]);
	}
	if (!d->flat)
		put_stages(&p, s);
	if (s->has_window)
		put_object(&p, "window", window_members,
		    less(object_shown(window_members, 0, window_ways,
			     s->window.by_edges),
			window_members, "about", s->window.has_about),
		    &s->window);
	if (s->has_device)
		put_device(&p, &s->device);
	if (k->has_at || k->radius > 0)
		put_object(&p, "pick", pick_members,
		    less(less(ALL_MEMBERS, pick_members, "at", k->has_at),
			pick_members, "radius", k->radius > 0),
		    k);
	if (s->margin > 0) {
		put_name_on_new_line(&p, "margin");
		put_number(&p, s->margin);
	}
	put_text(&p, on_line ? "}\n" : "\n}\n");
	put_all(text, (size_t)(p.at - text));
}
