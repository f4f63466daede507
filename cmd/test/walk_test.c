/* SPDX-License-Identifier: MIT */
/* walk_lines finds the numbers on lines of the usual form, and leaves other lines to
 * cursors, which take more time. These tests say which lines are left, and where the
 * numbers are on the others. */
#include "../../core/points/transform.h"
#include "../table/plan.h"

#include <stdio.h>

#include "../../core/test/numbers.h"

/* A line, and its numbers with a bar after each, or NULL if walk_lines leaves the
 * line. */
struct example {
	const char *line, *numbers;
};

#define A_NUMBER "1234567890.1234567890123456789012"

#define BLANKS "                              "

static const struct example text[] = {
	{ "1 2 3", "1|2|3|" },
	{ "1,2 3 4", "1,2|3|4|" },
	{ " \t-1\t.5  3.", "-1|.5|3.|" },
	{ "1 2 3 and, more", "1|2|3|" },
	{ "1 2 3\r", "1|2|3|" },
	{ "       1  2   3    ", "1|2|3|" },
	{ "1" BLANKS BLANKS "2 \t " BLANKS " 3", "1|2|3|" },
	{ "1 2", NULL },
	{ "", NULL },
	{ "# 1 2 3", NULL },
	{ A_NUMBER " 2 3", NULL },
	{ "1 2 34567890123456789012345678901234",
	    "1|2|34567890123456789012345678901234|" },
	{ NULL, NULL },
};

static const struct example two_of_text[] = {
	{ "1 2", "1|2|" },
	{ "1 2 3", "1|2|" },
	{ NULL, NULL },
};

/* Below a header of four names. */
static const struct example rows_of_text[] = {
	{ "1 2 3 a", "1|2|3|" },
	{ " 1  2\t3 a,b \r", "1|2|3|" },
	{ "1 2 3", NULL },
	{ "1 2 3 ", NULL },
	{ "1 2 3 a b", NULL },
	{ NULL, NULL },
};

static const struct example obj[] = {
	{ "v 1 2 3", "1|2|3|" },
	{ " v  1 2\t3 1 0 0", "1|2|3|" },
	{ "v", NULL },
	{ "v 1 2", NULL },
	{ "vn 1 2 3", NULL },
	{ "1 2 3", NULL },
	{ "# v 1 2 3", NULL },
	{ NULL, NULL },
};

static const struct example csv[] = {
	{ "1,2,3", "1|2|3|" },
	{ " 1 ,\t2 , 3 ", "1|2|3|" },
	{ "1,2,3,a b,\"c\",\"d, e\"", "1|2|3|" },
	{ "1,2,3,\"c\"\r", "1|2|3|" },
	{ "1 2,3,4", NULL },
	{ "1,2,3,\"c\"\"d\"", NULL },
	{ "1,2,3,5\" pipe", NULL },
	{ "1,2,3,\"c", NULL },
	{ "1,2,\"3\"", "1|2|3|" },
	{ " \"1\" ,\"2\",\"3\"\r", "1|2|3|" },
	{ "1,\" 2\",3", NULL },
	{ "1,\"2,3\",4", NULL },
	{ "1,\"2\"3,4", NULL },
	{ "1,\"2\"\"\",4", NULL },
	{ "1,2,\"3", NULL },
	{ "1,,3", "1||3|" },
	{ ",\"\",", "|||" },
	{ "1, ,3", NULL },
	{ "1,2,\r", NULL },
	{ "x,y,z", "x|y|z|" },
	{ NULL, NULL },
};

/* As the first row has four fields. */
static const struct example rows_of_csv[] = {
	{ "1,2,3,a", "1|2|3|" },
	{ "1,2,3,", "1|2|3|" },
	{ "1,2,3,a,", "1|2|3|" },
	{ "1,2,3,,", "1|2|3|" },
	{ "1,2,3", NULL },
	{ "1,2,3,a,b", NULL },
	{ "1,2,3,a,,", NULL },
	{ NULL, NULL },
};

static const struct example columns_of_csv[] = {
	{ "a,1,b c,2,3", "3|1|2|" },
	{ ",1,,2,3,d", "3|1|2|" },
	{ "a,1,\"b,c\" ,2,3", "3|1|2|" },
	{ "a,1,\"b\"\"c\",2,3", NULL },
	{ "a,1,\"b\"c,2,3", NULL },
	{ "a,1,\"b,2,3", NULL },
	{ "a,1,b,2", NULL },
	{ NULL, NULL },
};

