/* SPDX-License-Identifier: MIT */
/* Removes hidden lines. A face hides an interval of a segment: where the segment is
 * inside its outline, and beyond its plane. What no interval covers is visible. The
 * faces that may hide a segment are found in a tree of boxes. */
#include "hidden.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../message/grow.h"

/* Parts of the picture that are told apart, and by which outlines are widened, so that
 * no line shows between two neighbours. */
static const double least_part = 1e-5, seam = 1e-9;

/* A box of faces: all nodes from this one to `end` are within. Leaves have `count`
 * faces from `first` on. */
struct node {
	double low[3], high[3];
	unsigned end, first, count;
};

struct tree {
	struct node *node;
	unsigned nodes;
};

/* Hidden parts of a segment, as fractions of the way. */
struct interval {
	double from, to;
};

static struct intervals {
	struct interval *v;
	size_t n;
} hidden;

enum { LEAF_FACES = 4 };

/* Puts 16 bits on the even places of 32. */
static uint32_t spread(double v)
{
	uint32_t x = v < 0 ? 0 : v >= 1 ? 65535 : (uint32_t)(65536 * v);

	x = (x | x << 8) & 0x00ff00ff;
	x = (x | x << 4) & 0x0f0f0f0f;
	x = (x | x << 2) & 0x33333333;
	return (x | x << 1) & 0x55555555;
}

static int compare_places(const void *a, const void *b)
{
	const struct face *p = a, *q = b;

	return (p->place > q->place) - (p->place < q->place);
}

static void node_hold(struct node *node, const double low[3], const double high[3])
{
	for (int k = 0; k < 3; k++) {
		node->low[k] = fmin(node->low[k], low[k]);
		node->high[k] = fmax(node->high[k], high[k]);
	}
}

/* Adds the node of n faces from `first` on, and those below it. */
static void tree_add(struct tree *t, const struct picture *p, unsigned first,
    unsigned n)
{
	struct node *node = &t->node[t->nodes++], *half[2];

	*node = (struct node){ .low = { HUGE_VAL, HUGE_VAL, HUGE_VAL },
		.high = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL },
		.first = first };
	if (n <= LEAF_FACES) {
		node->count = n;
		for (unsigned i = first; i < first + n; i++)
			node_hold(node, p->face[i].low, p->face[i].high);
	} else {
		half[0] = &t->node[t->nodes];
		tree_add(t, p, first, n / 2);
		half[1] = &t->node[t->nodes];
		tree_add(t, p, first + n / 2, n - n / 2);
		for (int k = 0; k < 2; k++)
			node_hold(node, half[k]->low, half[k]->high);
	}
	node->end = t->nodes;
}

/* Makes the tree of a picture with faces, which it sorts along Morton's curve. */
static void tree_make(struct tree *t, struct picture *p)
{
	for (size_t i = 0; i < p->faces; i++) {
		struct face *f = &p->face[i];

		f->place = spread((f->low[0] + f->high[0]) / 2) |
		    spread((f->low[1] + f->high[1]) / 2) << 1;
	}
	qsort(p->face, p->faces, sizeof *p->face, compare_places);
	t->node = xrealloc(NULL, p->faces * sizeof *t->node);
	tree_add(t, p, 0, (unsigned)p->faces);
}

/* Makes [*from, *to] the part of the segment that is inside the outline of a face. */
static bool cut_by_outline(const struct picture *p, const struct face *f,
    const struct segment *s, double *from, double *to)
{
	const double(*v)[3] = (const double(*)[3])p->corner + f->first;
	const double *a = s->end[0];
	const double dx = s->end[1][0] - a[0], dy = s->end[1][1] - a[1];

	for (unsigned i = 0; i < f->n; i++) {
		const double *q = v[i], *r = v[i + 1 < f->n ? i + 1 : 0];
		const double ex = r[0] - q[0], ey = r[1] - q[1];
		/* distances from the edge, times its length: at a, and what b adds */
		const double at = ex * (a[1] - q[1]) - ey * (a[0] - q[0]) +
		    seam * (fabs(ex) + fabs(ey));
		const double rise = ex * dy - ey * dx;

		if (rise > 0)
			*from = fmax(*from, -at / rise);
		else if (rise < 0)
			*to = fmin(*to, -at / rise);
		else if (at < 0)
			return false;
	}
	return *to > *from;
}

/* Adds the part of the segment that a face hides. Where the face ends in the segment's
 * own vertex, the other end alone tells which side of the plane it is on. */
