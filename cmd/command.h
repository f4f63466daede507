/* A command, its options, and what its source files share. */
#ifndef COMMAND_H
#define COMMAND_H

#include <stdbool.h>

#include "scene/document.h"
#include "points/stream.h"

struct options {
	const char *convention; /* NULL: the document's */
	enum format in, out;
	bool out_given;
	struct columns columns;
	struct number_style style;
	struct accuracy accuracy;
	bool precision_given;
	bool has_from, has_to;
	enum space from, to;
	bool homogeneous, matrix, ray, flags, visible, keep_going;
	bool progress;
	int jobs; /* 0: as many as there are cores */
	bool has_at;
	double at[2], radius; /* of pick */
	const char *params;   /* operand, "-" by default */
	int n_points;
	char **points; /* operands */
};

struct command {
	const char *name;
	int (*run)(const struct command *, const struct options *);
	const char *letters; /* of the options that it uses */
	const char *about;   /* one line of help */
	/* for the commands that print a matrix */
	bool flat;
	int from, to;  /* spaces of the matrix */
	int points_to; /* where points go instead */
	enum scene_member bare;
	unsigned needed;
	int projection;
};

int run_matrix(const struct command *, const struct options *);
int run_project(const struct command *, const struct options *);
int run_pick(const struct command *, const struct options *);
int run_fit(const struct command *, const struct options *);
int run_inspect(const struct command *, const struct options *);

/* Reads PARAMS. The text stays allocated with the document. */
void read_document(const struct command *, const struct options *,
    int coordinates, struct document *);

/* Whether there are points to carry, from operands or the member. */
bool has_points(const struct options *, const struct document *);

/* Sends all points: operands, else the member, else standard input. */
void stream_points(const struct options *, const struct document *,
    struct job *);

/* Fills in what the options and the transform say of the lines. */
void stream_options(struct job *, const struct options *);

void print_matrix(const struct options *, const struct document *,
    const struct map *, bool flat);

#endif
