/* SPDX-License-Identifier: MIT */
#include "look.h"

#include <stdlib.h>
#include <string.h>

#include "../message/escape.h"
#include "text.h"

static bool look_stop(struct look *k, const char *at, const char *what,
    const char *remedy)
{
	k->s = at;
	k->what = what;
	k->remedy = remedy;
	return false;
}

/* Moves k->s past the string that begins there, or to the end of a text that ends in
 * it. Returns false if a character of it is wrong. */
static bool look_string(struct look *k)
{
	const char *s = k->s + 1, *const end = k->end;
	unsigned code;

	for (int n; s < end && *s != '"'; s += n) {
		n = (unsigned char)*s < 0x80 ? 1 : utf8_read(s, end, &code);
		if (n == 0)
			return look_stop(k, s, "a byte is not UTF-8",
			    "iconv -f LATIN1 -t UTF-8 makes UTF-8 of Latin-1");
		if ((unsigned char)*s < ' ')
			return look_stop(k, s, "a control character is in a string",
			    text("write \\u%04x", (unsigned)*s));
		if (*s != '\\')
			continue;
		n = end - s > 1 ? 2 : 1;
		if (end - s > 5 && s[1] == 'u' &&
		    (json_hex4(s + 2, end, &code) < s + 6 || code == 0))
			return look_stop(k, s,
			    text("'%.*s' is in a string", (int)utf8_fit(s, 6), s),
			    "\\u has four hexadecimal digits, and is not 0");
	}
	k->string = k->s;
	k->in_string = s >= end;
	k->s = s < end ? s + 1 : end;
	return true;
}

/* If the string from `name` to k->s is that of a member `points` of the outermost
 * object, and an array follows, the array begins there. */
static void look_for_points(struct look *k, const char *name)
{
	char copy[16] = "";
	const size_t n = (size_t)(k->s - name) - 2;
	const char *s = json_skip_blanks(k->s, k->end);

	if (k->level != 1 || *k->open[0] != '{' || k->points.s != NULL || s == k->end ||
	    *s != ':' || n >= sizeof copy)
		return;
	memcpy(copy, name + 1, n);
	s = json_skip_blanks(s + 1, k->end);
	if (s < k->end && *s == '[' && word_equals(copy, "points"))
		k->points.s = s;
}

/* Returns whether look_over can pass a byte: it begins no string, is no bracket, and no
 * control character but a blank. */
static inline bool is_plain(unsigned char c)
{
	static const bool is_other[256] = { ['"'] = true,
		['['] = true,
		[']'] = true,
		['{'] = true,
		['}'] = true };

	return !is_other[c] && (c >= ' ' || json_is_blank((char)c));
}

static bool look_over(struct look *k)
{
	while (k->s < k->end) {
		while (k->s < k->end && is_plain((unsigned char)*k->s))
			k->s++;
		if (k->s == k->end)
			break;
		const char *const at = k->s;
		const char c = *at;

		if (c == '"') {
			if (!look_string(k))
				return false;
			look_for_points(k, at);
			continue;
		}
		k->s++;
		if (c == '[' || c == '{') {
			if (k->level == JSON_LEVELS_MAX)
				return look_stop(k, at,
				    "brackets are nested more than 200 levels deep",
				    NULL);
			k->open[k->level++] = at;
		} else if ((c == ']' || c == '}') && k->level > 0) {
			if (--k->level == 1 && k->open[1] == k->points.s)
				k->points.end = k->s;
			if (k->level == 0 && k->closed == NULL)
				k->closed = k->s;
		} else if (c != ']' && c != '}') {
			return look_stop(k, at, "a control character is no JSON", NULL);
		}
	}
	return true;
}

/* Sets the line and column of `at` in a text that begins at `begin`. */
static void set_place(const struct json_source *source, const char *begin,
    const char *at, struct place *p)
{
	p->line = source->lines_before + 1;
	p->column = source->bytes_before + 1;
	json_count_lines(begin, at, &p->line, &p->column);
}

