/* SPDX-License-Identifier: MIT */
#include "value.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../message/nearest.h"
#include "../number/number.h"
#include "../message/message.h"
#include "text.h"

const struct value_range range_any = { .min = -MAGNITUDE_MAX,
	.max = MAGNITUDE_MAX };
const struct value_range range_turn = { .min = -MAGNITUDE_MAX,
	.max = MAGNITUDE_MAX,
	.angle = true };
const struct value_range range_positive = { .min = SIZE_MIN,
	.max = MAGNITUDE_MAX };

static const struct number_style shortest = { NUMBER_SHORTEST, 0 };

struct value value_parse(struct source *source, const char *name, char *text,
    size_t size)
{
	struct value v = { .source = source };
	struct json_error e;

	if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
		memset(text, ' ', 3); /* a byte order mark */
	source->end = text + size;
	if (!json_check_part(text, source->end, source->line + 1, name,
		&source->array, &e))
		die_at(EXIT_INPUT,
		    &(struct place){ .file = source->name, .line = e.line },
		    "%s", e.reason);
	if (source->array.s != NULL && *source->array.s != '[')
		source->array.s = NULL;
	v.s = json_space(text, source->end);
	return v;
}

/* Moves *v to the value behind at, an opening bracket, or a comma or bracket behind a
 * value. */
static void value_move(struct value *v, const char *at)
{
	const char *end = v->source->end;
	const struct span *array = &v->source->array;
	const char *s = at;

	v->s = NULL;
	if (*s == ']' || *s == '}')
		return;
	s = json_space(s + 1, end);
	if (*s == ']' || *s == '}')
		return;
	if (v->named) {
		json_string_copy(s, end, v->name, NAME_ROOM);
		s = json_space(json_string(s, end), end);
		s = json_space(s + 1, end);
	}
	v->s = s;
	v->after = json_skip(s == array->s ? array->end : s, end);
}

struct value value_child(const struct value *v)
{
	struct value child = { .source = v->source,
		.in = v,
		.unused = v->unused,
		.named = *v->s == '{' };

	if (*v->s == '{' || *v->s == '[')
		value_move(&child, v->s);
	return child;
}

void value_next(struct value *v)
{
	v->index++;
	value_move(v, v->after);
}

struct value value_missing(const struct value *in, const char *name)
{
	struct value v = { .source = in->source, .in = in, .named = true };

	strcpy(v.name, name);
	return v;
}

bool value_member(const struct value *object, const char *name,
    struct value *member)
{
	*member = value_child(object);
	while (member->s != NULL && strcmp(member->name, name) != 0)
		value_next(member);
	return member->s != NULL;
}

bool value_is_object(const struct value *v)
{
	return *v->s == '{';
}

bool value_is_array(const struct value *v)
{
	return *v->s == '[';
}

bool value_is_null(const struct value *v)
{
	return *v->s == 'n';
}

const char *value_string(const struct value *v, char out[NAME_ROOM])
{
	if (*v->s != '"')
		return NULL;
	json_string_copy(v->s, v->source->end, out, NAME_ROOM);
	return out;
}

size_t value_count(const struct value *v)
{
	struct value e = value_child(v);

	while (e.s != NULL)
		value_next(&e);
	return e.index;
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
	if (v->named)
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
	va_start(args, format);
	vdie_at(EXIT_INPUT,
	    &(struct place){ .file = v->source->name, .pointer = way }, format,
	    args);
	va_end(args);
}

void value_wrong(const struct value *v, const char *wanted)
{
	const char *is = "a number";

	switch (*v->s) {
	case 'f':
		is = "false";
		break;
	case 't':
		is = "true";
		break;
	case 'n':
		is = "null";
		break;
	case '"':
		is = "a string";
		break;
	case '[':
		is = "an array";
		break;
	case '{':
		is = "an object";
	}
	value_refuse(v, "is %s; %s is wanted", is, wanted);
}

void value_want_object(const struct value *v)
{
	if (!value_is_object(v))
		value_wrong(v, "an object");
}

/* Whether a range's limits are parts of pi: radians, of an angle that has limits. */
static bool is_by_pi(const struct value_range *r, unsigned unit)
{
	return r->angle && unit == RADIANS && r->max < MAGNITUDE_MAX;
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

enum { LIMIT_ROOM = 24, WANTED_ROOM = 100 };

static void write_limit(char out[LIMIT_ROOM], double v, bool by_pi)
{
	if (v == SIZE_MIN)
		strcpy(out, "0");
	else if (!by_pi || v == 0)
		snprintf(out, LIMIT_ROOM, "%g", v);
	else
		snprintf(out, LIMIT_ROOM, "%spi%s", v < 0 ? "-" : "",
		    fabs(v) == 90 ? "/2" : "");
}

/* Writes the sentence that tells a range. */
static void write_wanted(char out[WANTED_ROOM], const struct value_range *r,
    bool by_pi)
{
	bool above = r->above || r->min == SIZE_MIN;
	char min[LIMIT_ROOM], max[LIMIT_ROOM];

	write_limit(min, r->min, by_pi);
	write_limit(max, r->max, by_pi);
	if (r->max == MAGNITUDE_MAX)
		strcpy(out,
		    r->min < 0 ? "numbers go up to 1e150" :
				 "a number from 1e-150 to 1e150 is wanted");
	else
		snprintf(out, WANTED_ROOM, "%s %s %s %s%s%s%s is wanted",
		    r->angle ? "an angle" : "a number",
		    above ? "above" : "from", min,
		    !above       ? "to " :
			r->below ? "and " :
				   "and up to ",
		    r->below ? "below " : "", max,
		    !r->angle ? "" :
			by_pi ? " radians" :
				" degrees");
}

double value_number(const struct value *v, const struct value_range *range)
{
	bool by_pi = is_by_pi(range, v->source->unit);
	char wanted[WANTED_ROOM];
	char text[NUMBER_MAX], word[NAME_ROOM];
	double x;

	if (value_string(v, word) != NULL && strcmp(word, "infinity") == 0)
		value_refuse(v, "only \"far\" of \"persp\" can be infinite");
	if (strchr("-0123456789", *v->s) == NULL)
		value_wrong(v, "a number");
	number_read(v->s, v->source->end, &x);
	if (v->unused || is_within(x, range, by_pi))
		return x;
	write_wanted(wanted, range, by_pi);
	if (isinf(x))
		value_refuse(v, "is beyond the range of doubles; %s", wanted);
	*number_write(text, x, shortest) = '\0';
	value_refuse(v, "%s is %s; %s", text,
	    range->min > 0 && x <= 0 ? "not positive" : "out of range", wanted);
}

bool value_flag(const struct value *v)
{
	if (*v->s != 't' && *v->s != 'f')
		value_wrong(v, "true or false");
	return *v->s == 't';
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

	for (; e.s != NULL; value_next(&e))
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
	char all[LISTED], shown[ESCAPED_MAX], word[NAME_ROOM];
	const char *s = value_string(v, word), *near;

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
