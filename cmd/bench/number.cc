// SPDX-License-Identifier: MIT
/* Prints the nanoseconds per number of each library with which number.cc could read and
 * write, for coordinates with six decimals and for doubles with all digits. */
#include "../number/vector/loops.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "peer/hand.h"

/* Declared in core/points/points.h, which is not C++. */
extern "C" bool kernels_choose(const char *name);

enum { COUNT = 30000, RUNS = 21 };

static double values[COUNT];
static char input[COUNT * 32], output[COUNT * 32 + 64];
static const char *input_end;

/* The results of the loops are stored here, or the compiler would remove the
 * loops. */
static volatile double sink;

static uint64_t next_random(void)
{
	static uint64_t state = 88172645463325252;

	state ^= state << 13;
	state ^= state >> 7;
	return state ^= state << 17;
}

/* Writes random coordinates within +-1000 to input, three on a line. */
static void fill(const char *format)
{
	char *s = input;

	for (int i = 0; i < COUNT; i++) {
		double unit = double(next_random() >> 11) / (1ull << 53);
		int size = snprintf(s, 31, format, 2000 * unit - 1000);

		values[i] = strtod(s, NULL);
		s += size;
		*s++ = i % 3 == 2 ? '\n' : ' ';
	}
	input_end = s;
}

/* Divides the numbers that were read, so that the numbers to write are within
 * +-1. */
static void project(void)
{
	for (int i = 0; i < COUNT; i++)
		values[i] /= 1000 + values[i - i % 3] / 7;
}

template <class Run> static void measure(const char *name, int numbers, Run run)
{
	double time[RUNS];

	for (double &t : time) {
		auto start = std::chrono::steady_clock::now();
		run();
		std::chrono::duration<double, std::nano> used =
		    std::chrono::steady_clock::now() - start;
		t = used.count() / numbers;
	}
	std::sort(time, time + RUNS);
	printf("  %-28s %6.1f\n", name, time[RUNS / 2]);
}

template <class Read> static void measure_read(const char *name, Read read)
{
	measure(name, COUNT, [&] {
		double sum = 0, v = 0;

		for (const char *s = input; s < input_end; s++) {
			s = read(s, &v);
			sum += v;
		}
		sink = sum;
	});
}

template <class Write> static void measure_write(const char *name, Write write)
{
	measure(name, COUNT, [&] {
		char *s = output;

		for (double v : values)
			s = write(s, v);
		sink = double(s - output);
	});
}

/* Measures number_texts, which puts a separator after each number, as in the
 * program. */
static void measure_texts(number_style style)
{
	static number_text texts[1024];
	const size_t block = sizeof texts / sizeof *texts;
	const size_t count = COUNT / block * block;

	for (const char *copy : { "avx512", "avx2", "neon" }) {
		if (!kernels_choose(copy))
			continue;
		measure((std::string("number_texts, ") + copy).c_str(), int(count),
		    [&] {
			    char *s = output;

			    for (size_t i = 0; i < count; i++) {
				    if (i % block == 0)
					    number_texts(values + i, block, false,
						style, texts);
				    s = number_text_put(s, &texts[i % block], values[i],
					false, style);
				    *s++ = ' ';
			    }
			    sink = double(s - output);
		    });
	}
}

static void read_all(void)
{
	measure_read("strtod", [](const char *s, double *v) {
		char *end;

		*v = strtod(s, &end);
		return (const char *)end;
	});
	measure_read("from_chars, charconv", [](const char *s, double *v) {
		return std::from_chars(s, input_end, *v).ptr;
	});
	measure_read("from_chars, fast_float", [](const char *s, double *v) {
		return fast_float::from_chars(s, input_end, *v).ptr;
	});
	measure_read("by hand, words of digits",
	    [](const char *s, double *v) { return hand_read(s, input_end, v); });
	measure_read("number_read",
	    [](const char *s, double *v) { return number_read(s, input_end, v); });
}

static void write_all(void)
{
	const number_style style = { number_style::NUMBER_SHORTEST, 0 };

	measure_write("printf %.17g",
	    [](char *s, double v) { return s + snprintf(s, 32, "%.17g", v); });
	measure_write("to_chars, charconv",
	    [](char *s, double v) { return std::to_chars(s, s + 32, v).ptr; });
	measure_write("by hand, one product",
	    [](char *s, double v) { return hand_write(s, v); });
	measure_write("number_write",
	    [=](char *s, double v) { return number_write(s, v, style); });
	measure_texts(style);
}

static void write_rounded(void)
{
	const number_style decimals = { number_style::NUMBER_DECIMALS, 3 };
	const number_style digits = { number_style::NUMBER_DIGITS, 12 };

	measure_write("printf %.3f",
	    [](char *s, double v) { return s + snprintf(s, 32, "%.3f", v); });
	measure_write("to_chars, 3 decimals", [](char *s, double v) {
		return std::to_chars(s, s + 32, v, std::chars_format::fixed, 3).ptr;
	});
	measure_write("number_write, 3 decimals",
	    [=](char *s, double v) { return number_write(s, v, decimals); });
	measure_texts(decimals);
	measure_write("printf %.11e",
	    [](char *s, double v) { return s + snprintf(s, 32, "%.11e", v); });
	measure_write("to_chars, 12 digits", [](char *s, double v) {
		return std::to_chars(s, s + 32, v, std::chars_format::scientific, 11)
		    .ptr;
	});
	measure_write("number_write, 12 digits",
	    [=](char *s, double v) { return number_write(s, v, digits); });
}

int main(void)
{
	fill("%.6f");
	puts("reading %.6f:");
	read_all();
	puts("writing them, shortest:");
	write_all();
	fill("%.17g");
	puts("reading 17 digits:");
	read_all();
	project();
	puts("writing 17 digits, shortest:");
	write_all();
	fill("%.17g");
	puts("writing rounded:");
	write_rounded();
	return 0;
}
