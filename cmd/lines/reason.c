/* SPDX-License-Identifier: MIT */
#include "reason.h"

#include <math.h>
#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <strings.h>

#include "../../core/scene/scene.h"
#include "../message/escape.h"
#include "../message/words.h"

void reason_refuse(struct refusal *r, const char *reason)
{
	char what[REASON_MAX];
	char quote = '\0', *s = what;

	snprintf(what, sizeof what, "%s", reason);
	for (; *s != '\0' && (quote != '\0' || strncmp(s, "; ", 2) != 0); s++)
		if (quote != '\0')
			quote = *s == quote ? '\0' : quote;
		else if (strchr("'\"", *s) && (s == what || s[-1] == ' '))
			quote = *s;
	const char *remedy = *s != '\0' ? s + 2 : "";

	*s = '\0';
	refusal_set(r, NULL, what, remedy);
}

static void __attribute__((format(printf, 2, 3)))
say_more(char reason[REASON_MAX], const char *format, ...)
{
	size_t n = strlen(reason);
	va_list arguments;

	va_start(arguments, format);
	vsnprintf(reason + n, REASON_MAX - n, format, arguments);
	va_end(arguments);
}

static const char *find_byte(struct span f, char c)
{
	return f.s < f.end ? memchr(f.s, c, (size_t)(f.end - f.s)) : NULL;
}

/* Separators, the likeliest first. `rare` leaves out those that many fields have. */
static const char rare[] = ";|\t", frequent[] = ";|\t, ";

/* Adds the remedy for the mark that f, a line or field, begins with, or else for the
 * separator before its last byte. Returns false if it adds nothing. */
static bool say_mend(const struct layout *l, struct span f, const char *separators,
    char reason[REASON_MAX])
{
	static const char *const marks[][2] = {
		{ "{\"type\"",
		    "; is it GeoJSON? jq -c '..|.coordinates?|arrays|..|arrays|"
		    "select(.[0]|numbers)' makes lines for -i json" },
		{ "[", "; is it JSON? say -i json; if not, tr -d '[]'" },
		{ "{", "; is it JSON? say -i json" },
		{ "\xe2\x88\x92", /* U+2212, a minus */
		    "; write - for U+2212: sed 's/\xe2\x88\x92/-/g'" },
	};
	const char own = l->in.separator;
	const char *c = separators;
	const size_t size = (size_t)(f.end - f.s);

	for (size_t k = 0; k < sizeof marks / sizeof *marks; k++) {
		const size_t n = strlen(*marks[k]);

		if (size >= n && memcmp(f.s, *marks[k], n) == 0) {
			say_more(reason, "%s", marks[k][1]);
			return true;
		}
	}
	f.end -= size > 0;
	while (*c != '\0' && (*c == own || find_byte(f, *c) == NULL))
		c++;
	if (*c == '\0')
		return false;
	say_more(reason,
	    *c == '\t' ? "; is a tab the separator? " : "; is '%c' the separator? ",
	    *c);
	say_more(reason,
	    l->seen.header_fields > 1 ?
		"the header has another; make both the same by tr or sed" :
		*c == '\t' ? "say -i tsv" :
		*c == ' '  ? "say -i text" :
			     "say -i csv --separator '%c'",
	    *c);
	return true;
}

/* Returns whether the letters that a field begins with are one of `words`. */
static bool begins_with(struct span f, const char *words)
{
	char word[16];
	size_t n = 0;

	for (; n < sizeof word - 1 && f.s + n < f.end && isalpha((unsigned char)f.s[n]);
	     n++)
		word[n] = f.s[n];
	word[n] = '\0';
	return (f.s + n == f.end || !isdigit((unsigned char)f.s[n])) &&
	    word_is_one_of(word, words);
}

/* Adds how to mend WKT or COPY's \N, which f, a field or header, begins with. Returns
 * false if it adds nothing. */
static bool say_database(struct span f, char reason[REASON_MAX])
{
	const bool wkt = begins_with(f,
	    "POINT LINESTRING POLYGON MULTIPOINT MULTIPOLYGON");
	const bool null = f.end - f.s >= 2 && memcmp(f.s, "\\N", 2) == 0;

	if (wkt)
		say_more(reason,
		    "; is it WKT? tr ',' '\\n' | sed 's/.*(//; s/).*//' makes it text");
	else if (null)
		say_more(reason, "; write NA for \\N: sed 's/\\\\N/NA/g'");
	return wkt || null;
}

