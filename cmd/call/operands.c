/* SPDX-License-Identifier: MIT */
#include "operands.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "input.h"
#include "params.h"
#include "../stream/progress.h"
#include "../message/message.h"

/* Refuses an operand that is no file but an option without its dashes, or with
 * those that editors make of them, U+2010 to U+2015 in UTF-8. */
static void check_option(const struct command *c, const char *word)
{
	const struct option_row *r;
	const char *name = word;

	while (strncmp(name, "\xe2\x80", 2) == 0 && (name[2] & 0xf0) == 0x90)
		name += 3;
	r = option_named(name);
	if (r != NULL && option_is_for(r, c))
		die_at(EXIT_USAGE, &(struct place){ .file = word },
		    "%s; the option is --%s", strerror(ENOENT), name);
}

/* Whether the shell has taken JSON apart: {"eye": [0,0,5]} without quotes. */
static bool is_torn(const struct options *o)
{
	if (strchr(o->params, '}') != NULL)
		return false;
	for (int i = 0; i < o->n_points; i++)
		if (strchr(o->points[i], '}') != NULL)
			return true;
	return false;
}

/* Refuses PARAMS that are neither a file nor JSON. */
static void check_params(const struct command *c, const struct options *o)
{
	const char *name = o->params;
	bool typed = first_char(name) == '{';

	if (is_stdin(name) || (typed ? !is_torn(o) : access(name, F_OK) == 0))
		return;
	check_option(c, name);
	if (typed || is_numbers(name) || strpbrk(name, "\":{=") != NULL ||
	    strcmp(name, "help") == 0)
		die(EXIT_USAGE,
		    "'%s' is no scene; PARAMS is a JSON file, - or JSON in "
		    "quotes: projcalc %s %s",
		    name, c->name, c->example);
}

/* Refuses a file of points that can't be read. */
static void check_file(const struct command *c, const struct options *o,
    const char *name)
{
	const struct place place = { .file = name };
	const int n = 2 * coordinates_of(c, o) + 1;

	check_input(name);
	if (access(name, R_OK) == 0)
		return;
	const char *why = strerror(errno);

	check_option(c, name);
	if (!is_numbers(name) && strpbrk(name, "{\"") == NULL)
		die_at(EXIT_USAGE, &place, "%s", why);
	die_at(EXIT_USAGE, &place, "%s; POINTS are a file, - or '[%.*s]'%s",
	    why, n, "1.5,2,3,4",
	    c->kind == PICK ? "; where to look is --at 320,240" : "");
}

#define USE_RAY                                                      \
	"--ray takes x y to the ray through it, --plane A,B,C,D to " \
	"where that ray meets a plane"

/* Returns whether points of two coordinates are positions on the device for which
 * project has --ray and --plane. */
static bool lacks_depth(const struct options *o)
{
	return o->has_from && o->from == SPACE_DEVICE && !o->homogeneous &&
	    !o->ray && o->plane.n == 0 && (!o->has_to || o->to == SPACE_WORLD);
}

/* Returns what a message says of points of two numbers, or NULL. */
static const char *two_of(const struct command *c, const struct options *o)
{
	return c->kind == PROJECT && lacks_depth(o) ? "; " USE_RAY : NULL;
}

/* Refuses a typed position on the device in place of a point, or of the first of a
 * list: pick and project have options for it. */
static void check_position(const struct command *c, const struct options *o,
    const char *points)
{
	double v;
	int from = 0, n = 0;

	if ((sscanf(points, " [%lf ,%lf ]%n", &v, &v, &n) < 2 || n == 0) &&
	    (sscanf(points, " [ %n[%lf ,%lf ]%n", &from, &v, &v, &n) < 2 ||
		n == 0))
		return;
	points += from;
	n -= from;
	if (c->kind == PICK)
		die(EXIT_USAGE,
		    "'%.*s' is no point; where to look is --at 320,240", n,
		    points);
	if (c->kind == PROJECT && lacks_depth(o))
		die(EXIT_USAGE, "'%.*s' has no depth; " USE_RAY, n, points);
}

