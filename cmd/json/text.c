/* SPDX-License-Identifier: MIT */
#include "text.h"

#include <ctype.h>
#include <string.h>

#include "../number/number.h"

/* Returns the end of the digits at s, or NULL if there is no digit at s. */
static const char *digits_end(const char *s, const char *end)
{
	const char *first = s;

	while (s < end && *s >= '0' && *s <= '9')
		s++;
	return s > first ? s : NULL;
}

const char *json_number(const char *s, const char *end, double *v)
{
	const char *const start = s, *first;

	s += s < end && *s == '-';
	first = s;
	s = digits_end(s, end);
	if (s == NULL || (*first == '0' && s > first + 1))
		return NULL;
	if (s < end && *s == '.')
		s = digits_end(s + 1, end);
	if (s != NULL && s < end && (*s == 'e' || *s == 'E')) {
		s++;
		s += s < end && (*s == '+' || *s == '-');
		s = digits_end(s, end);
	}
	return s != NULL && v != NULL ? number_read(start, s, v) : s;
}

const char *json_string_end(const char *s, const char *end)
{
	for (s++; s < end && *s != '"'; s++)
		s += *s == '\\' && s + 1 < end;
	return s < end ? s + 1 : end;
}

const char *json_item_end(const char *s, const char *end)
{
	long level = 0;

	for (; s < end; s++) {
		bool closes = *s == ']' || *s == '}';

		if (level == 0 && (closes || *s == ','))
			return s;
		if (*s == '"')
			s = json_string_end(s, end) - 1;
		else
			level += (*s == '[' || *s == '{') - closes;
	}
	return end;
}

const char *json_hex4(const char *s, const char *end, unsigned *code)
{
	*code = 0;
	for (int i = 0; i < 4 && s < end && isxdigit((unsigned char)*s); i++, s++)
		*code = *code * 16 + ((unsigned char)*s & 15u) + (*s > '9' ? 9 : 0);
	return s;
}

/* code >> 10 of the first and of the second half of a surrogate pair */
enum { FIRST_HALF = 0xd800 >> 10, SECOND_HALF = 0xdc00 >> 10 };

/* Reads the hexadecimal digits at s, which follow \u, to *code. If they are the first
 * half of a surrogate pair, also reads the escape of the second half. *code becomes
 * U+FFFD for a half without the other. Returns the end of the text that was read. */
static const char *unescape_unicode(const char *s, const char *end, unsigned *code)
{
	const char *after;
	unsigned second;

	s = json_hex4(s, end, code);
	if (*code >> 10 == FIRST_HALF && end - s > 1 && s[0] == '\\' && s[1] == 'u') {
		after = json_hex4(s + 2, end, &second);
		if (second >> 10 == SECOND_HALF) {
			*code = 0x10000 + ((*code & 0x3ff) << 10) + (second & 0x3ff);
			return after;
		}
	}
	if (*code >> 10 == FIRST_HALF || *code >> 10 == SECOND_HALF)
		*code = 0xfffd;
	return s;
}

const char *json_unescape(const char *s, const char *end, char out[4], int *n)
{
	static const char from[] = "bfnrt", to[] = "\b\f\n\r\t";
	const char *simple = memchr(from, s[1], 5);
	unsigned code;

	*n = 1;
	out[0] = simple != NULL ? to[simple - from] : s[1];
	if (s[1] != 'u')
		return s + 2;
	s = unescape_unicode(s + 2, end, &code);
	*n = utf8_write(code, out);
	return s;
}

bool json_is_name(struct span f, struct span name, bool pointer)
{
	const char *s = f.s + 1, *stop = f.end - 1;
	char character[4];

	while (s < stop) {
		int size = 1;

		character[0] = *s;
		s = *s == '\\' ? json_unescape(s, stop, character, &size) : s + 1;
		for (int i = 0; i < size; i++, name.s++) {
			if (name.s == name.end)
				return false;
			char c = *name.s;

			if (pointer && c == '~' &&
			    (name.s[1] == '0' || name.s[1] == '1'))
				c = *++name.s == '0' ? '~' : '/';
			if (c != character[i])
				return false;
		}
	}
	return name.s == name.end;
}

const char *json_scalar_end(const char *p, const char *end)
{
	static const char *const words[] = { "true", "false", "null" };

	for (int i = 0; i < 3 && p < end && '9' < *p; i++) {
		size_t n = strlen(words[i]);

		if ((size_t)(end - p) >= n && memcmp(p, words[i], n) == 0)
			return p + n;
	}
	return json_number(p, end, NULL);
}

void json_count_lines(const char *text, const char *at, long long *line, size_t *column)
{
	*column += (size_t)(at - text);
	for (const char *s = text; s < at; s++)
		if (*s == '\n') {
			++*line;
			*column = (size_t)(at - s);
		}
}
