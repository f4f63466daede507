// SPDX-License-Identifier: MIT
// Programs around a peer, as its users write them: with scanf and printf; with
// the fastest functions of C++ for numbers, all the input in memory; with blocks
// of bytes.
#include "peer.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>

#include <fast_float/fast_float.h>

// The longest shortest double has 24 bytes, and one that separates.
enum { NUMBER_MAX = 25, READ_SIZE = 1 << 20 };

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

template <class T> static void run_stdio(blocks<T> &b)
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
}

// *size gets how many bytes; NULL if there is no room for them.
static const char *read_all(size_t *size)
{
	size_t room = READ_SIZE, got;
	char *text = nullptr;

	*size = 0;
	do {
		room *= 2;
		text = static_cast<char *>(realloc(text, room));
		if (text == nullptr)
			return text;
		got = fread(text + *size, 1, room - *size, stdin);
		*size += got;
	} while (*size == room);
	return text;
}

// Up to a block of points from s on; n is how many.
template <class T>
static const char *parse(blocks<T> &b, const char *s, const char *end,
    size_t *n)
{
	for (*n = 0; *n < PEER_BLOCK; ++*n)
		for (size_t k = 0; k < 3; k++) {
			while (s < end && (*s == ' ' || *s == '\n'))
				s++;
			auto r = fast_float::from_chars(s, end, b.to(*n, k));

			if (r.ec != std::errc())
				return end;
			s = r.ptr;
		}
	return s;
}

template <class T> static void run_text(blocks<T> &b)
{
	static char lines[3 * PEER_BLOCK * NUMBER_MAX];
	size_t size;
	const char *s = read_all(&size), *end = s + (s == nullptr ? 0 : size);

	while (s < end) {
		char *out = lines;
		size_t n;

		s = parse(b, s, end, &n);
		b.p->carry(b.in, b.out, n);
		for (size_t i = 0; i < n; i++)
			for (size_t k = 0; k < 3; k++) {
				out = std::to_chars(out, out + NUMBER_MAX,
				    b.from(i, k))
					  .ptr;
				*out++ = k < 2 ? ' ' : '\n';
			}
		fwrite(lines, 1, size_t(out - lines), stdout);
	}
}

template <class T> static void run_binary(blocks<T> &b)
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
		fwrite(points, sizeof *points, n, stdout);
	}
}

template <class T> static void run(const peer *p, filter f)
{
	static blocks<T> b;

	b.p = p;
	for (T &t : b.in)
		t = 1;
	if (f == FILTER_STDIO)
		run_stdio(b);
	else if (f == FILTER_TEXT)
		run_text(b);
	else
		run_binary(b);
}

bool peer_filter(const peer *p, filter f)
{
	if (p->single)
		run<float>(p, f);
	else
		run<double>(p, f);
	return fflush(stdout) == 0 && !ferror(stdin) && !ferror(stdout);
}