bool look_refuse(const struct json_source *source, const char *at, const char *what,
    const char *remedy)
{
	struct place p = { 0 };

	if (source->faults->n < REFUSALS_MAX)
		set_place(source, source->begin, at, &p);
	return refuse_at(source->faults, NULL, what, remedy, p.line, p.column);
}

/* Returns the byte before `at` that is no blank, or NUL. */
static char byte_before(const char *begin, const char *at)
{
	while (at > begin && json_is_blank(at[-1]))
		at--;
	return at > begin ? at[-1] : '\0';
}

/* Returns what JSON has after what is before `at`, in the brackets that k has open. */
static const char *expected_at(const struct look *k, const char *begin, const char *at)
{
	const char before = byte_before(begin, at);
	const char open = k->level > 0 ? *k->open[k->level - 1] : '\0';
	const bool begins = before == open || before == ',';

	if (k->in_string)
		return "'\"' at the end of a string";
	if (open == '{' && begins)
		return "a member's name in \"double quotes\"";
	if (before == ':' || (open == '[' && begins) || before == '\0')
		return "a value";
	if (open == '{' && before == '"' &&
	    strchr("{,", byte_before(begin, k->string)) != NULL)
		return "':' after the member's name";
	return open == '{' ? "',' or '}'" :
	    open == '['    ? "',' or ']'" :
			     "the end of the text";
}

/* Returns what to do about the text at `at`, which is no JSON; or NULL. */
static const char *remedy_at(const struct look *k, const char *begin, const char *at,
    const char *end)
{
	const char c = *at, next = end - at > 1 ? at[1] : '\0';
	const char *digits = at;

	while (digits > begin && strchr("0123456789.eE+-", digits[-1]) != NULL)
		digits--;
	if (at - digits >= 63)
		return "this cJSON reads at most 63 characters of a number";
	if (c == '#' || (c == '/' && (next == '/' || next == '*')))
		return "comments are not JSON; use a member \"_comment\"";
	if (c == '\'')
		return "JSON has \"double quotes\" alone";
	if ((c == ']' || c == '}') && byte_before(begin, at) == ',')
		return "remove the comma before it";
	if (k->level == 0 && c == '{')
		return "--scenes reads several scenes";
	if (k->level == 0 && c == ',' && *begin == '[')
		return "several points are one list: [[0,0,0], [1,1,1]]";
	return NULL;
}

bool look_refuse_end(const struct json_source *source, const struct look *k)
{
	const char *const begin = source->begin;
	const char *const open = k->level > 0 ? k->open[k->level - 1] : begin;
	struct place place = { 0 };

	set_place(source, begin, open, &place);
	return look_refuse(source, k->end,
	    text("expected %s, but the text ends", expected_at(k, begin, k->end)),
	    k->level == 0 ?
		NULL :
		text("the '%c' on line %lld is not closed", *open, place.line));
}

const char *look_for_wrong(const char *begin, const char *at, const char *end)
{
	struct look before = { .s = begin, .end = at - 1 };

	if (at > begin && look_over(&before) && before.level > 0 &&
	    *before.open[before.level - 1] == '{' && at[-1] != '"' &&
	    !json_is_blank(at[-1]) &&
	    strchr("{,", byte_before(begin, at - 1)) != NULL &&
	    !(at[-1] == '}' && byte_before(begin, at - 1) == '{'))
		return at - 1;
	return json_skip_blanks(at, end);
}

bool look_refuse_no_json(const struct json_source *source, const char *at,
    const char *end)
{
	const char *const begin = source->begin;
	struct look before = { .s = begin, .end = at };
	const char *stop = at;
	char shown[ESCAPED_MAX];
	unsigned code;

	look_over(&before);
	if (before.in_string)
		return look_refuse(source, at,
		    text("'%.*s' is in a string", at[1] == 'u' ? 6 : 2, at),
		    at[1] == 'u' ? "it is half of a surrogate pair" :
				   "a backslash itself is \\\\");
	while (stop < end && !json_is_blank(*stop) && strchr(",:[]{}\"", *stop) == NULL)
		stop++;
	if (stop == at)
		stop += (unsigned char)*at < 0x80 ? 1 : utf8_read(at, end, &code);
	escape_short(shown, at, (size_t)(stop - at));
	return look_refuse(source, at,
	    text("expected %s, not '%s'", expected_at(&before, begin, at), shown),
	    remedy_at(&before, begin, at, end));
}

