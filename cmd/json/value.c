/* SPDX-License-Identifier: MIT */
#include "value.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../number/number.h"
#include "text.h"

struct json_faults json_faults;

const struct value_range range_any = { -SCENE_MAGNITUDE_MAX, SCENE_MAGNITUDE_MAX,
	.wanted = "numbers go up to 1e150" };
const struct value_range range_positive = { SCENE_SIZE_MIN, SCENE_MAGNITUDE_MAX,
	.wanted = "a number from 1e-150 to 1e150 is wanted" };

static const struct number_style shortest = { NUMBER_SHORTEST, 0 };

static struct place source_place_at(const struct json_source *source, const char *text,
    const char *at)
{
	struct place p = { .file = source->name,
		.line = source->lines_before + 1,
		.column = source->bytes_before + 1 };

	json_count_lines(text, at, &p.line, &p.column);
	return p;
}

struct place json_source_place(const struct json_source *source, const char *pointer)
{
	struct json_check c = { .text = source->text,
		.end = source->end,
		.pointer = pointer };
	struct place p = { .file = source->name };

	if (source->text != NULL && json_check(&c))
		p = source_place_at(source, c.text, c.found.s);
	p.pointer = pointer;
	p.of_scene = !source->is_operand;
	return p;
}

/* Writes blanks over the member at s, and over the comma that parts it from others. */
static char *blank_member(char *s, const char *end)
{
	char *next = (char *)json_item_end(s, end), *before = s;

	if (next < end && *next == ',') {
		next++;
	} else {
		while (json_is_blank(before[-1]))
			before--;
		if (before[-1] == ',')
			before[-1] = ' ';
	}
	memset(s, ' ', (size_t)(next - s));
	return next;
}

/* Changes a checked text so that cJSON reads it and takes less memory: blanks members
 * whose names begin with _. A number that is too long for cJSON becomes the shortest text
 * of the same double, filled up with blanks. */
