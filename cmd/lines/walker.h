/* SPDX-License-Identifier: MIT */
/* A walker is a position in a stretch. A function pass_x moves the position behind x,
 * or returns false if the line has to be left to line_read. */
#pragma once

#include "../json/text.h"
#include "walk.h"

/* INLINE functions are compiled once for each format, so that the compiler removes the
 * branches of other formats. Makefile defines INLINE otherwise for sanitizers. */
#ifndef INLINE
#define INLINE static inline __attribute__((always_inline))
#endif

struct walker {
	const char *text;
	uint32_t at;          /* the position, in bytes from text */
	const uint16_t *stop; /* the first stop at or after `at` */
	bool comma;           /* the separator passed last has a comma */
	int found;            /* the number of coordinates passed */
};

/* Returns whether the byte at the position is a stop, and is c. */
INLINE bool stop_is(const struct walker *p, char c)
{
	return *p->stop == p->at && p->text[p->at] == c;
}

INLINE void pass_stop(struct walker *p)
{
	p->at++;
	p->stop++;
}

/* Passes blanks. Spaces that follow two others may be no stops. Counts up to seven at a
 * time without a branch, as their number varies where columns are
 * aligned; of JSON one. */
INLINE void pass_blanks(struct walker *p, struct dialect d)
{
	const uint64_t spaces = 0x2020202020202020, end = 1ull << 63;

	while (*p->stop == p->at && is_blank_of(d, p->text[p->at])) {
		uint32_t from = p->at;

		if (d.format == FORMAT_JSON && p->text[p->at + 1] != ' ') {
			pass_stop(p);
			continue;
		}
		while (p->text[p->at] == ' ') {
			uint64_t b;

			memcpy(&b, p->text + p->at, sizeof b);
			b = (b ^ spaces) | end;
			p->at += (uint32_t)__builtin_ctzll(b) / 8;
		}
		p->at += p->at == from;
		do
			p->stop++;
		while (*p->stop < p->at);
	}
}

/* Passes a separator, which is mostly a single byte, in the format text as
 * skip_text_separator does. Returns false if there is none. */
INLINE bool pass_separator(struct walker *p, struct dialect d)
{
	bool text = d.format == FORMAT_TEXT;
	char comma = text ? ',' : d.separator, c = p->text[p->at];

	if (*p->stop == p->at &&
	    (text ? c != '\n' && p->stop[1] > p->at + 1 : c == comma)) {
		p->comma = c == comma;
		pass_stop(p);
		if (!text)
			pass_blanks(p, d);
		return true;
	}
	pass_blanks(p, d);
	p->comma = stop_is(p, comma);
	if (p->comma) {
		pass_stop(p);
		pass_blanks(p, d);
	}
	return p->comma || (text && !stop_is(p, '\n'));
}

/* Returns how many stops the escape at s has after its backslash; -1: no escape. */
static inline int stops_in_escape(const char *s)
{
	unsigned code;

	if (s[1] == 'u')
		return json_hex4(s + 2, s + 6, &code) == s + 6 ? 0 : -1;
	if (s[1] == '"' || s[1] == '\\')
		return 1;
	return s[1] != '\0' && strchr("/bfnrt", s[1]) != NULL ? 0 : -1;
}

/* Passes a string of JSON. Returns false if the string has an escape, unless
 * may_have_escapes is set: an escaped name could be the name of a coordinate. */
INLINE bool pass_string(struct walker *p, bool may_have_escapes)
{
	for (p->stop++; p->text[*p->stop] != '"'; p->stop++) {
		const char *s = &p->text[*p->stop];
		int stops = -1;

		if (__builtin_expect(*s == '\\', 0) && may_have_escapes)
			stops = stops_in_escape(s);
		if (stops < 0 && (*s == '\\' || (unsigned char)*s < ' '))
			return false;
		p->stop += stops > 0;
	}
	p->at = *p->stop++ + 1u;
	return true;
}

/* Returns whether a plain number (loops.h) is legal JSON: 01, .5, +1, "1." are not. */
INLINE bool is_json_number(const char *s, const char *end)
{
	s += *s == '-';
	/* no branches, because the first digits can't be predicted */
	return !(((*s == '0') & (s[1] >= '0') & (s[1] <= '9')) | (*s < '0') |
	    (end[-1] == '.'));
}

/* Passes a field, in the formats text and csv, that is not a coordinate. A quote inside
 * of a quoted field ends it here: as no separator follows, line_read reads the line. */
INLINE bool pass_other_field(struct walker *p, struct dialect d)
{
	bool csv = d.format == FORMAT_CSV, quoted = csv && stop_is(p, '"');

	if (quoted)
		for (p->stop++; p->text[*p->stop] != '"'; p->stop++)
			if (p->text[*p->stop] == '\n')
				return false;
	while (csv && !quoted && is_blank_of(d, p->text[*p->stop]))
		p->stop++;
	p->at = *p->stop;
	if (quoted)
		pass_stop(p);
	return true;
}

/* Returns false if the separator after the n coordinates of a line in the format text
 * shows that a comma may be decimal: "1 2 3,5" may be 1, 2, 3.5; if n is 2, "1,5 2" may
 * be 1.5, 2. The parameter comma says whether commas are between the coordinates. */
INLINE bool has_no_decimal_comma(struct walker *p, struct dialect d, int n, bool comma)
{
	if (*p->stop != p->at || stop_is(p, '\n'))
		return *p->stop == p->at;
	if (n != 2)
		return comma || !stop_is(p, ',');
	pass_separator(p, d);
	return stop_is(p, '\n') || p->comma == comma;
}

static inline struct walk_paths paths_inside(const struct walk_paths *t, unsigned leads)
{
	struct walk_paths rest;

	for (int i = 0; i < 4; i++) {
		bool set = (leads >> i & 1) != 0;

		rest.path[i] = set ? t->path[i] + t->size[i] + 1 : "";
		rest.size[i] = set ? strcspn(rest.path[i], "/") : SIZE_MAX;
	}
	return rest;
}

/* Returns the coordinate whose path ends at the field with this name or index, or
 * -1. Sets bit i of *leads if path i leads to the field or into it. */
INLINE int follow_paths(const struct walk_paths *t, int n, struct span name,
    unsigned *leads)
{
	size_t size = (size_t)(name.end - name.s);

	*leads = 0;
	for (int i = 0; i < n; i++) {
		const char *path = t->path[i];

		if (t->size[i] != size || *path != *name.s ||
		    (size > 1 && memcmp(path, name.s, size) != 0))
			continue;
		*leads |= 1u << i;
		if (path[size] != '/')
			return i;
	}
	return -1;
}
