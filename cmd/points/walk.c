#include "walk.h"

#include <string.h>

/* What can end a field: blanks, newlines and commas; in csv quotes, where the
 * field is to be left; in JSON brackets, and what strings hold but rarely. */
#define TEXT_STOPS "\t\n\v\f\r ,"
#define CONTROLS                                                  \
	"\0\1\2\3\4\5\6\7\10\16\17\20\21\22\23\24\25\26\27\30\31" \
	"\32\33\34\35\36\37"
static const char text_stops[] = TEXT_STOPS, csv_stops[] = TEXT_STOPS "\"",
		  json_stops[] = TEXT_STOPS "\"[]{}\\" CONTROLS;

/* A bit for each value of the upper four: there may be eight of these. */
static struct byte_set set_of(const char *bytes, size_t n)
{
	struct byte_set set = { { 0 }, { 0 } };
	int bits = 0;

	for (size_t i = 0; i < n; i++) {
		uint8_t b = (uint8_t)bytes[i], *bit = &set.high[b >> 4];

		if (*bit == 0)
			*bit = (uint8_t)(1 << bits++);
		set.low[b & 15] |= *bit;
	}
	return set;
}

static struct byte_set stops_of(enum format format)
{
	switch (format) {
	case FORMAT_CSV:
		return set_of(csv_stops, sizeof csv_stops - 1);
	case FORMAT_JSON:
		return set_of(json_stops, sizeof json_stops - 1);
	default:
		return set_of(text_stops, sizeof text_stops - 1);
	}
}

bool walk_plan(const struct layout *l, struct walk *w)
{
	const int *field = l->columns.field;
	int n = l->reads, last = -1;

	*w = (struct walk){ .format = l->in,
		.stops = stops_of(l->in),
		.n = n,
		.columns = l->columns.n > 0 };
	for (int i = 0; i < n; i++)
		w->coordinate[i] = i;
	if (!w->columns)
		return true;
	for (int i = 0; i < n; i++) {
		int k = i;

		for (; k > 0 && field[w->coordinate[k - 1]] > field[i]; k--)
			w->coordinate[k] = w->coordinate[k - 1];
		w->coordinate[k] = i;
	}
	for (int i = 0; i < n; i++) {
		w->skip[i] = field[w->coordinate[i]] - last - 1;
		last = field[w->coordinate[i]];
		if (w->skip[i] < 0)
			return false;
	}
	return true;
}

bool stretch_open(struct stretch *w, const struct walk *walk, const char *text,
    const char *end)
{
	size_t size = (size_t)(end - text), n;

	if (size > STRETCH)
		size = STRETCH;
	n = plain_reader()->find(&walk->stops, text, size, w->stop);
	while (n > 0 && text[w->stop[n - 1]] != '\n')
		n--;
	w->text = text;
	w->at = 0;
	w->end = n > 0 ? w->stop[n - 1] + 1u : 0;
	w->next = w->stop;
	return n > 0;
}

/* On the way through a line: at and the first stop from there on, which is never
 * beyond the newline. */
struct place {
	const char *text;
	uint32_t at;
	const uint16_t *stop;
};

static inline bool stands(const struct place *p, char c)
{
	return *p->stop == p->at && p->text[p->at] == c;
}

static inline void pass(struct place *p)
{
	p->at++;
	p->stop++;
}

static inline void pass_blanks(struct place *p, enum format format)
{
	while (*p->stop == p->at && is_blank_of(format, p->text[p->at]))
		pass(p);
}

/* As skip_separator in text; elsewhere only a comma separates. Most separators are
 * of one byte. */
static inline bool pass_separator(struct place *p, enum format format)
{
	char c = p->text[p->at];

	if (p->stop[1] > p->at + 1 && *p->stop == p->at &&
	    (format == FORMAT_TEXT ? c != '\n' : c == ',')) {
		pass(p);
		return true;
	}
	pass_blanks(p, format);
	if (stands(p, ',')) {
		pass(p);
		pass_blanks(p, format);
		return true;
	}
	return format == FORMAT_TEXT;
}

/* Past a string of JSON with nothing in it that would have to be looked at. */
static bool pass_string(struct place *p)
{
	for (p->stop++; p->text[*p->stop] != '"'; p->stop++) {
		char c = p->text[*p->stop];

		if (c == '\\' || (unsigned char)c < ' ')
			return false;
	}
	p->at = *p->stop++ + 1u;
	return true;
}

/* Whether a plain number is one of JSON: it has no 0 before another digit, and
 * digits on both sides of its point. */
static inline bool is_narrow(const char *s, const char *end)
{
	s += *s == '-';
	/* what the first digits are the processor could not guess: no branches */
	return !(((*s == '0') & (s[1] >= '0') & (s[1] <= '9')) | (*s == '.') |
	    (end[-1] == '.'));
}

static bool is_number(const char *s, const char *end)
{
	const char *first = s;
	int points = 0, digits = 0;

	for (s += s < end && *s == '-'; s < end; s++) {
		points += *s == '.';
		digits += *s >= '0' && *s <= '9';
		if (*s != '.' && (*s < '0' || *s > '9'))
			return false;
	}
	return digits > 0 && points < 2 && is_narrow(first, end);
}

