/* SPDX-License-Identifier: MIT */
#include "value.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../message/escape.h"
#include "../number/number.h"
#include "text.h"

const struct value_range range_any = { -SCENE_MAGNITUDE_MAX, SCENE_MAGNITUDE_MAX,
	.wanted = "numbers go up to 1e150" };
const struct value_range range_positive = { SCENE_SIZE_MIN, SCENE_MAGNITUDE_MAX,
	.wanted = "a number from 1e-150 to 1e150 is wanted" };

/* A look over the text before cJSON, which takes what is no JSON: control characters, a
 * NUL by its escape, and bytes that are not UTF-8. It also finds the array of
 * points. */
struct look {
	const char *s, *end; /* the next byte; the end of the text */
	int level;           /* the number of open brackets */
	const char *open[JSON_LEVELS_MAX + 1];
	struct span points;
	const char *closed; /* the end of the outermost brackets, or NULL */
	const char *string; /* the last string, and whether the text ends in it */
	bool in_string;
	const char *what, *remedy; /* what is wrong at s, or NULL */
};

static bool look_refuse(struct look *k, const char *at, const char *what,
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
			return look_refuse(k, s, "a byte is not UTF-8",
			    "iconv -f LATIN1 -t UTF-8 makes UTF-8 of Latin-1");
		if ((unsigned char)*s < ' ')
			return look_refuse(k, s, "a control character is in a string",
			    text("write \\u%04x", (unsigned)*s));
		if (*s != '\\')
			continue;
		n = end - s > 1 ? 2 : 1;
		if (end - s > 5 && s[1] == 'u' &&
		    (json_hex4(s + 2, end, &code) < s + 6 || code == 0))
			return look_refuse(k, s, text("'%.6s' is in a string", s),
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
				return look_refuse(k, at,
				    "brackets are nested more than 200 levels deep",
				    NULL);
			k->open[k->level++] = at;
		} else if ((c == ']' || c == '}') && k->level > 0) {
			if (--k->level == 1 && k->open[1] == k->points.s)
				k->points.end = k->s;
			if (k->level == 0 && k->closed == NULL)
				k->closed = k->s;
		} else if (c != ']' && c != '}') {
			return look_refuse(k, at, "a control character is no JSON",
			    NULL);
		}
	}
	return true;
}

/* Sets the line and column of `at` in a text that begins at `begin`. */
static void set_place(const struct json_source *source, const char *begin,
    const char *at, struct refusal *r)
{
	r->line = source->lines_before + 1;
	r->column = source->bytes_before + 1;
	json_count_lines(begin, at, &r->line, &r->column);
}