/* Adds how to mend f, a field of text or csv. Returns false if it adds nothing. */
static bool say_remedy(const struct layout *l, struct span f, char reason[REASON_MAX])
{
	const char *comma = find_byte(f, ','), *open = find_byte(f, '(');
	double v;
	const char *after = number_read(f.s, f.end, &v);
	const bool two_numbers = format_of(l->in)->header && after != NULL &&
	    number_read(skip_text_separator(after, f.end), f.end, &v) != NULL;

	if (comma == NULL && l->in.separator == ';')
		comma = find_byte(f, ' ');
	if (say_database(f, reason))
		return true;
	if (after != NULL && comma != NULL &&
	    number_read(comma + 1, f.end, &v) == f.end)
		say_more(reason, "; write 1.5 for 1,5, and 1000 for 1,000 or 1 000");
	else if (open != NULL && f.end[-1] != ')')
		say_more(reason, "; make brackets blanks: tr '()' '  '");
	else if (f.s < f.end && f.end[-1] == ';')
		say_more(reason, "; leave out each ; by tr -d ';'");
	else if (open == NULL && say_mend(l, f, two_numbers ? frequent : rare, reason))
		return true;
	else if (find_byte(f, '=') != NULL)
		say_more(reason, "; leave out names: sed 's/[A-Za-z]*=//g'");
	else if (begins_with(f, "v vn vt o g mtllib usemtl"))
		say_more(reason,
		    "; is it OBJ? grep '^v ' keeps its vertices, for --columns 2,3,4");
	else if (after != NULL && !field_is_name(f))
		say_more(reason,
		    "; a number is wanted, and nothing else in the field; --columns "
		    "chooses other fields");
	else
		return false;
	return true;
}

static const char *json_remedy(const struct field *f)
{
	const char first = *f->value.s;
	double v;

	return number_read(f->value.s, f->value.end, &v) != NULL ?
	    ", as JSON writes it" :
	    first != '[' && first != '{' ?
	    "" :
	    f->name.s == NULL ?
	    "; one array or object a line, for -i json: jq -c '.[]'" :
	    "; --columns takes pointers, such as /x/0";
}

void reason_field(const struct layout *l, int i, const struct field *field,
    char reason[REASON_MAX])
{
	const struct format_row *in = format_of(l->in);
	/* the message shows the quotes of csv */
	const struct span f = in->header ? field->whole : field->value;
	char word[ESCAPED_MAX];

	*reason = '\0';
	say_more(reason, "%s is '%s'", coordinate_name(i),
	    escape_short(word, f.s, (size_t)(f.end - f.s)));
	if (*in->open != '\0')
		say_more(reason, "; a number is wanted%s", json_remedy(field));
	else if (!say_remedy(l, field->value, reason))
		say_more(reason, "; a number is wanted%s",
		    l->columns.n == 0 && i == 0 ?
			"; --columns says which fields the coordinates are" :
			", or NA");
}

bool reason_in_range(const struct layout *l, int i, double v, char reason[REASON_MAX])
{
	if (!(fabs(v) > SCENE_MAGNITUDE_MAX))
		return true;
	snprintf(reason, REASON_MAX,
	    isinf(v) ? "%s is infinite; a number up to 1e150 is wanted, or %s" :
		       "%s is beyond 1e150 in magnitude; choose another unit",
	    coordinate_name(i), format_of(l->in)->nan_text);
	return false;
}

enum { NAMES_MAX = 32, COLUMN_ROOM = 64 };

/* The first NAMES_MAX names of columns or members that are shorter than COLUMN_ROOM. */
struct names {
	char name[NAMES_MAX][COLUMN_ROOM];
	int n;
	bool omitted; /* there are more names, or longer ones */
};

/* Returns the name in f, a word of a comment, without quotes and unit: t for t[s]. */
static struct span name_word(struct span f)
{
	f.s += f.s < f.end && (*f.s == '"' || *f.s == '\'');
	const char *s = f.s;

