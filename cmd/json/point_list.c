/* SPDX-License-Identifier: MIT */
#include "point_list.h"

#include <string.h>

#include "look.h"
#include "text.h"

static bool refuse_byte(const struct json_source *source, const char *s,
    const char *wanted)
{
	return look_refuse(source, s,
	    text("expected %s, not '%c'", wanted, (unsigned char)*s < 0x7f ? *s : '?'),
	    *s == ']' ? "remove the comma before it" : NULL);
}

/* Refuses the value at s, which is no `wanted`. */
static bool refuse_type_at(const struct value *v, const char *s, const char *wanted)
{
	static const char begins[] = "ftn-\"[{"; /* values of each type */
	const char *const type = strchr(begins, *s);

	return value_refuse_as(v,
	    type != NULL ? (enum json_type)(type - begins) : JSON_NUMBER, wanted);
}

static const char *value_end(const char *s, const char *end)
{
	return *s == '"'           ? json_string_end(s, end) :
	    *s == '[' || *s == '{' ? json_item_end(s, end) :
				     json_scalar_end(s, end);
}

/* Returns whether the number from s to end is surely in range_any, as most are: without
 * an exponent it needs more digits to be beyond it. */
static bool is_short(const char *s, const char *end)
{
	const size_t n = (size_t)(end - s);

	return n < 100 && memchr(s, 'e', n) == NULL && memchr(s, 'E', n) == NULL;
}

/* Checks element e of a point, whose text is from s to end. */
static bool check_element(const struct value *e, const char *s, const char *end,
    bool coordinate)
{
	double x;

	if (coordinate && (*s == '-' || (*s >= '0' && *s <= '9'))) {
		if (is_short(s, end))
			return true;
		json_number(s, end, &x);
		return value_in_range(e, &range_any, x);
	}
	if (coordinate ? *s != 'n' : *s == '[' || *s == '{')
		return refuse_type_at(e, s,
		    coordinate ? "a number" : "a number, a string or null");
	return true;
}

/* Checks the point v, whose text begins at *s, and moves *s to its end. Returns false
 * if the text is no JSON; other faults are refused, and the next point can be
 * checked. */
static bool check_point(const struct value *v, const char **s, const char *end,
    int coordinates)
{
	struct value e = { v->source, .parent = v, .unused = v->unused };
	const char *p = *s, *stop;
	size_t wrong = 0;

	if (*p != '[') {
		*s = value_end(p, end);
		if (*s == NULL)
			return refuse_byte(v->source, p, "a point");
		if (*p == '{')
			value_refuse(v, "is an object",
			    "here a point is an array; a file may have objects");
		else
			refuse_type_at(v, p, "an array of coordinates");
		return true;
	}
	for (p = json_skip_blanks(p + 1, end); *p != ']' || e.index > 0; e.index++) {
		stop = value_end(p, end);
		if (stop == NULL)
			return refuse_byte(v->source, p, "a value");
		wrong += !check_element(&e, p, stop, e.index < (size_t)coordinates);
		p = json_skip_blanks(stop, end);
		if (*p == ']') {
			e.index++;
			break;
		}
		if (*p != ',')
			return refuse_byte(v->source, p, "',' or ']'");
		p = json_skip_blanks(p + 1, end);
	}
	*s = p + 1;
	const char *hint = e.index == 2 && v->source->two_numbers_hint != NULL ?
	    v->source->two_numbers_hint :
	    "";

	/* of what is no number at all, how many there are is no fault of its own */
	if (e.index < (size_t)coordinates && (wrong < e.index || e.index == 0))
		value_refuse_count(v, e.index,
		    text("%d coordinates are wanted%s%s", coordinates,
			*hint != '\0' ? "; " : "", hint));
	return true;
}

/* Does for one or all points what check_point does. */
static bool check_points(const struct value *v, const struct span *array, bool single,
    int coordinates)
{
	struct value e = { v->source, .parent = v, .unused = v->unused };
	const char *s = array->s, *const end = array->end;

	if (single)
		return check_point(v, &s, end, coordinates);
	for (s = json_skip_blanks(s + 1, end); *s != ']' || e.index > 0; e.index++) {
		if (!check_point(&e, &s, end, coordinates))
			return false;
		s = json_skip_blanks(s, end);
		if (*s == ']')
			break;
		if (*s != ',')
			return refuse_byte(v->source, s, "',' or ']'");
		s = json_skip_blanks(s + 1, end);
	}
	return true;
}

/* Writes a line of the point at *s, without blanks, and moves *s to its end. */
static char *cut_point(const char **s, const char *end, char *out)
{
	const char *p = *s;

	for (; *p != ']'; p++) {
		const char *last = *p == '"' ? json_string_end(p, end) - 1 : p;

		while (p < last) /* of the string, without its closing quote */
			*out++ = *p++;
		*out = *p;
		out += !json_is_blank(*p);
	}
	*s = p + 1;
	*out++ = ']';
	*out++ = '\n';
	return out;
}

bool points_cut(const struct value *v, struct span *array, int coordinates)
{
	const char *s = json_skip_blanks(array->s + 1, array->end);
	const bool single = *s != '[' && *s != '{' && *s != ']';
	const size_t faults = v->source->faults->n;
	char *out = (char *)array->s;

	if (!check_points(v, array, single, coordinates) ||
	    v->source->faults->n != faults)
		return false;
	if (single)
		s = array->s;
	while (s < array->end && *s != ']')
		if (*s == '[')
			out = cut_point(&s, array->end, out);
		else
			s++; /* a blank, or a comma */
	array->end = out;
	return true;
}
