/* SPDX-License-Identifier: MIT */
#include "section.h"

#include "projection.h"

/* Computes scale = 2, size = r - l and edge_sum = l + r, each times cos a cos b, for
 * the edges l = tan a and r = tan b at distance 1 of the two angles a and b. */
static void tangents(const double angle[2], enum angle_unit unit, struct sum *scale,
    struct sum *size, struct sum *edge_sum)
{
	struct sum sa, ca, sb, cb;

	trig_sin_cos(angle[0], unit, &sa, &ca);
	trig_sin_cos(angle[1], unit, &sb, &cb);
	struct sum left = sum_mul(sa, cb), right = sum_mul(sb, ca);

	*scale = sum_scale(sum_mul(ca, cb), 2);
	*size = sum_sub(right, left);
	*edge_sum = sum_add(left, right);
}

/* Sets the sizes of ways that give one number and an aspect; f->s[0] is twice the
 * distance. */
static void sizes_by_aspect(const struct projection *p, struct scaled_matrix *f)
{
	const struct projection_section *s = &p->section;
	const bool wide = p->aspect[0] >= p->aspect[1];

	switch (s->way) {
	case SECTION_FOVY:
	case SECTION_FOVX:
	case SECTION_VIEW_ANGLE:
		scaled_set_sizes(p->aspect,
		    s->way == SECTION_FOVY || (s->way == SECTION_VIEW_ANGLE && wide),
		    trig_cot(s->angle / 2, p->unit), 1, f);
		break;
	case SECTION_FIELD:
		scaled_set_sizes(p->aspect, !wide, sum_one, s->field, f);
		break;
	case SECTION_WIDTH:
		scaled_set_sizes(p->aspect, 0, f->s[0], s->width, f);
		break;
	case SECTION_HEIGHT:
		scaled_set_sizes(p->aspect, 1, f->s[0], s->height, f);
		break;
	case SECTION_SIZE:
	case SECTION_EDGES:
	case SECTION_ANGLES:
	case SECTION_INTRINSICS: /* section_sizes reads both numbers */
		break;
	}
}

bool section_check(const struct projection *p, struct refusals *faults)
{
	const struct projection_section *s = &p->section;
	static const char remedy[] = "the edges must differ";
	bool is_right = true;

	if (s->way == SECTION_EDGES && s->left == s->right)
		is_right = refuse(faults, "/projection/right", "equal to left", remedy);
	if (s->way == SECTION_EDGES && s->bottom == s->top)
		is_right = refuse(faults, "/projection/top", "equal to bottom", remedy);
	if (s->way == SECTION_ANGLES &&
	    (s->angles[0] >= s->angles[1] || s->angles[2] >= s->angles[3]))
		is_right = refuse(faults, "/projection/angles", "not in order",
		    "left below right, bottom below top");
	return is_right;
}

void section_sizes(const struct projection *p, double d, struct scaled_matrix *f,
    struct sum sums[2])
{
	const struct projection_section *s = &p->section;
	const double size[2] = { s->width, s->height };

	for (int k = 0; k < 2; k++) {
		sum_set(&sums[k], 0);
		sum_set(&f->s[k], 2 * d);
		sum_set(&f->d[k], size[k]);
		if (s->way == SECTION_ANGLES)
			tangents(s->angles + 2 * k, p->unit, &f->s[k], &f->d[k],
			    &sums[k]);
		if (s->way == SECTION_INTRINSICS) /* edges from 0 to the size */
			sum_copy(&sums[k], &f->d[k]);
		if (s->way != SECTION_EDGES)
			continue;
		f->d[k] = sum_difference(s->edges[2 * k + 1], s->edges[2 * k]);
		sums[k] = sum_difference(s->edges[2 * k], -s->edges[2 * k + 1]);
	}
	sizes_by_aspect(p, f);
}