	while (s < f.end && strchr(" ;/([\"'", *s) == NULL &&
	    (*s != '_' || s != f.s + 1 || strchr("xyzwXYZW", *f.s) == NULL))
		s++;
	return (struct span){ f.s, s };
}

/* Copies names of members or a header, or the words of a comment, after the cursor. */
static void copy_names(struct cursor c, struct names *names)
{
	struct field f;

	names->n = 0;
	names->omitted = false;
	while (cursor_next(&c, &f)) {
		struct span all = c.members ?
		    (struct span){ f.name.s + 1, f.name.end - 1 } :
		    c.names ? f.value :
			      name_word(f.value);
		size_t size = (size_t)(all.end - all.s);

		if (!c.members && !c.names &&
		    (size == 0 || strchr("])", all.end[-1]) != NULL))
			continue;
		if (names->n == NAMES_MAX || size >= COLUMN_ROOM) {
			names->omitted = true;
			continue;
		}
		memcpy(names->name[names->n], all.s, size);
		names->name[names->n++][size] = '\0';
	}
}

/* Returns the index of the name of n bytes of a and, in any case, `word`; or -1. */
static int find_name(const struct names *names, const char *a, size_t n,
    const char *word)
{
	for (int i = 0; i < names->n; i++)
		if (strncmp(names->name[i], a, n) == 0 &&
		    strcasecmp(names->name[i] + n, word) == 0)
			return i;
	return -1;
}

static bool can_be_typed(const char *name)
{
	char shown[ESCAPED_MAX];

	return strpbrk(name, " ,'\"\\$`()[]{}<>|&;*?#~!") == NULL &&
	    strcmp(escape_short(shown, name, strlen(name)), name) == 0;
}

/* Returns whether column x is the first of columns whose names begin alike and end in
 * names of axes, such as gps_lon and gps_lat: found[i] becomes that of coordinate i, or
 * -1. Leaves out quaternions, such as qx, qy, qz and qw, and names such as px if x is a
 * name. */
static bool find_axes(const struct names *names, int x, const char *const axis[2],
    int reads, int found[4])
{
	static const char *const heights[] = { "z", "altitude", "alt", "elevation",
		"elev", "ele", "height", "hoehe", "h", "up", "w" };
	/* w, the last of heights[], is left out if points have a w */
	const int usable = (int)(sizeof heights / sizeof *heights) - (reads > 3);
	const char *a = names->name[x];
	const size_t n = strlen(a), size = strlen(axis[0]), at = n - size;

	found[0] = x;
	found[2] = -1;
	if (n < size || find_name(names, a, at, axis[0]) != x ||
	    (found[1] = find_name(names, a, at, axis[1])) < 0 || !can_be_typed(a))
		return false;
	found[3] = find_name(names, a, at, "w");
	if (at > 0 &&
	    (find_name(names, a, 0, "x") >= 0 ||
		(strcmp(axis[0], "x") == 0 && reads < 4 && found[3] >= 0)))
		return false;
	for (int i = 0; i < 2 * usable && found[2] < 0; i++)
		found[2] = find_name(names, a, i < usable ? at : 0,
		    heights[i % usable]);
	return true;
}

/* Adds "; say --columns px,py,pz or vx,vy,vz" or, for `numbers`, column numbers, and
 * sets bits of *numbers. Returns false, and adds nothing, if none is found or fits. */
