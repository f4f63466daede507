/* SPDX-License-Identifier: MIT */
#include "value.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../message/nearest.h"
#include "../number/number.h"
#include "../message/escape.h"
#include "../message/message.h"
#include "text.h"

#define UP_TO "numbers go up to 1e150"

const struct value_range range_any = { -MAGNITUDE_MAX, MAGNITUDE_MAX,
	.says = UP_TO };
const struct value_range range_turn = { -MAGNITUDE_MAX, MAGNITUDE_MAX,
	.says = UP_TO, .angle = true };
const struct value_range range_positive = { SIZE_MIN, MAGNITUDE_MAX,
	.says = "a number from 1e-150 to 1e150 is wanted" };

static const struct number_style shortest = { NUMBER_SHORTEST, 0 };

/* cJSON takes no more characters than these for a number, and what follows for
 * something else. */
enum { CJSON_NUMBER_MAX = 63 };

/* A text that grows. */
struct copy {
	char *s;
	size_t n, room;
};

static void copy_add(struct copy *c, const char *s, size_t n)
{
	if (c->room - c->n < n) {
		c->room = 2 * c->room + n;
		c->s = need(c->s, c->room);
	}
	memcpy(c->s + c->n, s, n);
	c->n += n;
}

/* Adds a number, which is v, or where cJSON does not take all of its n characters the
 * shortest text of v. */
static void copy_number(struct copy *c, const char *s, size_t n, double v)
{
	char text[NUMBER_MAX] = "1e999", *end = text + 5;

	if (n > CJSON_NUMBER_MAX && isfinite(v))
		end = number_write(text, v, shortest);
	if (n > CJSON_NUMBER_MAX)
		copy_add(c, text, (size_t)(end - text));
	else
		copy_add(c, s, n);
}

/* Returns where a member ends, with the comma behind it, whose name is the string from s
 * to stop and begins with _; NULL where no such member is there. */
static const char *pass_hidden(const char *s, const char *stop, const char *end)
{
	char first[4] = { s[1] };
	int n;

	if (first[0] == '\\')
		json_unescape(s + 1, end, first, &n);
	stop = json_space(stop, end);
	if (first[0] != '_' || stop == end || *stop != ':')
		return NULL;
	stop = json_skip(stop, end);
	return stop + (*stop == ',');
}

/* Parses checked text but for a part, which becomes [], and for members whose names
 * begin with _, so that they take no memory. cJSON takes whatever passes the check;
 * where it fails, memory is short. */
static const struct cJSON *parse(const char *s, const char *end,
    const struct span *part)
{
	struct copy c = { 0 };
	const char *next;
	double v;

	for (; s < end; s = next) {
		next = s + 1;
		if (s == part->s) {
			copy_add(&c, "[]", 2);
			next = part->end;
		} else if (*s == '"') {
			const char *stop = json_string(s, end);

			next = pass_hidden(s, stop, end);
			if (next == NULL)
				copy_add(&c, s, (size_t)(stop - s));
			else if (*next == '}' && c.s[c.n - 1] == ',')
				c.n--;
			if (next == NULL)
				next = stop;
		} else if (json_number(s, end, &v) != NULL) {
			next = json_number(s, end, &v);
			copy_number(&c, s, (size_t)(next - s), v);
		} else if ((unsigned char)*s > ' ') {
			copy_add(&c, s, 1);
		}
	}
	const cJSON *item = cJSON_ParseWithLength(c.s, c.n);

	if (item == NULL)
		die(EXIT_SYSTEM, "out of memory");
	free(c.s);
	return item;
}

/* Keeps the text of a document, or of an operand, where messages tell its lines. */
static void source_keep(struct source *source, const char *text, size_t size)
{
	static char *kept[2];
	char **copy = &kept[source->operand];

	if (!says_json())
		return;
	*copy = memcpy(need(*copy, size), text, size);
	source->text = *copy;
	source->end = *copy + size;
}

/* Says in which line and column a byte of the text stands. */
static void source_count(const struct source *source, size_t offset,
    struct place *p)
{
	p->line = source->line + 1;
	p->column = source->before + offset + 1;
	for (size_t i = 0; i < offset; i++)
		if (source->text[i] == '\n') {
			p->line++;
			p->column = offset - i;
		}
}