bool look_at_text(struct json_source *source, char *begin, size_t size, struct look *k)
{
	static char *texts[2];
	char **const kept = &texts[source->row == NULL]; /* of a document, of POINTS */

	*k = (struct look){ .s = begin, .end = begin + size };
	source->begin = begin;
	if (size >= 3 && memcmp(begin, "\xef\xbb\xbf", 3) == 0)
		memset(begin, ' ', 3); /* a byte order mark */
	if (message_state.json && size > 0) {
		source->text = *kept = memcpy(xrealloc(*kept, size), begin, size);
		source->end = *kept + size;
	}
	return look_over(k) || look_refuse(source, k->s, k->what, k->remedy);
}

const char *look_for_wrong_number(const char *s, const char *end, struct span points)
{
	while (s < end) {
		const char *const at = s;

		if (s == points.s) {
			s = points.end;
		} else if (*s == '"') {
			s = json_string_end(s, end);
		} else if (*s == '-' || (*s >= '0' && *s <= '9')) {
			s = json_number(s, end, NULL);
			if (s == NULL)
				return at;
		} else {
			s++;
		}
	}
	return end;
}

bool look_for_array(struct json_source *source, char *begin, size_t size,
    struct span *array)
{
	struct look k;

	if (!look_at_text(source, begin, size, &k))
		return false;
	if (k.closed == NULL)
		return look_refuse_end(source, &k);
	const char *rest = json_skip_blanks(k.closed, k.end);

	*array = (struct span){ json_skip_blanks(begin, k.end), k.closed };
	return rest == k.end || look_refuse_no_json(source, rest, k.end);
}

/* Returns where the value of the member or element that a token of a pointer leads to
 * begins in the array or object at s, which is JSON: of members of one name the last
 * one's; or, if `token.s` is NULL, of member or element `index`. NULL if there is
 * none. */
static const char *find_token(const char *s, const char *end, struct span token,
    size_t index)
{
	const bool members = *s == '{', by_name = members && token.s != NULL;
	const char *found = NULL;

	if (!members && *s != '[')
		return NULL;
	if (!members && token.s != NULL)
		index = (size_t)strtol(token.s, NULL, 10);
	s = json_skip_blanks(s + 1, end);
	while (s < end && *s != ']' && *s != '}') {
		const struct span name = { s, members ? json_string_end(s, end) : s };

		if (members)
			s = json_skip_blanks(json_skip_blanks(name.end, end) + 1, end);
		if (by_name ? json_is_name(name, token, true) : index-- == 0)
			found = s;
		if (found != NULL && !by_name)
			break;
		s = json_item_end(s, end);
		if (s < end && *s == ',')
			s = json_skip_blanks(s + 1, end);
	}
	return found;
}

struct place look_at_pointer(const struct json_source *source, const char *pointer)
{
	struct place p = { .file = source->name, .pointer = pointer };

	if (source->text == NULL)
		return p;
	const char *s = json_skip_blanks(source->text, source->end), *next = s;

	for (const char *t = pointer; *t == '/' && next != NULL;) {
		const struct span token = { t + 1, t + 1 + strcspn(t + 1, "/") };

		next = find_token(s, source->end, token, 0);
		s = next != NULL ? next : s;
		t = token.end;
	}
	set_place(source, source->text, s, &p);
	return p;
}

/* Returns where a value, which is not missing, begins in the source's text. */
static const char *find_value(const struct value *v)
{
	const struct json_source *source = v->source;
	const struct span none = { NULL, NULL };

	if (v->parent == NULL)
		return json_skip_blanks(source->text, source->end);
	return find_token(find_value(v->parent), source->end, none, v->index);
}

struct place look_at_value(const struct value *v)
{
	struct place p = { 0 };

	if (v->source->text != NULL)
		set_place(v->source, v->source->text, find_value(v), &p);
	return p;
}