static bool say_guess(const struct names *names, int reads, uint32_t *numbers,
    char reason[REASON_MAX])
{
	static const char *const axes[][2] = { { "x", "y" },
		{ "longitude", "latitude" }, { "lon", "lat" }, { "long", "lat" },
		{ "lng", "lat" }, { "easting", "northing" }, { "east", "north" },
		{ "rechtswert", "hochwert" }, { "e", "n" }, { "u", "v" } };
	const int pairs = sizeof axes / sizeof *axes;
	const size_t was = strlen(reason);
	bool all = true, degrees = false;
	int found[4];

	for (int k = 0; k < pairs * names->n; k++) {
		const char *const *axis = axes[k / names->n];

		if (!find_axes(names, k % names->n, axis, reads, found) ||
		    (numbers != NULL &&
			(found[reads - 1] < 0 || (reads > 3 && found[2] < 0))))
			continue;
		say_more(reason, reason[was] == '\0' ? "; say --columns " : " or ");
		degrees |= strncmp(axis[1], "lat", 3) == 0;
		for (int i = 0; i < reads; i++) {
			say_more(reason, i > 0 ? "," : "");
			all &= found[i] >= 0;
			if (numbers != NULL) {
				say_more(reason, "%d", found[i] + 1);
				*numbers |= 1u << found[i];
			} else {
				say_more(reason, "%s",
				    found[i] < 0 ? "NAME" : names->name[found[i]]);
			}
		}
	}
	if (!all)
		say_more(reason, ", where NAME is another column");
	if (degrees)
		say_more(reason, "; degrees are no lengths: cs2cs makes metres first");
	if (strlen(reason) == REASON_MAX - 1)
		reason[was] = '\0';
	return reason[was] != '\0';
}

/* Adds what to say instead of `typed`, a name in --columns that nothing has. */
static void say_near(const struct lookup *found, const struct names *names,
    const char *typed, char reason[REASON_MAX])
{
	const size_t head = strcspn(typed, ".[");
	char shown[ESCAPED_MAX];

	if (found->c.members && typed[head] != '\0' &&
	    find_name(names, typed, head, "") >= 0) {
		say_more(reason, "; say /a/b for a.b, and /a/0 for a[0]");
	} else if (found->c.names && found->l->header == HEADER_MAYBE &&
	    !field_is_name((struct span){ found->c.s, found->c.end })) {
		say_more(reason,
		    "; if there is no header, say --columns by number, such as 3,4,5");
	} else {
		const char *list[NAMES_MAX + 1] = { NULL }, *near;

		for (int i = 0; i < names->n; i++)
			list[i] = names->name[i];
		near = word_nearest(typed, list);
		if (near != NULL)
			say_more(reason, "; did you mean '%s'?",
			    escape_short(shown, near, strlen(near)));
	}
}

/* Says what makes lines of an object whose one member may be a list of points. */
static bool say_list(const struct names *names, char reason[REASON_MAX])
{
	static const char *const lists[] = { "points", "positions", "vertices" };

	for (int k = 0; k < 3 && names->n == 1; k++)
		if (find_name(names, "", 0, lists[k]) >= 0) {
			say_more(reason,
			    "; jq -c '.%s[]' prints its points, for -i json", lists[k]);
			return true;
		}
	return false;
}

/* Adds the result of say_near or, if typed is NULL, a guess or the remedy of say_mend;
 * except after that, the names after the cursor, "; it has x, y". */
static void say_names(const struct lookup *found, const char *typed,
    char reason[REASON_MAX])
{
	const struct layout *l = found->l;
	const struct cursor c = found->c;
	const size_t room = REASON_MAX - ESCAPED_MAX - 8;
	const struct span header = { c.s, c.end };
	char shown[ESCAPED_MAX];
	struct names names;
	int i = 0;

	copy_names(c, &names);
	if (c.members &&
	    (find_name(&names, "", 0, "features") >= 0 ||
		find_name(&names, "", 0, "geometry") >= 0 ||
		find_name(&names, "", 0, "coordinates") >= 0)) {
		say_more(reason,
		    "; is it GeoJSON? jq -c '..|.coordinates?|arrays|..|arrays|"
		    "select(.[0]|numbers)' makes lines of points for -i json");
		return;
	}
	if (c.members && say_list(&names, reason))
		return;
	if (typed != NULL) {
		say_near(found, &names, typed, reason);
	} else if (!say_database(header, reason) &&
	    !say_guess(&names, l->reads, NULL, reason)) {
		if (say_mend(l, header, names.n == 1 ? ";|\t," : rare, reason))
			return;
		const bool blank = names.n == 1 && say_mend(l, header, " ", reason);

		const bool wkt = find_name(&names, "", 0, "WKT") >= 0;

		if (wkt)
			say_more(reason,
			    "; ogr2ogr -lco GEOMETRY=AS_XYZ makes columns X, Y and Z "
			    "of WKT");
		else if (find_byte(header, '[') != NULL ||
		    find_byte(header, '(') != NULL)
			say_more(reason,
			    "; leave out units: sed '%zus/ *[[(][^])]*[])]//g'",
			    l->seen.first_line);
		else if (!blank)
			say_more(reason,
			    "; say with --columns which the coordinates are");
		if (!wkt && (names.n < l->reads || *names.name[names.n - 1] == '\0'))
			say_more(reason, "; leave out a title line by sed %zud",
			    l->seen.first_line);
		if (blank)
			return;
	}
	if (names.n > 0 || names.omitted)
		say_more(reason, "%s it has ",
		    reason[strlen(reason) - 1] == '?' ? "" : ";");
	for (; i < names.n && strlen(reason) < room; i++)
		say_more(reason, "%s%s", i > 0 ? ", " : "",
		    escape_short(shown, names.name[i], strlen(names.name[i])));
	if (i < names.n || names.omitted)
		say_more(reason, i > 0 ? ", ..." : "...");
}

