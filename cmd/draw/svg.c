/* SPDX-License-Identifier: MIT */
/* The pictures become texts, which svg_print puts into one, as its first line tells the
 * extent of all. x is that of the device, and y, too, if it counts from the top; else y
 * is mirrored. */
#include "svg.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../number/number.h"
#include "../message/grow.h"

struct drawn {
	struct frame frame;
	size_t end; /* of its bytes in the text, which follow those before */
};

static struct svg {
	char *text;
	size_t size;
	struct drawn *drawn;
	size_t n;
	double unit;      /* numbers are rounded to multiples of 1 / unit */
	char *background; /* the address of an image element; or NULL */
} svg;

static void put_bytes(const char *s, size_t n)
{
	GROW(svg.text, svg.size, n);
	memcpy(svg.text + svg.size, s, n);
	svg.size += n;
}

static void put_number(double v)
{
	char number[NUMBER_MAX];
	const double units = v * svg.unit;
	/* from 2^53 on there are no digits to round */
	const double rounded = fabs(units) < 0x1p53 ? round(units) / svg.unit : v;
	const char *end = number_write(number, rounded,
	    (struct number_style){ NUMBER_SHORTEST, 0 });

	put_bytes(number, (size_t)(end - number));
}

/* Puts a text, in which each % stands for the next double. */
static void put(const char *s, ...)
{
	va_list numbers;

	va_start(numbers, s);
	for (const char *at; (at = strchr(s, '%')) != NULL; s = at + 1) {
		put_bytes(s, (size_t)(at - s));
		put_number(va_arg(numbers, double));
	}
	va_end(numbers);
	put_bytes(s, strlen(s));
}

/* Rounds the next numbers so that they change by at most 1e-5 of a size. */
static void round_by(double size)
{
	svg.unit = pow(10, ceil(-log10(2e-5 * size)));
}

/* Puts a text whose two % stand for a place. */
static void put_place(const struct frame *f, const char *s, const double at[3])
{
	put(s, f->x + at[0] * frame_size(f), f->y + at[1] * frame_size(f));
}

/* Puts a text of XML, with U+FFFD for what XML or UTF-8 lacks. */
static void put_escaped(struct span name)
{
	for (const char *s = name.s; s < name.end;) {
		unsigned code = 0;
		const int n = utf8_read(s, name.end, &code);

		if (n == 0 || (code < ' ' && code != '\t') || (code & 0xfffe) == 0xfffe)
			put("\xef\xbf\xbd");
		else if (code == '<' || code == '&' || code == '>')
			put(code == '<' ? "&lt;" : code == '>' ? "&gt;" : "&amp;");
		else
			put_bytes(s, (size_t)n);
		s += n > 0 ? n : 1;
	}
}

static const char *const classes[STROKES] = { "edge", "line", "dot" };

/* The size of names, in a picture of 640 units. */
static const double type_size = 13;

/* Puts the path of a stroke; a segment goes on where the one before ended. */
static void put_path(const struct picture *p, const struct frame *f, enum stroke stroke)
{
	const double *last = NULL;

	for (size_t i = 0; i < p->segments; i++) {
		const struct segment *s = &p->segment[i];

		if (s->stroke != stroke)
			continue;
		if (last == NULL || memcmp(last, s->end[0], 2 * sizeof *last) != 0)
			put_place(f, "\nM% %", s->end[0]);
		if (stroke == STROKE_DOT) {
			put("h0");
		} else {
			put_place(f, "L% %", s->end[1]);
			last = s->end[1];
		}
	}
}

/* Returns whether a name stands to the left of its dot: it has more room there, and
 * would be cut off at the right, with 0.6 of the type's size for a character. If there
 * are several pictures, the type may be larger. */
static bool stands_left(const struct picture *p, const struct segment *dot)
{
	const double size = type_size / 640, x = dot->end[0][0];
	int n = 0;

	for (const char *s = dot->name.s; s < dot->name.end; s++)
		n += (*s & 0xc0) != 0x80; /* no further byte of UTF-8 */
	return x > 0.5 * p->width && x + size * (0.5 + 0.6 * n) > p->width;
}

