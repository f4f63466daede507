/* SPDX-License-Identifier: MIT */
#include "value.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/scene/scene.h"
#include "../number/number.h"
#include "look.h"
#include "text.h"

const struct value_range range_any = { -SCENE_MAGNITUDE_MAX, SCENE_MAGNITUDE_MAX,
	.wanted = "numbers go up to 1e150" };
const struct value_range range_positive = { SCENE_SIZE_MIN, SCENE_MAGNITUDE_MAX,
	.wanted = "a number from 1e-150 to 1e150 is wanted" };

/* For cJSON, which would take a lack of memory for no JSON. */
static void *take(size_t size)
{
	return xrealloc(NULL, size);
}

/* Returns the tree of the text without the elements of the array `points`, if its s is
 * not NULL: cJSON would need 64 bytes for each number, and change their digits. Returns
 * NULL if the text is no JSON, and sets *stop to where it is none. */
static cJSON *parse_without(const char *begin, const char *end, struct span points,
    const char **stop)
{
	const size_t before = points.s != NULL ? (size_t)(points.s + 1 - begin) : 0;
	const size_t cut = points.s != NULL ? (size_t)(points.end - points.s - 2) : 0;
	const size_t n = (size_t)(end - begin) - cut;
	char *const copy = xrealloc(NULL, n + 1);
	const char *at;

	memcpy(copy, begin, before);
	memcpy(copy + before, begin + before + cut, n - before);
	/* so that cJSON stops at the end, not before it, of a text that ends too
	 * early */
	copy[n] = ' ';
	cJSON_InitHooks(&(cJSON_Hooks){ take, free });
	cJSON *const parsed = cJSON_ParseWithLengthOpts(copy, n + 1, &at, false);
	const size_t passed = (size_t)(at - copy);

	*stop = begin + passed + (passed >= before ? cut : 0);
	free(copy);
	return parsed;
}

bool value_parse_document(struct json_source *source, char *begin, size_t size,
    struct value *root, struct span *points)
{
	static cJSON *parsed;
	const char *const end = begin + size, *stop;
	struct look k;

	if (!look_at_text(source, begin, size, &k))
		return false;
	if (k.points.end == NULL || k.points.end[-1] != ']')
		k.points.s = NULL; /* it is not closed, which cJSON finds */
	cJSON_Delete(parsed);
	parsed = parse_without(begin, end, k.points, &stop);
	stop = parsed == NULL ? look_for_wrong(begin, stop, end) :
				json_skip_blanks(stop, end);
	if (parsed == NULL && (stop == end || k.in_string))
		return look_refuse_end(source, &k);
	if (stop == end)
		stop = look_for_wrong_number(begin, end, k.points);
	if (stop < end)
		return look_refuse_no_json(source, stop, end);
	*root = (struct value){ .source = source, .item = parsed };
	*points = k.points;
	return true;
}

struct value value_literal(const char *text)
{
	static struct refusals faults;
	static const struct json_source source = { .faults = &faults };
	static cJSON *parsed;

	cJSON_Delete(parsed);
	parsed = cJSON_Parse(text);
	return (struct value){ .source = &source, .item = parsed };
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

/* Returns the end. In a name, ~ becomes ~0 and / becomes ~1 (RFC 6901). A name that
 * does not fit into the room is cut at a character, and what is in it is left out. */
static char *write_pointer(const struct value *v, char *out, const char *end)
{
	enum { LEAST = sizeof "/..." + 24 }; /* an index has at most 20 digits */

	if (v->parent == NULL)
		return out;
	out = write_pointer(v->parent, out, end);
	if (end - out <= LEAST)
		return out;
	if (v->name == NULL)
		return out + sprintf(out, "/%zu", v->index);
	*out++ = '/';
	for (const char *s = v->name; *s != '\0';) {
		if (end - out < LEAST)
			return stpcpy(out, "...");
		if (*s == '~' || *s == '/')
			*out++ = '~';
		*out++ = *s == '~' ? '0' : *s == '/' ? '1' : *s;
		while ((*++s & 0xc0) == 0x80) /* the rest of a character */
			*out++ = *s;
	}
	return out;
}

bool value_refuse(const struct value *v, const char *what, const char *remedy)
{
	struct refusals *const faults = v->source->faults;
	char where[sizeof((struct refusal *)NULL)->where] = "";
	struct place p = { 0 };

	*write_pointer(v, where, where + sizeof where - 1) = '\0';
	/* to find a place takes a look at all of the text before it */
	if (refusals_have(faults, where, what, remedy))
		return false;
	if (faults->n < REFUSALS_MAX && v->item != NULL)
		p = look_at_value(v);
	return refuse_at(faults, where, what, remedy, p.line, p.column);
}

bool value_refuse_as(const struct value *v, enum json_type type, const char *wanted)
{
	static const char *const names[] = { "false", "true", "null", "a number",
		"a string", "an array", "an object" };

	return value_refuse(v, text("is %s", names[type]),
	    text("%s is wanted", wanted));
}

bool value_refuse_type(const struct value *v, const char *wanted)
{
	return value_refuse_as(v,
	    (enum json_type)__builtin_ctz((unsigned)v->item->type), wanted);
}

bool value_refuse_count(const struct value *v, size_t n, const char *remedy)
{
	return value_refuse(v, text("has %zu element%s", n, n == 1 ? "" : "s"), remedy);
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
	double beyond;

	if (!value_is(v, JSON_ARRAY))
		return value_refuse_type(v, text("an array of %zu numbers", n));
	if (count != n)
		good = value_refuse_count(v, count,
		    text("an array of %zu numbers is wanted", n));
	for (struct value e = value_child(v); e.item != NULL; value_next(&e))
		good &= value_number(&e, range, e.index < n ? &out[e.index] : &beyond);
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
	return value_refuse(v, text("is \"%.*s\"", (int)utf8_fit(word, 60), word),
	    word_remedy_of_value(list, word, words, aliases, "\""));
}
