/* SPDX-License-Identifier: MIT */
#include "say.h"

#include <math.h>
#include <stdio.h>

#include "../../core/scene/scene.h"
#include "../message/escape.h"
#include "../message/nearest.h"
#include "cut.h"

bool say_range(int i, double v, char reason[REASON_MAX])
{
	if (!(fabs(v) > MAGNITUDE_MAX))
		return true;
	snprintf(reason, REASON_MAX,
	    isinf(v) ?
		"%s is infinite; a number up to 1e150 is wanted, or nan" :
		"%s is beyond 1e150 in magnitude; choose another unit",
	    coordinate_name(i));
	return false;
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

/* Returns what would be right in the place of f. If a number begins there, what
 * comes after it is wrong. */
static const char *hint(const struct layout *l, int i, struct span f)
{
	const struct format_row *in = format_of(l->in);
	bool json = *in->open != '\0';
	double v;
	bool begins = number_read(f.s, f.end, &v) != NULL;

	if (in->header && l->in.separator != ',' && has(f, ','))
		return count(f, ',') == 1 ?
		    "; a decimal point is a point: 1.5" :
		    "; is a comma the separator? say -i csv alone";
	if (!json && has(f, ';'))
		return "; is ; the separator? say -i csv --separator ';'";
	if (!json && has(f, '|'))
		return "; is | the separator? say -i csv --separator '|'";
	if (in->header && has(f, ' ') && begins)
		return "; are blanks the separator? leave -i csv out";
	if (begins)
		return json ?
		    "; a number is wanted, as JSON writes it" :
		    in->header ?
		    "; a number is wanted, and nothing else in the field" :
		    "; a number is wanted, with a blank or comma behind it";
	if (!json && l->columns.n == 0 && i == 0)
		return "; a number is wanted; --columns says which fields the "
		       "coordinates are";
	return "; a number is wanted";
}

void say_field(const struct layout *l, int i, struct span f,
    char reason[REASON_MAX])
{
	size_t n = (size_t)(f.end - f.s);
	bool nested = n > 0 && (*f.s == '[' || *f.s == '{');
	char word[ESCAPED_MAX];

	if (nested && *format_of(l->in)->open == '\0')
		snprintf(reason, REASON_MAX,
		    "looks like JSON; say -i json, with one array or object a "
		    "line: jq -c '%s'",
		    *f.s == '[' ? ".[]" : ".points[]");
	else if (nested)
		snprintf(reason, REASON_MAX,
		    "%s is not a number; one array or object a line: jq -c "
		    "'.[]'",
		    coordinate_name(i));
	else if (n == 0)
		snprintf(reason, REASON_MAX,
		    "%s is missing; %d numbers are wanted%s",
		    coordinate_name(i), l->reads,
		    i == 2 && l->two != NULL ? l->two : "");
	else
		snprintf(reason, REASON_MAX, "%s is '%s'%s", coordinate_name(i),
		    escaped(word, f.s, n), hint(l, i, f));
}

enum { NAMES_MAX = 32, NAME_ROOM = 64 };

/* Writes to the end of the reason, as far as there is room. */
static void say_more(char reason[REASON_MAX], const char *before,
    const char *name, const char *after)
{
	char shown[ESCAPED_MAX];
	size_t n = strlen(reason);

	snprintf(reason + n, REASON_MAX - n, "%s%s%s", before,
	    escaped(shown, name, strlen(name)), after);
}

void say_names(struct cut c, const char *wanted, char reason[REASON_MAX])
{
	const size_t room = REASON_MAX - ESCAPED_MAX - 8;
	char name[NAMES_MAX][NAME_ROOM];
	const char *list[NAMES_MAX + 1], *near;
	int n = 0, i = 0;
	bool more = false;
	struct field f;

	while (cut_next(&c, &f)) {
		struct span all = c.members ?
		    (struct span){ f.name.s + 1, f.name.end - 1 } :
		    trimmed(c.in, f.value);
		size_t size = (size_t)(all.end - all.s);

		if (n == NAMES_MAX || size >= NAME_ROOM) {
			more = true;
			continue;
		}
		memcpy(name[n], all.s, size);
		name[n][size] = '\0';
		list[n] = name[n];
		n++;
	}
	list[n] = NULL;
	if (n == 0 && !more)
		return;
	near = nearest(wanted, list);
	if (near != NULL)
		say_more(reason, "; did you mean '", near, "'? it has ");
	else
		say_more(reason, "; it has ", "", "");
	for (; i < n && strlen(reason) < room; i++)
		say_more(reason, i > 0 ? ", " : "", name[i], "");
	if (i < n || more)
		say_more(reason, i > 0 ? ", ..." : "...", "", "");
}

void say_text_header(const struct layout *l, struct span line,
    char reason[REASON_MAX])
{
	struct cut c = cut_line(l->in, line);
	struct field f;

	for (int i = 0; i < l->reads && cut_next(&c, &f); i++) {
		double v;

		if (number_read(f.value.s, f.value.end, &v) != NULL ||
		    (i == 0 && (*f.value.s == '[' || *f.value.s == '{')))
			return;
	}
	snprintf(reason, REASON_MAX, "looks like a header; say %s",
	    has(line, ',')      ? "-i csv" :
		has(line, '\t') ? "-i tsv" :
		has(line, ';')  ? "-i csv --separator ';'" :
				  "-i csv --separator ' ', or put # before it");
}
