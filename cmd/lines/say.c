/* SPDX-License-Identifier: MIT */
#include "say.h"

#include <math.h>
#include <stdio.h>
#include <strings.h>

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

/* Returns what to say if another separator than that of csv stands in f, which is
 * all of a line or a field of several; else NULL. */
static const char *other_separator(const struct layout *l, struct span f,
    bool alone)
{
	char used = format_of(l->in)->header ? l->in.separator : ',';

	if (used != ';' && has(f, ';'))
		return "; is ; the separator? say -i csv --separator ';'";
	if (used != '|' && has(f, '|'))
		return "; is | the separator? say -i csv --separator '|'";
	if (used != '\t' && has(f, '\t'))
		return "; is a tab the separator? say -i tsv";
	if (used != ',' && alone && has(f, ','))
		return "; is a comma the separator? say -i csv alone";
	if (used != ' ' && alone && has(f, ' '))
		return "; are blanks the separator? say --separator ' '";
	return NULL;
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
	const char *other = other_separator(l, f, false);

	if (!json && other != NULL)
		return other;
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

/* The names of columns or members: the first of them, without long ones. */
struct names {
	char name[NAMES_MAX][NAME_ROOM];
	int field[NAMES_MAX];
	int n;
	bool more; /* there are others */
};

static void names_of(struct cut c, struct names *names)
{
	struct field f;

	names->n = 0;
	names->more = false;
	for (int k = 0; cut_next(&c, &f); k++) {
		struct span all = c.members ?
		    (struct span){ f.name.s + 1, f.name.end - 1 } :
		    f.value;
		size_t size = (size_t)(all.end - all.s);

		if (names->n == NAMES_MAX || size >= NAME_ROOM) {
			names->more = true;
			continue;
		}
		memcpy(names->name[names->n], all.s, size);
		names->name[names->n][size] = '\0';
		names->field[names->n++] = k;
	}
}

/* Writes to the end of the reason, as far as there is room. */
static void say_more(char reason[REASON_MAX], const char *before,
    const char *name, const char *after)
{
	char shown[ESCAPED_MAX];
	size_t n = strlen(reason);

	snprintf(reason + n, REASON_MAX - n, "%s%s%s", before,
	    escaped(shown, name, strlen(name)), after);
}

static void say_list(const struct names *names, char reason[REASON_MAX])
{
	const size_t room = REASON_MAX - ESCAPED_MAX - 8;
	int i = 0;

	for (; i < names->n && strlen(reason) < room; i++)
		say_more(reason, i > 0 ? ", " : " it has ", names->name[i], "");
	if (i < names->n || names->more)
		say_more(reason, i > 0 ? ", ..." : " it has ...", "", "");
}

void say_names(struct cut c, const char *wanted, char reason[REASON_MAX])
{
	const char *list[NAMES_MAX + 1] = { NULL }, *near;
	struct names names;

	names_of(c, &names);
	if (names.n == 0 && !names.more)
		return;
	for (int i = 0; i < names.n; i++)
		list[i] = names.name[i];
	near = nearest(wanted, list);
	if (near != NULL)
		say_more(reason, "; did you mean '", near, "'?");
	else
		say_more(reason, ";", "", "");
	say_list(&names, reason);
}

/* Returns which name is a, with the word at a + at of size bytes exchanged for
 * another; -1: none. */
static int find_exchanged(const struct names *names, const char *a, size_t at,
    size_t size, const char *word)
{
	size_t n = strlen(word);

	for (int i = 0; i < names->n && *word != '\0'; i++) {
		const char *b = names->name[i];

		if (strlen(b) == strlen(a) - size + n &&
		    strncasecmp(a, b, at) == 0 &&
		    strncasecmp(b + at, word, n) == 0 &&
		    strcasecmp(a + at + size, b + at + n) == 0)
			return i;
	}
	return -1;
}

/* Returns the first name of a height, beside a horizontal one a as above. */
static int find_height(const struct names *names, const char *a, size_t at,
    size_t size)
{
	static const char *const heights[] = { "z", "altitude", "alt",
		"elevation", "elev", "ele", "height", "h", "up" };
	int found = -1;

	for (int k = 0; k < 9 && found < 0; k++) {
		found = find_exchanged(names, a, at, size, heights[k]);
		if (found < 0)
			found = find_exchanged(names, "", 0, 0, heights[k]);
	}
	return found;
}

/* The words that tell names of one point's coordinates apart. */
static const char *const axes[][4] = { { "x", "y", "z", "w" },
	{ "longitude", "latitude", "", "" }, { "lon", "lat", "", "" },
	{ "long", "lat", "", "" }, { "lng", "lat", "", "" },
	{ "easting", "northing", "", "" }, { "east", "north", "", "" },
	{ "e", "n", "", "" }, { "u", "v", "w", "" } };

/* Returns how many coordinates have names that are alike but for a word, as gps_lon
 * and gps_lat are, where the first is field[0] with the word at the byte. */
static int find_alike(const struct names *names, const char *const axis[4],
    size_t at, int reads, int field[4])
{
	const char *a = names->name[field[0]];
	size_t size = strlen(axis[0]);
	int n = 1;

	if (strncasecmp(a + at, axis[0], size) != 0)
		return 0;
	for (; n < reads; n++) {
		field[n] = find_exchanged(names, a, at, size, axis[n]);
		if (field[n] < 0 && n == 2)
			field[n] = find_height(names, a, at, size);
		if (field[n] < 0)
			break;
	}
	return n;
}

/* Finds which names the coordinates have in all likelihood. Returns how many, from
 * the first on: at least two, or none. */
static int guess_columns(const struct names *names, int reads, int found[4])
{
	int best = 1, field[4];

	for (size_t r = 0; r < sizeof axes / sizeof *axes; r++)
		for (int i = 0; i < names->n; i++)
			for (size_t at = 0; names->name[i][at] != '\0'; at++) {
				field[0] = i;
				int n = find_alike(names, axes[r], at, reads,
				    field);

				if (n > best)
					memcpy(found, field, sizeof field);
				best = n > best ? n : best;
			}
	return best > 1 ? best : 0;
}

/* Returns whether --columns and a shell's single quotes can hold the name. */
static bool can_be_typed(const char *name)
{
	char shown[ESCAPED_MAX];

	return name[strspn(name, "0123456789")] != '\0' &&
	    strpbrk(name, ",'") == NULL &&
	    strcmp(escaped(shown, name, strlen(name)), name) == 0;
}

/* Says --columns for the names that were guessed: by number if one can't be typed. */
static void say_guessed(const struct names *names, const int *found, int n,
    int reads, char reason[REASON_MAX])
{
	bool typed = true, quoted = false;

	for (int i = 0; i < n; i++) {
		const char *name = names->name[found[i]];

		typed &= can_be_typed(name);
		quoted |= strpbrk(name, " \t\"\\$`()[]{}<>|&;*?#~!") != NULL;
	}
	const char *quote = typed && quoted ? "'" : "";

	say_more(reason, "; say --columns ", quote, "");
	for (int i = 0; i < reads; i++) {
		char number[16];

		snprintf(number, sizeof number, "%d",
		    i < n ? names->field[found[i]] + 1 : 0);
		say_more(reason, i > 0 ? "," : "",
		    i >= n    ? "NAME" :
			typed ? names->name[found[i]] :
				number,
		    "");
	}
	say_more(reason, quote, ";", "");
}

void say_columns(const struct layout *l, struct cut c, char reason[REASON_MAX])
{
	struct span header = { c.s, c.end };
	struct names names;
	int found[4];

	names_of(c, &names);
	int n = guess_columns(&names, l->reads, found);
	const char *other = other_separator(l, header, names.n == 1);

	if (n < l->reads && other != NULL) {
		say_more(reason, other, "", "");
		return;
	}
	if (n > 0)
		say_guessed(&names, found, n, l->reads, reason);
	else
		say_more(reason,
		    "; say with --columns which the coordinates are;", "", "");
	say_list(&names, reason);
}

void say_text_header(const struct layout *l, struct span line,
    char reason[REASON_MAX])
{
	struct cut c = cut_line(l->in, line);
	struct field f;

	for (int i = 0; i < l->reads && cut_next(&c, &f); i++) {
		double v;

		if (format_of(l->in)->number(f.value.s, f.value.end, &v) !=
			NULL ||
		    (i == 0 && (*f.value.s == '[' || *f.value.s == '{')))
			return;
	}
	snprintf(reason, REASON_MAX, "looks like a header; say %s",
	    has(line, ',')      ? "-i csv" :
		has(line, '\t') ? "-i tsv" :
		has(line, ';')  ? "-i csv --separator ';'" :
				  "-i csv --separator ' ', or put # before it");
}
