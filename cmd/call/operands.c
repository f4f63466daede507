/* SPDX-License-Identifier: MIT */
#include "operands.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../message/message.h"
#include "../message/utf8.h"
#include "../number/number.h"
#include "../stream/lines.h"
#include "input.h"

#define PARAMS_HINT \
	"PARAMS is a JSON file, - or JSON in quotes, as 'projcalc help %s' shows"

/* Writes the numbers of n_words words, from the first to one that is a file, as a JSON
 * array. Returns how many they are, or 0 if one is no number or they are more than a
 * point has. */
static int join_numbers(char *const *words, int n_words, char out[7 * NUMBER_MAX])
{
	enum { MOST = 4 };
	int n = 0;

	for (int i = 0; i < n_words && access(words[i], F_OK) != 0; i++) {
		const char *s = words[i], *end = s + strlen(s);
		double v;

		while ((s += strspn(s, " ,")) < end) {
			s = number_read(s, end, &v);
			if (s == NULL || !isfinite(v) || n++ == MOST ||
			    (s < end && strchr(" ,", *s) == NULL))
				return 0;
			*out++ = n == 1 ? '[' : ',';
			out = number_write(out, v,
			    (struct number_style){ NUMBER_SHORTEST, 0 });
		}
	}
	strcpy(out, "]");
	return n;
}

/* Refuses PARAMS that are an array or numbers, and no file: they are points, if they
 * are no single number, which may be a name. */