static void edit_for_cjson(char *s, const char *end)
{
	char text[NUMBER_MAX], *text_end;
	double v;

	for (char *next; s < end; s = next) {
		next = s + 1;
		if (*s == '"') {
			const char *after = json_string_end(s, end);
			const char *colon = json_skip_blanks(after, end);

			next = s[1] == '_' && colon < end && *colon == ':' ?
			    blank_member(s, end) :
			    (char *)after;
			continue;
		}
		if (*s != '-' && (*s < '0' || *s > '9'))
			continue;
		next = (char *)number_read(s, end, &v);
		if (next - s <= CJSON_NUMBER_MAX)
			continue;
		memset(s, ' ', (size_t)(next - s));
		text_end = isfinite(v) ? number_write(text, v, shortest) :
					 stpcpy(text, "1e999");
		memcpy(s, text, (size_t)(text_end - text));
	}
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

/* Returns the tree of a checked text, which changes, or if array.s is not NULL of a copy
 * without the elements of the array: cJSON would need 64 bytes for each number. */
static const cJSON *parse_without(const struct json_check *c, char *text,
    struct span array)
{
	char *copy = NULL, *s = text;
	size_t n = (size_t)(c->end - text);

	if (array.s != NULL) {
		const size_t before = (size_t)(array.s + 1 - text);

		n = before + (size_t)(c->end - array.end) + 1;
		s = copy = xrealloc(NULL, n);
		memcpy(copy, text, before);
		memcpy(copy + before, array.end - 1, n - before);
	}
	if (c->needs_edit)
		edit_for_cjson(s, s + n);
	/* cJSON takes every text that json_check accepts */
	const cJSON *parsed = cJSON_ParseWithLength(s, n);

	free(copy);
	return parsed;
}

struct value value_parse_document(struct json_source *source, const char *pointer,
    char *text, size_t size, struct span *array)
{
	static char *texts[2];
	char **kept = &texts[source->is_operand];
	struct json_check c = { .text = text,
		.end = text + size,
		.line = source->lines_before + 1,
		.pointer = pointer };

	if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
		memset(text, ' ', 3); /* a byte order mark */
	if (message_state.json) {
		source->text = *kept = memcpy(xrealloc(*kept, size), text, size);
		source->end = source->text + size;
	}
	if (!json_check(&c)) {
		const struct place place = source_place_at(source, text, c.at);

		die_at(EXIT_INPUT, &place, "%s", c.reason);
	}
	if (!source->is_operand)
		take_back();
	json_faults = (struct json_faults){ 0 };
	*array = (struct span){ *c.found.s == '[' ? c.found.s : NULL, c.found.end };
	return (
	    struct value){ .source = source, .item = parse_without(&c, text, *array) };
}

const char *value_peek(struct value *v, const char *s, const char *end)
{
	/* the first characters of values, in the order of enum json_type */
	static const char begins[] = "ftn0\"[{";
	static cJSON item;
	v->item = &item;
	if (*s == '-' || (*s >= '0' && *s <= '9')) {
		item.type = cJSON_Number;
		return number_read(s, end, &item.valuedouble);
	}
	item.type = 1 << (strchr(begins, *s) - begins);
	return *s == '"' ? json_string_end(s, end) : s + (*s == 'f' ? 5 : 4);
}

struct value value_literal(const char *text)
{
	static const struct json_source source;

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

bool value_member(const struct value *object, const char *name, struct value *member)
{
	*member = value_child(object);
	while (member->item != NULL &&
	    (member->name == NULL || strcmp(member->name, name) != 0))
		value_next(member);
	return member->item != NULL;
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

/* Returns the end. In a name, ~ becomes ~0 and / becomes ~1 (RFC 6901). */
static char *write_pointer(const struct value *v, char *out)
{
	if (v->parent == NULL)
		return out;
	out = write_pointer(v->parent, out);
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

struct place value_place(const struct value *v, char pointer[POINTER_ROOM])
{
	*write_pointer(v, pointer) = '\0';
	return json_source_place(v->source, pointer);
}

static void tell_fault(const struct value *v, const char *format, va_list args)
{
	char pointer[POINTER_ROOM];

	json_faults.n++;
	if (json_faults.unknown > UNKNOWN_TOLD_MAX)
		return;
	const struct place place = value_place(v, pointer);

	vsay_at(EXIT_INPUT, &place, format, args);
}

void value_fault(const struct value *v, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	tell_fault(v, format, args);
	va_end(args);
}

void value_refuse(const struct value *v, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	tell_fault(v, format, args);
	va_end(args);
	value_give_up(v);
}

void value_give_up(const struct value *v)
{
	if (json_faults.next != NULL)
		longjmp(*json_faults.next, 1);
	if (json_faults.unknown > UNKNOWN_TOLD_MAX) {
		const struct place place = json_source_place(v->source, "");

		say_at(EXIT_INPUT, &place, "%zu unknown members", json_faults.unknown);
	}
	quit(EXIT_INPUT, !v->source->is_operand);
}

void value_refuse_type(const struct value *v, const char *wanted)
{
	static const char *const names[] = { "false", "true", "null", "a number",
		"a string", "an array", "an object" };

	value_refuse(v, "is %s; %s is wanted",
	    names[__builtin_ctz((unsigned)v->item->type)], wanted);
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

double value_number(const struct value *v, const struct value_range *range)
{
	bool radians = range->wanted_radians != NULL &&
	    v->source->unit == ANGLE_RADIANS;
	const char *wanted = radians ? range->wanted_radians : range->wanted;
	double x = v->item->valuedouble;
	char text[NUMBER_MAX];

	if (!value_is(v, JSON_NUMBER))
		value_refuse_type(v, "a number");
	if (v->unused || is_within(x, range, radians))
		return x;
	if (isinf(x))
		value_refuse(v, "is beyond the range of doubles; %s", wanted);
	*number_write(text, x, shortest) = '\0';
	value_refuse(v, "%s is %s; %s", text,
	    range->min > 0 && x <= 0 ? "not positive" : "out of range", wanted);
}

void value_numbers(const struct value *v, const struct value_range *range, size_t n,
    const char *hint, double *out)
{
	const size_t count = value_count(v);
	char wanted[LIST_ROOM];

	if (count != n) {
		snprintf(wanted, sizeof wanted, "an array of %zu numbers%s", n, hint);
		if (!value_is(v, JSON_ARRAY))
			value_refuse_type(v, wanted);
		value_refuse(v, "has %zu element%s; %s is wanted", count,
		    count == 1 ? "" : "s", wanted);
	}
	struct value e = value_child(v);

	for (; e.item != NULL; value_next(&e))
		*out++ = value_number(&e, range);
}

int value_find_word(const struct value *v, const char *const *words)
{
	const char *word = value_string(v);

	for (int i = 0; word != NULL && words[i] != NULL; i++)
		if (strcmp(word, words[i]) == 0)
			return i;
	return -1;
}

int value_word(const struct value *v, const char *const *words)
{
	const int found = value_find_word(v, words);
	const char *word = value_string(v);
	struct word_guess g = { .word = word };
	char all[LIST_ROOM];

	if (found >= 0)
		return found;
	words_join(all, words, " or ", "\"");
	if (word == NULL)
		value_refuse_type(v, all);
	word_offer_list(&g, words, "did you mean \"%s\"?");
	word_offer(&g, WORD_ELSE, "%s is wanted", all);
	value_refuse(v, "is \"%.60s\"; %s", word, g.remedy);
}
