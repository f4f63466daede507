/* SPDX-License-Identifier: MIT */
#include "projection.h"

static const struct projection_row *const rows[PROJECTION_TYPES] = {
	[PROJECTION_NONE] = &projection_row_none,
	[PROJECTION_PERSP] = &projection_row_persp,
	[PROJECTION_ORTHO] = &projection_row_ortho,
	[PROJECTION_OBLIQUE] = &projection_row_oblique,
	[PROJECTION_VOLUME] = &projection_row_volume,
	[PROJECTION_MATRIX] = &projection_row_matrix,
};

enum projection_type projection_type_of(enum projection_family family, bool sheared)
{
	for (unsigned type = PROJECTION_NONE + 1; type < PROJECTION_TYPES; type++)
		if (rows[type]->family == family && rows[type]->is_sheared == sheared)
			return (enum projection_type)type;
	return PROJECTION_NONE;
}

void projection_set_defaults(struct projection *p, enum projection_type type)
{
	*p = (struct projection){ .type = type,
		.near_ratio = PROJECTION_NEAR_RATIO,
		.shear.direction = PROJECTION_DIRECTION };
}

enum projection_family projection_family(const struct projection *p)
{
	return rows[p->type]->family;
}

bool projection_is_sheared(const struct projection *p)
{
	return rows[p->type]->is_sheared;
}

bool projection_check(const struct projection *p, bool inverse, struct refusals *faults)
{
	const struct projection_row *row = rows[p->type];

	return (row->check == NULL || row->check(p, faults)) &&
	    (row->check_map == NULL || row->check_map(p, inverse, faults));
}

bool projection_map(const struct projection *p, const struct convention *c,
    bool inverse, struct map *r, struct refusals *faults)
{
	const struct projection_row *row = rows[p->type];
	struct convention given = { .right_handed = false };

	if ((row->check != NULL && !row->check(p, faults)) ||
	    !row->map(p, c, inverse, r, faults))
		return false;
	if (row->frame == FRAME_SCENE)
		return true;
	if (row->frame == FRAME_VIEW)
		given = (struct convention){ .right_handed = c->right_handed,
			.view_y_down = c->view_y_down,
			.ndc_y_down = c->view_y_down };
	convention_change(&given, c, false, !inverse, r);
	convention_change(&given, c, true, inverse, r);
	return true;
}

bool projection_is_reversed(const struct projection *p, const struct convention *c)
{
	const struct projection_row *row = rows[p->type];

	return row->is_reversed != NULL ? row->is_reversed(p, c) : p->reverse_z;
}
