/* SPDX-License-Identifier: MIT */
#include "format.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <strings.h>

#include "../json/text.h"
#include "../message/message.h"
#include "../message/words.h"
#include "../number/number.h"

#define LINES .open = "", .close = "", .nan_text = "nan"

const struct format_row format_rows[] = {
	[FORMAT_TEXT] = { ' ', LINES, .blanks = true, .header = true },
	[FORMAT_CSV] = { 0, LINES, .ends = "csv", .table = true, .header = true },
	[FORMAT_TSV] = { '\t', LINES, .ends = "tsv", .table = true, .header = true },
	[FORMAT_JSON] = { ',', .open = "[", .close = "]", .nan_text = "null",
	    .ends = "json jsonl ndjson" },
	[FORMAT_OBJ] = { ' ', .open = "v ", .close = "", .nan_text = "nan",
	    .ends = "obj", .blanks = true },
	[FORMAT_F64] = { ',', LINES, .size = sizeof(double) },
	[FORMAT_F32] = { ',', LINES, .size = sizeof(float) },
	[FORMAT_SNIFF] = { ',', LINES },
};

const char *const format_names[] = {
	[FORMAT_TEXT] = "text",
	[FORMAT_CSV] = "csv",
	[FORMAT_TSV] = "tsv",
	[FORMAT_JSON] = "json",
	[FORMAT_OBJ] = "obj",
	[FORMAT_F64] = "f64",
	[FORMAT_F32] = "f32",
	[FORMAT_SNIFF] = NULL,
};

struct dialect dialect_of(enum format f, char separator)
{
	const char own = format_rows[f].separator;

	return (struct dialect){ f == FORMAT_TSV ? FORMAT_CSV : f,
		own != 0 ? own : separator };
}

enum format format_of_name(const char *name)
{
	const char *dot = strrchr(name, '.');

	for (int f = 0; dot != NULL && f < FORMAT_SNIFF; f++)
		if (word_is_one_of(dot + 1, format_rows[f].ends))
			return (enum format)f;
	return FORMAT_SNIFF;
}

enum format format_of_line(struct span line)
{
	const char *s = line.s, *end = line.end, *word;

	if (s < end && *s == '\t')
		return FORMAT_TSV;
	while (s < end && is_blank(*s))
		s++;
	if (s < end && (*s == '[' || *s == '{'))
		return FORMAT_JSON;
	for (word = s; s < end && !is_blank(*s); s++)
		continue;
	if (s < end && *s == '\t')
		return FORMAT_TSV;
	return memchr(word, ',', (size_t)(s - word)) != NULL ? FORMAT_CSV : FORMAT_TEXT;
}

/* What other files begin with. The first two rows are those of binary points, too. */
static const struct {
	const char *bytes, *what, *remedy;
} foreign[] = {
	{ "\xff\xfe", "is UTF-16", "iconv -f UTF-16 -t UTF-8 makes it UTF-8" },
	{ "\xfe\xff", "is UTF-16", "iconv -f UTF-16 -t UTF-8 makes it UTF-8" },
	{ "\x1f\x8b", "is gzip", "pipe it in by zcat" },
	{ "PK\3\4", "is a zip archive or a workbook", "save it as csv" },
	{ "%PDF", "is a PDF", "pdftotext -layout makes it text" },
	{ "\x89PNG", "is a PNG picture", "lines of x, y and depth are wanted" },
	{ "\xff\xd8\xff", "is a JPEG picture", "lines of x, y and depth are wanted" },
	{ "ply\n", "is PLY",
	    "sed 1,/end_header/d | head -n N keeps the points of 'element vertex N'" },
	{ "ply\r", "is PLY",
	    "sed 1,/end_header/d | head -n N keeps the points of 'element vertex N'" },
	{ "OFF\n", "is OFF", "sed 1,2d | head -n N keeps N points" },
	{ "OFF\r", "is OFF", "sed 1,2d | head -n N keeps N points" },
};

static bool begins_as(const char *s, size_t n, const char *bytes)
{
	return n >= strlen(bytes) && memcmp(s, bytes, strlen(bytes)) == 0;
}

bool format_is_foreign(const char *text, size_t n, bool binary, struct refusal *r)
{
	const unsigned char *s = (const unsigned char *)text;
	const size_t count = sizeof foreign / sizeof *foreign;

	if (n >= NPY_HEADER && begins_as(text, n, NPY_MAGIC)) {
		/* the header's size has two bytes in version 1, later four */
		const int header = s[8] + 256 * s[9] +
		    (s[6] == 1 ? 11 : 13 + 65536 * s[10]);
		char remedy[160];

		snprintf(remedy, sizeof remedy,
		    "tail -c +%d leaves its numbers: f64 if descr is '<f8', f32 if "
		    "'<f4' (f32x4 of 4 columns), with fortran_order False",
		    header);
		refusal_set(r, NULL, "is a .npy file of NumPy", remedy);
		return true;
	}
	for (size_t k = 0; k < (binary ? 2 : count); k++) {
		if (!begins_as(text, n, foreign[k].bytes))
			continue;
		/* of UTF-16 each second byte of Latin-1 is 0 */
		if (binary && (n < 8 || (s[3 - k] | s[5 - k] | s[7 - k]) != 0))
			continue;
		refusal_set(r, NULL, foreign[k].what, foreign[k].remedy);
		return true;
	}
	return false;
}

