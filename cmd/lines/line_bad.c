/* SPDX-License-Identifier: MIT */
#include "line_bad.h"

#include <stdio.h>

#include "../message/escape.h"
#include "cut.h"

const char *axis(int i)
{
	static const char *const words[] = { "x", "y", "z", "w" };

	return words[i];
}

static int count(struct span f, char c)
{
	int n = 0;

	for (; f.s < f.end; f.s++)
		n += *f.s == c;
	return n;
}

static bool has(struct span f, char c)
{
	return count(f, c) > 0;
}

/* What would be right in the place of f. Where reads says that a number begins
 * there, it is what comes after it that is wrong. */
static const char *hint(const struct layout *l, int i, struct span f)
{
	double v;

	if (l->in.format == FORMAT_CSV && l->in.separator != ',' && has(f, ','))
		return count(f, ',') == 1 ?
		    "; a decimal point is a point: 1.5" :
		    "; is a comma the separator? say -i csv alone";
	if (l->in.format != FORMAT_JSON && has(f, ';'))
		return "; is ; the separator? say -i csv --separator ';'";
	if (l->in.format != FORMAT_JSON && has(f, '|'))
		return "; is | the separator? say -i csv --separator '|'";
	if (l->in.format == FORMAT_CSV && has(f, ' ') &&
	    number_read(f.s, f.end, &v) != NULL)
		return "; are blanks the separator? leave -i csv out";
	if (number_read(f.s, f.end, &v) != NULL)
		return l->in.format == FORMAT_JSON ?
		    "; a number is wanted, as JSON writes it" :
		    l->in.format == FORMAT_CSV ?
		    "; a number is wanted, and nothing else in the field" :
		    "; a number is wanted, with a blank or comma behind it";
	if (l->in.format != FORMAT_JSON && l->columns.n == 0 && i == 0)
		return "; a number is wanted; --columns says which fields the "
		       "coordinates are";
	return "; a number is wanted";
}

void say_bad_field(const struct layout *l, int i, struct span f,
    char reason[REASON_MAX])
{
	size_t n = (size_t)(f.end - f.s);
	bool nested = n > 0 && (*f.s == '[' || *f.s == '{');
	char word[ESCAPED_MAX];

	if (nested && l->in.format != FORMAT_JSON)
		snprintf(reason, REASON_MAX,
		    "looks like JSON; say -i json, with one array or object a "
		    "line: jq -c '%s'",
		    *f.s == '[' ? ".[]" : ".points[]");
	else if (nested)
		snprintf(reason, REASON_MAX,
		    "%s is not a number; one array or object a line: jq -c "
		    "'.[]'",
		    axis(i));
	else if (n == 0)
		snprintf(reason, REASON_MAX,
		    "%s is missing; %d numbers are wanted", axis(i), l->reads);
	else
		snprintf(reason, REASON_MAX, "%s is '%s'%s", axis(i),
		    escaped(word, f.s, n), hint(l, i, f));
}

bool say_header_of_text(const struct layout *l, struct span text,
    char reason[REASON_MAX])
{
	struct cut c = cut_line(l->in, text);
	struct field f;

	if (l->columns.n > 0 || *c.s == '[' || *c.s == '{')
		return false;
	for (int i = 0; i < l->reads && cut_next(&c, &f); i++) {
		double v;

		if (number_read(f.value.s, f.value.end, &v) != NULL)
			return false;
	}
	snprintf(reason, REASON_MAX, "looks like a header; say %s",
	    has(text, ',')      ? "-i csv" :
		has(text, '\t') ? "-i tsv" :
		has(text, ';')  ? "-i csv --separator ';'" :
				  "-i csv --separator ' ', or put # before it");
	return true;
}

