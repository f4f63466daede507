#include "operands.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "points/progress.h"
#include "points/threads.h"
#include "talk.h"

enum { DOCUMENT_MAX = 1 << 28 };

static char first_char(const char *s)
{
	while (isspace((unsigned char)*s))
		s++;
	return *s;
}

static bool is_stdin(const char *operand)
{
	return strcmp(operand, "-") == 0;
}

/* If a standard stream is closed, open returns its number, and the file would
 * be read or written in its place: it gets another number. */
static int open_file(const char *name)
{
	int fd = open(name, O_RDONLY), low = fd;

	if (fd < 0 || fd > STDERR_FILENO)
		return fd;
	fd = fcntl(low, F_DUPFD, STDERR_FILENO + 1);
	close(low);
	return fd;
}

static int open_input(const char *name)
{
	struct stat st;
	int fd = is_stdin(name) ? STDIN_FILENO : open_file(name);

	if (fd < 0 || fstat(fd, &st) != 0)
		die(EXIT_USAGE, "%s: %s", name, strerror(errno));
	if (S_ISDIR(st.st_mode))
		die(EXIT_USAGE, "%s: is a directory", name);
	return fd;
}

/* Texts of which points may be left have a margin for those who read them. */
static char *grow(char *text, size_t room)
{
	return need(text, room + PIECE_MARGIN);
}

static char *copy_operand(const char *operand, size_t *size)
{
	*size = strlen(operand);
	return memcpy(grow(NULL, *size), operand, *size);
}

static char *read_whole(const char *name, size_t *size)
{
	int fd = open_input(name);
	size_t room = 1 << 16;
	char *text = grow(NULL, room);

	*size = 0;
	for (;;) {
		ssize_t n = read(fd, text + *size, room - *size);

		if (n < 0 && go_on(fd, POLLIN))
			continue;
		if (n < 0)
			die(EXIT_SYSTEM, "%s: %s", name, strerror(errno));
		if (n == 0)
			break;
		*size += (size_t)n;
		if (*size > DOCUMENT_MAX)
			die(EXIT_INPUT,
			    "%s: a document of more than 256 MiB; "
			    "points may stand in a file of their own",
			    name);
		if (*size == room)
			text = grow(text, room *= 2);
	}
	if (fd != STDIN_FILENO)
		close(fd);
	return text;
}

static void check_file(const char *name)
{
	const char *end = name + strlen(name);
	struct stat st;
	double v;

	if (stat(name, &st) == 0 && S_ISDIR(st.st_mode))
		die(EXIT_USAGE, "%s: is a directory", name);
	if (access(name, R_OK) == 0)
		return;
	if (number_read(name, end, &v) == end && end != name)
		die(EXIT_USAGE, "%s: %s; POINTS are a file, - or '[0,0,0]'",
		    name, strerror(errno));
	die(EXIT_USAGE, "%s: %s", name, strerror(errno));
}

/* Before anything is printed, an operand that can't be opened is refused. */
static void check_operands(const struct command *c, const struct options *o)
{
	int from_stdin = is_stdin(o->params);

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
		if (!is_stdin(name) && first_char(name) != '[')
			check_file(name);
	}
}

void read_document(const struct command *c, const struct options *o,
    int coordinates, struct document *d)
{
	struct document_wants wants = c->wants;
	const char *name = o->params;
	char *text;
	size_t size;

	wants.convention = o->convention;
	/* the document's points are not read if points are operands */
	if (!o->matrix && o->n_points == 0)
		wants.coordinates = coordinates;
	check_operands(c, o);
	if (first_char(o->params) == '{') {
		name = "PARAMS";
		text = copy_operand(o->params, &size);
	} else {
		text = read_whole(name, &size);
	}
	document_read(d, name, text, size, &wants);
	if (d->points == NULL)
		free(text);
}

bool has_points(const struct options *o, const struct document *d)
{
	return o->n_points > 0 || d->points != NULL;
}

static void check_layout(const struct options *o, const struct layout *l)
{
	for (int i = 0; i < o->columns.n; i++)
		if (o->columns.name[i] != NULL && o->in != FORMAT_CSV)
			die(EXIT_USAGE,
			    "--columns: '%s' is a name, and names "
			    "are for -i csv; write numbers: 2,3,4",
			    o->columns.name[i]);
	if (o->flags && is_binary(l->out))
		die(EXIT_USAGE,
		    "--flags: binary points have no room for words; say "
		    "-o text");
	if (o->tolerances.n > l->writes)
		die(EXIT_USAGE,
		    "--tolerance: %d tolerances; %d coordinates are "
		    "printed here",
		    o->tolerances.n, l->writes);
	if (o->columns.n > 0 && is_binary(o->in))
		die(EXIT_USAGE, "--columns: binary points have no fields");
	if (o->columns.n > 0 && o->columns.n != l->reads)
		die(EXIT_USAGE,
		    "--columns: %d fields; %d coordinates are "
		    "read here",
		    o->columns.n, l->reads);
}

