/* SPDX-License-Identifier: MIT */
/* Most points are written in special ways. They give the same bytes as the general way,
 * by which every line can be written. */
#include "random.h"

#include "../table/emit.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

#include "../../core/points/kernel/kernel.h"

enum { LINES = 200, ROOM = 1 << 17 };

static const char *const blanks[] = { " ", " ", " ", "  ", "\t", "   " };
static const char *const commas[] = { ",", ",", ",", " ,", ", ", "," };

static const char *pick_of(const char *const *list, int n)
{
	return list[random_below(n)];
}

/* Writes a field of csv or another format: a number, some of csv in quotes. */
static int put_random_number(char *s, bool csv)
{
	const int v = random_below(20000) - 10000;
	const bool quoted = csv && random_below(8) == 0;

	return sprintf(s, quoted ? "\"%d.%02d\"" : "%d.%02d", v, random_below(100));
}

/* Writes a line of n numbers and, mostly, a label. */
static int put_random_line(char *s, enum format f, int n)
{
	const bool json = f == FORMAT_JSON, object = json && random_below(2) == 0;
	const bool csv = f == FORMAT_CSV;
	char *const start = s;

	s += sprintf(s, "%s", random_below(5) == 0 && !csv ? " " : "");
	s += sprintf(s, "%s", f == FORMAT_OBJ ? "v " : object ? "{" : json ? "[" : "");
	for (int i = 0; i < n; i++) {
		if (i > 0)
			s += sprintf(s, "%s",
			    csv || json ? pick_of(commas, 6) : pick_of(blanks, 6));
		if (object)
			s += sprintf(s, "\"%c\":", "xyzw"[i]);
		s += put_random_number(s, csv);
	}
	if (csv || random_below(3) == 0)
		s += sprintf(s, "%s%s\"a\"", csv || json ? "," : " ",
		    object ? "\"n\": " : "");
	s += sprintf(s, "%s", object ? "}" : json ? "]" : "");
	return (int)(s - start) +
	    sprintf(s, "%s",
		random_below(5) == 0     ? " " :
		    random_below(5) == 0 ? "\r" :
					   "");
}

/* Compares both ways for lines of a layout. */
static void check_layout(struct layout *l)
{
	static char text[ROOM], special[4 * ROOM], general[4 * ROOM];
	static double image[COORDINATES_MAX][POINTS_BLOCK];
	static struct flag_words words;
	static struct line line[LINES];
	unsigned char outside[LINES];
	enum next_part first = FIRST_LINE;
	struct emit_block b = { .line = line,
		.lines = LINES,
		.points = LINES,
		.image = (const double(*)[POINTS_BLOCK])image,
		.outside = outside,
		.words = &words };
	char *s = text;
	struct refusal r;
	double v[4];

	plan_begin(l);
	for (int i = 0; i < LINES; i++) {
		const int n = put_random_line(s, l->in.format, 4);

		plan_line(l, (struct span){ s, s + n }, &first, &line[i], v, &r);
		line[i].newline = true;
		assert_int_equal(line[i].kind, LINE_POINT);
		s += n + 1;
		outside[i] = (unsigned char)random_below(64);
		for (int k = 0; k < COORDINATES_MAX; k++)
			image[k][i] = random_below(40) == 0 ?
			    (double)NAN :
			    ((double)random_below(1000000) - 500000) / 64;
	}
	const char *end = emit_lines(l, &b, special);

	b.general = true;
	assert_int_equal(emit_lines(l, &b, general) - general, end - special);
	assert_memory_equal(special, general, (size_t)(end - special));
	assert_true((size_t)(end - special) <= emit_room(l, LINES, (size_t)(s - text)));
}