void reason_missing(const struct lookup *found, int i, char reason[REASON_MAX])
{
	const struct layout *l = found->l;
	const struct cursor c = found->c;
	const char *name = c.members || c.names ? l->columns.name[i] : NULL;
	const bool one = c.bracket == NULL && cursor_count(c) == 1;
	char shown[ESCAPED_MAX];

	*reason = '\0';
	if (name == NULL) {
		if (l->columns.n == 0)
			say_more(reason, "%s is missing; %d numbers are wanted%s",
			    coordinate_name(i), l->reads,
			    i == 2 && l->z_hint != NULL ? l->z_hint : "");
		else
			say_more(reason, "%s is missing: there is no field %d",
			    coordinate_name(i), l->columns.field[i] + 1);
		if (one)
			say_mend(l, trimmed(c.in, (struct span){ c.s, c.end }),
			    frequent, reason);
		return;
	}
	escape_short(shown, name, strlen(name));
	if (found->times[i] == 0) {
		say_more(reason, "%s '%s'%s",
		    c.names ? "the header has no column" : "has no member", shown,
		    c.names || l->columns.n > 0 ? "" :
						  "; --columns names the coordinates, "
						  "such as lon, /pos/x or /pos/0");
		if (c.names && i == 2 && l->z_hint != NULL)
			say_more(reason, "%s", l->z_hint);
		else
			say_names(found, c.names && l->columns.by_default ? NULL : name,
			    reason);
	} else if (c.names) {
		say_more(reason,
		    "the header has two columns for %s, %ld and %ld; say --columns by "
		    "number",
		    name, found->index[i] + 1, found->second_index[i] + 1);
	} else {
		say_more(reason, "has two members '%s'", shown);
	}
}

void reason_comment_columns(struct layout *l, struct span text)
{
	const struct dialect blanks = { FORMAT_TEXT, ' ' };
	const struct dialect table = { FORMAT_CSV,
		format_of(l->in)->header ? l->in.separator : ',' };
	char reason[REASON_MAX] = "the comment above names the columns";
	char *remedy = strchr(reason, '\0');
	uint32_t numbers = 0;
	const size_t n = 2 * (size_t)l->reads - 1;
	struct names names;

	text.s = skip_blanks(l->in, text.s, text.end) + 1; /* after # */
	/* COLMAP's last column: TRACK[] as (IMAGE_ID, POINT2D_IDX) */
	bool list = false;

	for (const char *s = text.s; s < text.end - 5 && !list; s++)
		if (memcmp(s, "[] as", 5) == 0) {
			list = true;
			text.end = s;
		}
	for (const char *s = text.s; s < text.end; s++)
		if (*s != table.separator &&
		    strchr(s == text.s ? "#%!;:=" : ":=", *s) != NULL)
			text.s = s + 1;
	const bool separated = memchr(text.s, table.separator,
				   (size_t)(text.end - text.s)) != NULL;

	copy_names(line_cursor(blanks, text), &names);
	const int words = names.n;

	copy_names(line_cursor(separated ? table : blanks, text), &names);
	if (names.omitted)
		return;
	if (!say_guess(&names, l->reads, &numbers, reason)) {
		/* # id,foo,bar may name columns, if each name is one word */
		if (!format_of(l->in)->header || text.s[-1] == ':' || names.n < 3 ||
		    list || *l->seen.comment_reason != '\0' ||
		    (words != names.n && words != 1) ||
		    !lookup_is_header(l, line_cursor(table, text)))
			return;
		l->seen.comment_line = l->seen.first_line;
		l->seen.comment_names = (size_t)names.n;
		l->seen.comment_numbers = 0;
		return;
	}
	const char *columns = remedy + strlen("; say --columns ");
	const bool first = strncmp(columns, "1,2,3,4", n) == 0 &&
	    (columns[n] == '\0' ||
		(columns[n] == ' ' && strcasecmp(*names.name, "x") == 0));

	l->seen.comment_line = 0;
	l->seen.comment_names = first ? 0 : (size_t)(names.n - list);
	l->seen.comment_list = list;
	l->seen.comment_numbers = numbers;
	strcpy(l->seen.comment_reason, reason);
}