static void put_names(const struct picture *p, const struct frame *f)
{
	for (size_t i = 0; i < p->segments; i++) {
		const struct segment *dot = &p->segment[i];

		if (dot->name.s == dot->name.end)
			continue;
		put_place(f, "<text x=\"%\" y=\"%\" dx=\"", dot->end[0]);
		put(stands_left(p, dot) ? "-.5em\" text-anchor=\"end" : ".5em");
		put("\" dy=\"-.2em\">");
		put_escaped(dot->name);
		put("</text>\n");
	}
}

/* Puts the attributes of a rectangle whose top is at y. */
static void put_box(const struct frame *f, double y)
{
	put(" x=\"%\" y=\"%\" width=\"%\" height=\"%\"", f->x, y, f->width, f->height);
}

/* Over a background each path is drawn twice: light and wide, then dark. */
static void put_stroke(const struct picture *p, const struct frame *f,
    enum stroke stroke)
{
	const bool photo = svg.background != NULL;
	const char *name = classes[stroke];
	const size_t before = svg.size;
	char begin[64], use[128];

	snprintf(begin, sizeof begin,
	    photo ? "<defs><path id=\"%s%zu\" d=\"" : "<path class=\"%s\" d=\"", name,
	    svg.n);
	put(begin);
	const size_t empty = svg.size;

	put_path(p, f, stroke);
	if (svg.size == empty) {
		svg.size = before;
		return;
	}
	put("\"/>\n");
	if (!photo)
		return;
	snprintf(use, sizeof use,
	    "</defs><g class=\"halo\"><use class=\"%s\" href=\"#%s%zu\"/></g>\n"
	    "<use class=\"%s\" href=\"#%s%zu\"/>\n",
	    name, name, svg.n, name, name, svg.n);
	put(use);
}

void svg_add(const struct picture *p, const struct frame *f)
{
	round_by(frame_size(f));
	if (svg.background != NULL) {
		put("<image preserveAspectRatio=\"none\"");
		put_box(f, f->y);
		put(" href=\"");
		put(svg.background);
		put("\"/>\n");
	}
	for (enum stroke k = 0; k < STROKES; k++)
		put_stroke(p, f, k);
	put_names(p, f);
	GROW(svg.drawn, svg.n, 1);
	svg.drawn[svg.n++] = (struct drawn){ *f, svg.size };
}

/* Writes the characters of base64 (RFC 4648) for the bytes. Returns their end. */
static char *write_base64(char *out, const unsigned char *s, size_t n)
{
	static const char digit[] =
	    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

	for (size_t i = 0; i < n; i += 3) {
		const unsigned b = (unsigned)s[i] << 16 |
		    (i + 1 < n ? (unsigned)s[i + 1] << 8 : 0) |
		    (i + 2 < n ? (unsigned)s[i + 2] : 0);

		*out++ = digit[b >> 18];
		*out++ = digit[b >> 12 & 63];
		*out++ = i + 1 < n ? digit[b >> 6 & 63] : '=';
		*out++ = i + 2 < n ? digit[b & 63] : '=';
	}
	return out;
}

bool svg_set_background(struct span file, struct refusal *r)
{
	static const char png[] = "\x89PNG\r\n\x1a\n", jpeg[] = "\xff\xd8\xff";
	const size_t n = (size_t)(file.end - file.s);
	const bool is_png = n > 8 && memcmp(file.s, png, 8) == 0;
	char *at;

	if (!is_png && !(n > 3 && memcmp(file.s, jpeg, 3) == 0)) {
		refusal_set(r, NULL, "is neither a PNG nor a JPEG picture",
		    "convert it to one");
		return false;
	}
	svg.background = at = xrealloc(NULL, n / 3 * 4 + 64);
	at = stpcpy(at, is_png ? "data:image/png;base64," : "data:image/jpeg;base64,");
	*write_base64(at, (const unsigned char *)file.s, n) = '\0';
	return true;
}

