/* SPDX-License-Identifier: MIT */
#include "operands.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../message/message.h"
#include "../number/number.h"
#include "input.h"
#include "notes.h"
#include "option_row.h"

#define PARAMS_HINT \
	"PARAMS is a JSON file, - or JSON in quotes, as 'projcalc help %s' shows"

/* Writes the numbers of n_words words, from the first to one that is a file, as a JSON
 * array. Returns false if they are not as many as a point has coordinates. */
static bool join_numbers(const struct options *o, char *const *words, int n_words,
    char out[7 * NUMBER_MAX])
{
	int left = options_coordinates(o);

	*out++ = '[';
	for (int i = 0; i < n_words && access(words[i], F_OK) != 0; i++) {
		const char *s = words[i], *end = s + strlen(s);
		double v;

		while ((s += strspn(s, " ,")) < end) {
			s = number_read(s, end, &v);
			if (s == NULL || !isfinite(v) || left-- == 0 ||
			    (s < end && strchr(" ,", *s) == NULL))
				return false;
			out = number_write(out, v,
			    (struct number_style){ NUMBER_SHORTEST, 0 });
			*out++ = left > 0 ? ',' : ']';
		}
	}
	*out = '\0';
	return left == 0;
}

/* Refuses PARAMS that are an array or numbers, and no file: they are points. */
static void check_is_scene(const struct options *o)
{
	const struct place place = { .file = o->params };
	char list[7 * NUMBER_MAX], *words[] = { (char *)o->params };
	const bool array = input_first_char(o->params) == '[';

	if (array || join_numbers(o, words, 1, list))
		die_at(EXIT_USAGE, &place, "holds points",
		    params_points_remedy(o,
			text("'%.200s'", array ? o->params : list)));
}

static void check_params(const struct options *o)
{
	const struct command *c = o->command;
	const struct place place = { .file = o->params };

	/* the shell splits an object without quotes: the first operand lacks } */
	if (input_first_char(o->params) == '{') {
		if (o->n_points > 0 && strchr(o->params, '}') == NULL)
			die_at(EXIT_USAGE, &place, "has no }",
			    text(PARAMS_HINT, c->name));
		return;
	}
	if (o->columns.n != 1)
		check_is_scene(o);
	if (!input_check(o->params))
		die_at(EXIT_USAGE, &place, strerror(errno), text(PARAMS_HINT, c->name));
}

void operands_check(const struct options *o)
{
	bool from_stdin = input_is_stdin(o->params);
	char list[7 * NUMBER_MAX];

	check_params(o);
	if (o->n_points > 0 && !command_reads_points(o->command))
		die(EXIT_USAGE, text("%s reads no points", o->command->name),
		    "leave them out");
	for (int i = 0; i < o->n_points && !o->matrix; i++) {
		const struct place place = { .file = o->points[i] };

		if (input_is_stdin(place.file) && from_stdin)
			die(EXIT_USAGE, "standard input is named twice", "name a file");
		from_stdin |= input_is_stdin(place.file);
		if (join_numbers(o, o->points + i, o->n_points - i, list))
			die_at(EXIT_USAGE, &place,
			    text("numbers of POINTS are in brackets: '%s'", list),
			    NULL);
		if (input_first_char(place.file) != '[' && !input_check(place.file) &&
		    !input_is_stdin(place.file))
			die_at(EXIT_USAGE, &place, strerror(errno),
			    text("POINTS are a file, - or '[%.*s]'%s",
				2 * options_coordinates(o) + 1, "1.5,2,3,4",
				o->columns.n == 1 ?
				    "; --columns takes a list such as 1,2,3" :
				    o->command->kind == COMMAND_PICK ? POSITION_HINT :
								       ""));
	}
}

bool operands_have_points(const struct options *o, struct document *d, bool *have)
{
	*have = o->n_points > 0 || d->points != NULL;
	if (*have || o->points_only_option == NULL)
		return true;
	d->is_usage = true;
	return document_refuse(d, NULL,
	    text("--%s is for points, and there are none", o->points_only_option),
	    "add POINTS or -");
}

/* Returns whether `path`, or its first token, is a name that the output adds. */
static bool is_added_member(const struct layout *l, const char *path)
{
	const bool pointer = *path == '/';
	const size_t n = pointer ? strcspn(path + 1, "/") : strlen(path);

	for (int k = l->reads; k <= COORDINATES_MAX && !l->output.append; k++)
		if (n > 0 && strlen(l->output.name[k]) == n &&
		    strncmp(path + pointer, l->output.name[k], n) == 0)
			return true;
	return false;
}

