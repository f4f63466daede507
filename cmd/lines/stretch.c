/* SPDX-License-Identifier: MIT */
#include "stretch.h"

#include <string.h>

struct byte_set stretch_stops(struct dialect d)
{
	const struct format_row *row = format_of(d);
	const bool json = *row->open != '\0';
	struct byte_set set = { { 0 }, { 0 } };
	int bits = 0;

	for (int b = 0; b < 256; b++) {
		/* stops with the same upper four bits share one of 8 bits */
		uint8_t *bit = &set.high[b >> 4];
		char c = (char)b;

		if (c != '\n' && !is_blank(c) && c != d.separator &&
		    !(row->blanks && c == ',') &&
		    (row->quote == 0 || (c != row->quote && c != row->escape)) &&
		    !(json && (b < ' ' || strchr("[]{}", c) != NULL)))
			continue;
		if (*bit == 0)
			*bit = (uint8_t)(1 << bits++);
		set.low[b & 15] |= *bit;
	}
	return set;
}

bool stretch_open(struct stretch *s, const struct byte_set *stops, const char *text,
    const char *end)
{
	size_t size = (size_t)(end - text), n;

	if (size > STRETCH_MAX)
		size = STRETCH_MAX;
	/* a line with a NUL is wrong wherever it stands, and line_read says so */
	const char *nul = memchr(text, '\0', size);

	if (nul != NULL)
		size = (size_t)(nul - text);
	n = number_loops_chosen()->find(stops, text, size, s->stop);
	while (n > 0 && text[s->stop[n - 1]] != '\n')
		n--;
	s->text = text;
	s->at = 0;
	s->end = n > 0 ? s->stop[n - 1] + 1u : 0;
	s->next = s->stop;
	return n > 0;
}
