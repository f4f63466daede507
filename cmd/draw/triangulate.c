/* SPDX-License-Identifier: MIT */
/* Cuts ears: a corner whose triangle with its two neighbours holds no other corner is
 * cut off, until a triangle is left. */
#include "triangulate.h"

#include <math.h>
#include <stdlib.h>

#include "../message/message.h"

struct ring {
	double (
	    *at)[2]; /* the corners, seen along the face's normal: counterclockwise */
	size_t *next, *previous;
};

/* Returns twice the area of a triangle, which is positive if it is counterclockwise. */
static double area(const double a[2], const double b[2], const double c[2])
{
	return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Writes the corners as seen along the axis nearest to the normal, which Newell's sums
 * of areas give. Numbers relative to the first corner, over the greatest, have areas in
 * the range of doubles. */
static void flatten(const double (*point)[3], const unsigned *corner, size_t n,
    double (*out)[2])
{
	const double *o = point[corner[0]];
	double size = 0, normal[3] = { 0 };
	int axis = 2;

	for (size_t i = 0; i < n; i++)
		for (int k = 0; k < 3; k++)
			size = fmax(size, fabs(point[corner[i]][k] - o[k]));
	for (size_t i = 0; i < n; i++) {
		const double *p = point[corner[i]];
		const double *q = point[corner[i + 1 < n ? i + 1 : 0]];

		for (int k = 0; k < 3 && size > 0; k++) {
			const int a = (k + 1) % 3, b = (k + 2) % 3;

			normal[k] += (p[a] - q[a]) / size *
			    ((p[b] - o[b]) / size + (q[b] - o[b]) / size);
		}
	}
	for (int k = 0; k < 3; k++)
		if (fabs(normal[k]) > fabs(normal[axis]))
			axis = k;
	const int a = (axis + 1) % 3, b = (axis + 2) % 3;

	for (size_t i = 0; i < n; i++) {
		const double *p = point[corner[i]];

		out[i][0] = size > 0 ? (p[a] - o[a]) / size : 0;
		out[i][1] = (size > 0 ? (p[b] - o[b]) / size : 0) *
		    (normal[axis] < 0 ? -1 : 1);
	}
}

static bool is_at(const double p[2], const double q[2])
{
	return p[0] == q[0] && p[1] == q[1];
}

/* Returns whether no other corner is in the triangle of corner i. A face with a hole
 * comes back to corners that it had before. */
static bool is_ear(const struct ring *r, size_t i)
{
	const double *a = r->at[r->previous[i]], *b = r->at[i], *c = r->at[r->next[i]];

	if (!(area(a, b, c) > 0))
		return false;
	for (size_t k = r->next[r->next[i]]; k != r->previous[i]; k = r->next[k]) {
		const double *p = r->at[k];

		if (area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0 &&
		    !is_at(p, a) && !is_at(p, b) && !is_at(p, c))
			return false;
	}
	return true;
}

/* Returns whether corner i is cut off after `tried` of `left` corners were not. Of a
 * face that is one line or crosses itself, no corner may be an ear. */
static bool is_cut(const struct ring *r, size_t i, size_t tried, size_t left)
{
	if (left == 3 || tried >= 2 * left)
		return true;
	return tried < left ?
	    is_ear(r, i) :
	    area(r->at[r->previous[i]], r->at[i], r->at[r->next[i]]) >= 0;
}

size_t triangulate(const double (*point)[3], const unsigned *corner, size_t n,
    struct mesh_triangle *out)
{
	struct ring r = { 0 };
	size_t count = 0, left = n, i = 0, tried = 0;

	if (n > 3) {
		r.at = xrealloc(NULL, n * sizeof *r.at);
		flatten(point, corner, n, r.at);
	}
	r.next = xrealloc(NULL, 2 * n * sizeof *r.next);
	r.previous = r.next + n;
	for (size_t k = 0; k < n; k++) {
		r.next[k] = k + 1 < n ? k + 1 : 0;
		r.previous[k] = k > 0 ? k - 1 : n - 1;
	}
	for (; left > 2; i = r.next[i]) {
		if (!is_cut(&r, i, tried++, left))
			continue;
		const unsigned a = corner[r.previous[i]], b = corner[i],
			       c = corner[r.next[i]];

		if (a != b && b != c && c != a)
			out[count++] = (struct mesh_triangle){ { a, b, c } };
		r.next[r.previous[i]] = r.next[i];
		r.previous[r.next[i]] = r.previous[i];
		left--;
		tried = 0;
	}
	free(r.at);
	free(r.next);
	return count;
}