static void check_columns(const struct options *o, const struct layout *l)
{
	const bool csv = l->in.format == FORMAT_CSV, json = o->in == FORMAT_JSON;
	const int n = o->columns.n;

	for (int i = 0; i < n; i++) {
		const char *name = o->columns.name[i];

		if (name != NULL && !json && (!csv || o->no_header))
			die(EXIT_USAGE, text("--columns: '%s' is a name", name),
			    "names are for json and for csv with a header, else "
			    "numbers: "
			    "2,3,4");
		if (name != NULL && json && is_added_member(l, name))
			die(EXIT_USAGE,
			    text("--columns: the output adds '%s', too", name), NULL);
		if (json && (name == NULL) != (o->columns.name[0] == NULL))
			die(EXIT_USAGE, "--columns: in json all are numbers or names",
			    NULL);
		if (l->record > 0 && o->columns.field[i] >= l->record)
			die(EXIT_USAGE,
			    text("--columns: no field %d in records of %d",
				o->columns.field[i] + 1, l->record),
			    NULL);
	}
	if (n == 1 && json && o->columns.name[0] != NULL)
		die(EXIT_USAGE, "--columns: one member",
		    text("of an array say --columns /%1$s/0,/%1$s/1%2$s",
			o->columns.name[0] + (*o->columns.name[0] == '/'),
			l->reads > 2 ? " and so on" : ""));
	if (n > 0 && n != l->reads && !(format_is_binary(o->in) && l->record == 0))
		die(EXIT_USAGE, text("--columns: %d field%s", n, n == 1 ? "" : "s"),
		    text("%d coordinates are read here", l->reads));
}

/* If the command prints images of points, records keep their number of coordinates. */
static void check_layout(const struct options *o, const struct layout *l, bool printed)
{
	const bool record = l->record > 0, binary = format_is_binary(l->out.format);
	const struct {
		bool refused;
		const char *what, *remedy;
	} rows[] = {
		{ (o->header || o->no_header) && l->in.format != FORMAT_CSV,
		    "--header and --no-header are for csv", "use -i csv or -i tsv" },
		{ o->header && o->no_header,
		    "--header and --no-header exclude each other", NULL },
		{ l->output.append &&
			(format_is_binary(o->in) || (o->has_out && o->out != o->in)),
		    "--append keeps the lines that it read",
		    "leave -o out, and read no binary points" },
		{ o->flags && (binary || (printed && record)),
		    "--flags: binary points and records have no room for words",
		    "use -o text, and convert records before" },
		{ o->columns.n > 0 && format_is_binary(o->in) && !record,
		    "--columns: binary points have no other fields",
		    "use -i f32x4 or f64x4 for records of four numbers" },
		{ record && l->record < l->reads,
		    "--input: the records have fewer numbers than a point", NULL },
		{ l->output.keeps && printed && l->reads != l->writes,
		    "--input: records keep the number of coordinates, and here it "
		    "changes",
		    "use -o text, csv or json" },
	};

	check_columns(o, l);
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (rows[i].refused)
			die(EXIT_USAGE, rows[i].what, rows[i].remedy);
	if (o->decimals.n + o->digits.n > l->writes)
		die(EXIT_USAGE,
		    text("--decimals or --digits: %d numbers for %d coordinates",
			o->decimals.n + o->digits.n, l->writes),
		    NULL);
}

/* Tests choose the kernels by PROJCALC_CPU; else they are the processor's fastest. All
 * scenes of --scenes have the same, as to ask the processor takes
 * longer than a scene. */
static void choose_kernels(void)
{
	static bool is_done;
	const char *cpu = getenv("PROJCALC_CPU");

	if (!is_done && !kernels_choose(cpu != NULL && *cpu != '\0' ? cpu : NULL))
		die(EXIT_USAGE,
		    text("PROJCALC_CPU=%s: is none of avx512, avx2, neon and baseline "
			 "that runs here",
			cpu),
		    NULL);
	is_done = true;
}

/* With --append the names of coordinates begin with the space of images: device_x. */
static void name_numbers(struct layout *l, const char *space)
{
	static const char *const ray[] = { "x", "y", "z", "dx", "dy", "dz" };

	for (int k = 0; k < l->writes; k++) {
		bool of_space = l->output.append && (k < 3 || l->writes <= 4);

		snprintf(l->output.name[k], sizeof *l->output.name, "%s%s%s",
		    of_space ? space : "", of_space ? "_" : "",
		    l->writes > 4 ? ray[k] : coordinate_name(k));
	}
	strcpy(l->output.name[COORDINATES_MAX], l->output.flags ? "flags" : "");
}