/* Past a field that is no coordinate. */
static inline bool pass_field(struct place *p, enum format format)
{
	uint32_t from = p->at;

	if (format == FORMAT_JSON && stands(p, '"'))
		return pass_string(p);
	if (format == FORMAT_CSV)
		while (is_blank(p->text[*p->stop]))
			p->stop++;
	p->at = *p->stop;
	return p->text[p->at] != '"' &&
	    (format != FORMAT_JSON ||
		is_number(p->text + from, p->text + p->at));
}

/* Past the last coordinate: whether all up to the newline is right, too. In text
 * and csv, anything is that begins with a separator. */
static inline bool pass_rest(struct place *p, enum format format)
{
	if (format != FORMAT_TEXT)
		pass_blanks(p, format);
	if (format != FORMAT_JSON)
		return *p->stop == p->at && p->text[p->at] != '"';
	while (stands(p, ',')) {
		pass_separator(p, format);
		if (!pass_field(p, format))
			return false;
		pass_blanks(p, format);
	}
	if (!stands(p, ']'))
		return false;
	pass(p);
	pass_blanks(p, format);
	return stands(p, '\n');
}

/* Where the coordinates of line i stand; false where it is to be left. */
static inline __attribute__((always_inline)) bool
find_coordinates(struct place *p, const struct walk *w, enum format format,
    int n, bool columns, struct line *line, size_t i,
    struct plain_places places[4])
{
	uint32_t begin = p->at;

	pass_blanks(p, format);
	if (p->text[p->at] == '#')
		return false;
	if (format == FORMAT_JSON) {
		if (!stands(p, '['))
			return false;
		pass(p);
		pass_blanks(p, format);
	}
#pragma GCC unroll 3
	for (int m = 0; m < n; m++) {
		for (int skip = columns ? w->skip[m] : 0; skip > 0; skip--)
			if (!pass_field(p, format) ||
			    !pass_separator(p, format))
				return false;
		uint32_t from = p->at, to = *p->stop;
		int k = columns ? w->coordinate[m] : m;

		if (to - from - 1 >= PLAIN_MAX ||
		    (format == FORMAT_JSON &&
			!is_narrow(p->text + from, p->text + to)))
			return false;
		line->at[k] = (struct part){ from - begin, to - begin };
		places[k].end[i] = p->text + to;
		places[k].size[i] = (uint8_t)(to - from);
		p->at = to;
		if (m + 1 < n && !pass_separator(p, format))
			return false;
	}
	return pass_rest(p, format);
}

/* What stands for the numbers of a line that is left. */
static void no_numbers(int n, size_t i, struct plain_places places[4])
{
	static const char none[PLAIN_BEFORE + 1] = "";

	for (int k = 0; k < n; k++) {
		places[k].end[i] = none + sizeof none;
		places[k].size[i] = 1;
	}
}

/* Inline, so that the compiler makes a copy for each format, of which what does not
 * concern it falls away. */
static inline __attribute__((always_inline)) size_t
take_lines(struct stretch *s, const struct walk *walk, enum format format,
    int n, bool columns, size_t max, struct line *lines,
    struct plain_places places[4], uint64_t *left)
{
	struct place p = { s->text, s->at, s->next };
	uint32_t end = s->end;
	size_t i;

	*left = 0;
	for (i = 0; i < max && p.at < end; i++) {
		uint32_t begin = p.at;

		if (p.text + begin - s->readable < PLAIN_BEFORE ||
		    !find_coordinates(&p, walk, format, n, columns, &lines[i],
			i, places)) {
			no_numbers(n, i, places);
			*left |= (uint64_t)1 << i;
		}
		while (p.text[*p.stop] != '\n')
			p.stop++;
		p.at = *p.stop++;
		lines[i].s = p.text + begin;
		lines[i].size = p.at++ - begin;
		lines[i].kind = LINE_POINT;
		lines[i].newline = true;
	}
	for (size_t k = i; k % PLAIN_GROUP != 0; k++)
		no_numbers(n, k, places);
	s->at = p.at;
	s->next = p.stop;
	return i;
}

/* Three coordinates are what is usual. */
static inline __attribute__((always_inline)) size_t
take_format(struct stretch *s, const struct walk *walk, enum format format,
    size_t max, struct line *lines, struct plain_places places[4],
    uint64_t *left)
{
	if (walk->n == 3)
		return walk->columns ? take_lines(s, walk, format, 3, true, max,
					   lines, places, left) :
				       take_lines(s, walk, format, 3, false,
					   max, lines, places, left);
	return take_lines(s, walk, format, walk->n, true, max, lines, places,
	    left);
}

size_t walk_lines(struct stretch *s, const struct walk *walk, size_t n,
    struct line lines[PLAIN_BATCH], struct plain_places places[4],
    uint64_t *left)
{
	switch (walk->format) {
	case FORMAT_CSV:
		return take_format(s, walk, FORMAT_CSV, n, lines, places, left);
	case FORMAT_JSON:
		return take_format(s, walk, FORMAT_JSON, n, lines, places,
		    left);
	default:
		return take_format(s, walk, FORMAT_TEXT, n, lines, places,
		    left);
	}
}