static void hide_by(const struct picture *p, const struct face *f,
    const struct segment *s)
{
	int end = 0;
	const int shared = picture_shared(f, s->vertex, &end);

	if (shared == 2)
		return;
	const double a = picture_beyond(p, f, s->end[0]);
	const double b = picture_beyond(p, f, s->end[1]);
	double from = 0, to = 1;

	if (shared == 1 ? (end == 0 ? b : a) <= 0 : a <= 0 && b <= 0)
		return;
	if (shared == 0 && a < 0)
		from = a / (a - b);
	if (shared == 0 && b < 0)
		to = a / (a - b);
	if (!cut_by_outline(p, f, s, &from, &to))
		return;
	GROW(hidden.v, hidden.n, 1);
	hidden.v[hidden.n++] = (struct interval){ from, to };
}

/* Returns whether a face of the node may be in front of the segment in this box. */
static bool node_meets(const struct node *n, const struct segment *s,
    const double low[3], const double high[3])
{
	if (n->low[0] > high[0] || n->high[0] < low[0] || n->low[1] > high[1] ||
	    n->high[1] < low[1] || n->low[2] > high[2])
		return false;
	const double dx = s->end[1][0] - s->end[0][0];
	const double dy = s->end[1][1] - s->end[0][1];
	const double x = (n->low[0] + n->high[0]) / 2 - s->end[0][0];
	const double y = (n->low[1] + n->high[1]) / 2 - s->end[0][1];

	return fabs(dx * y - dy * x) <=
	    fabs(dx) * ((n->high[1] - n->low[1]) / 2 + seam) +
	    fabs(dy) * ((n->high[0] - n->low[0]) / 2 + seam);
}

static int compare_intervals(const void *a, const void *b)
{
	const struct interval *p = a, *q = b;

	return (p->from > q->from) - (p->from < q->from);
}

/* Finds the hidden parts of a segment, in order. Stops at a face that hides all. */
static void hide(const struct picture *p, const struct tree *t, const struct segment *s)
{
	double low[3], high[3];

	hidden.n = 0;
	for (int k = 0; k < 3; k++) {
		low[k] = fmin(s->end[0][k], s->end[1][k]) - (k < 2 ? seam : 0);
		high[k] = fmax(s->end[0][k], s->end[1][k]) + (k < 2 ? seam : 0);
	}
	for (unsigned i = 0; i < t->nodes;) {
		const struct node *node = &t->node[i];

		if (!node_meets(node, s, low, high)) {
			i = node->end;
			continue;
		}
		for (unsigned k = 0; k < node->count; k++) {
			const struct face *f = &p->face[node->first + k];
			const size_t n = hidden.n;

			if (f->low[0] <= high[0] && f->high[0] >= low[0] &&
			    f->low[1] <= high[1] && f->high[1] >= low[1])
				hide_by(p, f, s);
			if (hidden.n > n && hidden.v[n].from <= 0 &&
			    hidden.v[n].to >= 1) {
				hidden.v[0] = hidden.v[n];
				hidden.n = 1;
				return;
			}
		}
		i++;
	}
	if (hidden.n > 1)
		qsort(hidden.v, hidden.n, sizeof *hidden.v, compare_intervals);
}

/* Adds the part of a segment between two fractions of the way. */
static void add_part(struct picture *p, const struct segment *s, double from, double to)
{
	struct segment part = *s;

	for (int k = 0; k < 3; k++) {
		const double d = s->end[1][k] - s->end[0][k];

		part.end[0][k] += from * d;
		if (to < 1)
			part.end[1][k] = s->end[0][k] + to * d;
	}
	part.vertex[0] = from > 0 ? NO_VERTEX : s->vertex[0];
	part.vertex[1] = to < 1 ? NO_VERTEX : s->vertex[1];
	picture_add_segment(p, &part);
}

/* Adds the visible parts of a segment whose hidden parts are known. */
static void add_parts(struct picture *p, const struct segment *s)
{
	const double length = hypot(s->end[1][0] - s->end[0][0],
	    s->end[1][1] - s->end[0][1]);
	const double least = 4 * least_part > length ? 0.25 : least_part / length;
	double begin = 0;

	/* a gap that is not told apart is closed, and then a part that is not */
	for (size_t i = 0; i < hidden.n; i++) {
		double to = fmin(hidden.v[i].to, 1);
		const double from = fmax(hidden.v[i].from, 0);

		while (i + 1 < hidden.n && hidden.v[i + 1].from <= to + least) {
			i++;
			to = fmax(to, fmin(hidden.v[i].to, 1));
		}
		if (to - from < least)
			continue;
		if (from - begin > least)
			add_part(p, s, begin, from);
		begin = to;
	}
	if (1 - begin > least)
		add_part(p, s, begin, 1);
}

void hidden_remove(struct picture *p)
{
	struct segment *given = p->segment;
	const size_t segments = p->segments;
	struct tree t = { 0 };

	if (p->faces == 0)
		return;
	tree_make(&t, p);
	p->segment = NULL;
	p->segments = 0;
	for (size_t i = 0; i < segments; i++) {
		hide(p, &t, &given[i]);
		add_parts(p, &given[i]);
	}
	free(given);
	free(t.node);
}