static void check_is_scene(const struct options *o)
{
	const struct place place = { .file = o->params };
	const bool array = input_first_char(o->params) == '[';
	char list[7 * NUMBER_MAX], *words[] = { (char *)o->params };
	const int n = join_numbers(words, 1, list);
	const int shown = array ? (int)utf8_fit(o->params, 190) : (int)strlen(list);

	if (array || n > 1)
		die_at(EXIT_USAGE, &place, "holds points",
		    params_points_remedy(o,
			!array && n < options_coordinates(o) ?
			    "POINTS" :
			    text("'%.*s'", shown, array ? o->params : list)));
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
		if (join_numbers(o->points + i, o->n_points - i, list) ==
		    options_coordinates(o))
			die_at(EXIT_USAGE, &place,
			    text("numbers of POINTS are in brackets: '%s'", list),
			    NULL);
		if (input_first_char(place.file) == '{')
			die_at(EXIT_USAGE, &place, "is an object",
			    "a scene comes first, and POINTS are a file, - or an "
			    "array");
		if (input_first_char(place.file) != '[' && !input_check(place.file) &&
		    !input_is_stdin(place.file))
			die_at(EXIT_USAGE, &place, strerror(errno),
			    text("POINTS are a file, - or '[%.*s]'%s",
				2 * options_coordinates(o) + 1, "1.5,2,3,4",
				o->columns.n == 1 ?
				    "; --columns takes a list such as 1,2,3" :
				    o->command->kind == COMMAND_PICK ?
				    "; " POSITION_HINT :
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

static void check_columns(const struct options *o, const struct layout *l)
{
	const int n = o->columns.n;

	for (int i = 0; i < n; i++) {
		const char *name = o->columns.name[i];

		if (name != NULL && o->no_header)
			die(EXIT_USAGE,
			    text("--columns: '%s' is a name in a header", name),
			    "leave --no-header out, or say numbers: 2,3,4");
		if (name != NULL && (o->in == FORMAT_OBJ || format_is_binary(o->in)))
			die(EXIT_USAGE, text("--columns: '%s' is a name", name),
			    text("%s has numbers: 2,3,4", format_names[o->in]));
		if (l->record > 0 && o->columns.field[i] >= l->record)
			die(EXIT_USAGE,
			    text("--columns: no field %d in records of %d",
				o->columns.field[i] + 1, l->record),
			    NULL);
	}
	if (n > 0 && n != l->reads && !(format_is_binary(o->in) && l->record == 0))
		die(EXIT_USAGE, text("--columns: %d field%s", n, n == 1 ? "" : "s"),
		    text("%d coordinates are read here", l->reads));
}

#define APPEND_WHAT "--append keeps the lines that it read"
#define APPEND_REMEDY "leave -o out, and read no binary points"

/* Checks the options that depend on the format of an input, and sets the output's if
 * it is that of the input: so inputs of two formats need -o. */
static void settle_formats(const struct options *o, struct layout *l, const char *name)
{
	const struct format_row *in = format_of(l->in);
	const struct place place = { .file = name };
	const bool json = l->in.format == FORMAT_JSON;
	const bool picks = o->command->kind == COMMAND_PICK;
	struct dialect out = l->in;

	if ((o->header || o->no_header) && !in->header)
		die_at(EXIT_USAGE, &place,
		    "--header and --no-header are for text, csv and tsv", NULL);
	if (!json && !in->header && layout_has_names(l))
		die_at(EXIT_USAGE, &place,
		    "--columns: names are for text, csv, tsv and json", NULL);
	for (int i = 1; i < o->columns.n && json; i++)
		if ((o->columns.name[i] == NULL) != (o->columns.name[0] == NULL))
			die_at(EXIT_USAGE, &place,
			    "--columns: in json all are numbers or names", NULL);
	if (o->command->kind == COMMAND_TRACE)
		out = dialect_of(json ? FORMAT_JSON : FORMAT_TEXT, ',');
	if (l->out.format == FORMAT_SNIFF)
		l->out = out;
	if (l->output.append && !same_dialect(l->in, l->out))
		die_at(EXIT_USAGE, &place, APPEND_WHAT, APPEND_REMEDY);
	if (picks && o->has_out && l->out.format != FORMAT_JSON &&
	    !same_dialect(l->in, l->out))
		die_at(EXIT_USAGE, &place, "pick prints the lines that it read",
		    "leave -o out, or say -o json");
	if (!o->has_out && !same_dialect(out, l->out))
		die_at(EXIT_USAGE, &place, "is of another format than the input before",
		    picks ? "say -o json" : "say -o for the output's");
}

/* If the command prints images of points, records keep their number of coordinates. */
static void check_layout(const struct options *o, const struct layout *l, bool printed)
{
	const bool record = l->record > 0, binary = format_is_binary(l->out.format);
	const struct {
		bool refused;
		const char *what, *remedy;
	} rows[] = {
		{ o->header && o->no_header,
		    "--header and --no-header exclude each other", NULL },
		{ l->output.append && (format_is_binary(o->in) || binary), APPEND_WHAT,
		    APPEND_REMEDY },
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
static void name_numbers(struct layout *l)
{
	static const char *const ray[] = { "x", "y", "z", "dx", "dy", "dz" };

	for (int k = 0; k < l->writes; k++) {
		bool of_space = l->output.append && (k < 3 || l->writes <= 4);

		snprintf(l->output.name[k], sizeof *l->output.name, "%s%s%s",
		    of_space ? l->output.space : "", of_space ? "_" : "",
		    l->writes > 4 ? ray[k] : coordinate_name(k));
	}
	strcpy(l->output.name[COORDINATES_MAX], l->output.flags ? "flags" : "");
}

static void prepare_job(struct job *j, const struct options *o)
{
	/* a ray is made from 2 numbers, x y, and written as 6: point and direction */
	j->layout = (struct layout){
		.out = dialect_of(o->command->kind == COMMAND_TRACE && !o->has_out ?
			    FORMAT_SNIFF :
			    options_out_format(o),
		    o->separator),
		.header = o->header ? HEADER_YES :
		    o->no_header    ? HEADER_NONE :
				      HEADER_MAYBE,
		.columns = o->columns,
		.reads = j->rays ? 2 : j->transform.in,
		.writes = j->rays ? 6 : j->transform.out,
		.record = o->in_record,
		.from = j->layout.from,
		.output = {
			.flags = o->flags,
			.append = o->append,
			.keeps = o->in_record > 0 &&
			    (!o->has_out || o->out_record > 0),
			.single = o->precision == PRECISION_SINGLE,
			.copies = j->take_block == NULL ||
			    o->command->kind == COMMAND_PICK,
			.space = j->layout.output.space,
		},
	};
	for (int k = 0; k < COORDINATES_MAX; k++)
		j->layout.output.style[k] = options_style(o, k);
	name_numbers(&j->layout);
	j->precision = o->precision;
	j->visible = o->visible;
	j->keep_going = o->keep_going;
	j->threads = (int)*o->jobs.v;
	answer_start_progress(o->progress);
	pipe_enlarge(STDOUT_FILENO, PIPE_ROOM);
	choose_kernels();
	check_layout(o, &j->layout, j->take_block == NULL);
}

/* Law 8: in csv and tsv the numbers of a source of another format have a header of
 * their names, unless they follow lines without one. */
static void join_names(struct job *j, const struct point_source *s)
{
	struct layout *l = &j->layout;
	const bool named = format_of(l->out)->table &&
	    (!l->common.known || l->common.text != NULL);
	char names[COORDINATES_MAX * 4 * NAME_ROOM];
	const char *end = emit_names(l, names);
	struct refusal r;
	const enum line_kind kind = plan_join_header(l,
	    named ? (struct span){ names, end - 1 } : (struct span){ NULL, NULL }, &r);

	if (kind == LINE_REFUSED)
		answer_refuse(j, s, &r);
	if (kind == LINE_HEADER)
		answer_text(j, (struct span){ names, end });
}

/* Reads the points of a source. Lines of our own are of JSON, and printed as text but
 * for --append; comments alone are of any format, and tell none. */
static void run_source(const struct options *o, struct job *j, struct point_source s)
{
	struct layout *l = &j->layout;
	const enum format in = s.is_ours ? FORMAT_JSON : o->in;
	const struct dialect before = l->out;
	struct refusal r;

	l->in = dialect_of(in != FORMAT_SNIFF ? in : format_of_name(s.name),
	    o->separator);
	if (!source_begin(&s, l, &r))
		answer_refuse(j, &s, &r);
	if (!s.is_ours && !l->plan.has_none)
		settle_formats(o, l, s.name);
	else if (l->out.format == FORMAT_SNIFF)
		l->out = s.is_ours && !o->append ? dialect_of(FORMAT_TEXT, ',') : l->in;
	if (l->plan.has_none && !format_is_binary(l->out.format))
		l->in = l->out;
	if (o->append && !same_dialect(l->in, l->out))
		die(EXIT_USAGE, APPEND_WHAT, APPEND_REMEDY);
	if (j->take_block == NULL && !same_dialect(l->in, l->out))
		join_names(j, &s);
	stream_points(j, s);
	if (l->plan.has_none)
		l->out = before;
}

/* `lines` are those that document_read_points or document_read made. */
static void run_json_points(const struct options *o, struct job *j, const char *name,
    const char *lines, size_t size)
{
	struct point_source s = source_of_text(name, lines, size);

	if (o->in_record > 0 || o->columns.n > 0)
		die(EXIT_USAGE,
		    text("--%s is for points in a file",
			o->in_record > 0 ? "input" : "columns"),
		    NULL);
	s.is_ours = true;
	run_source(o, j, s);
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

/* Returns whether the job takes an operand as an OBJ file. */
static bool is_whole_obj(const struct options *o, const struct job *j,
    const char *operand)
{
	return j->take_obj != NULL &&
	    (o->in == FORMAT_OBJ ||
		(o->in == FORMAT_SNIFF && format_of_name(operand) == FORMAT_OBJ));
}

static void take_obj(const struct options *o, const struct job *j, const char *name,
    const struct input_text *t)
{
	struct place place = { .file = name };
	struct refusal r = { .line = 0 };

	if (o->columns.n > 0 || o->header || o->no_header)
		die_at(EXIT_USAGE, &place,
		    "--columns, --header and --no-header are for points",
		    "leave them out");
	if (j->take_obj(j, (struct span){ t->s, t->s + t->size }, &r))
		return;
	place.line = r.line;
	die_at(EXIT_INPUT, &place, r.what, r.remedy);
}

/* With --scenes, the text of a file is kept for the next scenes. */
static bool run_operand(const struct options *o, struct document *d, struct job *j,
    int i)
{
	static struct input_text *kept;
	const char *operand = i < o->n_points ? o->points[i] : "-";
	const size_t kept_size = ((size_t)o->n_points + 1) * sizeof *kept;
	const bool is_obj = is_whole_obj(o, j, operand);

	if (input_first_char(operand) == '[')
		return run_typed(o, d, j, operand);
	if (!o->scenes && !is_obj) {
		const int fd = input_open(operand);

		run_source(o, j, source_of_file(operand, fd));
		close(fd);
		return true;
	}
	if (kept == NULL)
		kept = memset(xrealloc(NULL, kept_size), 0, kept_size);
	if (kept[i].s == NULL)
		kept[i] = input_of_file(operand);
	if (is_obj)
		take_obj(o, j, operand, &kept[i]);
	else
		run_source(o, j, source_of_text(operand, kept[i].s, kept[i].size));
	if (!o->scenes)
		input_free(&kept[i]);
	return true;
}

/* Returns what a w that is not positive may come of. Points of a matrix, a plane or a
 * ray are not found behind the camera; the last has no transform. */
static enum behind find_behind(const struct scene *s, enum space from, enum space to,
    const struct job *j)
{
	const struct camera *c = &s->camera;

	if (!j->transform.divide || !j->transform.front)
		return BEHIND_NOTHING;
	if (from == SPACE_DEVICE && j->transform.in == 3 && !s->viewport.distance)
		return BEHIND_DEPTH;
	if (from > SPACE_CLIP || to < SPACE_NDC)
		return BEHIND_NOTHING;
	if (!s->has_camera || from > SPACE_WORLD || camera_is_by_gaze(c))
		return BEHIND_CAMERA;
	return c->way == CAMERA_ORIENTATION || c->way == CAMERA_TRANSLATION ?
	    BEHIND_ORDER :
	    BEHIND_AXES;
}

bool operands_run_job(const struct options *o, struct document *d, enum space from,
    enum space to, struct job *j)
{
	if (o->lines && o->command->kind != COMMAND_DRAW &&
	    !lines_prepare(&d->scene, from, to, j, d->source.faults))
		return false;
	prepare_job(j, o);
	j->behind = find_behind(&d->scene, from, to, j);
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
	free(j->layout.common.text);
	return true;
}