static void ways_agree(void **state)
{
	static const enum format formats[] = { FORMAT_TEXT, FORMAT_CSV, FORMAT_JSON,
		FORMAT_OBJ };
	static const int sizes[][2] = { { 3, 3 }, { 3, 4 }, { 4, 3 }, { 2, 2 },
		{ 2, 6 }, { 4, 4 } };
	static const int fields[][4] = { { 0, 1, 2, 3 }, { 2, 0, 1, 3 },
		{ 3, 1, 0, 2 } };

	(void)state;
	kernels_choose(NULL);
	for (unsigned k = 0; k < 4 * 6 * 3 * 8; k++) {
		const enum format f = formats[k % 4];
		const int *size = sizes[k / 4 % 6];
		struct layout l = { .in = dialect_of(f, ','),
			.out = dialect_of(f, ','),
			.header = HEADER_NONE,
			.reads = size[0],
			.writes = size[1],
			.output = { .append = k & 128, .flags = k & 256 } };

		if (k & 512)
			l.out = dialect_of(formats[(k + 1) % 4], ',');
		l.output.append &= same_dialect(l.in, l.out);
		for (int i = 0; i < l.writes; i++)
			sprintf(l.output.name[i], "%s%c", l.output.append ? "a_" : "",
			    "xyzwvu"[i]);
		strcpy(l.output.name[COORDINATES_MAX], l.output.flags ? "flags" : "");
		/* objects have names; w is there, and can't be added */
		l.columns.n = k / 24 % 3 > 0 && f != FORMAT_JSON ? l.reads : 0;
		memcpy(l.columns.field, fields[k / 24 % 3], sizeof l.columns.field);
		if (f == FORMAT_JSON && !l.output.append && l.writes > l.reads)
			continue;
		check_layout(&l);
	}
}

/* Returns the nanoseconds that a line takes. */
static double time_of(const struct layout *l, const struct emit_block *b, char *out)
{
	enum { TIMES = 4000 };
	const clock_t begin = clock();

	for (int i = 0; i < TIMES; i++)
		emit_lines(l, b, out);
	const double calls = (double)(TIMES * LINES);

	return 1e9 * (double)(clock() - begin) / CLOCKS_PER_SEC / calls;
}

/* Prints how long lines of three numbers take both ways. */
static void print_gain(enum format f, bool append)
{
	static char text[ROOM], out[4 * ROOM];
	static double image[COORDINATES_MAX][POINTS_BLOCK];
	static struct flag_words words;
	static struct line line[LINES];
	const struct format_row *row = &format_rows[f];
	const char c = dialect_of(f, ',').separator;
	enum next_part first = FIRST_LINE;
	struct layout l = { .in = dialect_of(f, ','),
		.out = dialect_of(f, ','),
		.header = HEADER_NONE,
		.reads = 3,
		.writes = 3,
		.output = { .append = append } };
	struct emit_block b = { .line = line,
		.lines = LINES,
		.points = LINES,
		.image = (const double(*)[POINTS_BLOCK])image,
		.words = &words };
	char *s = text;
	struct refusal r;
	double v[4];

	plan_begin(&l);
	for (int i = 0; i < LINES; i++) {
		const int n = sprintf(s, "%s%d.%06d%c%d.%06d%c%d.%06d%s", row->open,
		    random_below(2000) - 1000, random_below(1000000), c,
		    random_below(2000) - 1000, random_below(1000000), c,
		    random_below(2000), random_below(1000000), row->close);

		plan_line(&l, (struct span){ s, s + n }, &first, &line[i], v, &r);
		line[i].newline = true;
		s += n + 1;
		for (int k = 0; k < 3; k++)
			image[k][i] = (double)random_below(1000000) / 977;
	}
	const double special = time_of(&l, &b, out);

	b.general = true;
	const double general = time_of(&l, &b, out);

	printf("%s%s: %.0f ns a line, %.1f times as long in the general way\n",
	    format_names[f], append ? " --append" : "", special, general / special);
}

int main(int argc, char **argv)
{
	static const enum format formats[] = { FORMAT_TEXT, FORMAT_CSV, FORMAT_JSON };
	const struct CMUnitTest tests[] = { cmocka_unit_test(ways_agree) };

	if (argc > 1 && strcmp(argv[1], "gain") == 0) {
		kernels_choose(NULL);
		for (int i = 0; i < 6; i++)
			print_gain(formats[i % 3], i >= 3);
		return 0;
	}
	return cmocka_run_group_tests(tests, NULL, NULL);
}