bool value_refuse_text(const struct json_source *source, const char *at,
    const char *what, const char *remedy)
{
	struct refusals *const f = source->faults;

	refuse(f, NULL, what, remedy);
	if (f->n <= REFUSALS_MAX)
		set_place(source, source->begin, at, &f->list[f->n - 1]);
	return false;
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

/* Refuses a text that ends in brackets or, where `at` is no end, in a string. */
static bool refuse_end(const struct json_source *source, const struct look *k)
{
	const char *const begin = source->begin;
	const char *const open = k->level > 0 ? k->open[k->level - 1] : begin;
	struct refusal place = { .where = "" };

	set_place(source, begin, open, &place);
	return value_refuse_text(source, k->end,
	    text("expected %s, but the text ends", expected_at(k, begin, k->end)),
	    k->level == 0 ?
		NULL :
		text("the '%c' on line %lld is not closed", *open, place.line));
}

/* Returns the byte that is wrong where cJSON stopped at `at`: blanks may precede it,
 * but of what is no name of a member cJSON passes a byte. */
static const char *find_wrong(const char *begin, const char *at, const char *end)
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

/* Refuses the text from `at` on, which is no JSON. */
static bool refuse_no_json(const struct json_source *source, const char *at,
    const char *end)
{
	const char *const begin = source->begin;
	struct look before = { .s = begin, .end = at };
	const char *stop = at;
	char shown[ESCAPED_MAX];
	unsigned code;

	look_over(&before);
	if (before.in_string)
		return value_refuse_text(source, at,
		    text("'%.*s' is in a string", at[1] == 'u' ? 6 : 2, at),
		    at[1] == 'u' ? "it is half of a surrogate pair" :
				   "a backslash itself is \\\\");
	while (stop < end && !json_is_blank(*stop) && strchr(",:[]{}\"", *stop) == NULL)
		stop++;
	if (stop == at)
		stop += (unsigned char)*at < 0x80 ? 1 : utf8_read(at, end, &code);
	escape_short(shown, at, (size_t)(stop - at));
	return value_refuse_text(source, at,
	    text("expected %s, not '%s'", expected_at(&before, begin, at), shown),
	    remedy_at(&before, begin, at, end));
}

/* The memory of cJSON's trees, which the next document takes back. */
static struct block {
	struct block *next;
	size_t n, room;
	_Alignas(max_align_t) char bytes[];
} * blocks;

static void *block_take(size_t size)
{
	const size_t align = _Alignof(max_align_t), least = 1 << 14,
		     n = (size + align - 1) / align * align;

	if (blocks == NULL || blocks->room - blocks->n < n) {
		const size_t room = n > least ? n : least;
		struct block *b = xrealloc(NULL, sizeof *b + room);

		*b = (struct block){ .next = blocks, .room = room };
		blocks = b;
	}
	blocks->n += n;
	return blocks->bytes + blocks->n - n;
}

static void block_keep(void *p)
{
	(void)p;
}

static void take_back(void)
{
	cJSON_InitHooks(&(cJSON_Hooks){ block_take, block_keep });
	for (struct block *b; blocks != NULL && blocks->next != NULL; blocks = b) {
		b = blocks->next;
		free(blocks);
	}
	if (blocks != NULL)
		blocks->n = 0;
}

/* Returns the tree of the text or, if points.s is not NULL, of a copy without the
 * elements of the array: cJSON would need 64 bytes for each number, and change their
 * digits. Returns NULL if the text is no JSON, and sets *stop to where it is none. */
static const cJSON *parse_without(const char *begin, const char *end,
    struct span points, const char **stop)
{
	const size_t before = points.s != NULL ? (size_t)(points.s + 1 - begin) : 0;
	const size_t cut = points.s != NULL ? (size_t)(points.end - points.s - 2) : 0;
	const size_t n = (size_t)(end - begin) - cut;
	char *copy = NULL;
	const char *s = begin, *at;

	if (cut > 0) {
		s = copy = xrealloc(NULL, n);
		memcpy(copy, begin, before);
		memcpy(copy + before, begin + before + cut, n - before);
	}
	const cJSON *parsed = cJSON_ParseWithLengthOpts(s, n, &at, false);

	if (parsed == NULL && n > 0 && at == s + n - 1) {
		/* cJSON stops at the last byte also where the text ends too early: then
		 * it passes the byte if a blank follows */
		char *longer = xrealloc(NULL, n + 1);

		memcpy(longer, s, n);
		longer[n] = ' ';
		cJSON_ParseWithLengthOpts(longer, n + 1, &at, false);
		at = s + (at - longer);
		free(longer);
	}
	*stop = begin + (at - s) + (cut > 0 && (size_t)(at - s) >= before ? cut : 0);
	free(copy);
	return parsed;
}

/* Sets the source's text, keeps a copy of it for messages, and looks it over. */
static bool begin_text(struct json_source *source, char *begin, size_t size,
    struct look *k)
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
	return look_over(k) || value_refuse_text(source, k->s, k->what, k->remedy);
}

/* Returns the first number that cJSON reads though it is none of JSON, as 010 and 1.
 * are, or NULL. Those of points are read elsewhere. */
static const char *find_wrong_number(const char *s, const char *end, struct span points)
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
	return NULL;
}

bool value_parse_document(struct json_source *source, char *begin, size_t size,
    struct value *root, struct span *points)
{
	const char *const end = begin + size, *stop;
	struct look k;