static void prepare_job(struct job *j, const struct options *o)
{
	/* a ray is made from 2 numbers, x y, and written as 6: point and direction */
	j->layout = (struct layout){
		.in = dialect_of(o->in, o->separator),
		.out = dialect_of(options_out_format(o), o->separator),
		.header = o->header ? HEADER_YES :
		    o->no_header    ? HEADER_NONE :
				      HEADER_MAYBE,
		.columns = o->columns,
		.reads = j->rays ? 2 : j->transform.in,
		.writes = j->rays ? 6 : j->transform.out,
		.record = o->in_record,
		.from = j->from,
		.output = {
			.flags = o->flags,
			.append = o->append,
			.keeps = o->in_record > 0 &&
			    (!o->has_out || o->out_record > 0),
			.single = o->precision == PRECISION_SINGLE,
		},
	};
	j->layout.columns.by_default = o->columns.n == 0;
	for (int k = 0; k < 4 && j->layout.columns.by_default; k++)
		j->layout.columns.name[k] = coordinate_name(k);
	for (int k = 0; k < COORDINATES_MAX; k++)
		j->layout.output.style[k] = options_style(o, k);
	name_numbers(&j->layout, j->space);
	j->precision = o->precision;
	j->visible = o->visible;
	j->keep_going = o->keep_going;
	j->threads = (int)*o->jobs.v;
	answer_start_progress(o->progress);
	pipe_enlarge(STDOUT_FILENO, PIPE_ROOM);
	choose_kernels();
	check_layout(o, &j->layout, j->take_block == NULL);
}

/* `lines` are those that document_read_points or document_read made. */
static void run_json_points(const struct options *o, struct job *j, const char *name,
    const char *lines, size_t size)
{
	struct layout files_layout = j->layout;

	if (o->in_record > 0 || o->columns.n > 0)
		die(EXIT_USAGE,
		    text("--%s is for points in a file",
			o->in_record > 0 ? "input" : "columns"),
		    NULL);
	j->layout.in = dialect_of(FORMAT_JSON, ',');
	j->layout.columns.n = 0;
	stream_points(j, source_of_text(name, lines, size));
	j->layout = files_layout;
}

/* Does the job on an operand that is typed. Returns false if it is refused: the
 * refusals are then about its text, and it is wrong for every scene. */
static bool run_typed(const struct options *o, struct document *d, struct job *j,
    const char *operand)
{
	struct input_text t = input_of_operand(operand);
	struct json_source source = { .name = "POINTS",
		.two_numbers_hint = j->layout.z_hint,
		.faults = d->source.faults };
	struct span lines;
	d->ends_run = !document_read_points(&source, t.s, t.size, j->layout.reads,
	    &lines);
	if (d->ends_run)
		d->source = source;
	else
		run_json_points(o, j, "POINTS", lines.s, (size_t)(lines.end - lines.s));
	input_free(&t);
	return !d->ends_run;
}

/* With --scenes, the text of a file is kept for the next scenes. */
static bool run_operand(const struct options *o, struct document *d, struct job *j,
    int i)
{
	static struct input_text *kept;
	const char *operand = i < o->n_points ? o->points[i] : "-";
	const size_t kept_size = ((size_t)o->n_points + 1) * sizeof *kept;

	if (input_first_char(operand) == '[')
		return run_typed(o, d, j, operand);
	if (o->scenes) {
		if (kept == NULL)
			kept = memset(xrealloc(NULL, kept_size), 0, kept_size);
		if (kept[i].s == NULL)
			kept[i] = input_of_file(operand);
		stream_points(j, source_of_text(operand, kept[i].s, kept[i].size));
	} else {
		int fd = input_open(operand);

		stream_points(j, source_of_file(operand, fd));
		close(fd);
	}
	return true;
}

bool operands_run_job(const struct options *o, struct document *d, enum space from,
    enum space to, struct job *j)
{
	prepare_job(j, o);
	notes_watch(d, from, to, j);
	if (o->n_points == 0 && d->points == NULL && input_is_stdin(o->params)) {
		d->is_usage = true;
		return document_refuse(d, "/points",
		    "missing, and standard input is PARAMS already", NULL);
	}
	j->layout.z_hint = d->source.two_numbers_hint;
	if (o->n_points == 0 && d->points != NULL)
		run_json_points(o, j, d->source.name, d->points, d->points_size);
	else
		for (int i = 0; i == 0 || i < o->n_points; i++)
			if (!run_operand(o, d, j, i))
				return false;
	if (j->flush != NULL)
		j->flush(j);
	notes_say_behind(d, from, j);
	return true;
}