/* Puts the style. Widths are of a picture of 640 units. Without a background the
 * colours are those of a light page or of a dark one. */
static void put_style(double size)
{
	const bool photo = svg.background != NULL;
	const double width = size / 640;

	put("<style>\nsvg{color:#1b1b1f");
	put(photo ? "}\n" : ";color-scheme:light dark}\n");
	put(".edge,.line,.dot{fill:none;stroke-linecap:round;stroke-linejoin:round}\n"
	    ".edge{stroke:currentColor;stroke-width:%}\n"
	    ".line{stroke:#1769c4;stroke-width:%}\n"
	    ".dot{stroke:#d8342c;stroke-width:%}\n"
	    "text{fill:currentColor;font:%px sans-serif}\n",
	    0.8 * width, 1.5 * width, 5 * width, type_size * width);
	if (photo)
		put(".halo *{stroke:#fff;stroke-opacity:.75}\n"
		    ".halo .edge{stroke-width:%}\n.halo .line{stroke-width:%}\n"
		    ".halo .dot{stroke-width:%}\n"
		    "text{paint-order:stroke;stroke:#fff;stroke-width:%}\n",
		    3 * width, 4 * width, 8 * width, 3 * width);
	else
		put("@media(prefers-color-scheme:dark){svg{color:#e6e6ea}"
		    ".line{stroke:#6cb2ff}.dot{stroke:#ff7a70}}\n");
	put("</style>\n");
}

/* Returns the rectangle that holds all frames. */
static struct frame frames_hull(void)
{
	struct frame f = svg.drawn[0].frame;
	double right = f.x + f.width, bottom = f.y + f.height;

	for (size_t i = 1; i < svg.n; i++) {
		const struct frame *g = &svg.drawn[i].frame;

		f.x = fmin(f.x, g->x);
		f.y = fmin(f.y, g->y);
		right = fmax(right, g->x + g->width);
		bottom = fmax(bottom, g->y + g->height);
	}
	f.width = right - f.x;
	f.height = bottom - f.y;
	return f;
}

static void put_view_box(const struct frame *f)
{
	put(" viewBox=\"% % % %\"", f->x, f->y, f->width, f->height);
}

/* Puts the first line. Pixels are the units of the viewport, unless they would be too
 * few or too many to look at. */
static void put_head(const struct frame *hull)
{
	const double size = frame_size(hull);
	const double pixels = size >= 100 && size <= 10000 ? 1 : 640 / size;

	round_by(size);
	put("<svg xmlns=\"http://www.w3.org/2000/svg\"");
	put_view_box(hull);
	svg.unit = 1000;
	put(" width=\"%\" height=\"%\">\n", hull->width * pixels,
	    hull->height * pixels);
	round_by(size / 1000);
	put_style(size);
	round_by(size);
}

/* Writes the text from here on, and forgets it. */
static void flush(size_t from)
{
	output_write(svg.text + from, svg.size - from);
	svg.size = from;
}

void svg_print(void)
{
	const size_t end = svg.size;
	size_t from = 0;

	if (svg.n == 0)
		return;
	const struct frame hull = frames_hull();

	put_head(&hull);
	for (size_t i = 0; i < svg.n; from = svg.drawn[i++].end) {
		const struct frame *f = &svg.drawn[i].frame;
		const double mirrored = 2 * hull.y + hull.height - f->y - f->height;

		if (svg.n > 1) {
			put("<svg");
			put_box(f, f->from_bottom ? mirrored : f->y);
			put_view_box(f);
			put(">\n");
		}
		flush(end);
		output_write(svg.text + from, svg.drawn[i].end - from);
		if (svg.n > 1)
			put("</svg>\n");
	}
	put("</svg>\n");
	flush(end);
	svg.size = svg.n = 0;
}