static const struct example arrays[] = {
	{ "[1,2,3]", "1|2|3|" },
	{ " [ -1 , 2.5,0.5 ] ", "-1|2.5|0.5|" },
	{ "[1,2,3,\"a\", true,false ,null,-1.5,\"\"]", "1|2|3|" },
	{ "[01,2,3]", NULL },
	{ "[1,2.,3]", NULL },
	{ "[1,2,-.5]", NULL },
	{ "[1,2,.5]", NULL },
	{ "[1,2,3,\"\\n\\\\\\\"\\u00e9\\/\"]", "1|2|3|" },
	{ "[1,2,3,\"\\a\"]", NULL },
	{ "[1,2,3,\"\\u00g9\"]", NULL },
	{ "[1,2,3,\"\\\"]", NULL },
	{ "[1,2,3,[4]]", "1|2|3|" },
	{ "[1,2,3,{\"a\" : [ ],\"b\":[{},\"]\"]}]", "1|2|3|" },
	{ "[1,2,3,[[[[[[[[4]]]]]]]]]", "1|2|3|" },
	{ "[1,2,3,[[[[[[[[[4]]]]]]]]]]", NULL },
	{ "[1,2,3,[4}]", NULL },
	{ "[1,2,3,[4,]]", NULL },
	{ "[1,2,3,{\"a\"}]", NULL },
	{ "[1,2,3,{a:1}]", NULL },
	{ "[1,2,3,[4]", NULL },
	{ "[1,2,3,1e5,-2.5E-7]", "1|2|3|" },
	{ "[1,2,3,1e]", NULL },
	{ "[1,2,3,+1e5]", NULL },
	{ "[1,2,3,tru]", NULL },
	{ "[1,2,3,-]", NULL },
	{ "[1,2,3,1.2.3]", NULL },
	{ "[1,2,3,]", NULL },
	{ "[1,2,3", NULL },
	{ "[1,2]", NULL },
	{ "[1,2,3] 4", NULL },
	{ "1,2,3", NULL },
	{ NULL, NULL },
};

static const struct example columns_of_arrays[] = {
	{ "[\"a\",1,true,2,3]", "3|1|2|" },
	{ "[0, 1, 0, 2, 3, \"b\"]", "3|1|2|" },
	{ "[[],1,0,2,3]", "3|1|2|" },
	{ "[[,1,0,2,3]", NULL },
	{ NULL, NULL },
};

static const struct example objects[] = {
	{ "{\"x\":1,\"y\":2,\"z\":3}", "1|2|3|" },
	{ " { \"z\" : 3 , \"x\":1,\"a\":\"b\",\"\":0, \"y\":-2.5 } ", "1|-2.5|3|" },
	{ "{\"x\":1,\"y\":2,\"z\":3,\"t\":true}", "1|2|3|" },
	{ "{\"x\":1,\"y\":2}", NULL },
	{ "{\"x\":1,\"y\":2,\"z\":3,\"x\":4}", NULL },
	{ "{\"x\":1,\"y\":2,\"z\":3,\"a\":[{\"x\":1}]}", "1|2|3|" },
	{ "{\"x\":1,\"y\":2,\"z\":3,\"\\u0061\":0}", NULL },
	{ "{\"x\":1,\"y\":2,\"z\":3,\"a\":\"\\u0061\"}", "1|2|3|" },
	{ "{\"x\":1,\"y\":2,\"z\":3,\"a\" 0}", NULL },
	{ "{\"x\":01,\"y\":2,\"z\":3}", NULL },
	{ "{\"x\":1,\"y\":2,\"z\":3", NULL },
	{ "{\"x\":1,\"y\":2,\"z\":3}}", NULL },
	{ "{\"x\":1,\"y\":2,\"z\":3,\"flags\":0}", NULL },
	{ "{\"x\":1,\"y\":2,\"z\":3,\"a\":\"\xc3\xa9\"}", "1|2|3|" },
	{ "[1,2,3]", NULL },
	{ NULL, NULL },
};

/* The number of lines before the tested line. walk_lines leaves the first lines of a
 * text. */
enum { BEFORE = 8 };

/* Returns the numbers that walk_lines finds on a line, with a bar after each, or NULL
 * if it leaves the line. Lines equal to usual stand before and after the line. */
static const char *numbers_found(const struct layout *l, const char *line,
    const char *usual)
{
	static struct stretch s;
	static char out[200];
	struct walk walk;
	struct line lines[PLAIN_BATCH];
	struct plain_places places[4];
	uint64_t left;
	char all[600];
	size_t n = 0, size = 0;

	for (int i = 0; i <= BEFORE + 1; i++)
		n += (size_t)sprintf(all + n, "%s\n", i == BEFORE ? line : usual);

	assert_true(plan_walk(l, &walk));
	s.readable = all;
	assert_true(stretch_open(&s, &walk, all, all + n));
	assert_int_equal(walk_lines(&s, &walk, PLAIN_BATCH, lines, places, &left),
	    BEFORE + 2);
	assert_int_equal(s.at, n);
	assert_int_equal(lines[BEFORE].size, strlen(line));
	assert_int_equal(left >> (BEFORE - 1) & 1, 0);
	assert_int_equal(left >> (BEFORE + 1) & 1, 0);
	if (left >> BEFORE & 1)
		return NULL;
	for (int k = 0; k < l->reads; k++) {
		const struct part *at = &lines[BEFORE].at[k];
		const char *end = places[k].end[BEFORE];

		if (at->to > at->from) {
			assert_ptr_equal(end, lines[BEFORE].s + at->to);
			assert_int_equal(places[k].size[BEFORE], at->to - at->from);
		}
		size += (size_t)sprintf(out + size, "%.*s|", (int)(at->to - at->from),
		    line + at->from);
	}
	return out;
}

