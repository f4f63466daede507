#include "line.h"

#include <string.h>

enum { DEPTH_MAX = 100 };

/* p stops at what is wrong. */
struct scan {
	const char *p, *end;
	int depth;
};

static bool is_digit(char c)
{
	return c >= '0' && c <= '9';
}

bool is_json_number(struct span f)
{
	const char *s = f.s, *point;

	s += s < f.end && *s == '-';
	if (s == f.end || !is_digit(*s))
		return false;
	if (*s == '0' && s + 1 < f.end && is_digit(s[1]))
		return false;
	point = memchr(s, '.', (size_t)(f.end - s));
	return point == NULL || (point + 1 < f.end && is_digit(point[1]));
}

static bool take(struct scan *s, char c)
{
	s->p = skip_blanks(s->p, s->end);
	if (s->p == s->end || *s->p != c)
		return false;
	s->p++;
	return true;
}

static bool digits(struct scan *s)
{
	const char *start = s->p;

	while (s->p < s->end && is_digit(*s->p))
		s->p++;
	return s->p > start;
}

static bool number(struct scan *s)
{
	struct scan t = *s;

	t.p += *t.p == '-';
	const char *start = t.p;
	bool ok = digits(&t) && (*start != '0' || t.p == start + 1);

	if (ok && t.p < t.end && *t.p == '.') {
		t.p++;
		ok = digits(&t);
	}
	if (ok && t.p < t.end && (*t.p | 0x20) == 'e') {
		t.p++;
		t.p += t.p < t.end && (*t.p == '+' || *t.p == '-');
		ok = digits(&t);
	}
	if (ok)
		s->p = t.p;
	return ok;
}

static bool word(struct scan *s)
{
	static const char *const words[] = { "true", "false", "null" };

	for (int i = 0; i < 3; i++) {
		size_t n = strlen(words[i]);

		if ((size_t)(s->end - s->p) >= n &&
		    memcmp(s->p, words[i], n) == 0) {
			s->p += n;
			return true;
		}
	}
	return false;
}

static bool string(struct scan *s)
{
	if (!take(s, '"'))
		return false;
	for (; s->p < s->end && *s->p != '"'; s->p++) {
		int hex = 0;

		if ((unsigned char)*s->p < ' ')
			return false;
		if (*s->p != '\\')
			continue;
		if (s->end - s->p < 2 || !memchr("\"\\/bfnrtu", s->p[1], 9))
			return false;
		if (*++s->p != 'u')
			continue;
		while (hex < 4 && s->end - s->p > 1 &&
		    memchr("0123456789abcdefABCDEF", s->p[1], 22)) {
			s->p++;
			hex++;
		}
		if (hex < 4)
			return false;
	}
	return take(s, '"');
}

static bool value(struct scan *s);

/* Behind an opening bracket or brace. */
static bool list(struct scan *s, char close)
{
	if (take(s, close))
		return true;
	do
		if ((close == '}' && !(string(s) && take(s, ':'))) || !value(s))
			return false;
	while (take(s, ','));
	return take(s, close);
}

static bool value(struct scan *s)
{
	bool array = take(s, '[');

	if (array || take(s, '{')) {
		bool ok = ++s->depth <= DEPTH_MAX && list(s, array ? ']' : '}');

		s->depth--;
		return ok;
	}
	if (s->p == s->end)
		return false;
	return *s->p == '"' ? string(s) : number(s) || word(s);
}

const char *json_wrong(const char *p, const char *end)
{
	struct scan s = { p, end, 0 };

	if (!value(&s))
		return s.p;
	s.p = skip_blanks(s.p, end);
	return s.p < end ? s.p : NULL;
}
