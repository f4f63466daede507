// SPDX-License-Identifier: MIT
// Programs around a peer. One has scanf and printf, as most people write them. Two, for
// peers whose points lie in columns, read blocks of lines, and read and write numbers
// by the fastest functions of C++ or by hand. Two read blocks of binary numbers; one of
// them transforms the numbers where they are.
#include "peer.h"

#include <cstdio>
#include <unistd.h>

#include "hand.h"

enum { READ_SIZE = 1 << 18 };

template <class T> struct blocks {
	const peer *p;
	alignas(64) T in[4 * PEER_BLOCK], out[4 * PEER_BLOCK];

	T &to(size_t i, size_t k)
	{
		return in[i * p->layout.point + k * p->layout.coordinate];
	}
	T from(size_t i, size_t k)
	{
		return out[i * p->layout.point + k * p->layout.coordinate];
	}
};

template <class T> static bool run_stdio(blocks<T> &b)
{
	const int digits = sizeof(T) == sizeof(float) ? 9 : 17;
	double x, y, z;

	while (scanf("%lf %lf %lf", &x, &y, &z) == 3) {
		b.to(0, 0) = T(x);
		b.to(0, 1) = T(y);
		b.to(0, 2) = T(z);
		b.p->carry(b.in, b.out, 1);
		printf("%.*g %.*g %.*g\n", digits, double(b.from(0, 0)), digits,
		    double(b.from(0, 1)), digits, double(b.from(0, 2)));
	}
	return feof(stdin);
}

static bool put(const void *from, size_t size)
{
	const char *s = static_cast<const char *>(from), *end = s + size;

	while (s < end) {
		ssize_t n = write(1, s, size_t(end - s));

		if (n < 0)
			return false;
		s += n;
	}
	return true;
}

// The fastest functions of C++ to read and write a number.
struct standard {
	template <class T>
	static const char *read(const char *s, const char *end, T *value)
	{
		auto r = fast_float::from_chars(s, end, *value);

		return r.ec == std::errc() ? r.ptr : nullptr;
	}
	template <class T> static char *write(char *to, T value)
	{
		return std::to_chars(to, to + HAND_MAX, value).ptr;
	}
};

struct by_hand {
	template <class T>
	static const char *read(const char *s, const char *end, T *value)
	{
		return hand_read(s, end, value);
	}
	template <class T> static char *write(char *to, T value)
	{
		return hand_write(to, value);
	}
};

// Reads at most a block of lines from s into columns, and sets *n to their number.
// Returns the end of these lines, or nullptr if a line lacks three numbers.
template <class Number, class T>
static const char *parse(T *columns, const char *s, const char *end, size_t *n)
{
	size_t i;

	for (i = 0; i < PEER_BLOCK && s < end; i++) {
		for (size_t k = 0; k < 3; k++) {
			while (*s == ' ')
				s++;
			s = Number::read(s, end, &columns[k * PEER_BLOCK + i]);
			if (s == nullptr)
				return s;
		}
		while (*s++ != '\n')
			;
	}
	*n = i;
	return s;
}

template <class Number, class T>
static bool carry_lines(blocks<T> &b, const char *s, const char *end)
{
	static char lines[3 * PEER_BLOCK * HAND_MAX];

	while (s < end) {
		char *to = lines;
		size_t n;

		s = parse<Number>(b.in, s, end, &n);
		if (s == nullptr)
			return false;
		b.p->carry(b.in, b.out, n);
		for (size_t i = 0; i < n; i++)
			for (size_t k = 0; k < 3; k++) {
				to = Number::write(to, b.out[k * PEER_BLOCK + i]);
				*to++ = k < 2 ? ' ' : '\n';
			}
		if (!put(lines, size_t(to - lines)))
			return false;
	}
	return true;
}

template <class Number, class T> static bool run_lines(blocks<T> &b)
{
	// The text has room for a newline after the last line, and for a read of 8
	// bytes.
	static char text[READ_SIZE + 8];
	size_t size = 0;
	ssize_t got;

	do {
		got = read(0, text + size, READ_SIZE - size);
		if (got < 0)
			return false;
		size += size_t(got);
		text[size] = '\n';
		char *end = text + size;
		while (got > 0 && end > text && end[-1] != '\n')
			end--;
		if (!carry_lines<Number>(b, text, end))
			return false;
		size -= size_t(end - text);
		memmove(text, end, size);
	} while (got > 0 && size < READ_SIZE);
	return size == 0;
}

template <class T> static bool run_binary(blocks<T> &b)
{
	static T points[PEER_BLOCK][3];
	size_t n;

	while ((n = fread(points, sizeof *points, PEER_BLOCK, stdin)) > 0) {
		for (size_t i = 0; i < n; i++)
			for (size_t k = 0; k < 3; k++)
				b.to(i, k) = points[i][k];
		b.p->carry(b.in, b.out, n);
		for (size_t i = 0; i < n; i++)
			for (size_t k = 0; k < 3; k++)
				points[i][k] = b.from(i, k);
		if (!put(points, n * sizeof *points))
			return false;
	}
	return !ferror(stdin);
}

// Transforms the points where read() puts them.
template <class T> static bool run_in_place(const peer *p)
{
	alignas(64) static T points[READ_SIZE / sizeof(T)];
	const size_t point = 3 * sizeof(T), room = READ_SIZE / point * point;
	char *bytes = reinterpret_cast<char *>(points);
	size_t size = 0;
	ssize_t got;

	do {
		got = read(0, bytes + size, room - size);
		if (got < 0)
			return false;
		size += size_t(got);
		if (got > 0 && size < room)
			continue;
		p->in_place(points, size / point);
		if (!put(bytes, size / point * point))
			return false;
		size = 0;
	} while (got > 0);
	return true;
}

template <class T> static bool run(const peer *p, const char *filter)
{
	static blocks<T> b;

	b.p = p;
	for (T &t : b.in)
		t = 1;
	if (strcmp(filter, "stdio") == 0)
		return run_stdio(b) && fflush(stdout) == 0;
	if (strcmp(filter, "binary") == 0)
		return p->in_place != nullptr ? run_in_place<T>(p) : run_binary(b);
	if (p->layout.point != 1)
		return false;
	return strcmp(filter, "hand") == 0 ? run_lines<by_hand>(b) :
					     run_lines<standard>(b);
}

bool peer_filter(const peer *p, const char *filter)
{
	return p->single ? run<float>(p, filter) : run<double>(p, filter);
}