static bool is_missing(struct dialect d, struct span f)
{
	static const char words[][5] = { "", "na", "n/a", "nan", "+nan", "-nan",
		"null" };

	if (d.format == FORMAT_JSON)
		return span_is(f, "null");
	/* csv's quotes are no part of the field */
	if (format_of(d)->blanks)
		f = unquoted(f);
	for (size_t i = 0; i < sizeof words / sizeof *words; i++)
		if (strlen(words[i]) == span_size(f) &&
		    strncasecmp(words[i], f.s, span_size(f)) == 0)
			return true;
	return false;
}

const char *format_read(struct dialect d, const char *s, const char *end, double *v)
{
	const char *after = d.format == FORMAT_JSON ? json_number(s, end, v) :
						      number_read(s, end, v);

	if (after != end && is_missing(d, (struct span){ s, end })) {
		*v = (double)NAN;
		after = end;
	}
	return after;
}

/* Copies a field with each byte of `from` replaced by `to`, or left out if `to` is 0.
 * Returns whether the copy is a number. */
static bool becomes_number(struct span f, const char *from, char to, char out[64])
{
	size_t n = 0;
	double v;

	for (const char *s = f.s; s < f.end && n < 60; s++)
		if (strchr(from, *s) == NULL)
			out[n++] = *s;
		else if (to != '\0')
			out[n++] = to;
	out[n] = '\0';
	return n > 0 && number_read(out, out + n, &v) == out + n && isfinite(v);
}

/* Returns the end of the digits at s, up to `end`. */
static const char *skip_digits(const char *s, const char *end)
{
	while (s < end && isdigit((unsigned char)*s))
		s++;
	return s;
}

/* Copies a number whose whole part may have groups of three digits, parted by `group`,
 * and which may have a fraction behind `mark`, as C writes it. Returns whether it is
 * so. */
static bool read_grouped(struct span f, char group, char mark, char out[64])
{
	const char *s = f.s + (f.s < f.end && strchr("+-", *f.s) != NULL);
	const char *next = skip_digits(s, f.end);
	const char separator[] = { group, '\0' };

	if (next == s || next - s > 3 || *s == '0')
		return false;
	while (next < f.end && *next == group) {
		s = next + 1;
		next = skip_digits(s, f.end);
		if (next - s != 3)
			return false;
	}
	const struct span whole = { f.s, next }, part = { next + 1, f.end };
	const bool has_part = next < f.end && *next == mark && part.s < part.end &&
	    skip_digits(part.s, part.end) == part.end;

	if (!becomes_number(whole, separator, '\0', out) || (next < f.end && !has_part))
		return false;
	if (has_part)
		sprintf(out + strlen(out), ".%.*s", (int)span_size(part), part.s);
	return true;
}

/* Returns what to write in place of a number with commas. Of a comma alone before three
 * digits nobody knows whether it is the decimal one. */
static const char *comma_remedy(struct dialect d, struct span f)
{
	const char *const comma = memchr(f.s, ',', span_size(f));
	const char *const csv = d.format == FORMAT_TEXT ? "; of csv say -i csv" : "";
	const bool decimal = comma > f.s && isdigit((unsigned char)comma[-1]) &&
	    comma + 1 < f.end && isdigit((unsigned char)comma[1]) &&
	    memchr(f.s, '.', span_size(f)) == NULL;
	char number[64], whole[64];

	if (decimal && becomes_number(f, ",", '.', number))
		return read_grouped(f, ',', '.', whole) ?
		    text("write %s, or of thousands %s%s", number, whole, csv) :
		    text("write %s with a decimal point%s", number, csv);
	if (read_grouped(f, ',', '.', whole) || read_grouped(f, '.', ',', whole))
		return text("write %s%s", whole, csv);
	return d.format == FORMAT_TEXT ? "of csv say -i csv" : "";
}

const char *format_number_remedy(struct dialect d, struct span f)
{
	const size_t size = span_size(f);
	char number[64], *end;

	if (size == 0 || size > 40 || memchr(f.s, '\0', size) != NULL)
		return "";
	if (becomes_number(f, "dD", 'e', number))
		return text("write e for %c: %s",
		    memchr(f.s, 'd', size) != NULL ? 'd' : 'D', number);
	if (becomes_number(f, "_'", '\0', number))
		return text("write %s", number);
	if (memchr(f.s, ',', size) != NULL)
		return comma_remedy(d, f);
	memcpy(number, f.s, size);
	number[size] = '\0';
	if (strncasecmp(number + strspn(number, "+-"), "0x", 2) != 0)
		return "";
	const double v = strtod(number, &end);

	return *end == '\0' ? text("write %.17g", v) : "";
}
