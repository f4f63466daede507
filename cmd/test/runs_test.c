/* SPDX-License-Identifier: MIT */
/* Runs of points end where they should, with the rest of each line as its name, in
 * every format. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>

#include "../stream/runs.h"
#include "../stream/stream.h"

/* What came: x of each point, its name in parentheses, and | after each run. */
static char came[1 << 12];
static size_t size;

static void take(void *data, const struct run *run)
{
	(void)data;
	for (size_t i = 0; i < run->n; i++) {
		const struct run_point *p = &run->point[i];

		size += (size_t)sprintf(came + size, "%g(%.*s) ", p->in[0],
		    (int)p->name_size, run->names + p->name);
		assert_true(p->image[0] == p->in[0] && p->image[1] == p->in[1]);
		assert_int_equal(p->outside, p->in[0] > 1 ? OUT_RIGHT : 0);
	}
	size += (size_t)sprintf(came + size, "|");
}

static const struct {
	enum format format;
	const char *text, *wanted;
} cases[] = {
	{ FORMAT_TEXT, "0 0 0\n1 0 0 a b \n\n2 0 0\tc\n", "0() 1(a b) |2(c) |" },
	{ FORMAT_TEXT, "# d\nx y z n\n0 0 0 A\n# e\n1 0 0 B\n", "0(A) 1(B) |" },
	{ FORMAT_TEXT, "0 0 0 a\nNA 0 0 b\n1 0 0 c\nnan 1 1\n\n\n2 0 0",
	    "0(a) |1(c) |2() |" },
	{ FORMAT_TEXT, "0 0 0\r\n \r\n1 0 0 a\r\n", "0() |1(a) |" },
	{ FORMAT_CSV, "0,0,0,a b\n1,0,0, \"c, d\" \n\n2,0,0,\n",
	    "0(a b) 1(\"c, d\") |2() |" },
	{ FORMAT_CSV, "\"0\",\"0\",\"0\",a\n1,0,0,b\n", "0(a) 1(b) |" },
	{ FORMAT_CSV, "n,x,y,z,m\na,0,0,0,\n\"b c\",\"1\",0,0,\nd,2,0,0,e\n",
	    "0(a) 1(\"b c\") 2(d e) |" },
	{ FORMAT_TEXT, "n x y z\nA 0 0 0\n B  1 0 0\n", "0(A) 1(B) |" },
	{ FORMAT_TSV, "0\t0\t0\ta b\n\n1\t0\t0\tc\n", "0(a b) |1(c) |" },
	{ FORMAT_JSON,
	    "[0,0,0]\n[1, 0, 0 , \"a]\"]\n\n{\"x\":2,\"y\":0,\"z\":0,\"n\":\"b\"}\n",
	    "0() 1(\"a]\") |2(\"n\":\"b\") |" },
	{ FORMAT_JSON, "[[0,0,0],\n\n[1,0,0]]\n", "0() 1() |" },
	{ FORMAT_OBJ, "v 0 0 0\nvn 1 1 1\nv 1 0 0 a\n\nv 2 0 0\nf 1 2 3\n",
	    "0() 1(a) |2() |" },
};

static void runs_and_names_are_right(void **state)
{
	static struct run_reader reader = { take, .names = true };
	static struct scene scene;
	static struct job j;

	(void)state;
	map_identity(&j.transform.map);
	transform_init(&j.transform, SPACE_VIEW, SPACE_VIEW, false);
	assert_true(frustum_of(&scene, SPACE_VIEW, false, &j.frustum, NULL));
	runs_prepare(&reader, &j);
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
		static char text[1 << 10];
		struct point_source s;
		struct refusal r;

		strcpy(text, cases[i].text);
		s = source_of_text("test", text, strlen(text));
		j.layout = (struct layout){ .in = dialect_of(cases[i].format, ','),
			.reads = 3,
			.writes = 3 };
		size = 0;
		assert_true(source_begin(&s, &j.layout, &r));
		stream_points(&j, s);
		assert_string_equal(came, cases[i].wanted);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(runs_and_names_are_right),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