void check_operands(const struct command *c, const struct options *o)
{
	int from_stdin = is_stdin(o->params);

	check_params(c, o);
	if (first_char(o->params) != '{')
		check_input(o->params);
	if (o->n_points > 0 && !command_reads_points(c))
		die(EXIT_USAGE, "%s reads no points; leave them out", c->name);
	for (int i = 0; i < o->n_points && !o->matrix; i++) {
		const char *name = o->points[i];

		if (is_stdin(name) && from_stdin++)
			die(EXIT_USAGE,
			    is_stdin(o->params) ?
				"PARAMS and POINTS are both standard input; "
				"name a file for one of them" :
				"standard input is named twice");
		if (first_char(name) == '[')
			check_position(c, o, name);
		else if (is_stdin(name))
			check_input(name);
		else
			check_file(c, o, name);
	}
}

void read_document(const struct command *c, const struct options *o,
    struct document *d)
{
	struct document_wants wants = c->wants;

	wants.convention = o->convention;
	wants.two = two_of(c, o);
	/* the document's points are not read if points are operands */
	if (command_reads_points(c) && !o->matrix && o->n_points == 0)
		wants.coordinates = coordinates_of(c, o);
	params_read(o, &wants, d);
}

bool has_points(const struct options *o, const struct document *d)
{
	return o->n_points > 0 || d->points != NULL;
}

/* Whether path is the name, or a pointer to that member or into it. */
static bool leads_into(const char *path, const char *name)
{
	size_t n = strlen(name);
	bool pointer = *path == '/';

	path += pointer;
	return strncmp(path, name, n) == 0 &&
	    (path[n] == '\0' || (pointer && path[n] == '/'));
}

/* What is added to an object has names of its own. */
static bool is_added(const struct options *o, const struct layout *l,
    const char *name)
{
	static const char *const added[] = { "z", "dx", "dy", "dz" };
	bool is = o->flags && !l->append && leads_into(name, "flags");

	int n = l->append ? 0 :
	    l->writes > 4 ? 4 :
			    l->reads == 2 && l->writes == 3;

	for (int i = 0; i < n; i++)
		is |= leads_into(name, added[i]);
	return is ||
	    (l->writes == 4 && l->reads == 3 && !l->append &&
		leads_into(name, "w"));
}

static void check_columns_of(const struct options *o, const struct layout *l)
{
	bool csv = l->in.format == FORMAT_CSV, json = o->in == FORMAT_JSON;

	for (int i = 0; i < o->columns.n; i++) {
		const char *name = o->columns.name[i];

		if (name != NULL && !csv && !json)
			die(EXIT_USAGE,
			    "--columns: '%s' is a name, and names are for -i "
			    "csv, tsv and json; write numbers: 2,3,4",
			    name);
		if (name != NULL && json && is_added(o, l, name))
			die(EXIT_USAGE,
			    "--columns: '%s' is also what a number is called "
			    "that is added",
			    name);
		if (json && (name == NULL) != (o->columns.name[0] == NULL))
			die(EXIT_USAGE,
			    "--columns: in JSON they are numbers, of an "
			    "array's elements, or names, of an object's "
			    "members, not both");
	}
	if (o->columns.n > 0 && is_binary(o->in) && l->record == 0)
		die(EXIT_USAGE,
		    "--columns: binary points have no other fields; records "
		    "of four numbers are -i %sx4",
		    format_names[o->in]);
	if (o->columns.n > 0 && o->columns.n != l->reads)
		die(EXIT_USAGE,
		    "--columns: %d field%s; %d coordinates are read here, as "
		    "%.*s or %.*s%s%.*s",
		    o->columns.n, o->columns.n == 1 ? "" : "s", l->reads,
		    2 * l->reads - 1, "2,3,4,5", 2 * l->reads - 1, "x,y,z,w",
		    json ? " or " : "", json ? 5 * l->reads - 1 : 0,
		    "/p/0,/p/1,/p/2,/p/3");
}

