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
	const double size[2] = { s->width, s->height }, *edges = s->edges;
	const bool wide = p->aspect[0] >= p->aspect[1];

	for (int k = 0; k < 2; k++) {
		sum_set(&sums[k], 0);
		sum_set(&f->s[k], 2 * d);
		sum_set(&f->d[k], size[k]);
	}
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
	case SECTION_SIZE:
		break;
	case SECTION_WIDTH:
	case SECTION_HEIGHT:
		scaled_set_sizes(p->aspect, s->way == SECTION_HEIGHT, f->s[0],
		    size[s->way == SECTION_HEIGHT], f);
		break;
	case SECTION_EDGES:
		for (int k = 0; k < 2; k++) {
			f->d[k] = sum_difference(edges[2 * k + 1], edges[2 * k]);
			sums[k] = sum_difference(edges[2 * k], -edges[2 * k + 1]);
		}
		break;
	case SECTION_ANGLES:
		for (int k = 0; k < 2; k++)
			tangents(s->angles + 2 * k, p->unit, &f->s[k], &f->d[k],
			    &sums[k]);
		break;
	case SECTION_INTRINSICS: /* edges from 0 to the size */
		for (int k = 0; k < 2; k++)
			sum_copy(&sums[k], &f->d[k]);
		break;
	}
}