void reason_binary(const struct layout *l, struct span text, bool has_nul,
    char reason[REASON_MAX])
{
	enum { LOOK = 4096 };
	const long long sizes[] = { 16, 4LL * l->reads, 8LL * l->reads };
	const char *const names[] = { "f32x4", "f32", "f64" };
	const char *before = "is binary; if it is numbers alone, say -i ";
	const char *s = text.s, *end = text.end - s > LOOK ? s + LOOK : text.end;

	/* a NUL is in has_nul: strchr finds one in every string */
	while (s < end && ((unsigned char)*s >= ' ' || strchr("\t\n\r\33", *s) != NULL))
		s++;
	if (s == end && !has_nul)
		return;
	*reason = '\0';
	/* first what the size of the file divides by */
	for (int no = 0; no < 2; no++)
		for (int k = 0; k < 3; k++)
			if ((l->seen.size == 0 || l->seen.size % sizes[k] != 0) == no) {
				say_more(reason, "%s%s", before, names[k]);
				before = " or ";
			}
}

bool reason_needs_header(struct layout *l, struct span row, bool lost,
    char reason[REASON_MAX])
{
	struct cursor c = line_cursor(l->in, row);
	bool fits = l->seen.comment_names > 0;
	struct field f;
	double v;

	if (!l->columns.by_default)
		return lost && layout_has_names(l);
	for (size_t i = 0; fits && i < l->seen.comment_names; i++)
		fits = cursor_next(&c, &f) &&
		    ((l->seen.comment_numbers >> i & 1) == 0 ||
			format_read(l->in, f.value.s, f.value.end, &v) == f.value.end);
	if (l->header != HEADER_MAYBE ||
	    (!l->seen.reordered && (!fits || (c.s != NULL && !l->seen.comment_list))))
		return false;
	l->seen.note = l->seen.comment_line > 0 && !l->seen.reordered;
	if (l->seen.note)
		return false;
	strcpy(reason,
	    l->seen.reordered ?
		"lacks the header of a file before; say --columns by number" :
		l->seen.comment_reason);
	return true;
}

void reason_text_header(const struct layout *l, struct span line,
    char reason[REASON_MAX])
{
	struct cursor c = line_cursor(l->in, line);
	char remedy[REASON_MAX] = "", in_order[] = "; say --columns 1,2,3,4";
	uint32_t numbers = 0;
	struct names names;
	struct field f;
	double v;

	/* after a number or NA the reason is about another field */
	if (find_byte(line, '=') != NULL || !cursor_next(&c, &f) ||
	    format_read(l->in, f.value.s, f.value.end, &v) == f.value.end ||
	    say_remedy(l, f.value, remedy))
		return;
	strcpy(reason, "looks like a header");
	say_more(reason, "%s leave it out by sed %zud",
	    say_mend(l, line, frequent, reason) ? ", or" : ";", l->seen.first_line);
	copy_names(line_cursor(l->in, line), &names);
	in_order[sizeof in_order - 1 - 2 * (size_t)(4 - l->reads)] = '\0';
	if (!isalpha((unsigned char)*names.name[0]) ||
	    !say_guess(&names, l->reads, &numbers, remedy))
		say_more(reason, ", with --columns if x is not first");
	else if (strcmp(remedy, in_order) != 0)
		say_more(reason, ", and%s", remedy + 1);
}
