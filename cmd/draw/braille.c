/* SPDX-License-Identifier: MIT */
/* A character has 2 x 4 dots, which are about square. Each dot keeps the face that is
 * nearest there. A face is as bright as the share of its dots that are set, by ordered
 * dither; where faces end or meet at an angle, an outline is. */
#include "braille.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "../message/message.h"

enum { COLUMNS_MAX = 1000, ROWS_MAX = 1000, CHARACTER_MAX = 4 };

/* What a dot of the raster shows. */
struct cell {
	const struct face *face; /* NULL: none */
	float z;
	bool ink; /* of a line or a dot */
};

struct raster {
	const struct picture *picture;
	int width, height; /* in dots */
	double scale;      /* dots for a unit of the picture */
	struct cell *cell;
	double depth; /* the differences of distance that make an outline */
	char (*name)[CHARACTER_MAX + 1]; /* by character: one of a name, or "" */
};

static struct cell *cell_at(const struct raster *r, int x, int y)
{
	return &r->cell[(size_t)y * (size_t)r->width + (size_t)x];
}

static double plane_z(const struct raster *r, const struct face *f, double x, double y)
{
	const double *o = r->picture->corner[f->first];

	return o[2] -
	    (f->normal[0] * (x - o[0]) + f->normal[1] * (y - o[1])) / f->normal[2];
}

/* Narrows [*low, *high] to the x of a row y that are inside the face. */
static void row_of_face(const struct raster *r, const struct face *f, double y,
    double *low, double *high)
{
	const double(*v)[3] = (const double(*)[3])r->picture->corner + f->first;

	for (unsigned i = 0; i < f->n; i++) {
		const double *p = v[i], *q = v[i + 1 < f->n ? i + 1 : 0];

		if ((p[1] <= y) == (q[1] <= y))
			continue;
		const double x = p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]);

		*low = fmin(*low, x);
		*high = fmax(*high, x);
	}
}

static int clamp(double v, int most)
{
	return v < 0 ? 0 : v > most ? most : (int)v;
}

static void fill(struct raster *r, const struct face *f)
{
	const int from = clamp(f->low[1] * r->scale, r->height);
	const int to = clamp(f->high[1] * r->scale + 1, r->height);

	for (int y = from; y < to; y++) {
		const double at = (y + 0.5) / r->scale;
		double low = HUGE_VAL, high = -HUGE_VAL;

		row_of_face(r, f, at, &low, &high);
		const int end = clamp(ceil(high * r->scale - 0.5), r->width);

		for (int x = clamp(ceil(low * r->scale - 0.5), r->width); x < end;
		     x++) {
			const float z = (float)plane_z(r, f, (x + 0.5) / r->scale, at);
			struct cell *c = cell_at(r, x, y);

			if (c->face == NULL || z < c->z) {
				c->face = f;
				c->z = z;
			}
		}
	}
}

/* Sets the dot at p, of a segment with these vertices, unless it is behind a face or
 * outside, and returns whether it did. */
static bool ink(struct raster *r, const double p[3], const unsigned vertex[2])
{
	const double x = floor(p[0] * r->scale), y = floor(p[1] * r->scale);
	int which;

	if (!(x >= 0 && x < r->width && y >= 0 && y < r->height))
		return false;
	struct cell *c = cell_at(r, (int)x, (int)y);

	if (c->face != NULL && picture_shared(c->face, vertex, &which) == 0 &&
	    picture_beyond(r->picture, c->face, p) > 0)
		return false;
	return c->ink = true;
}

/* Returns whether some of the segment is seen. */
static bool ink_segment(struct raster *r, const struct segment *s)
{
	const double *a = s->end[0], *b = s->end[1];
	const double size = fmax(fabs(b[0] - a[0]), fabs(b[1] - a[1]));
	const int n = (int)ceil(size * r->scale) + 1;
	bool seen = false;

	for (int i = 0; i <= n; i++) {
		double p[3];

		for (int k = 0; k < 3; k++)
			p[k] = a[k] + (b[k] - a[k]) * i / n;
		seen |= ink(r, p, s->vertex);
	}
	return seen;
}

/* Puts the characters of a name beside its dot, up to the picture's edge. */
static void put_name(struct raster *r, const struct segment *dot)
{
	const int columns = r->width / 2;
	const int row = clamp(dot->end[0][1] * r->scale / 4, r->height / 4 - 1);
	int column = clamp(dot->end[0][0] * r->scale / 2, columns) + 1;

	for (const char *s = dot->name.s; s < dot->name.end && column < columns;
	     column++) {
		unsigned code = 0;
		const int n = utf8_read(s, dot->name.end, &code);
		char *out = memset(r->name[(size_t)(row * columns + column)], 0,
		    sizeof *r->name);

		/* nothing that moves the cursor */
		if (n == 0 || code < ' ' || (code >= 0x7f && code < 0xa0))
			*out = '?';
		else
			memcpy(out, s, (size_t)n); /* the rest is 0 */
		s += n > 0 ? n : 1;
	}
}