struct place source_place(const struct source *source, const char *pointer)
{
	struct place p = { .file = source->name, .pointer = pointer };

	if (source->text != NULL)
		source_count(source,
		    (size_t)(json_at(source->text, source->end, pointer) -
			source->text),
		    &p);
	return p;
}

/* The values that were parsed last; a refusal does not come back to free them. */
static const struct cJSON *parsed;

struct value value_parse_without(struct source *source, const char *name,
    char *text, size_t size, struct span *array)
{
	struct json_error e;

	if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
		memset(text, ' ', 3); /* a byte order mark */
	source_keep(source, text, size);
	if (!json_check_part(text, text + size, source->line + 1, name, array,
		&e)) {
		struct place place = { .file = source->name, .line = e.line };

		if (source->text != NULL)
			source_count(source, (size_t)(e.at - text), &place);
		die_at(EXIT_INPUT, &place, "%s", e.reason);
	}
	if (array->s == NULL || *array->s != '[')
		array->s = NULL;
	cJSON_Delete((cJSON *)parsed);
	parsed = parse(text, text + size, array);
	return (struct value){ .source = source, .item = parsed };
}

void value_parse_part(struct value *v, const char *s, const char *end)
{
	static const struct cJSON *part;

	cJSON_Delete((cJSON *)part);
	v->item = part = parse(s, end, &(struct span){ NULL, NULL });
}

struct value value_literal(const struct source *source, const char *text)
{
	static struct {
		const char *text;
		const struct cJSON *item;
	} known[LITERALS];
	size_t i = 0;

	while (known[i].text != NULL && known[i].text != text)
		i++;
	if (known[i].text == NULL) {
		known[i].item = cJSON_Parse(text);
		if (known[i].item == NULL)
			die(EXIT_SYSTEM, "out of memory");
		known[i].text = text;
	}
	return (struct value){ .source = source, .item = known[i].item };
}

struct value value_child(const struct value *v)
{
	const cJSON *item = v->item->child;