	if (!begin_text(source, begin, size, &k))
		return false;
	if (k.points.end == NULL || k.points.end[-1] != ']')
		k.points.s = NULL; /* it is not closed, which cJSON finds */
	take_back();
	const cJSON *parsed = parse_without(begin, end, k.points, &stop);

	stop = parsed == NULL ? find_wrong(begin, stop, end) :
				json_skip_blanks(stop, end);
	if (parsed == NULL && (stop == end || k.in_string))
		return refuse_end(source, &k);
	if (stop < end || parsed == NULL)
		return refuse_no_json(source, stop, end);
	stop = find_wrong_number(begin, end, k.points);
	if (stop != NULL)
		return refuse_no_json(source, stop, end);
	*root = (struct value){ .source = source, .item = parsed };
	*points = k.points;
	return true;
}

bool value_find_array(struct json_source *source, char *begin, size_t size,
    struct span *array)
{
	struct look k;

	if (!begin_text(source, begin, size, &k))
		return false;
	if (k.closed == NULL)
		return refuse_end(source, &k);
	const char *rest = json_skip_blanks(k.closed, k.end);

	*array = (struct span){ json_skip_blanks(begin, k.end), k.closed };
	return rest == k.end || refuse_no_json(source, rest, k.end);
}

struct value value_literal(const char *text)
{
	static struct refusals faults;
	static const struct json_source source = { .faults = &faults };

	return (struct value){ .source = &source, .item = cJSON_Parse(text) };
}

struct value value_child(const struct value *v)
{
	const cJSON *item = v->item->child;

	return (struct value){ .source = v->source,
		.parent = v,
		.name = item != NULL ? item->string : NULL,
		.unused = v->unused,
		.item = item };
}

void value_next(struct value *v)
{
	v->item = v->item->next;
	v->index++;
	v->name = v->item != NULL ? v->item->string : NULL;
}

bool value_is(const struct value *v, enum json_type type)
{
	return v->item != NULL && (v->item->type >> type & 1) != 0;
}

const char *value_string(const struct value *v)
{
	return cJSON_GetStringValue(v->item);
}

size_t value_count(const struct value *v)
{
	return value_is(v, JSON_ARRAY) ? (size_t)cJSON_GetArraySize(v->item) : 0;
}

/* Returns the end. In a name, ~ becomes ~0 and / becomes ~1 (RFC 6901). Names are cut,
 * and what does not fit into the room is left out. */
static char *write_pointer(const struct value *v, char *out, const char *end)
{
	enum { TOKEN_MAX = 64 };

	if (v->parent == NULL)
		return out;
	out = write_pointer(v->parent, out, end);
	if (end - out <= TOKEN_MAX)
		return out;
	if (v->name == NULL)
		return out + sprintf(out, "/%zu", v->index);
	const char *const start = out;

	*out++ = '/';
	for (const char *s = v->name; *s != '\0'; s++) {
		if (out - start > TOKEN_MAX - 6)
			return stpcpy(out, "...");
		if (*s == '~' || *s == '/')
			*out++ = '~';
		*out++ = *s == '~' ? '0' : *s == '/' ? '1' : *s;
	}
	return out;
}

bool value_refuse(const struct value *v, const char *what, const char *remedy)
{
	char where[sizeof((struct refusal *)NULL)->where];

	*write_pointer(v, where, where + sizeof where) = '\0';
	return refuse(v->source->faults, where, what, remedy);
}

bool value_refuse_type(const struct value *v, const char *wanted)
{
	static const char *const names[] = { "false", "true", "null", "a number",
		"a string", "an array", "an object" };

	return value_refuse(v,
	    text("is %s", names[__builtin_ctz((unsigned)v->item->type)]),
	    text("%s is wanted", wanted));
}

/* In radians, limits of 180 and 90 degrees become the doubles PI and PI / 2, which are
 * below pi and pi/2, so x may be equal to them even if the limit is excluded. */