static double distance_of_z(const struct raster *r, double z)
{
	return r->picture->parallel ? z : -1 / z;
}

/* Returns whether an outline is at x y: a neighbour has no face, or one that is far
 * behind; or, of the two dots at a bend, at the first. */
static bool is_outline(const struct raster *r, int x, int y, int x1, int y1)
{
	const struct cell *a = cell_at(r, x, y), *b;
	double cosine = 0;

	if (x1 < 0 || y1 < 0 || x1 >= r->width || y1 >= r->height)
		return false;
	b = cell_at(r, x1, y1);
	if (b->face == a->face)
		return false;
	if (b->face == NULL)
		return true;
	const double z = plane_z(r, a->face, (x1 + 0.5) / r->scale,
	    (y1 + 0.5) / r->scale);

	if ((r->picture->parallel || (z > 0) == r->picture->reverse) &&
	    distance_of_z(r, (double)b->z) - distance_of_z(r, z) > r->depth)
		return true;
	for (int k = 0; k < 3; k++)
		cosine += (double)(a->face->view_normal[k] * b->face->view_normal[k]);
	return cosine < 0.7 && (x1 > x || y1 > y);
}

static bool is_set(const struct raster *r, int x, int y)
{
	static const int order[4][4] = { { 0, 8, 2, 10 }, { 12, 4, 14, 6 },
		{ 3, 11, 1, 9 }, { 15, 7, 13, 5 } };
	const struct cell *c = cell_at(r, x, y);

	if (c->face == NULL || c->ink)
		return c->ink;
	/* the power darkens what has little light, so that hollows stand out */
	return 1.2 * pow((double)c->face->light, 2.5) >
	    (order[y % 4][x % 4] + 0.5) / 16 ||
	    is_outline(r, x, y, x - 1, y) || is_outline(r, x, y, x + 1, y) ||
	    is_outline(r, x, y, x, y - 1) || is_outline(r, x, y, x, y + 1);
}

static void print_row(const struct raster *r, int y)
{
	static const int bit[8] = { 1, 8, 2, 16, 4, 32, 64, 128 };
	char line[(CHARACTER_MAX + 1) * COLUMNS_MAX + 1], *at = line, *last = line;

	for (int x = 0; x < r->width; x += 2) {
		const char *name = r->name[(y / 4) * (r->width / 2) + x / 2];
		int dots = 0;

		for (int i = 0; i < 8 && *name == '\0'; i++)
			if (is_set(r, x + i % 2, y + i / 2))
				dots |= bit[i];
		if (*name != '\0') {
			at = stpcpy(at, name);
		} else { /* U+2800 and the bits */
			*at++ = (char)0xe2;
			*at++ = (char)(0xa0 + dots / 64);
			*at++ = (char)(0x80 + dots % 64);
		}
		if (dots != 0 || *name != '\0')
			last = at;
	}
	*last++ = '\n';
	output_write(line, (size_t)(last - line));
}

static void draw_items(struct raster *r)
{
	const struct picture *p = r->picture;
	double least = HUGE_VAL, most = -HUGE_VAL;

	for (size_t i = 0; i < p->faces; i++) {
		fill(r, &p->face[i]);
		least = fmin(least, distance_of_z(r, p->face[i].low[2]));
		most = fmax(most, distance_of_z(r, p->face[i].high[2]));
	}
	r->depth = 0.1 * (most - least);
	for (size_t i = 0; i < p->segments; i++)
		if (ink_segment(r, &p->segment[i]))
			put_name(r, &p->segment[i]);
}

void braille_print(const struct picture *p, int columns)
{
	struct raster r = { .picture = p, .width = 2 * columns };
	const double rows = ceil(p->height / p->width * columns / 2);

	r.height = 4 * (rows < 1 ? 1 : clamp(rows, ROWS_MAX));
	r.scale = fmin(r.width / p->width, 4 * ROWS_MAX / p->height);
	const size_t dots = (size_t)r.width * (size_t)r.height;

	r.cell = memset(xrealloc(NULL, dots * sizeof *r.cell), 0,
	    dots * sizeof *r.cell);
	r.name = memset(xrealloc(NULL, dots / 8 * sizeof *r.name), 0,
	    dots / 8 * sizeof *r.name);
	draw_items(&r);
	for (int y = 0; y < r.height; y += 4)
		print_row(&r, y);
	free(r.cell);
	free(r.name);
}

int braille_columns(void)
{
#ifdef TIOCGWINSZ
	struct winsize size;

	if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
		return size.ws_col < COLUMNS_MAX ? size.ws_col : COLUMNS_MAX;
#endif
	return 80;
}