	return (struct value){ .source = v->source,
		.in = v,
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

struct value value_missing(const struct value *in, const char *name)
{
	return (struct value){ .source = in->source, .in = in, .name = name };
}

bool value_member(const struct value *object, const char *name,
    struct value *member)
{
	*member = value_child(object);
	while (member->item != NULL && strcmp(member->name, name) != 0)
		value_next(member);
	return member->item != NULL;
}

bool value_is_object(const struct value *v)
{
	return cJSON_IsObject(v->item);
}

bool value_is_array(const struct value *v)
{
	return cJSON_IsArray(v->item);
}

bool value_is_null(const struct value *v)
{
	return cJSON_IsNull(v->item);
}

const char *value_string(const struct value *v)
{
	return cJSON_GetStringValue(v->item);
}

size_t value_count(const struct value *v)
{
	size_t n = 0;

	for (const cJSON *item = v->item->child; item != NULL;
	     item = item->next)
		n++;
	return n;
}

/* A step of a pointer: ~ is ~0, / is ~1 (RFC 6901). */
static void step(char out[ESCAPED_MAX], const char *name)
{
	char way[2 * ESCAPED_MAX];
	size_t n = 0;

	for (; *name != '\0' && n + 2 <= sizeof way; name++) {
		if (*name == '~' || *name == '/')
			way[n++] = '~';
		char c = *name;

		way[n++] = c == '~' ? '0' : c == '/' ? '1' : c;
	}
	escaped(out, way, n);
}

/* No value is looked at that is deeper than /camera/matrix/matrix/3/3. */
enum { STEPS_MAX = 5 };

/* Writes the pointer to a value, as /camera/eye/0; returns where it ends. */
static char *pointer(const struct value *v, char *out)
{
	char name[ESCAPED_MAX];

	if (v->in == NULL)
		return out;
	out = pointer(v->in, out);
	if (v->name != NULL)
		step(name, v->name);
	else
		snprintf(name, sizeof name, "%zu", v->index);
	return out + sprintf(out, "/%s", name);
}

void value_refuse(const struct value *v, const char *format, ...)
{
	char way[STEPS_MAX * ESCAPED_MAX + 1];
	va_list args;

	*pointer(v, way) = '\0';
	const struct place place = source_place(v->source, way);

	va_start(args, format);
	if (v->source->operand)
		vdie_at(EXIT_INPUT, &place, format, args);
	vrefuse_at(&place, format, args);
	va_end(args);
}

void value_wrong(const struct value *v, const char *wanted)
{
	static const struct {
		int type;
		const char *name;
	} names[] = {
		{ cJSON_False, "false" },
		{ cJSON_True, "true" },
		{ cJSON_NULL, "null" },
		{ cJSON_Number, "a number" },
		{ cJSON_String, "a string" },
		{ cJSON_Array, "an array" },
	};
	const char *name = "an object";

	for (size_t i = 0; i < sizeof names / sizeof *names; i++)
		if ((v->item->type & 0xff) == names[i].type)
			name = names[i].name;
	value_refuse(v, "is %s; %s is wanted", name, wanted);
}

void value_want_object(const struct value *v)
{
	if (!value_is_object(v))
		value_wrong(v, "an object");
}

/* PI and its half are the largest doubles below what they stand for. */
static bool is_within(double x, const struct value_range *r, bool by_pi)
{
	double min = r->min, max = r->max;

	if (by_pi) {
		min = min == SIZE_MIN ? min : min / 180 * PI;
		max = max / 180 * PI;
	}
	return (x > min || (x == min && (by_pi || !r->above))) &&
	    (x < max || (x == max && (by_pi || !r->below)));
}

double value_number(const struct value *v, const struct value_range *range)
{
	bool by_pi = range->by_pi != NULL && v->source->unit == RADIANS;
	const char *wanted = by_pi ? range->by_pi : range->says;
	double x = v->item->valuedouble;
	char text[NUMBER_MAX];

	if (cJSON_IsString(v->item) &&
	    strcmp(v->item->valuestring, "infinity") == 0)
		value_refuse(v, "only \"far\" of \"persp\" can be infinite");
	if (!cJSON_IsNumber(v->item))
		value_wrong(v, "a number");
	if (v->unused || is_within(x, range, by_pi))
		return x;
	if (isinf(x))
		value_refuse(v, "is beyond the range of doubles; %s", wanted);
	*number_write(text, x, shortest) = '\0';
	value_refuse(v, "%s is %s; %s", text,
	    range->min > 0 && x <= 0 ? "not positive" : "out of range", wanted);
}

bool value_flag(const struct value *v)
{
	if (!cJSON_IsBool(v->item))
		value_wrong(v, "true or false");
	return cJSON_IsTrue(v->item);
}

void value_numbers(const struct value *v, const struct value_range *range,
    size_t n, double *out)
{
	char wanted[40];

	snprintf(wanted, sizeof wanted, "an array of %zu numbers", n);
	if (!value_is_array(v))
		value_wrong(v, wanted);
	if (value_count(v) != n)
		value_refuse(v, "has %zu element%s; %s is wanted",
		    value_count(v), value_count(v) == 1 ? "" : "s", wanted);
	struct value e = value_child(v);

	for (; e.item != NULL; value_next(&e))
		*out++ = value_number(&e, range);
}

static const char *between(const char *const *rest, const char *last)
{
	return rest[0] == NULL ? "" : rest[1] == NULL ? last : ", ";
}

const char *list_words(char out[LISTED], const char *const *words,
    const char *last, const char *quote)
{
	size_t at = 0;

	*out = '\0';
	for (int i = 0; words[i] != NULL && at < LISTED; i++)
		at += (size_t)snprintf(out + at, LISTED - at, "%s%s%s%s", quote,
		    words[i], quote, between(words + i + 1, last));
	return out;
}

int value_word(const struct value *v, const char *const *words)
{
	const char *s = value_string(v), *near;
	char all[LISTED], shown[ESCAPED_MAX];

	list_words(all, words, " or ", "\"");
	if (s == NULL)
		value_wrong(v, all);
	for (int i = 0; words[i] != NULL; i++)
		if (strcmp(s, words[i]) == 0)
			return i;
	near = nearest(s, words);
	escaped(shown, s, strlen(s));
	if (near != NULL)
		value_refuse(v, "is \"%s\"; did you mean \"%s\"?", shown, near);
	value_refuse(v, "is \"%s\"; %s is wanted", shown, all);
}
