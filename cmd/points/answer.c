#include "answer.h"

#include <stdio.h>
#include <string.h>

#include "progress.h"
#include "../talk.h"

/* Of all chunks so far. It needs no lock, as no two are answered at a time. */
static struct {
	size_t next_line; /* of the source, from 1 */
	bool unended;     /* the last line printed has no newline yet */
	bool bad;         /* there was a complaint */
	size_t imageless; /* points */
	/* the first of them, and its file's name */
	struct place where;
	char file[300];
} answer;

void answer_source(void)
{
	answer.next_line = 1;
}

static void print(const struct job *j, const struct chunk *c)
{
	if (c->size > 0 && answer.unended)
		put_all("\n", 1);
	if (c->size > 0)
		answer.unended = !is_binary(j->layout.out) &&
		    c->out[c->size - 1] != '\n';
	put_all(c->out, c->size);
}

/* Of a line of the chunk, from 0. */
static struct place place_of(const struct chunk *c, size_t line)
{
	return (struct place){ .file = c->name,
		.line = (long)(answer.next_line + line) };
}

static void count_imageless(const struct chunk *c)
{
	if (c->imageless > 0 && answer.imageless == 0) {
		snprintf(answer.file, sizeof answer.file, "%s", c->name);
		answer.where = place_of(c, c->first_imageless);
		answer.where.file = answer.file;
		answer.where.scene = said_scene();
	}
	answer.imageless += c->imageless;
}

static void complain(const struct job *j, const struct chunk *c)
{
	if (!j->keep_going && j->flush != NULL)
		j->flush(j);
	progress_clear();
	for (size_t i = 0; i < c->n_complaints; i++) {
		struct place p = place_of(c, c->complaints[i].line);

		say_at(EXIT_INPUT, &p, "%s",
		    c->reasons + c->complaints[i].reason);
	}
	answer.bad = true;
	if (!j->keep_going) {
		close_output();
		quit(EXIT_INPUT);
	}
}

static _Noreturn void stop(const struct job *j, const struct chunk *c)
{
	struct place p = place_of(c, 0);

	if (j->flush != NULL)
		j->flush(j);
	progress_clear();
	if (c->state == PIECE_TOO_LONG)
		die_at(EXIT_INPUT, &p, "a line of more than 64 MiB");
	p.line = 0;
	die_at(EXIT_SYSTEM, &p, "%s", strerror(c->error));
}

void answer_chunk(const struct job *j, const struct chunk *c)
{
	if (j->collect != NULL)
		j->collect(j, c, answer.next_line);
	else
		print(j, c);
	if (j->count_imageless)
		count_imageless(c);
	if (c->n_complaints > 0)
		complain(j, c);
	answer.next_line += c->n_lines;
	progress_add(c->n_lines, c->bytes);
	if (c->state == PIECE_TOO_LONG || c->state == PIECE_FAILED)
		stop(j, c);
}

int answer_end(void)
{
	progress_end();
	answer.where.join = answer.imageless == 1 ? ": " : ", the first in ";
	if (answer.imageless == 1)
		say_at(EXIT_OK, &answer.where, "1 point has no image");
	else if (answer.imageless > 1)
		say_at(EXIT_OK, &answer.where, "%zu points have no image",
		    answer.imageless);
	close_output();
	return answer.bad ? EXIT_INPUT : EXIT_OK;
}