/* Tests and measurements choose the kernels by PROJCALC_CPU; else they are the
 * best that this processor can run. */
static void choose_kernels(void)
{
	const char *cpu = getenv("PROJCALC_CPU");

	if (!points_choose(cpu) || !number_choose(cpu))
		die(EXIT_USAGE,
		    "PROJCALC_CPU=%s: not a processor that this is; "
		    "it is one of baseline, avx2, avx512 and neon",
		    cpu);
}

/* Text is rounded, and what is computed leaves room for that. */
static void set_tolerances(struct job *j, const struct tolerances *t)
{
	bool text = !is_binary(j->layout.out);

	for (int k = 0; k < COORDINATES_MAX; k++)
		j->layout.style[k] = (struct number_style){ NUMBER_WITHIN,
			t->decimals[k] };
	for (int k = 0; k < 3; k++)
		j->accuracy.tolerance[k] = text ? tolerance_left(t, k) :
						  t->within[k] * (1 - 0x1p-52);
}

void prepare_job(struct job *j, const struct options *o)
{
	/* a ray's position; its point and direction */
	const int ray_reads = 2, ray_writes = 6;

	j->layout = (struct layout){
		.in = o->in,
		.out = o->has_out ? o->out : o->in,
		.columns = o->columns,
		.reads = j->rays ? ray_reads : j->transform.in,
		.writes = j->rays ? ray_writes : j->transform.out,
		.single = o->precision == PRECISION_SINGLE,
	};
	for (int k = 0; k < COORDINATES_MAX; k++)
		j->layout.style[k] = o->style;
	j->accuracy = (struct accuracy){ .precision = o->precision };
	if (o->tolerances.n > 0)
		set_tolerances(j, &o->tolerances);
	j->keep_going = o->keep_going;
	j->threads = o->jobs > 0 ? o->jobs : threads_processors();
	progress_start(o->progress);
	widen_pipe(STDOUT_FILENO);
	choose_kernels();
	check_layout(o, &j->layout);
}

/* Points as document_points and document_read give them are lines of JSON,
 * whatever format the options say of files. */
static void do_json(struct job *j, const char *name, const char *text,
    size_t size)
{
	enum format in = j->layout.in;

	j->layout.in = FORMAT_JSON;
	stream_text(j, name, text, size);
	j->layout.in = in;
}

/* Refuses --columns for points that are typed: it is of lines of a file. */
static void check_columns(const struct options *o, const struct document *d)
{
	bool typed = o->n_points == 0 && d->points != NULL;

	for (int i = 0; i < o->n_points; i++)
		typed |= first_char(o->points[i]) == '[';
	if (typed && o->columns.n > 0)
		die(EXIT_USAGE,
		    "--columns: points that are typed, or in the document, "
		    "begin with their coordinates; name a file");
}

/* Does the job on points typed as an operand; or where there is none, only
 * refuses what is wrong with them. */
static void do_typed(struct job *j, const char *operand, int reads)
{
	size_t size, n;
	char *text = copy_operand(operand, &n);
	const char *points = document_points("POINTS", text, n, reads, &size);

	if (j != NULL)
		do_json(j, "POINTS", points, size);
	free(text);
}

static void do_operand(struct job *j, const char *operand)
{
	if (first_char(operand) == '[') {
		do_typed(j, operand, j->layout.reads);
		return;
	}
	int fd = open_input(operand);

	stream_file(j, operand, fd);
	if (fd != STDIN_FILENO)
		close(fd);
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
		do_json(j, d->name, d->points, d->points_size);
	else if (o->n_points == 0)
		do_operand(j, "-");
	/* points that are typed wrong are refused before those of the first
	 * operand are printed */
	for (int i = 1; i < o->n_points; i++)
		if (first_char(o->points[i]) == '[')
			do_typed(NULL, o->points[i], j->layout.reads);
	for (int i = 0; i < o->n_points; i++)
		do_operand(j, o->points[i]);
}