static void check_csv(const struct options *o, const struct layout *l)
{
	if (o->separator != ',' && o->in != FORMAT_CSV && o->out != FORMAT_CSV)
		die(EXIT_USAGE, "--separator is of csv; say -i csv, or -o csv");
	if ((o->header || o->no_header) && l->in.format != FORMAT_CSV)
		die(EXIT_USAGE, "--%s is of csv; say -i csv or -i tsv",
		    o->header ? "header" : "no-header");
	if (o->header && o->no_header)
		die(EXIT_USAGE, "--header and --no-header exclude each other");
	for (int i = 0; i < o->columns.n && o->no_header; i++)
		if (o->columns.name[i] != NULL)
			die(EXIT_USAGE,
			    "--columns: '%s' is a name, and with --no-header "
			    "there are none; write numbers: 2,3,4",
			    o->columns.name[i]);
}

static void check_append(const struct options *o, const struct layout *l)
{
	if (!l->append)
		return;
	if (is_binary(o->in) || is_binary(l->out.format))
		die(EXIT_USAGE,
		    "--append: binary points have no lines to stand behind; "
		    "say -o text without it");
	if (o->has_out && o->out != o->in)
		die(EXIT_USAGE,
		    "--append keeps lines as they were read; leave -o out");
}

/* Refuses what binary records can't hold, or have not. Whether points are printed says
 * whether images have to fit in. */
static void check_record(const struct options *o, const struct layout *l,
    bool printed)
{
	const char *name = format_names[o->in];

	if (l->record == 0)
		return;
	if (l->record < l->reads)
		die(EXIT_USAGE, "-i %sx%d: %d coordinates are read here", name,
		    l->record, l->reads);
	for (int i = 0; i < l->columns.n; i++)
		if (l->columns.field[i] >= l->record)
			die(EXIT_USAGE,
			    "--columns: there is no field %d in the %d numbers "
			    "of -i %sx%d",
			    l->columns.field[i] + 1, l->record, name,
			    l->record);
	if (printed && o->flags)
		die(EXIT_USAGE, "-i %sx%d: records take no --flags", name,
		    l->record);
	if (printed && l->reads != l->writes)
		die(EXIT_USAGE,
		    "-i %sx%d: records keep the number of coordinates; here "
		    "%d are read and %d written",
		    name, l->record, l->reads, l->writes);
}

static void check_layout(const struct options *o, const struct layout *l)
{
	check_columns_of(o, l);
	check_csv(o, l);
	check_append(o, l);
	if (o->flags && is_binary(l->out.format))
		die(EXIT_USAGE,
		    "--flags: binary points have no room for words; say "
		    "-o text");
	if (o->styles.n > l->writes)
		die(EXIT_USAGE,
		    "--%s: %d numbers; %d coordinates are printed here",
		    o->styles.style[0].kind == NUMBER_DIGITS ? "digits" :
							       "decimals",
		    o->styles.n, l->writes);
}

/* Tests and measurements choose the kernels by PROJCALC_CPU; else, or where it is
 * empty, they are the best that this processor can run. */
static void choose_kernels(void)
{
	const char *cpu = getenv("PROJCALC_CPU");

	if (cpu != NULL && *cpu == '\0')
		cpu = NULL;
	if (!points_choose(cpu) || !number_choose(cpu))
		die(EXIT_USAGE,
		    "PROJCALC_CPU=%s: not what this processor can be; "
		    "there are baseline, avx2, avx512 and neon",
		    cpu);
}

/* Names what --append adds: x, y, z and w of a space; and the direction of a ray. */
static void name_added(struct layout *l, const char *space)
{
	for (int k = 0; k < l->writes; k++)
		if (l->writes > 4 && k >= 3)
			snprintf(l->added[k], sizeof *l->added, "d%c",
			    "xyz"[k - 3]);
		else
			snprintf(l->added[k], sizeof *l->added, "%s_%s", space,
			    coordinate_name(k));
	if (l->flags)
		strcpy(l->added[COORDINATES_MAX], "flags");
}