static bool is_within(double x, const struct value_range *r, bool radians)
{
	double min = r->min, max = r->max;

	if (radians) {
		min = min == SCENE_SIZE_MIN ? min : min / 180 * PI;
		max = max / 180 * PI;
	}
	return (x > min || (x == min && (radians || !r->min_excluded))) &&
	    (x < max || (x == max && (radians || !r->max_excluded)));
}

bool value_in_range(const struct value *v, const struct value_range *range, double x)
{
	bool radians = range->wanted_radians != NULL &&
	    v->source->unit == ANGLE_RADIANS;
	const char *wanted = radians ? range->wanted_radians : range->wanted;
	char digits[NUMBER_MAX];

	if (v->unused || is_within(x, range, radians))
		return true;
	if (isinf(x))
		return value_refuse(v, "is beyond the range of doubles", wanted);
	*number_write(digits, x, (struct number_style){ NUMBER_SHORTEST, 0 }) = '\0';
	return value_refuse(v,
	    text("%s is %s", digits,
		range->min > 0 && x <= 0 ? "not positive" : "out of range"),
	    wanted);
}

bool value_number(const struct value *v, const struct value_range *range, double *out)
{
	*out = v->item->valuedouble;
	return value_is(v, JSON_NUMBER) ? value_in_range(v, range, *out) :
					  value_refuse_type(v, "a number");
}

bool value_numbers(const struct value *v, const struct value_range *range, size_t n,
    double *out)
{
	const size_t count = value_count(v);
	bool good = true;

	if (!value_is(v, JSON_ARRAY))
		return value_refuse_type(v, text("an array of %zu numbers", n));
	if (count != n)
		return value_refuse(v,
		    text("has %zu element%s", count, count == 1 ? "" : "s"),
		    text("an array of %zu numbers is wanted", n));
	for (struct value e = value_child(v); e.item != NULL; value_next(&e))
		good &= value_number(&e, range, out++);
	return good;
}

bool value_word(const struct value *v, const char *const *words,
    const char *const *aliases, unsigned *index)
{
	const char *word = value_string(v);
	const int found = word != NULL ? word_index(word, words, aliases) : -1;
	char list[LIST_ROOM];

	*index = found >= 0 ? (unsigned)found : 0;
	if (found >= 0)
		return true;
	if (word == NULL)
		return value_refuse_type(v, words_join(list, words, " or ", "\""));
	return value_refuse(v, text("is \"%.60s\"", word),
	    word_remedy(list, word, WORD_VALUE, words, "\""));
}

/* Returns where the value of the last member, or the element, `token` begins in the
 * array or object at s, which is JSON; NULL if there is none. */
static const char *find_token(const char *s, const char *end, struct span token)
{
	const bool members = *s == '{';
	const char *found = NULL;
	long index = members ? 0 : strtol(token.s, NULL, 10);

	if (!members && *s != '[')
		return NULL;
	for (s = json_skip_blanks(s + 1, end); s < end && *s != ']' && *s != '}';
	     s = json_next_item(json_item_end(s, end), end)) {
		const struct span name = { s, members ? json_string_end(s, end) : s };

		if (members)
			s = json_skip_blanks(json_skip_blanks(name.end, end) + 1, end);
		if (members ? json_is_name(name, token, true) : index-- == 0)
			found = s;
	}
	return found;
}

struct place json_source_place(const struct json_source *source, const char *pointer)
{
	struct place p = { .file = source->name, .pointer = pointer };
	struct refusal at = { .where = "" };

	if (source->text == NULL)
		return p;
	const char *s = json_skip_blanks(source->text, source->end), *next = s;

	for (const char *t = pointer; *t == '/' && next != NULL;) {
		const struct span token = { t + 1, t + 1 + strcspn(t + 1, "/") };

		next = find_token(s, source->end, token);
		s = next != NULL ? next : s;
		t = token.end;
	}
	set_place(source, source->text, s, &at);
	p.line = at.line;
	p.column = at.column;
	return p;
}
