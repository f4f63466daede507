/* SPDX-License-Identifier: MIT */
/* Reads any bytes as lines of points, for libFuzzer. A line that was read must be
 * written within its room, as one line, and must read back as the same numbers. */
#define _GNU_SOURCE /* memmem */
#include <cjson/cJSON.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../message/message.h"
#include "layout.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Only a header takes memory, once. */
void *xrealloc(void *old, size_t size)
{
	if (old != NULL)
		abort();
	return malloc(size > 0 ? size : 1);
}

static void want(bool so)
{
	if (!so)
		abort();
}

static bool same(double a, double b)
{
	return a == b || (isnan(a) && isnan(b));
}

/* Returns whether the numbers of the output are found where the plan has them. */
static bool can_read_back(const struct layout *l)
{
	for (int i = 0; i < l->reads && same_dialect(l->in, l->out); i++)
		if (l->plan.field[i] != i || l->plan.in_space)
			return false;
	return true;
}

static void check_back(const struct layout *l, const double v[], struct span text)
{
	enum next_part first = FIRST_NONE;
	struct layout back = *l;
	struct line line = { 0 };
	struct refusal r;
	double read[4];

	back.in = l->out;
	back.header = HEADER_NONE;
	back.output = (struct output){ 0 };
	back.plan.has_header = false;
	back.plan.fields = 0;
	back.reads = l->writes > 4 ? 3 : l->writes;
	if (!same_dialect(l->in, l->out) || !layout_has_names(l))
		back.columns.n = 0;
	for (int i = 0; i < back.reads; i++) {
		back.plan.field[i] = i;
		if (i >= l->reads || back.columns.n > 0)
			strcpy(back.plan.member[i], l->output.name[i]);
	}
	back.columns.n = 0;
	text.s = skip_bom(text.s, text.end);
	plan_line(&back, text, &first, &line, read, &r);
	/* text that is no comment can begin with # only where x is not first */
	want(line.kind == LINE_POINT);
	for (int i = 0; i < back.reads; i++)
		want(l->output.style[i].kind != NUMBER_SHORTEST || same(read[i], v[i]));
}

/* Checks that cJSON reads the text, too, unless the text has half of a surrogate pair
 * or \u0000, which cJSON refuses. */
static void check_json(struct span text)
{
	size_t n = (size_t)(text.end - text.s);
	cJSON *json = cJSON_ParseWithLength(text.s, n);

	want(json != NULL || memmem(text.s, n, "\\u", 2) != NULL);
	want(json == NULL || cJSON_IsArray(json) || cJSON_IsObject(json));
	cJSON_Delete(json);
}

static void write_back(const struct layout *l, const struct line *line,
    const double read[])
{
	static const unsigned char outside = 17;
	static double image[COORDINATES_MAX][POINTS_BLOCK];
	static struct flag_words words;
	double v[COORDINATES_MAX] = { (double)NAN, -1.25e-7, 1e150, 0, -7, 1e-320 };
	const struct emit_block block = { .line = line,
		.lines = 1,
		.points = 1,
		.image = (const double(*)[POINTS_BLOCK])image,
		.outside = &outside,
		.words = &words };
	size_t room = emit_room(l, 1, line->size);
	char *out = malloc(room), *end;

	if (out == NULL)
		return;
	for (int i = 0; line->kind == LINE_POINT && i < l->reads && i < 3; i++)
		v[i] = i == 1 ? -read[i] : read[i];
	for (int i = 0; i < COORDINATES_MAX; i++)
		image[i][0] = v[i];
	end = emit_lines(l, &block, out);
	want((size_t)(end - out) <= room);
	struct span text = { out, end };

	if (line->newline && end > out)
		text.end--;
	want(memchr(text.s, '\n', (size_t)(text.end - text.s)) == NULL);
	if (l->out.format == FORMAT_JSON && end > out)
		check_json(text);
	if (line->kind == LINE_POINT && can_read_back(l))
		check_back(l, v, text);
	free(out);
}

static void check_spans(const struct layout *l, const struct line *line,
    struct span text)
{
	for (int i = 0; i < l->reads; i++) {
		want(line->at[i].from <= line->at[i].to);
		want(text.s + line->at[i].to <= text.end);
	}
}

/* Returns false if the source ends with the line, as it is refused. */
static bool check_line(struct layout *l, struct span text, const char *end,
    enum next_part *header)
{
	struct refusal r = { .what = "" };
	struct line line = { 0 };
	double v[4];

	plan_line(l, text, header, &line, v, &r);
	line.newline = text.end < end;
	if (line.kind == LINE_POINT)
		check_spans(l, &line, text);
	if (line_is_bad(&line))
		want(*r.what != '\0' && strpbrk(r.what, "\n") == NULL);
	if (line.kind == LINE_REFUSED)
		return false;
	write_back(l, &line, v);
	return true;
}

/* Returns the end of the line at s: its newline, or end. */
static const char *line_end(const char *s, const char *end)
{
	const char *newline = memchr(s, '\n', (size_t)(end - s));

	return newline != NULL ? newline : end;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	enum next_part header = FIRST_LINE;

	if (size < HEADER)
		return 0;
	struct layout l = layout_of(data);

	if (format_is_binary(l.in.format) || format_is_binary(l.out.format) ||
	    l.in.format == FORMAT_SNIFF)
		return 0;
	kernels_choose("baseline");
	plan_begin(&l);
	/* no more room after the text than may be read, so that a sanitizer finds the
	 * rest */
	char *text = malloc(size - HEADER + LINE_MARGIN), *end = text + size - HEADER;

	memcpy(text, data + HEADER, size - HEADER);
	for (const char *s = text; s < end;) {
		struct span line = { s, line_end(s, end) };

		if (!check_line(&l, line, end, &header))
			break;
		s = line.end + (line.end < end);
	}
	free(l.common.text);
	free(text);
	return 0;
}
