/* SPDX-License-Identifier: MIT */
/* The operands PARAMS and POINTS, together with the options: whether they go with each
 * other, and the job on points that they describe. */
#pragma once

#include "../stream/answer.h"
#include "../stream/stream.h"
#include "options.h"
#include "params.h"

/* Refuses wrong operands and files that can't be opened, before anything is printed. */
void operands_check(const struct options *);

/* Sets *have to whether there are points, as operands or in the document. If there are
 * none, refuses options that are only for points. */
bool operands_have_points(const struct options *, struct document *, bool *have);

/* Completes the job by the options, and does it on the points of the operands; without
 * operands, on those of the document or, if it has none, of standard input. The caller
 * has set job.transform, or job.rays and job.ray, and in job.layout the names of the
 * spaces: `from` and output.space. --scenes reads operands only once. A note is due if
 * points of `from` without image in `to` are behind the camera. Returns false if the
 * scene or an operand that is typed is refused. */
bool operands_run_job(const struct options *, struct document *, enum space from,
    enum space to, struct job *);
