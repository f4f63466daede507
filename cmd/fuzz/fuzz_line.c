/* SPDX-License-Identifier: MIT */
/* Reads any bytes as lines of points, for libFuzzer. A line that was read must be
 * written within its room, as one line, and must read back as the same numbers. */
#define _GNU_SOURCE /* memmem */
#include <cjson/cJSON.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../message/message.h"
#include "layout.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Must not be called, as reading a line takes no memory. */
void *xrealloc(void *old, size_t size)
{
	(void)old, (void)size;
	abort();
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

/* Returns whether the output can be read by the same layout. If coordinates are added
 * or left out, the fields after them change their numbers, and --columns would find
 * other fields. */
static bool can_read_back(const struct layout *l)
{
	return !format_is_binary(l->out.format) &&
	    (l->columns.n == 0 || !same_dialect(l->in, l->out) ||
		(l->reads == l->writes && !l->output.flags));
}

static void check_back(const struct layout *l, const double v[], struct span text,
    bool has_bom)
{
	struct layout back = *l;
	struct line line = { 0 };
	double read[4];
	char reason[REASON_MAX];
	bool first = has_bom && skip_bom(text.s, text.end) > text.s;
	enum next_part header = first ? FIRST_LINE : FIRST_NONE;

	for (int i = 0; i < back.columns.n && l->in.format == FORMAT_CSV; i++)
		back.columns.name[i] = NULL;
	back.columns.by_default = false;
	back.header = HEADER_NONE;
	back.seen.header_fields = 0; /* the header of the output has more names */
	back.in = l->out;
	back.reads = l->writes > 4 ? 3 : l->writes;
	if (!same_dialect(l->in, l->out))
		back.columns.n = 0;
	line_read(&back, text, &header, &line, read, reason);
	/* a member that an object has twice is refused only if it is a coordinate */
	if (line.object && strncmp(reason, "has two", 7) == 0)
		return;
	/* text can't quote a field of csv that begins with a comma */
	if (format_of(back.in)->blanks && l->in.format == FORMAT_CSV &&
	    strncmp(reason, "has commas", 10) == 0)
		return;
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
	static const struct flags flags = { "left+near", 9 };
	static const struct number_text none = { .layout = 0 };
	double v[COORDINATES_MAX] = { (double)NAN, -1.25e-7, 1e150, 0, -7, 1e-320 };
	const struct image_numbers numbers = { v, &none, 1, 0 };
	size_t room = splice_room(l, 1, line->size);
	char *out = malloc(room), *end;

	if (out == NULL)
		return;
	for (int i = 0; line->kind == LINE_POINT && i < l->reads && i < 3; i++)
		v[i] = i == 1 ? -read[i] : read[i];
	end = splice_line(l, line, &numbers, l->output.flags ? &flags : NULL, out);
	want((size_t)(end - out) <= room);
	struct span text = { out, end };

	if (line->newline && end > out)
		text.end--;
	want(memchr(text.s, '\n', (size_t)(text.end - text.s)) == NULL);
	if (l->out.format == FORMAT_JSON && end > out)
		check_json(text);
	if (line->kind == LINE_POINT && can_read_back(l))
		check_back(l, v, text, line->has_bom);
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

static void check_line(struct layout *l, struct span text, const char *end,
    enum next_part *header)
{
	char reason[REASON_MAX] = "";
	struct line line = { 0 };
	double v[4];

	line_read(l, text, header, &line, v, reason);
	line.newline = text.end < end;
	if (line.kind == LINE_POINT)
		check_spans(l, &line, text);
	if (line_is_bad(&line))
		want(*reason != '\0' && strchr(reason, '\n') == NULL);
	if (line.kind != LINE_REFUSED)
		write_back(l, &line, v);
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

	if (format_is_binary(l.in.format) || format_is_binary(l.out.format))
		return 0;
	/* no more room after the text than may be read, so that a sanitizer finds the
	 * rest */
	char *text = malloc(size - HEADER + LINE_MARGIN), *end = text + size - HEADER;

	memcpy(text, data + HEADER, size - HEADER);
	for (const char *s = text; s < end;) {
		struct span line = { s, line_end(s, end) };

		check_line(&l, line, end, &header);
		s = line.end + (line.end < end);
	}
	free(text);
	return 0;
}
