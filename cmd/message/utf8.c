/* SPDX-License-Identifier: MIT */
#include "utf8.h"

#include <string.h>

/* Refuses forms longer than needed, halves of surrogate pairs, and codes beyond
 * U+10FFFF (RFC 3629, section 4). */
int utf8_read(const char *s, const char *end, unsigned *code)
{
	static const unsigned least[] = { 0, 0, 0x80, 0x800, 0x10000 };
	unsigned first = (unsigned char)*s;
	int n = first < 0x80 ? 1 :
	    first < 0xc0     ? 0 :
	    first < 0xe0     ? 2 :
	    first < 0xf0     ? 3 :
	    first < 0xf8     ? 4 :
			       0;

	if (n == 0 || end - s < n)
		return 0;
	*code = n == 1 ? first : first & 0xffu >> (n + 1);
	for (int i = 1; i < n; i++) {
		if ((s[i] & 0xc0) != 0x80)
			return 0;
		*code = *code << 6 | (s[i] & 0x3f);
	}
	return *code >= least[n] && *code <= 0x10ffff && *code >> 11 != 0x1b ? n : 0;
}

int utf8_write(unsigned code, char out[4])
{
	int n = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
	static const unsigned char first[] = { 0, 0, 0xc0, 0xe0, 0xf0 };

	for (int i = n - 1; i > 0; i--, code >>= 6)
		out[i] = (char)(0x80 | (code & 0x3f));
	out[0] = (char)(first[n] | code);
	return n;
}

size_t utf8_fit(const char *s, size_t most)
{
	size_t n = strnlen(s, most);

	while (n > 0 && (s[n] & 0xc0) == 0x80)
		n--;
	return n;
}