static void check_examples(const struct layout *l, const struct example *e,
    const char *usual)
{
	for (; e->line != NULL; e++)
		assert_text(numbers_found(l, e->line, usual), e->numbers, e->line);
}

static void numbers_are_found(void **state)
{
	const struct plan order = { .field = { 0, 1, 2, 3 } };
	struct layout l = { .in = { FORMAT_TEXT, ' ' }, .reads = 3, .plan = order };

	(void)state;
	if (!kernels_choose(NULL) || number_loops_chosen() == NULL)
		skip();
	check_examples(&l, text, "11 12 13");
	l.plan.fields = 4;
	check_examples(&l, rows_of_text, "11 12 13 a");
	l.plan.fields = 0;
	l.reads = 2;
	check_examples(&l, two_of_text, "11 12");
	l = (struct layout){ .in = { FORMAT_OBJ, ' ' }, .reads = 3, .plan = order };
	check_examples(&l, obj, "v 11 12 13");
	l = (struct layout){ .in = { FORMAT_CSV, ',' }, .reads = 3, .plan = order };
	check_examples(&l, csv, "11,12,13");
	l.plan.fields = 4;
	check_examples(&l, rows_of_csv, "11,12,13,a");
	l.plan = (struct plan){ .field = { 4, 1, 3 } };
	check_examples(&l, columns_of_csv, "a,11,b,12,13");
	l.in.format = FORMAT_JSON;
	check_examples(&l, columns_of_arrays, "[0,11,0,12,13]");
	l.plan = order;
	for (int i = 0; i < 3; i++)
		strcpy(l.plan.member[i], coordinate_name(i));
	check_examples(&l, arrays, "[11,12,13]");
	strcpy(l.output.name[COORDINATES_MAX], "flags");
	check_examples(&l, objects, "{\"x\":11,\"y\":12,\"z\":13}");
}

/* A line of JSON that is not UTF-8 makes all lines of the stretch unusual. */
static void utf8_is_needed(void **state)
{
	const struct layout l = { .in = { FORMAT_JSON, ',' },
		.reads = 3,
		.plan = { .field = { 0, 1, 2, 3 } } };

	(void)state;
	if (!kernels_choose(NULL) || number_loops_chosen() == NULL)
		skip();
	static struct stretch s;
	struct walk walk;
	char all[] = "[1,2,3,\"\xc3\xa9\"]\n";

	assert_true(plan_walk(&l, &walk));
	assert_true(stretch_open(&s, &walk, all, all + sizeof all - 1));
	assert_true(s.usual);
	all[8] = 'a';
	assert_true(stretch_open(&s, &walk, all, all + sizeof all - 1));
	assert_false(s.usual);
}

/* The vector loops leave some of these numbers. walk_numbers reads them all the same,
 * or leaves their lines. */
static void numbers_with_exponents_are_read(void **state)
{
	static const char all[] = "1 2 30\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n"
				  "1e-3 2 3\n+4 2 3\nnan 2 3\n1e200 2 3\n"
				  "1e 2 3\n0x1 2 3\n5 6 7e1\n";
	const struct layout l = { .in = { FORMAT_TEXT, ' ' },
		.reads = 3,
		.plan = { .field = { 0, 1, 2 } } };
	static struct stretch s;
	struct walk walk;
	struct line lines[PLAIN_BATCH];
	struct plain_places places[4];
	double v[4][PLAIN_BATCH];
	const char *end = all + sizeof all - 1;
	uint64_t left;

	(void)state;
	if (!kernels_choose(NULL) || number_loops_chosen() == NULL)
		skip();
	assert_true(plan_walk(&l, &walk));
	s.readable = all;
	assert_true(stretch_open(&s, &walk, all, end));
	size_t n = walk_lines(&s, &walk, PLAIN_BATCH, lines, places, &left);

	assert_int_equal(n, 13);
	left = walk_numbers(&walk, lines, n, places, left, v);
	assert_int_equal(left >> 6, 0x38);
	assert_true(v[0][6] == 1e-3 && v[0][7] == 4 && v[0][8] != v[0][8]);
	assert_true(v[0][12] == 5 && v[1][12] == 6 && v[2][12] == 70);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(numbers_are_found),
		cmocka_unit_test(utf8_is_needed),
		cmocka_unit_test(numbers_with_exponents_are_read),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