void prepare_job(struct job *j, const struct options *o)
{
	/* a ray's position; its point and direction */
	const int ray_reads = 2, ray_writes = 6;

	j->layout = (struct layout){
		.in = dialect_of(o->in, o->separator),
		.out = dialect_of(options_output(o), o->separator),
		.header = o->header ? HEADER_FIRST :
		    o->no_header    ? HEADER_NONE :
				      HEADER_MAYBE,
		.columns = o->columns,
		.reads = j->rays ? ray_reads : j->transform.in,
		.writes = j->rays ? ray_writes : j->transform.out,
		.flags = o->flags,
		.append = o->append,
		.record = o->in_record,
		.keeps = o->in_record > 0 &&
		    (!o->has_out ||
			(o->out_record == o->in_record && o->out == o->in)),
		.single = o->precision == PRECISION_SINGLE,
	};
	j->layout.columns.by_header = o->columns.n == 0;
	for (int k = 0; k < COORDINATES_MAX; k++)
		j->layout.style[k] = o->styles.style[k];
	if (o->append)
		name_added(&j->layout, j->space);
	j->precision = o->precision;
	j->visible = o->visible;
	j->keep_going = o->keep_going;
	j->threads = o->jobs > 0 ? o->jobs : stream_processors();
	progress_start(o->progress);
	widen_pipe(STDOUT_FILENO, PIPE_ROOM);
	choose_kernels();
	check_layout(o, &j->layout);
	check_record(o, &j->layout, j->take == NULL);
}

/* Points as document_points and document_read give them are lines of JSON,
 * whatever format the options say of files. */
static void do_json(struct job *j, const char *name, const char *text,
    size_t size)
{
	struct layout of_files = j->layout;

	j->layout.in = dialect_of(FORMAT_JSON, ',');
	j->layout.columns.n = 0;
	stream_text(j, name, text, size);
	j->layout = of_files;
}

/* Refuses --columns and records for points that are typed: these are of a file. */
static void check_columns(const struct options *o, const struct document *d)
{
	bool typed = o->n_points == 0 && d->points != NULL;

	for (int i = 0; i < o->n_points; i++)
		typed |= first_char(o->points[i]) == '[';
	if (typed && o->in_record > 0)
		die(EXIT_USAGE,
		    "-i %sx%d: points that are typed, or in the document, are "
		    "no records; name a file",
		    format_names[o->in], o->in_record);
	if (typed && o->columns.n > 0)
		die(EXIT_USAGE,
		    "--columns: points that are typed, or in the document, "
		    "begin with their coordinates; name a file");
}

/* Does the job on points typed as an operand; or where there is none, only
 * refuses what is wrong with them. */
static void do_typed(struct job *j, const char *operand, int reads)
{
	struct text t = copy_operand(operand);
	size_t size;
	const char *points = document_points("POINTS", t.s, t.have, reads,
	    &size);

	if (j != NULL)
		do_json(j, "POINTS", points, size);
	text_free(&t);
}

/* The i-th operand, kept for the scenes after this one. */
static void do_kept(const struct options *o, struct job *j, int i,
    const char *name)
{
	static struct text *kept;

	if (kept == NULL) {
		size_t size = ((size_t)o->n_points + 1) * sizeof *kept;

		kept = memset(need(NULL, size), 0, size);
	}
	if (kept[i].s == NULL)
		kept[i] = read_whole(name);
	stream_text(j, name, kept[i].s, kept[i].have);
}

static void do_operand(const struct options *o, struct job *j, int i)
{
	const char *operand = i < o->n_points ? o->points[i] : "-";

	if (first_char(operand) == '[') {
		do_typed(j, operand, j->layout.reads);
		return;
	}
	if (o->scenes) {
		do_kept(o, j, i, operand);
		return;
	}
	int fd = open_input(operand);

	stream_file(j, operand, fd);
	close_input(fd);
}

void do_points(const struct options *o, const struct document *d, struct job *j)
{
	if (o->n_points == 0 && d->points == NULL && is_stdin(o->params))
		die(EXIT_USAGE,
		    "PARAMS and POINTS are both standard input, "
		    "and the document has no points; name a file for one of "
		    "them");
	check_columns(o, d);
	if (o->n_points == 0 && d->points != NULL)
		do_json(j, d->source.name, d->points, d->points_size);
	else if (o->n_points == 0)
		do_operand(o, j, 0);
	/* points that are typed wrong are refused before those of the first
	 * operand are printed */
	for (int i = 1; i < o->n_points; i++)
		if (first_char(o->points[i]) == '[')
			do_typed(NULL, o->points[i], j->layout.reads);
	for (int i = 0; i < o->n_points; i++)
		do_operand(o, j, i);
	if (j->flush != NULL)
		j->flush(j);
}
