/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../message/grow.h"

void picture_add_corner(struct picture *p, const double at[3])
{
	GROW(p->corner, p->corners, 1);
	memcpy(p->corner[p->corners++], at, sizeof *p->corner);
}

void picture_add_face(struct picture *p, size_t first, const unsigned vertex[3],
    const double view_normal[3])
{
	struct face f = { .first = first, .n = (unsigned)(p->corners - first) };
	double length = 0;

	for (int k = 0; k < 3; k++)
		length = hypot(length, view_normal[k]);
	for (int k = 0; k < 3; k++) {
		f.vertex[k] = vertex[k];
		f.view_normal[k] = (float)(length > 0 ? view_normal[k] / length : 0);
	}
	GROW(p->face, p->faces, 1);
	p->face[p->faces++] = f;
}

void picture_add_segment(struct picture *p, const struct segment *s)
{
	GROW(p->segment, p->segments, 1);
	p->segment[p->segments++] = *s;
}

/* Returns z of corner i or, from the last one on, of an end of a segment. */
static double *z_at(const struct picture *p, size_t i)
{
	const size_t end = i - p->corners;

	return i < p->corners ? &p->corner[i][2] : &p->segment[end / 2].end[end % 2][2];
}

static void set_depths(struct picture *p)
{
	const size_t n = p->corners + 2 * p->segments;
	double least = HUGE_VAL, most = -HUGE_VAL;

	for (size_t i = 0; i < n; i++) {
		least = fmin(least, *z_at(p, i));
		most = fmax(most, *z_at(p, i));
	}
	for (size_t i = 0; i < n; i++) {
		double *const z = z_at(p, i);

		if (p->parallel)
			*z = most > least ? (*z - least) / (most - least) : 0;
		else
			*z = (p->reverse ? least : -least) / *z;
	}
}

/* Sets the box and the plane of a face, by the products of its sides from its first
 * corner. Returns their sign, or 0 if it is seen from the side. */
static int set_plane(const struct picture *p, struct face *f)
{
	const double(*v)[3] = (const double(*)[3])p->corner + f->first;
	double side = 0;

	for (int k = 0; k < 3; k++) {
		const int a = (k + 1) % 3, b = (k + 2) % 3;

		f->low[k] = f->high[k] = v[0][k];
		for (unsigned i = 1; i < f->n; i++) {
			f->low[k] = fmin(f->low[k], v[i][k]);
			f->high[k] = fmax(f->high[k], v[i][k]);
		}
		for (unsigned i = 1; i + 1 < f->n; i++)
			f->normal[k] += (v[i][a] - v[0][a]) * (v[i + 1][b] - v[0][b]) -
			    (v[i][b] - v[0][b]) * (v[i + 1][a] - v[0][a]);
	}
	for (int k = 0; k < 2; k++)
		side = fmax(side, f->high[k] - f->low[k]);
	/* it is at most about 1e-8 of the picture wide */
	if (!(fabs(f->normal[2]) > 1e-8 * side))
		return 0;
	return f->normal[2] < 0 ? -1 : 1;
}

/* Turns the normal and the order of the corners. */
static void turn(const struct picture *p, struct face *f)
{
	double(*v)[3] = p->corner + f->first, swap[3];

	for (unsigned i = 0, k = f->n - 1; i < k; i++, k--) {
		memcpy(swap, v[i], sizeof swap);
		memcpy(v[i], v[k], sizeof swap);
		memcpy(v[k], swap, sizeof swap);
	}
	for (int k = 0; k < 3; k++) {
		f->normal[k] = -f->normal[k];
		f->view_normal[k] = -f->view_normal[k];
	}
}

void picture_complete(struct picture *p, const double lamp[3], const double gaze[3])
{
	double faces_away = 0; /* what the faces say together */
	size_t n = 0;

	set_depths(p);
	for (size_t i = 0; i < p->faces; i++) {
		struct face *f = &p->face[i];
		const int sign = set_plane(p, f);

		if (sign < 0)
			turn(p, f);
		for (int k = 0; k < 3 && sign != 0; k++)
			faces_away += f->normal[2] * (double)f->view_normal[k] *
			    gaze[k];
		if (sign != 0)
			p->face[n++] = *f;
	}
	p->faces = n;
	for (size_t i = 0; i < n; i++) {
		struct face *f = &p->face[i];
		double light = 0;

		for (int k = 0; k < 3; k++) {
			f->view_normal[k] *= faces_away > 0 ? -1 : 1;
			light += (double)f->view_normal[k] * lamp[k];
		}
		f->light = (float)fmax(light, 0);
	}
}

void picture_free(struct picture *p)
{
	free(p->corner);
	free(p->face);
	free(p->segment);
	*p = (struct picture){ 0 };
}
