/* Any bytes as lines of points, for libFuzzer: what is read is written within
 * its room, is a line, and reads back as the same numbers. */
#define _GNU_SOURCE /* memmem */
#include <cjson/cJSON.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "layout.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void want(bool so)
{
	if (!so)
		abort();
}

static bool same(double a, double b)
{
	return a == b || (isnan(a) && isnan(b));
}

/* Where coordinates are added or left out, the fields behind them change their
 * numbers, so that --columns would find others. */
static bool can_read_back(const struct layout *l)
{
	return l->out <= FORMAT_JSON &&
	    (l->columns.n == 0 || l->in != l->out ||
		(l->reads == l->writes && !l->flags));
}

static void check_back(const struct layout *l, const double v[],
    struct span line)
{
	struct layout back = *l;
	struct line r = { 0 };
	double read[4];
	char reason[REASON_MAX];
	bool header = true; /* a byte order mark may stand before the first */

	for (int i = 0; i < back.columns.n; i++)
		back.columns.name[i] = NULL;
	back.in = l->out;
	back.reads = l->writes < 4 ? l->writes : 4;
	if (l->in != l->out)
		back.columns.n = 0;
	line_read(&back, line, line.end, &header, &r, read, reason);
	want(r.kind == LINE_POINT);
	for (int i = 0; i < back.reads; i++)
		want(l->style.kind != NUMBER_SHORTEST || same(read[i], v[i]));
}

/* cJSON refuses half of a surrogate pair and \u0000; lines may hold them. */
static void check_json(struct span line)
{
	size_t n = (size_t)(line.end - line.s);
	cJSON *array = cJSON_ParseWithLength(line.s, n);

	want(array != NULL || memmem(line.s, n, "\\u", 2) != NULL);
	want(array == NULL || cJSON_IsArray(array));
	cJSON_Delete(array);
}

static void write_back(const struct layout *l, const struct line *r,
    const double read[])
{
	const char *flags = l->flags ? "left+near" : NULL;
	double v[COORDINATES_MAX] = { (double)NAN, -1.25e-7, 1e150, 0, -7,
		1e-320 };
	size_t room = line_room(l, r);
	char *out = malloc(room), *end;

	for (int i = 0; r->kind == LINE_POINT && i < l->reads && i < 3; i++)
		v[i] = i == 1 ? -read[i] : read[i];
	end = line_write(l, r, v, flags, out);
	want((size_t)(end - out) <= room);
	struct span line = { out, end };

	if (r->newline && end > out)
		line.end--;
	want(memchr(line.s, '\n', (size_t)(line.end - line.s)) == NULL);
	if (l->out == FORMAT_JSON && end > out)
		check_json(line);
	if (r->kind == LINE_POINT && can_read_back(l))
		check_back(l, v, line);
	free(out);
}

static void check_spans(const struct layout *l, const struct line *r,
    struct span line)
{
	for (int i = 0; i < l->reads; i++) {
		want(line.s <= r->at[i].s && r->at[i].s <= r->at[i].end);
		want(r->at[i].end <= line.end);
	}
}

static void check_line(struct layout *l, struct span line, const char *end,
    bool *header)
{
	char reason[REASON_MAX] = "";
	struct line r = { 0 };
	double v[4];

	line_read(l, line, end, header, &r, v, reason);
	r.newline = line.end < end;
	if (r.kind == LINE_POINT)
		check_spans(l, &r, line);
	if (r.kind == LINE_BAD)
		want(*reason != '\0' && strchr(reason, '\n') == NULL);
	write_back(l, &r, v);
}

/* The end of a line, or of what is there. */
static const char *line_end(const char *s, const char *end)
{
	const char *newline = memchr(s, '\n', (size_t)(end - s));

	return newline != NULL ? newline : end;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	bool header = true;

	if (size < HEADER)
		return 0;
	struct layout l = layout_of(data);

	if (l.in > FORMAT_JSON || l.out > FORMAT_JSON)
		return 0;
	/* exactly as long, so that a byte too far is seen */
	char *text = malloc(size - HEADER), *end = text + size - HEADER;

	memcpy(text, data + HEADER, size - HEADER);
	for (const char *s = text; s < end;) {
		struct span line = { s, line_end(s, end) };

		check_line(&l, line, end, &header);
		s = line.end + (line.end < end);
	}
	free(text);
	return 0;
}
