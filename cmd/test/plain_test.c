/* SPDX-License-Identifier: MIT */
/* The loops of cmd/number/vector read numbers as strtod does. They leave to the scalar
 * code every number that is not plain (see is_plain), and few others. */
#include "random.h"

#include "../../core/points/transform.h"
#include "../number/number.h"
#include "../number/vector/loops.h"

enum { ROUNDS = 6000 };

static int put_digits(char *s, int n)
{
	for (int i = 0; i < n; i++)
		s[i] = (char)('0' + random_below(10));
	return n;
}

/* Writes a number of n to n + more digits, with a point. Returns its length. */
static int put_decimal(char *s, int n, int more)
{
	int size = random_below(2), point;

	s[0] = '-';
	n += random_below(more + 1);
	point = random_below(n + 1);
	size += put_digits(s + size, point);
	s[size++] = '.';
	size += put_digits(s + size, n - point);
	return size;
}

/* Writes a midpoint of two integers that are doubles, or a number near such a
 * midpoint. */
static int put_midway(char *s)
{
	static const char *const fractions[] = { "5", "49", "51", "499", "501" };
	unsigned long long k = 1ull << 52 | next_random() >> 12;

	if (random_below(2))
		return sprintf(s, "%llu", 2 * k + 1);
	return sprintf(s, "%llu.%s", k, fractions[random_below(5)]);
}

static int put_any_text(char *s)
{
	int n = 1 + random_below(PLAIN_MAX);

	for (int i = 0; i < n; i++)
		s[i] = "0123456789012345678901234567890123.-+e/:\xb9"[random_below(41)];
	return n;
}

/* Writes a number of this sort, or a text that is no number. Returns its length. */
static int put_of_sort(int sort, char *s)
{
	double v = (double)(int64_t)next_random() / 0x1p63;

	switch (sort) {
	case 0:
		return sprintf(s, random_below(2) ? "%.6f" : "%+.6f", 1000 * v);
	case 1:
		return sprintf(s, "%.17g", v * 100 + (v < 0 ? -1 : 1));
	case 2:
		return put_decimal(s, 1, 14);
	case 3:
		return sprintf(s, "%.*e", 17 + random_below(2),
		    ldexp(v + (v < 0 ? -1 : 1), random_below(50)));
	case 4:
		return put_decimal(s, 15, 7);
	case 5:
		return put_decimal(s, 1, 29);
	case 6:
		return put_digits(s, 1 + random_below(22));
	case 7:
		return put_midway(s);
	case 8: {
		int size = put_decimal(s, 1, 18);

		return size + sprintf(s + size, "e%+03d", random_below(60) - 30);
	}
	default:
		return put_any_text(s);
	}
}

enum {
	SORTS = 10,
	ALL_READ = 4
}; /* the loops read nearly all numbers of sorts below ALL_READ */

/* Returns whether s is empty or an exponent that the loops may read. */
static bool is_exponent(const char *s)
{
	return *s == '\0' ||
	    ((*s == 'e' || *s == 'E') && (s[1] == '-' || s[1] == '+') &&
		strspn(s + 2, "0123456789") == 2 && s[4] == '\0' && s[-1] != '.');
}

/* Returns whether the loops may read s: [+-] digits with at most one point, and an
 * exponent of two digits. */
static bool is_plain(const char *s)
{
	s += *s == '-' || *s == '+';
	size_t whole = strspn(s, "0123456789");
	size_t point = s[whole] == '.';
	size_t decimals = strspn(s + whole + point, "0123456789");

	return whole + decimals > 0 && is_exponent(s + whole + point + decimals);
}

static void check_number(const char *text, bool left, double v)
{
	double truth = strtod(text, NULL);

	if (!left && (!is_plain(text) || memcmp(&v, &truth, sizeof v) != 0))
		fail_msg("%s: expected %a%s, came %a", text, truth,
		    is_plain(text) ? "" : " by the scalar code", v);
}

/* Compares up to PLAIN_BATCH numbers of a sort, as the loops read them, with strtod.
 * The last number ends before the guard page. Returns the count of numbers that the
 * loops left. */
static int check_batch(const struct number_loops *r, int sort, char *guard)
{
	struct plain_places at;
	char text[PLAIN_BATCH][PLAIN_MAX + 32], *s = guard;
	double v[PLAIN_BATCH];
	int n = 1 + random_below(PLAIN_BATCH), n_left = 0;

	for (int i = n - 1; i >= 0; i--) {
		int size = put_of_sort(sort, text[i]);

		size = size < PLAIN_MAX ? size : PLAIN_MAX;
		text[i][size] = '\0';
		at.end[i] = s;
		at.size[i] = (uint8_t)size;
		s = memcpy(s - size, text[i], (size_t)size);
		*--s = " ,7.-"[random_below(5)];
	}
	for (int i = n; i % PLAIN_GROUP != 0; i++) {
		at.end[i] = at.end[0];
		at.size[i] = at.size[0];
	}
	uint64_t left = r->read(&at, (size_t)n, v);

	for (int i = 0; i < n; i++) {
		check_number(text[i], left >> i & 1, v[i]);
		n_left += (int)(left >> i & 1);
	}
	assert_true(n == 64 || left >> n == 0);
	return n_left;
}

static const char *const copies[] = { "avx512", "avx2", "neon", "baseline" };

static void reads_as_strtod(void **unused)
{
	char *guard = guard_page();

	(void)unused;
	for (int c = 0; c < 4; c++) {
		if (!kernels_choose(copies[c]) || number_loops_chosen() == NULL)
			continue;
		for (int sort = 0; sort < SORTS; sort++) {
			int left = 0;

			for (int i = 0; i < ROUNDS; i++)
				left += check_batch(number_loops_chosen(), sort, guard);
			if (sort < ALL_READ)
				assert_in_range(left, 0, 10);
		}
	}
}

/* Compares the places at which the loops find bytes of the set with those that the
 * definition of struct byte_set gives. */
static void check_places(const struct number_loops *r, const struct byte_set *set,
    const char *s, size_t size)
{
	static uint16_t at[4096 + 128];
	size_t n = r->find(set, s, size, at), k = 0;

	for (size_t i = 0; i < size; i++) {
		uint8_t b = (uint8_t)s[i];

		if ((set->low[b & 15] & set->high[b >> 4]) == 0)
			continue;
		assert_true(k < n);
		assert_int_equal(at[k++], i);
	}
	assert_int_equal(k, n);
}

static void finds_what_is_in_the_set(void **unused)
{
	char *guard = guard_page();

	(void)unused;
	for (int c = 0; c < 4; c++) {
		if (!kernels_choose(copies[c]) || number_loops_chosen() == NULL)
			continue;
		for (int round = 0; round < 2000; round++) {
			size_t size = (size_t)random_below(round % 2 ? 200 : 4096);
			struct byte_set set;
			char *s = guard - size;

			for (int i = 0; i < 16; i++) {
				set.low[i] = (uint8_t)next_random();
				set.high[i] = (uint8_t)(next_random() & next_random() &
				    next_random());
			}
			for (size_t i = 0; i < size; i++)
				s[i] = (char)next_random();
			check_places(number_loops_chosen(), &set, s, size);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(reads_as_strtod),
		cmocka_unit_test(finds_what_is_in_the_set),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
